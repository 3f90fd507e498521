//! A polygon's vertices, as they are drawn, and edits that keep it convex. In
//! millimetres.

use super::{Turned, written};
use crate::geometry::{Core, Vector, cross};
use crate::scene::Shape;
use crate::scene::limits::{VERTEX_SPACING_MM, VERTICES};

/// A hull whose area, doubled, is below this share of its extent squared is a
/// line: it would enclose next to nothing, and its edges would have no side.
const FLAT: f64 = 1e-6;
/// Lines whose directions differ by an angle of a smaller sine are parallel:
/// where they meet, coordinates of 1e3 mm would have lost all their digits.
const PARALLEL: f64 = 1e-9;
/// What is meant by on a line, in mm: within rounding of coordinates to 1e6 mm.
const ON_LINE_MM: f64 = 1e-9;

/// The vertices of a polygon where they are drawn, its turn applied; none of
/// any other shape.
pub fn vertices(shape: &Shape) -> Vec<Vector> {
    let Shape::Polygon {
        points_mm,
        rotation_deg,
        ..
    } = shape
    else {
        return Vec::new();
    };
    let anchor = Vector::from(shape.anchor_mm());
    let turn = Turned::by(*rotation_deg);
    let points = points_mm.iter().map(|p| Vector::from(*p));
    points.map(|p| anchor + turn.out(p - anchor)).collect()
}

/// Gives a polygon the vertices that it is to be drawn with. Its turn stays,
/// which is about their mean.
fn as_drawn(shape: &mut Shape, drawn: &[Vector]) {
    let Shape::Polygon {
        points_mm,
        rotation_deg,
        ..
    } = shape
    else {
        return;
    };
    if *rotation_deg == 0.0 {
        *points_mm = drawn.iter().map(|p| written(*p)).collect();
        return;
    }
    let mean = drawn.iter().sum::<Vector>() / drawn.len() as f64;
    let turn = Turned::by(*rotation_deg);
    // Not rounded: the mean would move, and with it every vertex.
    let unturned = drawn.iter().map(|p| mean + turn.into_frame(p - mean));
    *points_mm = unturned.map(Into::into).collect();
}

/// Moves a vertex to the place nearest to `to` where the polygon stays convex,
/// at least `margin` outside of the line between its neighbours.
pub fn move_vertex(shape: &mut Shape, index: usize, to: Vector, margin: f64) {
    let mut points = vertices(shape);
    let count = points.len();
    if count < 3 || index >= count {
        return;
    }
    let at = |by: usize| points[(index + by) % count];
    let (next, beyond_next) = (at(1), at(2));
    let (before, beyond_before) = (at(count - 1), at(count - 2));
    let way = area(&points).signum();
    let margin = margin.max(2.0 * VERTEX_SPACING_MM);
    // Right of the line past it, left of those that lead to its neighbours,
    // counterclockwise.
    let bounds = [
        Side::left_of(next, before, way, margin),
        Side::left_of(beyond_before, before, way, 0.0),
        Side::left_of(next, beyond_next, way, 0.0),
    ];
    if let Some(place) = nearest_within(&bounds, to) {
        points[index] = place;
        as_drawn(shape, &points);
    }
}

/// The polygon with one more vertex where a point is nearest to its edges, and
/// that vertex's index. `None` for other shapes and full polygons.
pub fn add_vertex(shape: &Shape, near: Vector) -> Option<(Shape, usize)> {
    let mut points = vertices(shape);
    if points.len() >= VERTICES {
        return None;
    }
    let (edge, place, _) = edge_near(&points, near)?;
    let count = points.len();
    let apart = |p: Vector| (p - place).norm() > 2.0 * VERTEX_SPACING_MM;
    if !apart(points[edge]) || !apart(points[(edge + 1) % count]) {
        return None;
    }
    points.insert(edge + 1, place);
    let mut more = shape.clone();
    as_drawn(&mut more, &points);
    Some((more, edge + 1))
}

/// The polygon without a vertex. `None` for other shapes and triangles.
pub fn remove_vertex(shape: &Shape, index: usize) -> Option<Shape> {
    let mut points = vertices(shape);
    if points.len() <= 3 || index >= points.len() {
        return None;
    }
    points.remove(index);
    let mut fewer = shape.clone();
    as_drawn(&mut fewer, &points);
    Some(fewer)
}

/// The edge of an outline that is nearest to a point, by its first vertex, the
/// nearest point on it and its distance.
pub fn edge_near(points: &[Vector], to: Vector) -> Option<(usize, Vector, f64)> {
    let count = points.len();
    let edges = (0..count).map(|i| {
        let (a, b) = (points[i], points[(i + 1) % count]);
        let along = b - a;
        let share = (to - a).dot(&along) / along.norm_squared();
        let place = a + share.clamp(0.0, 1.0) * along;
        (i, place, (to - place).norm())
    });
    edges.min_by(|a, b| a.2.total_cmp(&b.2))
}

/// What became of some points when a convex polygon was made of them.
#[derive(Clone, Debug, PartialEq)]
pub struct Convex {
    /// Its vertices.
    pub points: Vec<Vector>,
    /// How many of the points, those in one place aside, lie inside of it.
    pub left_out: usize,
}

/// The convex polygon of points: they themselves where they go round one, or
/// else their hull. `None` where they enclose nothing.
pub fn convex(points: &[Vector]) -> Option<Convex> {
    let mut distinct: Vec<Vector> = Vec::new();
    for point in points {
        let far = |other: &Vector| (point - other).norm() > 10.0 * VERTEX_SPACING_MM;
        if distinct.iter().all(far) {
            distinct.push(*point);
        }
    }
    if distinct.len() < 3 {
        return None;
    }
    let mut hull = match Core::polygon(&distinct)? {
        Core::Vertices(hull) => hull,
        _ => return None,
    };
    hull.truncate(VERTICES);
    // Hulls of points almost on a line enclose next to nothing.
    let extent = hull
        .iter()
        .map(|p| (p - hull[0]).norm())
        .fold(0.0, f64::max);
    (area(&hull) > FLAT * extent * extent).then(|| Convex {
        left_out: distinct.len() - hull.len(),
        points: hull,
    })
}

/// Twice the area, positive counterclockwise.
fn area(points: &[Vector]) -> f64 {
    let next = points.iter().cycle().skip(1);
    points.iter().zip(next).map(|(a, b)| cross(*a, *b)).sum()
}

/// The points p with n·p ≥ c, n a unit vector.
#[derive(Clone, Copy, Debug)]
struct Side {
    normal: Vector,
    least: f64,
}

impl Side {
    /// What lies at least `margin` left of the line from `a` to `b`, or right
    /// of it where `way` is −1.
    fn left_of(a: Vector, b: Vector, way: f64, margin: f64) -> Self {
        let along = (b - a).normalize();
        let normal = way * Vector::new(-along.y, along.x);
        Self {
            normal,
            least: normal.dot(&a) + margin,
        }
    }

    fn depth(&self, point: Vector) -> f64 {
        self.normal.dot(&point) - self.least
    }
}

/// The point nearest to `to` that is on all three sides. `None` where there is
/// none.
fn nearest_within(sides: &[Side; 3], to: Vector) -> Option<Vector> {
    if sides.iter().all(|side| side.depth(to) >= 0.0) {
        return Some(to);
    }
    // It is on one line or where two meet.
    let mut places: Vec<Vector> = Vec::new();
    for (i, a) in sides.iter().enumerate() {
        places.push(to - a.depth(to) * a.normal);
        for b in &sides[i + 1..] {
            let determinant = cross(a.normal, b.normal);
            if determinant.abs() > PARALLEL {
                places.push(Vector::new(
                    (a.least * b.normal.y - b.least * a.normal.y) / determinant,
                    (b.least * a.normal.x - a.least * b.normal.x) / determinant,
                ));
            }
        }
    }
    let within = |place: &Vector| sides.iter().all(|side| side.depth(*place) >= -ON_LINE_MM);
    let mut good = places
        .into_iter()
        .filter(|p| p.x.is_finite() && p.y.is_finite());
    let first = good.find(|p| within(p))?;
    let nearer = |best: Vector, p: Vector| {
        if within(&p) && (p - to).norm() < (best - to).norm() {
            p
        } else {
            best
        }
    };
    Some(good.fold(first, nearer))
}
