//! A cable along the robot: where it runs and what it is made of. Nothing of what
//! pulls it.

use serde::{Deserialize, Serialize};

/// A cable that is fixed in its last disk and runs through the holes of those below.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Cable {
    /// Its distance from the backbone, in metres, positive towards +x of the straight
    /// robot.
    pub offset: f64,
    /// The disk that it ends in, from 1; that of the base is 0.
    pub last_disk: usize,
    /// By how much a newton stretches it, in m/N: its straight length over EA; 0 where
    /// it does not stretch.
    pub compliance: f64,
    /// Its diameter, in metres.
    pub diameter: f64,
}
