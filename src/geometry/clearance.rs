//! Clearances of points and edges from an obstacle, exact to rounding.
//!
//! The distance from a point to a polygon is taken edge by edge with parry's
//! segment projection: parry's own polygon projection iterates to a tolerance
//! that would end up in the multipliers.
//!
//! An edge (a link or a disk of the robot) touches an obstacle either with
//! one of its ends, which is a point's clearance, or with its inside on a
//! vertex of the obstacle's core, which is what [`Obstacle::edge_clearances`]
//! gives: one row a vertex.

use super::obstacle::{Core, Obstacle};
use super::{Vector, cross, from_parry, perpendicular, to_parry};
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

/// The clearance of an edge's inside from a vertex of the core.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EdgeClearance {
    /// The vertex's index.
    pub vertex: usize,
    /// Signed distance from the edge to the vertex, less the radius.
    pub distance: f64,
    /// The unit normal of the edge that points away from the obstacle.
    pub normal: Vector,
    /// Where the vertex projects on the edge, from 0 at its start to 1.
    pub along: f64,
}

impl Obstacle {
    /// Whether a point is certainly farther from the surface than `margin`;
    /// cheap, and false for some points that are.
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

    fn near_edge(&self, edge: usize, height: f64) -> PointClearance {
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

    /// Calls `each` for every core vertex that the inside of the edge from
    /// `start` to `end` faces, in the order of their indices: the one
    /// farthest towards the edge, and its neighbours.
    ///
    /// Calls it for none where the edge is beyond one of the core's own edges
    /// by more than it is beyond a vertex: its ends are nearer then.
    pub fn edge_clearances(&self, start: Vector, end: Vector, mut each: impl FnMut(EdgeClearance)) {
        let count = self.vertices.len();
        let along = end - start;
        let length = along.norm();
        if count == 0 || length <= 0.0 {
            return;
        }
        let left = perpendicular(along) / length;
        // The greatest and least height of the core beside the edge's line.
        let height = |i: usize| left.dot(&(self.vertices[i] - start));
        let (mut top, mut bottom) = (0, 0);
        for i in 1..count {
            if height(i) > height(top) {
                top = i;
            }
            if height(i) < height(bottom) {
                bottom = i;
            }
        }
        let (facing, normal) = if height(bottom) > -height(top) {
            (bottom, -left)
        } else {
            (top, left)
        };
        let separation = -normal.dot(&(self.vertices[facing] - start));
        if separation < 0.0 && self.beyond_an_edge(start, end, separation) {
            return;
        }
        let neighbours = [(facing + count - 1) % count, facing, (facing + 1) % count];
        for vertex in 0..count {
            if neighbours.contains(&vertex) {
                let offset = self.vertices[vertex] - start;
                let share = along.dot(&offset) / (length * length);
                if share > 0.0 && share < 1.0 {
                    each(EdgeClearance {
                        vertex,
                        distance: -normal.dot(&offset) - self.radius,
                        normal,
                        along: share,
                    });
                }
            }
        }
    }

    /// How deep an edge that crosses the core would have to be moved to be
    /// clear of the outline; `None` where it does not cross the core. An edge
    /// may cross with both ends clear and no vertex near it.
    pub fn crossing_depth(&self, start: Vector, end: Vector) -> Option<f64> {
        if self.vertices.len() < 2 {
            return None;
        }
        // Two convex sets overlap where no edge of either separates them.
        let left = perpendicular(end - start).try_normalize(0.0)?;
        let heights = self.vertices.iter().map(|v| left.dot(&(v - start)));
        let (bottom, top) = heights.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), h| {
            (low.min(h), high.max(h))
        });
        let edges = self.vertices.iter().zip(&self.normals);
        let separation = edges
            .map(|(v, normal)| normal.dot(&(start - v)).min(normal.dot(&(end - v))))
            .fold(bottom.max(-top), f64::max);
        (separation < 0.0).then_some(self.radius - separation)
    }

    /// Whether both points are beyond one of the core's edges by more than
    /// `least`.
    fn beyond_an_edge(&self, a: Vector, b: Vector, least: f64) -> bool {
        self.vertices.iter().zip(&self.normals).any(|(v, normal)| {
            let height = normal.dot(&(a - v)).min(normal.dot(&(b - v)));
            height > least
        })
    }
}

impl EdgeClearance {
    /// The second derivative of the distance along a displacement of the
    /// edge's ends, δ = (`start`, `end`), as the quadratic form's value.
    ///
    /// With e the edge, t its direction, m the normal and δe = `end` −
    /// `start`: δ²d = −(m·δe/|e|) (2 t·δp + (d/|e|) m·δe), where δp is the
    /// displacement of the touching point and d the distance to the vertex.
    pub fn second_derivative(&self, edge: Vector, radius: f64, start: Vector, end: Vector) -> f64 {
        let length = edge.norm();
        let direction = edge / length;
        let turn = self.normal.dot(&(end - start)) / length;
        let touching = start + self.along * (end - start);
        let depth = self.distance + radius;
        -turn * (2.0 * direction.dot(&touching) + depth * turn)
    }
}

/// Whether the moving edge from (`a0`, `b0`) to (`a1`, `b1`), both ends on
/// straight paths, sweeps over the point at rest. Within `tolerance` of the
/// edge at either end of the motion the point counts as on its own side.
pub(super) fn sweeps_over(
    point: Vector,
    (a0, b0): (Vector, Vector),
    (a1, b1): (Vector, Vector),
    tolerance: f64,
) -> bool {
    let area = |a: Vector, b: Vector| cross(b - a, point - a);
    let first = area(a0, b0) / (b0 - a0).norm();
    let last = area(a1, b1) / (b1 - a1).norm();
    if first * last >= 0.0 || first.abs().min(last.abs()) < tolerance {
        return false;
    }
    // The area is quadratic in time; it changes sign once between.
    let at = |t: f64| (a0 + t * (a1 - a0), b0 + t * (b1 - b0));
    let (mut low, mut high) = (0.0, 1.0);
    for _ in 0..50 {
        let middle = 0.5 * (low + high);
        let (a, b) = at(middle);
        if area(a, b) * first > 0.0 {
            low = middle;
        } else {
            high = middle;
        }
    }
    let (a, b) = at(high);
    let share = (b - a).dot(&(point - a)) / (b - a).norm_squared();
    (0.0..=1.0).contains(&share)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn shapes() -> Vec<Obstacle> {
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
                let point =
                    Vector::new(0.03, 0.08) + radius * Vector::new(angle.cos(), angle.sin());
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
    fn second_derivative_of_edges_against_finite_differences() {
        let h = 1e-4;
        let mut checked = 0;
        for obstacle in shapes() {
            for i in 0..200 {
                let angle = f64::from(i) * 0.37;
                let middle =
                    Vector::new(0.03, 0.08) + 0.035 * Vector::new(angle.cos(), angle.sin());
                let turned = angle + 1.57 + 0.2 * (f64::from(i) * 1.3).sin();
                let half = 0.02 * Vector::new(turned.cos(), turned.sin());
                let (start, end) = (middle - half, middle + half);
                let (ds, de) = (Vector::new(0.3, -0.2), Vector::new(-0.5, 0.4));
                let at = |t: f64| {
                    let mut found = Vec::new();
                    obstacle.edge_clearances(start + t * ds, end + t * de, |c| found.push(c));
                    found
                };
                let (here, after, before) = (at(0.0), at(h), at(-h));
                if here.len() != after.len() || here.len() != before.len() {
                    continue;
                }
                for ((c, a), b) in here.iter().zip(&after).zip(&before) {
                    if a.vertex != c.vertex || b.vertex != c.vertex {
                        continue;
                    }
                    checked += 1;
                    let slope = (a.distance - b.distance) / (2.0 * h);
                    let exact = c.normal.dot(&(ds + c.along * (de - ds)));
                    assert!((slope - exact).abs() < 1e-4, "{slope} {exact}");
                    let bend = (a.distance - 2.0 * c.distance + b.distance) / (h * h);
                    let exact = c.second_derivative(end - start, obstacle.radius, ds, de);
                    assert!(
                        (bend - exact).abs() < 1e-2 * (1.0 + exact.abs()),
                        "{bend} {exact}"
                    );
                }
            }
        }
        assert!(checked > 300, "{checked}");
    }

    #[test]
    fn an_edge_across_a_bar_crosses_it_though_both_ends_are_clear() {
        let bar = Obstacle::new(Core::rectangle(0.06, 0.004), 0.0, Vector::zeros(), 0.0);
        let across = bar.crossing_depth(Vector::new(0.0, -0.005), Vector::new(0.001, 0.005));
        assert!((across.unwrap() - 0.007).abs() < 1e-15);
        let capsule = Obstacle::new(Core::segment(0.06), 0.002, Vector::zeros(), 0.3);
        assert!(
            capsule
                .crossing_depth(Vector::new(0.0, -0.005), Vector::new(0.0, 0.006))
                .is_some()
        );
        let beside = bar.crossing_depth(Vector::new(0.031, -0.005), Vector::new(0.031, 0.005));
        assert_eq!(beside, None);
    }

    #[test]
    fn points_on_the_axis_of_a_turned_capsule_are_beyond_its_end() {
        for i in 0..360 {
            let angle = f64::from(i).to_radians();
            let capsule = Obstacle::new(Core::segment(0.06), 0.003, Vector::new(-0.2, 0.3), angle);
            let along = Vector::new(angle.cos(), angle.sin());
            for share in [0.031, 0.054, 0.2] {
                let clearance = capsule.clearance(Vector::new(-0.2, 0.3) + share * along);
                assert!(
                    (clearance.distance - (share - 0.033)).abs() < 1e-15,
                    "{i} {share}"
                );
            }
        }
    }

    #[test]
    fn an_edge_beside_a_slanted_side_is_not_taken_for_one_that_cuts() {
        // The edge ends before a slanted side; vertices project on its inside.
        let core = Core::polygon(&[
            Vector::new(0.05, -0.055),
            Vector::new(0.30, 0.09),
            Vector::new(0.20, 0.095),
        ]);
        let obstacle = Obstacle::new(core.unwrap(), 0.0, Vector::zeros(), 0.0);
        let mut found = 0;
        obstacle.edge_clearances(Vector::zeros(), Vector::new(0.1, 0.0), |_| found += 1);
        assert_eq!(found, 0);
    }
}
