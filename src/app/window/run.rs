//! What each command does.

use super::Sinew;
use super::layout::SidePanel;
use crate::app::commands::Command;
use crate::app::dock::Dock;
use crate::app::files::{self, Saving, export};
use crate::app::panels::settings_id;
use crate::app::platform::{Errand, PictureKind};
use crate::app::shapes::copied;
use crate::app::sheets::Sheet;
use crate::app::workbench::{Held, Intent, Rescale, Selection, Views, Way};
use crate::scene::Obstacle;
use eframe::egui::{Context, Popup, Theme, ThemePreference, ViewportCommand};

impl Sinew {
    /// Runs a command, if it would do anything.
    pub(super) fn run(&mut self, command: Command, ctx: &Context) {
        let bench = &mut self.bench;
        if !bench.allows(command) {
            return;
        }
        let scene = &mut bench.document.scene;
        match command {
            Command::New => files::request(bench, Intent::New, ctx),
            Command::Open => files::pick(bench, Errand::Scene),
            Command::Examples => self.sheets.open(Sheet::Gallery),
            Command::Save => files::save(bench, Saving::InPlace, None),
            Command::SaveAs => files::save(bench, Saving::As, None),
            Command::ImportMeasurements => files::pick(bench, Errand::Measurements),
            Command::PlacePhoto => files::pick(bench, Errand::Photo),
            Command::ExportSvg => export::picture(bench, PictureKind::Svg, ctx),
            Command::ExportPng => export::picture(bench, PictureKind::Png, ctx),
            Command::CopyLink => export::copy_link(bench, ctx),
            Command::PasteLink => ctx.send_viewport_cmd(ViewportCommand::RequestPaste),
            Command::Undo => {
                bench.transport.stop();
                bench.history.undo(scene);
            }
            Command::Redo => {
                bench.transport.stop();
                bench.history.redo(scene);
            }
            Command::Duplicate => {
                let original = bench.selection.obstacle();
                if let Some(original) = original.and_then(|index| scene.obstacles.get(index)) {
                    let copy = Obstacle {
                        name: original.name.as_ref().map(|name| format!("{name} copy")),
                        shape: copied(&original.shape, &scene.robot),
                    };
                    scene.obstacles.push(copy);
                    bench.selection = Selection::Obstacle(scene.obstacles.len() - 1);
                }
            }
            Command::Delete if bench.selection == Selection::Photo => {
                scene.photo = None;
                bench.selection = Selection::Nothing;
            }
            Command::Delete if bench.selection == Selection::Measured => {
                scene.measured = None;
                bench.selection = Selection::Nothing;
            }
            Command::Delete => {
                if let Some(index) = bench.selection.obstacle()
                    && let Some(obstacle) = scene.obstacles.get_mut(index)
                    && !self.canvas.remove_vertex(index, &mut obstacle.shape)
                {
                    scene.obstacles.remove(index);
                    bench.selection = Selection::Nothing;
                }
            }
            Command::Deselect => {
                if bench.photos.scaling.take().is_none() && !self.canvas.give_up(scene) {
                    bench.selection = Selection::Nothing;
                }
            }
            Command::Tool(tool) => self.canvas.take_tool(tool),
            Command::Play => bench.play_or_pause(),
            Command::FromStraight => bench.restart(),
            Command::NextMark => bench.go_to_mark(Way::Up),
            Command::PreviousMark => bench.go_to_mark(Way::Down),
            Command::Pin => bench.pin(),
            Command::Load => {
                let cable = bench.cable();
                let other = match bench.held(cable) {
                    Held::Pull => Held::Load,
                    Held::Load => Held::Pull,
                };
                bench.hold(cable, other);
            }
            Command::Mechanics => bench.switch_mechanics(),
            Command::Compare => bench.preferences.compare ^= true,
            Command::Fit => {
                bench.trace.clear();
                self.canvas.fit_soon();
                self.space.fit_soon();
            }
            Command::ViewPlane => bench.preferences.views = Views::Plane,
            Command::ViewSpace => bench.preferences.views = Views::Space,
            Command::ViewBoth => bench.preferences.views = Views::Both,
            Command::Outline => self.toggle(SidePanel::Outline, ctx),
            Command::Dock => self.toggle(SidePanel::Dock, ctx),
            Command::GroupPlots => self.arrange(Dock::group),
            Command::SpreadPlots => self.arrange(Dock::spread),
            Command::Field => bench.preferences.field ^= true,
            Command::Grid => bench.preferences.grid ^= true,
            Command::Trace => {
                bench.preferences.trace ^= true;
                bench.redraw();
            }
            Command::Larger => bench.preferences.rescale(Rescale::Larger),
            Command::Smaller => bench.preferences.rescale(Rescale::Smaller),
            Command::UsualSize => bench.preferences.rescale(Rescale::Usual),
            Command::Palette => self.sheets.open(Sheet::Palette),
            Command::Settings => Popup::open_id(ctx, settings_id()),
            Command::Help => self.sheets.open(Sheet::Help),
            Command::Theme => {
                bench.preferences.theme = match ctx.theme() {
                    Theme::Dark => ThemePreference::Light,
                    Theme::Light => ThemePreference::Dark,
                };
            }
        }
        // What it did may have opened a document, or changed what is in hand.
        self.sheets.take_news(&mut self.bench);
        self.bench.is_in_hand = self.canvas.is_giving_up_something();
    }

    /// Arranges the plots, and shows them.
    fn arrange(&mut self, how: impl FnOnce(&mut Dock)) {
        self.bench.preferences.dock = true;
        how(&mut self.dock);
    }
}
