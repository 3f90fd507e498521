//! What each command does.

use super::Command;
use crate::app::state::{Selection, State, Views};
use eframe::egui::{Context, Theme, ThemePreference};

/// Runs a command, if it would do anything.
pub fn run(command: Command, state: &mut State, ctx: &Context) {
    if !command.is_enabled(state) {
        return;
    }
    let scene = &mut state.document.scene;
    match command {
        Command::Undo => {
            state.transport.stop();
            state.history.undo(scene);
        }
        Command::Redo => {
            state.transport.stop();
            state.history.redo(scene);
        }
        Command::Delete => {
            if let Some(index) = state.selection.obstacle() {
                scene.obstacles.remove(index);
                state.selection = Selection::Nothing;
            }
        }
        Command::Deselect => state.selection = Selection::Nothing,
        Command::Play => {
            let span = state.span_mm();
            let pull_mm = &mut state.document.scene.actuation.pull_mm;
            state.transport.toggle(pull_mm, span);
        }
        Command::FromStraight => state.restart(),
        Command::Fit => {
            state.canvas.fit_soon();
            state.space.fit_soon();
        }
        Command::ViewPlane => state.preferences.views = Views::Plane,
        Command::ViewSpace => state.preferences.views = Views::Space,
        Command::ViewBoth => state.preferences.views = Views::Both,
        Command::Outline => state.preferences.outline ^= true,
        Command::Dock => state.preferences.dock ^= true,
        Command::Field => state.preferences.field ^= true,
        Command::Grid => state.preferences.grid ^= true,
        Command::Trace => {
            state.preferences.trace ^= true;
            state.redraw();
        }
        Command::Theme => {
            state.preferences.theme = match ctx.theme() {
                Theme::Dark => ThemePreference::Light,
                Theme::Light => ThemePreference::Dark,
            };
        }
    }
}
