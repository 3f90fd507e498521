//! The window: canvas, panels and plots around a solver that never makes them
//! wait. The only layer that knows egui.
//!
//! [`State`] is what all parts read and change. A frame goes: what the solver
//! has found, commands, panels and canvas, which change the scene as they
//! like; at its end the scene settles ([`State::settle`]): a change that makes
//! it unsolvable is taken back with its reason, any other is asked of the
//! solver and becomes a step of undo when its gesture ends.

pub mod backend;
mod canvas;
mod commands;
pub mod dock;
mod document;
pub mod examples;
pub mod files;
#[cfg(not(target_arch = "wasm32"))]
mod fit;
mod history;
pub mod link;
mod live;
mod load;
pub mod look;
mod measured;
mod notices;
#[cfg(all(target_arch = "wasm32", feature = "web"))]
pub mod page;
mod paint;
pub mod panels;
mod photo;
mod pixels;
pub mod platform;
pub mod plots;
mod shapes;
mod sheets;
mod space;
mod state;
mod transport;
mod widgets;
#[cfg(not(target_arch = "wasm32"))]
pub mod window;
mod words;

pub use canvas::Hints;
pub use commands::Command;
pub use document::Document;
pub use shapes::Tool;
pub use state::{Hovered, Preferences, Selection, State, Views};

use crate::scene::Scene;
use backend::SolverBackend;
use eframe::egui::{self, Context, Ui};
use files::autosave::{Stored, Unsaved};
use notices::Notice;
use platform::Platform;
use std::path::PathBuf;

/// The scene that the window opens on.
const FIRST: &str = include_str!("../../assets/scenes/two-discs.toml");

/// The window's contents.
pub struct Sinew {
    state: State,
    #[cfg(not(target_arch = "wasm32"))]
    fit: fit::Fit,
}

impl Sinew {
    /// A window on a scene, or on the first example.
    ///
    /// # Errors
    /// When the scene cannot be solved: its faults.
    pub fn new(
        ctx: &Context,
        scene: Option<Scene>,
        backend: Box<dyn SolverBackend>,
        preferences: Preferences,
    ) -> Result<Self, Vec<crate::scene::SceneError>> {
        look::install(ctx);
        // Commands of the list do it, and what they do is kept.
        ctx.options_mut(|options| options.zoom_with_keyboard = false);
        let scene = match scene {
            Some(scene) => scene,
            None => Scene::from_toml(FIRST).map_err(|fault| vec![fault])?,
        };
        let document = Document::new(scene)?;
        Ok(Self {
            state: State::new(document, backend, preferences),
            #[cfg(not(target_arch = "wasm32"))]
            fit: fit::Fit::default(),
        })
    }

    /// The same with a system around it and what an earlier window has left.
    #[must_use]
    pub fn on(mut self, platform: Box<dyn Platform>, stored: Stored) -> Self {
        let state = &mut self.state;
        state.files.platform = platform;
        state.files.unsaved = Unsaved::left(&mut *state.files.platform);
        state.preferences = stored.preferences;
        state.files.recent = stored.recent;
        if let (Some(dock), Some(arrangement)) = (&mut state.dock, stored.dock) {
            dock.arrange(arrangement);
        }
        for lost in stored.lost {
            let told = format!("What was stored of {lost} cannot be read and is left out.");
            state.notices.tell(Notice::trouble(told));
        }
        self
    }

    /// The same with its scene's file.
    #[must_use]
    pub fn from_file(mut self, file: PathBuf) -> Self {
        self.state.files.remember(&file);
        self.state.document.file = Some(file);
        photo::fetch(&mut self.state);
        self
    }

    /// What the window shows.
    pub fn state(&self) -> &State {
        &self.state
    }

    /// Lets a test change what the window shows.
    pub fn state_mut(&mut self) -> &mut State {
        &mut self.state
    }
}

impl Sinew {
    /// What comes before a frame: what the system and the solver have to tell,
    /// and the pull of a robot that plays.
    pub fn before_frame(&mut self, ctx: &Context) {
        let state = &mut self.state;
        suit(ctx, &state.preferences);
        files::guard_closing(state, ctx);
        files::arrive(state, ctx);
        photo::arrive(state, ctx);
        measured::arrive(state, ctx);
        state.poll();
        if state.live.wants_frames() {
            ctx.request_repaint();
        }
        let span = state.span_mm();
        let seconds = f64::from(ctx.input(|input| input.stable_dt));
        let pull_mm = &mut state.document.scene.actuation.pull_mm;
        state.transport.advance(pull_mm, span, seconds);
        if state.transport.is_playing() {
            ctx.request_repaint();
        }
    }

    /// A frame.
    pub fn frame(&mut self, ui: &mut Ui) {
        let state = &mut self.state;
        let ctx = ui.ctx().clone();
        canvas::hold_space(&ctx, state);
        // What lies over the window has the keys.
        if !state.sheets.is_open() {
            state.commands.extend(commands::pressed(&ctx));
        }
        files::take_drops(state, &ctx);
        files::take_pastes(state, &ctx);
        panels::show(ui, state);
        egui::CentralPanel::no_frame().show(ui, |ui| views(ui, state));
        sheets::show(&ctx, state);
        state.notices.show(&ctx);
        files::announce(ui);
        // Commands find a scene that can be solved, so that every step of undo is
        // one.
        state.take_edits(&ctx);
        for command in std::mem::take(&mut state.commands) {
            commands::run(command, state, &ctx);
        }
        state.settle(&ctx);
        files::title(state, &ctx);
    }
}

impl eframe::App for Sinew {
    #[cfg_attr(
        target_arch = "wasm32",
        expect(unused_variables, reason = "a page has no place on a screen")
    )]
    fn logic(&mut self, ctx: &Context, frame: &mut eframe::Frame) {
        self.before_frame(ctx);
        #[cfg(not(target_arch = "wasm32"))]
        self.fit.look(ctx, frame);
    }

    fn ui(&mut self, ui: &mut Ui, frame: &mut eframe::Frame) {
        self.frame(ui);
        if self.state.gesture(ui.ctx()) == history::Gesture::Over {
            files::autosave::store_settled(&mut self.state, frame.storage_mut());
        }
    }

    fn save(&mut self, storage: &mut dyn eframe::Storage) {
        files::autosave::keep(&mut self.state);
        files::autosave::store(&self.state, storage);
    }

    fn auto_save_interval(&self) -> std::time::Duration {
        std::time::Duration::from_secs(5)
    }
}

/// Makes the window suit the user's choices.
fn suit(ctx: &Context, preferences: &Preferences) {
    ctx.set_theme(preferences.theme);
    ctx.set_zoom_factor(preferences.zoom);
    if ctx.input(|input| input.has_touch_screen()) {
        look::fit_fingers(ctx);
    }
    let seconds = if preferences.still {
        0.0
    } else {
        look::MOTION_SECONDS
    };
    if ctx.global_style().animation_time != seconds {
        ctx.all_styles_mut(|style| style.animation_time = seconds);
    }
}

/// The open views of the robot, in all the room there is.
fn views(ui: &mut Ui, state: &mut State) {
    match state.preferences.views {
        Views::Plane => canvas::show(ui, state),
        Views::Space => space::show(ui, state),
        Views::Both => {
            let width = 0.5 * ui.available_width();
            egui::Panel::right("space")
                .frame(egui::Frame::NONE)
                .default_size(width)
                .size_range(0.25 * width..=1.6 * width)
                .show(ui, |ui| space::show(ui, state));
            egui::CentralPanel::no_frame().show(ui, |ui| canvas::show(ui, state));
        }
    }
}
