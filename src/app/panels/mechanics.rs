//! Which mechanics the scene is solved in, with the switch, what keeps it from being
//! switched, and both models side by side.

use crate::app::commands::Command;
use crate::app::look::{Segment, Tokens, icon, icons, segments, semibold};
use crate::app::widgets::row;
use crate::app::words;
use crate::app::workbench::Workbench;
use crate::equilibrium::Solved;
use crate::mechanics::Model;
use crate::units::{grams, millimetres, per_millimetre};
use crate::view::Quantity;
use eframe::egui::{self, Align, Label, Rect, RichText, Role, Ui, WidgetInfo, pos2, vec2};

/// Width of the button for both, in points, and the room before it.
const BOTH: f32 = 48.0;
const GAP: f32 = 8.0;
/// What is told of faults, at most.
const TOLD: usize = 2;
/// Width of a column of numbers and of their unit, and height of a row, in points.
const COLUMN: f32 = 62.0;
const UNIT: f32 = 24.0;
const ROW: f32 = 20.0;

/// Shows the switch, and what there is to say of it.
pub fn show(ui: &mut Ui, bench: &mut Workbench) {
    row::heading(ui, "Mechanics");
    ui.add_space(2.0);
    switch(ui, bench);
    let faults = bench.other.faults();
    if !faults.is_empty() {
        let to = match bench.model() {
            Model::Sliding => "The paper’s model cannot take this scene.",
            Model::Equal => "A sliding cable cannot take this scene.",
        };
        let why: Vec<String> = faults.iter().take(TOLD).map(words::obstacle_to).collect();
        let more = faults.len().saturating_sub(TOLD);
        let more = match more {
            0 => String::new(),
            more => format!(" And {more} more."),
        };
        note(ui, icons::INFO, &format!("{to} {}{more}", why.join(" ")));
    }
    if bench.model() == Model::Equal && bench.document.stiffness().is_some() {
        note(
            ui,
            icons::WARNING,
            "The paper’s cable cannot slide, so its contact forces are too small, near first \
             contact 6 to 40 times.",
        );
    }
    if bench.preferences.compare && bench.other.faults().is_empty() {
        ui.add_space(4.0);
        side_by_side(ui, bench);
    }
    ui.add_space(16.0);
}

fn switch(ui: &mut Ui, bench: &mut Workbench) {
    let current = match bench.model() {
        Model::Sliding => 0,
        Model::Equal => 1,
    };
    let possible = bench.allows(Command::Mechanics);
    let tip = |words: &str| Command::Mechanics.tip_saying(words, ui.ctx());
    let shown = [
        Segment {
            name: "Sliding cable",
            title: "Let the cable slide",
            tip: tip("The cable slides through its disks: forces that a load cell would show"),
            enabled: possible || current == 0,
        },
        Segment {
            name: "Paper’s model",
            title: "Take the paper’s model",
            tip: tip("Every segment of the cable shortens alike, as in the paper"),
            enabled: possible || current == 1,
        },
    ];
    let compare = bench.preferences.compare;
    let both = [Segment {
        name: "Both",
        title: Command::Compare.entry().title,
        tip: Command::Compare.tip_saying(
            "Draw the shape in the other model, too, with its numbers beside this one’s",
            ui.ctx(),
        ),
        enabled: possible,
    }];
    ui.horizontal(|ui| {
        ui.spacing_mut().item_spacing.x = GAP;
        // The rails end two points after their names.
        let width = (ui.available_width() - BOTH - GAP - 8.0) / 2.0;
        let chosen = segments(ui, width, &shown, Some(current));
        if chosen.is_some_and(|chosen| chosen != current) {
            bench.commands.push(Command::Mechanics);
        }
        if segments(ui, BOTH, &both, compare.then_some(0)).is_some() {
            bench.commands.push(Command::Compare);
        }
    });
}

fn note(ui: &mut Ui, glyph: &str, text: &str) {
    let tokens = Tokens::in_ui(ui);
    let ink = if glyph == icons::WARNING {
        tokens.warning
    } else {
        tokens.muted
    };
    ui.add_space(4.0);
    ui.horizontal_top(|ui| {
        ui.spacing_mut().item_spacing.x = 6.0;
        ui.label(icon(glyph).size(14.0).color(ink));
        let text = RichText::new(text).small().color(tokens.muted);
        ui.add(Label::new(text).wrap());
    });
}

/// A line of the comparison: its name, and both values.
struct Line {
    name: String,
    unit: &'static str,
    values: [String; 2],
}

/// The live robot and the other one, number by number.
fn side_by_side(ui: &mut Ui, bench: &Workbench) {
    let (Some(live), Some(other)) = (bench.live.solution(), bench.other.solved()) else {
        ui.weak("Solving…");
        return;
    };
    if live.nodes.is_empty() || other.nodes.is_empty() {
        return;
    }
    let (left, right) = match live.problem().model() {
        Model::Sliding => ("Slides", "Paper’s"),
        Model::Equal => ("Paper’s", "Slides"),
    };
    let tokens = Tokens::in_ui(ui);
    let unit = |unit: &str| RichText::new(unit.to_owned()).small().color(tokens.muted);
    cells(
        ui,
        "",
        [
            RichText::new(left).font(semibold(12.0)),
            RichText::new(right).small().color(tokens.other),
        ],
        unit(""),
        &format!("{left} beside {right}"),
    );
    for line in lines(bench, live, other) {
        let [here, there] = &line.values;
        let (name, unit_word) = (&line.name, line.unit);
        let told = format!("{name}: {left} {here} {unit_word}, {right} {there} {unit_word}");
        cells(
            ui,
            &line.name,
            [
                RichText::new(here).font(semibold(12.0)),
                RichText::new(there).small().color(tokens.other),
            ],
            unit(line.unit),
            &told,
        );
    }
}

/// A row of the comparison: a name, both values in columns, and their unit.
fn cells(ui: &mut Ui, name: &str, values: [RichText; 2], unit: RichText, told: &str) {
    let size = vec2(ui.available_width(), ROW);
    let (rect, response) = ui.allocate_exact_size(size, egui::Sense::hover());
    response.widget_info(|| WidgetInfo::labeled(Role::Label, true, told));
    let muted = Tokens::in_ui(ui).muted;
    let from = |right: f32, width: f32| {
        let left = rect.right() - right - width;
        Rect::from_min_size(pos2(left, rect.top()), vec2(width, ROW))
    };
    let [here, there] = values;
    row::text(ui, from(0.0, UNIT), unit, Align::Min);
    row::text(ui, from(UNIT + 4.0, COLUMN), there, Align::Max);
    row::text(ui, from(UNIT + COLUMN + 8.0, COLUMN), here, Align::Max);
    let used = UNIT + 2.0 * COLUMN + 12.0;
    let name = RichText::new(name).small().color(muted);
    let place = from(used, (rect.width() - used).max(0.0));
    row::text(ui, place, name, Align::Min);
}

fn lines(bench: &Workbench, live: &Solved, other: &Solved) -> Vec<Line> {
    let both = [live, other];
    let mm = |of: &dyn Fn(&Solved) -> f64| {
        both.map(|it| Quantity::fixed(millimetres(of(it)), 2, "").digits)
    };
    let mut lines = vec![
        Line {
            name: "Tip x".to_owned(),
            unit: "mm",
            values: mm(&|it| it.tip().position.x),
        },
        Line {
            name: "Tip y".to_owned(),
            unit: "mm",
            values: mm(&|it| it.tip().position.y),
        },
    ];
    let newtons = bench.document.newtons_per_multiplier();
    // Without a stiffness, in rad²/mm, which has no room.
    let unit = if newtons.is_some() { "g" } else { "" };
    let digits = |multiplier: f64| match newtons {
        Some(newtons) => force_digits(grams(newtons * multiplier)),
        None => Quantity::significant(per_millimetre(multiplier), "").digits,
    };
    lines.push(Line {
        name: "Tension T".to_owned(),
        unit,
        values: both.map(|it| digits(it.energy_slope())),
    });
    let count = live.problem().obstacles().len();
    for index in 0..count {
        let on = both.map(|it| {
            let on = it.contacts.iter().filter(|on| on.obstacle == index);
            on.map(|contact| contact.multiplier).sum::<f64>()
        });
        if on.iter().any(|force| *force > 0.0) {
            lines.push(Line {
                name: words::obstacle_of(&bench.document.scene, index),
                unit,
                values: on.map(digits),
            });
        }
    }
    lines
}

/// A force in g to a tenth, or to more digits where that would be next to nothing.
fn force_digits(grams: f64) -> String {
    if grams.abs() >= 10.0 || grams == 0.0 {
        Quantity::fixed(grams, 1, "").digits
    } else {
        Quantity::fixed(grams, 2, "").digits
    }
}
