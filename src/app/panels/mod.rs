//! The panels around the canvas: bar, outline and inspector, transport,
//! status, tables.

mod bar;
mod inspector;
mod measured;
mod menu;
mod outline;
mod photo;
mod restore;
mod row;
mod settings;
mod status;
pub mod tables;
mod track;
mod transport;
mod typed;

pub use settings::settings_id;

use super::dock;
use super::look::Tokens;
use super::state::{Selection, State};
use eframe::egui::{Align, Frame, Layout, Margin, Panel, Ui, vec2};

/// Windows that are narrower than this, in points, have no room for the
/// outline.
const NARROW: f32 = 640.0;

/// Windows that are narrower than this, in points, have no room for the dock.
const WIDE: f32 = 960.0;

/// What the panels keep from frame to frame.
#[derive(Debug, Default)]
pub struct Panels {
    /// Whether the certificate is open.
    pub certificate: bool,
    /// The obstacle that is being renamed in the outline.
    renaming: Option<outline::Renaming>,
    /// What was wrong with what was typed last.
    complaint: Option<inspector::Complaint>,
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
        .show(ui, |ui| {
            let bar = ui.available_width();
            let height = ui.spacing().interact_size.y;
            let layout = Layout::right_to_left(Align::Center);
            ui.allocate_ui_with_layout(vec2(bar, height), layout, |ui| {
                ui.spacing_mut().item_spacing.x = 16.0;
                status::show(ui, state, bar);
                ui.with_layout(Layout::left_to_right(Align::Center), |ui| {
                    ui.spacing_mut().item_spacing.x = 8.0;
                    transport::show(ui, state);
                });
            });
        });
    let width = ui.available_width();
    if state.preferences.outline && width >= NARROW {
        Panel::left("outline")
            .frame(frame(12, 12))
            .default_size(260.0)
            .size_range(220.0..=0.4 * width)
            .show(ui, |ui| {
                let height = ui.available_height();
                ui.scope(|ui| outline::show(ui, state, 0.4 * height));
                ui.add_space(20.0);
                inspector::show(ui, state);
            });
    }
    if state.preferences.dock && width >= WIDE {
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
