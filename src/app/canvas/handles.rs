//! The handles of the selected obstacle.

use super::hit::{Reach, per_point};
use crate::app::look::Tokens;
use crate::app::paint::to_screen;
use crate::app::shapes::{Handle, Turned, handles, vertices};
use crate::geometry::Vector;
use crate::scene::Shape as Outline;
use crate::units::METRES_PER_MM;
use crate::view::Frame;
use eframe::egui::{Color32, Painter, Pos2, Rect, Shape, Stroke, StrokeKind, Vec2, vec2};

/// Paints the handles of a shape, the one under the pointer and the selected
/// vertex filled.
pub fn paint(
    painter: &Painter,
    shape: &Outline,
    frame: &Frame,
    (under, vertex): (Option<Handle>, Option<usize>),
    reach: Reach,
    tokens: &Tokens,
) {
    // As large as half of what the pointer reaches.
    let size = 0.5 * reach.handle as f32;
    let stroke = Stroke::new(1.5, tokens.accent);
    for (handle, at) in handles(shape, per_point(frame)) {
        let at = to_screen(frame, METRES_PER_MM * at);
        if !at.is_finite() {
            continue;
        }
        let full = under == Some(handle) || vertex.is_some_and(|v| handle == Handle::Vertex(v));
        let fill = if full { tokens.accent } else { tokens.canvas };
        match handle {
            Handle::Turn => {
                let from = to_screen(frame, METRES_PER_MM * stem(shape));
                painter.line_segment([from, at], Stroke::new(1.0, tokens.accent));
                painter.circle(at, size + 1.0, fill, stroke);
                turn_mark(
                    painter,
                    at,
                    0.55 * size,
                    if full { tokens.canvas } else { tokens.accent },
                );
            }
            Handle::Side { .. } => {
                let half = 0.85 * size;
                square(painter, at, half, turn_of(shape), fill, stroke);
            }
            Handle::Corner => {
                painter.circle(at, 0.7 * size, fill, stroke);
            }
            Handle::Rim(_) | Handle::End(_) | Handle::Flank(_) | Handle::Vertex(_) => {
                painter.circle(at, size, fill, stroke);
            }
        }
    }
}

/// The turn of a shape as screens have it, clockwise, in radians.
fn turn_of(shape: &Outline) -> f32 {
    -(crate::units::radians(shape.rotation_deg()) as f32)
}

/// Where the line to the handle of a turn begins, in mm.
fn stem(shape: &Outline) -> Vector {
    let anchor = Vector::from(shape.anchor_mm());
    let turn = Turned::by(shape.rotation_deg());
    match shape {
        Outline::Box { size_mm, .. } => anchor + 0.5 * size_mm[1] * turn.y,
        Outline::Wall {
            corner_radius_mm, ..
        } => anchor + *corner_radius_mm * turn.x,
        _ => {
            // Where the line leaves the outline.
            let points = vertices(shape);
            let next = points.iter().cycle().skip(1);
            let crossings = points.iter().zip(next).filter_map(|(a, b)| {
                let (left, right) = (turn.x.dot(&(a - anchor)), turn.x.dot(&(b - anchor)));
                let share = left / (left - right);
                let at = a + share * (b - a);
                (0.0..=1.0)
                    .contains(&share)
                    .then(|| turn.y.dot(&(at - anchor)))
            });
            anchor + crossings.fold(0.0, f64::max) * turn.y
        }
    }
}

fn square(painter: &Painter, at: Pos2, half: f32, turn: f32, fill: Color32, stroke: Stroke) {
    if turn == 0.0 {
        let area = Rect::from_center_size(at, Vec2::splat(2.0 * half));
        painter.rect(area, 1.5, fill, stroke, StrokeKind::Middle);
        return;
    }
    let (sine, cosine) = turn.sin_cos();
    let corner = |x: f32, y: f32| at + vec2(cosine * x - sine * y, sine * x + cosine * y);
    let corners = vec![
        corner(half, half),
        corner(-half, half),
        corner(-half, -half),
        corner(half, -half),
    ];
    painter.add(Shape::convex_polygon(corners, fill, stroke));
}

/// Three quarters of a circle with an arrow's head.
fn turn_mark(painter: &Painter, at: Pos2, radius: f32, ink: Color32) {
    if radius < 3.0 {
        painter.circle_filled(at, 1.5, ink);
        return;
    }
    let on = |angle: f32| at + radius * vec2(angle.cos(), angle.sin());
    let arc: Vec<Pos2> = (0..=12).map(|i| on(i as f32 * 0.36)).collect();
    painter.add(Shape::line(arc, Stroke::new(1.2, ink)));
}
