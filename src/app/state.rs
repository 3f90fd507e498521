//! What every part of the window reads and changes.

use super::backend::SolverBackend;
use super::canvas::{Canvas, Hints};
use super::commands::Command;
use super::dock::Dock;
use super::document::{Document, Settled};
use super::files::Files;
use super::history::{Gesture, History};
use super::live::Live;
use super::measured::Measuring;
use super::notices::{Notice, Notices};
use super::panels::Panels;
use super::photo::Photos;
use super::platform::Detached;
use super::sheets::Sheets;
use super::space::Space;
use super::transport::{Transport, span_mm};
use super::words;
use crate::scene::{Scene, SceneError};
use crate::solving::StartFrom;
use crate::units::metres;
use crate::view::Notes;
use eframe::egui::Context;
use serde::{Deserialize, Serialize};

/// What is selected.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Selection {
    /// Nothing.
    #[default]
    Nothing,
    /// The robot.
    Robot,
    /// An obstacle, by its index in the scene.
    Obstacle(usize),
    /// The photograph.
    Photo,
    /// What was measured.
    Measured,
}

impl Selection {
    /// The obstacle that is selected, by its index in the scene.
    pub fn obstacle(self) -> Option<usize> {
        match self {
            Selection::Obstacle(index) => Some(index),
            _ => None,
        }
    }
}

/// What the pointer is on, in whichever part of the window: its twins light up
/// in all others.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Hovered {
    /// Nothing that has a twin.
    #[default]
    Nothing,
    /// A node, from 0 at the base.
    Node(usize),
    /// A contact, by its index in the solution.
    Contact(usize),
    /// An obstacle, by its index in the scene.
    Obstacle(usize),
    /// A pull, in metres.
    Pull(f64),
}

/// Which views of the robot are open.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub enum Views {
    /// The plane.
    #[default]
    Plane,
    /// The robot in space.
    Space,
    /// Both, side by side.
    Both,
}

/// The user's choices, which outlive the window.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct Preferences {
    /// Which views are open.
    pub views: Views,
    /// Whether the clearance field is drawn behind the robot.
    pub field: bool,
    /// Whether the grid is drawn.
    pub grid: bool,
    /// Whether the tip leaves a trace.
    pub trace: bool,
    /// Whether the outline and the inspector are open.
    pub outline: bool,
    /// Whether the plots are open.
    pub dock: bool,
    /// Light, dark or the system's.
    pub theme: eframe::egui::ThemePreference,
    /// Enlarges everything, [`Preferences::ZOOMS`].
    pub zoom: f32,
    /// Whether nothing moves by itself.
    pub still: bool,
    /// Which hints were of use already.
    pub hints: Hints,
}

/// A change of [`Preferences::zoom`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rescale {
    /// By a step.
    Larger,
    /// By a step.
    Smaller,
    /// Back to 1.
    Usual,
}

impl Preferences {
    /// The least and greatest [`Preferences::zoom`].
    pub const ZOOMS: (f32, f32) = (0.75, 2.0);

    /// Changes the size of everything.
    pub fn rescale(&mut self, by: Rescale) {
        // Steps of an eighth, from wherever it is.
        let eighths = self.zoom * 8.0;
        self.zoom = match by {
            Rescale::Larger => (eighths.floor() + 1.0) / 8.0,
            Rescale::Smaller => (eighths.ceil() - 1.0) / 8.0,
            Rescale::Usual => 1.0,
        };
        self.bring_into_range();
    }

    /// Corrects values that no control can give, as from a damaged file.
    pub fn bring_into_range(&mut self) {
        let (least, most) = Self::ZOOMS;
        // The order also replaces NaN.
        self.zoom = self.zoom.max(least).min(most);
    }
}

impl Default for Preferences {
    fn default() -> Self {
        Self {
            views: Views::Plane,
            field: true,
            grid: true,
            trace: true,
            outline: true,
            dock: true,
            theme: eframe::egui::ThemePreference::System,
            zoom: 1.0,
            still: false,
            hints: Hints::default(),
        }
    }
}

/// An edit that was taken back.
#[derive(Clone, Debug, PartialEq)]
pub struct Refusal {
    /// Why.
    pub faults: Vec<SceneError>,
    /// When, in seconds of the window's clock.
    pub at: f64,
}

/// Everything the window shows.
pub struct State {
    /// The scene.
    pub document: Document,
    /// Counts the documents that were opened: what was asked or begun for one
    /// is not for the next.
    pub opened: u64,
    /// Its past.
    pub history: History,
    /// Its solution.
    pub live: Live,
    /// What is selected.
    pub selection: Selection,
    /// What the pointer was on in the last frame …
    pub hovered: Hovered,
    /// … and what it is on in this one, as far as is known.
    pub hovering: Hovered,
    /// The canvas: where it looks and what is being dragged on it.
    pub canvas: Canvas,
    /// The view in space.
    pub space: Space,
    /// What the panels keep from frame to frame.
    pub panels: Panels,
    /// The plots and tables; not there while they are shown.
    pub dock: Option<Dock>,
    /// The pull over time.
    pub transport: Transport,
    /// The user's choices.
    pub preferences: Preferences,
    /// The last edit that was taken back, as long as it is told.
    pub refusal: Option<Refusal>,
    /// Commands to be run at the end of the frame.
    pub commands: Vec<Command>,
    /// The document's way to and from files.
    pub files: Files,
    /// What lies over the window.
    pub sheets: Sheets,
    /// What is being told.
    pub notices: Notices,
    /// The photographs that were seen.
    pub photos: Photos,
    /// Measurements against the robot.
    pub measuring: Measuring,
}

impl State {
    /// The state of a window that opens on a document.
    pub fn new(
        document: Document,
        backend: Box<dyn SolverBackend>,
        preferences: Preferences,
    ) -> Self {
        let notes = Notes::of(&document.scene);
        Self {
            history: History::new(&document.scene),
            live: Live::new(backend, document.problem(), span(&document), &notes),
            document,
            opened: 0,
            selection: Selection::Nothing,
            hovered: Hovered::Nothing,
            hovering: Hovered::Nothing,
            canvas: Canvas::default(),
            space: Space::default(),
            dock: Some(Dock::default()),
            panels: Panels::default(),
            transport: Transport::default(),
            preferences,
            refusal: None,
            commands: Vec::new(),
            files: Files::new(Box::new(Detached::default())),
            sheets: Sheets::default(),
            notices: Notices::default(),
            photos: Photos::default(),
            measuring: Measuring::default(),
        }
    }

    /// Opens a scene in the place of the present one, solved from the straight
    /// robot. Undo leads back.
    ///
    /// # Errors
    /// When the scene cannot be solved: its faults. The present one stays.
    pub fn open(&mut self, scene: Scene) -> Result<(), Vec<SceneError>> {
        self.document = Document::new(scene)?;
        self.opened += 1;
        self.selection = Selection::Nothing;
        self.transport.stop();
        self.canvas.fit_soon();
        self.space.fit_soon();
        self.restart();
        Ok(())
    }

    /// Follows the present scene anew from the straight robot.
    pub fn restart(&mut self) {
        self.ask(StartFrom::Straight);
    }

    fn ask(&mut self, from: StartFrom) {
        let span = span(&self.document);
        self.live.ask(self.document.problem(), from, span);
    }

    /// Takes what the solver has found.
    pub fn poll(&mut self) {
        if self.live.poll() {
            if let Some(leap) = self.live.take_leap() {
                let told = words::event(&leap.jump, &self.document.scene);
                self.notices.tell(Notice::information(told));
                self.canvas.leave_behind(leap.backbone);
            }
            self.canvas.follow_tip(&self.live);
            self.redraw();
        }
    }

    /// Takes the scene as it has become and asks for its shape or, if it cannot
    /// be solved, takes the last change back. What is painted after this shows
    /// what was done before it in the same frame.
    pub fn take_edits(&mut self, ctx: &Context) {
        match self.document.settle() {
            Settled::Unchanged => {}
            Settled::Changed => {
                self.refusal = None;
                self.ask(StartFrom::Last);
                self.redraw();
                ctx.request_repaint();
            }
            Settled::Refused(faults) => {
                let at = ctx.input(|input| input.time);
                self.refusal = Some(Refusal { faults, at });
                ctx.request_repaint();
            }
        }
        let count = self.document.scene.obstacles.len();
        if self
            .selection
            .obstacle()
            .is_some_and(|index| index >= count)
        {
            self.selection = Selection::Nothing;
            if self.refusal.is_some() {
                self.panels.follow(self.selection);
            }
        }
    }

    /// At the end of a frame: takes what was done in it, as a step of undo if
    /// it is over.
    pub fn settle(&mut self, ctx: &Context) {
        self.take_edits(ctx);
        let gesture = self.gesture(ctx);
        self.history.observe(&self.document.scene, gesture);
        if self.hovering != self.hovered {
            // Its twins light up in parts that were shown before this was known.
            ctx.request_repaint();
        }
        self.hovered = std::mem::take(&mut self.hovering);
    }

    /// Whether the user is in the middle of something that is to be one step
    /// of undo.
    pub fn gesture(&self, ctx: &Context) -> Gesture {
        let held = ctx.input(|input| input.pointer.any_down() || !input.keys_down.is_empty());
        if held || self.transport.is_playing() || ctx.text_edit_focused() {
            Gesture::Going
        } else {
            Gesture::Over
        }
    }

    /// The pulls that the slider covers, in mm.
    pub fn span_mm(&self) -> (f64, f64) {
        let scene = &self.document.scene;
        let allowed = self.document.problem().robot().pull_range();
        span_mm(&scene.robot, allowed, scene.actuation.pull_mm)
    }

    /// Draws anew what has changed.
    pub fn redraw(&mut self) {
        let mut notes = Notes::of(&self.document.scene);
        if self.preferences.trace {
            notes.tip_trace = self.canvas.trace().to_vec();
        }
        self.live.redraw(&notes);
    }
}

/// The pulls that the path of a document covers, in metres.
fn span(document: &Document) -> (f64, f64) {
    let allowed = document.problem().robot().pull_range();
    let scene = &document.scene;
    let (least, most) = span_mm(&scene.robot, allowed, scene.actuation.pull_mm);
    (metres(least), metres(most))
}
