//! Between the world and the frame of the robot's base, in which a run works.
//! It moves whole problems; the solution moves itself.

use super::Branch;
use crate::geometry::Vector;
use crate::mechanics::{Mechanics, Problem};
use std::borrow::Cow;

/// The problem relative to the robot's base.
pub(super) fn at_base(problem: &Problem) -> Cow<'_, Problem> {
    let base = problem.robot().base.position;
    if base == Vector::zeros() {
        Cow::Borrowed(problem)
    } else {
        Cow::Owned(problem.moved(-base))
    }
}

impl<M: Mechanics<NU>, const NU: usize> Branch<M, NU> {
    /// Keeps the present problem as [`Branch::problem`] tells it.
    pub(super) fn show_world(&mut self) {
        let elsewhere = self.origin != Vector::zeros();
        self.world = elsewhere.then(|| self.now.moved(self.origin));
    }
}
