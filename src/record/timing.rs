//! How long a solve takes, in the three ways it can start. It measures nothing.

use serde::Serialize;

/// Times of the three kinds of solve, in microseconds.
#[derive(Serialize)]
pub struct Timing {
    /// Directly from the free shape: [`crate::equilibrium::Start::Direct`].
    pub cold: Sample,
    /// Along the pull from the straight robot:
    /// [`crate::equilibrium::Start::Straight`].
    pub path: Sample,
    /// From the same robot at a pull 0.05 mm away.
    pub warm: Sample,
}

/// What a number of solves took, in microseconds.
#[derive(Serialize)]
pub struct Sample {
    /// Half of them took at most this long.
    pub median: f64,
    /// 99 % of them took at most this long.
    pub p99: f64,
    /// How many of them converged.
    pub converged: u32,
}
