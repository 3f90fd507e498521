//! What went wrong, said where it did: edits that were taken back, shapes that
//! are no certified equilibria, and where those got stuck.

use super::tools::raised;
use super::{Canvas, chip, to_screen};
use crate::app::commands::Command;
use crate::app::live::Live;
use crate::app::look::{Tokens, icon, icons, semibold};
use crate::app::state::State;
use crate::equilibrium::{Solution, Status};
use crate::geometry::Vector;
use crate::model::{Line, Problem};
use crate::view::{Frame, Standing};
use eframe::egui::{
    Align, Button, Color32, Layout, Painter, Pos2, Rect, RichText, Sense, Stroke, Ui, UiBuilder,
    pos2, vec2,
};
use std::time::Duration;

/// How long messages stay, in seconds.
const TOLD_FOR: f64 = 4.0;
/// How long rings pulse before they keep still, in seconds.
const PULSING: f64 = 2.4;
/// Length of a pulse, in seconds.
const PULSE: f64 = 0.8;
/// Widest banner, in points.
const WIDEST: f32 = 620.0;

/// A remark on what was done.
#[derive(Clone, Debug, PartialEq)]
pub struct Notice {
    text: &'static str,
    at: f64,
}

impl Canvas {
    /// Tells something for a few seconds, from a time of the window's clock.
    pub fn tell(&mut self, text: &'static str, now: f64) {
        self.notice = Some(Notice { text, at: now });
    }

    /// What is being told.
    pub fn told(&self) -> Option<&str> {
        self.notice.as_ref().map(|notice| notice.text)
    }
}

/// Paints what is being told, and forgets what was told long enough.
pub fn messages(ui: &Ui, painter: &Painter, state: &mut State, rect: Rect, pointer: Option<Pos2>) {
    let tokens = Tokens::in_ui(ui);
    let now = ui.input(|input| input.time);
    let told = |at: f64| {
        let left = TOLD_FOR - (now - at);
        if left > 0.0 {
            let later = Duration::from_secs_f64(left);
            ui.ctx().request_repaint_after(later);
        }
        left > 0.0
    };
    if state
        .refusal
        .as_ref()
        .is_some_and(|refusal| !told(refusal.at))
    {
        state.refusal = None;
    }
    let canvas = &mut state.canvas;
    if canvas
        .notice
        .as_ref()
        .is_some_and(|notice| !told(notice.at))
    {
        canvas.notice = None;
    }
    let corner = pos2(rect.left() + super::tools::ROOM + 8.0, rect.top() + 12.0);
    let mut at = pointer.map_or(corner, |pointer| pointer + vec2(18.0, 52.0));
    if let Some(refusal) = &state.refusal {
        let faults: Vec<String> = refusal.faults.iter().map(ToString::to_string).collect();
        let text = format!("Taken back: {}", faults.join("; "));
        let area = chip::warning(painter, rect, at, &text, &tokens);
        at = area.left_bottom() + vec2(0.0, 8.0);
    }
    if let Some(notice) = &canvas.notice {
        let mark = (icons::INFO, tokens.accent);
        chip::marked(painter, rect, at, mark, notice.text, &tokens);
    }
}

/// Whether there is a shape that is greyed for what it is, not because it is
/// still being solved.
fn is_stuck(live: &Live) -> bool {
    let solution = live.solution();
    let unfinished = solution.is_none_or(|solution| solution.status == Status::Unfinished);
    live.drawing().standing.is_greyed() && !unfinished
}

/// Shows why the shape is greyed, with two ways out.
pub fn show(ui: &mut Ui, state: &mut State, rect: Rect) {
    if !is_stuck(&state.live) {
        return;
    }
    let Standing::Greyed { what, reason } = state.live.drawing().standing.clone() else {
        return;
    };
    let tokens = Tokens::in_ui(ui);
    let room = rect.width() - 2.0 * (super::tools::ROOM + 8.0);
    let width = room.min(WIDEST).max(160.0);
    let top = rect.center_top() + vec2(-0.5 * width, 12.0);
    let builder = UiBuilder::new()
        .id_salt("banner")
        .max_rect(Rect::from_min_size(top, vec2(width, 160.0)))
        .layout(Layout::top_down(Align::Min))
        .sense(Sense::click_and_drag());
    ui.scope_builder(builder, |ui| {
        raised(&tokens, 10).show(ui, |ui| {
            ui.horizontal_wrapped(|ui| {
                ui.label(icon(icons::WARNING).color(tokens.warning));
                ui.label(RichText::new(what).font(semibold(14.0)));
                ui.weak("The shape shown is the last one that holds.");
            });
            ui.label(format!("{}.", sentence(&reason)));
            ui.add_space(4.0);
            ui.horizontal_wrapped(|ui| {
                for (command, title) in [
                    (Command::Undo, "Undo"),
                    (Command::FromStraight, "Start from straight"),
                ] {
                    let button = Button::new((icon(command.entry().icon), title));
                    let enabled = command.is_enabled(state);
                    let tip = command.tip(ui.ctx());
                    let response = ui.add_enabled(enabled, button).on_hover_text(tip);
                    if response.accessible_name(title).clicked() {
                        state.commands.push(command);
                    }
                }
            });
        });
    });
}

fn sentence(reason: &str) -> String {
    let mut letters = reason.chars();
    match letters.next() {
        Some(first) => first.to_uppercase().chain(letters).collect(),
        None => String::new(),
    }
}

/// Rings around what the status names: the segment that ends a branch, the
/// contacts that cannot all be met.
pub fn rings(ui: &Ui, painter: &Painter, state: &mut State, frame: &Frame) {
    if !is_stuck(&state.live) {
        state.canvas.stuck_since = None;
        return;
    }
    let now = ui.input(|input| input.time);
    let since = *state.canvas.stuck_since.get_or_insert(now);
    let still = ui.style().animation_time == 0.0 || now - since > PULSING;
    let phase = if still {
        0.0
    } else {
        ui.ctx().request_repaint_after(Duration::from_millis(33));
        ((now - since) / PULSE).fract()
    };
    let warning = Tokens::in_ui(ui).warning;
    let solution = state.live.solution();
    let places = solution.map(|solution| stuck_at(state.live.problem(), solution));
    for place in places.into_iter().flatten() {
        let at = to_screen(frame, place);
        painter.circle_stroke(at, 12.0, Stroke::new(2.0, warning));
        if !still {
            let ink: Color32 = warning.gamma_multiply(1.0 - phase as f32);
            painter.circle_stroke(at, 12.0 + 14.0 * phase as f32, Stroke::new(2.0, ink));
        }
    }
}

/// Where the robot got stuck, in metres.
fn stuck_at(problem: &Problem, solution: &Solution) -> Vec<Vector> {
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
                let candidates = problem.candidates().iter();
                let mut of = candidates.filter(|c| c.line == line && c.node == node);
                let lever = of.next().map_or(0.0, |candidate| candidate.lever());
                nodes.get(node).map(|node| node.at(lever))
            };
            let places = conflicts.iter().filter_map(|c| place(c.line, c.node));
            places.collect()
        }
        _ => Vec::new(),
    }
}
