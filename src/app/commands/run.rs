//! What each command does.

use super::Command;
use crate::app::files::{self, Intent, Saving, export};
use crate::app::panels::settings_id;
use crate::app::platform::{Errand, PictureKind};
use crate::app::sheets::Sheet;
use crate::app::state::{Rescale, Selection, State, Views};
use eframe::egui::{Context, Popup, Theme, ThemePreference, ViewportCommand};

/// Runs a command, if it would do anything.
pub fn run(command: Command, state: &mut State, ctx: &Context) {
    if !command.is_enabled(state) {
        return;
    }
    let scene = &mut state.document.scene;
    match command {
        Command::New => files::request(state, Intent::New, ctx),
        Command::Open => files::pick(state, Errand::Scene),
        Command::Examples => state.sheets.show(Sheet::Gallery),
        Command::Save => files::save(state, Saving::InPlace, None),
        Command::SaveAs => files::save(state, Saving::As, None),
        Command::ImportMeasurements => files::pick(state, Errand::Measurements),
        Command::PlacePhoto => files::pick(state, Errand::Photo),
        Command::ExportSvg => export::picture(state, PictureKind::Svg, ctx),
        Command::ExportPng => export::picture(state, PictureKind::Png, ctx),
        Command::CopyLink => export::copy_link(state, ctx),
        Command::PasteLink => ctx.send_viewport_cmd(ViewportCommand::RequestPaste),
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
        Command::Fit => state.canvas.fit_soon(),
        Command::Outline => state.preferences.outline ^= true,
        Command::Dock => state.preferences.dock ^= true,
        Command::Field => state.preferences.field ^= true,
        Command::Grid => state.preferences.grid ^= true,
        Command::Trace => {
            state.preferences.trace ^= true;
            state.redraw();
        }
        Command::ViewPlane => state.preferences.views = Views::Plane,
        Command::ViewSpace => state.preferences.views = Views::Space,
        Command::ViewBoth => state.preferences.views = Views::Both,
        Command::Larger => state.preferences.rescale(Rescale::Larger),
        Command::Smaller => state.preferences.rescale(Rescale::Smaller),
        Command::UsualSize => state.preferences.rescale(Rescale::Usual),
        Command::Palette => state.sheets.show(Sheet::Palette),
        Command::Settings => Popup::open_id(ctx, settings_id()),
        Command::Help => state.sheets.show(Sheet::Help),
        Command::Theme => {
            state.preferences.theme = match ctx.theme() {
                Theme::Dark => ThemePreference::Light,
                Theme::Light => ThemePreference::Dark,
            };
        }
    }
}
