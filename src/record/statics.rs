//! The record of what the base holds, and of what is left of sums of forces.

use serde::Serialize;

use crate::forces::Statics;
use crate::units::millimetres;

/// What the mount of the first disk exerts on the robot.
#[derive(Serialize)]
pub struct Base {
    /// In the scene's frame.
    pub force_n: [f64; 2],
    /// About the base, clockwise, in N mm.
    pub moment_nmm: f64,
}

impl Base {
    /// `None` where a number is not finite.
    pub(super) fn of(statics: &Statics) -> Option<Self> {
        let base = Self {
            force_n: [statics.clamp.force.x, statics.clamp.force.y],
            moment_nmm: -millimetres(statics.clamp.moment),
        };
        let [x, y] = base.force_n;
        let numbers = [x, y, base.moment_nmm];
        numbers.into_iter().all(f64::is_finite).then_some(base)
    }
}

/// What is left of sums of all forces and moments, and of every section's, over the
/// largest.
#[derive(Serialize)]
pub struct Balance {
    /// Of forces.
    pub force: f64,
    /// Of moments about the base.
    pub moment: f64,
}

impl Balance {
    /// `None` where a number is not finite.
    pub(super) fn of(statics: &Statics) -> Option<Self> {
        let (force, moment) = (statics.unbalanced_force, statics.unbalanced_moment);
        (force.is_finite() && moment.is_finite()).then_some(Self { force, moment })
    }
}
