//! Where the canvas looks, what is in hand on it and what is being dragged.

use super::camera::Camera;
use super::drag::Drag;
use super::hit::Target;
use super::labels::Labels;
use super::shade::Shade;
use crate::app::shapes::{Tool, remove_vertex};
use crate::app::workbench::{Live, Workbench};
use crate::geometry::Vector;
use crate::scene::{Scene, Shape};
use crate::view::Frame;
use eframe::egui::{Id, Rect};

/// Space as it is held over the canvas: it plays when let go, unless the view
/// was moved with it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum SpaceKey {
    /// It is not held.
    #[default]
    Up,
    /// It is held.
    Down,
    /// It is held and the view was moved.
    Panned,
}

/// What the menu was opened on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Opened {
    pub target: Target,
    /// In mm.
    pub at: Vector,
}

/// Where the canvas looks, what is in hand and what is being dragged.
#[derive(Debug)]
pub struct Canvas {
    /// Whether something lies over the window and has the keys.
    pub covered: bool,
    /// The document that it has seen, see [`Workbench::opened`].
    pub(super) opened: u64,
    pub(super) camera: Camera,
    /// Whether the view goes on to fit what the solver is about to find.
    pub(super) fitting: bool,
    pub(super) labels: Labels,
    pub(super) drag: Option<Drag>,
    pub(super) tool: Tool,
    /// The vertices of the polygon being drawn, in mm.
    pub(super) draft: Vec<Vector>,
    /// The selected vertex, by its obstacle's index and its own.
    pub(super) vertex: Option<(usize, usize)>,
    pub(super) menu: Option<Opened>,
    pub(super) space_key: SpaceKey,
    /// Whether Tab has selected everything in turn.
    pub(super) went_round: bool,
    /// What the robot has left by a jump.
    pub(super) shade: Option<Shade>,
    /// Since when the shape is greyed, in seconds of the window's clock.
    pub(super) stuck_since: Option<f64>,
    pub(super) id: Option<Id>,
    pub(super) rect: Rect,
    /// What the tools cover.
    pub(super) strip: Rect,
    /// Where the photograph is held while it is dragged, from its centre, in
    /// metres.
    pub(super) held_photo: Option<Vector>,
}

impl Default for Canvas {
    fn default() -> Self {
        Self {
            covered: false,
            opened: 0,
            camera: Camera::default(),
            fitting: true,
            labels: Labels::default(),
            drag: None,
            tool: Tool::Select,
            draft: Vec::new(),
            vertex: None,
            menu: None,
            space_key: SpaceKey::Up,
            went_round: false,
            shade: None,
            stuck_since: None,
            id: None,
            rect: Rect::NOTHING,
            strip: Rect::NOTHING,
            held_photo: None,
        }
    }
}

impl Canvas {
    /// Takes what the workbench has for it: another document is shown whole, and
    /// what a jump has left fades.
    pub(super) fn take_news(&mut self, bench: &mut Workbench) {
        if self.opened != bench.opened {
            self.opened = bench.opened;
            self.fit_soon();
        }
        if let Some(backbone) = bench.left_behind.take() {
            self.shade = Some(Shade::of(backbone));
        }
    }

    /// Shows everything at the next frame.
    pub fn fit_soon(&mut self) {
        self.camera.fit_soon();
        self.fitting = true;
    }

    /// Fits the view again at the next frame while the robot is on its way,
    /// unless the user has moved the view or moves something in it.
    pub(super) fn go_on_fitting(&mut self, live: &Live) {
        self.fitting &= !live.is_settled() && self.drag.is_none() && !self.camera.is_moved();
        if self.fitting {
            self.camera.fit_soon();
        }
    }

    /// Where the canvas looks: what is where on the screen.
    pub fn frame(&self) -> Frame {
        self.camera.frame()
    }

    /// Where it is on the screen.
    pub fn room(&self) -> Rect {
        self.rect
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

    /// Gives up what is being dragged or drawn and puts a tool away; the scene
    /// becomes what it was before. Whether there was anything.
    pub fn give_up(&mut self, scene: &mut Scene) -> bool {
        if let Some(drag) = self.drag.take() {
            scene.clone_from(drag.before());
            return true;
        }
        let any = self.is_giving_up_something();
        self.draft.clear();
        self.tool = Tool::Select;
        any
    }

    /// Whether there is something to give up.
    pub fn is_giving_up_something(&self) -> bool {
        self.drag.is_some() || !self.draft.is_empty() || self.tool != Tool::Select
    }

    /// Takes a tool in hand.
    pub fn take_tool(&mut self, tool: Tool) {
        self.draft.clear();
        self.tool = tool;
    }

    /// The tool in hand.
    pub fn tool(&self) -> Tool {
        self.tool
    }
}
