//! A point of a disk as a function of its node's state, with two derivatives.

use crate::geometry::Vector;
use crate::robot::PlanarNode;
use crate::solver::State;

/// A point of a disk as a function of its node's state.
#[derive(Clone, Copy, Debug)]
pub(super) struct DiskPoint<'a> {
    pub node: &'a PlanarNode,
    pub lever: f64,
}

impl DiskPoint<'_> {
    /// The gradient of w·x, where x is the point.
    pub fn gradient(&self, weight: Vector) -> State<3> {
        let turn = self.lever * weight.dot(&self.node.normal());
        nalgebra::vector![weight.x, weight.y, turn]
    }

    /// The second derivative of w·x in φ; all others are zero.
    pub fn curvature(&self, weight: Vector) -> f64 {
        -self.lever * weight.dot(&self.node.disk)
    }

    /// The displacement of the point under a unit change of state component
    /// `index`.
    pub fn displacement(&self, index: usize) -> Vector {
        match index {
            0 => Vector::x(),
            1 => Vector::y(),
            _ => self.lever * self.node.normal(),
        }
    }
}
