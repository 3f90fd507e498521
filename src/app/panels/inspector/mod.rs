//! What is selected, every field of it editable; or, where nothing is, what is
//! known of the robot's shape.

mod obstacle;
mod robot;
mod summary;

use super::Panels;
use crate::app::state::{Selection, State};
use crate::app::widgets::Form;
use crate::scene::SceneError;
use eframe::egui::{ScrollArea, Ui};

/// Shows the inspector in the room there is.
pub fn show(ui: &mut Ui, state: &mut State) {
    if state.panels.inspected != state.selection {
        // What was wrong with one thing is not to be told of another.
        state.panels.inspected = state.selection;
        state.panels.complaint = None;
        state.refusal = None;
    }
    ScrollArea::vertical()
        .id_salt("inspector")
        .auto_shrink([false, false])
        .show(ui, |ui| match state.selection {
            Selection::Nothing => summary::show(ui, state),
            Selection::Robot => robot::show(ui, state),
            Selection::Obstacle(index) => obstacle::show(ui, state, index),
            Selection::Photo => super::photo::show(ui, state),
            Selection::Measured => super::measured::show(ui, state),
        });
}

/// A form for a part of the scene, which is handed out beside it.
pub(super) fn with_form(
    state: &mut State,
    add: impl FnOnce(&mut crate::scene::Scene, &mut Form<'_>),
) {
    let faults: &[SceneError] = state.refusal.as_ref().map_or(&[], |it| &it.faults);
    let Panels { complaint, .. } = &mut state.panels;
    add(&mut state.document.scene, &mut Form::new(complaint, faults));
}
