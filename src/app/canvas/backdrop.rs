//! What lies behind and before the robot besides the drawing: the photograph
//! and the measured backbone.

use super::photo;
use super::view::Canvas;
use crate::app::look::Tokens;
use crate::app::workbench::{Selection, Workbench};
use crate::geometry::Vector;
use crate::units::metres;
use crate::view::{Frame, Theme};
use eframe::egui::{Painter, Pos2, Response, Shape, Stroke, pos2, vec2};

/// Behind everything.
pub fn behind(painter: &Painter, bench: &Workbench, frame: &Frame) {
    let photo = bench.document.scene.photo.as_ref();
    photo::paint(painter, &bench.photos, photo, frame);
}

/// Before everything but words.
pub fn before(painter: &Painter, bench: &Workbench, frame: &Frame, theme: Theme) {
    photo::outline(painter, bench, frame, theme);
    measured(painter, bench, frame, theme);
}

/// Whether the pointer is taken by what lies here.
pub fn interact(
    response: &Response,
    canvas: &mut Canvas,
    bench: &mut Workbench,
    frame: &Frame,
) -> bool {
    photo::interact(response, canvas, bench, frame)
}

/// The measured backbone: diamonds, which nothing else on the canvas is.
fn measured(painter: &Painter, bench: &Workbench, frame: &Frame, theme: Theme) {
    let Some(measured) = &bench.document.scene.measured else {
        return;
    };
    let tokens = Tokens::of(theme);
    let at = |point: &[f64; 2]| -> Pos2 {
        let place = frame.to_screen(Vector::new(metres(point[0]), metres(point[1])));
        pos2(place.x as f32, place.y as f32)
    };
    let places: Vec<Pos2> = measured.points_mm.iter().map(at).collect();
    if !places.iter().all(|place| place.is_finite()) {
        return;
    }
    let selected = bench.selection == Selection::Measured;
    let colour = if selected { tokens.accent } else { tokens.good };
    let line = Stroke::new(1.0, colour.gamma_multiply(0.6));
    painter.extend(Shape::dashed_line(&places, line, 4.0, 4.0));
    let size = if selected { 5.0 } else { 4.0 };
    for place in places {
        let corners = [(0.0, -size), (size, 0.0), (0.0, size), (-size, 0.0)];
        let corners = corners.map(|(x, y)| place + vec2(x, y)).to_vec();
        let edge = Stroke::new(1.5, colour);
        painter.add(Shape::convex_polygon(
            corners,
            tokens.canvas.gamma_multiply(0.8),
            edge,
        ));
    }
}
