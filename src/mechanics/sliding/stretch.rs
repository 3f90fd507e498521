//! A cable's stretch between two disks: its length with two derivatives in the bends
//! of the arcs between.

use super::bay::Bay;
use crate::geometry::Vector;
use crate::solver::Control;
use nalgebra::SMatrix;

/// The length of a stretch, and how it changes with the controls of its bay.
///
/// With H the hole of the upper disk, H₀ that of the lower one, D = H − H₀ and its
/// direction t:
///
/// ```text
/// len = |D|    ∂len = t·∂H    ∂²len = (∂H·∂H′ − (t·∂H)(t·∂H′))/len + t·∂²H
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Stretch<const NU: usize> {
    /// In metres.
    pub length: f64,
    /// ∂len/∂u.
    pub gradient: Control<NU>,
    direction: Vector,
    holes: [Vector; NU],
}

impl<const NU: usize> Stretch<NU> {
    /// The stretch of a cable at an offset, in metres, in a bay.
    pub fn of(bay: &Bay<NU>, offset: f64) -> Self {
        let hole = bay.point(bay.arcs(), offset);
        let along = bay.at(bay.arcs(), offset) - bay.at(0, offset);
        let length = along.norm();
        let direction = along / length;
        Self {
            length,
            gradient: hole.by_control(direction),
            direction,
            holes: hole.by_control,
        }
    }

    /// ∂²len/∂u².
    pub fn curvature(&self, bay: &Bay<NU>, offset: f64) -> SMatrix<f64, NU, NU> {
        let hole = bay.point(bay.arcs(), offset);
        let turning = SMatrix::from_fn(|i, j| {
            let along = self.gradient[i] * self.gradient[j];
            (self.holes[i].dot(&self.holes[j]) - along) / self.length
        });
        turning + hole.curvature(self.direction).by_control
    }
}
