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
mod document;
pub mod examples;
pub mod files;
mod history;
pub mod link;
mod live;
pub mod look;
mod measured;
mod notices;
mod panels;
mod photo;
pub mod platform;
mod sheets;
mod state;
mod transport;
#[cfg(not(target_arch = "wasm32"))]
pub mod window;
mod words;

pub use commands::Command;
pub use document::Document;
pub use state::{Hovered, Preferences, Selection, State, Views};

use crate::scene::Scene;
use backend::SolverBackend;
use eframe::egui::{self, Context, Ui};

/// The scene that the window opens on.
const FIRST: &str = include_str!("../../assets/scenes/two-discs.toml");

/// The window's contents.
pub struct Sinew {
    state: State,
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
        let scene = match scene {
            Some(scene) => scene,
            None => Scene::from_toml(FIRST).map_err(|fault| vec![fault])?,
        };
        let document = Document::new(scene)?;
        Ok(Self {
            state: State::new(document, backend, preferences),
        })
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

impl eframe::App for Sinew {
    fn logic(&mut self, ctx: &Context, _frame: &mut eframe::Frame) {
        let state = &mut self.state;
        ctx.set_theme(state.preferences.theme);
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

    fn ui(&mut self, ui: &mut Ui, _frame: &mut eframe::Frame) {
        let state = &mut self.state;
        state.commands.extend(commands::pressed(ui.ctx()));
        panels::show(ui, state);
        egui::CentralPanel::no_frame().show(ui, |ui| canvas::show(ui, state));
        for command in std::mem::take(&mut state.commands) {
            commands::run(command, state, ui.ctx());
        }
        state.settle(ui.ctx());
    }
}
