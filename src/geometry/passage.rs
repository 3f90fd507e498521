//! Whether a motion leads through an obstacle. It judges motions between two
//! instants; it moves nothing.
//!
//! Both the robot's points and the obstacle may move. Everything is taken
//! relative to the obstacle's own frame, in which it rests.

use super::edge::sweeps_over;
use super::obstacle::{Core, Obstacle};
use super::{Vector, cross, to_parry};
use crate::math::within;
use parry2d_f64::math::Pose;
use parry2d_f64::query;
use parry2d_f64::shape::{Ball, ConvexPolygon, Segment};

/// One of the robot's points at two instants.
pub type Motion = (Vector, Vector);

/// How far, as a cosine, the normal may turn on a chord through the outline: by
/// a right angle, with room for the rounding of a box's corners.
const TURNED: f64 = -1e-3;
/// How far, as a cosine, the normal inside may be from that of the side by
/// which a point came in: by 60°, more than a fine polygon's sides differ by and
/// less than a box's.
const ENTERED: f64 = 0.5;
/// The way round a corner, as a share of the outline, that a chord may cut off
/// however far the normal turns: a tip of 1/80 of the outline on either side,
/// long enough that rounding decides nothing.
const CORNER: f64 = 0.025;
/// The same, as a share of the outline, for motions however short: behind a tip
/// the two sides are near each other, and a point between them that is led now
/// to one and now to the other would never get away from it.
const TIP: f64 = 1e-3;
/// How many times longer than anything has moved the way round a tip may be: a
/// chord through an acute corner is shorter than the way by the corner's angle.
const SLACK: f64 = 5.0;
/// Heights below this share of an outline's size are on its surface: far above
/// their rounding, far below a step.
const ON_SURFACE: f64 = 1e-9;

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
        let after = later.clearance(to);
        let normal_after = later.turn_to_local(after.normal);
        let through = normal_before.dot(&normal_after) < TURNED
            && later.cuts(start, end, radius)
            && !later.is_corner_between(start, end, radius, moved);
        let inside = after.distance < radius - ON_SURFACE * later.reach;
        through || inside && later.is_entered_elsewhere(start, to, radius, moved)
    }

    /// Whether a point, `radius` thick, that comes straight from a place of the
    /// frame and ends inside the outline, at `to` in the world, came in by
    /// another side than the one it is nearest to: its clearance would lead it
    /// on through.
    fn is_entered_elsewhere(&self, start: Vector, to: Vector, radius: f64, moved: f64) -> bool {
        let from = self.to_world(start);
        let out = self.clearance(to).normal;
        let grown = self.radius + radius;
        let on_surface = ON_SURFACE * self.reach;
        let mut entered = (f64::NEG_INFINITY, None);
        for (vertex, normal) in self.vertices.iter().zip(&self.normals) {
            let height = |point: Vector| normal.dot(&(point - vertex)) - grown;
            let (before, after) = (height(from), height(to));
            let share = before / (before - after);
            if before > -on_surface && after < before && share > entered.0 {
                entered = (share, Some(normal));
            }
        }
        let (share, Some(by)) = entered else {
            return false;
        };
        let entry = self.to_local(from + share.max(0.0) * (to - from));
        by.dot(&out) < ENTERED && !self.is_corner_between(entry, self.to_local(to), radius, moved)
    }

    /// Whether two places of a polygon's frame are on either side of one of its
    /// corners: whether the way from one to the other, to the outline, along it
    /// and away from it, is at most the share [`CORNER`] of the outline, and no
    /// longer than a few times what anything has `moved`.
    fn is_corner_between(&self, a: Vector, b: Vector, radius: f64, moved: f64) -> bool {
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
                let along = within(edge.dot(&(point - start)) / length, 0.0, length);
                let distance = (start + edge * (along / length) - point).norm();
                if distance < nearest.0 {
                    *nearest = (distance, round + along);
                }
            }
            round += length;
        }
        let along = (nearest[0].1 - nearest[1].1).abs();
        let away = nearest.map(|(distance, _)| (distance - self.radius - radius).max(0.0));
        along.min(round - along) + away[0] + away[1]
            <= (CORNER * round).min(SLACK * moved.max(TIP * round))
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
    fn the_tip_of_a_corner_is_gone_round_and_nothing_else_of_it() {
        let wedge = [[0.0, 0.0], [0.03, -0.003], [0.03, 0.003]].map(Vector::from);
        let wedge = Obstacle::new(Core::polygon(&wedge).unwrap(), 0.0, Vector::zeros(), 0.0);
        // From one side of the acute corner to the other, 0.4 mm and 4 mm behind it.
        assert!(!passes(&wedge, [0.0004, -0.00004], [0.0004, 0.00004]));
        assert!(passes(&wedge, [0.004, -0.0004], [0.004, 0.0004]));
        // Nor from far away, nor by a motion that is shorter than the way round.
        assert!(passes(&wedge, [0.0004, -0.05], [0.0004, 0.05]));
        let motion = (Vector::new(0.0004, -0.00004), Vector::new(0.0004, 0.00004));
        assert!(wedge.point_passes(&wedge, motion, 0.0, 0.0001));
        let bar = Obstacle::new(Core::segment(0.1), 1e-4, Vector::zeros(), 0.0);
        assert!(passes(&bar, [0.048, 0.05], [0.048, -0.05]));
        // A box's right angle is gone round whatever rounding makes of it.
        for turn in 0..90 {
            let angle = f64::from(turn).to_radians();
            let square = Obstacle::new(Core::rectangle(0.02, 0.02), 0.0, Vector::zeros(), angle);
            let at = |x: f64, y: f64| square.to_world(Vector::new(x, y));
            let motion = (at(0.01, 0.008), at(0.008, 0.01));
            assert!(!square.point_passes(&square, motion, 0.0, 1.0), "{turn}");
        }
    }

    #[test]
    fn a_point_that_comes_in_is_led_out_by_the_same_side() {
        let tall = Obstacle::new(Core::rectangle(0.01, 0.03), 0.0, Vector::zeros(), 0.0);
        // From the top, down to where the right side is nearer.
        assert!(passes(&tall, [0.003, 0.02], [0.003, 0.012]));
        assert!(!passes(&tall, [0.003, 0.02], [0.003, 0.014]));
        // Off the end of a capsule, clear of it.
        let capsule = Obstacle::new(Core::segment(0.1), 1e-3, Vector::zeros(), 0.0);
        assert!(!passes(&capsule, [0.0, 0.0011], [0.056, 0.0]));
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
