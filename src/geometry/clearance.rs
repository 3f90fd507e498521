//! The clearance of a point from an obstacle, exact to rounding.
//!
//! The distance to a polygon is taken edge by edge with parry's segment
//! projection: parry's own polygon projection iterates to a tolerance that
//! would end up in the multipliers. What edges of the robot add to this is in
//! [`super::edge`].

use super::obstacle::{Core, Obstacle};
use super::{Vector, from_parry, to_parry};
use parry2d_f64::query::PointQueryWithLocation;
use parry2d_f64::shape::{Segment, SegmentPointLocation};

/// The clearance of a point: value, gradient, Hessian.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PointClearance {
    /// Signed distance to the surface, negative inside.
    pub distance: f64,
    /// Its gradient, the outward unit normal.
    pub normal: Vector,
    /// Its second derivative along the surface, 1/distance to the core where
    /// the nearest feature is a point and 0 where it is an edge.
    pub curvature: f64,
}

impl Obstacle {
    /// Whether a point is certainly farther from the surface than `margin`;
    /// cheap, and false for some points that are.
    #[inline]
    pub fn is_beyond(&self, point: Vector, margin: f64) -> bool {
        let away = point - self.position();
        match self.core {
            Core::HalfPlane => self.wall_normal().dot(&away) > self.radius + margin,
            _ => {
                let near = self.reach + margin;
                near < 0.0 || away.norm_squared() > near * near
            }
        }
    }

    /// The clearance of a point. Where the point is equally near to two
    /// features (inside, on the core's medial axis) the first one counts.
    pub fn clearance(&self, point: Vector) -> PointClearance {
        match self.core {
            Core::HalfPlane => {
                let normal = self.wall_normal();
                PointClearance {
                    distance: normal.dot(&(point - self.position())) - self.radius,
                    normal,
                    curvature: 0.0,
                }
            }
            Core::Point => self.near_vertex(point - self.position(), Vector::x()),
            Core::Vertices(_) => self.near_polygon(point),
        }
    }

    /// The clearance where a core vertex is nearest, `away` from it; `instead`
    /// is the normal of a point exactly on the vertex.
    fn near_vertex(&self, away: Vector, instead: Vector) -> PointClearance {
        let to_core = away.norm();
        let normal = if to_core > 0.0 {
            away / to_core
        } else {
            instead
        };
        PointClearance {
            distance: to_core - self.radius,
            normal,
            // Bounded, for a point on a sharp corner.
            curvature: 1.0 / to_core.max(1e-9),
        }
    }

    pub(super) fn near_edge(&self, edge: usize, height: f64) -> PointClearance {
        PointClearance {
            distance: height - self.radius,
            normal: self.normals[edge],
            curvature: 0.0,
        }
    }

    fn near_polygon(&self, point: Vector) -> PointClearance {
        let height = |i: usize| self.normals[i].dot(&(point - self.vertices[i]));
        let mut highest = (0, height(0));
        for i in 1..self.vertices.len() {
            let height = height(i);
            if height > highest.1 {
                highest = (i, height);
            }
        }
        // A segment has no inside: a point on its line is beyond neither side.
        if highest.1 <= 0.0 && self.vertices.len() > 2 {
            return self.near_edge(highest.0, highest.1);
        }
        let mut nearest = (f64::INFINITY, 0, None);
        for i in 0..self.vertices.len() {
            let next = (i + 1) % self.vertices.len();
            let edge = Segment::new(to_parry(self.vertices[i]), to_parry(self.vertices[next]));
            let (projection, location) =
                edge.project_local_point_and_get_location(to_parry(point), true);
            let away = point - from_parry(projection.point);
            // Behind an edge another one is nearer; of a segment's two sides,
            // rounding may put a point on its line behind both.
            let faces = height(i) >= 0.0 || (self.vertices.len() == 2 && i == highest.0);
            if away.norm_squared() < nearest.0 && faces {
                let corner = match location {
                    SegmentPointLocation::OnVertex(0) => Some(i),
                    SegmentPointLocation::OnVertex(_) => Some(next),
                    SegmentPointLocation::OnEdge(_) => None,
                };
                nearest = (away.norm_squared(), i, corner);
            }
        }
        match nearest.2 {
            Some(corner) => {
                self.near_vertex(point - self.vertices[corner], self.normals[nearest.1])
            }
            None => self.near_edge(nearest.1, height(nearest.1)),
        }
    }
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;
    use crate::geometry::perpendicular;

    /// One obstacle of each kind.
    pub(in crate::geometry) fn shapes() -> Vec<Obstacle> {
        let polygon = Core::polygon(&[
            Vector::new(-0.02, -0.015),
            Vector::new(0.025, -0.01),
            Vector::new(0.015, 0.02),
            Vector::new(-0.01, 0.022),
        ])
        .unwrap();
        let at = Vector::new(0.03, 0.08);
        vec![
            Obstacle::new(Core::Point, 0.012, at, 0.0),
            Obstacle::new(Core::HalfPlane, 0.003, at, 2.5),
            Obstacle::new(Core::rectangle(0.04, 0.02), 0.0, at, 0.4),
            Obstacle::new(Core::rectangle(0.04, 0.02), 0.005, at, -0.7),
            Obstacle::new(Core::segment(0.05), 0.004, at, 1.1),
            Obstacle::new(polygon, 0.002, at, 0.3),
        ]
    }

    #[test]
    fn known_distances() {
        let box_ = Obstacle::new(Core::rectangle(2.0, 1.0), 0.25, Vector::zeros(), 0.0);
        let check = |x: f64, y: f64, distance: f64, curvature: f64| {
            let clearance = box_.clearance(Vector::new(x, y));
            assert!((clearance.distance - distance).abs() < 1e-15, "{x} {y}");
            assert!((clearance.curvature - curvature).abs() < 1e-12, "{x} {y}");
        };
        check(0.3, 2.5, 1.75, 0.0);
        check(1.3, 0.9, 0.25, 2.0);
        check(0.0, 0.4, -0.35, 0.0);
        check(0.95, 0.0, -0.3, 0.0);
    }

    #[test]
    fn a_point_on_a_capsules_axis_is_as_far_as_its_end() {
        let capsule = Obstacle::new(Core::segment(0.05), 0.006, Vector::zeros(), 0.0);
        let check = |x: f64, y: f64, distance: f64, normal: [f64; 2]| {
            let clearance = capsule.clearance(Vector::new(x, y));
            assert!(
                (clearance.distance - distance).abs() < 1e-16,
                "{clearance:?}"
            );
            assert!((clearance.normal - Vector::from(normal)).norm() < 1e-12);
        };
        check(0.2, 0.0, 0.169, [1.0, 0.0]);
        check(-0.031, 0.0, 0.0, [-1.0, 0.0]);
        check(0.01, 0.01, 0.004, [0.0, 1.0]);
        check(0.01, -0.01, 0.004, [0.0, -1.0]);
        // On the axis itself either side is as near.
        assert_eq!(capsule.clearance(Vector::zeros()).distance, -0.006);
    }

    /// Central differences of step h err by h²/6 times the third derivative,
    /// of order 1/distance² here, and by rounding 1e-16/h: both near 1e-9.
    #[test]
    fn gradient_and_curvature_of_points_against_finite_differences() {
        let h = 1e-7;
        for obstacle in shapes() {
            for i in 0..400 {
                let angle = f64::from(i) * 0.7;
                let radius = 0.02 + 0.0002 * f64::from(i);
                let point = Vector::new(0.03, 0.08)
                    + radius * Vector::new(libm::cos(angle), libm::sin(angle));
                let here = obstacle.clearance(point);
                let tangent = perpendicular(here.normal);
                let near = |step: Vector| obstacle.clearance(point + step);
                let ends = [near(h * tangent), near(-h * tangent)];
                if ends
                    .iter()
                    .any(|end| (end.curvature == 0.0) != (here.curvature == 0.0))
                {
                    continue;
                }
                let slope =
                    (near(h * here.normal).distance - near(-h * here.normal).distance) / (2.0 * h);
                assert!((slope - 1.0).abs() < 1e-7, "{obstacle:?} {point:?}");
                let turn = (ends[0].normal - ends[1].normal).dot(&tangent) / (2.0 * h);
                assert!((turn - here.curvature).abs() < 1e-5 * (1.0 + here.curvature));
            }
        }
    }

    #[test]
    fn points_on_the_axis_of_a_turned_capsule_are_beyond_its_end() {
        for i in 0..360 {
            let angle = f64::from(i).to_radians();
            let capsule = Obstacle::new(Core::segment(0.06), 0.003, Vector::new(-0.2, 0.3), angle);
            let along = Vector::new(libm::cos(angle), libm::sin(angle));
            for share in [0.031, 0.054, 0.2] {
                let clearance = capsule.clearance(Vector::new(-0.2, 0.3) + share * along);
                assert!(
                    (clearance.distance - (share - 0.033)).abs() < 1e-15,
                    "{i} {share}"
                );
            }
        }
    }
}
