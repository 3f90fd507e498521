//! How a test sees inside the window: its state as JSON, and where its widgets
//! are. Only in builds for tests.

use super::Page;
use crate::app::window::Sinew;
use crate::geometry::Vector;
use crate::units::{metres, millimetres};
use eframe::egui::{Context, FullOutput, Plugin};
use eframe::wgpu::Backend;
use eframe::{CreationContext, WebRunner};
use serde_json::{Map, Value, json};
use std::cell::RefCell;
use wasm_bindgen::prelude::*;

thread_local! {
    static RUNNER: RefCell<Option<WebRunner>> = const { RefCell::new(None) };
    static WATCHED: RefCell<Option<Watched>> = const { RefCell::new(None) };
}

/// What is not in the window's state.
struct Watched {
    ctx: Context,
    renderer: &'static str,
}

/// Holds on to what runs the window.
pub fn hold(runner: &WebRunner) {
    RUNNER.with(|held| *held.borrow_mut() = Some(runner.clone()));
}

/// Notes from now on where the widgets are.
pub fn watch(cc: &CreationContext<'_>) {
    let ctx = cc.egui_ctx.clone();
    ctx.enable_accesskit();
    ctx.add_plugin(Widgets::default());
    let gpu = cc.wgpu_render_state.as_ref();
    let renderer = match gpu.map(|gpu| gpu.adapter.get_info().backend) {
        Some(Backend::BrowserWebGpu) => "webgpu",
        Some(Backend::Gl) => "webgl",
        _ => "none",
    };
    let watched = Watched { ctx, renderer };
    WATCHED.with(|held| *held.borrow_mut() = Some(watched));
}

/// The state of the window as JSON; nothing before its first frame.
#[wasm_bindgen]
pub fn sinew_state() -> Option<String> {
    RUNNER.with(|runner| {
        let runner = runner.borrow();
        let page = runner.as_ref()?.app_mut::<Page>()?;
        (page.frames > 0).then(|| of_page(&page).to_string())
    })
}

/// The pixel of the page, in CSS pixels, where a point in millimetres is.
#[wasm_bindgen]
pub fn sinew_pixel(x_mm: f64, y_mm: f64) -> Option<Vec<f64>> {
    RUNNER.with(|runner| {
        let runner = runner.borrow();
        let page = runner.as_ref()?.app_mut::<Page>()?;
        let frame = page.window.canvas().frame();
        let pixel = frame.to_screen(Vector::new(metres(x_mm), metres(y_mm)));
        Some(vec![pixel.x, pixel.y])
    })
}

/// Fails as a fault in the program would.
#[wasm_bindgen]
pub fn sinew_panic() {
    panic!("asked for by a test");
}

fn of_page(page: &Page) -> Value {
    let mut value = of_window(&page.window);
    let solver = if page.arrived.is_some() {
        "worker"
    } else {
        "inline"
    };
    value["solver"] = json!(solver);
    value["frames"] = json!(page.frames);
    WATCHED.with(|watched| {
        if let Some(Watched { ctx, renderer }) = &*watched.borrow() {
            let widgets = ctx.with_plugin(|widgets: &mut Widgets| widgets.0.clone());
            value["renderer"] = json!(renderer);
            value["pixels_per_point"] = json!(ctx.pixels_per_point());
            value["widgets"] = Value::Object(widgets.unwrap_or_default());
        }
    });
    value
}

fn of_window(window: &Sinew) -> Value {
    let bench = window.bench();
    let live = &bench.live;
    let scene = &bench.document.scene;
    let solution = live.solution();
    let point = |at: Vector| json!([millimetres(at.x), millimetres(at.y)]);
    let obstacles = live.problem().obstacles().iter();
    let contacts = solution.into_iter().flat_map(|solution| &solution.contacts);
    json!({
        "title": scene.title,
        "pull_mm": bench.pull_mm(),
        "span_mm": [bench.span_mm().0, bench.span_mm().1],
        "obstacles_mm": obstacles.map(|o| point(o.position())).collect::<Vec<_>>(),
        "settled": live.is_settled(),
        "status": solution.map(|solution| solution.status.word()),
        "energy": solution.map(|solution| solution.energy),
        "iterations": solution.map(|solution| solution.iterations),
        "backbone_mm": solution.map(|solution| solution.backbone().map(point).collect::<Vec<_>>()),
        "contacts": contacts
            .map(|contact| json!({
                "obstacle": contact.obstacle,
                "node": contact.node,
                "multiplier": contact.multiplier,
            }))
            .collect::<Vec<_>>(),
        "solve_ms": live.time().as_secs_f64() * 1e3,
        "path_states": live.path().map(|path| path.states.len()),
        "path_is_current": live.path_is_current(),
        "points_per_mm": window.canvas().frame().scale * metres(1.0),
        "notices": bench.notices.iter().map(|notice| &notice.text).collect::<Vec<_>>(),
        "still": bench.preferences.still,
        "undo": bench.history.can_undo(scene),
    })
}

/// The widgets by what a screen reader calls them: left, top, width, height,
/// in points.
#[derive(Default)]
struct Widgets(Map<String, Value>);

impl Plugin for Widgets {
    fn debug_name(&self) -> &'static str {
        "widgets"
    }

    fn output_hook(&mut self, _ctx: &Context, output: &mut FullOutput) {
        let Some(update) = output.platform_output.accesskit_update.take() else {
            return;
        };
        self.0.clear();
        for (_, node) in &update.nodes {
            let name = node.label().or(node.value());
            if let (Some(name), Some(area)) = (name, node.bounds()) {
                let area = [area.x0, area.y0, area.x1 - area.x0, area.y1 - area.y0];
                self.0.insert(name.to_owned(), json!(area));
            }
        }
    }
}
