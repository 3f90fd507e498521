//! The canvas: the robot among its obstacles, in the plane, to be looked at
//! and taken hold of.

mod camera;
mod overlays;
mod paint;

pub(super) use paint::drawing as paint_drawing;

use super::live::Live;
use super::look::{Tokens, theme_of};
use super::state::{Hovered, Selection, State};
use crate::geometry::Vector;
use crate::units::millimetres;
use crate::view::Frame;
use camera::Camera;
use eframe::egui::{self, CursorIcon, PointerButton, Pos2, Sense, Ui};

/// Points of the tip's trace that are kept.
const TRACE: usize = 2000;
/// How near the pointer has to be to a node or to the tip, in points.
const NEAR: f64 = 14.0;

/// Where the canvas looks and what is being dragged on it.
#[derive(Debug, Default)]
pub struct Canvas {
    camera: Camera,
    trace: Vec<Vector>,
    gesture: Option<Gesture>,
    labels: paint::Labels,
}

/// What is being dragged.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Gesture {
    /// The view.
    Pan,
    /// An obstacle, held at this distance from its anchor, in metres.
    Move { index: usize, held: Vector },
}

impl Canvas {
    /// Shows everything at the next frame.
    pub fn fit_soon(&mut self) {
        self.camera.fit_soon();
        self.trace.clear();
    }

    /// Where the tip has been, in metres.
    pub fn trace(&self) -> &[Vector] {
        &self.trace
    }

    /// Adds the tip of a new shape to its trace.
    pub fn follow_tip(&mut self, live: &Live) {
        let Some(solution) = live.solution() else {
            return;
        };
        if !live.is_settled() || solution.nodes.is_empty() {
            return;
        }
        let tip = solution.tip().position;
        let far = 2e-4 * live.problem().length();
        if self
            .trace
            .last()
            .is_none_or(|last| (tip - last).norm() > far)
        {
            self.trace.push(tip);
        }
        if self.trace.len() > TRACE {
            self.trace.drain(..TRACE / 2);
        }
    }
}

/// Shows the canvas in all the room there is.
pub fn show(ui: &mut Ui, state: &mut State) {
    let size = ui.available_size();
    let (rect, response) = ui.allocate_exact_size(size, Sense::click_and_drag());
    response
        .widget_info(|| egui::WidgetInfo::labeled(egui::Role::Canvas, true, "Robot and obstacles"));
    if rect.width() < 8.0 || rect.height() < 8.0 {
        return;
    }
    let bounds = state.live.drawing().bounds;
    state.canvas.camera.place(rect, &bounds);
    state.canvas.camera.navigate(ui, &response);
    let frame = state.canvas.camera.frame();
    if !overlays::interact(&response, state, &frame) {
        interact(&response, state, &frame);
    }
    let theme = theme_of(ui);
    let painter = ui.painter_at(rect);
    painter.rect_filled(rect, 0.0, Tokens::of(theme).canvas);
    overlays::behind(&painter, state, &frame);
    if state.preferences.grid {
        paint::grid(&painter, &frame, theme);
    }
    let State {
        canvas,
        live,
        selection,
        ..
    } = state;
    paint::drawing(&painter, live.drawing(), &frame, theme);
    paint::selection(&painter, live, *selection, &frame, theme);
    let revision = live.revision();
    canvas
        .labels
        .paint(&painter, live.drawing(), revision, &frame, theme);
    paint::scale_bar(&painter, &frame, theme);
    overlays::before(&painter, state, &frame, theme);
    paint::legend(&painter, live.drawing(), rect, theme);
}

fn to_world(frame: &Frame, at: Pos2) -> Vector {
    frame.to_world(Vector::new(f64::from(at.x), f64::from(at.y)))
}

fn to_screen(frame: &Frame, at: Vector) -> Pos2 {
    let at = frame.to_screen(at);
    Pos2::new(at.x as f32, at.y as f32)
}

fn interact(response: &egui::Response, state: &mut State, frame: &Frame) {
    let Some(pointer) = response.hover_pos().or(response.interact_pointer_pos()) else {
        return;
    };
    let world = to_world(frame, pointer);
    let under = obstacle_at(&state.live, world, 4.0 / frame.scale);
    if state.canvas.gesture.is_none() {
        state.hovering = hovered_at(&state.live, frame, world, under);
    }
    if under.is_some() {
        response.ctx.set_cursor_icon(CursorIcon::Grab);
    }
    if response.clicked() {
        state.selection = under.map_or(Selection::Nothing, Selection::Obstacle);
    }
    if response.drag_started_by(PointerButton::Primary) {
        let origin = response.ctx.input(|input| input.pointer.press_origin());
        let origin = to_world(frame, origin.unwrap_or(pointer));
        let under = obstacle_at(&state.live, origin, 4.0 / frame.scale);
        state.canvas.gesture = Some(match under {
            Some(index) => {
                state.selection = Selection::Obstacle(index);
                let anchor = state.live.problem().obstacles()[index].position();
                let held = origin - anchor;
                Gesture::Move { index, held }
            }
            None => Gesture::Pan,
        });
    }
    match state.canvas.gesture {
        Some(Gesture::Pan) => {
            let by = response.drag_delta();
            state.canvas.camera.pan(f64::from(by.x), f64::from(by.y));
        }
        Some(Gesture::Move { index, held }) => {
            response.ctx.set_cursor_icon(CursorIcon::Grabbing);
            if let Some(obstacle) = state.document.scene.obstacles.get_mut(index) {
                let to = world - held;
                obstacle
                    .shape
                    .move_to_mm([millimetres(to.x), millimetres(to.y)]);
            }
        }
        None => {}
    }
    if response.drag_stopped() {
        state.canvas.gesture = None;
    }
}

/// The topmost obstacle within `margin` metres of a point.
fn obstacle_at(live: &Live, point: Vector, margin: f64) -> Option<usize> {
    let obstacles = live.problem().obstacles();
    obstacles
        .iter()
        .rposition(|obstacle| obstacle.clearance(point).distance <= margin)
}

fn hovered_at(live: &Live, frame: &Frame, point: Vector, under: Option<usize>) -> Hovered {
    let near = NEAR / frame.scale;
    if let Some(solution) = live.solution() {
        let contacts = solution.contacts.iter().map(|contact| contact.point);
        if let Some(index) = nearest(contacts, point, near) {
            return Hovered::Contact(index);
        }
        if let Some(index) = nearest(solution.backbone(), point, near) {
            return Hovered::Node(index);
        }
    }
    under.map_or(Hovered::Nothing, Hovered::Obstacle)
}

/// The nearest of some points, if it is near enough.
fn nearest(points: impl Iterator<Item = Vector>, to: Vector, near: f64) -> Option<usize> {
    let away = points.map(|point| (point - to).norm()).enumerate();
    away.filter(|(_, away)| *away <= near)
        .min_by(|a, b| a.1.total_cmp(&b.1))
        .map(|(index, _)| index)
}
