//! Whatever is done to the window, it stays a window: thousands of random
//! gestures, keys, edits and nonsense, frame by frame. Nothing may panic, no
//! number drawn may be other than finite, what is called converged must be
//! certified, and undo must lead back to the start and redo to the end.

use eframe::egui::{
    Context, Event, Key, Modifiers, MouseWheelSource, MouseWheelUnit, PointerButton, Pos2,
    RawInput, Rect, Shape, TouchPhase, pos2, vec2,
};
use proptest::prelude::*;
use proptest::test_runner::{
    Config, RngAlgorithm, TestCaseError, TestCaseResult, TestRng, TestRunner,
};
use sinew::app::backend::Inline;
use sinew::app::{Command, Preferences, Sinew};
use sinew::equilibrium::Status;
use sinew::mechanics::Problem;
use sinew::scene::{self, Scene};

/// Runs, and things done in each: 20 000 in all.
const RUNS: u32 = 20;
const ACTIONS: usize = 1000;

/// Something done to the window.
#[derive(Clone, Debug)]
enum Action {
    Press(f32, f32, PointerButton),
    Move(f32, f32),
    Release,
    DoubleClick(f32, f32),
    Wheel(f32, f32, f32),
    Key(Key, Modifiers),
    Write(&'static str),
    Command(Command),
    Pull(f64),
    MoveObstacle(usize, [f64; 2]),
    Add(scene::Shape),
    Turn(f64),
    Segments(u32, u32),
    Offset(f64),
}

/// Keys that mean something, none of which opens a file.
const KEYS: &[Key] = &[
    Key::ArrowLeft,
    Key::ArrowRight,
    Key::ArrowUp,
    Key::ArrowDown,
    Key::Tab,
    Key::Enter,
    Key::Escape,
    Key::Delete,
    Key::Backspace,
    Key::Space,
    Key::F,
    Key::R,
    Key::L,
    Key::M,
    Key::O,
    Key::Z,
    Key::D,
    Key::G,
    Key::K,
    Key::Num1,
    Key::Num2,
    Key::Num3,
    Key::F1,
    Key::F2,
];

const TEXTS: &[&str] = &["12", "-3.5", "NaN", "1e999", "abc", "2 cm", "", "∞", "0"];

const COMMANDS: &[Command] = &[
    Command::Undo,
    Command::Redo,
    Command::Duplicate,
    Command::Delete,
    Command::Deselect,
    Command::Play,
    Command::FromStraight,
    Command::Load,
    Command::Mechanics,
    Command::Compare,
    Command::Fit,
    Command::ViewPlane,
    Command::ViewBoth,
    Command::Outline,
    Command::Dock,
    Command::Theme,
    Command::Palette,
    Command::Help,
    Command::Settings,
];

fn shape() -> impl Strategy<Value = scene::Shape> {
    let place = [-60.0..200.0f64, -20.0..220.0f64];
    (place, 1.0..30.0f64, -400.0..400.0f64, 0..4u8).prop_map(|(at, size, turn, kind)| match kind {
        0 => scene::Shape::Disc {
            center_mm: at,
            radius_mm: size,
        },
        1 => scene::Shape::Box {
            center_mm: at,
            size_mm: [size, 2.0 * size],
            rotation_deg: turn,
            corner_radius_mm: 0.1 * size,
        },
        2 => scene::Shape::Capsule {
            center_mm: at,
            length_mm: size,
            radius_mm: 0.3 * size,
            rotation_deg: turn,
        },
        _ => scene::Shape::Wall {
            point_mm: at,
            rotation_deg: turn,
            corner_radius_mm: 0.0,
        },
    })
}

/// Mostly sense, now and then nonsense.
fn number(range: std::ops::Range<f64>) -> impl Strategy<Value = f64> {
    prop_oneof![
        12 => range,
        1 => Just(f64::NAN),
        1 => Just(f64::INFINITY),
        1 => -1e9..1e9f64,
    ]
}

fn action() -> impl Strategy<Value = Action> {
    let spot = || (0.0..1280.0f32, 0.0..800.0f32);
    let button = prop_oneof![
        5 => Just(PointerButton::Primary),
        1 => Just(PointerButton::Secondary),
        1 => Just(PointerButton::Middle),
    ];
    let modifiers = prop_oneof![
        4 => Just(Modifiers::NONE),
        1 => Just(Modifiers::SHIFT),
        1 => Just(Modifiers::COMMAND),
        1 => Just(Modifiers::ALT),
    ];
    prop_oneof![
        6 => (spot(), button).prop_map(|((x, y), button)| Action::Press(x, y, button)),
        12 => spot().prop_map(|(x, y)| Action::Move(x, y)),
        8 => Just(Action::Release),
        1 => spot().prop_map(|(x, y)| Action::DoubleClick(x, y)),
        2 => (spot(), -300.0..300.0f32).prop_map(|((x, y), by)| Action::Wheel(x, y, by)),
        5 => (prop::sample::select(KEYS), modifiers)
            .prop_map(|(key, modifiers)| Action::Key(key, modifiers)),
        2 => prop::sample::select(TEXTS).prop_map(Action::Write),
        4 => prop::sample::select(COMMANDS).prop_map(Action::Command),
        4 => number(0.0..20.0).prop_map(Action::Pull),
        3 => (0..4usize, [number(-50.0..150.0), number(-20.0..200.0)])
            .prop_map(|(index, to)| Action::MoveObstacle(index, to)),
        1 => shape().prop_map(Action::Add),
        1 => number(-400.0..400.0).prop_map(Action::Turn),
        1 => (0..40u32, 0..4u32).prop_map(|(n, bay)| Action::Segments(n, bay)),
        1 => number(1.0..20.0).prop_map(Action::Offset),
    ]
}

/// A window with its inputs, drawn by nobody.
struct Window {
    ctx: Context,
    app: Sinew,
    time: f64,
    pointer: Pos2,
    held: Option<PointerButton>,
    /// What has been done since the last frame.
    events: Vec<Event>,
}

/// Things done between two frames: a hand is quicker than the screen.
const A_FRAME: usize = 4;

impl Window {
    fn new() -> Self {
        let ctx = Context::default();
        // A few at a time, as a busy thread would: requests overtake each other.
        let backend = Box::new(Inline::by_slices(3));
        let app = Sinew::new(&ctx, None, backend, Preferences::default()).unwrap();
        let mut window = Self {
            ctx,
            app,
            time: 0.0,
            pointer: pos2(0.0, 0.0),
            held: None,
            events: Vec::new(),
        };
        window.frame();
        window.frame();
        window
    }

    fn scene(&self) -> &Scene {
        &self.app.bench().document.scene
    }

    fn frame(&mut self) {
        self.time += 1.0 / 60.0;
        let input = RawInput {
            screen_rect: Some(Rect::from_min_size(pos2(0.0, 0.0), vec2(1280.0, 800.0))),
            time: Some(self.time),
            events: std::mem::take(&mut self.events),
            ..RawInput::default()
        };
        let app = &mut self.app;
        let mut begun = false;
        let mut output = self.ctx.run_ui(input, |ui| {
            if !std::mem::replace(&mut begun, true) {
                app.before_frame(ui.ctx());
            }
            app.frame(ui);
        });
        // Nobody draws.
        output.textures_delta.clear();
        for clipped in &output.shapes {
            let finite = match &clipped.shape {
                // A text without letters is nowhere.
                Shape::Text(text) => text.galley.text().is_empty() || text.pos.is_finite(),
                shape => !shape.visual_bounding_rect().any_nan(),
            };
            assert!(finite, "{:?}", clipped.shape);
        }
    }

    fn button(&mut self, button: PointerButton, pressed: bool) {
        self.held = pressed.then_some(button);
        self.events.push(Event::PointerButton {
            pos: self.pointer,
            button,
            pressed,
            modifiers: Modifiers::NONE,
        });
    }

    fn move_to(&mut self, x: f32, y: f32) {
        self.pointer = pos2(x, y);
        self.events.push(Event::PointerMoved(self.pointer));
    }

    fn release(&mut self) {
        if let Some(button) = self.held {
            self.button(button, false);
        }
    }

    fn edit(&mut self, change: impl FnOnce(&mut Scene)) {
        change(&mut self.app.bench_mut().document.scene);
    }

    fn command(&mut self, command: Command) {
        self.app.bench_mut().commands.push(command);
    }

    fn act(&mut self, action: &Action) {
        match action.clone() {
            Action::Press(x, y, button) => {
                self.release();
                self.move_to(x, y);
                self.button(button, true);
            }
            Action::Move(x, y) => self.move_to(x, y),
            Action::Release => self.release(),
            Action::DoubleClick(x, y) => {
                self.release();
                self.move_to(x, y);
                for pressed in [true, false, true, false] {
                    self.button(PointerButton::Primary, pressed);
                }
            }
            Action::Wheel(x, y, by) => {
                self.move_to(x, y);
                self.events.push(Event::MouseWheel {
                    unit: MouseWheelUnit::Point,
                    delta: vec2(0.0, by),
                    phase: TouchPhase::Move,
                    source: MouseWheelSource::Wheel,
                    modifiers: Modifiers::NONE,
                });
            }
            Action::Key(key, modifiers) => {
                for pressed in [true, false] {
                    self.events.push(Event::Key {
                        key,
                        physical_key: None,
                        pressed,
                        repeat: false,
                        modifiers,
                    });
                }
            }
            Action::Write(text) => self.events.push(Event::Text(text.to_owned())),
            Action::Command(command) => self.command(command),
            Action::Pull(pull_mm) => self.edit(|scene| scene.set_pull_mm(pull_mm)),
            Action::MoveObstacle(index, to) => self.edit(|scene| {
                if let Some(obstacle) = scene.obstacles.get_mut(index) {
                    obstacle.shape.move_to_mm(to);
                }
            }),
            Action::Add(shape) => self.edit(|scene| {
                if scene.obstacles.len() < 5 {
                    scene.obstacles.push(shape.into());
                }
            }),
            Action::Turn(angle) => self.edit(|scene| scene.robot.base_angle_deg = angle),
            Action::Segments(segments, bay) => self.edit(|scene| {
                scene.robot.segments = segments;
                scene.robot.segments_per_bay = bay;
            }),
            Action::Offset(offset) => self.edit(|scene| scene.robot.cable_offset_mm = Some(offset)),
        }
    }

    /// Lets go of everything, so that what was done is over.
    fn rest(&mut self) {
        self.release();
        self.frame();
        self.ctx.memory_mut(|memory| memory.stop_text_input());
        if self.app.bench().transport.is_playing() {
            self.command(Command::Play);
        }
        self.frame();
        self.frame();
    }

    /// Takes everything back, step by step; how many there were.
    fn undo_all(&mut self) -> Result<usize, TestCaseError> {
        let mut steps = 0;
        while self.app.bench().allows(Command::Undo) {
            prop_assert!(steps <= 2 * ACTIONS, "undo comes to no end");
            self.command(Command::Undo);
            self.frame();
            self.check()?;
            steps += 1;
        }
        Ok(steps)
    }

    /// What must hold after every frame.
    fn check(&self) -> TestCaseResult {
        let bench = self.app.bench();
        prop_assert!(Problem::faults(self.scene()).is_empty());
        if let Some(solution) = bench.live.solution() {
            if solution.status == Status::Converged {
                prop_assert!(solution.certificate.holds(), "{:?}", solution.certificate);
            }
            let nodes = solution.nodes.iter();
            let finite = nodes.flat_map(|node| [node.position.x, node.position.y, node.angle]);
            prop_assert!(
                finite
                    .chain(solution.turns.iter().copied())
                    .all(f64::is_finite)
            );
        }
        let drawing = bench.live.drawing();
        for mark in &drawing.marks {
            let points = mark.geometry.points(1e-4, &drawing.bounds);
            prop_assert!(points.iter().all(|p| p.x.is_finite() && p.y.is_finite()));
        }
        Ok(())
    }
}

#[test]
fn nothing_breaks_the_window_and_undo_leads_back() {
    let config = Config {
        cases: RUNS,
        failure_persistence: None,
        max_shrink_iters: 0,
        ..Config::default()
    };
    let random = TestRng::deterministic_rng(RngAlgorithm::ChaCha);
    let actions = prop::collection::vec(action(), ACTIONS);
    let result = TestRunner::new_with_rng(config, random).run(&actions, |actions| {
        let mut window = Window::new();
        let start = window.scene().clone();
        for actions in actions.chunks(A_FRAME) {
            for action in actions {
                window.act(action);
            }
            window.frame();
            window.check()?;
        }
        window.rest();
        let end = window.scene().clone();
        let steps = window.undo_all()?;
        prop_assert_eq!(window.scene(), &start);
        // There may be more, taken back before the end.
        for _ in 0..steps {
            window.command(Command::Redo);
            window.frame();
            window.check()?;
        }
        prop_assert_eq!(window.scene(), &end);
        Ok(())
    });
    if let Err(failure) = result {
        panic!("{failure}");
    }
}
