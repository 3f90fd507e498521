//! The canvas by keyboard: arrows nudge what is selected, Tab goes from one
//! obstacle to the next, Space held moves the view.

use super::tools::close_draft;
use super::{Canvas, hit};
use crate::app::commands::Command;
use crate::app::shapes::{Tool, moved, neat};
use crate::app::state::{Selection, State, Views};
use crate::geometry::Vector;
use crate::view::Frame;
use eframe::egui::{Context, EventFilter, Key, Modifiers, Response};

/// How far an arrow key moves an obstacle, in mm.
const NUDGE_MM: f64 = 0.5;
/// How far it moves the pull, in mm.
const PULL_MM: f64 = 0.1;
/// How much farther with Shift, or less far with Alt.
const FACTOR: f64 = 10.0;

/// Space as it is held over the canvas: it plays when let go, unless the view
/// was moved with it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Space {
    /// It is not held.
    #[default]
    Up,
    /// It is held.
    Down,
    /// It is held and the view was moved.
    Panned,
}

/// Before commands take their keys: keeps Space for the canvas while the
/// pointer is on it.
pub fn hold_space(ctx: &Context, state: &mut State) {
    let pointer = ctx.input(|input| input.pointer.hover_pos());
    let shown = state.preferences.views != Views::Space && !state.sheets.is_open();
    let over = shown && pointer.is_some_and(|at| state.canvas.rect.contains(at));
    let canvas = &mut state.canvas;
    if over && is_ours(ctx, canvas) {
        let pressed = ctx.input_mut(|input| input.consume_key(Modifiers::NONE, Key::Space));
        if pressed && canvas.space == Space::Up {
            canvas.space = Space::Down;
        }
    }
    if canvas.space != Space::Up && !ctx.input(|input| input.key_down(Key::Space)) {
        if canvas.space == Space::Down {
            state.commands.push(Command::Play);
        }
        canvas.space = Space::Up;
    }
}

/// Whether keys are the canvas's: no other control has the focus.
fn is_ours(ctx: &Context, canvas: &Canvas) -> bool {
    let focused = ctx.memory(|memory| memory.focused());
    !ctx.text_edit_focused() && (focused.is_none() || focused == canvas.id)
}

/// Follows the keys.
pub fn follow(response: &Response, state: &mut State, frame: &Frame) {
    let ctx = &response.ctx;
    state.canvas.id = Some(response.id);
    if !is_ours(ctx, &state.canvas) || state.sheets.is_open() {
        return;
    }
    // After everything was selected in turn, Tab goes on to other controls.
    let canvas = &mut state.canvas;
    canvas.went_round &= state.selection == Selection::Nothing && response.has_focus();
    let filter = EventFilter {
        tab: !canvas.went_round,
        horizontal_arrows: true,
        vertical_arrows: true,
        escape: true,
    };
    ctx.memory_mut(|memory| memory.set_focus_lock_filter(response.id, filter));
    if !state.canvas.draft.is_empty() {
        draw(ctx, state);
    }
    if response.has_focus() && !state.canvas.went_round {
        let tab = |modifiers| ctx.input_mut(|input| input.consume_key(modifiers, Key::Tab));
        if tab(Modifiers::SHIFT) {
            cycle(state, Way::Back);
        } else if tab(Modifiers::NONE) {
            cycle(state, Way::On);
        }
    }
    nudge(ctx, state, frame);
}

/// The keys of a polygon being drawn; Escape is a command's.
fn draw(ctx: &Context, state: &mut State) {
    let pressed = |key| ctx.input_mut(|input| input.consume_key(Modifiers::NONE, key));
    if pressed(Key::Enter) {
        close_draft(state);
    } else if pressed(Key::Backspace) {
        state.canvas.draft.pop();
    }
}

/// A way round.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Way {
    On,
    Back,
}

/// Selects the next of the obstacles and, after them, the robot; then nothing.
fn cycle(state: &mut State, way: Way) {
    let robot = state.document.scene.obstacles.len();
    let now = match state.selection {
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
    state.canvas.vertex = None;
    state.canvas.went_round = next.is_none();
    state.selection = match next {
        None => Selection::Nothing,
        Some(index) if index == robot => Selection::Robot,
        Some(index) => Selection::Obstacle(index),
    };
}

/// Moves what is selected by the arrow keys: an obstacle, or the pull.
fn nudge(ctx: &Context, state: &mut State, frame: &Frame) {
    if state.selection == Selection::Nothing || state.canvas.gesture.is_some() {
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
    match state.selection {
        Selection::Obstacle(index) => {
            if let Some(obstacle) = state.document.scene.obstacles.get_mut(index) {
                // A nudge is as exact as its step, however far one is away.
                let fine = hit::per_point(frame).min(0.1 * NUDGE_MM);
                let by = NUDGE_MM * steps;
                obstacle.shape = moved(&obstacle.shape, by, Modifiers::NONE, fine);
            }
        }
        Selection::Robot => {
            let span = state.span_mm();
            state.transport.stop();
            let pull_mm = &mut state.document.scene.actuation.pull_mm;
            let pull = neat(*pull_mm + PULL_MM * (steps.x + steps.y), 0.1 * PULL_MM);
            *pull_mm = pull.clamp(span.0, span.1);
        }
        Selection::Nothing | Selection::Photo | Selection::Measured => {}
    }
}

impl Canvas {
    /// Gives up what is being dragged or drawn and puts a tool away; the scene
    /// becomes what it was before. Whether there was anything.
    pub fn give_up(&mut self, scene: &mut crate::scene::Scene) -> bool {
        if let Some(gesture) = self.gesture.take() {
            scene.clone_from(gesture.before());
            return true;
        }
        let any = self.is_giving_up_something();
        self.draft.clear();
        self.tool = Tool::Select;
        any
    }

    /// Whether there is something to give up.
    pub fn is_giving_up_something(&self) -> bool {
        self.gesture.is_some() || !self.draft.is_empty() || self.tool != Tool::Select
    }
}
