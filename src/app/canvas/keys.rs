//! The canvas by keyboard: arrows nudge what is selected, Tab goes from one
//! obstacle to the next, Space held moves the view.

use super::hit;
use super::tools::close_draft;
use super::view::{Canvas, SpaceKey};
use crate::app::commands::Command;
use crate::app::shapes::{moved, neat};
use crate::app::workbench::{Playing, Selection, Views, Workbench};
use crate::geometry::Vector;
use crate::view::Frame;
use eframe::egui::{Context, EventFilter, Key, Modifiers, Response};

/// How far an arrow key moves an obstacle, in mm.
const NUDGE_MM: f64 = 0.5;
/// How far it moves the pull, in mm.
const PULL_MM: f64 = 0.1;
/// How much farther with Shift, or less far with Alt.
const FACTOR: f64 = 10.0;

/// Before commands take their keys: keeps Space for the canvas while the
/// pointer is on it.
pub fn hold_space(ctx: &Context, canvas: &mut Canvas, bench: &mut Workbench) {
    let pointer = ctx.input(|input| input.pointer.hover_pos());
    let shown = bench.preferences.views != Views::Space && !canvas.covered;
    let over = shown && pointer.is_some_and(|at| canvas.rect.contains(at));
    if over && is_ours(ctx, canvas) {
        let pressed = ctx.input_mut(|input| input.consume_key(Modifiers::NONE, Key::Space));
        if pressed && canvas.space_key == SpaceKey::Up {
            canvas.space_key = SpaceKey::Down;
        }
    }
    if canvas.space_key != SpaceKey::Up && !ctx.input(|input| input.key_down(Key::Space)) {
        if canvas.space_key == SpaceKey::Down {
            bench.commands.push(Command::Play);
        }
        canvas.space_key = SpaceKey::Up;
    }
}

/// Whether keys are the canvas's: no other control has the focus.
fn is_ours(ctx: &Context, canvas: &Canvas) -> bool {
    let focused = ctx.memory(|memory| memory.focused());
    !ctx.text_edit_focused() && (focused.is_none() || focused == canvas.id)
}

/// Follows the keys.
pub fn follow(response: &Response, canvas: &mut Canvas, bench: &mut Workbench, frame: &Frame) {
    let ctx = &response.ctx;
    canvas.id = Some(response.id);
    if !is_ours(ctx, canvas) || canvas.covered {
        return;
    }
    // After everything was selected in turn, Tab goes on to other controls.
    canvas.went_round &= bench.selection == Selection::Nothing && response.has_focus();
    let filter = EventFilter {
        tab: !canvas.went_round,
        horizontal_arrows: true,
        vertical_arrows: true,
        escape: true,
    };
    ctx.memory_mut(|memory| memory.set_focus_lock_filter(response.id, filter));
    if !canvas.draft.is_empty() {
        draw(ctx, canvas, bench);
    }
    if response.has_focus() && !canvas.went_round {
        let tab = |modifiers| ctx.input_mut(|input| input.consume_key(modifiers, Key::Tab));
        if tab(Modifiers::SHIFT) {
            cycle(canvas, bench, Way::Back);
        } else if tab(Modifiers::NONE) {
            cycle(canvas, bench, Way::On);
        }
    }
    nudge(ctx, canvas, bench, frame);
}

/// The keys of a polygon being drawn; Escape is a command's.
fn draw(ctx: &Context, canvas: &mut Canvas, bench: &mut Workbench) {
    let pressed = |key| ctx.input_mut(|input| input.consume_key(Modifiers::NONE, key));
    if pressed(Key::Enter) {
        close_draft(canvas, bench);
    } else if pressed(Key::Backspace) {
        canvas.draft.pop();
    }
}

/// A way round.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Way {
    On,
    Back,
}

/// Selects the next of the obstacles and, after them, the robot; then nothing.
fn cycle(canvas: &mut Canvas, bench: &mut Workbench, way: Way) {
    let robot = bench.document.scene.obstacles.len();
    let now = match bench.selection {
        Selection::Nothing | Selection::Photo | Selection::Measured => None,
        Selection::Obstacle(index) => Some(index),
        Selection::Robot => Some(robot),
    };
    let next = match (way, now) {
        (Way::Back, None) => Some(robot),
        (Way::Back, Some(now)) => now.checked_sub(1),
        (Way::On, None) => Some(0),
        (Way::On, Some(now)) => Some(now + 1).filter(|next| *next <= robot),
    };
    canvas.vertex = None;
    canvas.went_round = next.is_none();
    bench.selection = match next {
        None => Selection::Nothing,
        Some(index) if index == robot => Selection::Robot,
        Some(index) => Selection::Obstacle(index),
    };
}

/// Moves what is selected by the arrow keys: an obstacle, or the pull.
fn nudge(ctx: &Context, canvas: &mut Canvas, bench: &mut Workbench, frame: &Frame) {
    if bench.selection == Selection::Nothing || canvas.drag.is_some() {
        return;
    }
    let mut steps = Vector::zeros();
    ctx.input_mut(|input| {
        for (modifiers, factor) in [
            (Modifiers::SHIFT, FACTOR),
            (Modifiers::ALT, 1.0 / FACTOR),
            (Modifiers::NONE, 1.0),
        ] {
            for (key, way) in [
                (Key::ArrowRight, Vector::x()),
                (Key::ArrowLeft, -Vector::x()),
                (Key::ArrowUp, Vector::y()),
                (Key::ArrowDown, -Vector::y()),
            ] {
                let count = input.count_and_consume_key(modifiers, key);
                steps += count as f64 * factor * way;
            }
        }
    });
    if steps == Vector::zeros() {
        return;
    }
    match bench.selection {
        Selection::Obstacle(index) => {
            if let Some(obstacle) = bench.document.scene.obstacles.get_mut(index) {
                // A nudge is as exact as its step, however far one is away.
                let fine = hit::per_point(frame).min(0.1 * NUDGE_MM);
                let by = NUDGE_MM * steps;
                obstacle.shape = moved(&obstacle.shape, by, Modifiers::NONE, fine);
            }
        }
        Selection::Robot => {
            let pull_mm = bench.pull_mm() + PULL_MM * (steps.x + steps.y);
            bench.set_pull_within_span(neat(pull_mm, 0.1 * PULL_MM), Playing::Stops);
        }
        Selection::Nothing | Selection::Photo | Selection::Measured => {}
    }
}
