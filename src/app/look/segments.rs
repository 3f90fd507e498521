//! A row of names of which one is chosen.

use super::{Tokens, semibold};
use eframe::egui::{
    Align2, Color32, FontId, Rect, Response, Role, Sense, Stroke, StrokeKind, Ui, WidgetInfo, vec2,
};

/// Distance of the names from the edge of their rail, in points.
const EDGE: f32 = 2.0;

/// A name to choose.
pub struct Segment<'a> {
    /// What is written, in a word.
    pub name: &'a str,
    /// What it does, for those who cannot see it.
    pub title: &'a str,
    /// What it does, where the pointer rests on it.
    pub tip: String,
    /// Whether it can be chosen.
    pub enabled: bool,
}

/// Shows segments of one width, in points; which of them was clicked.
pub fn segments(
    ui: &mut Ui,
    width: f32,
    shown: &[Segment<'_>],
    current: Option<usize>,
) -> Option<usize> {
    let tokens = Tokens::in_ui(ui);
    let size = vec2(width, ui.spacing().interact_size.y);
    let all = vec2(size.x * shown.len() as f32 + 2.0 * EDGE, size.y);
    let (rail, _) = ui.allocate_exact_size(all, Sense::hover());
    ui.painter().rect_filled(rail, 7.0, tokens.sunken);
    let mut corner = rail.min + vec2(EDGE, 0.0);
    let mut clicked = None;
    for (index, segment) in shown.iter().enumerate() {
        // What can be hit is as high as the rail, what is seen is not.
        let rect = Rect::from_min_size(corner, size);
        corner.x += size.x;
        let enabled = segment.enabled && ui.is_enabled();
        let sense = match enabled {
            true => Sense::click(),
            false => Sense::hover(),
        };
        let id = ui.scope_id().with(segment.title);
        let response = ui.interact(rect, id, sense).on_hover_text(&segment.tip);
        let chosen = current == Some(index);
        response.widget_info(|| {
            WidgetInfo::selected(Role::RadioButton, enabled, chosen, segment.title)
        });
        paint(ui, &response, segment, chosen, enabled);
        if response.clicked() {
            clicked = Some(index);
        }
    }
    clicked
}

fn paint(ui: &Ui, response: &Response, segment: &Segment<'_>, chosen: bool, enabled: bool) {
    let tokens = Tokens::in_ui(ui);
    let (ink, font) = match chosen {
        true => (tokens.text, semibold(12.0)),
        false => (tokens.muted, FontId::proportional(12.0)),
    };
    let fill = if chosen {
        tokens.raised
    } else if enabled && response.is_pointer_button_down_on() {
        tokens.held
    } else if enabled && response.hovered() {
        tokens.hover
    } else {
        Color32::TRANSPARENT
    };
    let face = response.rect.shrink2(vec2(0.0, EDGE));
    let painter = ui.painter();
    painter.rect_filled(face, 5.0, fill);
    if response.has_focus() {
        let stroke = Stroke::new(1.5, tokens.accent);
        painter.rect_stroke(face, 5.0, stroke, StrokeKind::Inside);
    }
    let ink = if enabled {
        ink
    } else {
        ink.gamma_multiply(0.5)
    };
    let middle = face.center();
    painter.text(middle, Align2::CENTER_CENTER, segment.name, font, ink);
}
