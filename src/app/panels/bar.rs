//! The bar at the top: what the document is called, and the commands that are
//! used most.

use crate::app::commands::Command;
use crate::app::look::{icon_button, semibold};
use crate::app::state::State;
use eframe::egui::{Align, Layout, RichText, Ui};

/// Shows the bar.
pub fn show(ui: &mut Ui, state: &mut State) {
    ui.horizontal(|ui| {
        ui.label(RichText::new("Sinew").font(semibold(14.0)));
        ui.add_space(8.0);
        ui.label(state.document.name());
        if state.document.is_changed() {
            ui.weak("changed");
        }
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            for command in [
                Command::Theme,
                Command::Dock,
                Command::Outline,
                Command::Fit,
                Command::Redo,
                Command::Undo,
            ] {
                button(ui, state, command);
            }
        });
    });
}

/// A button for a command.
pub fn button(ui: &mut Ui, state: &mut State, command: Command) {
    let enabled = command.is_enabled(state);
    let tip = command.tip(ui.ctx());
    let clicked = ui
        .add_enabled_ui(enabled, |ui| {
            icon_button(ui, command.entry().icon, &tip).clicked()
        })
        .inner;
    if clicked {
        state.commands.push(command);
    }
}
