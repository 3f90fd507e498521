//! Where the photograph lies: painted behind everything, dragged while it is
//! selected, and brought to scale by two points whose distance is known.

use super::view::Canvas;
use crate::app::look::Tokens;
use crate::app::paint::{to_screen, to_world};
use crate::app::workbench::{Photograph, Photos, Selection, Workbench, photo_centre};
use crate::geometry::Vector;
use crate::scene::Photo;
use crate::units::{metres, millimetres, radians};
use crate::view::{Frame, Theme};
use eframe::egui::{
    Color32, CursorIcon, Mesh, Painter, PointerButton, Pos2, Response, Shape, Stroke, Vec2, pos2,
};

/// The corners in metres: upper left, upper right, lower right, lower left.
fn corners(photo: &Photo, ratio: f64) -> [Vector; 4] {
    let across = 0.5 * metres(photo.width_mm);
    let (sin, cos) = radians(photo.rotation_deg).sin_cos();
    [(-1.0, 1.0), (1.0, 1.0), (1.0, -1.0), (-1.0, -1.0)].map(|(x, y)| {
        let (x, y) = (across * x, across * ratio * y);
        photo_centre(photo) + Vector::new(cos * x - sin * y, sin * x + cos * y)
    })
}

/// Whether a point lies on the photograph.
fn holds(photo: &Photo, ratio: f64, point: Vector) -> bool {
    let corners = corners(photo, ratio);
    let from = point - corners[3];
    let within = |side: Vector| {
        let share = from.dot(&side) / side.norm_squared();
        (0.0..=1.0).contains(&share)
    };
    within(corners[2] - corners[3]) && within(corners[0] - corners[3])
}

/// Paints the photograph.
pub fn paint(painter: &Painter, photos: &Photos, photo: Option<&Photo>, frame: &Frame) {
    let Some(photo) = photo else {
        return;
    };
    let Some(Photograph::Here { texture, .. }) = photos.get(photo) else {
        return;
    };
    let Some(ratio) = photos.ratio(photo) else {
        return;
    };
    let places = corners(photo, ratio).map(|corner| to_screen(frame, corner));
    if !places.iter().all(|place| place.is_finite()) {
        return;
    }
    let shown = (255.0 * photo.opacity.clamp(0.0, 1.0)).round() as u8;
    let tint = Color32::from_white_alpha(shown);
    let mut mesh = Mesh::with_texture(texture.id());
    let uv = [
        pos2(0.0, 0.0),
        pos2(1.0, 0.0),
        pos2(1.0, 1.0),
        pos2(0.0, 1.0),
    ];
    for (place, uv) in places.into_iter().zip(uv) {
        mesh.vertices.push(eframe::egui::epaint::Vertex {
            pos: place,
            uv,
            color: tint,
        });
    }
    mesh.add_triangle(0, 1, 2);
    mesh.add_triangle(0, 2, 3);
    painter.add(Shape::mesh(mesh));
}

/// Paints the line around the selected photograph, and the points of the
/// scale tool.
pub fn outline(painter: &Painter, bench: &Workbench, frame: &Frame, theme: Theme) {
    let tokens = Tokens::of(theme);
    let photos = &bench.photos;
    if let Some(photo) = &bench.document.scene.photo
        && bench.selection == Selection::Photo
        && let Some(ratio) = photos.ratio(photo)
    {
        let mut line = corners(photo, ratio)
            .map(|corner| to_screen(frame, corner))
            .to_vec();
        line.extend(line.first().copied());
        let stroke = Stroke::new(1.5, tokens.accent);
        painter.extend(Shape::dashed_line(&line, stroke, 6.0, 4.0));
    }
    if let Some(scaling) = &photos.scaling {
        let points: Vec<Pos2> = scaling
            .points
            .iter()
            .map(|p| to_screen(frame, *p))
            .collect();
        if let [a, b] = points[..] {
            painter.line_segment([a, b], Stroke::new(2.0, tokens.accent));
        }
        for point in points {
            let arm = |by: Vec2| {
                painter.line_segment([point - by, point + by], Stroke::new(1.5, tokens.text))
            };
            arm(Vec2::new(9.0, 0.0));
            arm(Vec2::new(0.0, 9.0));
            painter.circle(point, 4.0, tokens.accent, Stroke::new(1.5, tokens.raised));
        }
    }
}

/// Lets the scale tool take points and the selected photograph be dragged;
/// whether the pointer is thereby taken.
pub fn interact(
    response: &Response,
    canvas: &mut Canvas,
    bench: &mut Workbench,
    frame: &Frame,
) -> bool {
    let Some(pointer) = response.hover_pos().or(response.interact_pointer_pos()) else {
        return false;
    };
    let world = |at: Pos2| to_world(frame, at);
    if let Some(scaling) = &mut bench.photos.scaling {
        response.ctx.set_cursor_icon(CursorIcon::Crosshair);
        if response.clicked() {
            scaling.take(world(pointer));
        }
        return !response.dragged();
    }
    if bench.selection != Selection::Photo {
        canvas.held_photo = None;
        return false;
    }
    let Some(photo) = &mut bench.document.scene.photo else {
        return false;
    };
    if response.drag_started_by(PointerButton::Primary) {
        let origin = response.ctx.input(|input| input.pointer.press_origin());
        let origin = world(origin.unwrap_or(pointer));
        let ratio = match bench.photos.known.get(std::path::Path::new(&photo.file)) {
            Some(Photograph::Here { size, .. }) => f64::from(size[1]) / f64::from(size[0]),
            _ => 1.0,
        };
        if holds(photo, ratio, origin) {
            canvas.held_photo = Some(origin - photo_centre(photo));
        }
    }
    let Some(held) = canvas.held_photo else {
        return false;
    };
    response.ctx.set_cursor_icon(CursorIcon::Grabbing);
    let to = world(pointer) - held;
    photo.center_mm = [millimetres(to.x), millimetres(to.y)];
    if response.drag_stopped() {
        canvas.held_photo = None;
    }
    true
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::app::workbench::photo;

    #[test]
    fn a_turned_photograph_is_where_it_is_painted() {
        // A quarter turn: the width runs upward.
        assert!(holds(&photo(), 0.5, Vector::new(0.01, 0.069)));
        assert!(!holds(&photo(), 0.5, Vector::new(0.059, 0.02)));
        let upper_left = corners(&photo(), 0.5)[0];
        assert!(
            (upper_left - Vector::new(-0.015, -0.03)).norm() < 1e-12,
            "{upper_left}"
        );
    }
}
