//! The panels around the canvas: bar, outline and inspector, transport,
//! status, tables.

mod bar;
mod inspector;
mod measured;
mod menu;
mod outline;
mod photo;
mod restore;
mod settings;
mod status;
pub mod tables;
mod track;
mod transport;

pub use settings::settings_id;

use super::dock;
use super::look::{Segment, Tokens, icon_button, icons, segments};
use super::state::{Selection, State};
use eframe::egui::{Align, Context, Frame, Layout, Margin, Panel, Ui};

/// Windows that are narrower than this, in points, have no room for the
/// outline.
const NARROW: f32 = 640.0;

/// Windows that are narrower than this, in points, have no room for the dock.
const WIDE: f32 = 960.0;

/// A panel beside the canvas, or below it where the window is narrow.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// Outline and inspector.
    Outline,
    /// Plots and tables.
    Dock,
}

impl Side {
    /// Whether a window of this width, in points, has no room beside its canvas.
    fn is_below(self, width: f32) -> bool {
        match self {
            Side::Outline => width < NARROW,
            Side::Dock => width < WIDE,
        }
    }

    /// Shows or hides the panel, which below the canvas is never there at first.
    pub fn toggle(self, state: &mut State, ctx: &Context) {
        if self.is_below(ctx.content_rect().width()) {
            let below = &mut state.panels.below;
            *below = (*below != Some(self)).then_some(self);
        } else {
            let shown = match self {
                Side::Outline => &mut state.preferences.outline,
                Side::Dock => &mut state.preferences.dock,
            };
            *shown ^= true;
        }
    }
}

/// What the panels keep from frame to frame.
#[derive(Debug, Default)]
pub struct Panels {
    /// Whether the certificate is open.
    pub certificate: bool,
    /// What is open below the canvas of a narrow window.
    pub below: Option<Side>,
    /// The obstacle that is being renamed in the outline.
    renaming: Option<outline::Renaming>,
    /// What was wrong with what was typed last.
    complaint: Option<super::widgets::Complaint>,
    /// What the inspector showed last.
    inspected: Selection,
    /// What the status chip told last, and when.
    told: Option<(status::Verdict, f64)>,
}

impl Panels {
    /// Follows a selection that went because what was selected was taken back:
    /// the inspector is not to forget why.
    pub fn follow(&mut self, selection: Selection) {
        self.inspected = selection;
    }
}

/// Outline and inspector.
fn scene(ui: &mut Ui, state: &mut State) {
    let height = ui.available_height();
    ui.scope(|ui| outline::show(ui, state, 0.4 * height));
    ui.add_space(20.0);
    inspector::show(ui, state);
}

/// What is open below the canvas, with the way back.
fn below(ui: &mut Ui, state: &mut State, side: Side, width: f32) {
    let sides = [(Side::Outline, "Scene"), (Side::Dock, "Plots")];
    let sides: Vec<_> = sides
        .into_iter()
        .filter(|it| it.0.is_below(width))
        .collect();
    let margin = Margin::symmetric(12, 6);
    Frame::new().inner_margin(margin).show(ui, |ui| {
        ui.horizontal(|ui| {
            let shown = sides.iter().map(|(_, name)| Segment {
                name,
                title: name,
                tip: (*name).to_owned(),
                enabled: true,
            });
            let shown: Vec<_> = shown.collect();
            let current = sides.iter().position(|it| it.0 == side);
            if let Some(chosen) = segments(ui, 72.0, &shown, current) {
                state.panels.below = Some(sides[chosen].0);
            }
            ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
                if icon_button(ui, icons::X, "Close").clicked() {
                    state.panels.below = None;
                }
            });
        });
    });
    match side {
        Side::Dock => dock::show(ui, state),
        Side::Outline => {
            let margin = Margin::symmetric(12, 4);
            Frame::new()
                .inner_margin(margin)
                .show(ui, |ui| scene(ui, state));
        }
    }
}

/// Shows all panels that are open; what is left is the canvas's.
pub fn show(ui: &mut Ui, state: &mut State) {
    let tokens = Tokens::in_ui(ui);
    let frame = |x: i8, y: i8| {
        Frame::new()
            .fill(tokens.panel)
            .inner_margin(Margin::symmetric(x, y))
    };
    Panel::top("bar")
        .frame(frame(12, 6))
        .show(ui, |ui| bar::show(ui, state));
    restore::show(ui, state);
    Panel::bottom("transport")
        .frame(frame(12, 8))
        .show(ui, |ui| transport::show(ui, state));
    let width = ui.available_width();
    if let Some(side) = state.panels.below.filter(|side| side.is_below(width)) {
        Panel::bottom("below")
            .frame(Frame::new().fill(tokens.panel))
            .default_size(0.5 * ui.available_height())
            .size_range(160.0..=0.7 * ui.available_height())
            .show(ui, |ui| below(ui, state, side, width));
    }
    if state.preferences.outline && !Side::Outline.is_below(width) {
        Panel::left("outline")
            .frame(frame(12, 12))
            .default_size(260.0)
            .size_range(220.0..=0.4 * width)
            .show(ui, |ui| scene(ui, state));
    }
    if state.preferences.dock && !Side::Dock.is_below(width) {
        Panel::right("dock")
            .frame(Frame::new().fill(tokens.panel))
            .default_size(0.27 * width)
            .size_range(280.0..=0.6 * width)
            .show(ui, |ui| dock::show(ui, state));
    }
    if state.panels.certificate {
        status::certificate(ui, state);
    }
}
