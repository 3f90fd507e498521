//! An obstacle: a core, a radius, a pose, and what is derived from them for
//! the hot loops. It answers no questions about clearance itself.

use super::{Vector, from_parry, perpendicular, to_parry};
use parry2d_f64::math::Pose;
use parry2d_f64::transformation::convex_hull;
use serde::de::Error;
use serde::{Deserialize, Deserializer, Serialize, Serializer};
use std::ops::Range;

/// How many vertices a core has: contacts name one in a byte.
const VERTICES: Range<usize> = 2..255;

/// A convex set in an obstacle's own frame.
#[derive(Debug, PartialEq, Serialize, Deserialize)]
pub enum Core {
    /// The frame's origin.
    Point,
    /// A polygon's vertices counterclockwise; two make a segment.
    Vertices(Vec<Vector>),
    /// All points with x ≤ 0.
    HalfPlane,
}

/// A convex obstacle at a place.
///
/// Clone with `clone_from` where one exists already: it reuses the storage.
#[derive(Debug)]
pub struct Obstacle {
    pub(super) core: Core,
    pub(super) radius: f64,
    pub(super) pose: Pose,
    angle: f64,
    /// The core's vertices in the world; one for a point, none for a
    /// half-plane.
    pub(super) vertices: Vec<Vector>,
    /// Outward normal of the edge from each vertex to the next, in the world.
    pub(super) normals: Vec<Vector>,
    /// Radius of a circle about the pose's origin that holds the outline.
    pub(super) reach: f64,
}

impl Clone for Core {
    fn clone(&self) -> Self {
        match self {
            Core::Point => Core::Point,
            Core::Vertices(vertices) => Core::Vertices(vertices.clone()),
            Core::HalfPlane => Core::HalfPlane,
        }
    }

    fn clone_from(&mut self, source: &Self) {
        match (self, source) {
            (Core::Vertices(to), Core::Vertices(from)) => to.clone_from(from),
            (to, from) => *to = from.clone(),
        }
    }
}

impl Clone for Obstacle {
    fn clone(&self) -> Self {
        Self {
            core: self.core.clone(),
            vertices: self.vertices.clone(),
            normals: self.normals.clone(),
            ..*self
        }
    }

    fn clone_from(&mut self, source: &Self) {
        self.core.clone_from(&source.core);
        self.radius = source.radius;
        self.pose = source.pose;
        self.angle = source.angle;
        self.vertices.clone_from(&source.vertices);
        self.normals.clone_from(&source.normals);
        self.reach = source.reach;
    }
}

/// What an obstacle is made of.
#[derive(Serialize, Deserialize)]
struct Parts {
    core: Core,
    radius: f64,
    position: Vector,
    angle: f64,
}

impl Serialize for Obstacle {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let parts = Parts {
            core: self.core.clone(),
            radius: self.radius,
            position: self.position(),
            angle: self.angle,
        };
        parts.serialize(serializer)
    }
}

impl<'de> Deserialize<'de> for Obstacle {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let parts = Parts::deserialize(deserializer)?;
        if let Core::Vertices(vertices) = &parts.core
            && !VERTICES.contains(&vertices.len())
        {
            return Err(D::Error::custom("a core of too few or too many vertices"));
        }
        Ok(Self::new(
            parts.core,
            parts.radius,
            parts.position,
            parts.angle,
        ))
    }
}

impl Obstacle {
    /// An obstacle from its core, the radius the core is grown by, and its
    /// frame's position and counterclockwise angle.
    ///
    /// # Panics
    /// If a core of vertices has fewer than two or more than 254: a bug of the
    /// caller, who makes them with [`Core::polygon`] or [`Core::segment`].
    pub fn new(core: Core, radius: f64, position: Vector, angle: f64) -> Self {
        if let Core::Vertices(vertices) = &core {
            let count = vertices.len();
            assert!(VERTICES.contains(&count), "a core of {count} vertices");
        }
        let mut obstacle = Self {
            core,
            radius,
            pose: Pose::new(to_parry(position), angle),
            angle,
            vertices: Vec::new(),
            normals: Vec::new(),
            reach: 0.0,
        };
        obstacle.refresh();
        obstacle
    }

    /// The frame's origin in the world.
    pub fn position(&self) -> Vector {
        from_parry(self.pose.translation)
    }

    /// The frame's counterclockwise angle.
    pub fn angle(&self) -> f64 {
        self.angle
    }

    /// The radius the core is grown by.
    pub fn radius(&self) -> f64 {
        self.radius
    }

    /// The core in the obstacle's own frame.
    pub fn core(&self) -> &Core {
        &self.core
    }

    /// Whether another obstacle has a core of the same kind and as many
    /// vertices, so that one can be moved into the other.
    pub fn resembles(&self, other: &Self) -> bool {
        match (&self.core, &other.core) {
            (Core::Vertices(a), Core::Vertices(b)) => a.len() == b.len(),
            (a, b) => std::mem::discriminant(a) == std::mem::discriminant(b),
        }
    }

    /// Becomes the obstacle a share `t` in \[0, 1\] of the way from `a` to
    /// `b`, which must resemble each other and this one. Allocates nothing.
    pub fn set_between(&mut self, a: &Self, b: &Self, t: f64) {
        // Exact at both ends.
        self.radius = (1.0 - t) * a.radius + t * b.radius;
        self.angle = if t < 1.0 {
            a.angle + t * a.turn_to(b)
        } else {
            b.angle
        };
        let position = (1.0 - t) * a.position() + t * b.position();
        self.pose = Pose::new(to_parry(position), self.angle);
        if let (Core::Vertices(to), Core::Vertices(a), Core::Vertices(b)) =
            (&mut self.core, &a.core, &b.core)
        {
            for ((to, a), b) in to.iter_mut().zip(a).zip(b) {
                *to = (1.0 - t) * a + t * b;
            }
        }
        self.refresh();
    }

    /// The turn to another obstacle's angle the short way, in \[−π, π\].
    fn turn_to(&self, other: &Self) -> f64 {
        let turn = other.angle - self.angle;
        turn - std::f64::consts::TAU * (turn / std::f64::consts::TAU).round()
    }

    /// An upper bound of how far any point of the outline is from its place in
    /// `other`, which resembles this one; for a half-plane, of any point within
    /// a metre of its frame.
    pub fn change(&self, other: &Self) -> f64 {
        let reach = match (&self.core, &other.core) {
            (Core::HalfPlane, _) => 1.0,
            _ => self.reach.max(other.reach),
        };
        let mut vertices = 0.0_f64;
        if let (Core::Vertices(a), Core::Vertices(b)) = (&self.core, &other.core) {
            let moved = a.iter().zip(b).map(|(a, b)| (a - b).norm());
            vertices = moved.fold(0.0, f64::max);
        }
        (self.position() - other.position()).norm()
            + (self.radius - other.radius).abs()
            + self.turn_to(other).abs() * reach
            + vertices
    }

    /// The obstacle shrunk towards a point of the world to a share `scale` of
    /// its size. Half-planes are moved along their normal so that their
    /// surface keeps that share of its distance from the point.
    pub fn shrunk(&self, towards: Vector, scale: f64) -> Self {
        let mut shrunk = self.clone();
        let position = towards + scale * (self.position() - towards);
        shrunk.radius *= scale;
        shrunk.pose = Pose::new(to_parry(position), self.angle);
        if let Core::Vertices(vertices) = &mut shrunk.core {
            vertices.iter_mut().for_each(|vertex| *vertex *= scale);
        }
        shrunk.refresh();
        shrunk
    }

    /// The obstacle moved by a vector.
    pub fn moved(&self, by: Vector) -> Self {
        Self::new(
            self.core.clone(),
            self.radius,
            self.position() + by,
            self.angle,
        )
    }

    /// The greatest extent of the outline along a unit direction: max d·x.
    /// `None` for a half-plane, unless the direction is its normal.
    pub fn support(&self, direction: Vector) -> Option<f64> {
        match self.core {
            Core::HalfPlane => {
                let normal = self.wall_normal();
                (direction.dot(&normal) > 1.0 - 1e-12)
                    .then(|| normal.dot(&self.position()) + self.radius)
            }
            _ => self
                .vertices
                .iter()
                .map(|vertex| direction.dot(vertex) + self.radius)
                .reduce(f64::max),
        }
    }

    /// Half of the outline's least width. Infinite for a half-plane.
    pub fn half_width(&self) -> f64 {
        if matches!(self.core, Core::HalfPlane) {
            return f64::INFINITY;
        }
        // A convex polygon is narrowest across one of its edges.
        let across = self.normals.iter().map(|normal| {
            let heights = self.vertices.iter().map(|vertex| normal.dot(vertex));
            let (low, high) = heights.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), h| {
                (low.min(h), high.max(h))
            });
            high - low
        });
        let core = across.reduce(f64::min).unwrap_or(0.0);
        0.5 * core + self.radius
    }

    /// A half-plane's outward normal.
    pub(super) fn wall_normal(&self) -> Vector {
        from_parry(
            self.pose
                .rotation
                .transform_vector(parry2d_f64::math::Vector::X),
        )
    }

    /// A point of the world in the obstacle's own frame.
    pub(super) fn to_local(&self, point: Vector) -> Vector {
        from_parry(self.pose.inverse_transform_point(to_parry(point)))
    }

    /// A point of the obstacle's own frame in the world.
    pub(super) fn to_world(&self, point: Vector) -> Vector {
        from_parry(self.pose.transform_point(to_parry(point)))
    }

    /// Recomputes what is derived.
    fn refresh(&mut self) {
        self.vertices.clear();
        self.normals.clear();
        self.reach = match &self.core {
            Core::HalfPlane => f64::INFINITY,
            Core::Point => {
                self.vertices.push(from_parry(self.pose.translation));
                self.radius
            }
            Core::Vertices(local) => {
                let pose = self.pose;
                let world = |v: &Vector| from_parry(pose.transform_point(to_parry(*v)));
                self.vertices.extend(local.iter().map(world));
                for (i, a) in self.vertices.iter().enumerate() {
                    let b = self.vertices[(i + 1) % self.vertices.len()];
                    self.normals.push(-perpendicular(b - a).normalize());
                }
                let farthest = local.iter().map(|v| v.norm()).fold(0.0, f64::max);
                farthest + self.radius
            }
        };
    }
}

impl Core {
    /// A segment of a length along x, centred on the origin.
    pub fn segment(length: f64) -> Self {
        let end = Vector::new(0.5 * length, 0.0);
        Core::Vertices(vec![-end, end])
    }

    /// A rectangle centred on the origin.
    pub fn rectangle(width: f64, height: f64) -> Self {
        let (x, y) = (0.5 * width, 0.5 * height);
        Core::Vertices(vec![
            Vector::new(-x, -y),
            Vector::new(x, -y),
            Vector::new(x, y),
            Vector::new(-x, y),
        ])
    }

    /// The convex hull of points, counterclockwise. `None` where they span no
    /// area.
    pub fn polygon(points: &[Vector]) -> Option<Self> {
        let points: Vec<_> = points.iter().copied().map(to_parry).collect();
        let hull: Vec<Vector> = convex_hull(&points).into_iter().map(from_parry).collect();
        let twice_area: f64 = hull
            .iter()
            .zip(hull.iter().cycle().skip(1))
            .map(|(a, b)| super::cross(*a, *b))
            .sum();
        (hull.len() >= 3 && twice_area > 0.0).then_some(Core::Vertices(hull))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shrinking_keeps_the_point_and_nests() {
        let core = Core::rectangle(0.2, 0.1);
        let obstacle = Obstacle::new(core, 0.01, Vector::new(0.3, 0.2), 0.4);
        let towards = Vector::new(0.0, 0.1);
        let half = obstacle.shrunk(towards, 0.5);
        for direction in [Vector::x(), Vector::y(), Vector::new(-0.6, 0.8)] {
            let full = obstacle.support(direction).unwrap() - direction.dot(&towards);
            let shrunk = half.support(direction).unwrap() - direction.dot(&towards);
            assert!((shrunk - 0.5 * full).abs() < 1e-15);
        }
    }

    #[test]
    fn a_change_bounds_how_far_the_outline_moves() {
        let a = Obstacle::new(Core::segment(0.1), 0.01, Vector::new(0.1, 0.2), 0.2);
        let b = Obstacle::new(Core::segment(0.14), 0.02, Vector::new(0.11, 0.18), 1.7);
        // The ends of the capsules, in their own frames (0.05, 0) and (0.07, 0).
        let end = |half: f64, angle: f64| half * Vector::new(libm::cos(angle), libm::sin(angle));
        let moved = a.position() + end(0.06, 0.2) - b.position() - end(0.09, 1.7);
        assert!(a.change(&b) >= moved.norm());
        // A turn of almost a whole circle is a small one the other way.
        let c = Obstacle::new(Core::segment(0.1), 0.01, Vector::zeros(), 3.1);
        let d = Obstacle::new(Core::segment(0.1), 0.01, Vector::zeros(), -3.1);
        assert!(c.change(&d) < 0.1 * 0.06);
    }

    #[test]
    fn between_its_ends_an_obstacle_is_its_ends() {
        let a = Obstacle::new(Core::segment(0.1), 0.01, Vector::new(0.1, 0.2), 0.0);
        let b = Obstacle::new(Core::segment(0.3), 0.03, Vector::new(0.2, 0.1), 1.0);
        let mut c = a.clone();
        c.set_between(&a, &b, 1.0);
        assert!((c.support(Vector::x()).unwrap() - b.support(Vector::x()).unwrap()).abs() < 1e-15);
        c.set_between(&a, &b, 0.0);
        assert!((c.support(Vector::y()).unwrap() - a.support(Vector::y()).unwrap()).abs() < 1e-15);
    }

    #[test]
    fn an_outline_is_as_wide_as_its_narrowest_place() {
        let check = |core, radius, expect: f64| {
            let obstacle = Obstacle::new(core, radius, Vector::new(0.1, 0.2), 0.3);
            let half = obstacle.half_width();
            assert!(half == expect || (half - expect).abs() < 1e-15, "{half}");
        };
        check(Core::Point, 0.012, 0.012);
        check(Core::segment(0.05), 0.004, 0.004);
        check(Core::rectangle(0.04, 0.02), 0.005, 0.015);
        check(Core::HalfPlane, 0.0, f64::INFINITY);
    }

    #[test]
    fn a_hull_without_area_is_no_polygon() {
        let line: Vec<Vector> = (0..4).map(|i| Vector::new(f64::from(i), 0.0)).collect();
        assert_eq!(Core::polygon(&line), None);
    }
}
