//! How long a measured backbone is, against its robot: numbers in another unit
//! make a tiny robot, which a strong pull curls up in until it fits.

use super::{MeasuredFault, MeasuredPoint};
use crate::geometry::Vector;
use crate::mechanics::Problem;

/// A backbone this many times shorter or longer than its robot is in another
/// unit: that between cm and mm is 10, and nobody measures a quarter.
const FACTOR: f64 = 4.0;
/// A line's length is measured in strides of this share of its extent, longer
/// than its points are off and short against its bends.
const STRIDE: f64 = 1.0 / 16.0;

/// The length of the line through measured points, at least one, in metres.
///
/// # Errors
/// If the robot's is another by a factor.
pub(super) fn check(points: &[MeasuredPoint], problem: &Problem) -> Result<f64, MeasuredFault> {
    let robot = problem.robot();
    let length = length_in_strides(points, STRIDE * extent(points));
    let (found, expected) = if points[0].node.is_some() {
        straightest(points, robot.length, robot.segments)
    } else {
        (length, robot.length)
    };
    if found * FACTOR < expected || found > FACTOR * expected {
        return Err(MeasuredFault::Length { found, expected });
    }
    Ok(length)
}

/// The greater side of the rectangle about the points, in metres.
pub(super) fn extent(points: &[MeasuredPoint]) -> f64 {
    let positions = || points.iter().map(|point| point.position);
    let low = positions().fold(points[0].position, |a, b| a.inf(&b));
    let high = positions().fold(points[0].position, |a, b| a.sup(&b));
    (high - low).amax()
}

/// Of the pieces between named nodes that which is longest for its nodes: its
/// length, and that of the robot along it. The ends of a bent piece are nearer
/// to each other than it is long; those of a short one are so by their noise.
fn straightest(points: &[MeasuredPoint], length: f64, segments: usize) -> (f64, f64) {
    let node = |point: &MeasuredPoint| point.node.unwrap_or(0);
    let (first, last) = (&points[0], &points[points.len() - 1]);
    let along = |a: &MeasuredPoint, b: &MeasuredPoint| {
        length * (node(b) - node(a)) as f64 / segments as f64
    };
    let shortest = (STRIDE * length).min(along(first, last));
    let (mut found, mut expected) = (0.0, length);
    let mut before = first;
    for point in points {
        let (apart, way) = (
            (point.position - before.position).norm(),
            along(before, point),
        );
        if way < shortest {
            continue;
        }
        if apart * expected > found * way {
            (found, expected) = (apart, way);
        }
        before = point;
    }
    (found, expected)
}

fn length_in_strides(points: &[MeasuredPoint], stride: f64) -> f64 {
    let walked: Vec<(usize, Vector)> = strides(points, stride).collect();
    let pieces = walked.windows(2).map(|ends| (ends[1].1 - ends[0].1).norm());
    // What is left between the last stride's end and the last point.
    let rest = match (walked.last(), points.last()) {
        (Some((_, at)), Some(last)) => (last.position - at).norm(),
        _ => 0.0,
    };
    pieces.sum::<f64>() + rest
}

/// The first point and every one that is this far from the one taken before,
/// with their indices.
pub(super) fn strides(
    points: &[MeasuredPoint],
    stride: f64,
) -> impl Iterator<Item = (usize, Vector)> {
    let mut before: Option<Vector> = None;
    let places = points.iter().map(|point| point.position).enumerate();
    places.filter(move |(_, place)| {
        let far = before.is_none_or(|before| (place - before).norm() >= stride);
        if far {
            before = Some(*place);
        }
        far
    })
}
