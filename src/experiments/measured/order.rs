//! Whether measured points without names lead from the base to the tip. Noise
//! is no disorder: they are judged at a distance that is long against it.

use super::span::{extent, strides};
use super::{MeasuredFault, MeasuredPoint};
use crate::geometry::Vector;
use crate::mechanics::Problem;

/// Points nearer to each other than this, over the length, are one: far below
/// what any measurement tells apart, far above rounding.
const SAME: f64 = 1e-9;
/// A stride is this many times the noise, so that noise turns it by a few
/// degrees.
const CALM: f64 = 10.0;
/// At most this share of the points' extent.
const LONGEST: f64 = 0.25;
/// The median length of p − 2q + r, for points with normal errors of size 1 in
/// both coordinates: √6 times that of a point with such errors, √(2 ln 2).
const MEDIAN: f64 = 2.884;

/// # Errors
/// For points that are there twice, and for those that turn back.
pub(super) fn check(points: &[MeasuredPoint], problem: &Problem) -> Result<(), MeasuredFault> {
    let robot = problem.robot();
    let (length, base) = (robot.length, robot.base.position);
    if let Some((earlier, row)) = twins(points, SAME * length) {
        return Err(MeasuredFault::Duplicate { row, earlier });
    }
    let stride = (CALM * noise(points)).min(LONGEST * extent(points));
    let walked: Vec<_> = strides(points, stride).collect();
    let back = walked.windows(3).find(|three| {
        let [a, b, c] = [three[0].1, three[1].1, three[2].1];
        (b - a).dot(&(c - b)) < 0.0
    });
    if let Some(three) = back {
        let row = points[three[2].0].row;
        return Err(MeasuredFault::Unsorted { row });
    }
    // The first may yet be the tip.
    let reach = |p: &MeasuredPoint| (p.position - base).norm();
    let (first, last) = (&points[0], &points[points.len() - 1]);
    if reach(first) > reach(last) && reach(first) > 0.5 * length {
        return Err(MeasuredFault::Unsorted { row: last.row });
    }
    Ok(())
}

/// The size of the points' errors in a coordinate, in metres, from how far each
/// is from the middle of its neighbours: half of them may be out of order. Bends
/// count as noise, little where points are dense.
fn noise(points: &[MeasuredPoint]) -> f64 {
    let three = points.windows(3);
    let mut off: Vec<f64> = three
        .map(|p| (p[0].position - 2.0 * p[1].position + p[2].position).norm())
        .collect();
    off.sort_by(f64::total_cmp);
    off.get(off.len() / 2).map_or(0.0, |median| median / MEDIAN)
}

/// The rows of two points that are one, the first that repeats another.
fn twins(points: &[MeasuredPoint], apart: f64) -> Option<(usize, usize)> {
    // Along a direction that no robot has: many stand along an axis.
    let ahead = Vector::new(0.540_302, 0.841_471);
    let mut order: Vec<(f64, usize)> = points
        .iter()
        .map(|p| ahead.dot(&p.position))
        .zip(0..)
        .collect();
    order.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut found: Option<(usize, usize)> = None;
    for (k, (at, a)) in order.iter().enumerate() {
        let near = order[k + 1..].iter();
        for (_, b) in near.take_while(|(other, _)| other - at <= apart) {
            let (earlier, later) = (*a.min(b), *a.max(b));
            let first = found.is_none_or(|(_, known)| later < known);
            let between = points[earlier].position - points[later].position;
            if first && between.norm() <= apart {
                found = Some((earlier, later));
            }
        }
    }
    found.map(|(earlier, later)| (points[earlier].row, points[later].row))
}
