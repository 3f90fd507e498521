//! A button for a command.

use crate::app::commands::Command;
use crate::app::look::icon_button;
use crate::app::workbench::Workbench;
use eframe::egui::Ui;

/// A button for a command.
pub fn button(ui: &mut Ui, bench: &mut Workbench, command: Command) {
    let enabled = bench.allows(command);
    let tip = command.tip(ui.ctx());
    let clicked = ui
        .add_enabled_ui(enabled, |ui| {
            icon_button(ui, command.entry().icon, &tip).clicked()
        })
        .inner;
    if clicked {
        bench.commands.push(command);
    }
}
