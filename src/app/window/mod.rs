//! The window: it owns the workbench and the parts that show it, and passes on
//! what one of them means for the others.
//!
//! A frame goes: what the system and the solver have found, the keys of
//! commands, the parts, which change the scene as they like, then the commands
//! that were asked for; at its end the scene settles
//! ([`Workbench::settle`]).

#[cfg(not(target_arch = "wasm32"))]
mod fit;
mod layout;
mod notices;
mod run;
pub mod stored;

use super::backend::SolverBackend;
use super::canvas::{self, Canvas};
use super::dock::Dock;
use super::files::{self, autosave};
use super::panels::Panels;
use super::platform::Platform;
use super::sheets::{self, Sheets};
use super::space::Space;
use super::workbench::{Document, Gesture, Notice, Preferences, Unsaved, Views, Workbench};
use super::{commands, look, photo};
use crate::scene::{Scene, SceneError};
use eframe::egui::{Context, Ui};
use layout::SidePanel;
use std::path::PathBuf;
use stored::{Snapshot, Stored};

/// The scene that the window opens on.
const FIRST: &str = include_str!("../../../assets/scenes/two-posts.toml");

/// The window's contents.
pub struct Sinew {
    bench: Workbench,
    canvas: Canvas,
    space: Space,
    panels: Panels,
    /// What is open below the canvas of a narrow window.
    below: Option<SidePanel>,
    dock: Dock,
    sheets: Sheets,
    /// What was last stored.
    stored: Option<Snapshot>,
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
    ) -> Result<Self, Vec<SceneError>> {
        look::install(ctx);
        // Commands of the list do it, and what they do is kept.
        ctx.options_mut(|options| options.zoom_with_keyboard = false);
        let scene = match scene {
            Some(scene) => scene,
            None => Scene::from_toml(FIRST).map_err(|fault| vec![fault])?,
        };
        let document = Document::new(scene)?;
        Ok(Self {
            bench: Workbench::new(document, backend, preferences),
            canvas: Canvas::default(),
            space: Space::default(),
            panels: Panels::default(),
            below: None,
            dock: Dock::default(),
            sheets: Sheets::default(),
            stored: None,
            #[cfg(not(target_arch = "wasm32"))]
            fit: fit::Fit::default(),
        })
    }

    /// The same with a system around it and what an earlier window has left.
    #[must_use]
    pub fn on(mut self, platform: Box<dyn Platform>, stored: Stored) -> Self {
        let bench = &mut self.bench;
        bench.files.platform = platform;
        bench.files.unsaved = Unsaved::left(&mut *bench.files.platform);
        bench.preferences = stored.preferences;
        bench.files.recent = stored.recent;
        if let Some(arrangement) = stored.dock {
            self.dock.arrange(arrangement);
        }
        for lost in stored.lost {
            let told = format!("What was stored of {lost} cannot be read and is left out.");
            bench.notices.tell(Notice::trouble(told));
        }
        self
    }

    /// The same with its scene's file.
    #[must_use]
    pub fn from_file(mut self, file: PathBuf) -> Self {
        self.bench.files.remember(&file);
        self.bench.document.file = Some(file);
        photo::fetch(&mut self.bench);
        self
    }

    /// The user's work.
    pub fn bench(&self) -> &Workbench {
        &self.bench
    }

    /// Lets a page, or a test, change the user's work.
    pub fn bench_mut(&mut self) -> &mut Workbench {
        &mut self.bench
    }

    /// The canvas.
    pub fn canvas(&self) -> &Canvas {
        &self.canvas
    }

    /// The plots and tables.
    pub fn dock(&self) -> &Dock {
        &self.dock
    }

    /// Whether anything lies over the window.
    pub fn is_covered(&self) -> bool {
        self.sheets.is_open(&self.bench)
    }

    /// What comes before a frame: what the system and the solver have to tell,
    /// and the pull of a robot that plays.
    pub fn before_frame(&mut self, ctx: &Context) {
        let bench = &mut self.bench;
        suit(ctx, &bench.preferences);
        files::guard_closing(bench, ctx);
        files::arrive(bench, ctx);
        photo::arrive(bench, ctx);
        self.sheets.take_news(bench);
        bench.poll();
        if bench.wants_frames() {
            ctx.request_repaint();
        }
        bench.play_on(f64::from(ctx.input(|input| input.stable_dt)));
        if bench.transport.is_playing() {
            ctx.request_repaint();
        }
    }

    /// A frame.
    pub fn frame(&mut self, ui: &mut Ui) {
        let ctx = ui.ctx().clone();
        self.cover();
        canvas::hold_space(&ctx, &mut self.canvas, &mut self.bench);
        // What lies over the window has the keys.
        if !self.sheets.is_open(&self.bench) {
            self.bench.commands.extend(commands::pressed(&ctx));
        }
        files::take_drops(&mut self.bench, &ctx);
        if !self.sheets.is_open(&self.bench) {
            files::take_pastes(&mut self.bench, &ctx);
        }
        self.show(ui);
        sheets::show(&ctx, &mut self.sheets, &mut self.bench);
        let shown = self.bench.preferences.views != Views::Space;
        let (room, kept) = match shown {
            true => (self.canvas.room(), canvas::kept(&self.canvas, &self.bench)),
            false => (ctx.content_rect(), Vec::new()),
        };
        notices::show(&ctx, &mut self.bench.notices, room, &kept);
        files::announce(ui);
        // Commands find a scene that can be solved, so that every step of undo is
        // one.
        self.bench.take_edits(&ctx);
        for command in std::mem::take(&mut self.bench.commands) {
            self.run(command, &ctx);
        }
        self.bench.settle(&ctx);
        files::title(&mut self.bench, &ctx);
    }

    /// Tells the canvas whether something lies over it.
    fn cover(&mut self) {
        self.sheets.take_news(&mut self.bench);
        self.canvas.covered = self.sheets.is_open(&self.bench);
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
        if self.bench.gesture(ui.ctx()) == Gesture::Over {
            self.store_settled(frame.storage_mut());
        }
    }

    fn save(&mut self, storage: &mut dyn eframe::Storage) {
        autosave::keep(&mut self.bench);
        stored::store(&self.bench, &self.dock, storage);
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
