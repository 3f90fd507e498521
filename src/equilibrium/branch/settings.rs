//! How far a run goes before it is given up, and in what steps.

/// Limits of a run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Settings {
    /// Iterations of the whole run before it is given up.
    pub iterations: usize,
    /// Greatest change in a step of what drives the robot, as a pull over the greatest
    /// cable offset: 1/16 of it turns the free robot's tip by 3.6°, a tenth of a
    /// segment's usual reach.
    pub pull_step: f64,
    /// Greatest motion of an obstacle in a step, over the backbone's length.
    pub obstacle_step: f64,
}

impl Default for Settings {
    fn default() -> Self {
        Self {
            iterations: 50_000,
            pull_step: 1.0 / 16.0,
            obstacle_step: 1.0 / 40.0,
        }
    }
}
