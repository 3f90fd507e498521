//! Solving in the background: what the window asks and what it is told.
//!
//! A [`SolverBackend`] takes the newest [`Request`] and forgets older ones, even
//! in the middle of their solve; its [`Job`] keeps the last equilibrium, so
//! that each request goes on from the shape on the screen. The window never
//! waits: it asks [`SolverBackend::poll`] once a frame.

mod inline;
mod job;
#[cfg(not(target_arch = "wasm32"))]
mod thread;

pub use inline::Inline;
pub use job::{Job, Work};
#[cfg(not(target_arch = "wasm32"))]
pub use thread::Thread;

use crate::equilibrium::Solution;
use crate::model::Problem;
use std::sync::Arc;

/// What to solve.
#[derive(Clone, Debug)]
pub struct Request {
    /// Counts the requests; a later one replaces all before it.
    pub generation: u64,
    /// The robot, its obstacles and its pull.
    pub problem: Problem,
    /// What the solve starts from.
    pub from: StartFrom,
}

/// What a solve starts from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StartFrom {
    /// The shape on the screen: the branch is kept.
    Shown,
    /// The straight robot: the paper's continuation.
    Straight,
}

/// What a solve led to.
#[derive(Clone, Debug)]
pub enum Update {
    /// The robot's shape; soon after the request.
    Shape(Arc<Shape>),
}

/// A solved shape.
#[derive(Clone, Debug)]
pub struct Shape {
    /// The request it answers.
    pub generation: u64,
    /// The problem that the solution solves: the one asked for, or the last
    /// one on the way to it that has an equilibrium.
    pub problem: Problem,
    /// The solution.
    pub solution: Solution,
    /// Whether the obstacles are where the request has them.
    pub placed: bool,
    /// Time spent solving, in seconds.
    pub seconds: f64,
}

/// Something that solves while the window goes on.
pub trait SolverBackend {
    /// Replaces whatever is being solved.
    fn submit(&mut self, request: Request);

    /// The next thing that was found, if any; never waits.
    fn poll(&mut self) -> Option<Update>;

    /// Whether more is to come without a further request.
    fn is_busy(&self) -> bool;
}
