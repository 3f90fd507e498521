//! What is selected, every field of it editable; or, where nothing is, what is
//! known of the robot's shape.

mod cables;
mod friction;
mod loads;
mod obstacle;
mod robot;
mod spacing;
mod summary;

use crate::app::workbench::{Selection, Workbench};
use eframe::egui::{ScrollArea, Ui};

/// Shows the inspector in the room there is.
pub fn show(ui: &mut Ui, bench: &mut Workbench) {
    // What was wrong with one thing is not to be told of another.
    bench.inspect();
    ScrollArea::vertical()
        .id_salt("inspector")
        .auto_shrink([false, false])
        .show(ui, |ui| match bench.selection {
            Selection::Nothing => summary::show(ui, bench),
            Selection::Robot => robot::show(ui, bench),
            Selection::Obstacle(index) => obstacle::show(ui, bench, index),
            Selection::Photo => super::photo::show(ui, bench),
            Selection::Measured => super::measured::show(ui, bench),
        });
}
