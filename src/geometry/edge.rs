//! Clearances of the robot's edges, its links and disks, from an obstacle, and
//! of the points in which edges end.
//!
//! An edge touches an obstacle either with one of its ends, which is a point's
//! clearance, or with its inside on a vertex of the obstacle's core, which is
//! what [`Obstacle::edge_clearances`] gives: one row a vertex.

use super::clearance::PointClearance;
use super::obstacle::Obstacle;
use super::{Vector, cross, perpendicular};

/// An edge of the robot, a link or a disk, and the points that it is joined to.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Edge {
    /// Where it starts.
    pub start: Vector,
    /// Where it ends.
    pub end: Vector,
    /// The far ends of the edges joined to its start and to its end, if any.
    pub joined: [Option<Vector>; 2],
}

/// How far beyond an end a vertex still counts as facing an edge, as a share of
/// the edge's length, where the next edge turns towards the obstacle. A vertex
/// that has slid into such a notch rests on both edges, at the very ends of
/// them; rounding, or the violation between two iterations, would have it face
/// neither. There, and only there, is nothing added by looking beyond the end:
/// what is clear of the next edge is clear of this one's line. It is also how
/// near a core's vertex, over an edge's length, a point is left to the edges that
/// end in it. A tenth is far more than an iteration violates a row by, and so
/// little that a vertex that near faces no other edge.
const NOTCH: f64 = 0.1;

/// The sine of the angle by which an edge may lead into a face and still lie
/// flat on it.
const GRAZING: f64 = 0.01;

/// On which side of an edge's line a core is.
struct EdgeSide {
    /// The unit normal of the edge that points away from the core.
    normal: Vector,
    /// The vertex farthest towards the edge.
    facing: usize,
    /// How far the edge's line is from that vertex; negative where it cuts the
    /// core.
    separation: f64,
}

impl Edge {
    /// An edge that is joined to nothing.
    pub fn alone(start: Vector, end: Vector) -> Self {
        let joined = [None; 2];
        Self { start, end, joined }
    }

    /// Whether the edges joined to its start and to its end turn towards what is
    /// on the side that `normal` points away from.
    fn notches(&self, normal: Vector) -> [bool; 2] {
        let towards = |joined: Option<Vector>, end: Vector| {
            joined.is_some_and(|joined| normal.dot(&(joined - end)) < 0.0)
        };
        let [before, after] = self.joined;
        [towards(before, self.start), towards(after, self.end)]
    }
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
    /// Where the vertex projects on the edge, from 0 at its start to 1; beyond
    /// them where an edge that is joined there turns towards the obstacle.
    pub along: f64,
}

impl Obstacle {
    /// Calls `each` for every core vertex that the inside of an edge faces, in
    /// the order of their indices: the one farthest towards the edge, and its
    /// neighbours.
    ///
    /// Calls it for none where an end is nearer: where the edge is beyond one
    /// of the core's own edges by more than it is beyond a vertex, unless the
    /// two cross and the end is itself clear of the core, whose clearance
    /// would tell nothing of the crossing. Of an edge that crosses the core the
    /// vertex farthest towards it counts wherever it is: the edge may have gone
    /// into a side while its end slipped round the corner.
    pub fn edge_clearances(&self, edge: &Edge, mut each: impl FnMut(EdgeClearance)) {
        let Some(side) = self.side(edge) else {
            return;
        };
        if side.separation < 0.0 && self.an_end_is_nearer(edge, &side) {
            return;
        }
        let notches = edge.notches(side.normal);
        let [below, above] = notches.map(|notch| if notch { NOTCH } else { 0.0 });
        let (least, most) = (-below, 1.0 + above);
        let crosses =
            || side.separation < 0.0 && self.crossing_depth(edge.start, edge.end).is_some();
        let count = self.vertices.len();
        let neighbours = [
            (side.facing + count - 1) % count,
            side.facing,
            (side.facing + 1) % count,
        ];
        for vertex in 0..count {
            if neighbours.contains(&vertex) {
                let clearance = self.beside(edge, side.normal, vertex);
                let faces = clearance.along > least && clearance.along < most;
                if faces || vertex == side.facing && crosses() {
                    each(clearance);
                }
            }
        }
    }

    /// The clearance of an edge from one core vertex, wherever along the edge's
    /// line that is. `None` for an edge without length or a vertex that is not
    /// there.
    pub fn edge_clearance(&self, edge: &Edge, vertex: usize) -> Option<EdgeClearance> {
        let side = self.side(edge)?;
        (vertex < self.vertices.len()).then(|| self.beside(edge, side.normal, vertex))
    }

    fn beside(&self, edge: &Edge, normal: Vector, vertex: usize) -> EdgeClearance {
        let along = edge.end - edge.start;
        let offset = self.vertices[vertex] - edge.start;
        EdgeClearance {
            vertex,
            distance: -normal.dot(&offset) - self.radius,
            normal,
            along: along.dot(&offset) / along.norm_squared(),
        }
    }

    /// On which side of the edge's line the core is, for the better part.
    #[inline]
    fn side(&self, edge: &Edge) -> Option<EdgeSide> {
        let start = edge.start;
        let count = self.vertices.len();
        let along = edge.end - start;
        let length = along.norm();
        if count == 0 || length <= 0.0 {
            return None;
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
        Some(EdgeSide {
            normal,
            facing,
            separation: -normal.dot(&(self.vertices[facing] - start)),
        })
    }

    /// The signed distance of an edge from the surface, in metres: to the nearest
    /// point of either; where they overlap, minus the shortest way out. Exact
    /// wherever the edge is, by no choice of vertices or sides.
    pub fn edge_distance(&self, start: Vector, end: Vector) -> f64 {
        if let Some(depth) = self.crossing_depth(start, end) {
            return -depth;
        }
        // Of two convex sets that do not overlap, one has a vertex nearest.
        let along = end - start;
        let from_edge = |vertex: &Vector| {
            let share = along.dot(&(vertex - start)) / along.norm_squared();
            (start + share.clamp(0.0, 1.0) * along - vertex).norm() - self.radius
        };
        let ends = [start, end].map(|end| self.clearance(end).distance);
        let vertices = self.vertices.iter().map(from_edge);
        vertices.fold(ends[0].min(ends[1]), f64::min)
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

    /// Whether an edge whose line cuts the core is nearer to it with one of its
    /// ends, and that end tells so. The bottom of a notch is no end: what is in
    /// the notch is for both its edges to tell.
    fn an_end_is_nearer(&self, edge: &Edge, side: &EdgeSide) -> bool {
        let mut nearest = (f64::NEG_INFINITY, 0);
        for (vertex, normal) in self.vertices.iter().zip(&self.normals) {
            let [first, last] = [edge.start, edge.end].map(|end| normal.dot(&(end - vertex)));
            let nearer = if first < last { (first, 0) } else { (last, 1) };
            if nearer.0 > nearest.0 {
                nearest = nearer;
            }
        }
        let (height, end) = nearest;
        if height <= side.separation {
            return false;
        }
        if height >= 0.0 {
            return !edge.notches(side.normal)[end];
        }
        let ends = [edge.start, edge.end];
        let neighbours = [Some(ends[1 - end]), edge.joined[end]];
        self.core_holds(ends[end]) && self.end_clearance(ends[end], neighbours).is_some()
    }

    /// The clearance of a point at which edges of the robot end that lead to
    /// `neighbours`; `None` where those edges are nearer for sure.
    ///
    /// It differs from that of a point by itself near a core's vertex, where a
    /// face that the point may be behind by rounding, or by the violation
    /// between two iterations, can be one that the edges run through. Such a
    /// face, or such a vertex, is for the edges to tell of.
    pub fn end_clearance(
        &self,
        point: Vector,
        neighbours: [Option<Vector>; 2],
    ) -> Option<PointClearance> {
        let clearance = self.clearance(point);
        if self.vertices.len() < 2 {
            return Some(clearance);
        }
        let edges = neighbours.map(|to| to.map(|to| to - point));
        let ends_here = |normal: Vector| {
            let runs_out = |edge: Vector| normal.dot(&edge) >= -GRAZING * edge.norm();
            edges.into_iter().flatten().all(runs_out)
        };
        if ends_here(clearance.normal) {
            return Some(clearance);
        }
        let longest = edges.into_iter().flatten().map(|edge| edge.norm());
        let near = NOTCH * longest.fold(0.0, f64::max);
        if self.vertices.len() > 2 && self.core_holds(point) {
            let faces = self.vertices.iter().zip(&self.normals).enumerate();
            let heights = faces
                .filter(|(_, (_, normal))| ends_here(**normal))
                .map(|(face, (vertex, normal))| (face, normal.dot(&(point - vertex))));
            if clearance.distance + self.radius < -near {
                return Some(clearance);
            }
            let highest = heights.max_by(|a, b| a.1.total_cmp(&b.1));
            let (face, height) = highest.filter(|(_, height)| *height > -near)?;
            return Some(self.near_edge(face, height));
        }
        let is_far = clearance.distance + self.radius > near;
        (clearance.curvature == 0.0 || is_far).then_some(clearance)
    }

    /// Whether a point is inside the core or on it.
    fn core_holds(&self, point: Vector) -> bool {
        let mut edges = self.vertices.iter().zip(&self.normals);
        edges.all(|(vertex, normal)| normal.dot(&(point - vertex)) <= 0.0)
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
    use crate::geometry::Core;
    use crate::geometry::clearance::tests::shapes;

    #[test]
    fn second_derivative_of_edges_against_finite_differences() {
        let h = 1e-4;
        let mut checked = 0;
        for obstacle in shapes() {
            for i in 0..200 {
                let angle = f64::from(i) * 0.37;
                let middle = Vector::new(0.03, 0.08)
                    + 0.035 * Vector::new(libm::cos(angle), libm::sin(angle));
                let turned = angle + 1.57 + 0.2 * libm::sin(f64::from(i) * 1.3);
                let half = 0.02 * Vector::new(libm::cos(turned), libm::sin(turned));
                let (start, end) = (middle - half, middle + half);
                let (ds, de) = (Vector::new(0.3, -0.2), Vector::new(-0.5, 0.4));
                let at = |t: f64| {
                    let mut found = Vec::new();
                    let edge = Edge::alone(start + t * ds, end + t * de);
                    obstacle.edge_clearances(&edge, |c| found.push(c));
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
    fn an_edge_beside_a_slanted_side_is_not_taken_for_one_that_cuts() {
        // The edge ends before a slanted side; vertices project on its inside.
        let core = Core::polygon(&[
            Vector::new(0.05, -0.055),
            Vector::new(0.30, 0.09),
            Vector::new(0.20, 0.095),
        ]);
        let obstacle = Obstacle::new(core.unwrap(), 0.0, Vector::zeros(), 0.0);
        let mut found = 0;
        let edge = Edge::alone(Vector::zeros(), Vector::new(0.1, 0.0));
        obstacle.edge_clearances(&edge, |_| found += 1);
        assert_eq!(found, 0);
    }
}
