//! Where the parts are: panels around the canvas, or below it where the window
//! is narrow; the views of the robot in what is left.

use super::Sinew;
use crate::app::look::{Segment, Tokens, icon_button, icons, segments};
use crate::app::workbench::Views;
use crate::app::{canvas, dock, panels, space};
use eframe::egui::{Align, CentralPanel, Context, Frame, Layout, Margin, Panel, Ui};

/// Windows that are narrower than this, in points, have no room for the
/// outline.
const NARROW: f32 = 640.0;

/// Windows that are narrower than this, in points, have no room for the dock.
const WIDE: f32 = 960.0;

/// A panel beside the canvas, or below it where the window is narrow.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum SidePanel {
    /// Outline and inspector.
    Outline,
    /// Plots and tables.
    Dock,
}

impl SidePanel {
    /// Whether a window of this width, in points, has no room beside its canvas.
    fn is_below(self, width: f32) -> bool {
        match self {
            SidePanel::Outline => width < NARROW,
            SidePanel::Dock => width < WIDE,
        }
    }
}

impl Sinew {
    /// Shows or hides a panel, which below the canvas is never there at first.
    pub(super) fn toggle(&mut self, panel: SidePanel, ctx: &Context) {
        if panel.is_below(ctx.content_rect().width()) {
            self.below = (self.below != Some(panel)).then_some(panel);
        } else {
            let preferences = &mut self.bench.preferences;
            let shown = match panel {
                SidePanel::Outline => &mut preferences.outline,
                SidePanel::Dock => &mut preferences.dock,
            };
            *shown ^= true;
        }
    }

    /// Shows all parts that are open.
    pub(super) fn show(&mut self, ui: &mut Ui) {
        let tokens = Tokens::in_ui(ui);
        let frame = |x: i8, y: i8| {
            Frame::new()
                .fill(tokens.panel)
                .inner_margin(Margin::symmetric(x, y))
        };
        Panel::top("bar")
            .frame(frame(12, 6))
            .show(ui, |ui| panels::bar(ui, &mut self.bench));
        panels::restore(ui, &mut self.bench);
        Panel::bottom("transport")
            .frame(frame(12, 8))
            .show(ui, |ui| {
                panels::transport(ui, &mut self.panels, &mut self.bench);
            });
        let width = ui.available_width();
        if let Some(side) = self.below.filter(|side| side.is_below(width)) {
            Panel::bottom("below")
                .frame(Frame::new().fill(tokens.panel))
                .default_size(0.5 * ui.available_height())
                .size_range(160.0..=0.7 * ui.available_height())
                .show(ui, |ui| self.below(ui, side, width));
        }
        let preferences = &self.bench.preferences;
        let (outline, docked) = (preferences.outline, preferences.dock);
        if outline && !SidePanel::Outline.is_below(width) {
            Panel::left("outline")
                .frame(frame(12, 12))
                .default_size(260.0)
                .size_range(220.0..=0.4 * width)
                .show(ui, |ui| {
                    panels::scene(ui, &mut self.panels, &mut self.bench);
                });
        }
        if docked && !SidePanel::Dock.is_below(width) {
            Panel::right("dock")
                .frame(Frame::new().fill(tokens.panel))
                .default_size(0.27 * width)
                .size_range(280.0..=0.6 * width)
                .show(ui, |ui| dock::show(ui, &mut self.dock, &mut self.bench));
        }
        panels::certificate(ui, &mut self.panels, &mut self.bench);
        CentralPanel::no_frame().show(ui, |ui| self.views(ui));
    }

    /// What is open below the canvas, with the way back.
    fn below(&mut self, ui: &mut Ui, side: SidePanel, width: f32) {
        let sides = [(SidePanel::Outline, "Scene"), (SidePanel::Dock, "Plots")];
        let sides: Vec<_> = sides
            .into_iter()
            .filter(|it| it.0.is_below(width))
            .collect();
        let margin = Margin::symmetric(12, 6);
        Frame::new().inner_margin(margin).show(ui, |ui| {
            ui.horizontal(|ui| {
                let shown = sides.iter().map(|(_, name)| Segment {
                    name,
                    title: name,
                    tip: (*name).to_owned(),
                    enabled: true,
                });
                let shown: Vec<_> = shown.collect();
                let current = sides.iter().position(|it| it.0 == side);
                if let Some(chosen) = segments(ui, 72.0, &shown, current) {
                    self.below = Some(sides[chosen].0);
                }
                ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
                    if icon_button(ui, icons::X, "Close").clicked() {
                        self.below = None;
                    }
                });
            });
        });
        match side {
            SidePanel::Dock => dock::show(ui, &mut self.dock, &mut self.bench),
            SidePanel::Outline => {
                let margin = Margin::symmetric(12, 4);
                Frame::new().inner_margin(margin).show(ui, |ui| {
                    panels::scene(ui, &mut self.panels, &mut self.bench)
                });
            }
        }
    }

    /// The open views of the robot, in all the room there is.
    fn views(&mut self, ui: &mut Ui) {
        // What the panels did may have closed a sheet, or opened one.
        self.cover();
        match self.bench.preferences.views {
            Views::Plane => self.plane(ui),
            Views::Space => space::show(ui, &mut self.space, &mut self.bench),
            Views::Both => {
                let width = 0.5 * ui.available_width();
                Panel::right("space")
                    .frame(Frame::NONE)
                    .default_size(width)
                    .size_range(0.25 * width..=1.6 * width)
                    .show(ui, |ui| {
                        space::show(ui, &mut self.space, &mut self.bench);
                    });
                CentralPanel::no_frame().show(ui, |ui| self.plane(ui));
            }
        }
    }

    fn plane(&mut self, ui: &mut Ui) {
        canvas::show(ui, &mut self.canvas, &mut self.bench);
        self.bench.is_in_hand = self.canvas.is_giving_up_something();
    }
}
