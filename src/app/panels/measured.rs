//! What can be done with the measurements while they are selected: how far the
//! robot is from the measured backbone, the pull that suits it best, and the
//! force readings.

use crate::app::commands::Command;
use crate::app::look::{Tokens, icon, icons, semibold};
use crate::app::measured;
use crate::app::widgets::{button, row};
use crate::app::words::sentence;
use crate::app::workbench::{Selection, Workbench};
use crate::experiments::ShapeFit;
use crate::scene::Measurements;
use crate::units::millimetres;
use crate::view::Quantity;
use eframe::egui::{Align, Grid, Layout, RichText, ScrollArea, Spinner, Ui, vec2};

/// Shows the measurements.
pub fn show(ui: &mut Ui, bench: &mut Workbench) {
    let Some(held) = bench.document.scene.measured.clone() else {
        bench.selection = Selection::Nothing;
        return;
    };
    ui.horizontal(|ui| {
        ui.label(icon(icons::RULER));
        ui.label(RichText::new("Measurements").font(semibold(14.0)));
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            button(ui, bench, Command::Delete);
        });
    });
    ui.add_space(4.0);
    if !held.points_mm.is_empty() {
        backbone(ui, bench, &held);
    }
    if !held.forces.is_empty() {
        ui.add_space(12.0);
        forces(ui, &held);
    }
    ui.add_space(8.0);
    if ui.button("Import another table …").clicked() {
        bench.commands.push(Command::ImportMeasurements);
    }
}

fn backbone(ui: &mut Ui, bench: &mut Workbench, held: &Measurements) {
    row::heading(ui, "Backbone");
    let by = if held.nodes.is_empty() {
        "each against the nearest point"
    } else {
        "each against its node"
    };
    ui.label(
        RichText::new(format!("{} points, {by}", held.points_mm.len()))
            .small()
            .weak(),
    );
    let length = bench.live.problem().length();
    match measured::fit(bench) {
        Some(Ok(fit)) => distances(ui, "shown", fit, length),
        Some(Err(fault)) => {
            let colour = Tokens::in_ui(ui).warning;
            let told = sentence(&fault.to_string());
            ui.label(RichText::new(told).color(colour));
            return;
        }
        None => return,
    }
    ui.add_space(8.0);
    best(ui, bench, length);
}

/// The paper's measure, in mm and as a share of the length.
fn distances(ui: &mut Ui, of: &str, fit: &ShapeFit, length: f64) {
    Grid::new(("distances", of))
        .num_columns(3)
        .spacing(vec2(12.0, 4.0))
        .show(ui, |ui| {
            for (name, distance) in [("RMS distance", fit.rms), ("Greatest", fit.max)] {
                ui.label(name);
                ui.label(Quantity::fixed(millimetres(distance), 2, "mm").text());
                let share = Quantity::fixed(100.0 * distance / length, 2, "%");
                ui.weak(share.text()).on_hover_text("Of the robot's length");
                ui.end_row();
            }
        });
}

/// The pull that suits the backbone best.
fn best(ui: &mut Ui, bench: &mut Workbench, length: f64) {
    if let Some(search) = &bench.measuring.search {
        let share = Quantity::fixed(100.0 * search.share, 0, "%").text();
        ui.horizontal(|ui| {
            ui.add(Spinner::new().size(16.0));
            ui.label("Trying every pull");
            ui.weak(share);
            if ui.button("Stop the search").clicked() {
                measured::cancel(bench);
            }
        });
        return;
    }
    let found = bench
        .measuring
        .best(&bench.document.scene)
        .map(|best| best.fit.clone());
    match found {
        None => {
            if ui.button("Find the best pull").clicked() {
                measured::search(bench, ui.ctx());
            }
        }
        Some(Err(reason)) => {
            let colour = Tokens::in_ui(ui).warning;
            let told = sentence(&reason.to_string());
            ui.label(RichText::new(told).color(colour));
        }
        Some(Ok(fit)) => {
            let pull = Quantity::fixed(millimetres(fit.pull), 2, "mm").text();
            ui.label(format!("Best pull {pull}"));
            distances(ui, "best", &fit, length);
            let there = bench.pull_mm() == millimetres(fit.pull);
            ui.add_space(4.0);
            ui.add_enabled_ui(!there, |ui| {
                if ui.button("Apply").clicked() {
                    measured::apply(bench);
                }
            });
        }
    }
}

fn forces(ui: &mut Ui, held: &Measurements) {
    row::heading(ui, "Force readings");
    ScrollArea::vertical()
        .id_salt("readings")
        .max_height(160.0)
        .show(ui, |ui| {
            Grid::new("readings")
                .num_columns(2)
                .spacing(vec2(24.0, 2.0))
                .show(ui, |ui| {
                    ui.weak("Load, g");
                    ui.weak("Force, g");
                    ui.end_row();
                    for reading in &held.forces {
                        ui.label(Quantity::fixed(reading.load_g, 1, "").text());
                        ui.label(Quantity::fixed(reading.force_g, 1, "").text());
                        ui.end_row();
                    }
                });
        });
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::app::measured::tests::bench;
    use eframe::egui::{Key, accesskit::Role};
    use egui_kittest::Harness;
    use egui_kittest::kittest::Queryable as _;

    const STOP: &str = "Stop the search";

    /// The measurements by themselves. The solver works when it is polled.
    fn panel() -> Harness<'static, Workbench> {
        let mut bench = bench();
        while bench.wants_frames() {
            bench.poll();
        }
        let mut panel = Harness::builder()
            .with_context_setup(crate::app::look::install)
            .build_ui_state(show, bench);
        panel.step();
        panel
    }

    fn begin(panel: &mut Harness<'static, Workbench>) {
        panel.get_by_label("Find the best pull").click();
        panel.step();
        panel.step();
        panel.state_mut().poll();
        assert!(panel.state().measuring.search.is_some());
    }

    fn is_stopped(panel: &mut Harness<'static, Workbench>) {
        assert!(panel.state().measuring.search.is_none());
        while panel.state().wants_frames() {
            panel.state_mut().poll();
        }
        assert!(panel.state().measuring.best.is_none());
        panel.step();
        assert!(panel.query_by_label(STOP).is_none());
    }

    #[test]
    fn a_search_is_stopped_by_a_click() {
        let mut panel = panel();
        begin(&mut panel);
        panel.get_by_role_and_label(Role::Button, STOP).click();
        panel.step();
        panel.step();
        is_stopped(&mut panel);
        begin(&mut panel);
    }

    #[test]
    fn a_search_is_stopped_by_the_keyboard() {
        let mut panel = panel();
        begin(&mut panel);
        panel.get_by_role_and_label(Role::Button, STOP).focus();
        panel.step();
        panel.key_press(Key::Enter);
        panel.step();
        is_stopped(&mut panel);
    }
}
