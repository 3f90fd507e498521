//! The transport bar: play, and the pull's slider across the window.

use super::bar::button;
use crate::app::commands::Command;
use crate::app::look::{icon_button, icons};
use crate::app::state::State;
use eframe::egui::{DragValue, Slider, Ui};

/// Shows the transport bar.
pub fn show(ui: &mut Ui, state: &mut State) {
    ui.horizontal(|ui| {
        let (glyph, name) = if state.transport.is_playing() {
            (icons::PAUSE, "Pause (Space)")
        } else {
            (icons::PLAY, "Play (Space)")
        };
        if icon_button(ui, glyph, name).clicked() {
            state.commands.push(Command::Play);
        }
        button(ui, state, Command::FromStraight);
        let label = ui.label("Pull");
        let span = state.span_mm();
        let pull_mm = &mut state.document.scene.actuation.pull_mm;
        ui.add(
            DragValue::new(pull_mm)
                .speed(0.01)
                .fixed_decimals(2)
                .suffix(" mm"),
        )
        .labelled_by(label.id);
        ui.spacing_mut().slider_width = ui.available_width();
        ui.add(Slider::new(pull_mm, span.0..=span.1).show_value(false))
            .labelled_by(label.id);
    });
}
