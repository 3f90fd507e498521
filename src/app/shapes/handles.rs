//! Handles of the obstacles: where they are and what dragging them does to a
//! shape. In millimetres of the scene; knows no screen but the size of its
//! points.

mod vertices;

pub use vertices::{add_vertex, convex, edge_near, remove_vertex, vertices};

use crate::geometry::Vector;
use crate::scene::Shape;
use crate::scene::limits::{RADIUS, SIDE};
use eframe::egui::Modifiers;

/// Something of an obstacle to take hold of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Handle {
    /// A disc's rim: its radius. East, north, west and south, from 0.
    Rim(u8),
    /// A corner or a side of a box, by the signs of its place: its size.
    Side {
        /// −1 left, 1 right, 0 in the middle.
        x: i8,
        /// −1 below, 1 above, 0 in the middle.
        y: i8,
    },
    /// Inside a box's upper right corner: the corners' radius.
    Corner,
    /// A capsule's end, −1 or 1 along its axis: its length and its turn.
    End(i8),
    /// A capsule's flank, −1 or 1 across its axis: its radius.
    Flank(i8),
    /// The turn of a box, a polygon or a wall.
    Turn,
    /// A polygon's vertex.
    Vertex(usize),
}

/// Distance of the handle of a turn from the outline, in points.
const TURN_AWAY: f64 = 24.0;
/// The same for a wall, from its surface.
const WALL_AWAY: f64 = 44.0;
/// Distance of a corner's handle from the corner's circle, in points.
const CORNER_IN: f64 = 14.0;
/// A box needs half a side of so many points to show its corner's handle.
const CORNER_ROOM: f64 = 32.0;
/// Sides of so many points show handles in their middle.
const SIDE_ROOM: f64 = 44.0;
/// Nothing is dragged smaller than so many points.
const LEAST: f64 = 4.0;
/// What Shift makes a turn a multiple of, in degrees.
pub const SNAP_DEG: f64 = 15.0;
/// What a dragged turn is rounded to, in degrees.
const TURN_STEP_DEG: f64 = 0.1;
/// A turn by less is none, in degrees: what an angle of coordinates leaves by
/// rounding. So what is taken hold of and not moved stays what it was.
const NO_TURN_DEG: f64 = 1e-9;
/// Decimals of a length in mm, at most: a picometre, where a screen shows next
/// to nothing.
const MOST_DECIMALS: f64 = 9.0;
/// What coordinates are written in, over a millimetre: nanometres.
const WRITTEN_PER_MM: f64 = 1e6;

/// All handles of a shape with their places in mm, where a point of the screen
/// is `per_point` mm.
pub fn handles(shape: &Shape, per_point: f64) -> Vec<(Handle, Vector)> {
    let anchor = Vector::from(shape.anchor_mm());
    let turn = Turned::by(shape.rotation_deg());
    match shape {
        Shape::Disc { radius_mm, .. } => {
            let ways = [Vector::x(), Vector::y(), -Vector::x(), -Vector::y()];
            let rims = ways.iter().zip(0..);
            rims.map(|(way, i)| (Handle::Rim(i), anchor + *radius_mm * way))
                .collect()
        }
        Shape::Wall {
            corner_radius_mm, ..
        } => {
            let away = corner_radius_mm + WALL_AWAY * per_point;
            vec![(Handle::Turn, anchor + away * turn.x)]
        }
        Shape::Box {
            size_mm,
            corner_radius_mm,
            ..
        } => {
            let half = 0.5 * Vector::from(*size_mm);
            let at = |x: f64, y: f64| anchor + turn.out(Vector::new(x, y));
            let mut all = vec![(Handle::Turn, at(0.0, half.y + TURN_AWAY * per_point))];
            let room = |half: f64, points: f64| half > 0.5 * points * per_point;
            if room(half.min(), 2.0 * CORNER_ROOM) {
                let inward = corner_radius_mm + CORNER_IN * per_point;
                all.push((Handle::Corner, at(half.x - inward, half.y - inward)));
            }
            for (x, y) in [(0, 1), (0, -1), (1, 0), (-1, 0)] {
                let along = if x == 0 { half.x } else { half.y };
                if room(along, SIDE_ROOM) {
                    let place = at(f64::from(x) * half.x, f64::from(y) * half.y);
                    all.push((Handle::Side { x, y }, place));
                }
            }
            for (x, y) in [(1, 1), (-1, 1), (-1, -1), (1, -1)] {
                let place = at(f64::from(x) * half.x, f64::from(y) * half.y);
                all.push((Handle::Side { x, y }, place));
            }
            all
        }
        Shape::Capsule {
            length_mm,
            radius_mm,
            ..
        } => {
            let end = 0.5 * length_mm + radius_mm;
            let way = |sign: i8, by: f64, along: Vector| anchor + f64::from(sign) * by * along;
            vec![
                (Handle::Flank(1), way(1, *radius_mm, turn.y)),
                (Handle::Flank(-1), way(-1, *radius_mm, turn.y)),
                (Handle::End(1), way(1, end, turn.x)),
                (Handle::End(-1), way(-1, end, turn.x)),
            ]
        }
        Shape::Polygon {
            corner_radius_mm, ..
        } => {
            let points = vertices(shape);
            let up = points.iter().map(|p| turn.y.dot(&(p - anchor)));
            let reach = up.fold(0.0, f64::max) + corner_radius_mm + TURN_AWAY * per_point;
            let mut all = vec![(Handle::Turn, anchor + reach * turn.y)];
            let corners = points.iter().enumerate();
            all.extend(corners.map(|(i, point)| (Handle::Vertex(i), *point)));
            all
        }
    }
}

/// The shape with a handle dragged to a place in mm. Shift keeps a box's
/// proportions and makes turns multiples of [`SNAP_DEG`]; Alt resizes about
/// the middle. What a handle is not of stays as it is.
pub fn drag(
    shape: &Shape,
    handle: Handle,
    to: Vector,
    modifiers: Modifiers,
    per_point: f64,
) -> Shape {
    let mut dragged = shape.clone();
    let anchor = Vector::from(shape.anchor_mm());
    let turn = Turned::by(shape.rotation_deg());
    let least = LEAST * per_point;
    match (&mut dragged, handle) {
        (Shape::Disc { radius_mm, .. }, Handle::Rim(_)) => {
            let radius = (to - anchor).norm();
            *radius_mm = sized(radius, *radius_mm, least, RADIUS.min, per_point);
        }
        (Shape::Capsule { radius_mm, .. }, Handle::Flank(sign)) => {
            let radius = f64::from(sign) * turn.y.dot(&(to - anchor));
            *radius_mm = sized(radius, *radius_mm, least, RADIUS.min, per_point);
        }
        (
            Shape::Capsule {
                center_mm,
                length_mm,
                radius_mm,
                rotation_deg,
            },
            Handle::End(sign),
        ) => {
            let sign = f64::from(sign);
            // The other end stays or, with Alt, mirrors this one.
            let (fixed, share) = if modifiers.alt {
                (anchor, 2.0)
            } else {
                (anchor - sign * 0.5 * *length_mm * turn.x, 1.0)
            };
            let Some(angle) = direction_deg(sign * (to - fixed)) else {
                return dragged;
            };
            let length = share * ((to - fixed).norm() - *radius_mm);
            *length_mm = sized(length, *length_mm, least, SIDE.min, per_point);
            *rotation_deg = turned(*rotation_deg, angle, modifiers);
            if !modifiers.alt {
                let axis = Turned::by(*rotation_deg).x;
                *center_mm = written(fixed + sign * 0.5 * *length_mm * axis);
            }
        }
        (Shape::Box { .. }, Handle::Side { x, y }) => {
            resize_box(&mut dragged, [x, y], to, modifiers, per_point);
        }
        (
            Shape::Box {
                size_mm,
                corner_radius_mm,
                ..
            },
            Handle::Corner,
        ) => {
            let half = 0.5 * Vector::from(*size_mm);
            // Along the diagonal that the handle moves on.
            let inward = (half - turn.into_frame(to - anchor)).sum() / 2.0;
            let radius = neat(inward - CORNER_IN * per_point, per_point);
            *corner_radius_mm = radius.clamp(0.0, half.min());
        }
        (Shape::Box { rotation_deg, .. } | Shape::Polygon { rotation_deg, .. }, Handle::Turn) => {
            // The handle is above the middle.
            if let Some(angle) = direction_deg(to - anchor) {
                *rotation_deg = turned(*rotation_deg, angle - 90.0, modifiers);
            }
        }
        (Shape::Wall { rotation_deg, .. }, Handle::Turn) => {
            if let Some(angle) = direction_deg(to - anchor) {
                *rotation_deg = turned(*rotation_deg, angle, modifiers);
            }
        }
        (Shape::Polygon { .. }, Handle::Vertex(index)) => {
            let to = to.map(|x| neat(x, per_point));
            vertices::move_vertex(&mut dragged, index, to, 0.25 * least);
        }
        _ => {}
    }
    dragged
}

/// The shape moved by a vector in mm. A wall moves along its normal: along its
/// surface it would not change. Shift keeps to the axis that is moved along
/// most.
pub fn moved(shape: &Shape, by: Vector, modifiers: Modifiers, per_point: f64) -> Shape {
    let mut moved = shape.clone();
    let from = Vector::from(shape.anchor_mm());
    let by = match shape {
        Shape::Wall { rotation_deg, .. } => {
            let normal = Turned::by(*rotation_deg).x;
            moved.move_to_mm(written(from + neat(normal.dot(&by), per_point) * normal));
            return moved;
        }
        _ if modifiers.shift && by.x.abs() >= by.y.abs() => Vector::new(by.x, 0.0),
        _ if modifiers.shift => Vector::new(0.0, by.y),
        _ => by,
    };
    let mut to = from + by;
    for axis in 0..2 {
        // What is not moved is not rounded either.
        if by[axis] != 0.0 {
            to[axis] = neat(to[axis], per_point);
        }
    }
    moved.move_to_mm(to.into());
    moved
}

/// A length in mm rounded to about a tenth of what a point of the screen
/// shows, in decimal.
pub fn neat(value: f64, per_point: f64) -> f64 {
    let decimals = (1.0 - per_point.log10()).ceil().clamp(0.0, MOST_DECIMALS);
    rounded(value, 10f64.powi(decimals as i32))
}

/// A point in mm as it is written to a scene: to the nanometre, so that files
/// stay readable.
pub fn written(point: Vector) -> [f64; 2] {
    point.map(|x| rounded(x, WRITTEN_PER_MM)).into()
}

fn rounded(value: f64, per_one: f64) -> f64 {
    (value * per_one).round() / per_one
}

/// A dragged size: rounded, and no less than `least` unless it was already.
fn sized(value: f64, was: f64, least: f64, limit: f64, per_point: f64) -> f64 {
    neat(value.max(least.min(was)), per_point).max(limit)
}

fn resize_box(shape: &mut Shape, signs: [i8; 2], to: Vector, modifiers: Modifiers, per_point: f64) {
    let Shape::Box {
        center_mm,
        size_mm,
        rotation_deg,
        corner_radius_mm,
    } = shape
    else {
        return;
    };
    let turn = Turned::by(*rotation_deg);
    let centre = Vector::from(*center_mm);
    let signs = signs.map(f64::from);
    let was = *size_mm;
    let local = turn.into_frame(to - centre);
    let reach = |axis: usize| {
        let out = signs[axis] * local[axis];
        let size = if modifiers.alt {
            2.0 * out
        } else {
            out + 0.5 * was[axis]
        };
        sized(size, was[axis], LEAST * per_point, SIDE.min, per_point)
    };
    for axis in 0..2 {
        if signs[axis] != 0.0 {
            size_mm[axis] = reach(axis);
        }
    }
    if modifiers.shift {
        let moved = (0..2).filter(|axis| signs[*axis] != 0.0);
        let factor = moved.map(|axis| size_mm[axis] / was[axis]);
        let factor = factor.fold(0.0, f64::max);
        for axis in 0..2 {
            size_mm[axis] = neat(factor * was[axis], per_point).max(SIDE.min);
        }
    }
    *corner_radius_mm = corner_radius_mm.min(0.5 * size_mm[0].min(size_mm[1]));
    if !modifiers.alt {
        // The opposite side stays.
        let by = |axis: usize| signs[axis] * 0.5 * (size_mm[axis] - was[axis]);
        let shift = Vector::new(by(0), by(1));
        if shift != Vector::zeros() {
            *center_mm = written(centre + turn.out(shift));
        }
    }
}

/// A turn in degrees after one to `angle`: to a tenth of a degree or, with
/// Shift, a multiple of [`SNAP_DEG`]; within half a turn once it changes.
fn turned(was: f64, angle: f64, modifiers: Modifiers) -> f64 {
    let turn = angle - was;
    let turn = turn - 360.0 * (turn / 360.0).round();
    if turn.abs() < NO_TURN_DEG && !modifiers.shift {
        return was;
    }
    let angle = was + turn;
    let angle = if modifiers.shift {
        SNAP_DEG * (angle / SNAP_DEG).round()
    } else {
        rounded(angle, 1.0 / TURN_STEP_DEG)
    };
    let half_turns = angle - 360.0 * (angle / 360.0).round();
    if half_turns <= -180.0 {
        180.0
    } else {
        half_turns
    }
}

/// The direction of a vector in degrees from +x; `None` where it has none.
fn direction_deg(vector: Vector) -> Option<f64> {
    (vector.norm() > 1e-12).then(|| vector.y.atan2(vector.x).to_degrees())
}

/// The axes of a turned frame.
#[derive(Clone, Copy, Debug)]
pub struct Turned {
    /// Its x axis.
    pub x: Vector,
    /// Its y axis.
    pub y: Vector,
}

impl Turned {
    /// The frame turned counterclockwise by degrees.
    pub fn by(degrees: f64) -> Self {
        let (sine, cosine) = crate::units::radians(degrees).sin_cos();
        Self {
            x: Vector::new(cosine, sine),
            y: Vector::new(-sine, cosine),
        }
    }

    /// A vector of the frame in the world.
    pub fn out(&self, local: Vector) -> Vector {
        local.x * self.x + local.y * self.y
    }

    /// A vector of the world in the frame.
    pub fn into_frame(self, vector: Vector) -> Vector {
        Vector::new(self.x.dot(&vector), self.y.dot(&vector))
    }
}

#[cfg(test)]
mod tests;
