//! The panels around the canvas: bar, outline, transport, status, dock.

mod bar;
mod measured;
mod menu;
mod photo;
mod restore;
mod settings;
mod track;
mod transport;

pub use settings::settings_id;

use super::look::Tokens;
use super::state::State;
use eframe::egui::{Frame, Margin, Panel, Ui};

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
}
