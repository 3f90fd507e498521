//! How the points of a robot's disks move with the states and controls of its
//! chain: what rows, motions and pictures of contact need to know of a mechanics.

use crate::geometry::{Vector, perpendicular};
use crate::robot::{Nodes, PlanarNode};
use crate::solver::DynamicsCurvature;
use nalgebra::{SMatrix, SVector};

/// A point that moves with the state before a stage and with its controls, which
/// bend the robot below the point one after the other.
///
/// A bend turns all that is beyond it clockwise. So the second derivative in a bend
/// and in one above it is the displacement of the latter, turned; only that in the
/// bend itself is a quantity of its own.
#[derive(Clone, Copy, Debug)]
pub struct Inside<const NU: usize> {
    /// The displacement under a unit turn of the state, counterclockwise. Those under
    /// its motions are the axes.
    pub by_turn: Vector,
    /// The displacement under a unit change of each control.
    pub by_control: [Vector; NU],
    /// Its rate of change in that control.
    pub own: [Vector; NU],
    /// The bend, in radians, of a unit change of a control.
    pub bend: f64,
}

impl<const NU: usize> Inside<NU> {
    /// The gradient of w·x in the state, where x is the point.
    pub fn by_state(&self, weight: Vector) -> SVector<f64, 3> {
        nalgebra::vector![weight.x, weight.y, weight.dot(&self.by_turn)]
    }

    /// The gradient of w·x in the controls.
    pub fn by_control(&self, weight: Vector) -> SVector<f64, NU> {
        SVector::from_fn(|i, _| weight.dot(&self.by_control[i]))
    }

    /// The second derivative of w·x.
    pub fn curvature(&self, weight: Vector) -> DynamicsCurvature<3, NU> {
        let turned = perpendicular(weight);
        let mut curvature = DynamicsCurvature {
            by_state: SMatrix::zeros(),
            mixed: SMatrix::zeros(),
            by_control: SMatrix::zeros(),
        };
        // w · perpendicular(d) = −perpendicular(w) · d.
        curvature.by_state[(2, 2)] = -turned.dot(&self.by_turn);
        for i in 0..NU {
            let along = turned.dot(&self.by_control[i]);
            curvature.mixed[(2, i)] = -along;
            curvature.by_control[(i, i)] = weight.dot(&self.own[i]);
            for below in 0..i {
                curvature.by_control[(below, i)] = self.bend * along;
                curvature.by_control[(i, below)] = self.bend * along;
            }
        }
        curvature
    }
}

/// A shape of which it is known how it moves.
pub trait Kinematics<const NU: usize>: Nodes {
    /// The stage that a node ends or is inside of, from 1.
    fn stage(&self, node: usize) -> usize;

    /// Whether a node is inside a stage and no state of the chain.
    fn is_inside(&self, node: usize) -> bool;

    /// The point of a node's disk a distance `lever` from the backbone, as a function
    /// of the state before a stage and of its controls. The node ends the stage, is
    /// inside it or is the one before. `None` where no node is inside a stage.
    fn inside(&self, stage: usize, node: usize, lever: f64) -> Option<Inside<NU>>;
}

impl<const NU: usize> Kinematics<NU> for [PlanarNode] {
    #[inline]
    fn stage(&self, node: usize) -> usize {
        node
    }

    #[inline]
    fn is_inside(&self, _node: usize) -> bool {
        false
    }

    fn inside(&self, _stage: usize, _node: usize, _lever: f64) -> Option<Inside<NU>> {
        None
    }
}
