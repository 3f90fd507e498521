//! A window without a screen, driven by the events that a mouse and a keyboard
//! make. Solved inline, so that nothing races.

#![allow(dead_code, reason = "each test of the window drives it in its own way")]

use eframe::egui::{Event, Key, Modifiers, PointerButton, Pos2, Theme, pos2, vec2};
use egui_kittest::Harness;
use sinew::app::backend::Inline;
use sinew::app::{Canvas, Preferences, Sinew, Workbench};
use sinew::geometry::Vector;
use sinew::scene::{Obstacle, Scene, Shape};

/// A window and what is done to it.
pub struct Window {
    /// The window.
    pub harness: Harness<'static, Sinew>,
}

impl Window {
    /// A window on a scene, or on the first example.
    pub fn open(scene: Option<Scene>) -> Self {
        Self::sized([1280.0, 800.0], Theme::Light, scene)
    }

    /// A window of a size and a theme.
    pub fn sized(size: [f32; 2], theme: Theme, scene: Option<Scene>) -> Self {
        let mut window = Self::with(size, theme, scene, Inline::to_the_end());
        window.harness.run();
        window
    }

    /// A window that is solved in its own way, which has not begun.
    pub fn with(size: [f32; 2], theme: Theme, scene: Option<Scene>, backend: Inline) -> Self {
        let preferences = Preferences {
            theme: theme.into(),
            ..Preferences::default()
        };
        let harness = Harness::builder()
            .with_size(vec2(size[0], size[1]))
            .with_pixels_per_point(1.0)
            .with_theme(theme)
            .with_step_dt(1.0 / 60.0)
            .with_max_steps(240)
            .wgpu()
            .build_eframe(move |cc| {
                sinew::render::install(cc.wgpu_render_state.as_ref().unwrap());
                Sinew::new(&cc.egui_ctx, scene, Box::new(backend), preferences).unwrap()
            });
        Self { harness }
    }

    /// The user's work.
    pub fn bench(&self) -> &Workbench {
        self.harness.state().bench()
    }

    /// The canvas.
    pub fn canvas(&self) -> &Canvas {
        self.harness.state().canvas()
    }

    /// The scene as it is.
    pub fn scene(&self) -> &Scene {
        &self.bench().document.scene
    }

    /// An obstacle's shape.
    pub fn shape(&self, index: usize) -> &Shape {
        &self.scene().obstacles[index].shape
    }

    /// Where a point in millimetres is on the screen.
    pub fn at(&self, x_mm: f64, y_mm: f64) -> Pos2 {
        let frame = self.canvas().frame();
        let at = frame.to_screen(1e-3 * Vector::new(x_mm, y_mm));
        pos2(at.x as f32, at.y as f32)
    }

    /// Points of the screen in a millimetre.
    pub fn points(&self, mm: f64) -> f32 {
        (self.canvas().frame().scale * 1e-3 * mm) as f32
    }

    /// Where the tip is on the screen.
    pub fn tip(&self) -> Pos2 {
        let tip = self.bench().live.solution().unwrap().tip().position;
        self.at(1e3 * tip.x, 1e3 * tip.y)
    }

    /// Whether something is being told that holds these words.
    pub fn is_told(&self, words: &str) -> bool {
        let mut notices = self.bench().notices.iter();
        notices.any(|notice| notice.text.contains(words))
    }

    /// Moves the pointer.
    pub fn point(&mut self, at: Pos2) {
        self.harness.hover_at(at);
        self.harness.run();
    }

    /// Presses or releases a button at a place.
    pub fn button(&mut self, at: Pos2, button: PointerButton, pressed: bool) {
        let modifiers = self.harness.ctx.input(|input| input.modifiers);
        self.harness.event(Event::PointerButton {
            pos: at,
            button,
            pressed,
            modifiers,
        });
        self.harness.step();
    }

    /// Presses the primary button and goes through places, not letting go.
    pub fn hold(&mut self, path: &[Pos2]) {
        self.point(path[0]);
        self.button(path[0], PointerButton::Primary, true);
        for ends in path.windows(2) {
            for step in 1..=8 {
                self.point(ends[0].lerp(ends[1], step as f32 / 8.0));
            }
        }
    }

    /// Lets the primary button go.
    pub fn release(&mut self, at: Pos2) {
        self.button(at, PointerButton::Primary, false);
        self.harness.run();
    }

    /// Drags from place to place.
    pub fn drag(&mut self, path: &[Pos2]) {
        self.hold(path);
        self.release(path[path.len() - 1]);
    }

    /// Clicks with a button.
    pub fn click_with(&mut self, at: Pos2, button: PointerButton) {
        self.point(at);
        self.button(at, button, true);
        self.button(at, button, false);
        self.harness.run();
        // Not a part of a double click.
        self.harness.run_steps(30);
    }

    /// Clicks.
    pub fn click(&mut self, at: Pos2) {
        self.click_with(at, PointerButton::Primary);
    }

    /// Clicks twice.
    pub fn double_click(&mut self, at: Pos2) {
        self.point(at);
        for _ in 0..2 {
            self.button(at, PointerButton::Primary, true);
            self.button(at, PointerButton::Primary, false);
        }
        self.harness.run();
        self.harness.run_steps(30);
    }

    /// Holds modifiers, or lets them go.
    pub fn modifiers(&mut self, modifiers: Modifiers) {
        self.harness.event(Event::ModifiersChanged(modifiers));
        self.harness.step();
    }

    /// Presses a key and lets it go.
    pub fn key(&mut self, key: Key) {
        self.harness.key_press(key);
        self.harness.run();
    }

    /// The same with modifiers.
    pub fn key_with(&mut self, modifiers: Modifiers, key: Key) {
        self.harness.key_press_modifiers(modifiers, key);
        self.harness.run();
    }

    /// Saves a picture in the folder that SHOTS names, for looking at.
    pub fn shoot(&mut self, name: &str) {
        if let Some(folder) = std::env::var_os("SHOTS") {
            let file = std::path::Path::new(&folder).join(format!("{name}.png"));
            self.harness.render().unwrap().save(file).unwrap();
        }
    }
}

/// The paper's robot at a pull among some shapes.
pub fn scene(pull_mm: f64, shapes: impl IntoIterator<Item = Shape>) -> Scene {
    let mut scene = Scene {
        obstacles: shapes.into_iter().map(Obstacle::from).collect(),
        ..Scene::default()
    };
    scene.set_pull_mm(pull_mm);
    scene
}
