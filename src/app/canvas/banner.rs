//! What went wrong, said where it did: edits that were taken back, shapes that
//! are no certified equilibria, and where those got stuck.

use super::chip;
use super::clear::Rather;
use super::tools::raised;
use super::view::Canvas;
use crate::app::commands::Command;
use crate::app::look::{Tokens, icon, icons, semibold};
use crate::app::paint::to_screen;
use crate::app::words;
use crate::app::workbench::{Live, Workbench};
use crate::equilibrium::{Solved, Status};
use crate::geometry::Vector;
use crate::robot::Line;
use crate::view::{Frame, Standing};
use eframe::egui::{
    Align, Button, Color32, Label, Layout, Painter, Pos2, Rect, RichText, Sense, Stroke, Ui,
    UiBuilder, pos2, vec2,
};
use std::time::Duration;

/// How long messages stay, in seconds.
const TOLD_FOR: f64 = 4.0;
/// How long rings pulse before they keep still, in seconds.
const PULSING: f64 = 2.4;
/// Length of a pulse, in seconds.
const PULSE: f64 = 0.8;
/// Widest banner, in points.
const WIDEST: f32 = 760.0;
/// In a narrower one the buttons are below the text, in points.
const NARROW: f32 = 580.0;

/// Paints why an edit was taken back, beside the pointer, and forgets it when
/// it was told long enough.
pub fn refusal(
    ui: &Ui,
    painter: &Painter,
    bench: &mut Workbench,
    rect: Rect,
    pointer: Option<Pos2>,
) {
    let Some(refusal) = &bench.refusal else {
        return;
    };
    let left = TOLD_FOR - (ui.input(|input| input.time) - refusal.at);
    if left <= 0.0 {
        bench.refusal = None;
        return;
    }
    ui.ctx()
        .request_repaint_after(Duration::from_secs_f64(left));
    let corner = pos2(rect.left() + super::tools::ROOM + 8.0, rect.top() + 12.0);
    let at = pointer.map_or(corner, |pointer| pointer + vec2(18.0, 52.0));
    let faults: Vec<String> = refusal.faults.iter().map(words::refusal).collect();
    let text = format!("Taken back. {}", faults.join(" "));
    chip::warning(painter, rect, at, &text, &Tokens::in_ui(ui));
}

/// Whether there is a shape that is greyed for what it is, not because it is
/// still being solved.
fn is_stuck(live: &Live) -> bool {
    let solution = live.solution();
    let unfinished = solution.is_none_or(|solution| solution.status == Status::Unfinished);
    live.drawing().standing.is_greyed() && !unfinished
}

/// Shows why the shape is greyed, or that it is not the one that the straight
/// robot comes to, with two ways out.
pub fn show(ui: &mut Ui, bench: &mut Workbench, rect: Rect, kept: &[Rect]) {
    if !is_stuck(&bench.live) {
        // What friction remembers is no branch; the status chip tells of it.
        if bench.live.is_on_another_branch() && !bench.live.has_history() {
            let reason = "The straight robot comes to another shape at this pull.";
            banner(
                ui,
                bench,
                rect,
                kept,
                (icons::INFO, "Another branch", reason),
            );
        }
        return;
    }
    let Standing::Greyed { what, reason } = bench.live.drawing().standing.clone() else {
        return;
    };
    // In words that name obstacles by their names.
    let reason = match bench.live.solution() {
        Some(solution) => words::outcome(solution, &bench.document.scene),
        None => words::spoken(&reason),
    };
    banner(ui, bench, rect, kept, (icons::WARNING, what, &reason));
}

fn banner(ui: &mut Ui, bench: &mut Workbench, rect: Rect, kept: &[Rect], told: (&str, &str, &str)) {
    let tokens = Tokens::in_ui(ui);
    let room = rect.width() - 2.0 * (super::tools::ROOM + 8.0);
    let width = room.clamp(160.0, WIDEST);
    // As high as it was in the last frame.
    let id = ui.scope_id().with("banner height");
    let height = ui.data(|data| data.get_temp::<f32>(id)).unwrap_or(44.0);
    let top = super::clear::place(rect, vec2(width, height), kept, Rather::Above);
    let builder = UiBuilder::new()
        .id_salt("banner")
        .max_rect(Rect::from_min_size(top, vec2(width, 44.0)))
        .layout(Layout::top_down(Align::Min))
        .sense(Sense::click_and_drag());
    let shown = ui.scope_builder(builder, |ui| {
        raised(&tokens, 8).show(ui, |ui| {
            let wide = width > NARROW;
            if wide {
                // The buttons first, so that the text knows what is left.
                ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
                    actions(ui, bench);
                    ui.with_layout(Layout::left_to_right(Align::Center), |ui| {
                        reasons(ui, told, &tokens);
                    });
                });
            } else {
                ui.horizontal_wrapped(|ui| reasons(ui, told, &tokens));
                ui.horizontal_wrapped(|ui| actions(ui, bench));
            }
        });
    });
    let now = shown.response.rect.height();
    if now != height {
        ui.data_mut(|data| data.insert_temp(id, now));
        ui.ctx().request_repaint();
    }
}

fn reasons(ui: &mut Ui, (glyph, what, reason): (&str, &str, &str), tokens: &Tokens) {
    ui.label(icon(glyph).color(tokens.warning));
    ui.label(RichText::new(what).font(semibold(14.0)));
    let reason = RichText::new(reason);
    ui.add(Label::new(reason.small().color(tokens.muted)).wrap());
}

/// The ways out.
fn actions(ui: &mut Ui, bench: &mut Workbench) {
    for (command, title) in [
        (Command::FromStraight, "Start from straight"),
        (Command::Undo, "Undo"),
    ] {
        let button = Button::new((icon(command.entry().icon), title));
        let enabled = bench.allows(command);
        let tip = command.tip(ui.ctx());
        let response = ui.add_enabled(enabled, button).on_hover_text(tip);
        if response.accessible_name(title).clicked() {
            bench.commands.push(command);
        }
    }
}

/// Rings around what the status names: the segment that ends a branch, the
/// contacts that cannot all be met.
pub fn rings(
    ui: &Ui,
    painter: &Painter,
    canvas: &mut Canvas,
    bench: &mut Workbench,
    frame: &Frame,
) {
    if !is_stuck(&bench.live) {
        canvas.stuck_since = None;
        return;
    }
    let now = ui.input(|input| input.time);
    let since = *canvas.stuck_since.get_or_insert(now);
    let still = ui.style().animation_time == 0.0 || now - since > PULSING;
    let phase = if still {
        0.0
    } else {
        ui.ctx().request_repaint_after(Duration::from_millis(33));
        ((now - since) / PULSE).fract()
    };
    let warning = Tokens::in_ui(ui).warning;
    let solution = bench.live.solution();
    let places = solution.map(stuck_at);
    for place in places.into_iter().flatten() {
        let at = to_screen(frame, place);
        painter.circle_stroke(at, 12.0, Stroke::new(2.0, warning));
        if !still {
            let ink: Color32 = warning.gamma_multiply(1.0 - phase as f32);
            painter.circle_stroke(at, 12.0 + 14.0 * phase as f32, Stroke::new(2.0, ink));
        }
    }
}

/// Where the robot got stuck, in metres; nowhere where it did not.
pub(super) fn stuck_places(live: &Live) -> Vec<Vector> {
    match live.solution() {
        Some(solution) if is_stuck(live) => stuck_at(solution),
        _ => Vec::new(),
    }
}

/// Where a robot got stuck, in metres.
fn stuck_at(solution: &Solved) -> Vec<Vector> {
    let nodes = &solution.nodes;
    match &solution.status {
        Status::BranchEnded { segment, .. } => {
            let ends = segment.checked_sub(1).and_then(|below| {
                let (a, b) = (nodes.get(below)?, nodes.get(*segment)?);
                Some(0.5 * (a.position + b.position))
            });
            ends.into_iter().collect()
        }
        Status::Infeasible { conflicts } => {
            let place = |line: Line, node: usize| {
                let candidates = solution.problem().candidates().iter();
                let mut of = candidates.filter(|c| c.line == line && c.node == node);
                let candidate = of.next().filter(|it| it.node < nodes.len())?;
                let (a, b) = candidate.ends(nodes);
                Some(0.5 * (a + b))
            };
            let places = conflicts.iter().filter_map(|c| place(c.line, c.node));
            places.collect()
        }
        _ => Vec::new(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::equilibrium::{Settings, Start, solve};
    use crate::mechanics::Problem;
    use crate::scene::Scene;

    #[test]
    fn rings_are_where_the_conflicts_are() {
        let wedge = include_str!("../../../assets/scenes/wedge.toml");
        let mut scene = Scene::from_toml(wedge).unwrap();
        scene.set_pull_mm(12.0);
        let problem = Problem::new(&scene).unwrap();
        let solution = solve(&problem, Start::Straight, Settings::default());
        assert!(matches!(solution.status, Status::Infeasible { .. }));
        let places = stuck_at(&solution);
        assert!(!places.is_empty());
        // Every one of them is inside a part that presses, whose disks are 3 mm
        // thick.
        for place in places {
            let contacts = solution.contacts.iter();
            let near = contacts.map(|contact| (contact.point - place).norm());
            let near = near.fold(f64::INFINITY, f64::min);
            assert!(near < 2e-3, "{place} is {near} m from any contact");
        }
    }
}
