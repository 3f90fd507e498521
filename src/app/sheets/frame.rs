//! What all sheets are made of: their frame, captions and buttons.

use crate::app::look::{Tokens, icon_button, icons, semibold};
use eframe::egui::{
    Align, Align2, Color32, Context, Frame, Id, Layout, Margin, Modal, RichText, ScrollArea,
    Stroke, StrokeKind, Ui, vec2,
};

/// Whether a sheet stays.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Stays {
    Open,
    Closed,
}

impl Stays {
    pub fn unless(closed: bool) -> Self {
        if closed { Stays::Closed } else { Stays::Open }
    }
}

/// A sheet's room: at most this wide and high, and never beyond the window.
pub(super) fn room(ctx: &Context, width: f32, height: f32) -> (f32, f32) {
    let window = ctx.content_rect().size();
    (
        width.min(window.x - 24.0 - 2.0 * EDGE),
        height.min(window.y - 24.0 - 2.0 * EDGE - 40.0),
    )
}

/// Room between a sheet's edge and what it holds.
const EDGE: f32 = 20.0;

/// The frame of all sheets.
fn frame(ui_style: &eframe::egui::Style) -> Frame {
    Frame::window(ui_style)
        .corner_radius(14)
        .inner_margin(Margin::same(EDGE as i8))
}

pub(super) fn modal(ctx: &Context, name: &str) -> Modal {
    let shade = if ctx.global_style().visuals.dark_mode {
        150
    } else {
        80
    };
    Modal::new(Id::unique(name))
        .backdrop_color(Color32::from_black_alpha(shade))
        .frame(frame(&ctx.global_style()))
}

/// A large sheet with a title and a cross, whose contents scroll.
pub(super) fn large(
    ctx: &Context,
    name: &str,
    title: &str,
    size: (f32, f32),
    content: impl FnOnce(&mut Ui),
) -> Stays {
    let (width, height) = room(ctx, size.0, size.1);
    let response = modal(ctx, name).show(ctx, |ui| {
        ui.set_width(width);
        let mut closed = false;
        ui.horizontal(|ui| {
            ui.label(RichText::new(title).font(semibold(18.0)));
            ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
                closed = icon_button(ui, icons::X, "Close (Esc)").clicked();
            });
        });
        ui.add_space(8.0);
        ScrollArea::vertical()
            .max_height(height)
            // Beyond what the first frame happened to leave.
            .min_scrolled_height(height)
            .auto_shrink([false, true])
            .show(ui, |ui| {
                // Room for the scroll bar.
                ui.set_max_width(width - 10.0);
                content(ui);
            });
        closed
    });
    Stays::unless(response.inner || response.should_close())
}

/// A small sheet at the top of the window, as for words that are typed.
pub(super) fn at_top(
    ctx: &Context,
    name: &str,
    width: f32,
    content: impl FnOnce(&mut Ui),
) -> Stays {
    let (width, _) = room(ctx, width, 0.0);
    let id = Id::unique(name);
    let down = (0.12 * ctx.content_rect().height()).min(96.0);
    let area = Modal::default_area(id).anchor(Align2::CENTER_TOP, vec2(0.0, down));
    let frame = frame(&ctx.global_style()).inner_margin(Margin::same(8));
    let response = modal(ctx, name).area(area).frame(frame).show(ctx, |ui| {
        ui.set_width(width);
        content(ui);
    });
    Stays::unless(response.should_close())
}

/// A caption over a part of a sheet.
pub(super) fn caption(ui: &mut Ui, text: &str) {
    let muted = Tokens::in_ui(ui).muted;
    ui.label(RichText::new(text).font(semibold(12.0)).color(muted));
    ui.add_space(4.0);
}

/// A button that stands out: what is usually meant.
pub(super) fn main_button(ui: &mut Ui, text: &str) -> eframe::egui::Response {
    let tokens = Tokens::in_ui(ui);
    // Light on the accent by day, dark on it by night.
    let ink = if ui.visuals().dark_mode {
        tokens.sunken
    } else {
        tokens.raised
    };
    let text = RichText::new(text).font(semibold(14.0)).color(ink);
    let button = eframe::egui::Button::new(text).fill(tokens.accent);
    ringed(ui, button.min_size(vec2(72.0, 32.0)))
}

/// A button with a ring around it while it has the focus.
fn ringed(ui: &mut Ui, button: eframe::egui::Button<'_>) -> eframe::egui::Response {
    let response = ui.add(button);
    if response.has_focus() {
        let stroke = Stroke::new(2.0, Tokens::in_ui(ui).accent);
        let around = response.rect.expand(3.0);
        ui.painter()
            .rect_stroke(around, 8.0, stroke, StrokeKind::Inside);
    }
    response
}

/// Any other button of a sheet.
pub(super) fn plain_button(ui: &mut Ui, text: &str) -> eframe::egui::Response {
    ringed(
        ui,
        eframe::egui::Button::new(text).min_size(vec2(72.0, 32.0)),
    )
}
