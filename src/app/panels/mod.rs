//! The panels around the canvas: bar, outline and inspector, transport with
//! the status chip, the switch of mechanics, the certificate. Where they are is the window's.

mod bar;
mod inspector;
mod measured;
mod mechanics;
mod menu;
mod outline;
mod photo;
mod pins;
mod restore;
mod settings;
mod status;
mod track;
mod transport;

pub use bar::show as bar;
pub use restore::show as restore;
pub use settings::settings_id;

use super::workbench::Workbench;
use eframe::egui::Ui;
use outline::Outline;
use status::StatusChip;

/// What the panels keep from frame to frame.
#[derive(Debug, Default)]
pub struct Panels {
    outline: Outline,
    chip: StatusChip,
}

/// Shows outline and inspector.
pub fn scene(ui: &mut Ui, panels: &mut Panels, bench: &mut Workbench) {
    let height = ui.available_height();
    ui.scope(|ui| outline::show(ui, &mut panels.outline, bench, 0.4 * height));
    ui.add_space(16.0);
    mechanics::show(ui, bench);
    pins::show(ui, bench);
    inspector::show(ui, bench);
}

/// Shows the transport bar.
pub fn transport(ui: &mut Ui, panels: &mut Panels, bench: &mut Workbench) {
    transport::show(ui, &mut panels.chip, bench);
}

/// Shows the certificate's window, if it is open.
pub fn certificate(ui: &mut Ui, panels: &mut Panels, bench: &mut Workbench) {
    if panels.chip.certificate {
        status::certificate(ui, &mut panels.chip.certificate, bench);
    }
}
