//! What the pointer does on the canvas: hovering, clicks and the beginning and
//! end of drags. What a drag does in between is its [`Drag`]'s.

use super::drag::{Drag, Dragged};
use super::hit::{self, Held, Reach, Target};
use super::menu;
use super::tools;
use super::view::{Canvas, SpaceKey};
use crate::app::paint::to_world;
use crate::app::shapes::{Handle, Tool, add_vertex, edge_near, vertices};
use crate::app::workbench::{Selection, Workbench};
use crate::geometry::Vector;
use crate::scene::Shape;
use crate::units::METRES_PER_MM;
use crate::view::Frame;
use eframe::egui::{CursorIcon, PointerButton, Response};

/// Follows the pointer. Returns what it is on or has taken hold of.
pub fn follow(
    response: &Response,
    canvas: &mut Canvas,
    bench: &mut Workbench,
    frame: &Frame,
    reach: Reach,
) -> Target {
    let ctx = &response.ctx;
    let fingers = ctx.input(|input| input.multi_touch().is_some());
    if fingers {
        // Two fingers move the view, whatever the first had taken hold of.
        let dragged = canvas.drag.take();
        if let Some(drag) = dragged.filter(|drag| !drag.is_view()) {
            bench.document.scene.clone_from(drag.before());
        }
        return Target::Nothing;
    }
    let Some(pointer) = response.hover_pos().or(response.interact_pointer_pos()) else {
        canvas.drag = None;
        return Target::Nothing;
    };
    let world = to_world(frame, pointer);
    let under = hit::target_at(canvas.tool, bench, frame, world, reach);
    click(response, canvas, bench, frame, under, world);
    let origin = ctx.input(|input| input.pointer.press_origin());
    let origin = to_world(frame, origin.unwrap_or(pointer));
    if response.drag_started_by(PointerButton::Primary) {
        response.request_focus();
        let drag = if canvas.space_key != SpaceKey::Up {
            canvas.space_key = SpaceKey::Panned;
            Drag::view(bench)
        } else {
            let target = hit::target_at(canvas.tool, bench, frame, origin, reach);
            Drag::begin(canvas, bench, frame, target, origin)
        };
        canvas.drag = Some(drag);
    } else if response.drag_started_by(PointerButton::Middle) {
        canvas.drag = Some(Drag::view(bench));
    }
    if !response.dragged()
        && !response.drag_stopped()
        && let Some(drag) = canvas.drag.take()
    {
        drag.end(canvas, bench);
    }
    let Some(mut drag) = canvas.drag.take() else {
        if response.hovered() {
            bench.hovering = hit::hovered_at(bench, frame, world, reach);
            point(response, canvas, bench, frame, under);
        }
        return under;
    };
    if drag.is_view() {
        let by = response.drag_delta();
        canvas.camera.pan(f64::from(by.x), f64::from(by.y));
        ctx.set_cursor_icon(CursorIcon::Grabbing);
    } else {
        let modifiers = ctx.input(|input| input.modifiers);
        drag.follow(bench, frame, world, modifiers);
        let shape = match &drag.what {
            Dragged::Handle(_, _, shape) => Some(shape),
            _ => None,
        };
        ctx.set_cursor_icon(hit::cursor(drag.target(), shape, Held::Yes));
    }
    let target = drag.target();
    let held = ctx.input(|input| input.pointer.any_down());
    if response.drag_stopped() && !held {
        drag.end(canvas, bench);
    } else {
        // Escape stops a drag whose button is still held; it is a command's to
        // take the drag back.
        canvas.drag = Some(drag);
    }
    target
}

/// The cursor where nothing is being dragged.
fn point(response: &Response, canvas: &Canvas, bench: &Workbench, frame: &Frame, under: Target) {
    let icon = if canvas.space_key != SpaceKey::Up {
        CursorIcon::Grab
    } else if canvas.tool != Tool::Select {
        CursorIcon::Crosshair
    } else {
        let shape = hit::selected(canvas.tool, bench, frame).map(|(_, shape)| shape);
        hit::cursor(under, shape.as_ref(), Held::No)
    };
    response.ctx.set_cursor_icon(icon);
}

/// Follows clicks of all kinds.
fn click(
    response: &Response,
    canvas: &mut Canvas,
    bench: &mut Workbench,
    frame: &Frame,
    under: Target,
    at: Vector,
) {
    if response.secondary_clicked() {
        menu::open(canvas, bench, under, at);
        return;
    }
    // Keys click too, but not at the pointer.
    if !response.clicked_by(PointerButton::Primary) {
        return;
    }
    response.request_focus();
    let twice = response.double_clicked_by(PointerButton::Primary);
    match canvas.tool {
        Tool::Select if twice => twice_on(canvas, bench, frame, under, at),
        Tool::Select => select(canvas, bench, under),
        Tool::Polygon if twice => tools::close_draft(canvas, bench),
        Tool::Polygon => tools::add_to_draft(canvas, bench, frame, at),
        tool => menu::add(canvas, bench, tool, at, frame),
    }
}

fn select(canvas: &mut Canvas, bench: &mut Workbench, under: Target) {
    canvas.vertex = None;
    bench.selection = match under {
        Target::Handle(index, handle) => {
            if let Handle::Vertex(vertex) = handle {
                canvas.vertex = Some((index, vertex));
            }
            Selection::Obstacle(index)
        }
        Target::Obstacle(index) => Selection::Obstacle(index),
        Target::Tip | Target::TipForce | Target::Gravity | Target::Robot => Selection::Robot,
        Target::Nothing => Selection::Nothing,
    };
}

/// A double click: on the plane it adds a disc, on a polygon's edge a vertex.
fn twice_on(canvas: &mut Canvas, bench: &mut Workbench, frame: &Frame, under: Target, at: Vector) {
    match under {
        Target::Nothing => menu::add(canvas, bench, Tool::Disc, at, frame),
        Target::Obstacle(index) => {
            let Some(obstacle) = bench.document.scene.obstacles.get_mut(index) else {
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
                canvas.vertex = Some((index, vertex));
            }
        }
        _ => {}
    }
}
