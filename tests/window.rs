//! The window as a whole: what it shows at first, and pictures of whole screens
//! in `tests/screens`. `UPDATE_SNAPSHOTS=1 cargo test --test window` renews them;
//! then look at them.
//!
//! The pictures are those of lavapipe, Mesa's Vulkan driver in software, at one
//! pixel a point. Where the solver's time is written they are covered.

mod window_harness;

use eframe::egui::{Event, Key, Modifiers, Rect, Theme, pos2};
use egui_kittest::SnapshotOptions;
use egui_kittest::kittest::Queryable;
use sinew::app::Views;
use sinew::equilibrium::Status;
use sinew::scene::{Drive, Scene};
use sinew::units::grams;
use window_harness::Window;

const SIZE: [f32; 2] = [1200.0, 750.0];
const PHONE: [f32; 2] = [390.0, 780.0];

/// Compares a picture of the window with the one that is kept.
fn compare(window: &mut Window, name: &str) {
    let chip = window.harness.get_by_label_contains("Status:").rect();
    // The residual, the iterations and the time, right of the word.
    let numbers = Rect::from_min_max(pos2(chip.left() + 124.0, chip.top()), chip.max);
    if numbers.is_positive() {
        window.harness.mask(numbers);
    }
    // What differs between two versions of the driver is less than this; a
    // colour or a place that has changed is more.
    let options = SnapshotOptions::new()
        .threshold(1.0)
        .max_failed_pixels(10)
        .output_path("tests/screens");
    window.harness.snapshot_options(name, &options);
}

fn example(text: &str) -> Option<Scene> {
    Some(Scene::from_toml(text).unwrap())
}

#[test]
fn opens_on_the_robot_leaning_on_two_discs() {
    let mut window = Window::sized(SIZE, Theme::Light, None);
    assert!(window.bench().live.is_settled());
    let solution = window.bench().live.solution().unwrap();
    assert_eq!(solution.contacts.len(), 2);
    compare(&mut window, "light");
}

#[test]
fn shows_plane_and_space_side_by_side_in_the_dark() {
    let mut window = Window::sized(SIZE, Theme::Dark, None);
    window.key(Key::Num3);
    assert_eq!(window.bench().preferences.views, Views::Both);
    compare(&mut window, "dark-both");
}

#[test]
fn shows_the_robot_in_space_alone() {
    let grip = example(include_str!("../assets/scenes/grip.toml"));
    let mut window = Window::sized(SIZE, Theme::Light, grip);
    window.key(Key::Num2);
    compare(&mut window, "space");
}

#[test]
fn a_robot_that_can_go_no_further_is_greyed_with_its_reason() {
    let wedge = example(include_str!("../assets/scenes/wedge.toml"));
    let mut window = Window::sized(SIZE, Theme::Dark, wedge);
    window
        .harness
        .state_mut()
        .bench_mut()
        .document
        .scene
        .set_pull_mm(12.0);
    window.harness.run();
    let status = &window.bench().live.solution().unwrap().status;
    assert!(!matches!(status, Status::Converged), "{status:?}");
    assert!(window.bench().live.drawing().standing.is_greyed());
    compare(&mut window, "infeasible");
}

#[test]
fn a_phone_shows_the_canvas_and_the_slider() {
    let mut window = Window::sized(PHONE, Theme::Light, None);
    compare(&mut window, "phone");

    // What has no room beside the canvas is below it.
    let below = |window: &mut Window, button: &str, shown: &str| {
        assert!(window.harness.query_by_label_contains(shown).is_none());
        window.harness.get_by_label_contains(button).click();
        window.harness.run();
        window.harness.get_by_label_contains(shown);
    };
    below(&mut window, "the plots", "Multipliers by node");
    window.shoot("phone-plots");
    below(&mut window, "the outline", "Add an obstacle");
    window.shoot("phone-outline");
    window.harness.get_by_label("Close").click();
    window.harness.run();
    assert!(
        window
            .harness
            .query_by_label_contains("Add an obstacle")
            .is_none()
    );
}

#[test]
fn a_load_can_be_set_in_the_place_of_the_pull() {
    let mut window = Window::sized(SIZE, Theme::Light, None);
    window.harness.get_by_label("Pull slider");
    window.harness.get_by_label("Set the load").click();
    window.harness.run();
    window.harness.get_by_label("Load slider");
    window.harness.get_by_label("Load").click();
    window.harness.run();
    window.key_with(Modifiers::COMMAND, Key::A);
    window.harness.event(Event::Text("300".to_owned()));
    window.key(Key::Enter);
    let load = |window: &Window| {
        let bench = window.bench();
        let newtons = bench.document.newtons_per_multiplier().unwrap();
        let slope = bench.live.solution().unwrap().certificate.energy_slope;
        grams(newtons * slope)
    };
    assert!(window.bench().live.is_settled());
    assert!((load(&window) - 300.0).abs() < 1e-6, "{}", load(&window));
    // It is what is held: a softer robot bends farther under it.
    assert_eq!(window.scene().cable(0).drive, Drive::LoadG(300.0));
    let pull_mm = window.bench().pull_mm();
    let robot = &mut window.harness.state_mut().bench_mut().document.scene.robot;
    robot.bending_stiffness_nmm2 = Some(7000.0);
    window.harness.run();
    assert!((load(&window) - 300.0).abs() < 1e-6, "{}", load(&window));
    assert!(window.bench().pull_mm() > pull_mm + 0.1);
    // Without a stiffness there are no loads.
    let robot = &mut window.harness.state_mut().bench_mut().document.scene.robot;
    robot.bending_stiffness_nmm2 = None;
    window.harness.run();
    assert_eq!(window.scene().robot.bending_stiffness_nmm2, Some(7000.0));
    // The other way round, what hangs there now is found.
    window.harness.get_by_label("Set the pull").click();
    window.harness.run();
    assert!((load(&window) - 300.0).abs() < 0.1, "{}", load(&window));
    assert!(window.scene().cable(0).drive.pull_mm().is_some());
    // With a pull held, a robot needs no stiffness, and offers no loads.
    let robot = &mut window.harness.state_mut().bench_mut().document.scene.robot;
    robot.bending_stiffness_nmm2 = None;
    window.harness.run();
    window.harness.get_by_label("Pull slider");
    window.key(Key::L);
    window.harness.get_by_label("Pull slider");
}

#[test]
fn in_the_papers_model_a_load_is_a_way_to_set_the_pull() {
    let scene = example(include_str!("../assets/scenes/two-discs.toml"));
    let mut window = Window::sized(SIZE, Theme::Light, scene);
    window.key(Key::L);
    window.harness.get_by_label("Load slider");
    assert_eq!(window.scene().cable(0).drive, Drive::PullMm(4.9));
    // Where no stiffness is known it goes.
    let robot = &mut window.harness.state_mut().bench_mut().document.scene.robot;
    robot.bending_stiffness_nmm2 = None;
    window.harness.run();
    window.harness.get_by_label("Pull slider");
}

#[test]
fn a_jump_is_told_and_the_way_back_shows_another_branch() {
    let slip = example(include_str!("../assets/scenes/slip-off.toml"));
    let mut window = Window::sized(SIZE, Theme::Light, slip);
    let pull = |window: &mut Window, pull_mm: f64| {
        let bench = window.harness.state_mut().bench_mut();
        bench.document.scene.set_pull_mm(pull_mm);
        window.harness.run_steps(8);
    };
    let elsewhere = |window: &Window| {
        let banner = window.harness.query_by_label("Another branch");
        banner.is_some()
    };
    assert!(!elsewhere(&window));
    pull(&mut window, 7.5);
    assert!(window.is_told("robot jumps"));
    assert!(!elsewhere(&window));
    window.shoot("jump");
    pull(&mut window, 6.5);
    assert!(elsewhere(&window));
    window.shoot("another-branch");
    window.harness.get_by_label("Start from straight").click();
    window.harness.run();
    assert!(!elsewhere(&window));
}
