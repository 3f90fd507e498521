//! The dock's plots, driven as a person would.

use eframe::egui::{self, Modifiers, PointerButton, Pos2, Rect, Theme, pos2, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable;
use sinew::app::plots::{self, Link, Plot, PlotAction, PlotCache, PlotData};
use sinew::app::workbench::{Assumed, Followed, Loaded, Step};
use sinew::app::{Hovered, look};
use sinew::contact::Class;
use sinew::equilibrium::{Settings, Solved, Start, solve};
use sinew::explore::{Path, PathRun};
use sinew::forces::Window;
use sinew::mechanics::Problem;
use sinew::record::path::rows;
use sinew::scene::{Cable, Drive, ForceReading, Measurements, Mechanics, Scene, Shape};
use sinew::units::grams;
use sinew::view::{ForceScale, Notes, draw};

const FREE: &str = include_str!("../assets/scenes/free.toml");
const TWO_DISCS: &str = include_str!("../assets/scenes/two-discs.toml");
const TWO_POSTS: &str = include_str!("../assets/scenes/two-posts.toml");
const LOAD_CELL: &str = include_str!("../assets/scenes/load-cell.toml");
const BODY: &str = include_str!("../assets/scenes/body-contact.toml");

/// Everything that is plotted, and what a hand has done.
struct Bench {
    scene: Scene,
    problem: Problem,
    solution: Solved,
    path: Option<Path>,
    walked: Vec<Step>,
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
        let walked = walked(&solution);
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
            walked,
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
            asked: &self.problem,
            solved: &self.solution,
            path: self.path.as_ref(),
            models: &[],
            models_generation: 1,
            pins: &[],
            walked: &self.walked,
            cable: 0,
            scale: self.scale(),
            window: self.link.window,
            shape_generation: 1,
            path_generation: 1,
        }
    }

    fn scale(&self) -> ForceScale {
        draw(&self.solution, &Notes::of(&self.scene)).scale
    }

    /// The same without what a hand has done.
    fn again(&self) -> Self {
        Self {
            scene: self.scene.clone(),
            problem: self.problem.clone(),
            solution: self.solution.clone(),
            path: self.path.clone(),
            walked: self.walked.clone(),
            cache: PlotCache::default(),
            shown: self.shown.clone(),
            actions: Vec::new(),
            pulls: Vec::new(),
            calibrated: None,
            ..*self
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

#[test]
fn forces_of_other_models_stand_beside_the_scenes_own() {
    let bench = Bench::new(scene(TWO_POSTS), 0.008, &[]);
    let mut equal = scene(TWO_POSTS);
    equal.model.mechanics = Mechanics::Equal;
    let problem = Problem::new(&equal).unwrap();
    let path = PathRun::over(&problem, 0.0, 0.008, 201).finish();
    let models = [Followed {
        assumed: Assumed::Equal,
        problem,
        path: path.into(),
    }];
    let data = PlotData {
        models: &models,
        ..bench.data()
    };
    let table = plots::csv(Plot::Force, &data);
    let sources = column(&table, "source");
    let forces = numbers(&table, "force_g");
    let greatest = |wanted: &str| {
        let of = sources.iter().zip(&forces);
        let of = of.filter(|(source, _)| *source == wanted);
        of.map(|(_, force)| *force).fold(0.0, f64::max)
    };
    // The paper's are too small.
    assert!(greatest("multipliers") > 0.0);
    assert!(greatest("sliding") > 1.5 * greatest("multipliers"));
    let chart = plots::svg(Plot::Force, &data).unwrap();
    assert!(chart.contains("multipliers") && chart.contains("sliding"));
}

/// There and back around a shape, with a cable that lags.
fn walked(solution: &Solved) -> Vec<Step> {
    let at = |i: i32, lag: f64| {
        let cables = solution.cables.iter().map(|cable| Loaded {
            pull: cable.pull * (1.0 - 0.02 * f64::from(i)),
            load: cable.load * (1.0 - 0.02 * f64::from(i)) * lag,
        });
        Step {
            cables: cables.collect(),
            is_leap: false,
        }
    };
    let there = (0..20).map(|i| at(i, 1.0));
    there.chain((0..20).rev().map(|i| at(i, 1.2))).collect()
}

fn harness_of(bench: Bench, size: [f32; 2], theme: Theme) -> Harness<'static, Bench> {
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

/// A post that the robot slips off twice.
fn slippery() -> Scene {
    with_post([44.0, 170.0], 6.5)
}

/// A post that its branch ends on.
fn ends() -> Scene {
    with_post([44.0, 150.0], 6.5)
}

fn with_post(center_mm: [f64; 2], pull_mm: f64) -> Scene {
    let mut scene = scene(FREE);
    let post = Shape::Disc {
        center_mm,
        radius_mm: 8.0,
    };
    scene.obstacles.push(post.into());
    scene.set_pull_mm(pull_mm);
    scene
}

/// Two hundred segments that touch with their whole body.
fn fine() -> Scene {
    let mut scene = scene(BODY);
    scene.robot.segments = 200;
    scene.robot.segments_per_bay = 20;
    scene
}

/// A plot's frame on the screen.
fn frame(harness: &Harness<'_, Bench>, name: &str) -> Rect {
    harness.get_by_label(name).rect()
}

/// Where an abscissa is on the screen, for a plot that shows `range` with a
/// margin of this share on either side.
fn across(frame: Rect, value: f64, range: (f64, f64), margin: f64) -> f32 {
    let width = range.1 - range.0;
    let share = (value - range.0 + margin * width) / (width * (1.0 + 2.0 * margin));
    frame.left() + share as f32 * frame.width()
}

fn press(harness: &Harness<'_, Bench>, at: Pos2, pressed: bool) {
    harness.event(egui::Event::PointerMoved(at));
    harness.event(egui::Event::PointerButton {
        pos: at,
        button: PointerButton::Primary,
        pressed,
        modifiers: Modifiers::NONE,
    });
}

fn click(harness: &mut Harness<'_, Bench>, at: Pos2) {
    // What is held for long is no click.
    press(harness, at, true);
    harness.step();
    press(harness, at, false);
    harness.run();
}

fn drag(harness: &mut Harness<'_, Bench>, from: Pos2, to: Pos2) {
    press(harness, from, true);
    harness.run();
    for step in 1..=4 {
        harness.event(egui::Event::PointerMoved(from.lerp(to, step as f32 / 4.0)));
        harness.run();
    }
    press(harness, to, false);
    harness.run();
}

const SIZE: [f32; 2] = [560.0, 300.0];

#[test]
fn every_plot_draws_whatever_there_is() {
    for theme in [Theme::Light, Theme::Dark] {
        for scene in [
            scene(FREE),
            scene(TWO_DISCS),
            load_cell(),
            slippery(),
            ends(),
            fine(),
        ] {
            let mut bench = Bench::new(scene, 0.013, &Plot::ALL);
            harness_of(bench.again(), [480.0, 1500.0], theme);
            bench.path = None;
            harness_of(bench.again(), [480.0, 1500.0], theme);
            bench.solution = Solved::unsolved(bench.problem.clone());
            bench.path = Some(Path::default());
            // Hardly any room.
            harness_of(bench.again(), [120.0, 400.0], theme);
        }
    }
}

#[test]
fn a_stem_under_the_pointer_is_the_contact_everywhere() {
    let bench = Bench::new(scene(TWO_DISCS), 0.008, &[Plot::Multipliers, Plot::Bends]);
    let mut harness = harness_of(bench, [560.0, 600.0], Theme::Light);
    let stems = frame(&harness, "Multipliers by node");
    let node = |node: f64| across(stems, node, (0.0, 18.0), 0.025);
    // Each contact, then the nodes between them, then the other plot's segments.
    for (contact, at) in [(0, 10.0), (1, 16.0)] {
        harness.hover_at(pos2(node(at) + 3.0, stems.center().y));
        harness.run();
        assert_eq!(harness.state().link.hovered, Hovered::Contact(contact));
    }
    harness.hover_at(pos2(node(4.0), stems.center().y));
    harness.run();
    assert_eq!(harness.state().link.hovered, Hovered::Node(4));
    let bends = frame(&harness, "Bends and shears by segment");
    let segment = across(bends, 7.2, (0.5, 18.5), 0.01);
    harness.hover_at(pos2(segment, bends.center().y));
    harness.run();
    assert_eq!(harness.state().link.hovered, Hovered::Node(7));
    harness.remove_cursor();
    harness.run();
    assert_eq!(harness.state().link.hovered, Hovered::Nothing);
}

/// Two posts and a second cable on the other side, to disk 5, which hangs a load.
fn two_cables() -> Scene {
    let mut scene = scene(TWO_POSTS);
    let first = scene.cable(0);
    scene.robot.cable_offset_mm = None;
    scene.robot.cable_diameter_mm = 0.0;
    scene.actuation = None;
    let second = Cable {
        offset_mm: -8.0,
        drive: Drive::LoadG(150.0),
        to_disk: Some(5),
        ..first
    };
    scene.cables = vec![first, second];
    scene
}

#[test]
fn a_stretch_under_the_pointer_is_lit_in_all_plots() {
    let shown = [Plot::Tension, Plot::Bends];
    let bench = Bench::new(two_cables(), 0.008, &shown);
    let tensions: Vec<f64> = bench.solution.cables.iter().map(|c| c.tension).collect();
    assert!(tensions[0] > 1.2 * tensions[1], "{tensions:?}");
    let mut harness = harness_of(bench, [560.0, 600.0], Theme::Light);
    let plot = frame(&harness, "Tension along the cables");
    let disk = |disk: f64| across(plot, disk, (0.0, 9.0), 0.025);
    // The second cable ends at disk 5, under the first one's line.
    for (x, y, cable, stretch) in [
        (2.5, plot.top() + 2.0, 0, 2),
        (2.5, plot.bottom() - 30.0, 1, 2),
        (7.5, plot.top() + 2.0, 0, 7),
        (7.5, plot.bottom() - 30.0, 0, 7),
    ] {
        harness.remove_cursor();
        harness.run();
        harness.hover_at(pos2(disk(x), y));
        harness.run();
        let expected = Hovered::Stretch { cable, stretch };
        assert_eq!(harness.state().link.hovered, expected, "{x} {y}");
    }
}

#[test]
fn tensions_are_told_stretch_by_stretch() {
    let bench = Bench::new(two_cables(), 0.008, &[]);
    let table = plots::csv(Plot::Tension, &bench.data());
    let cables = numbers(&table, "cable");
    let expected: Vec<f64> = [vec![1.0; 9], vec![2.0; 5]].concat();
    assert_eq!(cables, expected);
    let newtons = bench.data().stiffness().unwrap().per_bend(&bench.problem);
    for (cable, tension) in cables.iter().zip(numbers(&table, "tension_g")) {
        let state = bench.solution.cables[*cable as usize - 1];
        let expected = grams(newtons * state.tension);
        assert!((tension - expected).abs() <= 1e-9 * expected, "{tension}");
    }
    // Along the path of the first cable, too.
    let table = plots::csv(Plot::Energy, &bench.data());
    let states = &bench.path.as_ref().unwrap().states;
    let loads = column(&table, "cable_2_load_g");
    let loads: Vec<f64> = loads.iter().filter_map(|load| load.parse().ok()).collect();
    assert_eq!(loads.len(), states.len());
    assert!(loads.iter().all(|load| (load - 150.0).abs() < 1e-6));
    let pulls = column(&table, "cable_2_pull_mm");
    let pulls: Vec<f64> = pulls.iter().filter_map(|pull| pull.parse().ok()).collect();
    assert!(pulls[0] > pulls[pulls.len() - 1] + 1.0, "{pulls:?}");
    let table = plots::csv(Plot::Load, &bench.data());
    assert_eq!(numbers(&table, "cable")[..4], [1.0, 2.0, 1.0, 2.0]);
    let loads = numbers(&table, "load_g");
    let first = grams(newtons * bench.walked[0].cables[1].load);
    assert!((loads[1] - first).abs() < 1e-9 * first);
    assert_eq!(loads.len(), 80);
    // Where the cable rubs, the tension falls at every hole that it slips through.
    assert_eq!(
        column(&plots::csv(Plot::Tension, &bench.data()), "slips"),
        [""; 14]
    );
    let mut rubs = scene(TWO_POSTS);
    rubs.friction.holes = 0.275;
    let bench = Bench::new(rubs, 0.008, &[]);
    let table = plots::csv(Plot::Tension, &bench.data());
    assert_eq!(column(&table, "slips"), ["in"; 9]);
    let tensions = numbers(&table, "tension_g");
    assert!(
        tensions.windows(2).all(|pair| pair[0] > 1.001 * pair[1]),
        "{tensions:?}"
    );
    // In the paper's model every link has its own, and their mean is the cable's.
    let mut scene = scene(TWO_DISCS);
    scene.robot.bending_stiffness_nmm2 = None;
    let bench = Bench::new(scene, 0.008, &[]);
    let table = plots::csv(Plot::Tension, &bench.data());
    let links = numbers(&table, "tension_rad2_per_mm");
    assert_eq!(numbers(&table, "to_disk")[..3], [0.5, 1.0, 1.5]);
    let mean = links.iter().sum::<f64>() / links.len() as f64;
    let expected = 1e-3 * bench.solution.energy_slope();
    assert!(
        (mean - expected).abs() < 1e-9 * expected,
        "{mean} {expected}"
    );
    assert!(links.iter().any(|link| (link - mean).abs() > 1e-4 * mean));
}

#[test]
fn the_window_of_the_fits_is_dragged_by_its_edges() {
    let bench = Bench::new(scene(FREE), 0.010, &[Plot::Tip]);
    let mut harness = harness_of(bench, SIZE, Theme::Light);
    for name in [
        "Displacement of the tip over the pull",
        "Slope of the tip over the pull",
    ] {
        let plot = frame(&harness, name);
        let at = |pull_mm: f64| pos2(across(plot, pull_mm, (0.0, 10.0), 0.05), plot.center().y);
        let window = harness.state().link.window;
        drag(
            &mut harness,
            at(1e3 * window.last) + vec2(2.0, 0.0),
            at(8.0),
        );
        drag(&mut harness, at(1e3 * window.first), at(1.5));
        let window = harness.state().link.window;
        // To a pixel: 10 mm are about 450 of them.
        assert!((window.last - 8e-3).abs() < 5e-5, "{window:?}");
        assert!((window.first - 1.5e-3).abs() < 5e-5, "{window:?}");
        // An edge does not go past the other.
        drag(&mut harness, at(1.5), at(9.5));
        let window = harness.state().link.window;
        assert!(window.first < window.last && window.first > 7e-3);
        drag(
            &mut harness,
            at(1e3 * window.first) - vec2(4.0, 0.0),
            at(0.5),
        );
        assert_eq!(harness.state().pulls, [0.0; 0]);
    }
}

#[test]
fn the_pull_is_set_by_a_click_and_by_a_drag() {
    let bench = Bench::new(scene(TWO_DISCS), 0.008, &[Plot::Energy]);
    let mut harness = harness_of(bench, SIZE, Theme::Light);
    let plot = frame(&harness, "Energy over the pull");
    let at = |pull_mm: f64| {
        pos2(
            across(plot, pull_mm, (0.0, 8.0), 0.03),
            plot.bottom() - 20.0,
        )
    };
    click(&mut harness, at(2.0));
    let pull = *harness.state().pulls.last().unwrap();
    assert!((pull - 2e-3).abs() < 3e-5, "{pull}");
    drag(&mut harness, at(1e3 * pull), at(3.0));
    let pull = *harness.state().pulls.last().unwrap();
    assert!((pull - 3e-3).abs() < 3e-5, "{pull}");
    // Never beyond the path.
    drag(
        &mut harness,
        at(3.0),
        pos2(plot.right() - 1.0, plot.center().y),
    );
    assert_eq!(*harness.state().pulls.last().unwrap(), 8e-3);
    // A mark is met exactly.
    let path = harness.state().path.clone().unwrap();
    let made = path.events[0].pull;
    click(&mut harness, at(1e3 * made) + vec2(2.0, 0.0));
    assert_eq!(*harness.state().pulls.last().unwrap(), made);
    // The pull under the pointer is told to all; an edge of the window is not
    // one.
    harness.state_mut().shown = vec![Plot::Tip];
    harness.run();
    let plot = frame(&harness, "Slope of the tip over the pull");
    for (pull_mm, expected) in [(3.0, true), (4.0, false)] {
        let x = across(plot, pull_mm, (0.0, 8.0), 0.05);
        harness.hover_at(pos2(x, plot.center().y));
        harness.run();
        let hovered = harness.state().link.hovered;
        assert_eq!(matches!(hovered, Hovered::Pull(_)), expected, "{hovered:?}");
    }
}

#[test]
fn a_click_on_a_reading_makes_it_fix_the_friction() {
    let mut scene = load_cell();
    scene.robot.bending_stiffness_nmm2 = None;
    let bench = Bench::new(scene, 0.010, &[Plot::Force]);
    let mut harness = harness_of(bench, SIZE, Theme::Light);
    let plot = frame(&harness, "Force against load");
    // The axis goes to 1.2 of the greatest load, 350 g, and the line through
    // the fourth reading to its force there.
    let readings = harness.state().scene.measured.clone().unwrap().forces;
    let top = 1.05 * 1.2 * 350.0 * readings[3].force_g / readings[3].load_g;
    let reading = readings[6];
    let x = across(plot, reading.load_g, (0.0, 420.0), 0.02);
    let up = (reading.force_g + 0.04 * top) / (1.08 * top);
    let y = plot.bottom() - up as f32 * plot.height();
    click(&mut harness, pos2(x, y));
    assert_eq!(harness.state().calibrated, Some(6));
}

#[test]
fn without_forces_the_ways_to_them_are_offered() {
    let mut scene = scene(TWO_DISCS);
    scene.robot.bending_stiffness_nmm2 = None;
    let bench = Bench::new(scene, 0.008, &[Plot::Force]);
    let mut harness = harness_of(bench, SIZE, Theme::Light);
    harness.get_by_label("Set the stiffness").click();
    harness.run();
    harness.get_by_label("Add a reading").click();
    harness.run();
    let asked = [PlotAction::AskStiffness, PlotAction::AskReading];
    assert_eq!(harness.state().actions, asked);
}

#[test]
fn the_menu_saves_files() {
    for plot in Plot::ALL {
        let bench = Bench::new(load_cell(), 0.008, &[plot]);
        let expected = plots::csv(plot, &bench.data());
        let mut harness = harness_of(bench, SIZE, Theme::Light);
        let name = format!("Save the plot of {}", plot.title().to_lowercase());
        for item in ["Export CSV", "Export SVG"] {
            harness.get_by_label(&name).click();
            harness.run();
            harness.get_by_label(item).click();
            harness.run();
        }
        let [
            PlotAction::Save { bytes: csv, .. },
            PlotAction::Save {
                bytes: svg,
                extension,
                name,
            },
        ] = harness.state().actions.as_slice()
        else {
            panic!("{:?}", harness.state().actions.len());
        };
        assert_eq!(String::from_utf8(csv.clone()).unwrap(), expected);
        assert_eq!((name.as_str(), *extension), (plot.word(), "svg"));
        let svg = String::from_utf8(svg.clone()).unwrap();
        let document = roxmltree::Document::parse(&svg).unwrap();
        let drawn = document.descendants().filter(|node| node.is_element());
        assert!(drawn.count() > 20, "{plot:?}");
    }
}

/// The columns of a table, by name.
fn column(table: &str, name: &str) -> Vec<String> {
    let mut rows = csv::Reader::from_reader(table.as_bytes());
    let index = rows.headers().unwrap().iter().position(|n| n == name);
    let index = index.unwrap_or_else(|| panic!("{name}"));
    rows.records()
        .map(|row| row.unwrap()[index].to_owned())
        .collect()
}

fn numbers(table: &str, name: &str) -> Vec<f64> {
    let cells = column(table, name);
    cells.iter().map(|cell| cell.parse().unwrap()).collect()
}

#[test]
fn tables_hold_the_numbers_themselves() {
    let bench = Bench::new(load_cell(), 0.010, &[]);
    let (data, solution) = (bench.data(), &bench.solution);
    let table = plots::csv(Plot::Multipliers, &data);
    let pressing = solution.contacts.iter();
    let expected: Vec<f64> = pressing.map(|c| 1e-3 * c.multiplier).collect();
    assert_eq!(solution.contacts[0].class, Class::Pressing);
    assert_eq!(numbers(&table, "multiplier_rad2_per_mm"), expected);
    assert_eq!(column(&table, "node"), ["14"]);
    assert_eq!(column(&table, "obstacle"), ["load cell"]);

    let table = plots::csv(Plot::Bends, &data);
    let degrees = |angles: &[f64]| angles.iter().map(|a| a.to_degrees()).collect::<Vec<_>>();
    assert_eq!(numbers(&table, "bend_deg"), degrees(&solution.bends));
    assert_eq!(numbers(&table, "shear_deg"), degrees(&solution.shears));

    let path = bench.path.as_ref().unwrap();
    let table = plots::csv(Plot::Tip, &data);
    let expected: Vec<f64> = rows(path).map(|row| row[2]).collect();
    assert_eq!(numbers(&table, "tip_x_mm"), expected);

    let table = plots::csv(Plot::Energy, &data);
    let energies = column(&table, "energy_rad2");
    let energies: Vec<f64> = energies.iter().filter_map(|e| e.parse().ok()).collect();
    let expected: Vec<f64> = path.states.iter().map(|state| state.energy).collect();
    assert_eq!(energies, expected);
    let events = column(&table, "event");
    assert!(events.iter().any(|event| event.contains("load cell")));

    // Virtual work goes through the reading that fixes it.
    let table = plots::csv(Plot::Force, &data);
    let sources = column(&table, "source");
    let forces = numbers(&table, "force_g");
    let of = |source: &str| -> Vec<f64> {
        let pairs = sources.iter().zip(&forces);
        pairs
            .filter(|(s, _)| *s == source)
            .map(|(_, f)| *f)
            .collect()
    };
    let (read, estimated) = (of("measured"), of("virtual work"));
    assert_eq!(read.len(), 7);
    assert!((read[3] - estimated[3]).abs() < 1e-9);
    for (load, force) in numbers(&table, "load_g").iter().zip(&estimated) {
        assert!((force / load - read[3] / 200.0).abs() < 1e-12);
    }
    // The newest of the states by multipliers: F of eq. 5 with EI.
    let per_bend = 40_000e-6 / (2.0 * 0.010);
    let here = path
        .states
        .iter()
        .position(|s| s.pull == solution.pull)
        .unwrap();
    let from = path
        .states
        .iter()
        .position(|s| !s.contacts.is_empty())
        .unwrap();
    let force = per_bend * solution.contacts[0].multiplier / 9.80665e-3;
    // Two rows a state: of all obstacles, and of the one.
    let found = of("multipliers")[2 * (here - from)];
    assert!((found - force).abs() < 1e-6 * force, "{found} {force}");
}
