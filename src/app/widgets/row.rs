//! What lists and tables of the panels are made of: a row that can be pointed
//! at, chosen and focused, and a name with a value beside it.

use crate::app::look::{Tokens, semibold};
use crate::view::Quantity;
use eframe::egui::{
    self, Align, CornerRadius, FontId, Id, Label, Layout, Rect, Response, RichText, Role, Sense,
    Stroke, StrokeKind, Ui, WidgetInfo, pos2, vec2,
};

/// Room for the units beside values of a summary, in points.
const UNIT: f32 = 52.0;

/// How a row stands out.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Emphasis {
    /// It is what is selected.
    pub selected: bool,
    /// Its twin is under the pointer elsewhere.
    pub lit: bool,
}

/// Height of rows, in points.
pub fn height(ui: &Ui) -> f32 {
    ui.spacing().interact_size.y
}

/// A row across the width there is, to be filled by the caller.
pub fn row(ui: &mut Ui, id: Id, name: &str, emphasis: Emphasis) -> Response {
    let size = vec2(ui.available_width(), height(ui));
    let (_, rect) = ui.allocate_space(size);
    let response = ui.interact(rect, id, Sense::click());
    response.widget_info(|| {
        WidgetInfo::selected(
            Role::ListBoxOption,
            ui.is_enabled(),
            emphasis.selected,
            name,
        )
    });
    let tokens = Tokens::in_ui(ui);
    let fill = if emphasis.selected {
        Some(tokens.accent_soft)
    } else if emphasis.lit || response.hovered() {
        Some(tokens.hover)
    } else {
        None
    };
    let radius = CornerRadius::same(6);
    if let Some(fill) = fill {
        ui.painter().rect_filled(rect, radius, fill);
    }
    focus(ui, &response);
    response
}

/// A ring around what has the keyboard's focus.
pub fn focus(ui: &Ui, response: &Response) {
    if response.has_focus() {
        let stroke = Stroke::new(1.5, Tokens::in_ui(ui).accent);
        let radius = CornerRadius::same(6);
        ui.painter()
            .rect_stroke(response.rect, radius, stroke, StrokeKind::Inside);
    }
}

/// Text within a rectangle, cut where it does not fit.
pub fn text(ui: &mut Ui, rect: Rect, text: impl Into<RichText>, align: Align) {
    let layout = match align {
        Align::Max => Layout::right_to_left(Align::Center),
        _ => Layout::left_to_right(Align::Center),
    };
    let builder = egui::UiBuilder::new().max_rect(rect).layout(layout);
    ui.scope_builder(builder, |ui| {
        ui.add(Label::new(text.into()).selectable(false).truncate());
    });
}

/// Text painted in a row, whose name already says it; cut where it does not fit.
pub fn painted(ui: &Ui, rect: Rect, text: &str) {
    let text = egui::WidgetText::from(text);
    let mode = egui::TextWrapMode::Truncate;
    let galley = text.into_galley(ui, Some(mode), rect.width(), egui::TextStyle::Body);
    let at = rect.left_center() - vec2(0.0, 0.5 * galley.size().y);
    ui.painter().galley(at, galley, Tokens::in_ui(ui).text);
}

/// A heading over a group, small and quiet.
pub fn heading(ui: &mut Ui, text: &str) -> Response {
    let muted = Tokens::in_ui(ui).muted;
    ui.label(RichText::new(text).font(semibold(12.0)).color(muted))
}

/// A name with a value beside it, digits under digits.
pub fn fact(ui: &mut Ui, name: &str, symbol: &str, value: &Quantity) {
    let size = vec2(ui.available_width(), 24.0);
    let (rect, response) = ui.allocate_exact_size(size, Sense::hover());
    response.widget_info(|| {
        let told = format!("{name} {}", value.text());
        WidgetInfo::labeled(Role::Label, ui.is_enabled(), told)
    });
    let tokens = Tokens::in_ui(ui);
    let painter = ui.painter();
    let body = FontId::proportional(14.0);
    let small = FontId::proportional(12.0);
    let y = rect.center().y;
    let name = painter.text(
        pos2(rect.left(), y),
        egui::Align2::LEFT_CENTER,
        name,
        body.clone(),
        tokens.muted,
    );
    painter.text(
        pos2(name.right() + 6.0, y),
        egui::Align2::LEFT_CENTER,
        symbol,
        body.clone(),
        tokens.muted,
    );
    let split = rect.right() - UNIT;
    painter.text(
        pos2(split, y),
        egui::Align2::RIGHT_CENTER,
        &value.digits,
        body,
        tokens.text,
    );
    painter.text(
        pos2(split + 4.0, y),
        egui::Align2::LEFT_CENTER,
        value.unit,
        small,
        tokens.muted,
    );
}
