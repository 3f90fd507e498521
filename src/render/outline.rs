//! Outlines of obstacles as corners with normals, for solids. Not the exact
//! paths that flat drawings use.

use super::mesh::Flat;
use crate::geometry::{Core, Obstacle, Vector, cross, perpendicular};
use crate::view::{Bounds, clip_half_plane};
use std::f64::consts::TAU;

/// The greatest turn between neighbouring corners of an arc.
const TURN: f64 = TAU / 72.0;
/// The least 1 + cos of a corner's turn that its bevel is mitred for: at sharper
/// corners, from 177°, the bevel would reach far inside.
const SHARPEST: f64 = 1e-3;

/// A corner of a convex outline. Where the outline has a kink there are two at
/// one place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Corner {
    /// Where, in metres from the mesh's origin.
    pub position: Flat,
    /// The outward unit normal.
    pub normal: Flat,
    /// The same corner of the outline shrunk by the bevel.
    pub inset: Flat,
}

/// The outline of what an area shows of an obstacle, counterclockwise and
/// relative to an origin, and the bevel it has room for, at most `bevel`. A
/// wall ends at the area's border and is a slab of this thickness. `None` where
/// the area shows nothing of the surface.
pub fn corners(
    obstacle: &Obstacle,
    area: &Bounds,
    origin: Vector,
    bevel: f64,
    thickness: f64,
) -> Option<(Vec<Corner>, f64)> {
    let (place, radius) = (obstacle.position(), obstacle.radius());
    let (sine, cosine) = obstacle.angle().sin_cos();
    let turned = |v: Vector| cosine * v + sine * perpendicular(v);
    let vertices: Vec<Vector> = match obstacle.core() {
        Core::HalfPlane => {
            let normal = Vector::new(cosine, sine);
            let point = place + radius * normal;
            let [a, b] = clip_half_plane(point, normal, &area.corners()).surface?;
            let slab = slab([a, b], normal, thickness);
            return Some(grown(&slab, 0.0, origin, bevel));
        }
        Core::Point => vec![place],
        Core::Vertices(local) => local.iter().map(|v| place + turned(*v)).collect(),
    };
    let extent = Bounds::of(vertices.iter().copied()).grown(radius);
    if extent.within(*area).is_empty() {
        return None;
    }
    Some(grown(&vertices, radius, origin, bevel))
}

/// What stands for a wall: its surface and the corners behind it,
/// counterclockwise.
fn slab([a, b]: [Vector; 2], normal: Vector, thickness: f64) -> [Vector; 4] {
    // Along the surface with the free side on the right.
    let (a, b) = if cross(b - a, normal) < 0.0 {
        (a, b)
    } else {
        (b, a)
    };
    let behind = -thickness * normal;
    [a, b, b + behind, a + behind]
}

/// A convex polygon, a segment or a point grown by a radius.
fn grown(vertices: &[Vector], radius: f64, origin: Vector, bevel: f64) -> (Vec<Corner>, f64) {
    let count = vertices.len();
    let normal = |i: usize| -> Vector {
        let along = vertices[(i + 1) % count] - vertices[i];
        // A point's outline starts anywhere.
        -perpendicular(along)
            .try_normalize(0.0)
            .unwrap_or(Vector::x())
    };
    let lengths = (0..count).map(|i| (vertices[(i + 1) % count] - vertices[i]).norm());
    let shortest = lengths.fold(f64::INFINITY, f64::min);
    let bevel = if radius > 0.0 {
        bevel.min(0.5 * radius)
    } else {
        bevel.min(0.1 * shortest)
    };
    let flat = |v: Vector| Flat::new(v.x as f32, v.y as f32);
    let mut corners = Vec::new();
    #[expect(clippy::needless_range_loop, reason = "neighbours are looked at too")]
    for i in 0..count {
        let (before, after) = (normal((i + count - 1) % count), normal(i));
        let vertex = vertices[i] - origin;
        let mut push = |normal: Vector, inset: Vector| {
            corners.push(Corner {
                position: flat(vertex + radius * normal),
                normal: flat(normal),
                inset: flat(vertex + inset),
            });
        };
        if radius > 0.0 {
            let turn = after.y.atan2(after.x) - before.y.atan2(before.x);
            let turn = if count == 1 {
                TAU
            } else {
                turn.rem_euclid(TAU)
            };
            let steps = (turn / TURN).ceil().max(1.0);
            // A circle's last corner is its first.
            let last = if count == 1 { steps - 1.0 } else { steps };
            for step in 0..=last as usize {
                let (sine, cosine) = (turn * step as f64 / steps).sin_cos();
                let normal = cosine * before + sine * perpendicular(before);
                push(normal, (radius - bevel) * normal);
            }
        } else {
            let mitre = (before + after) / (1.0 + before.dot(&after)).max(SHARPEST);
            push(before, -bevel * mitre);
            push(after, -bevel * mitre);
        }
    }
    (corners, bevel)
}
