//! What each command does.

use super::Command;
use crate::app::dock::Dock;
use crate::app::files::{self, Intent, Saving, export};
use crate::app::panels::{Side, settings_id};
use crate::app::platform::{Errand, PictureKind};
use crate::app::shapes::copied;
use crate::app::sheets::Sheet;
use crate::app::state::{Rescale, Selection, State, Views};
use crate::scene::Obstacle;
use eframe::egui::{Context, Popup, Theme, ThemePreference, ViewportCommand};

/// Arranges the plots, and shows them.
fn arrange(state: &mut State, how: impl FnOnce(&mut Dock)) {
    state.preferences.dock = true;
    if let Some(dock) = &mut state.dock {
        how(dock);
    }
}

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
        Command::Duplicate => {
            let original = state.selection.obstacle();
            if let Some(original) = original.and_then(|index| scene.obstacles.get(index)) {
                let copy = Obstacle {
                    name: original.name.as_ref().map(|name| format!("{name} copy")),
                    shape: copied(&original.shape, &scene.robot),
                };
                scene.obstacles.push(copy);
                state.selection = Selection::Obstacle(scene.obstacles.len() - 1);
            }
        }
        Command::Delete if state.selection == Selection::Photo => {
            scene.photo = None;
            state.selection = Selection::Nothing;
        }
        Command::Delete if state.selection == Selection::Measured => {
            scene.measured = None;
            state.selection = Selection::Nothing;
        }
        Command::Delete => {
            if let Some(index) = state.selection.obstacle()
                && let Some(obstacle) = scene.obstacles.get_mut(index)
                && !state.canvas.remove_vertex(index, &mut obstacle.shape)
            {
                scene.obstacles.remove(index);
                state.selection = Selection::Nothing;
            }
        }
        Command::Deselect => {
            if state.photos.scaling.take().is_none() && !state.canvas.give_up(scene) {
                state.selection = Selection::Nothing;
            }
        }
        Command::Tool(tool) => state.canvas.take_tool(tool),
        Command::Play => {
            let span = state.span_mm();
            let pull_mm = &mut state.document.scene.actuation.pull_mm;
            state.transport.toggle(pull_mm, span);
        }
        Command::FromStraight => state.restart(),
        Command::Load => state.transport.by_load ^= true,
        Command::Fit => {
            state.canvas.fit_soon();
            state.space.fit_soon();
        }
        Command::ViewPlane => state.preferences.views = Views::Plane,
        Command::ViewSpace => state.preferences.views = Views::Space,
        Command::ViewBoth => state.preferences.views = Views::Both,
        Command::Outline => Side::Outline.toggle(state, ctx),
        Command::Dock => Side::Dock.toggle(state, ctx),
        Command::GroupPlots => arrange(state, Dock::group),
        Command::SpreadPlots => arrange(state, Dock::spread),
        Command::Field => state.preferences.field ^= true,
        Command::Grid => state.preferences.grid ^= true,
        Command::Trace => {
            state.preferences.trace ^= true;
            state.redraw();
        }
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
