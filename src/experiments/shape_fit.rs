//! How far a computed shape is from a measured one. A point that knows its node
//! is compared with it, as the paper does; one that does not is compared with
//! the nearest point of the computed backbone.

use super::links::Links;
use super::{Measured, MeasuredPoint};
use crate::equilibrium::Solution;
use serde::{Deserialize, Serialize};

/// A computed shape's distances from a measured one.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct ShapeFit {
    /// The pull of the computed shape, in metres.
    pub pull: f64,
    /// The root of the mean squared distance, in metres: the paper's measure.
    pub rms: f64,
    /// The greatest distance, in metres.
    pub max: f64,
    /// The row of the greatest distance.
    pub max_row: usize,
    /// By measured point, in metres.
    pub distances: Vec<f64>,
}

/// A shape's distances from a measured one, in a time that grows little faster
/// than points and nodes do.
pub fn compare(solution: &Solution, measured: &Measured) -> ShapeFit {
    let points = measured.points();
    let distances: Vec<f64> = points.iter().map(distances(solution)).collect();
    let squares: f64 = distances.iter().map(|d| d * d).sum();
    let (worst, max) =
        distances.iter().enumerate().fold(
            (0, 0.0),
            |most, (i, d)| if *d > most.1 { (i, *d) } else { most },
        );
    ShapeFit {
        pull: solution.pull,
        rms: (squares / distances.len() as f64).sqrt(),
        max,
        max_row: points[worst].row,
        distances,
    }
}

/// The RMS distance of a shape from a measured one, in metres, or something
/// between it and a limit that it is above: a few points tell that a shape is
/// far off.
pub(super) fn rms_up_to(solution: &Solution, measured: &Measured, limit: f64) -> f64 {
    let points = measured.points();
    let count = points.len() as f64;
    let mut distance = distances(solution);
    let mut squares = 0.0;
    // Points from everywhere, the tip's first.
    for offset in 0..SPREAD {
        for point in points.iter().rev().skip(offset).step_by(SPREAD) {
            let distance = distance(point);
            squares += distance * distance;
            if squares > count * limit * limit {
                return (squares / count).sqrt();
            }
        }
    }
    (squares / count).sqrt()
}

/// Every how many-th point is looked at first.
const SPREAD: usize = 61;

/// The distance of a measured point from a shape, in metres.
fn distances(solution: &Solution) -> impl FnMut(&MeasuredPoint) -> f64 + '_ {
    let mut backbone = None;
    move |point| match point.node {
        Some(node) => (solution.nodes[node].position - point.position).norm(),
        None => backbone
            .get_or_insert_with(|| Links::new(solution.backbone().collect()))
            .distance(point.position),
    }
}
