//! Obstacles from a scene, in the file's units.

use crate::geometry::{Core, Edge, Obstacle, Vector};
use crate::robot::{Robot, Sizes};
use crate::scene::{self, Candidates, Shape};
use crate::units::{metres, radians};

/// A point from the file's millimetres.
fn point([x, y]: [f64; 2]) -> Vector {
    Vector::new(metres(x), metres(y))
}

/// The obstacle of a shape. `None` for a polygon without area.
pub fn obstacle(shape: &Shape) -> Option<Obstacle> {
    let position = point(shape.anchor_mm());
    let angle = radians(shape.rotation_deg());
    let (core, radius_mm) = match shape {
        Shape::Disc { radius_mm, .. } => (Core::Point, *radius_mm),
        Shape::Wall {
            corner_radius_mm, ..
        } => (Core::HalfPlane, *corner_radius_mm),
        Shape::Box {
            size_mm,
            corner_radius_mm,
            ..
        } => (rounded_box(*size_mm, *corner_radius_mm), *corner_radius_mm),
        Shape::Capsule {
            length_mm,
            radius_mm,
            ..
        } => (Core::segment(metres(*length_mm)), *radius_mm),
        Shape::Polygon {
            points_mm,
            corner_radius_mm,
            ..
        } => {
            let local: Vec<Vector> = points_mm.iter().map(|p| point(*p) - position).collect();
            (Core::polygon(&local)?, *corner_radius_mm)
        }
    };
    Some(Obstacle::new(core, metres(radius_mm), position, angle))
}

/// What is left of a box inside its rounded corners: a smaller box, or a
/// segment or a point where the corners take the whole width.
fn rounded_box(size_mm: [f64; 2], corner_radius_mm: f64) -> Core {
    let [width, height] = size_mm.map(|side| metres(side - 2.0 * corner_radius_mm).max(0.0));
    match (width > 0.0, height > 0.0) {
        (true, true) => Core::rectangle(width, height),
        (true, false) => Core::segment(width),
        (false, true) => {
            let end = Vector::new(0.0, 0.5 * height);
            Core::Vertices(vec![-end, end])
        }
        (false, false) => Core::Point,
    }
}

/// Whether the obstacle overlaps what cannot move, the first disk, by more
/// than touching it. Listed nodes never include it.
pub fn covers_base(robot: &Robot, contact: &scene::Contact, obstacle: &Obstacle) -> bool {
    let base = robot.base;
    let (start, end, thickness) = match contact.candidates {
        Candidates::Listed => return false,
        Candidates::Nodes => (base.position, base.at(robot.offset), 0.0),
        Candidates::Body => {
            let Sizes { rim, disk, .. } = robot.sizes;
            (base.at(-rim), base.at(rim), 0.5 * disk)
        }
    };
    let touching = robot.touching();
    let least = thickness - touching;
    let mut covered = [start, end]
        .iter()
        .any(|point| obstacle.clearance(*point).distance < least);
    if contact.candidates == Candidates::Body {
        let depth = obstacle.crossing_depth(start, end);
        covered |= depth.is_some_and(|depth| depth - obstacle.radius() > touching);
        obstacle.edge_clearances(&Edge::alone(start, end), |clearance| {
            covered |= clearance.distance < least;
        });
    }
    covered
}
