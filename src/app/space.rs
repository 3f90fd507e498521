//! The robot in space: an orbit camera around what the graphics processor
//! draws.

use super::look::{Tokens, semibold, theme_of};
use super::widgets::understated_over;
use super::workbench::{Live, Workbench};
use crate::geometry::Vector;
use crate::render::{Camera, Mesh, mesh, solid_callback};
use crate::view::{LabelText, Spot, Theme};
use eframe::egui::text::{LayoutJob, TextFormat};
use eframe::egui::{
    Align2, FontId, Painter, PointerButton, Rect, Response, Sense, Ui, WidgetInfo, vec2,
};
use nalgebra::Vector3;
use std::sync::Arc;

/// The view's camera, and the solids as last built.
#[derive(Debug, Default)]
pub struct Space {
    camera: Option<Camera>,
    /// Fit the camera at the next frame.
    fit: bool,
    /// The document that it has seen, see [`Workbench::opened`].
    opened: u64,
    built: Option<Built>,
}

/// Solids, and what they were built from.
#[derive(Debug)]
struct Built {
    revision: u64,
    theme: Theme,
    mesh: Arc<Mesh>,
}

impl Space {
    /// Shows everything at the next frame.
    pub fn fit_soon(&mut self) {
        self.fit = true;
    }
}

/// Shows the view in all the room there is.
pub fn show(ui: &mut Ui, space: &mut Space, bench: &mut Workbench) {
    let (rect, response) = ui.allocate_exact_size(ui.available_size(), Sense::click_and_drag());
    response
        .widget_info(|| WidgetInfo::labeled(eframe::egui::Role::Canvas, true, "Robot in space"));
    if space.opened != bench.opened {
        space.opened = bench.opened;
        space.fit_soon();
    }
    if rect.width() < 8.0 || rect.height() < 8.0 {
        return;
    }
    let theme = theme_of(ui);
    let solids = solids(space, bench, theme);
    let aspect = f64::from(rect.width() / rect.height());
    let camera = match (&mut space.camera, std::mem::take(&mut space.fit)) {
        (Some(camera), false) => camera,
        (camera, _) => camera.insert(Camera::fitting(&solids.focus, aspect)),
    };
    navigate(ui, &response, camera, rect);
    if response.double_clicked() {
        *camera = Camera::fitting(&solids.focus, aspect);
    }
    let painter = ui.painter_at(rect);
    painter.rect_filled(rect, 0.0, Tokens::of(theme).canvas);
    painter.add(solid_callback(rect, solids, *camera, theme));
    values(&painter, rect, *camera, &bench.live, theme);
    understated_over(ui, bench, rect.right_bottom() - vec2(12.0, 12.0));
    let hint = "Drag to turn, right-drag to move, double-click to reset";
    if response.hovered() {
        painter.text(
            rect.center_bottom() - vec2(0.0, 16.0),
            Align2::CENTER_BOTTOM,
            hint,
            FontId::proportional(12.0),
            Tokens::of(theme).muted,
        );
    }
}

/// The solids of what is shown, built again only when that has changed.
fn solids(space: &mut Space, bench: &Workbench, theme: Theme) -> Arc<Mesh> {
    let revision = bench.live.revision();
    if let Some(built) = &space.built
        && built.revision == revision
        && built.theme == theme
    {
        return Arc::clone(&built.mesh);
    }
    let drawing = bench.live.drawing();
    let (standing, scale) = (&drawing.standing, drawing.scale);
    let obstacles = bench.live.problem().obstacles();
    let mesh = Arc::new(mesh(
        &bench.live.solved(),
        obstacles,
        scale,
        theme,
        standing,
    ));
    space.built = Some(Built {
        revision,
        theme,
        mesh: Arc::clone(&mesh),
    });
    mesh
}

/// Paints how hard the contacts press, beyond their arrows.
fn values(painter: &Painter, rect: Rect, camera: Camera, live: &Live, theme: Theme) {
    let tokens = Tokens::of(theme);
    let aspect = f64::from(rect.width() / rect.height());
    let seen = |point: Vector| {
        let [right, up] = camera.seen(Vector3::new(point.x, point.y, 0.0), aspect)?;
        let half = 0.5 * rect.size();
        Some(rect.center() + vec2(right as f32 * half.x, -up as f32 * half.y))
    };
    let length = live.problem().length();
    for label in &live.drawing().labels {
        let (LabelText::Value(value), Spot::Beyond { point, towards }) = (&label.text, label.spot)
        else {
            continue;
        };
        let (Some(at), Some(beyond)) = (seen(point), seen(point + 0.05 * length * towards)) else {
            continue;
        };
        let away = (beyond - at).normalized();
        let mut job = LayoutJob::default();
        let unit = format!(" {}", value.unit);
        for (text, font, ink) in [
            (value.digits.as_str(), semibold(12.0), tokens.text),
            (unit.as_str(), FontId::proportional(12.0), tokens.muted),
        ] {
            job.append(text, 0.0, TextFormat::simple(font, ink));
        }
        let galley = painter.layout_job(job);
        let size = galley.size();
        let middle = at + away * (8.0 + 0.5 * size.x * away.x.abs() + 0.5 * size.y * away.y.abs());
        let area = Rect::from_center_size(middle, size);
        let back = tokens.canvas.gamma_multiply(0.6);
        painter.rect_filled(area.expand2(vec2(4.0, 1.0)), 4.0, back);
        painter.galley(area.min, galley, tokens.text);
    }
}

fn navigate(ui: &Ui, response: &Response, camera: &mut Camera, rect: Rect) {
    let by = response.drag_delta();
    let (right, down) = (f64::from(by.x), f64::from(by.y));
    let (shift, zoom, scroll, touch) = ui.input(|input| {
        (
            input.modifiers.shift,
            f64::from(input.zoom_delta()),
            f64::from(input.smooth_scroll_delta().y),
            input.multi_touch(),
        )
    });
    let height = f64::from(rect.height());
    if let Some(touch) = touch {
        let by = touch.translation_delta;
        camera.pan(f64::from(by.x), f64::from(by.y), height);
    } else if response.dragged_by(PointerButton::Primary) && !shift {
        camera.orbit(right, down);
    } else if response.dragged() {
        camera.pan(right, down, height);
    }
    if response.contains_pointer() {
        let factor = zoom * (scroll / 240.0).exp();
        if factor != 1.0 {
            camera.zoom(factor);
        }
    }
    if response.has_focus() {
        turn_by_keys(ui, camera);
    }
}

/// Arrow keys turn the view that has the focus.
fn turn_by_keys(ui: &Ui, camera: &mut Camera) {
    use eframe::egui::Key;
    const STEP: f64 = 12.0;
    ui.input(|input| {
        for (key, right, down) in [
            (Key::ArrowLeft, -STEP, 0.0),
            (Key::ArrowRight, STEP, 0.0),
            (Key::ArrowUp, 0.0, -STEP),
            (Key::ArrowDown, 0.0, STEP),
        ] {
            if input.key_pressed(key) {
                camera.orbit(right, down);
            }
        }
    });
}
