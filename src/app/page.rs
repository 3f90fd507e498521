//! The window in a browser's page, with its solver in a worker. The page
//! around it (`web/page`) decides what it may use, shows what comes before the
//! first frame, and what there is to say after the last one.

#[cfg(feature = "web-test")]
mod handle;
mod kept;
mod options;
mod place;

use super::backend::{Arrived, Inline, SLICE, SolverBackend, Worker};
use super::examples::EXAMPLES;
use super::files::request;
use super::link;
use super::look::fit_fingers;
use super::platform::Web;
use super::window::Sinew;
use super::window::stored::{Stored, has_preferences};
use super::words::{faults_of, sentence};
use super::workbench::{Arrival, Intent, Notice};
use crate::mechanics::Problem;
use crate::scene::Scene;
use eframe::egui::{Context, FullOutput, Plugin, Ui, ViewportCommand};
use eframe::{CreationContext, WebRunner};
use place::Place;
use std::rc::Rc;
use wasm_bindgen::prelude::*;

#[wasm_bindgen(js_namespace = sinew_page)]
extern "C" {
    /// Where the window is to be.
    fn canvas() -> web_sys::HtmlCanvasElement;
    /// A worker that runs `worker.js`, where there are workers.
    fn worker() -> Option<web_sys::Worker>;
    /// Whether WebGL is to be used even where there is WebGPU.
    fn wants_webgl() -> bool;
    /// Whether the page is part of another one: then the panels are closed and
    /// nothing is stored.
    fn is_embedded() -> bool;
    /// Whether nothing is to move by itself.
    fn wants_stillness() -> bool;
    /// Whether it is pointed at with fingers.
    fn has_fingers() -> bool;
    /// What the page is called.
    fn title(text: &str);
    /// Goes to a fragment of the page's address; the browser's way back leads
    /// from there.
    fn visit(fragment: &str);
    /// The window has its first frame.
    fn ready();
    /// The window is over; with the scene file that it had open.
    fn crashed(why: &str, scene: &str);
}

/// Opens the window in its page.
pub fn open() {
    // Fails only where there is a logger already.
    let _ = eframe::WebLogger::init(log::LevelFilter::Warn);
    kept::on_panic(crashed);
    wasm_bindgen_futures::spawn_local(run(WebRunner::new()));
}

/// The scene that is open as a file; empty before the first frame.
#[wasm_bindgen]
pub fn sinew_kept() -> String {
    kept::file()
}

async fn run(runner: WebRunner) {
    #[cfg(feature = "web-test")]
    handle::hold(&runner);
    let options = options::of(wants_webgl());
    let creator = Box::new(|cc: &CreationContext<'_>| {
        let page: Box<dyn eframe::App> = Box::new(Page::new(cc)?);
        Ok(page)
    });
    if let Err(error) = runner.start(canvas(), options, creator).await {
        let why = error.as_string().unwrap_or_else(|| format!("{error:?}"));
        crashed(&why, "");
    }
}

/// The window, and what only a page has.
struct Page {
    window: Sinew,
    /// The place in the address.
    place: Place,
    /// How the solver's worker is, where there is one that goes on.
    arrived: Option<Rc<Arrived>>,
    frames: u64,
}

impl Page {
    fn new(cc: &CreationContext<'_>) -> Result<Self, String> {
        if let Some(gpu) = &cc.wgpu_render_state {
            crate::render::install(gpu);
        }
        let ctx = &cc.egui_ctx;
        let fragment = cc.integration_info.web_info.location.hash.clone();
        let (scene, broken) = match linked(&fragment) {
            Ok(scene) => (scene, None),
            Err(why) => (None, Some(why)),
        };
        let (backend, arrived) = backend(ctx);
        let storage = cc.storage.filter(|_| !is_embedded());
        let mut stored = Stored::of(storage);
        let preferences = &mut stored.preferences;
        if storage.is_none_or(|storage| !has_preferences(storage)) {
            preferences.still = wants_stillness();
        }
        if is_embedded() {
            preferences.outline = false;
            preferences.dock = false;
        }
        let window = Sinew::new(ctx, scene, backend, preferences.clone());
        let window = window.map_err(|faults| faults_of(&faults).join(" "))?;
        let mut window = window.on(Box::new(Web::new(ctx)), stored);
        if has_fingers() {
            fit_fingers(ctx);
        }
        if let Some(why) = broken {
            window.bench_mut().notices.tell(Notice::trouble(why));
        }
        ctx.add_plugin(Title);
        #[cfg(feature = "web-test")]
        handle::watch(cc);
        Ok(Self {
            place: Place::new(fragment, &window.bench().document),
            window,
            arrived,
            frames: 0,
        })
    }

    /// Tells once where the solver's worker has failed.
    fn watch_worker(&mut self) {
        if self
            .arrived
            .as_ref()
            .is_some_and(|arrived| arrived.has_failed())
        {
            self.arrived = None;
            let told = "The solver's worker has stopped; the window solves by itself, if slower.";
            let notices = &mut self.window.bench_mut().notices;
            notices.tell(Notice::information(told));
        }
    }

    /// Opens what the address has come to name: by a link that was put into it,
    /// or by the browser's way back.
    fn follow(&mut self, fragment: &str, ctx: &Context) {
        if !self.place.is_news(fragment) {
            return;
        }
        let bench = self.window.bench_mut();
        match linked(fragment) {
            Ok(scene) => {
                let scene = scene.map_or_else(|| EXAMPLES[0].scene(), Ok);
                let Ok(scene) = scene else { return };
                let arrival = Box::new(Arrival::of(scene));
                request(bench, Intent::Scene(arrival), ctx);
            }
            Err(why) => bench.notices.tell(Notice::trouble(why)),
        }
    }
}

/// The scene of a fragment, if there is one; or a sentence on what is wrong
/// with it.
fn linked(fragment: &str) -> Result<Option<Scene>, String> {
    if fragment.trim_start_matches('#').is_empty() {
        return Ok(None);
    }
    if let Some(example) = place::example(fragment) {
        return example.map(Some);
    }
    let scene = link::decode(fragment).map_err(|error| sentence(&error.to_string()))?;
    match Problem::parse(&scene) {
        Ok(_) => Ok(Some(scene)),
        Err(faults) => Err(faults_of(&faults).join(" ")),
    }
}

fn backend(ctx: &Context) -> (Box<dyn SolverBackend>, Option<Rc<Arrived>>) {
    match worker() {
        Some(worker) => {
            let painter = ctx.clone();
            let worker = Worker::new(worker, move || painter.request_repaint());
            let arrived = worker.arrived();
            (Box::new(worker), Some(arrived))
        }
        None => (Box::new(Inline::sliced(SLICE)), None),
    }
}

/// Passes the window's title on to the page, which eframe does not.
struct Title;

impl Plugin for Title {
    fn debug_name(&self) -> &'static str {
        "title"
    }

    fn output_hook(&mut self, _ctx: &Context, output: &mut FullOutput) {
        for viewport in output.viewport_output.values_mut() {
            viewport.commands.retain(|command| match command {
                ViewportCommand::Title(text) => {
                    title(text);
                    false
                }
                _ => true,
            });
        }
    }
}

impl eframe::App for Page {
    fn logic(&mut self, ctx: &Context, frame: &mut eframe::Frame) {
        let fragment = frame.info().web_info.location.hash.clone();
        self.follow(&fragment, ctx);
        self.watch_worker();
        self.window.logic(ctx, frame);
    }

    fn ui(&mut self, ui: &mut Ui, frame: &mut eframe::Frame) {
        if is_embedded() {
            self.window.frame(ui);
        } else {
            self.window.ui(ui, frame);
        }
        let document = &self.window.bench().document;
        kept::keep(&document.scene);
        if let Some(fragment) = self.place.visit(document) {
            visit(fragment);
        }
        self.frames += 1;
        if self.frames == 1 {
            ready();
        }
    }

    fn save(&mut self, storage: &mut dyn eframe::Storage) {
        if !is_embedded() {
            self.window.save(storage);
        }
    }

    fn persist_egui_memory(&self) -> bool {
        !is_embedded()
    }

    fn auto_save_interval(&self) -> std::time::Duration {
        self.window.auto_save_interval()
    }

    fn as_any_mut(&mut self) -> Option<&mut dyn std::any::Any> {
        Some(self)
    }
}
