//! Whether the multipliers of what touches are the only ones possible.

use crate::math::PackedCholesky;
use crate::robot::Robot;
use crate::solver::{Chain, Control, Point};

/// More touching rows than this are only compared node by node.
const FEW: usize = 64;

/// Whether the gradients of all touching rows are linearly independent. Of
/// more than a few rows only those of the same node are compared with each
/// other, so that the test stays linear in the rows: two obstacles that touch
/// the same nodes alike are found all the same.
pub(super) fn independent<C: Chain<3, NU>, const NU: usize>(
    point: &Point<C, 3, NU>,
    length: f64,
) -> bool {
    let mut rows: Vec<_> = point.rows.iter().collect();
    rows.retain(|row| row.value <= Robot::TOUCHING * length);
    if rows.len() <= FEW {
        return independent_in_controls(point, length);
    }
    rows.sort_by_key(|row| row.stage);
    rows.len() <= point.stages.len()
        && rows.chunk_by(|a, b| a.stage == b.stage).all(|node| {
            let gradients = nalgebra::DMatrix::from_fn(3, node.len(), |axis, i| {
                // Angles count as much as a length of the robot.
                node[i].after[axis] / if axis == 2 { length } else { 1.0 }
            });
            node.len() <= 3 && gradients.rank(1e-9) == node.len()
        })
}

/// Whether they are, each as a gradient in all controls.
fn independent_in_controls<C: Chain<3, NU>, const NU: usize>(
    point: &Point<C, 3, NU>,
    length: f64,
) -> bool {
    let touching: Vec<Vec<Control<NU>>> = point
        .rows
        .iter()
        .filter(|row| row.value <= Robot::TOUCHING * length)
        .map(|row| point.row_gradient(row))
        .collect();
    let dot = |a: &[Control<NU>], b: &[Control<NU>]| -> f64 {
        a.iter().zip(b).map(|(a, b)| a.dot(b)).sum()
    };
    let mut factor = PackedCholesky::default();
    touching.iter().enumerate().all(|(i, row)| {
        let column: Vec<f64> = touching[..i].iter().map(|other| dot(row, other)).collect();
        let diagonal = dot(row, row);
        diagonal > 0.0 && factor.append(&column, diagonal, 1e-9 * diagonal).is_ok()
    })
}
