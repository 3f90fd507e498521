//! The cables that slide: where each lies, what of it is held, and what the solver
//! finds of it.

use crate::app::look::{Segment, icon, icons, segments};
use crate::app::widgets::{Form, Kind, Number, row, with_form};
use crate::app::workbench::{Held, Workbench};
use crate::equilibrium::Solved;
use crate::scene::limits::{
    AXIAL_STIFFNESS, CABLE_SIDE, CABLES, LINE_DIAMETER, LOAD, PULL, TO_DISK,
};
use crate::scene::{Cable, Drive, Mechanics, Scene};
use crate::units::grams;
use crate::view::Quantity;
use eframe::egui::{Button, RichText, Ui, vec2};

/// Shows what is held and found of each cable, with the fields of those that have
/// their own; nothing in the paper's model.
pub(super) fn show(ui: &mut Ui, bench: &mut Workbench) {
    if bench.document.scene.model.mechanics == Mechanics::Equal {
        return;
    }
    let count = bench.document.scene.cable_count();
    for cable in 0..count {
        one(ui, bench, cable, count);
    }
    more(ui, bench, count);
    ui.add_space(12.0);
}

fn one(ui: &mut Ui, bench: &mut Workbench, cable: usize, count: usize) {
    let name = match count {
        1 => "Cable".to_owned(),
        _ => format!("Cable {}", cable + 1),
    };
    row::heading(ui, &name);
    ui.push_id(("cable", cable), |ui| {
        if !bench.document.scene.cables.is_empty() {
            with_form(bench, |scene, form| place(ui, form, scene, cable));
        }
        held(ui, bench, cable);
        found(ui, bench, cable);
    });
    ui.add_space(8.0);
}

/// Where the cable lies and what it is made of.
fn place(ui: &mut Ui, form: &mut Form<'_>, scene: &mut Scene, index: usize) {
    let last = scene.last_disk();
    let path = |key: &str| format!("cable[{index}].{key}");
    let cable = &mut scene.cables[index];
    let number = Number {
        symbol: "a",
        ..Number::length(path("offset_mm"), "Cable offset", CABLE_SIDE)
    };
    form.number(ui, &number, &mut cable.offset_mm);
    let number = Number {
        kind: Kind::Count,
        ..Number::length(path("to_disk"), "Ends at disk", TO_DISK)
    };
    let mut disk = cable.to_disk.unwrap_or(last);
    if form.count(ui, &number, &mut disk) {
        cable.to_disk = (disk != last).then_some(disk);
    }
    let number = Number::length(path("diameter_mm"), "Cable diameter", LINE_DIAMETER);
    form.number(ui, &number, &mut cable.diameter_mm);
    let number = Number {
        symbol: "EA",
        kind: Kind::Plain,
        optional: true,
        ..Number::length(
            path("axial_stiffness_n"),
            "Axial stiffness",
            AXIAL_STIFFNESS,
        )
    };
    form.optional(ui, &number, &mut cable.axial_stiffness_n);
}

/// What of the cable is held, with its value.
fn held(ui: &mut Ui, bench: &mut Workbench, cable: usize) {
    let held = bench.held(cable);
    let known = bench.document.stiffness().is_some();
    let shown = [
        Segment {
            name: "Hold pull",
            title: "Hold the pull",
            tip: "The pull stays as it is set; the load is found".to_owned(),
            enabled: true,
        },
        Segment {
            name: "Hold load",
            title: "Hold the load",
            tip: match known {
                true => "The load stays as it is set; the pull is found".to_owned(),
                false => "A load can be held where the robot’s stiffness is known".to_owned(),
            },
            enabled: known,
        },
    ];
    let current = usize::from(held == Held::Load);
    let width = (ui.available_width() - 4.0) / 2.0;
    let chosen = segments(ui, width, &shown, Some(current));
    if chosen.is_some_and(|chosen| chosen != current) {
        let other = match held {
            Held::Pull => Held::Load,
            Held::Load => Held::Pull,
        };
        bench.hold(cable, other);
    }
    with_form(bench, |scene, form| {
        let drive = scene.cable(cable).drive;
        let path = scene.cable_field(cable, drive.key());
        match drive {
            Drive::PullMm(mut pull_mm) => {
                let number = Number {
                    symbol: "l",
                    ..Number::length(path, "Pull", PULL)
                };
                if form.number(ui, &number, &mut pull_mm) {
                    scene.set_drive(cable, Drive::PullMm(pull_mm));
                }
            }
            Drive::LoadG(mut load_g) => {
                let number = Number {
                    symbol: "P",
                    kind: Kind::Plain,
                    ..Number::length(path, "Load", LOAD)
                };
                if form.number(ui, &number, &mut load_g) {
                    scene.set_drive(cable, Drive::LoadG(load_g));
                }
            }
        }
    });
}

/// What the solver finds of the cable.
fn found(ui: &mut Ui, bench: &Workbench, cable: usize) {
    if bench.held(cable) == Held::Load {
        let pull = Quantity::fixed(bench.pull_mm_of(cable), 2, "mm");
        row::fact(ui, "Pull found", "l", &pull);
    }
    let Some(state) = bench.found(cable) else {
        return;
    };
    let rubs = |solved: &Solved| !solved.drive.friction.is_none();
    if !state.is_slack
        && bench.live.solution().is_some_and(rubs)
        && let Some(load) = bench.document.force(state.load)
    {
        // With friction it is not the tension.
        row::fact(ui, "Load below base", "P", &load);
    }
    if state.is_slack {
        let word = Quantity {
            digits: "slack".to_owned(),
            unit: "",
        };
        row::fact(ui, "Tension", "T", &word);
    } else if let Some(newtons) = bench.document.newtons_per_multiplier() {
        let force = newtons * state.tension;
        row::fact(ui, "Tension", "T", &Quantity::fixed(grams(force), 1, "g"));
        row::fact(ui, "", "", &Quantity::significant(force, "N"));
    }
}

/// Adds a cable on the other side, or takes the last one away.
fn more(ui: &mut Ui, bench: &mut Workbench, count: usize) {
    let known = bench.document.stiffness().is_some();
    ui.horizontal(|ui| {
        ui.spacing_mut().item_spacing = vec2(8.0, 0.0);
        let tip = match known {
            true => "Adds a cable on the other side of the backbone, with nothing on it yet",
            false => "A cable that hangs loose needs a robot whose stiffness is known",
        };
        let response = ui
            .add_enabled(
                known && count < CABLES,
                Button::new((icon(icons::PLUS), RichText::new("Add a cable"))),
            )
            .on_hover_text(tip)
            .on_disabled_hover_text(tip);
        if response.clicked() {
            let scene = &mut bench.document.scene;
            into_list(scene);
            let first = scene.cables[0];
            scene.cables.push(Cable {
                offset_mm: -first.offset_mm,
                drive: Drive::LoadG(0.0),
                ..first
            });
            bench.transport.cable = scene.cables.len() - 1;
        }
        if count > 1 && ui.button("Remove the last").clicked() {
            bench.document.scene.cables.pop();
        }
    });
}

/// Describes the cable that is described with the robot in a list of its own.
fn into_list(scene: &mut Scene) {
    if scene.cables.is_empty() {
        scene.cables = scene.each_cable().collect();
        scene.actuation = None;
        scene.robot.cable_offset_mm = None;
        scene.robot.cable_diameter_mm = 0.0;
    }
}
