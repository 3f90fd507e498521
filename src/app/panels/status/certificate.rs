//! The certificate: every condition that the shape has to meet, with what is
//! left of it, and how the solver came there.

use super::plot;
use super::verdict::Verdict;
use crate::app::look::{Tokens, icon, icons, semibold};
use crate::app::widgets::row;
use crate::app::words;
use crate::app::workbench::Workbench;
use crate::equilibrium::{Caution, Solution};
use crate::mechanics::{Certificate, Condition, ConditionKind};
use crate::scene::{Candidates, Scene};
use crate::solver::Iteration;
use crate::units::{millimetres, per_millimetre};
use crate::view::Quantity;
use eframe::egui::{
    Align, Align2, Color32, FontId, Label, Layout, RichText, Role, ScrollArea, Sense, Ui,
    WidgetInfo, Window, pos2, vec2,
};

/// The window's width, in points.
const WIDTH: f32 = 440.0;

/// Shows the certificate's window, if it is `open`.
pub fn show(ui: &mut Ui, open: &mut bool, bench: &mut Workbench) {
    let screen = ui.ctx().content_rect();
    let window = Window::new("Certificate")
        .open(open)
        .collapsible(false)
        .resizable([false, true])
        .default_width(WIDTH)
        .default_height(960.0_f32.min(screen.height() - 160.0))
        .pivot(Align2::RIGHT_BOTTOM)
        .default_pos(screen.right_bottom() - vec2(12.0, 60.0));
    window.show(ui.ctx(), |ui| {
        ui.set_width(WIDTH.min(screen.width() - 64.0));
        ScrollArea::vertical()
            .auto_shrink([false, true])
            .show(ui, |ui| contents(ui, bench));
    });
}

fn contents(ui: &mut Ui, bench: &mut Workbench) {
    let Some(solution) = bench.live.solution() else {
        ui.label("The solver is looking for the robot's shape.");
        return;
    };
    let scene = &bench.document.scene;
    verdict(ui, bench, solution, scene);
    let wants_body = cautions(ui, bench.live.cautions(), scene);
    ui.add_space(16.0);
    row::heading(ui, "Optimality, recomputed from the node positions");
    if bench.reached(0).is_some() {
        let pull = Quantity::fixed(millimetres(solution.pull), 2, "mm").text();
        ui.weak(format!(
            "Of the shape that was reached, at a pull of {pull}."
        ));
    }
    ui.add_space(4.0);
    conditions(ui, &solution.certificate);
    ui.add_space(16.0);
    row::heading(ui, &iterations(solution.trace.len(), solution.iterations));
    ui.add_space(4.0);
    plot::show(ui, &solution.trace);
    ui.add_space(8.0);
    trace(ui, &solution.trace);
    if !solution.events.is_empty() {
        ui.add_space(16.0);
        row::heading(ui, "On the way");
        ui.add_space(4.0);
        events(ui, solution, scene);
    }
    if wants_body {
        let contact = &mut bench.document.scene.contact;
        contact.candidates = Candidates::Body;
        contact.listed.clear();
    }
}

/// Shows what the certificate does not promise; whether the whole body is to
/// touch from now on.
fn cautions(ui: &mut Ui, cautions: &[Caution], scene: &Scene) -> bool {
    let warning = Tokens::in_ui(ui).warning;
    for caution in cautions {
        ui.add_space(8.0);
        ui.horizontal_top(|ui| {
            ui.label(icon(icons::WARNING).color(warning));
            ui.add(Label::new(words::caution(caution, scene)).wrap());
        });
    }
    let helps = cautions.iter().any(|caution| caution.remedy().is_some());
    helps
        && ui
            .button("Let the whole body touch")
            .on_hover_text("Obstacles keep out the body at its own size, and not only nodes")
            .clicked()
}

/// Iterations of the last solve, and of all on the way to the shape.
fn iterations(last: usize, all: usize) -> String {
    let word = if last == 1 { "iteration" } else { "iterations" };
    match all > last {
        true => format!("Last solve, {last} {word} of {all} on the whole way here"),
        false => format!("Last solve, {last} {word}"),
    }
}

fn verdict(ui: &mut Ui, bench: &Workbench, solution: &Solution, scene: &Scene) {
    let verdict = Verdict::of(&bench.live);
    let ink = verdict.colour(&Tokens::in_ui(ui));
    ui.horizontal(|ui| {
        ui.label(icon(verdict.icon()).color(ink));
        ui.label(
            RichText::new(verdict.word())
                .font(semibold(14.0))
                .color(ink),
        );
    });
    let text = match verdict {
        Verdict::Solving => "The solver is looking for the robot's shape.".to_owned(),
        _ => words::outcome(solution, scene),
    };
    ui.add(Label::new(text).wrap());
}

fn conditions(ui: &mut Ui, certificate: &Certificate) {
    for (condition, value) in certificate.conditions() {
        show_condition(ui, condition, value);
    }
    ui.add_space(8.0);
    let slope = Quantity::significant(per_millimetre(certificate.energy_slope), "rad²/mm");
    row::fact(ui, "Energy slope", "dJ/dl", &slope);
    small(
        ui,
        "How fast the least energy rises with the pull: times the bending stiffness over twice \
         a segment's length, the cable's tension.",
        0.0,
    );
}

/// A condition with what is left of it, and what that has to stay below, or
/// with whether it is met.
fn show_condition(ui: &mut Ui, condition: Condition, value: f64) {
    let is_met = condition.is_met(value);
    let (value, bound) = match condition.kind() {
        ConditionKind::Residual => {
            let bound = Quantity::order(Condition::BOUND, "").digits;
            let bound = format!("≤ {}", bound.trim_start_matches("1×"));
            (Quantity::significant(value, "").digits, bound)
        }
        ConditionKind::YesOrNo(_) => {
            let answer = if is_met { "yes" } else { "no" };
            (answer.to_owned(), String::new())
        }
    };
    let tokens = Tokens::in_ui(ui);
    let size = vec2(ui.available_width(), 22.0);
    let (rect, response) = ui.allocate_exact_size(size, Sense::hover());
    response.widget_info(|| {
        let name = condition.name();
        WidgetInfo::labeled(Role::Label, true, format!("{name} {value} {bound}"))
    });
    let (glyph, ink) = match is_met {
        true => (icons::CHECK, tokens.good),
        false => (icons::X, tokens.error),
    };
    let body = FontId::proportional(14.0);
    let small_font = FontId::proportional(12.0);
    let y = rect.center().y;
    let painter = ui.painter();
    let left = |x: f32, text: &str, font: FontId, ink: Color32| {
        let at = pos2(rect.left() + x, y);
        painter.text(at, Align2::LEFT_CENTER, text, font, ink)
    };
    left(0.0, glyph, crate::app::look::icon_font(14.0), ink);
    let name = left(20.0, condition.name(), body.clone(), tokens.text);
    let beside = name.right() - rect.left() + 8.0;
    left(
        beside,
        condition.symbols(),
        small_font.clone(),
        tokens.muted,
    );
    let right = |x: f32, text: &str, font: FontId, ink: Color32| {
        let at = pos2(rect.right() - x, y);
        painter.text(at, Align2::RIGHT_CENTER, text, font, ink);
    };
    right(0.0, &bound, small_font, tokens.muted);
    let value_ink = if is_met { tokens.text } else { tokens.error };
    right(64.0, &value, body, value_ink);
    small(ui, condition.meaning(), 20.0);
    ui.add_space(4.0);
}

/// A quiet sentence.
fn small(ui: &mut Ui, text: &str, indent: f32) {
    ui.horizontal_top(|ui| {
        ui.spacing_mut().item_spacing.x = 0.0;
        ui.add_space(indent);
        let muted = Tokens::in_ui(ui).muted;
        let text = RichText::new(text).small().color(muted);
        ui.add(Label::new(text).wrap());
    });
}

/// What an iteration tells, with what it means.
const COLUMNS: [(&str, f32, &str); 7] = [
    ("k", 24.0, "The iteration, from 0"),
    (
        "J − J*",
        72.0,
        "How far the energy is above the last one, of the scaled problem, whose energy is 1 to 100",
    ),
    (
        "Gradient",
        72.0,
        "Greatest entry of the Lagrangian's gradient",
    ),
    (
        "Violation",
        72.0,
        "Greatest depth inside an obstacle, scaled",
    ),
    ("Rows", 44.0, "Rows with a positive multiplier"),
    ("Step", 72.0, "Greatest change of a segment's turn"),
    (
        "Shift",
        64.0,
        "What was added to make the Hessian positive; 0 as a rule",
    ),
];

fn trace(ui: &mut Ui, trace: &[Iteration]) {
    let muted = Tokens::in_ui(ui).muted;
    columns(ui, |index| {
        let (name, _, meaning) = COLUMNS[index];
        (name.to_owned(), Some(muted), Some(meaning))
    });
    let least = trace.last().map_or(0.0, |last| last.cost);
    for (k, iteration) in trace.iter().enumerate() {
        let order = |value: f64| Quantity::order(value, "").digits;
        let cells = [
            k.to_string(),
            order(iteration.cost - least),
            order(iteration.stationarity),
            order(iteration.violation),
            iteration.active.to_string(),
            order(iteration.step),
            order(iteration.shift),
        ];
        columns(ui, |index| (cells[index].clone(), None, None));
    }
}

/// A line of the iteration table.
fn columns(ui: &mut Ui, cell: impl Fn(usize) -> (String, Option<Color32>, Option<&'static str>)) {
    ui.horizontal(|ui| {
        ui.spacing_mut().item_spacing.x = 0.0;
        for (index, (_, width, _)) in COLUMNS.into_iter().enumerate() {
            let layout = Layout::right_to_left(Align::Center);
            ui.allocate_ui_with_layout(vec2(width, 18.0), layout, |ui| {
                ui.set_min_width(width);
                let (text, ink, tip) = cell(index);
                let text = RichText::new(text).small();
                let text = match ink {
                    Some(ink) => text.color(ink),
                    None => text,
                };
                let response = ui.label(text);
                if let Some(tip) = tip {
                    response.on_hover_text(tip);
                }
            });
        }
    });
}

fn events(ui: &mut Ui, solution: &Solution, scene: &Scene) {
    for event in &solution.events {
        ui.horizontal_top(|ui| {
            let layout = Layout::right_to_left(Align::Min);
            ui.allocate_ui_with_layout(vec2(72.0, 18.0), layout, |ui| {
                ui.set_min_width(72.0);
                ui.label(RichText::new(words::when(event)).small());
            });
            let text = RichText::new(words::occurrence(&event.what, scene)).small();
            ui.add(Label::new(text).wrap());
        });
    }
}
