//! How long a frame of the window takes, without the graphics processor.
//!
//! `cargo bench --bench window`. A frame is what runs on the processor between
//! the events and the triangles: what the solver has found, panels, canvas,
//! plots, the settling of the scene, tessellation. The solution is a new one
//! in every frame, since the pull is; it is solved on its own thread, outside
//! of what is timed.
//!
//! All five plots are shown at once.
//!
//! Goals: at most 2 ms a frame; a new shape in the frame of the pointer's event
//! or the next. Measured on two cores of a virtual machine that was busy with
//! other builds (medians; the fastest in brackets), for 18 and 200 segments:
//!
//! | | 18 | 200 |
//! |---|---|---|
//! | frame with plots | 0.80 ms (0.66) | 1.87 ms (1.50) |
//! | the same and the view in space | 0.88 ms (0.75) | 1.87 ms (1.59) |
//! | drag to new shape: both frames and the solve | 2.7 ms (1.1) | 7.4 ms (3.2) |
//!
//! so that the answer to an event is there when the next frame of a screen of
//! 120 Hz begins.

use divan::Bencher;
use eframe::egui::{Context, Event, Modifiers, PointerButton, Pos2, RawInput, Rect, pos2, vec2};
use sinew::app::backend::Thread;
use sinew::app::{Command, Preferences, Sinew, Views};
use sinew::scene::Scene;
use std::cell::RefCell;
use std::sync::mpsc::{Receiver, channel};
use std::time::Duration;

fn main() {
    divan::main();
}

const SCENE: &str = include_str!("../assets/scenes/two-discs.toml");

/// A window with its inputs, its triangles thrown away.
struct Window {
    ctx: Context,
    app: Sinew,
    time: f64,
    found: Receiver<()>,
}

impl Window {
    fn new(segments: u32, views: Views) -> Self {
        let ctx = Context::default();
        let (tell, found) = channel();
        let opened = Thread::new(move || {
            // Nobody listens any more once the window is gone.
            let _ = tell.send(());
        });
        let Ok(backend) = opened else {
            panic!("a thread for the solver");
        };
        let Ok(mut scene) = Scene::from_toml(SCENE) else {
            panic!("the scene of this bench");
        };
        scene.robot.segments = segments;
        let preferences = Preferences {
            views,
            ..Preferences::default()
        };
        let opened = Sinew::new(&ctx, Some(scene), Box::new(backend), preferences);
        let Ok(mut app) = opened else {
            panic!("a window on the scene of this bench");
        };
        app.bench_mut().commands.push(Command::SpreadPlots);
        let mut window = Self {
            ctx,
            app,
            time: 0.0,
            found,
        };
        for _ in 0..20 {
            window.wait();
            window.frame(Vec::new());
        }
        window
    }

    /// Waits for something to be found, or a little.
    fn wait(&self) {
        let _ = self.found.recv_timeout(Duration::from_millis(50));
        while self.found.try_recv().is_ok() {}
    }

    /// Waits for an answer as a screen at 60 Hz would at most.
    fn wait_briefly(&self) {
        let _ = self.found.recv_timeout(Duration::from_millis(16));
    }

    /// A frame; how many triangles there are to draw.
    fn frame(&mut self, events: Vec<Event>) -> usize {
        self.time += 1.0 / 60.0;
        let input = RawInput {
            screen_rect: Some(Rect::from_min_size(pos2(0.0, 0.0), vec2(1440.0, 900.0))),
            time: Some(self.time),
            events,
            ..RawInput::default()
        };
        let app = &mut self.app;
        let mut output = self.ctx.run_ui(input, |ui| {
            app.before_frame(ui.ctx());
            app.frame(ui);
        });
        output.textures_delta.clear();
        self.ctx.tessellate(output.shapes, 1.0).len()
    }

    /// Moves the pull a little, so that the next frame shows a new solution.
    fn pull(&mut self, to_mm: f64) {
        self.app.bench_mut().document.scene.set_pull_mm(to_mm);
    }
}

/// Frames that each show a new solution.
fn changing(bencher: Bencher<'_, '_>, segments: u32, views: Views) {
    let window = RefCell::new(Window::new(segments, views));
    let count = RefCell::new(0_u32);
    bencher
        .with_inputs(|| {
            // The last frame has asked for a solution; this one shows it and
            // asks for the next.
            window.borrow().wait();
            let mut count = count.borrow_mut();
            *count += 1;
            let pull_mm = 4.5 + 0.005 * f64::from(*count % 100);
            window.borrow_mut().pull(pull_mm);
        })
        .bench_local_values(|()| window.borrow_mut().frame(Vec::new()));
}

#[divan::bench(args = [18, 200])]
fn frame_with_plots(bencher: Bencher<'_, '_>, segments: u32) {
    changing(bencher, segments, Views::Plane);
}

#[divan::bench(args = [18, 200])]
fn frame_with_plots_and_space(bencher: Bencher<'_, '_>, segments: u32) {
    changing(bencher, segments, Views::Both);
}

/// From the frame with a pointer's move, a disc in its grip, to the end of the
/// one that shows the new shape: one frame and the next, and the solve.
#[divan::bench(args = [18, 200])]
fn drag_to_new_shape(bencher: Bencher<'_, '_>, segments: u32) {
    let mut window = Window::new(segments, Views::Plane);
    let start = disc(&window);
    let button = |pressed| Event::PointerButton {
        pos: start,
        button: PointerButton::Primary,
        pressed,
        modifiers: Modifiers::NONE,
    };
    window.frame(vec![Event::PointerMoved(start)]);
    window.frame(vec![button(true)]);
    let mut count = 0_u32;
    bencher.bench_local(|| {
        count += 1;
        let away = 10.0 + (count % 20) as f32;
        let before = window.app.bench().live.revision();
        window.frame(vec![Event::PointerMoved(start + vec2(away, 0.0))]);
        let asked = window.app.bench().live.revision();
        assert!(asked > before, "the drag moves the disc");
        while window.app.bench().live.is_waiting() {
            window.wait_briefly();
            window.frame(Vec::new());
        }
        window.app.bench().live.revision()
    });
}

/// The middle of the lower disc on the screen.
fn disc(window: &Window) -> Pos2 {
    let obstacle = &window.app.bench().live.problem().obstacles()[0];
    let frame = window.app.canvas().frame();
    let at = frame.to_screen(obstacle.position());
    pos2(at.x as f32, at.y as f32)
}
