//! A node of the planar robot: where it is and how its disk points.

use crate::geometry::{Vector, perpendicular};
use serde::{Deserialize, Serialize};

/// A backbone point with the direction of its disk towards the cable.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct PlanarNode {
    /// The backbone point, in metres.
    pub position: Vector,
    /// (cos φ, sin φ), from the backbone towards the cable.
    pub disk: Vector,
    /// φ, counterclockwise from +x and not wrapped.
    pub angle: f64,
}

impl PlanarNode {
    /// The point of the disk a distance `lever` from the backbone, positive
    /// towards the cable.
    pub fn at(&self, lever: f64) -> Vector {
        self.position + lever * self.disk
    }

    /// The disk's normal, along the backbone towards the tip.
    pub fn normal(&self) -> Vector {
        perpendicular(self.disk)
    }
}
