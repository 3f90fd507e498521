//! The workbench: the user's work, and what all parts of the window read and
//! change of it. It knows no part of the window: who has something to say to a
//! part says it here, as data, and the part looks for it when it is shown.
//!
//! A part changes the scene as it likes. The scene then settles
//! ([`Workbench::settle`]): a change that makes it unsolvable is taken back with
//! its reason, any other is asked of the solver and becomes a step of undo when
//! its gesture ends. What drives the robot is set in one way
//! ([`Workbench::set_pull`]); what the user can ask for by a key or a button is
//! left in [`Workbench::commands`] until the end of the frame.

mod allowed;
mod along;
mod document;
mod files;
mod held_scale;
mod history;
mod live;
mod load_trace;
mod loads;
mod measuring;
mod models;
mod notices;
mod other;
mod photos;
mod pins;
mod preferences;
mod pull;
mod refined;
mod refusal;
mod selection;
mod trace;
mod transport;
mod trouble;
mod unsaved;

pub use along::{Along, Way};
pub use document::Document;
pub use files::{Arrival, Asked, Files, Intent, Saved};
pub use held_scale::HeldScale;
pub use history::{Gesture, History};
pub use live::{Answered, Live};
pub use load_trace::{LoadTrace, Loaded, Step};
pub use loads::Loads;
pub use measuring::{Basis, Best, Measuring, Search};
pub use models::{Assumed, Followed, Models};
pub use notices::{Notice, Notices, Tone};
pub use other::Other;
pub use photos::{Coming, Photograph, Photos, Scaling, photo_centre};
pub use pins::{Pin, Pins};
pub use preferences::{Hints, Preferences, Rescale, Views};
pub use pull::{Held, Playing};
pub use refined::{Refined, Refinement};
pub use refusal::{Complaint, Refusal};
pub use selection::{Hovered, Selection, nodes_of_stretch};
pub use trace::Trace;
pub use transport::Transport;
pub use trouble::Trouble;
pub use unsaved::Unsaved;

use super::backend::SolverBackend;
use super::commands::Command;
use super::platform::Detached;
use super::words;
use crate::geometry::Vector;
use crate::scene::{Scene, SceneError};
use crate::solving::{Answer, Order, StartFrom, Task, TaskId, Update};
use crate::view::Notes;
use document::Settled;
use eframe::egui::Context;

/// The user's work.
pub struct Workbench {
    /// The scene.
    pub document: Document,
    /// Counts the documents that were opened: what was asked or begun for one
    /// is not for the next. A view that has seen fewer shows everything.
    pub opened: u64,
    /// Its past.
    pub history: History,
    /// Its solution.
    pub live: Live,
    /// Who solves.
    solver: Box<dyn SolverBackend>,
    /// Tasks that were given to the solver.
    tasks: u64,
    /// Where the tip has been.
    pub trace: Trace,
    /// What forces are drawn by.
    pub held_scale: HeldScale,
    /// How the cables were loaded.
    pub load_trace: LoadTrace,
    /// The backbone's nodes, in metres, before the last jump, until a view takes
    /// them.
    pub left_behind: Option<Vec<Vector>>,
    /// What is selected.
    pub selection: Selection,
    /// What the pointer was on in the last frame …
    pub hovered: Hovered,
    /// … and what it is on in this one, as far as is known.
    pub hovering: Hovered,
    /// Whether something on the canvas can be given up: a drag, a drawing or a
    /// tool in hand.
    pub is_in_hand: bool,
    /// The pull over time.
    pub transport: Transport,
    /// The user's choices.
    pub preferences: Preferences,
    /// The last edit that was taken back, as long as it is told.
    pub refusal: Option<Refusal>,
    /// What was wrong with what was typed last.
    pub complaint: Option<Complaint>,
    /// What refusal and complaint are of: what the inspector showed last.
    pub inspected: Selection,
    /// Commands to be run at the end of the frame.
    pub commands: Vec<Command>,
    /// The document's way to and from files.
    pub files: Files,
    /// What did not work and is to be read, until it is shown.
    pub trouble: Option<Trouble>,
    /// What is being told.
    pub notices: Notices,
    /// The photographs that were seen.
    pub photos: Photos,
    /// Measurements against the robot.
    pub measuring: Measuring,
    /// The scene in the other mechanics.
    pub other: Other,
    /// The path along another cable than the first.
    pub along: Along,
    /// The path of the first cable in other models.
    pub models: Models,
    /// The scene with twice the segments.
    pub refined: Refined,
    /// Robots that were pinned.
    pub pins: Pins,
}

impl Workbench {
    /// A workbench with a document on it.
    pub fn new(
        document: Document,
        solver: Box<dyn SolverBackend>,
        preferences: Preferences,
    ) -> Self {
        let notes = Notes::of(&document.scene);
        let mut bench = Self {
            history: History::new(&document.scene),
            live: Live::new(document.problem(), &notes),
            solver,
            tasks: 0,
            document,
            opened: 0,
            trace: Trace::default(),
            held_scale: HeldScale::default(),
            load_trace: LoadTrace::default(),
            left_behind: None,
            selection: Selection::Nothing,
            hovered: Hovered::Nothing,
            hovering: Hovered::Nothing,
            is_in_hand: false,
            transport: Transport::default(),
            preferences,
            refusal: None,
            complaint: None,
            inspected: Selection::Nothing,
            commands: Vec::new(),
            files: Files::new(Box::new(Detached::default())),
            trouble: None,
            notices: Notices::default(),
            photos: Photos::default(),
            measuring: Measuring::default(),
            other: Other::default(),
            along: Along::default(),
            models: Models::default(),
            refined: Refined::default(),
            pins: Pins::default(),
        };
        bench.restart();
        bench
    }

    /// Opens a scene in the place of the present one, solved from the straight
    /// robot. Undo leads back.
    ///
    /// # Errors
    /// When the scene cannot be solved: its faults. The present one stays.
    pub fn open(&mut self, scene: Scene) -> Result<(), Vec<SceneError>> {
        self.document = Document::new(scene)?;
        self.opened += 1;
        self.held_scale = HeldScale::default();
        self.pins.clear();
        self.selection = Selection::Nothing;
        self.transport.stop();
        self.trace.clear();
        self.restart();
        Ok(())
    }

    /// Follows the present scene anew from the straight robot.
    pub fn restart(&mut self) {
        self.load_trace.clear();
        self.ask(StartFrom::Straight);
    }

    fn ask(&mut self, from: StartFrom) {
        let span = pull::span(&self.document);
        let request = self.live.ask(self.document.problem(), from, span);
        self.solver.submit(Order::Live(request));
        if let Some(task) = self.measuring.give_up(&self.document.scene) {
            self.cancel(task);
        }
    }

    /// Gives the solver a task, to be done in the pauses of live work. Whoever
    /// has asked for it finds its answer by the name returned.
    pub fn begin(&mut self, task: Task) -> TaskId {
        self.tasks += 1;
        let id = TaskId(self.tasks);
        self.solver.submit(Order::Task(id, task));
        id
    }

    /// Has the solver do a task no more.
    pub fn cancel(&mut self, task: TaskId) {
        self.solver.submit(Order::Cancel(task));
    }

    /// Whether the solver needs frames to go on.
    pub fn wants_frames(&self) -> bool {
        self.solver.wants_frames()
    }

    /// Takes what the solver has found.
    pub fn poll(&mut self) {
        let mut news = false;
        while let Some(found) = self.solver.poll() {
            match found.update {
                Update::Shape(shape) => news |= self.live.take_shape(*shape, found.time),
                Update::Path { course, path } => {
                    self.live.take_path(course, path);
                    news = true;
                }
                Update::Share { task, share } => self.measuring.go_on(task, share),
                Update::Answer { task, answer } => match *answer {
                    Answer::BestPull(fit) => self.measuring.end(task, fit),
                    Answer::Shape(shape) if self.refined.has_asked(task) => {
                        self.refined.take(task, *shape);
                    }
                    Answer::Shape(shape) => self.other.take(task, *shape),
                    Answer::Path(path) if self.models.has_asked(task) => {
                        self.models.take(task, *path);
                    }
                    Answer::Path(path) => self.along.take(task, *path),
                },
            }
        }
        if news {
            if let Some(leap) = self.live.take_leap() {
                let told = words::event(&leap.jump, &self.document.scene);
                self.notices.tell(Notice::information(told));
                self.left_behind = Some(leap.backbone);
            }
            self.trace.follow(&self.live);
            self.load_trace.follow(&self.live);
            self.redraw();
        }
        self.look_at_the_other();
        self.look_along();
    }

    /// Takes the scene as it has become and asks for its shape or, if it cannot
    /// be solved, takes the last change back. What is painted after this shows
    /// what was done before it in the same frame.
    pub fn take_edits(&mut self, ctx: &Context) {
        match self.document.settle() {
            Settled::Unchanged => {}
            Settled::Changed => {
                self.refusal = None;
                // Friction that comes to a shape that is there holds it as it is: what
                // was typed would change nothing until the robot moves.
                let drives = [&self.live.problem(), &self.document.problem()];
                let [before, now] = drives.map(|problem| problem.drive().friction);
                self.ask(match before == now {
                    true => StartFrom::Last,
                    false => StartFrom::Straight,
                });
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
        let selected = self.selection.obstacle();
        if selected.is_some_and(|index| index >= count) {
            self.selection = Selection::Nothing;
            if self.refusal.is_some() {
                // What was selected went because it was taken back: that is not
                // to make anyone forget why.
                self.inspected = self.selection;
            }
        }
    }

    /// At the end of a frame: takes what was done in it, as a step of undo if
    /// it is over.
    pub fn settle(&mut self, ctx: &Context) {
        self.take_edits(ctx);
        self.look_at_refined();
        if self.look_at_the_other() | self.look_along() | self.look_at_models() {
            ctx.request_repaint();
        }
        let gesture = self.gesture(ctx);
        let was_going = std::mem::replace(&mut self.held_scale.is_going, gesture == Gesture::Going);
        if was_going && gesture == Gesture::Over {
            // What was held may be let go.
            let held = self.live.drawing().scale;
            if self.force_scale() != held {
                self.redraw();
                ctx.request_repaint();
            }
        }
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

    /// Forgets what was wrong with one thing when another is selected.
    pub fn inspect(&mut self) {
        if self.inspected != self.selection {
            self.inspected = self.selection;
            self.complaint = None;
            self.refusal = None;
        }
    }

    /// Draws anew what has changed.
    pub fn redraw(&mut self) {
        let mut notes = Notes::of(&self.document.scene);
        notes.scale = Some(self.force_scale());
        if self.preferences.trace {
            notes.tip_trace = self.trace.points().to_vec();
        }
        self.live.redraw(&notes);
    }
}

#[cfg(test)]
pub use photos::tests::photo;

#[cfg(test)]
impl Workbench {
    /// A workbench of a test: a scene that can be solved, and the solver at hand.
    pub fn with(scene: Scene) -> Self {
        let document = Document::new(scene).unwrap();
        let backend = super::backend::Inline::to_the_end();
        Self::new(document, Box::new(backend), Preferences::default())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::Shape;

    fn with_disc(x_mm: f64) -> Scene {
        let mut scene = Scene::default();
        let disc = Shape::Disc {
            center_mm: [x_mm, 100.0],
            radius_mm: 5.0,
        };
        scene.obstacles.push(disc.into());
        scene
    }

    #[test]
    fn what_is_refused_is_told_until_something_else_is_looked_at() {
        let ctx = Context::default();
        let mut bench = Workbench::with(with_disc(60.0));
        bench.selection = Selection::Obstacle(0);
        bench.inspect();
        // Another disc, over the robot's base: it goes, and so does that it was
        // selected, but not why.
        let mut other = with_disc(0.0).obstacles.remove(0);
        other.shape.move_to_mm([0.0, 0.0]);
        bench.document.scene.obstacles.push(other);
        bench.selection = Selection::Obstacle(1);
        bench.take_edits(&ctx);
        assert_eq!(bench.document.scene, with_disc(60.0));
        assert_eq!(bench.selection, Selection::Nothing);
        bench.inspect();
        assert!(bench.refusal.is_some());
        bench.selection = Selection::Robot;
        bench.inspect();
        assert!(bench.refusal.is_none());
    }

    #[test]
    fn another_document_is_counted_and_has_no_trace() {
        let mut bench = Workbench::with(with_disc(60.0));
        bench.poll();
        assert_eq!(bench.trace.points().len(), 1);
        bench.selection = Selection::Robot;
        bench.open(with_disc(70.0)).unwrap();
        assert_eq!((bench.opened, bench.selection), (1, Selection::Nothing));
        assert!(bench.trace.points().is_empty());
        // One that cannot be solved changes nothing.
        let mut scene = with_disc(60.0);
        scene.robot.length_mm = -1.0;
        assert!(bench.open(scene).is_err());
        assert_eq!(bench.opened, 1);
        assert_eq!(bench.document.scene, with_disc(70.0));
    }
}
