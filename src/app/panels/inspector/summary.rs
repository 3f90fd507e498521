//! What is known of the scene and of the robot's shape, while nothing is
//! selected.

use crate::app::look::semibold;
use crate::app::panels::status::Verdict;
use crate::app::widgets::{row, with_form};
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
    row::fact(ui, "Multipliers", "Σ λ", &written);
    let tension = solution.energy_slope();
    let forces = [total, tension].map(|it| bench.document.force(it));
    if let [Some(total), Some(tension)] = forces {
        row::fact(ui, "Forces", "Σ F", &total);
        ui.add_space(12.0);
        row::heading(ui, "Cable");
        row::fact(ui, "Tension", "T", &tension);
    }
}

fn word(word: &str) -> Quantity {
    Quantity {
        digits: word.to_owned(),
        unit: "",
    }
}
