//! The dock's plots, driven as a person would.

use eframe::egui::{self, Modifiers, PointerButton, Pos2, Rect, Theme, pos2, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable;
use sinew::app::plots::{self, Link, Plot, PlotAction, PlotCache, PlotData};
use sinew::app::{Hovered, look};
use sinew::equilibrium::{Class, Settings, Solution, Start, solve};
use sinew::explore::{Path, PathRun, rows};
use sinew::forces::Window;
use sinew::model::Problem;
use sinew::scene::{ForceReading, Measurements, Scene, Shape};

const FREE: &str = include_str!("../assets/scenes/free.toml");
const TWO_DISCS: &str = include_str!("../assets/scenes/two-discs.toml");
const LOAD_CELL: &str = include_str!("../assets/scenes/load-cell.toml");
const BODY: &str = include_str!("../assets/scenes/body-contact.toml");

/// Everything that is plotted, and what a hand has done.
struct Bench {
    scene: Scene,
    problem: Problem,
    solution: Solution,
    path: Option<Path>,
    link: Link,
    cache: PlotCache,
    shown: Vec<Plot>,
    actions: Vec<PlotAction>,
    pulls: Vec<f64>,
    calibrated: Option<usize>,
}

impl Bench {
    fn new(scene: Scene, last: f64, shown: &[Plot]) -> Self {
        let problem = Problem::new(&scene).unwrap();
        let solution = solve(&problem, Start::Straight, Settings::default());
        let path = PathRun::over(&problem, 0.0, last, 201).finish();
        let window = Window {
            first: 0.0,
            last: 0.5 * last,
        };
        Self {
            link: Link {
                hovered: Hovered::Nothing,
                hovering: Hovered::Nothing,
                pull: None,
                window,
                calibrate: None,
            },
            scene,
            problem,
            solution,
            path: Some(path),
            cache: PlotCache::default(),
            shown: shown.to_vec(),
            actions: Vec::new(),
            pulls: Vec::new(),
            calibrated: None,
        }
    }

    fn data(&self) -> PlotData<'_> {
        PlotData {
            scene: &self.scene,
            problem: &self.problem,
            solution: &self.solution,
            path: self.path.as_ref(),
            window: self.link.window,
            shape_generation: 1,
            path_generation: 1,
        }
    }

    /// A frame of the dock, as the window does it.
    fn frame(&mut self, ui: &mut egui::Ui) {
        self.link.hovered = self.link.hovering;
        self.link.hovering = Hovered::Nothing;
        let room = ui.available_size();
        let height = room.y / self.shown.len() as f32 - 8.0;
        for plot in self.shown.clone() {
            let (mut cache, mut link) = (std::mem::take(&mut self.cache), self.link);
            let layout = egui::Layout::top_down(egui::Align::Min);
            let action = ui
                .push_id(plot, |ui| {
                    ui.allocate_ui_with_layout(vec2(room.x, height), layout, |ui| {
                        ui.set_min_size(vec2(room.x, height));
                        plots::show(ui, plot, &self.data(), &mut cache, &mut link)
                    })
                    .inner
                })
                .inner;
            self.cache = cache;
            self.link = link;
            self.actions.extend(action);
        }
        self.pulls.extend(self.link.pull.take());
        self.calibrated = self.link.calibrate.take().or(self.calibrated);
    }
}

fn harness(bench: Bench, size: [f32; 2], theme: Theme) -> Harness<'static, Bench> {
    let mut harness = Harness::builder()
        .with_size(vec2(size[0], size[1]))
        .with_pixels_per_point(1.0)
        .with_theme(theme)
        .with_context_setup(look::install)
        .wgpu()
        .build_ui_state(
            |ui, bench: &mut Bench| {
                let fill = ui.visuals().panel_fill;
                egui::Frame::new()
                    .fill(fill)
                    .inner_margin(8.0)
                    .show(ui, |ui| {
                        ui.set_min_size(ui.available_size());
                        bench.frame(ui);
                    });
            },
            bench,
        );
    harness.run();
    harness
}

fn scene(text: &str) -> Scene {
    Scene::from_toml(text).unwrap()
}

/// The load cell with its stiffness and the readings of Table 1 at 24 mm.
fn load_cell() -> Scene {
    let mut scene = scene(LOAD_CELL);
    scene.robot.bending_stiffness_nmm2 = Some(40_000.0);
    let table = include_str!("../assets/measured/table-1.csv");
    let rows = table.lines().filter_map(|line| {
        let mut cells = line.split(',').map(str::trim).map(str::parse::<f64>);
        match (cells.next(), cells.next()) {
            (Some(Ok(load_g)), Some(Ok(force_g))) => Some(ForceReading { load_g, force_g }),
            _ => None,
        }
    });
    scene.measured = Some(Measurements {
        forces: rows.collect(),
        calibration: Some(3),
        ..Measurements::default()
    });
    scene
}

/// A post that the branch ends on.
fn ends() -> Scene {
    let mut scene = scene(FREE);
    let post = Shape::Disc {
        center_mm: [44.0, 170.0],
        radius_mm: 8.0,
    };
    scene.obstacles.push(post.into());
    let block = Shape::Disc {
        center_mm: [95.0, 60.0],
        radius_mm: 20.0,
    };
    scene.obstacles.push(block.into());
    scene.actuation.pull_mm = 6.5;
    scene
}

#[test]
fn pictures() {
    let out = std::path::Path::new("/tmp/path-pictures");
    std::fs::create_dir_all(out).unwrap();
    for (theme, word) in [(Theme::Light, "light"), (Theme::Dark, "dark")] {
        for (name, scene, last) in [
            ("two", scene(TWO_DISCS), 0.008),
            ("cell", load_cell(), 0.010),
            ("ends", ends(), 0.016),
        ] {
            let bench = Bench::new(scene, last, &Plot::ALL);
            let mut harness = harness(bench, [560.0, 1500.0], theme);
            harness
                .render()
                .unwrap()
                .save(out.join(format!("{name}-{word}.png")))
                .unwrap();
        }
    }
}
