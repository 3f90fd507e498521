//! The canvas: the robot among its obstacles, in the plane, to be looked at
//! and taken hold of.

mod backdrop;
mod banner;
mod camera;
mod chip;
mod gesture;
mod handles;
mod hints;
mod hit;
mod hover;
mod keys;
mod labels;
mod menu;
mod overlay;
mod pointer;
mod pull;
mod shade;
mod tools;

pub use hints::Hints;
pub use keys::hold_space;

use super::live::Live;
use super::look::{Tokens, theme_of};
use super::paint::{drawing, grid};
use super::shapes::{Tool, remove_vertex};
use super::state::{Hovered, Selection, State};
use crate::geometry::Vector;
use crate::render::field_callback;
use crate::scene::Shape;
use crate::view::Frame;
use camera::Camera;
use eframe::egui::{self, Rect, Sense, Stroke, Ui};
use gesture::Gesture;
use hit::{Reach, Target};
use keys::Space;
use shade::Shade;

/// Points of the tip's trace that are kept.
const TRACE: usize = 2000;

/// Where the canvas looks, what is in hand and what is being dragged.
#[derive(Debug)]
pub struct Canvas {
    camera: Camera,
    /// Whether the view goes on to fit what the solver is about to find.
    fitting: bool,
    trace: Vec<Vector>,
    labels: labels::Labels,
    gesture: Option<Gesture>,
    tool: Tool,
    /// The vertices of the polygon being drawn, in mm.
    draft: Vec<Vector>,
    /// The selected vertex, by its obstacle's index and its own.
    vertex: Option<(usize, usize)>,
    menu: Option<menu::Opened>,
    space: Space,
    /// Whether Tab has selected everything in turn.
    went_round: bool,
    /// What the robot has left by a jump.
    shade: Option<Shade>,
    /// Since when the shape is greyed, in seconds of the window's clock.
    stuck_since: Option<f64>,
    id: Option<egui::Id>,
    rect: Rect,
    /// What the tools cover.
    strip: Rect,
}

impl Default for Canvas {
    fn default() -> Self {
        Self {
            camera: Camera::default(),
            fitting: true,
            trace: Vec::new(),
            labels: labels::Labels::default(),
            gesture: None,
            tool: Tool::Select,
            draft: Vec::new(),
            vertex: None,
            menu: None,
            space: Space::Up,
            went_round: false,
            shade: None,
            stuck_since: None,
            id: None,
            rect: Rect::NOTHING,
            strip: Rect::NOTHING,
        }
    }
}

impl Canvas {
    /// Shows everything at the next frame.
    pub fn fit_soon(&mut self) {
        self.camera.fit_soon();
        self.fitting = true;
        self.trace.clear();
    }

    /// Fits the view again at the next frame while the robot is on its way,
    /// unless the user has moved the view or moves something in it.
    fn go_on_fitting(&mut self, live: &Live) {
        self.fitting &= !live.is_settled() && self.gesture.is_none() && !self.camera.is_moved();
        if self.fitting {
            self.camera.fit_soon();
        }
    }

    /// Where the canvas looks: what is where on the screen.
    pub fn frame(&self) -> Frame {
        self.camera.frame()
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

    /// Leaves an old shape behind, its nodes in metres.
    pub fn leave_behind(&mut self, backbone: Vec<Vector>) {
        self.shade = Some(Shade::of(backbone));
    }

    /// Removes the selected vertex of an obstacle, if one is selected and can
    /// be spared. Whether one was selected.
    pub fn remove_vertex(&mut self, index: usize, shape: &mut Shape) -> bool {
        let Some((_, vertex)) = self.vertex.take().filter(|(of, _)| *of == index) else {
            return false;
        };
        if let Some(fewer) = remove_vertex(shape, vertex) {
            *shape = fewer;
        }
        true
    }
}

/// Shows the canvas in all the room there is.
pub fn show(ui: &mut Ui, state: &mut State) {
    let size = ui.available_size();
    let (rect, response) = ui.allocate_exact_size(size, Sense::click_and_drag());
    response
        .widget_info(|| egui::WidgetInfo::labeled(egui::Role::Canvas, true, "Robot and obstacles"));
    state.canvas.rect = rect;
    if rect.width() < 8.0 || rect.height() < 8.0 {
        return;
    }
    let bounds = state.live.drawing().bounds;
    state.canvas.camera.place(rect, tools::ROOM, &bounds);
    state.canvas.camera.navigate(ui, &response);
    let frame = state.canvas.camera.frame();
    state.canvas.go_on_fitting(&state.live);
    let reach = Reach::of(ui);
    keys::follow(&response, state, &frame);
    // What lies behind and before the robot comes first, where it is in hand.
    let target = if backdrop::interact(&response, state, &frame) {
        Target::Nothing
    } else {
        pointer::follow(&response, state, &frame, reach)
    };
    state.take_edits(ui.ctx());
    picture(ui, state, &frame, rect, target, reach);
    overlays(ui, state, &frame, rect, &response);
    if response.has_focus() && response.ctx.input(|input| !input.pointer.has_pointer()) {
        let ring = Stroke::new(2.0, Tokens::in_ui(ui).accent);
        let painter = ui.painter_at(rect);
        painter.rect_stroke(rect.shrink(1.0), 0.0, ring, egui::StrokeKind::Inside);
    }
    menu::show(&response, state, &frame);
}

/// Paints the scene.
fn picture(ui: &Ui, state: &mut State, frame: &Frame, rect: Rect, target: Target, reach: Reach) {
    let theme = theme_of(ui);
    let tokens = Tokens::of(theme);
    let painter = ui.painter_at(rect);
    painter.rect_filled(rect, 0.0, tokens.canvas);
    if state.preferences.field {
        let obstacles = state.live.problem().obstacles();
        painter.add(field_callback(rect, frame, obstacles, theme));
    }
    backdrop::behind(&painter, state, frame);
    if state.preferences.grid {
        grid(&painter, frame, theme);
    }
    let lit = match &state.canvas.gesture {
        None => state.hovering,
        Some(_) => Hovered::Nothing,
    };
    if state.selection == Selection::Robot {
        overlay::halo(&painter, &state.live, frame, theme);
    }
    if let Some(shade) = &mut state.canvas.shade
        && !shade.paint(ui, &painter, frame)
    {
        state.canvas.shade = None;
    }
    drawing(&painter, state.live.drawing(), frame, theme);
    if let Hovered::Obstacle(_) = lit {
        hover::paint(&painter, state, lit, frame, rect, theme);
    }
    overlay::selection(&painter, &state.live, state.selection, frame, theme);
    let revision = state.live.revision();
    let State { canvas, live, .. } = state;
    let drawing = (live.drawing(), revision);
    canvas
        .labels
        .paint(&painter, drawing, frame, canvas.strip, theme);
    if let Some((index, shape)) = hit::selected(state, frame) {
        let under = match target {
            Target::Handle(of, handle) if of == index => Some(handle),
            _ => None,
        };
        let vertex = state.canvas.vertex.filter(|(of, _)| *of == index);
        let filled = (under, vertex.map(|(_, vertex)| vertex));
        handles::paint(&painter, &shape, frame, filled, reach, &tokens);
    }
    if target == Target::Tip {
        overlay::tip_ring(&painter, &state.live, frame, &tokens);
    }
    overlay::scale_bar(&painter, frame, state.canvas.strip, theme);
    backdrop::before(&painter, state, frame, theme);
    if !state.live.drawing().standing.is_greyed() {
        overlay::legend(&painter, state.live.drawing(), rect, theme);
    }
    match lit {
        Hovered::Obstacle(_) => {}
        lit => hover::paint(&painter, state, lit, frame, rect, theme),
    }
}

/// Paints and shows what floats over the scene.
fn overlays(ui: &mut Ui, state: &mut State, frame: &Frame, rect: Rect, response: &egui::Response) {
    let tokens = Tokens::in_ui(ui);
    let painter = ui.painter_at(rect);
    let pointer = response.hover_pos().or(response.interact_pointer_pos());
    banner::rings(ui, &painter, state, frame);
    tools::paint_draft(&painter, &state.canvas, frame, pointer, &tokens);
    let calm = state.canvas.gesture.is_none() && state.canvas.tool == Tool::Select;
    let calm = calm && !state.live.drawing().standing.is_greyed();
    if calm && state.hovering == Hovered::Nothing && state.selection == Selection::Nothing {
        let hints = state.preferences.hints;
        hints.paint(&painter, &state.live, frame, rect, &tokens);
    }
    state.canvas.strip = tools::show(ui, state, rect);
    banner::show(ui, state, rect);
    let painter = ui.painter_at(rect);
    if let (Some(gesture), Some(pointer)) = (&state.canvas.gesture, pointer) {
        let numbers = gesture.reading(&state.document.scene);
        chip::reading(&painter, rect, pointer, &numbers, &tokens);
    }
    banner::refusal(ui, &painter, state, rect, pointer);
}
