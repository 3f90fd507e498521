//! The canvas, driven by pointer and keys as a person would: what one takes
//! hold of follows the hand, nothing lets the robot through, and everything can
//! be taken back.

mod window_harness;

use eframe::egui::accesskit::Role;
use eframe::egui::{
    Event, Key, Modifiers, MouseWheelUnit, PointerButton, Pos2, Theme, TouchPhase, vec2,
};
use egui_kittest::kittest::Queryable;
use sinew::app::workbench::Notice;
use sinew::app::{Hovered, Selection, Tool};
use sinew::geometry::Vector;
use sinew::scene::{Scene, Shape};
use window_harness::{Window, scene};

/// What every solution promises: it is certified, and nothing is inside of
/// anything, to the certificate's 1e-9 of the length.
fn keeps_out(window: &Window) {
    let bench = window.bench();
    assert!(bench.live.is_settled());
    let solution = bench.live.solution().unwrap();
    for clearance in solution.clearances() {
        assert!(clearance.clearance > -2e-10, "{clearance:?}");
    }
}

fn center(shape: &Shape) -> Vector {
    Vector::from(shape.anchor_mm())
}

fn disc() -> Shape {
    Shape::Disc {
        center_mm: [70.0, 90.0],
        radius_mm: 12.0,
    }
}

fn square() -> Shape {
    Shape::Polygon {
        points_mm: vec![[60.0, 70.0], [100.0, 70.0], [100.0, 110.0], [60.0, 110.0]],
        rotation_deg: 0.0,
        corner_radius_mm: 0.0,
    }
}

#[test]
fn a_disc_dragged_into_the_robot_pushes_it() {
    let mut window = Window::open(Some(scene(4.9, [disc()])));
    assert_eq!(window.bench().live.solution().unwrap().contacts.len(), 0);
    let before = window.scene().clone();
    let path = [window.at(72.0, 92.0), window.at(35.0, 92.0)];
    window.hold(&path);
    window.shoot("drag-disc");
    assert!(!window.bench().live.solution().unwrap().contacts.is_empty());
    keeps_out(&window);
    window.release(path[1]);
    // It is where the pointer is, held where it was taken hold of. Places are
    // rounded to 0.01 mm; a click's first pixels count as well.
    let moved = center(window.shape(0)) - Vector::new(33.0, 90.0);
    assert!(moved.norm() < 0.3, "{moved}");
    assert_eq!(window.bench().selection, Selection::Obstacle(0));
    window.key_with(Modifiers::COMMAND, Key::Z);
    assert_eq!(*window.scene(), before);
    assert!(!window.bench().history.can_undo(window.scene()));
}

#[test]
fn escape_takes_a_drag_back_exactly() {
    let mut window = Window::open(None);
    let before = window.scene().clone();
    let path = [window.at(33.0, 89.0), window.at(60.0, 70.0)];
    window.hold(&path);
    assert_ne!(*window.scene(), before);
    window.key(Key::Escape);
    assert_eq!(*window.scene(), before);
    // What the hand does until it lets go counts no more.
    window.point(window.at(80.0, 80.0));
    assert_eq!(*window.scene(), before);
    window.release(window.at(80.0, 80.0));
    assert_eq!(*window.scene(), before);
    assert!(!window.bench().history.can_undo(window.scene()));
}

#[test]
fn handles_resize_and_turn() {
    let rectangle = Shape::Box {
        center_mm: [80.0, 90.0],
        size_mm: [40.0, 30.0],
        rotation_deg: 0.0,
        corner_radius_mm: 0.0,
    };
    let mut window = Window::open(Some(scene(4.9, [rectangle, disc_at(100.0, 20.0)])));
    window.click(window.at(80.0, 90.0));
    window.shoot("box");
    let before = window.scene().clone();
    // A corner: the opposite one stays.
    window.drag(&[window.at(100.0, 105.0), window.at(110.0, 111.0)]);
    let Shape::Box {
        center_mm, size_mm, ..
    } = window.shape(0)
    else {
        panic!("no box");
    };
    let [center_mm, size_mm] = [*center_mm, *size_mm].map(Vector::from);
    // To half a pixel of the screen.
    let half_pixel = 0.5 / f64::from(window.points(1.0));
    assert!(
        (size_mm - Vector::new(50.0, 36.0)).amax() < half_pixel,
        "{size_mm}"
    );
    let opposite = center_mm - 0.5 * size_mm;
    assert!(
        (opposite - Vector::new(60.0, 75.0)).amax() < 1e-5,
        "{opposite}"
    );
    window.key_with(Modifiers::COMMAND, Key::Z);
    assert_eq!(*window.scene(), before);
    // The knob above it, a quarter turn to the right; Shift snaps.
    let knob = window.at(80.0, 105.0) - vec2(0.0, 24.0);
    window.hold(&[knob, window.at(130.0, 92.0)]);
    window.modifiers(Modifiers::SHIFT);
    assert_eq!(window.shape(0).rotation_deg(), -90.0);
    window.modifiers(Modifiers::NONE);
    window.shoot("turn");
    assert_ne!(window.shape(0).rotation_deg(), -90.0);
    window.release(window.at(130.0, 92.0));
    window.key_with(Modifiers::COMMAND, Key::Z);
    assert_eq!(*window.scene(), before);
    // A disc's rim.
    window.click(window.at(100.0, 20.0));
    window.drag(&[window.at(112.0, 20.0), window.at(120.0, 20.0)]);
    let Shape::Disc { radius_mm, .. } = window.shape(1) else {
        panic!("no disc");
    };
    assert!((radius_mm - 20.0).abs() < half_pixel, "{radius_mm}");
    window.shoot("rim");
}

fn disc_at(x: f64, y: f64) -> Shape {
    Shape::Disc {
        center_mm: [x, y],
        radius_mm: 12.0,
    }
}

#[test]
fn a_capsules_end_and_a_wall_follow_the_hand() {
    let capsule = Shape::Capsule {
        center_mm: [90.0, 120.0],
        length_mm: 30.0,
        radius_mm: 5.0,
        rotation_deg: 0.0,
    };
    let wall = Shape::Wall {
        point_mm: [130.0, 60.0],
        rotation_deg: 180.0,
        corner_radius_mm: 0.0,
    };
    let mut window = Window::open(Some(scene(4.9, [capsule, wall])));
    window.click(window.at(90.0, 120.0));
    window.shoot("capsule");
    window.drag(&[window.at(110.0, 120.0), window.at(75.0, 150.0)]);
    // The left end, at (75, 120), stays; the right one is now above it.
    assert!((window.shape(0).rotation_deg() - 90.0).abs() < 1.0);
    let low = center(window.shape(0)) - Vector::new(75.0, 132.5);
    assert!(low.norm() < 0.5, "{low}");
    // A wall goes along its normal.
    window.drag(&[window.at(140.0, 90.0), window.at(120.0, 40.0)]);
    let moved = center(window.shape(1)) - Vector::new(110.0, 60.0);
    assert!(moved.norm() < 0.3, "{moved}");
    window.shoot("wall");
}

#[test]
fn polygons_gain_lose_and_move_vertices() {
    let mut window = Window::open(Some(scene(4.9, [square()])));
    let points = |window: &Window| match window.shape(0) {
        Shape::Polygon { points_mm, .. } => points_mm.clone(),
        _ => panic!("no polygon"),
    };
    window.click(window.at(80.0, 90.0));
    window.drag(&[window.at(100.0, 110.0), window.at(112.0, 118.0)]);
    let corner = Vector::from(points(&window)[2]) - Vector::new(112.0, 118.0);
    assert!(corner.norm() < 0.3, "{corner}");
    // Pulled through the opposite side it stops before.
    window.drag(&[window.at(112.0, 118.0), window.at(50.0, 60.0)]);
    assert!(window.bench().refusal.is_none());
    let corner = Vector::from(points(&window)[2]);
    assert!(
        corner.x + corner.y > 170.0 && corner.x + corner.y < 173.0,
        "{corner}"
    );
    window.key_with(Modifiers::COMMAND, Key::Z);
    // The left edge gets another, which Delete removes again.
    window.double_click(window.at(60.5, 88.0));
    assert_eq!(points(&window).len(), 5);
    window.shoot("polygon");
    window.key(Key::Delete);
    assert_eq!(points(&window).len(), 4);
    // Now nothing of it is selected but itself.
    window.key(Key::Delete);
    assert_eq!(window.scene().obstacles.len(), 0);
}

#[test]
fn the_view_is_moved_and_zoomed_at_the_pointer() {
    let mut window = Window::open(None);
    let before = window.scene().clone();
    let empty = window.at(110.0, 40.0);
    let world = |window: &Window, at: Pos2| {
        let at = Vector::new(f64::from(at.x), f64::from(at.y));
        window.canvas().frame().to_world(at)
    };
    let there = empty + vec2(-60.0, 30.0);
    let held = world(&window, empty);
    window.drag(&[empty, there]);
    assert!((world(&window, there) - held).norm() < 1e-6, "pan");
    // The middle button moves it wherever it is, the wheel keeps the point
    // under the pointer.
    let post = window.at(33.0, 89.0);
    let held = world(&window, post);
    window.point(post);
    window.button(post, PointerButton::Middle, true);
    window.point(post + vec2(20.0, 10.0));
    window.point(post + vec2(40.0, 10.0));
    window.button(post + vec2(40.0, 10.0), PointerButton::Middle, false);
    let post = post + vec2(40.0, 10.0);
    assert!((world(&window, post) - held).norm() < 1e-6, "middle button");
    let scale = window.canvas().frame().scale;
    window.harness.event(Event::MouseWheel {
        unit: MouseWheelUnit::Line,
        delta: vec2(0.0, 3.0),
        phase: TouchPhase::Move,
        source: eframe::egui::MouseWheelSource::Wheel,
        modifiers: Modifiers::NONE,
    });
    window.harness.run();
    assert!(window.canvas().frame().scale > 1.2 * scale);
    assert!((world(&window, post) - held).norm() < 1e-6, "wheel");
    // Space held drags the view off an obstacle too, and plays nothing.
    window.harness.key_down(Key::Space);
    window.harness.run();
    window.drag(&[post, post + vec2(0.0, 50.0)]);
    window.harness.key_up(Key::Space);
    window.harness.run();
    let post = post + vec2(0.0, 50.0);
    assert!((world(&window, post) - held).norm() < 1e-6, "space");
    assert!(!window.bench().transport.is_playing());
    assert_eq!(*window.scene(), before);
    // Without a drag it plays.
    window.harness.key_press(Key::Space);
    window.harness.run_steps(4);
    assert!(window.bench().transport.is_playing());
}

#[test]
fn two_fingers_move_the_view_and_leave_the_scene() {
    let mut window = Window::open(None);
    let before = window.scene().clone();
    let scale = window.canvas().frame().scale;
    let post = window.at(33.0, 89.0);
    let touch = |window: &mut Window, id: u64, phase, at: Pos2| {
        window.harness.event(Event::Touch {
            device_id: eframe::egui::TouchDeviceId(1),
            id: eframe::egui::TouchId(id),
            phase,
            pos: at,
            force: None,
        });
        window.harness.run();
    };
    // The first finger takes hold of a post, as a pointer does …
    touch(&mut window, 1, TouchPhase::Start, post);
    window.hold(&[post, post + vec2(30.0, 0.0)]);
    touch(&mut window, 1, TouchPhase::Move, post + vec2(30.0, 0.0));
    assert_ne!(*window.scene(), before);
    // … until there is a second.
    touch(&mut window, 2, TouchPhase::Start, post + vec2(60.0, 0.0));
    touch(&mut window, 2, TouchPhase::Move, post + vec2(90.0, 0.0));
    touch(&mut window, 2, TouchPhase::Move, post + vec2(120.0, 0.0));
    assert_eq!(*window.scene(), before);
    assert!(window.canvas().frame().scale > 1.3 * scale);
}

#[test]
fn a_double_click_on_the_plane_adds_a_disc() {
    let mut window = Window::open(None);
    window.double_click(window.at(100.0, 60.0));
    assert_eq!(window.scene().obstacles.len(), 3);
    assert_eq!(window.bench().selection, Selection::Obstacle(2));
    let off = center(window.shape(2)) - Vector::new(100.0, 60.0);
    assert!(off.norm() < 0.3, "{off}");
    window.key_with(Modifiers::COMMAND, Key::Z);
    assert_eq!(window.scene().obstacles.len(), 2);
}

#[test]
fn tools_place_by_click_and_by_drag() {
    let mut window = Window::open(None);
    window.harness.get_by_label_contains("Add a box").click();
    window.harness.run();
    assert_eq!(window.canvas().tool(), Tool::Box);
    window.point(window.at(90.0, 40.0));
    window.shoot("tool");
    window.drag(&[window.at(90.0, 40.0), window.at(120.0, 60.0)]);
    let Shape::Box { size_mm, .. } = window.shape(2) else {
        panic!("no box");
    };
    let off = Vector::from(*size_mm) - Vector::new(30.0, 20.0);
    assert!(off.norm() < 0.5, "{off}");
    assert_eq!(window.canvas().tool(), Tool::Select);
    // By its key; the wall has the robot on its free side.
    window.key(Key::W);
    window.click(window.at(100.0, 100.0));
    assert!(matches!(window.shape(3), Shape::Wall { .. }));
    keeps_out(&window);
    window.shoot("wall-placed");
    // Escape puts a tool away.
    window.key(Key::K);
    assert_eq!(window.canvas().tool(), Tool::Capsule);
    window.key(Key::Escape);
    assert_eq!(window.canvas().tool(), Tool::Select);
    assert_eq!(window.scene().obstacles.len(), 4);
}

#[test]
fn a_polygon_is_drawn_vertex_by_vertex() {
    let mut window = Window::open(Some(scene(4.9, [])));
    window.key(Key::P);
    for [x, y] in [[70.0, 60.0], [100.0, 60.0], [80.0, 70.0], [70.0, 100.0]] {
        window.click(window.at(x, y));
    }
    window.point(window.at(60.0, 80.0));
    window.shoot("draft");
    assert_eq!(window.scene().obstacles.len(), 0);
    window.key(Key::Enter);
    let Shape::Polygon { points_mm, .. } = window.shape(0) else {
        panic!("no polygon");
    };
    // The dent is gone, and it is said.
    assert_eq!(points_mm.len(), 3);
    assert!(window.is_told("hull"));
    window.shoot("hull");
    // Escape draws nothing; two vertices enclose nothing.
    window.key(Key::P);
    window.click(window.at(100.0, 100.0));
    window.key(Key::Escape);
    assert_eq!(window.canvas().tool(), Tool::Select);
    window.key(Key::P);
    window.click(window.at(100.0, 100.0));
    window.double_click(window.at(110.0, 110.0));
    assert_eq!(window.scene().obstacles.len(), 1);
    assert!(window.is_told("three"));
}

#[test]
fn keys_nudge_duplicate_delete_and_go_round() {
    let mut window = Window::open(None);
    window.click(window.at(33.0, 89.0));
    let start = center(window.shape(0));
    window.key(Key::ArrowRight);
    window.key_with(Modifiers::SHIFT, Key::ArrowUp);
    window.key_with(Modifiers::ALT, Key::ArrowLeft);
    let by = center(window.shape(0)) - start;
    assert!((by - Vector::new(0.45, 5.0)).amax() < 1e-9, "{by}");
    window.key_with(Modifiers::COMMAND, Key::D);
    assert_eq!(window.scene().obstacles.len(), 3);
    assert_eq!(window.bench().selection, Selection::Obstacle(2));
    assert_eq!(
        window.scene().obstacles[2].name.as_deref(),
        Some("lower copy")
    );
    window.key(Key::Delete);
    assert_eq!(window.scene().obstacles.len(), 2);
    for expect in [
        Selection::Obstacle(0),
        Selection::Obstacle(1),
        Selection::Robot,
    ] {
        window.key(Key::Tab);
        assert_eq!(window.bench().selection, expect);
    }
    window.key_with(Modifiers::SHIFT, Key::Tab);
    assert_eq!(window.bench().selection, Selection::Obstacle(1));
    window.key(Key::Tab);
    let pull = window.scene().pull_mm();
    window.key(Key::ArrowUp);
    assert!((window.scene().pull_mm() - pull - 0.1).abs() < 1e-9);
    // Past the robot the focus goes on to other controls.
    let focused = |window: &Window| {
        let canvas = window.harness.get_by_label("Robot and obstacles");
        canvas.is_focused()
    };
    window.key(Key::Tab);
    assert_eq!(window.bench().selection, Selection::Nothing);
    assert!(focused(&window));
    window.key(Key::Tab);
    assert_eq!(window.bench().selection, Selection::Nothing);
    assert!(!focused(&window));
}

#[test]
fn the_tip_is_dragged_to_pull() {
    for shapes in [vec![], vec![disc_at(40.0, 89.0)]] {
        let mut window = Window::open(Some(scene(4.9, shapes)));
        let before = window.scene().clone();
        let tip = window.tip();
        let to = tip + vec2(window.points(20.0), window.points(8.0));
        window.hold(&[tip, to]);
        window.shoot("tip");
        assert!(window.scene().pull_mm() > 5.5);
        keeps_out(&window);
        assert!(window.tip().x > tip.x + window.points(8.0));
        window.release(to);
        window.key_with(Modifiers::COMMAND, Key::Z);
        assert_eq!(*window.scene(), before);
    }
}

#[test]
fn an_edit_that_cannot_be_is_taken_back_and_told() {
    let mut window = Window::open(Some(scene(4.9, [disc()])));
    window.hold(&[
        window.at(70.0, 90.0),
        window.at(40.0, 30.0),
        window.at(4.0, 0.0),
    ]);
    let refusal = window.bench().refusal.as_ref().unwrap();
    assert!(refusal.faults[0].to_string().contains("base"));
    window.shoot("refused");
    // It stays at the last place that can be, and follows again from there.
    let stopped = center(window.shape(0));
    assert!(stopped.norm() > 12.0, "{stopped}");
    keeps_out(&window);
    window.point(window.at(50.0, 30.0));
    assert!(window.bench().refusal.is_none());
    let off = center(window.shape(0)) - Vector::new(50.0, 30.0);
    assert!(off.norm() < 0.3, "{off}");
    window.release(window.at(50.0, 30.0));
    // New ones are told as well, and for a few seconds only.
    window.key(Key::D);
    window.click(window.at(2.0, 2.0));
    assert_eq!(window.scene().obstacles.len(), 1);
    assert!(window.bench().refusal.is_some());
    window.harness.run_steps(5 * 60);
    assert!(window.bench().refusal.is_none());
}

#[test]
fn what_is_hovered_is_known_everywhere() {
    let mut window = Window::open(None);
    let solution = window.bench().live.solution().unwrap().clone();
    let contact = solution.contacts[0].point;
    window.point(window.at(1e3 * contact.x, 1e3 * contact.y));
    assert_eq!(window.bench().hovered, Hovered::Contact(0));
    window.shoot("hover-contact");
    let node = solution.nodes[5].position;
    window.point(window.at(1e3 * node.x, 1e3 * node.y));
    assert_eq!(window.bench().hovered, Hovered::Node(5));
    window.shoot("hover-node");
    window.point(window.at(60.0, 141.0));
    assert_eq!(window.bench().hovered, Hovered::Obstacle(1));
    window.point(window.at(110.0, 30.0));
    assert_eq!(window.bench().hovered, Hovered::Nothing);
}

#[test]
fn a_right_click_offers_what_can_be_done() {
    let mut window = Window::open(Some(scene(4.9, [square()])));
    window.click_with(window.at(90.0, 90.0), PointerButton::Secondary);
    assert_eq!(window.bench().selection, Selection::Obstacle(0));
    window.shoot("menu");
    window.harness.get_by_label("Add a vertex here").click();
    window.harness.run();
    let Shape::Polygon { points_mm, .. } = window.shape(0) else {
        panic!("no polygon");
    };
    assert_eq!(points_mm.len(), 5);
    window.click_with(window.at(90.0, 90.0), PointerButton::Secondary);
    window
        .harness
        .get_by_role_and_label(Role::TextInput, "Rename")
        .click();
    window.harness.run();
    window.harness.event(Event::Text("block".to_owned()));
    window.harness.run();
    assert_eq!(window.scene().obstacles[0].name.as_deref(), Some("block"));
    // Escape closes the menu; the block stays selected.
    window.key(Key::Escape);
    assert!(window.harness.query_by_label("Add a vertex here").is_none());
    assert_eq!(window.bench().selection, Selection::Obstacle(0));
    window.click_with(window.at(105.0, 20.0), PointerButton::Secondary);
    window.shoot("menu-plane");
    window.harness.get_by_label("Add a capsule here").click();
    window.harness.run();
    assert!(matches!(window.shape(1), Shape::Capsule { .. }));
}

#[test]
fn hints_are_gone_once_they_were_of_use() {
    let mut window = Window::open(None);
    window.shoot("hints");
    let hints = |window: &Window| window.bench().preferences.hints;
    assert!(!hints(&window).obstacle && !hints(&window).tip);
    window.drag(&[window.at(33.0, 89.0), window.at(38.0, 89.0)]);
    assert!(hints(&window).obstacle && !hints(&window).tip);
    let tip = window.tip();
    window.drag(&[tip, tip + vec2(20.0, 5.0)]);
    assert!(hints(&window).tip);
}

/// Where the solver takes its time, the view waits for the robot.
#[test]
fn the_view_fits_the_robot_that_comes_later() {
    let slow = sinew::app::backend::Inline::sliced(std::time::Duration::ZERO);
    let mut window = Window::with([1280.0, 800.0], Theme::Light, None, slow);
    window.harness.run_steps(400);
    assert!(window.bench().live.is_settled());
    // As large as one that was solved at once.
    let expect = Window::open(None).canvas().frame();
    assert_eq!(window.canvas().frame(), expect);
    // A view that was moved stays.
    window.drag(&[window.at(100.0, 30.0), window.at(80.0, 50.0)]);
    let moved = window.canvas().frame();
    window.click(window.at(33.0, 89.0));
    window.key(Key::ArrowRight);
    window.harness.run_steps(400);
    assert_eq!(window.canvas().frame(), moved);
}

/// Pictures in both themes at the resolution of a good screen, to be looked at.
#[test]
fn handles_are_drawn_in_both_themes() {
    for (theme, name) in [(Theme::Light, "light"), (Theme::Dark, "dark")] {
        let shapes = [square(), disc_at(35.0, 60.0), turned_capsule()];
        let mut window = Window::sized([1000.0, 700.0], theme, Some(scene(6.0, shapes)));
        window.harness.set_pixels_per_point(2.0);
        window.harness.run();
        window.click(window.at(80.0, 90.0));
        window.point(window.at(100.0, 110.0));
        window.shoot(&format!("{name}-polygon"));
        window.click(window.at(65.0, 140.0));
        window.point(window.at(120.0, 20.0));
        window.shoot(&format!("{name}-capsule"));
        assert_eq!(window.bench().selection, Selection::Obstacle(2));
    }
}

fn turned_capsule() -> Shape {
    Shape::Capsule {
        center_mm: [65.0, 140.0],
        length_mm: 30.0,
        radius_mm: 5.0,
        rotation_deg: 35.0,
    }
}

/// A shape that is no certified equilibrium says why and offers ways out.
#[test]
fn a_branch_that_ends_says_so() {
    let mut scene: Scene = scene(4.9, [disc_at(24.0, 89.0), disc_at(-30.0, 89.0)]);
    scene.set_pull_mm(24.0);
    let mut window = Window::open(Some(scene));
    assert!(window.bench().live.drawing().standing.is_greyed());
    window.shoot("stuck");
    assert!(window.harness.query_by_label("Undo").is_some());
    let generation = |window: &Window| window.bench().live.shape().unwrap().generation;
    let before = generation(&window);
    window.harness.get_by_label("Start from straight").click();
    window.harness.run();
    assert!(generation(&window) > before);
}

#[test]
fn words_over_the_canvas_keep_clear_of_the_robot_in_small_windows() {
    for size in [[420.0, 800.0], [800.0, 600.0]] {
        let text = include_str!("../assets/scenes/one-disc.toml");
        let mut scene = Scene::from_toml(text).unwrap();
        scene.set_pull_mm(25.0);
        let mut window = Window::sized(size, Theme::Light, Some(scene));
        let told = "Words that are told in passing, long enough for two lines of a phone";
        let notice = Notice::information(told);
        window.harness.state_mut().bench_mut().notices.tell(notice);
        window.harness.run_steps(3);
        assert!(window.bench().live.drawing().standing.is_greyed());
        let solved = window.bench().live.solution().unwrap();
        let points: Vec<_> = [solved.nodes[0], solved.tip()]
            .map(|node| node.position)
            .into_iter()
            .chain(solved.contacts.iter().map(|contact| contact.point))
            .map(|at| window.at(1e3 * at.x, 1e3 * at.y))
            .collect();
        for words in [told, "Undo", "Branch ended"] {
            let all = window.harness.query_all_by_label_contains(words);
            for area in all.map(|node| node.rect()) {
                let over = points.iter().find(|point| area.contains(**point));
                assert_eq!(over, None, "{words} at {area:?} in {size:?}");
            }
        }
    }
}

#[test]
fn a_robot_is_pinned_by_key_and_told_apart_from_the_live_one() {
    let mut window = Window::open(None);
    window.key(Key::N);
    assert_eq!(window.bench().pins.all().len(), 1);
    let scene = &mut window.harness.state_mut().bench_mut().document.scene;
    scene.set_pull_mm(5.05);
    window.harness.run();
    window.harness.get_by_label("Pull, mm: −0.50");
    window.harness.get_by_label("Let A go").click();
    window.harness.run();
    assert!(window.bench().pins.all().is_empty());
}
