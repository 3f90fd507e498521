//! Whether a motion leads through an obstacle. It judges motions between two
//! instants; it moves nothing.
//!
//! Both the robot's points and the obstacle may move. Everything is taken
//! relative to the obstacle's own frame, in which it rests.

use super::edge::sweeps_over;
use super::obstacle::{Core, Obstacle};
use super::{Vector, cross, perpendicular, to_parry};
use parry2d_f64::math::Pose;
use parry2d_f64::query;
use parry2d_f64::shape::{Ball, ConvexPolygon, Segment};

/// One of the robot's points at two instants.
pub type Motion = (Vector, Vector);

/// How far, as a cosine, the normal may turn on a chord through the outline: by
/// a right angle, with room for the rounding of a box's corners.
const TURNED: f64 = -1e-3;
/// How far, as a cosine, the normal inside may be from that of the side by
/// which a point came in: by 60°.
const ENTERED: f64 = 0.5;
/// The way round a corner, as a share of the outline, that a chord may cut off
/// however far the normal turns. Rounding decides nothing at this length, and
/// what is cut off is a tip of 1/80 of the outline's length on either side.
const CORNER: f64 = 0.025;

impl Obstacle {
    /// Whether a point, `radius` thick, that goes straight from one place to
    /// another, while this obstacle becomes `later`, passes through it: its
    /// path cuts the outline, the outward normal turns by more than a right
    /// angle, and the way round is not just the tip of a corner. A point that
    /// slides around a curved surface also cuts a chord, but turns little in a
    /// small step; one that slides round an acute corner turns at once, but
    /// gets no farther.
    ///
    /// `moved` is an upper bound of how far the point goes relative to the
    /// obstacle; one that is farther away is not looked at.
    pub fn point_passes(&self, later: &Self, (from, to): Motion, radius: f64, moved: f64) -> bool {
        if self.is_beyond(from, radius + moved) {
            return false;
        }
        let start = self.to_local(from);
        let end = later.to_local(to);
        let normal_before = self.turn_to_local(self.clearance(from).normal);
        let normal_after = later.turn_to_local(later.clearance(to).normal);
        let through = normal_before.dot(&normal_after) < TURNED
            && later.cuts(start, end, radius)
            && !later.is_corner_between(start, end);
        through || later.is_entered_elsewhere(start, end, radius, normal_after)
    }

    /// Whether a point, `radius` thick, that goes straight between two places
    /// of a polygon's frame ends inside the outline and nearer to another side
    /// than the one by which it came: its clearance would lead it on through.
    fn is_entered_elsewhere(&self, start: Vector, end: Vector, radius: f64, out: Vector) -> bool {
        let Core::Vertices(vertices) = &self.core else {
            return false;
        };
        let grown = self.radius + radius;
        let mut entered = (0.0, None);
        for (a, b) in vertices.iter().zip(vertices.iter().cycle().skip(1)) {
            let normal = -perpendicular(b - a).normalize();
            let height = |point: Vector| normal.dot(&(point - a)) - grown;
            let (before, after) = (height(start), height(end));
            if after >= 0.0 {
                return false;
            }
            let share = before / (before - after);
            if before > 0.0 && share >= entered.0 {
                entered = (share, Some(normal));
            }
        }
        let (share, Some(by)) = entered else {
            return false;
        };
        by.dot(&out) < ENTERED && !self.is_corner_between(start + share * (end - start), end)
    }

    /// Whether the shorter way along a polygon's outline from the place nearest
    /// to one point of its frame to that nearest to another is at most the
    /// share [`CORNER`] of the outline.
    fn is_corner_between(&self, a: Vector, b: Vector) -> bool {
        let Core::Vertices(vertices) = &self.core else {
            return false;
        };
        let (mut round, mut nearest) = (0.0, [(f64::INFINITY, 0.0); 2]);
        for (start, end) in vertices.iter().zip(vertices.iter().cycle().skip(1)) {
            let edge = end - start;
            let length = edge.norm();
            for (point, nearest) in [a, b].iter().zip(&mut nearest) {
                // Of a segment's two sides, the one that the point is on.
                if vertices.len() == 2 && cross(edge, point - start) > 0.0 {
                    continue;
                }
                let along = (edge.dot(&(point - start)) / length).clamp(0.0, length);
                let distance = (start + edge * (along / length) - point).norm();
                if distance < nearest.0 {
                    *nearest = (distance, round + along);
                }
            }
            round += length;
        }
        let way = (nearest[0].1 - nearest[1].1).abs();
        way.min(round - way) <= CORNER * round
    }

    /// How far, as a cosine, the outward normal turns for a point, `radius`
    /// thick, that goes straight from one place to another while this obstacle
    /// becomes `later`, and dips into it on the way: it comes nearer first,
    /// goes away in the end, and cuts the outline in between. `None` for one
    /// that does not, or goes less than `least` relative to the obstacle;
    /// `moved` as for [`Obstacle::point_passes`].
    pub fn point_dips(
        &self,
        later: &Self,
        (from, to): Motion,
        radius: f64,
        (least, moved): (f64, f64),
    ) -> Option<f64> {
        if self.is_beyond(from, radius + moved) {
            return None;
        }
        let start = self.to_local(from);
        let end = later.to_local(to);
        if (end - start).norm() < least {
            return None;
        }
        // The distance to a convex outline is convex along the path.
        let before = self.turn_to_local(self.clearance(from).normal);
        if before.dot(&(end - start)) >= 0.0 {
            return None;
        }
        let after = later.turn_to_local(later.clearance(to).normal);
        let dips = after.dot(&(end - start)) > 0.0 && later.cuts(start, end, radius);
        dips.then(|| before.dot(&after))
    }

    /// Whether an edge, its ends moving straight, sweeps over the obstacle
    /// while it becomes `later`: over a vertex of a point's or a segment's
    /// core, which always lie within a radius, or over a polygon's middle. (A
    /// polygon may be sharp: its vertices are on the edge in contact, and a
    /// little beyond it between two iterations.) `moved` as for points.
    pub fn edge_passes(
        &self,
        later: &Self,
        (a, b): (Motion, Motion),
        tolerance: f64,
        moved: f64,
    ) -> bool {
        if self.is_beyond(a.0, (b.0 - a.0).norm() + moved) {
            return false;
        }
        let before = (self.to_local(a.0), self.to_local(b.0));
        let after = (later.to_local(a.1), later.to_local(b.1));
        // Relative to a vertex, which itself moves where the obstacle grows.
        let over = |(first, last): (&Vector, &Vector)| {
            let before = (before.0 - first, before.1 - first);
            let after = (after.0 - last, after.1 - last);
            sweeps_over(Vector::zeros(), before, after, tolerance)
        };
        match (&self.core, &later.core) {
            (Core::HalfPlane, _) => false,
            (Core::Vertices(first), Core::Vertices(last)) if last.len() == 2 => {
                first.iter().zip(last).any(over)
            }
            _ => over((&Vector::zeros(), &Vector::zeros())),
        }
    }

    fn turn_to_local(&self, direction: Vector) -> Vector {
        self.to_local(direction + self.position())
    }

    /// Whether a segment in the obstacle's frame comes nearer to the core
    /// than the radii together.
    fn cuts(&self, start: Vector, end: Vector, radius: f64) -> bool {
        let path = Segment::new(to_parry(start), to_parry(end));
        let here = Pose::identity();
        let distance = match &self.core {
            Core::HalfPlane => return false,
            Core::Point => query::distance(&here, &path, &here, &Ball::new(0.0)),
            Core::Vertices(vertices) if vertices.len() == 2 => {
                let core = Segment::new(to_parry(vertices[0]), to_parry(vertices[1]));
                query::distance(&here, &path, &here, &core)
            }
            Core::Vertices(vertices) => {
                let points = vertices.iter().copied().map(to_parry).collect();
                match ConvexPolygon::from_convex_polyline_unmodified(points) {
                    Some(core) => query::distance(&here, &path, &here, &core),
                    None => return false,
                }
            }
        };
        // parry supports every pair named here.
        let Ok(found) = distance else { return false };
        let grown = self.radius + radius;
        found.distance < grown || (grown == 0.0 && found.distance <= 0.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn passes(obstacle: &Obstacle, from: [f64; 2], to: [f64; 2]) -> bool {
        obstacle.point_passes(obstacle, (from.into(), to.into()), 0.0, 1.0)
    }

    #[test]
    fn straight_through_is_a_passage_and_sliding_is_not() {
        let disc = Obstacle::new(Core::Point, 0.01, Vector::new(0.1, 0.1), 0.0);
        assert!(passes(&disc, [0.08, 0.1], [0.12, 0.101]));
        assert!(!passes(&disc, [0.08, 0.1], [0.088, 0.1]));
        assert!(!passes(&disc, [0.09, 0.1], [0.0905, 0.103]));
        assert!(!passes(&disc, [0.08, 0.1], [0.12, 0.13]));
    }

    #[test]
    fn a_thin_bar_stops_a_long_stride() {
        let bar = Obstacle::new(Core::segment(0.1), 1e-4, Vector::zeros(), 0.0);
        assert!(passes(&bar, [0.0, 0.05], [0.0, -0.05]));
        assert!(!passes(&bar, [0.07, 0.05], [0.07, -0.05]));
        let sharp = Core::polygon(&[
            Vector::new(-0.05, 0.0),
            Vector::new(0.05, 0.0),
            Vector::new(0.0, 1e-5),
        ]);
        let blade = Obstacle::new(sharp.unwrap(), 0.0, Vector::zeros(), 0.0);
        assert!(passes(&blade, [0.0, 0.05], [0.0, -0.05]));
    }

    #[test]
    fn what_counts_is_the_motion_relative_to_the_obstacle() {
        let before = Obstacle::new(Core::Point, 0.01, Vector::new(-0.1, 0.0), 0.0);
        let after = before.moved(Vector::new(0.2, 0.0));
        let rest = (Vector::zeros(), Vector::zeros());
        assert!(before.point_passes(&after, rest, 0.0, 1.0));
        let along = (Vector::zeros(), Vector::new(0.2, 0.0));
        assert!(!before.point_passes(&after, along, 0.0, 1.0));
    }

    #[test]
    fn an_edge_sweeps_over_a_thin_disc_that_misses_its_ends() {
        let disc = Obstacle::new(Core::Point, 1e-4, Vector::zeros(), 0.0);
        let a = (Vector::new(-0.01, 0.01), Vector::new(-0.01, -0.01));
        let b = (Vector::new(0.01, 0.01), Vector::new(0.01, -0.01));
        assert!(disc.edge_passes(&disc, (a, b), 1e-9, 1.0));
        assert!(!disc.point_passes(&disc, a, 0.0, 1.0));
        let beside = (Vector::new(0.03, 0.01), Vector::new(0.03, -0.01));
        assert!(!disc.edge_passes(&disc, (b, beside), 1e-9, 1.0));
    }
}
