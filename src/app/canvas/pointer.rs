//! What the pointer does on the canvas: hovering, clicks and the beginning and
//! end of drags. What a drag does in between is its [`Gesture`]'s.

use super::gesture::{Dragged, Gesture};
use super::hit::{self, Held, Reach, Target};
use super::keys::Space;
use super::menu;
use super::tools;
use crate::app::paint::to_world;
use crate::app::shapes::{Handle, Tool, add_vertex, edge_near, vertices};
use crate::app::state::{Selection, State};
use crate::geometry::Vector;
use crate::scene::Shape;
use crate::units::METRES_PER_MM;
use crate::view::Frame;
use eframe::egui::{CursorIcon, PointerButton, Response};

/// Follows the pointer. Returns what it is on or has taken hold of.
pub fn follow(response: &Response, state: &mut State, frame: &Frame, reach: Reach) -> Target {
    let ctx = &response.ctx;
    let fingers = ctx.input(|input| input.multi_touch().is_some());
    if fingers {
        // Two fingers move the view, whatever the first had taken hold of.
        let dragged = state.canvas.gesture.take();
        if let Some(gesture) = dragged.filter(|gesture| !gesture.is_view()) {
            state.document.scene.clone_from(gesture.before());
        }
        return Target::Nothing;
    }
    let Some(pointer) = response.hover_pos().or(response.interact_pointer_pos()) else {
        state.canvas.gesture = None;
        return Target::Nothing;
    };
    let world = to_world(frame, pointer);
    let under = hit::target_at(state, frame, world, reach);
    click(response, state, frame, under, world);
    let origin = ctx.input(|input| input.pointer.press_origin());
    let origin = to_world(frame, origin.unwrap_or(pointer));
    if response.drag_started_by(PointerButton::Primary) {
        response.request_focus();
        let gesture = if state.canvas.space != Space::Up {
            state.canvas.space = Space::Panned;
            Gesture::view(state)
        } else {
            let target = hit::target_at(state, frame, origin, reach);
            Gesture::begin(state, frame, target, origin)
        };
        state.canvas.gesture = Some(gesture);
    } else if response.drag_started_by(PointerButton::Middle) {
        state.canvas.gesture = Some(Gesture::view(state));
    }
    if !response.dragged()
        && !response.drag_stopped()
        && let Some(gesture) = state.canvas.gesture.take()
    {
        gesture.end(state);
    }
    let Some(mut gesture) = state.canvas.gesture.take() else {
        if response.hovered() {
            state.hovering = hit::hovered_at(state, frame, world, reach);
            point(response, state, frame, under);
        }
        return under;
    };
    if gesture.is_view() {
        let by = response.drag_delta();
        state.canvas.camera.pan(f64::from(by.x), f64::from(by.y));
        ctx.set_cursor_icon(CursorIcon::Grabbing);
    } else {
        let modifiers = ctx.input(|input| input.modifiers);
        gesture.follow(state, frame, world, modifiers);
        let shape = match &gesture.what {
            Dragged::Handle(_, _, shape) => Some(shape),
            _ => None,
        };
        ctx.set_cursor_icon(hit::cursor(gesture.target(), shape, Held::Yes));
    }
    let target = gesture.target();
    let held = ctx.input(|input| input.pointer.any_down());
    if response.drag_stopped() && !held {
        gesture.end(state);
    } else {
        // Escape stops a drag whose button is still held; it is a command's to
        // take the drag back.
        state.canvas.gesture = Some(gesture);
    }
    target
}

/// The cursor where nothing is being dragged.
fn point(response: &Response, state: &State, frame: &Frame, under: Target) {
    let icon = if state.canvas.space != Space::Up {
        CursorIcon::Grab
    } else if state.canvas.tool != Tool::Select {
        CursorIcon::Crosshair
    } else {
        let shape = hit::selected(state, frame).map(|(_, shape)| shape);
        hit::cursor(under, shape.as_ref(), Held::No)
    };
    response.ctx.set_cursor_icon(icon);
}

/// Follows clicks of all kinds.
fn click(response: &Response, state: &mut State, frame: &Frame, under: Target, at: Vector) {
    if response.secondary_clicked() {
        menu::open(state, under, at);
        return;
    }
    // Keys click too, but not at the pointer.
    if !response.clicked_by(PointerButton::Primary) {
        return;
    }
    response.request_focus();
    let twice = response.double_clicked_by(PointerButton::Primary);
    match state.canvas.tool {
        Tool::Select if twice => twice_on(state, frame, under, at),
        Tool::Select => select(state, under),
        Tool::Polygon if twice => tools::close_draft(state),
        Tool::Polygon => tools::add_to_draft(state, frame, at),
        tool => menu::add(state, tool, at, frame),
    }
}

fn select(state: &mut State, under: Target) {
    state.canvas.vertex = None;
    state.selection = match under {
        Target::Handle(index, handle) => {
            if let Handle::Vertex(vertex) = handle {
                state.canvas.vertex = Some((index, vertex));
            }
            Selection::Obstacle(index)
        }
        Target::Obstacle(index) => Selection::Obstacle(index),
        Target::Tip | Target::Robot => Selection::Robot,
        Target::Nothing => Selection::Nothing,
    };
}

/// A double click: on the plane it adds a disc, on a polygon's edge a vertex.
fn twice_on(state: &mut State, frame: &Frame, under: Target, at: Vector) {
    match under {
        Target::Nothing => menu::add(state, Tool::Disc, at, frame),
        Target::Obstacle(index) => {
            let Some(obstacle) = state.document.scene.obstacles.get_mut(index) else {
                return;
            };
            let per_point = hit::per_point(frame);
            let at = at / METRES_PER_MM;
            let points = vertices(&obstacle.shape);
            let grown = match &obstacle.shape {
                Shape::Polygon {
                    corner_radius_mm, ..
                } => *corner_radius_mm,
                _ => return,
            };
            let near = grown + 10.0 * per_point;
            if edge_near(&points, at).is_some_and(|(_, _, away)| away <= near)
                && let Some((more, vertex)) = add_vertex(&obstacle.shape, at)
            {
                obstacle.shape = more;
                state.canvas.vertex = Some((index, vertex));
            }
        }
        _ => {}
    }
}
