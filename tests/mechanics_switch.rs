//! The switch of mechanics in the window: where it is, what it keeps, what it says, and
//! both models side by side; and what of each cable is held.

mod window_harness;

use eframe::egui::{Key, Modifiers, Theme};
use egui_kittest::kittest::{NodeT, Queryable};
use sinew::app::{Hovered, Selection, Workbench};
use sinew::equilibrium::{Settings, Start, solve};
use sinew::mechanics::{Model, Problem};
use sinew::scene::{Cable, Drive, Mechanics, Scene};
use sinew::units::{grams, millimetres};
use window_harness::Window;

const TWO_DISCS: &str = include_str!("../assets/scenes/two-discs.toml");
const TWO_POSTS: &str = include_str!("../assets/scenes/two-posts.toml");

fn on(text: &str) -> Window {
    Window::open(Some(Scene::from_toml(text).unwrap()))
}

fn edit(window: &mut Window, edit: impl FnOnce(&mut Scene)) {
    edit(&mut window.harness.state_mut().bench_mut().document.scene);
    window.harness.run();
}

fn click(window: &mut Window, name: &str) {
    window.harness.get_by_label(name).click();
    window.harness.run();
}

fn told(window: &Window, words: &str) -> bool {
    let mut found = window.harness.query_all_by_label_contains(words);
    found.next().is_some()
}

fn model(bench: &Workbench) -> Model {
    assert!(bench.live.is_settled());
    bench.live.solution().unwrap().problem().model()
}

/// Two cables on both sides of the backbone, which stretch.
fn antagonists() -> Scene {
    let mut scene = Scene::from_toml(TWO_POSTS).unwrap();
    scene.obstacles.clear();
    let one = Cable {
        axial_stiffness_n: Some(20_000.0),
        ..scene.cable(0)
    };
    scene.robot.cable_offset_mm = None;
    scene.robot.cable_diameter_mm = 0.0;
    scene.actuation = None;
    let other = Cable {
        offset_mm: -8.0,
        drive: Drive::LoadG(100.0),
        ..one
    };
    scene.cables = vec![one, other];
    scene
}

#[test]
fn the_window_and_new_scenes_begin_with_a_cable_that_slides() {
    let mut window = Window::open(None);
    assert_eq!(model(window.bench()), Model::Sliding);
    let stiffness = |window: &Window| window.scene().robot.bending_stiffness_nmm2;
    assert_eq!(stiffness(&window), Some(8000.0));
    let solution = window.bench().live.solution().unwrap();
    let newtons = window.bench().document.newtons_per_multiplier().unwrap();
    for contact in &solution.contacts {
        let force = grams(newtons * contact.multiplier);
        assert!((1.0..500.0).contains(&force), "{force}");
    }
    window.key_with(Modifiers::COMMAND, Key::N);
    assert!(window.scene().obstacles.is_empty());
    assert_eq!(window.scene().model.mechanics, Mechanics::Sliding);
    assert_eq!(stiffness(&window), Some(8000.0));
    assert!(window.bench().live.is_settled());
}

#[test]
fn one_click_switches_and_one_step_takes_it_back() {
    let mut window = on(TWO_DISCS);
    assert_eq!(model(window.bench()), Model::Equal);
    let before = window.scene().clone();
    let is_chosen = |window: &Window, name: &str| {
        let node = window.harness.get_by_label(name);
        node.accesskit_node().toggled() == Some(eframe::egui::accesskit::Toggled::True)
    };
    assert!(is_chosen(&window, "Take the paper’s model"));
    click(&mut window, "Let the cable slide");
    assert_eq!(model(window.bench()), Model::Sliding);
    assert!(is_chosen(&window, "Let the cable slide"));
    // The pull stays, and nothing else changes.
    let mut expect = before.clone();
    expect.model.mechanics = Mechanics::Sliding;
    assert_eq!(*window.scene(), expect);
    // What is written of it opens the same.
    let text = window.scene().to_toml().unwrap();
    assert_eq!(Scene::from_toml(&text).unwrap(), expect);
    window.key_with(Modifiers::COMMAND, Key::Z);
    assert_eq!(*window.scene(), before);
    assert_eq!(model(window.bench()), Model::Equal);
    // By a key, too.
    window.key(Key::M);
    assert_eq!(model(window.bench()), Model::Sliding);
    window.key(Key::M);
    assert_eq!(model(window.bench()), Model::Equal);
    assert_eq!(*window.scene(), before);
}

#[test]
fn what_the_papers_model_cannot_take_is_said_at_the_switch() {
    let mut window = on(TWO_POSTS);
    edit(&mut window, |scene| scene.loads.tip_force_n = [0.0, -0.1]);
    assert!(told(
        &window,
        "The paper’s model cannot take this scene. Tip force is"
    ));
    let before = window.scene().clone();
    window.key(Key::M);
    assert_eq!(*window.scene(), before);
    let switch = window.harness.get_by_label("Take the paper’s model");
    assert!(switch.accesskit_node().is_disabled());
    edit(&mut window, |scene| *scene = antagonists());
    assert!(told(&window, "List of cables has 2 entries"));
    // And no more, once it can.
    edit(&mut window, |scene| {
        scene.clone_from(&Scene::from_toml(TWO_POSTS).unwrap())
    });
    assert!(!told(&window, "cannot take this scene"));
    window.key(Key::M);
    assert_eq!(model(window.bench()), Model::Equal);
}

#[test]
fn forces_of_the_papers_model_carry_a_mark_that_leads_to_true_ones() {
    let mut window = on(TWO_DISCS);
    window.harness.state_mut().bench_mut().selection = Selection::Nothing;
    window.harness.run();
    assert!(told(&window, "its contact forces are too small"));
    // In the inspector, above the legend and in the force plot.
    let marks = window
        .harness
        .query_all_by_label_contains("Forces understated");
    assert_eq!(marks.count(), 3);
    let mark = window
        .harness
        .query_all_by_label_contains("Forces understated");
    mark.last().unwrap().click();
    window.harness.run();
    assert_eq!(model(window.bench()), Model::Sliding);
    assert!(!told(&window, "understated") && !told(&window, "too small"));
    // Multipliers without a stiffness are nobody's grams.
    window.key(Key::M);
    assert!(told(&window, "Forces understated"));
    edit(&mut window, |scene| {
        scene.robot.bending_stiffness_nmm2 = None
    });
    assert!(!told(&window, "Forces understated"));
}

#[test]
fn both_stand_side_by_side_and_follow() {
    let mut window = on(TWO_POSTS);
    assert!(!told(&window, "Tension T:"));
    click(&mut window, "Draw both models");
    window.harness.run();
    let mut other = window.scene().clone();
    other.model.mechanics = Mechanics::Equal;
    let check = |window: &Window, other: &Scene| {
        let expect = solve(
            &Problem::new(other).unwrap(),
            Start::Straight,
            Settings::default(),
        );
        let live = window.bench().live.solution().unwrap();
        let x = |x: f64| format!("{:.2}", millimetres(x));
        let line = format!(
            "Tip x: Slides {} mm, Paper’s {} mm",
            x(live.tip().position.x),
            x(expect.tip().position.x)
        );
        assert!(told(window, &line), "{line}");
        let compared = window.bench().other.solved().unwrap();
        assert_eq!(compared.nodes, expect.nodes);
    };
    check(&window, &other);
    assert!(told(&window, "lower: Slides 16.6 g, Paper’s 0.22 g"));
    edit(&mut window, |scene| scene.set_pull_mm(5.0));
    window.harness.run();
    other.set_pull_mm(5.0);
    check(&window, &other);
    // An obstacle that moves, too.
    edit(&mut window, |scene| {
        scene.obstacles[0].shape.move_to_mm([36.0, 89.0])
    });
    window.harness.run();
    other.obstacles[0].shape.move_to_mm([36.0, 89.0]);
    check(&window, &other);
    // It is a choice of the window, not of the scene.
    let slides = window.scene().model.mechanics;
    assert_eq!(slides, Mechanics::Sliding);
    click(&mut window, "Draw both models");
    assert!(!told(&window, "Tip x: Slides"));
}

#[test]
fn dragging_the_tip_under_a_load_keeps_the_load_held() {
    let mut window = on(TWO_POSTS);
    window.key(Key::L);
    let Drive::LoadG(before) = window.scene().cable(0).drive else {
        panic!("{:?}", window.scene().cable(0).drive);
    };
    let tip = window.tip();
    window.drag(&[tip, tip + eframe::egui::vec2(-40.0, -10.0)]);
    let Drive::LoadG(after) = window.scene().cable(0).drive else {
        panic!("{:?}", window.scene().cable(0).drive);
    };
    assert!(after < before - 10.0, "{before} {after}");
    assert!(window.tip().x < tip.x - 10.0);
    // It plays on in grams.
    window.harness.key_press(Key::Space);
    window.harness.run_steps(10);
    let Drive::LoadG(played) = window.scene().cable(0).drive else {
        panic!("{:?}", window.scene().cable(0).drive);
    };
    assert!(played > after);
}

#[test]
fn each_of_two_cables_has_its_slider() {
    let mut window = Window::open(Some(antagonists()));
    assert!(window.bench().live.is_settled());
    window.harness.get_by_label("Pull slider");
    click(&mut window, "Cable 2");
    window.harness.get_by_label("Load slider");
    click(&mut window, "Set the pull");
    assert!(window.scene().cable(1).drive.pull_mm().is_some());
    assert_eq!(window.scene().cable(0).drive, Drive::PullMm(5.55));
    // The same shape, held otherwise.
    let state = window.bench().found(1).unwrap();
    let newtons = window.bench().document.newtons_per_multiplier().unwrap();
    assert!((grams(newtons * state.tension) - 100.0).abs() < 0.5);
    click(&mut window, "Cable 1");
    click(&mut window, "Set the load");
    assert!(matches!(window.scene().cable(0).drive, Drive::LoadG(_)));
    assert!(window.bench().live.is_settled());
}

#[test]
fn the_inspector_tells_what_each_cable_does() {
    let mut window = Window::sized([1280.0, 2400.0], Theme::Light, Some(antagonists()));
    window.harness.state_mut().bench_mut().selection = Selection::Robot;
    window.harness.run();
    for words in [
        "twice as stiff a backbone",
        "Disk spacing",
        "Cable 1",
        "Tension 100.0 g",
        "Tip force x",
        "Gravity",
    ] {
        assert!(told(&window, words), "{words}");
    }
    edit(&mut window, |scene| scene.set_drive(1, Drive::LoadG(0.0)));
    assert!(told(&window, "Tension slack"));
    click(&mut window, "Remove the last");
    assert_eq!(window.scene().cable_count(), 1);
    window.harness.get_by_label_contains("Add a cable").click();
    window.harness.run();
    assert_eq!(window.scene().cable(1).offset_mm, -8.0);
    assert_eq!(window.scene().cable(1).drive, Drive::LoadG(0.0));
    assert!(window.bench().live.is_settled());
    // The paper's robot has one cable, and no loads.
    edit(&mut window, |scene| {
        *scene = Scene::from_toml(TWO_DISCS).unwrap()
    });
    assert!(!told(&window, "Tip force x") && !told(&window, "Hold the load"));
}

#[test]
fn friction_is_typed_in_and_told_at_holes_and_contacts() {
    let mut window = Window::sized([1280.0, 2400.0], Theme::Light, None);
    window.harness.state_mut().bench_mut().selection = Selection::Robot;
    window.harness.run();
    for (name, text) in [
        ("In holes", "0.3"),
        ("At contacts", "0.2"),
        ("Lost at base", "0.1"),
    ] {
        click(&mut window, name);
        window
            .harness
            .key_press_modifiers(Modifiers::COMMAND, Key::A);
        window.harness.run();
        window.harness.get_by_label(name).type_text(text);
        window.harness.run();
        window.key(Key::Enter);
    }
    let friction = window.scene().friction;
    let typed = (friction.holes, friction.contacts, friction.base_loss);
    assert_eq!(typed, (0.3, 0.2, 0.1));
    assert!(window.bench().live.is_settled());
    // What each means, on hover.
    let at = window.harness.get_by_label("At contacts").rect().center();
    window.point(at);
    window.harness.run_steps(60);
    assert!(told(&window, "The cone on the canvas"));
}

#[test]
fn what_was_asked_and_what_was_reached_are_both_told() {
    let text = include_str!("../assets/scenes/one-disc.toml");
    let scene = Scene::from_toml(text).unwrap();
    let mut window = Window::sized([1280.0, 1200.0], Theme::Light, Some(scene));
    assert!(window.bench().reached(0).is_none());
    assert!(!told(&window, "reached"));
    edit(&mut window, |scene| scene.set_pull_mm(25.0));
    let reached = window.bench().reached(0).unwrap();
    let solution = window.bench().live.solution().unwrap();
    assert_eq!(reached, millimetres(solution.pull));
    assert!((14.0..24.9).contains(&reached), "{reached}");
    assert!(told(
        &window,
        &format!("Asked 25.00 mm, reached {reached:.2} mm")
    ));
    // In the panel, too.
    assert!(told(&window, "Asked 25.00 mm"));
    edit(&mut window, |scene| scene.set_pull_mm(3.0));
    assert!(window.bench().reached(0).is_none());
}

#[test]
fn keys_go_from_mark_to_mark() {
    let mut window = on(TWO_POSTS);
    let path = std::sync::Arc::clone(window.bench().live.path().unwrap());
    let marks: Vec<f64> = path
        .events
        .iter()
        .map(|event| millimetres(event.pull))
        .collect();
    let after = |pull: f64| {
        marks
            .iter()
            .copied()
            .filter(|mark| *mark > pull + 1e-3)
            .reduce(f64::min)
    };
    let [first, second] = {
        let first = after(5.55).unwrap();
        [first, after(first).unwrap()]
    };
    window.key(Key::Period);
    assert_eq!(window.scene().pull_mm(), first);
    assert!(window.bench().live.is_settled());
    window.key(Key::Period);
    assert_eq!(window.scene().pull_mm(), second);
    window.key(Key::Comma);
    assert_eq!(window.scene().pull_mm(), first);
    window.key_with(Modifiers::COMMAND, Key::Z);
    assert_eq!(window.scene().pull_mm(), second);
}

#[test]
fn all_plots_are_shown_at_once_with_room_for_each_and_grouped_again() {
    let mut window = on(TWO_POSTS);
    assert!(!told(&window, "Bends and shears by segment"));
    window.key(Key::A);
    for name in [
        "Multipliers by node",
        "Energy over the pull",
        "Force against load",
        "Bends and shears by segment",
        "Tension along the cables",
        "Load against pull",
    ] {
        let plot = window.harness.get_by_label(name);
        assert!(plot.rect().height() >= 70.0, "{name}: {}", plot.rect());
    }
    window.key(Key::A);
    assert!(!told(&window, "Bends and shears by segment"));
}

#[test]
fn gravity_is_switched_on_and_turned_by_hand() {
    let mut scene = Scene::from_toml(TWO_POSTS).unwrap();
    scene.obstacles.clear();
    scene.robot.disk_mass_g = 5.0;
    let mut window = Window::sized([1280.0, 2000.0], Theme::Light, Some(scene));
    window.harness.state_mut().bench_mut().selection = Selection::Robot;
    window.harness.run();
    let still = window.tip();
    click(&mut window, "Gravity");
    assert_eq!(window.scene().loads.gravity_m_s2, [0.0, -9.80665]);
    assert!(window.bench().live.is_settled());
    let hung = window.tip();
    assert!((hung - still).length() > 2.0, "{still} {hung}");
    // The dial is in the canvas's upper right corner, its arrow downward.
    let corner = window.harness.get_by_label("Robot and obstacles").rect();
    let middle = corner.right_top() + eframe::egui::vec2(-46.0, 46.0);
    let way = |x: f32, y: f32| middle + eframe::egui::vec2(x, y);
    let before = window.scene().clone();
    window.drag(&[way(0.0, 20.0), way(14.0, 14.0), way(40.0, 0.0)]);
    assert_eq!(window.scene().loads.gravity_m_s2, [9.80665, 0.0]);
    assert!(window.bench().live.is_settled());
    assert!(window.tip().x > hung.x + 5.0);
    window.key_with(Modifiers::COMMAND, Key::Z);
    assert_eq!(*window.scene(), before);
    // The robot's own corner is not the dial's, once there is no gravity.
    click(&mut window, "Gravity");
    assert_eq!(window.scene().loads.gravity_m_s2, [0.0; 2]);
    window.drag(&[way(0.0, 20.0), way(40.0, 0.0)]);
    assert_eq!(window.scene().loads.gravity_m_s2, [0.0; 2]);
}

#[test]
fn a_stretch_of_a_cable_is_lit_on_the_canvas_and_in_the_plots() {
    let mut window = on(TWO_POSTS);
    let holes = window.bench().live.solution().unwrap().holes(0);
    let middle = 500.0 * (holes[2] + holes[3]);
    let at = window.at(middle.x, middle.y);
    window.point(at);
    let expected = Hovered::Stretch {
        cable: 0,
        stretch: 2,
    };
    assert_eq!(window.bench().hovered, expected);
    window.point(at - eframe::egui::vec2(60.0, 0.0));
    assert_ne!(window.bench().hovered, expected);
}

#[test]
fn a_force_on_the_tip_is_dragged_out_of_it_and_taken_back() {
    let mut window = on(TWO_POSTS);
    edit(&mut window, |scene| scene.obstacles.clear());
    window.harness.state_mut().bench_mut().selection = Selection::Robot;
    window.harness.run();
    let before = window.scene().clone();
    let ahead = {
        let node = window.bench().live.solution().unwrap().tip();
        34.0 * eframe::egui::vec2(node.normal().x as f32, -node.normal().y as f32)
    };
    let grip = window.tip() + ahead;
    window.drag(&[grip, grip + eframe::egui::vec2(0.0, 60.0)]);
    let [x, y] = window.scene().loads.tip_force_n;
    // EI/L² is 0.247 N and 45 mm long.
    let expect = -f64::from(60.0 / window.points(45.0)) * 8000.0 / (180.0 * 180.0);
    assert!(
        x.abs() < 0.01 && (y - expect).abs() < 0.01,
        "{x} {y} {expect}"
    );
    assert!(window.bench().live.is_settled());
    assert!(told(&window, "cannot take this scene"));
    window.key_with(Modifiers::COMMAND, Key::Z);
    assert_eq!(*window.scene(), before);
    // The paper's model has none to take hold of.
    window.key(Key::M);
    let grip = window.tip() + ahead;
    let before = window.scene().clone();
    window.drag(&[grip, grip + eframe::egui::vec2(0.0, 60.0)]);
    assert_eq!(window.scene().loads, before.loads);
}

#[test]
fn the_mark_stands_in_space_and_in_the_table_too() {
    let mut window = on(TWO_DISCS);
    window.key(Key::Num2);
    let marks = |window: &Window| {
        let marks = window
            .harness
            .query_all_by_label_contains("Forces understated");
        marks.count()
    };
    assert_eq!(marks(&window), 3);
    click(&mut window, "Contacts");
    assert_eq!(marks(&window), 4);
    window.key(Key::M);
    assert_eq!(marks(&window), 0);
}
