//! What is known of the scene and of the robot's shape, while nothing is
//! selected.

use crate::app::look::semibold;
use crate::app::panels::status::Verdict;
use crate::app::widgets::{row, understated, with_form};
use crate::app::workbench::Workbench;
use crate::units::{degrees, millimetres, per_millimetre};
use crate::view::Quantity;
use eframe::egui::{RichText, Ui};

/// Shows the summary.
pub fn show(ui: &mut Ui, bench: &mut Workbench) {
    ui.label(RichText::new("Scene").font(semibold(14.0)));
    ui.add_space(4.0);
    with_form(bench, |scene, form| {
        form.text(ui, "title", "Title", &mut scene.title);
    });
    ui.add_space(12.0);
    row::heading(ui, "Shape");
    let Some(shape) = bench.live.shape() else {
        row::fact(ui, "Status", "", &word("Solving…"));
        return;
    };
    let solution = &shape.solved;
    let mm = |value: f64| Quantity::fixed(millimetres(value), 2, "mm");
    row::fact(ui, "Status", "", &word(Verdict::of(&bench.live).word()));
    row::fact(ui, "Pull", "l", &mm(solution.pull));
    if let Some(asked) = bench.document.scene.cable(0).drive.pull_mm()
        && bench.reached(0).is_some()
    {
        row::fact(ui, "Asked", "", &Quantity::fixed(asked, 2, "mm"));
    }
    if let [base, .., tip] = solution.nodes.as_slice() {
        // Clockwise, as the robot bends when it is pulled.
        let bend = base.angle - tip.angle;
        row::fact(ui, "Tip", "x", &mm(tip.position.x));
        row::fact(ui, "Tip", "y", &mm(tip.position.y));
        row::fact(ui, "Bend", "Σ β", &Quantity::fixed(degrees(bend), 1, "°"));
    }
    ui.add_space(12.0);
    row::heading(ui, "Contact");
    let count = solution.contacts.len() as f64;
    let total: f64 = solution.contacts.iter().map(|it| it.multiplier).sum();
    row::fact(ui, "Contacts", "", &Quantity::fixed(count, 0, ""));
    let written = Quantity::significant(per_millimetre(total), "rad²/mm");
    let force = bench.document.force(total);
    match &force {
        // The paper's units say less: they change with the number of segments.
        Some(total) => row::fact(ui, "Forces", "Σ F", total),
        None => row::fact(ui, "Multipliers", "Σ λ", &written),
    }
    let count = solution.cables.len();
    let rubs = !solution.drive.friction.is_none();
    let cables = solution.cables.iter().enumerate();
    let cables: Vec<_> = cables
        .map(|(index, cable)| {
            let name = |word: &str| match count {
                1 => word.to_owned(),
                _ => format!("{word} {}", index + 1),
            };
            // Without friction what hangs on it is its tension.
            let load = bench.document.force(cable.load).filter(|_| rubs);
            let load = load.map(|load| (name("Load"), load));
            let tension = bench.document.force(cable.tension);
            (load, name("Tension"), tension, cable.is_slack)
        })
        .collect();
    if force.is_none() {
        return;
    }
    understated(ui, bench);
    ui.add_space(12.0);
    row::heading(ui, "Cable");
    for (load, name, tension, is_slack) in &cables {
        if let Some((name, load)) = load {
            row::fact(ui, name, "P", load);
        }
        match tension {
            _ if *is_slack => row::fact(ui, name, "T", &word("slack")),
            Some(tension) => row::fact(ui, name, "T", tension),
            None => {}
        }
    }
}

fn word(word: &str) -> Quantity {
    Quantity {
        digits: word.to_owned(),
        unit: "",
    }
}
