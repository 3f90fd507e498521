//! The panels, worked as a person would, with the keyboard and the pointer, and
//! found by the names that a screen reader tells.

use eframe::egui::{Event, Key, Modifiers, PointerButton, Theme, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable;
use sinew::app::backend::Inline;
use sinew::app::dock::tables;
use sinew::app::{Preferences, Selection, Sinew, Workbench};
use sinew::forces::{Statics, Stiffness};
use sinew::mechanics::Condition;
use sinew::scene::{Candidates, Scene, Shape};
use sinew::view::{Standing, outcome};

type Window = Harness<'static, Sinew>;

/// A window on a scene, or on the first example, solved inline so that nothing
/// races.
fn window(scene: Option<Scene>, size: [f32; 2], theme: Theme) -> Window {
    window_with(scene, size, theme, false)
}

fn window_with(scene: Option<Scene>, size: [f32; 2], theme: Theme, dock: bool) -> Window {
    let preferences = Preferences {
        theme: theme.into(),
        dock,
        ..Preferences::default()
    };
    let mut window = Harness::builder()
        .with_size(vec2(size[0], size[1]))
        .with_pixels_per_point(1.0)
        .with_theme(theme)
        .wgpu()
        .build_eframe(move |cc| {
            let backend = Box::new(Inline::to_the_end());
            Sinew::new(&cc.egui_ctx, scene, backend, preferences).unwrap()
        });
    window.run();
    window
}

fn first() -> Window {
    window(None, [1280.0, 800.0], Theme::Light)
}

fn scene(window: &Window) -> &Scene {
    &window.state().bench().document.scene
}

fn bench(window: &Window) -> &Workbench {
    window.state().bench()
}

/// Types into a field in the place of what is there, and presses Enter.
fn enter(window: &mut Window, name: &str, text: &str) {
    window.get_by_label(name).click();
    window.run();
    window.key_press_modifiers(Modifiers::COMMAND, Key::A);
    window.run();
    if text.is_empty() {
        window.key_press(Key::Delete);
    } else {
        let field = window.get_by_label(name);
        field.type_text(text);
    }
    window.run();
    window.key_press(Key::Enter);
    window.run();
}

fn select(window: &mut Window, name: &str) {
    window.get_by_label(name).click();
    window.run();
}

fn radius(window: &Window, index: usize) -> f64 {
    match scene(window).obstacles[index].shape {
        Shape::Disc { radius_mm, .. } => radius_mm,
        _ => panic!("not a disc"),
    }
}

/// The names of the discs in the first example.
fn discs(window: &Window) -> Vec<String> {
    let obstacles = scene(window).obstacles.iter();
    obstacles.map(|it| it.name.clone().unwrap()).collect()
}

fn told(window: &Window, text: &str) -> bool {
    window.query_all_by_label_contains(text).next().is_some()
}

#[test]
fn a_radius_is_typed_with_or_without_its_unit() {
    let mut window = first();
    let names = discs(&window);
    select(&mut window, &names[0]);
    assert_eq!(bench(&window).selection, Selection::Obstacle(0));
    let check = |window: &mut Window, text: &str, expect: f64| {
        enter(window, "Radius", text);
        assert_eq!(radius(window, 0), expect, "{text}");
    };
    check(&mut window, "12", 12.0);
    check(&mut window, "12,5", 12.5);
    check(&mut window, "1.1 cm", 11.0);
    check(&mut window, "0.01 m", 10.0);
    check(&mut window, "9.4321 mm", 9.4321);
    assert!(bench(&window).live.is_settled());
    // Escape gives up what was typed, and nothing else.
    window.get_by_label("Radius").click();
    window.run();
    window.get_by_label("Radius").type_text("7");
    window.run();
    window.key_press(Key::Escape);
    window.run();
    assert_eq!(radius(&window, 0), 9.4321);
    assert_eq!(bench(&window).selection, Selection::Obstacle(0));
    // To look at a field and leave it is not to round it.
    window.get_by_label("Radius").click();
    window.run();
    window.key_press(Key::Enter);
    window.run();
    assert_eq!(radius(&window, 0), 9.4321);
}

#[test]
fn nonsense_is_refused_under_its_field_and_the_value_stays() {
    let mut window = first();
    let names = discs(&window);
    select(&mut window, &names[0]);
    let before = radius(&window, 0);
    for (text, complaint) in [
        ("abc", "“abc” is no number"),
        ("NaN", "“NaN” is no number"),
        ("1e999", "1e999 is too large"),
        ("", "Type a number"),
        ("5 ft", "“ft” is no unit here"),
        (
            "-3",
            "-3 is out of range; type a value from 0.001 to 1000000 mm",
        ),
    ] {
        enter(&mut window, "Radius", text);
        assert_eq!(radius(&window, 0), before, "{text}");
        assert!(told(&window, complaint), "{text}: {complaint}");
        let note = window.get_by_label_contains(complaint).rect();
        let field = window.get_by_label("Radius").rect();
        assert!(note.top() >= field.bottom() && note.top() - field.bottom() < 12.0);
    }
    // A good value takes the complaint away, and so does another selection.
    enter(&mut window, "Radius", "11");
    assert!(!told(&window, "out of range"));
    enter(&mut window, "Radius", "x");
    assert!(told(&window, "no number"));
    select(&mut window, &names[1]);
    select(&mut window, &names[0]);
    assert!(!told(&window, "no number"));
}

#[test]
fn an_obstacle_is_renamed_in_the_outline_and_in_the_inspector() {
    let mut window = first();
    let names = discs(&window);
    select(&mut window, &names[0]);
    window.key_press(Key::F2);
    window.run();
    window.key_press_modifiers(Modifiers::COMMAND, Key::A);
    window.run();
    window
        .get_by_label("Name of the obstacle")
        .type_text("post");
    window.run();
    window.key_press(Key::Enter);
    window.run();
    assert_eq!(scene(&window).obstacles[0].name.as_deref(), Some("post"));
    window.get_by_label("post");
    assert_eq!(bench(&window).selection, Selection::Obstacle(0));
    // Escape leaves the name as it was.
    window.key_press(Key::F2);
    window.run();
    window.get_by_label("Name of the obstacle").type_text("no");
    window.run();
    window.key_press(Key::Escape);
    window.run();
    assert_eq!(scene(&window).obstacles[0].name.as_deref(), Some("post"));
    assert_eq!(bench(&window).selection, Selection::Obstacle(0));
    // A name that is emptied leaves the shape's word and place.
    enter(&mut window, "Name", "");
    assert_eq!(scene(&window).obstacles[0].name, None);
    window.get_by_label("Disc 1");
}

#[test]
fn a_double_click_begins_a_name() {
    let mut window = first();
    let names = discs(&window);
    let at = window.get_by_label(&names[1]).rect().center();
    window.hover_at(at);
    window.run();
    // Both clicks in one frame: a test's frames are longer than a double click.
    for pressed in [true, false, true, false] {
        window.input_mut().events.push(Event::PointerButton {
            pos: at,
            button: PointerButton::Primary,
            pressed,
            modifiers: Modifiers::NONE,
        });
    }
    window.run();
    assert!(window.query_by_label("Name of the obstacle").is_some());
}

#[test]
fn arrow_keys_move_the_selection() {
    let mut window = first();
    select(&mut window, "Robot");
    assert_eq!(bench(&window).selection, Selection::Robot);
    for (key, expect) in [
        (Key::ArrowDown, Selection::Obstacle(0)),
        (Key::ArrowDown, Selection::Obstacle(1)),
        (Key::ArrowDown, Selection::Obstacle(1)),
        (Key::Home, Selection::Robot),
        (Key::End, Selection::Obstacle(1)),
        (Key::ArrowUp, Selection::Obstacle(0)),
    ] {
        window.key_press(key);
        window.run();
        assert_eq!(bench(&window).selection, expect, "{key:?}");
    }
    window.key_press(Key::Delete);
    window.run();
    assert_eq!(scene(&window).obstacles.len(), 1);
}

#[test]
fn obstacles_are_added_duplicated_and_deleted() {
    let mut window = window(Some(Scene::default()), [1280.0, 800.0], Theme::Light);
    assert!(told(&window, "Nothing stands around the robot"));
    select(&mut window, "Add a disc");
    assert_eq!(scene(&window).obstacles.len(), 1);
    assert_eq!(bench(&window).selection, Selection::Obstacle(0));
    for (item, expect) in [("Duplicate", 2), ("Delete", 1)] {
        window.get_by_label("Disc 1").click_secondary();
        window.run();
        let found: Vec<_> = window.query_all_by_label_contains(item).collect();
        found.last().unwrap().click();
        drop(found);
        window.run();
        assert_eq!(scene(&window).obstacles.len(), expect, "{item}");
    }
    select(&mut window, "Add an obstacle");
    select(&mut window, "Capsule");
    assert!(matches!(
        scene(&window).obstacles[1].shape,
        Shape::Capsule { .. }
    ));
    assert!(bench(&window).live.is_settled());
}

#[test]
fn disks_are_counted_spaced_and_kept_where_the_robot_is_cut_more_finely() {
    let mut window = window(None, [1280.0, 1600.0], Theme::Light);
    select(&mut window, "Robot");
    enter(&mut window, "Disks", "12");
    assert_eq!(scene(&window).robot.segments, 24);
    enter(&mut window, "Disks", "2.5");
    assert!(told(&window, "2.5 is not a whole number"));
    enter(&mut window, "Disk spacing", "16");
    let robot = &scene(&window).robot;
    assert_eq!((robot.length_mm, robot.segments), (192.0, 24));
    enter(&mut window, "Segments per bay", "3");
    let robot = &scene(&window).robot;
    assert_eq!((robot.segments, robot.segments_per_bay), (36, 3));
    assert!(told(&window, "Segments 36"));
    assert!(bench(&window).live.is_settled());
    select(&mut window, "Does it change with n?");
    window.run();
    assert!(told(&window, "With n = 72 the tip is"));
}

#[test]
fn what_another_field_forbids_is_told_under_that_field() {
    let mut window = first();
    select(&mut window, "Robot");
    enter(&mut window, "Disk radius", "9");
    assert_eq!(scene(&window).robot.disk_radius_mm, Some(9.0));
    enter(&mut window, "Cable offset", "9.5");
    assert_eq!(scene(&window).offset_mm(), 8.0, "taken back");
    let note = window
        .get_by_label_contains("Disk radius is 9 mm; set it to a value from the cable offset, 9.5")
        .rect();
    let field = window.get_by_label("Disk radius").rect();
    assert!(note.top() >= field.bottom() && note.top() - field.bottom() < 12.0);
    // A stiffness may be missing.
    enter(&mut window, "Stiffness", "31000");
    assert_eq!(scene(&window).robot.bending_stiffness_nmm2, Some(31000.0));
    enter(&mut window, "Stiffness", "0");
    assert!(told(&window, "0 is out of range"));
    enter(&mut window, "Stiffness", "");
    assert_eq!(scene(&window).robot.bending_stiffness_nmm2, None);
    // With the rim where the cable is, the offset is free again.
    select(&mut window, "Disk radius follows the cable offset");
    assert_eq!(scene(&window).robot.disk_radius_mm, None);
    enter(&mut window, "Cable offset", "9.5");
    assert_eq!(scene(&window).offset_mm(), 9.5);
    assert!(!told(&window, "Taken back"));
}

#[test]
fn an_obstacle_over_the_base_is_taken_back_with_its_reason() {
    let mut window = first();
    let names = discs(&window);
    select(&mut window, &names[0]);
    enter(&mut window, "Centre y", "0");
    let before = scene(&window).clone();
    enter(&mut window, "Centre x", "5");
    assert_eq!(*scene(&window), before);
    let reason = format!("{} covers the robot's base", names[0]);
    assert!(told(&window, &reason[1..]), "{reason}");
    assert!(bench(&window).live.is_settled());
}

#[test]
fn the_certificate_tells_the_numbers_of_the_solution() {
    let mut window = first();
    window.get_by_label("Status: Converged").click();
    window.run();
    let certificate = bench(&window).live.solution().unwrap().certificate;
    let number = |value| sinew::view::Quantity::significant(value, "").digits;
    for (name, condition) in [
        ("Stationarity", Condition::Stationarity),
        ("Links", Condition::Links),
        ("Penetration", Condition::Penetration),
        ("Complementarity", Condition::Complementarity),
        ("Dual feasibility", Condition::Dual),
    ] {
        let value = certificate.get(condition).unwrap();
        assert!(value <= Condition::BOUND);
        window.get_by_label(&format!("{name} {} ≤ 10⁻⁹", number(value)));
    }
    window.get_by_label("Orientation yes ");
    window.get_by_label("Minimum yes ");
    let count = bench(&window).live.solution().unwrap().trace.len();
    assert!(told(&window, &format!("Last solve, {count} iteration")));
    window.get_by_label("Status: Converged").click();
    window.run();
    assert!(!told(&window, "Stationarity"));
}

#[test]
fn cautions_stand_beside_the_certificate_with_what_helps() {
    let text = r#"
        version = 2
        model = { mechanics = "equal" }
        robot = { length_mm = 180, segments = 18, cable_offset_mm = 8 }
        actuation = { pull_mm = 6.3 }
        obstacle = [{ name = "Pin", shape = "disc", center_mm = [30, 105], radius_mm = 0.5 }]
    "#;
    let pin = Scene::from_toml(text).unwrap();
    let mut window = window(Some(pin), [1280.0, 800.0], Theme::Light);
    let caution = "Pin stands between backbone and cable below node 12";
    assert!(!told(&window, caution));
    select(&mut window, "Status: Converged");
    assert!(told(&window, caution));
    select(&mut window, "Let the whole body touch");
    assert_eq!(scene(&window).contact.candidates, Candidates::Body);
    assert!(!told(&window, caution));
    assert_eq!(bench(&window).live.solution().unwrap().contacts.len(), 1);
    assert!(bench(&window).live.cautions().is_empty());
    // A cable that would have to push has no such remedy.
    let scene = &mut window.state_mut().bench_mut().document.scene;
    scene.obstacles.clear();
    scene.set_pull_mm(-3.0);
    window.run();
    assert!(told(&window, "cable would have to push"));
    assert!(!told(&window, "Let the whole body touch"));
}

#[test]
fn a_branch_that_ends_is_told_with_its_reason() {
    let two_discs = Scene::from_toml(include_str!("../assets/scenes/two-discs.toml")).unwrap();
    let mut window = window(Some(two_discs), [1280.0, 800.0], Theme::Light);
    let work = window.state_mut().bench_mut();
    // The robot that leans on both discs slips off before this.
    work.document.scene.set_pull_mm(16.0);
    window.run();
    let solution = bench(&window).live.solution().unwrap();
    assert_eq!(solution.status.word(), "branch_ended");
    let reason = solution.status.reason();
    select(&mut window, "Status: Branch ended");
    assert!(told(&window, &reason[1..]), "{reason}");
}

/// A state has one name: over the canvas, in the chip, in the certificate and
/// in pictures.
#[test]
fn what_became_of_a_solve_has_one_name() {
    let wedge = include_str!("../assets/scenes/wedge.toml");
    let scene = Scene::from_toml(wedge).unwrap();
    let mut window = window(Some(scene), [1280.0, 800.0], Theme::Light);
    let work = window.state_mut().bench_mut();
    work.document.scene.set_pull_mm(12.0);
    window.run();
    let solution = bench(&window).live.solution().unwrap();
    assert_eq!(solution.status.word(), "infeasible");
    let name = outcome(solution);
    let Standing::Greyed { what, .. } = &bench(&window).live.drawing().standing else {
        panic!("it is believed");
    };
    assert_eq!(*what, name);
    select(&mut window, &format!("Status: {name}"));
    // Over the canvas and in the certificate.
    assert!(window.query_all_by_label(name).count() >= 2);
}

#[test]
fn nothing_moves_when_numbers_change() {
    let mut window = first();
    let places = |window: &Window| {
        let labels = ["Status: Converged", "Robot", "Pull", "Title"];
        let rects = labels.map(|label| {
            let all = window.query_all_by_label(label);
            all.map(|node| node.rect()).collect::<Vec<_>>()
        });
        let facts = window.query_all_by_label_contains("Tip ");
        (rects, facts.map(|node| node.rect()).collect::<Vec<_>>())
    };
    let before = places(&window);
    assert_eq!(before.1.len(), 2);
    for pull in [0.3, 12.345, 4.9] {
        window
            .state_mut()
            .bench_mut()
            .document
            .scene
            .set_pull_mm(pull);
        window.run();
        assert_eq!(places(&window), before, "{pull}");
    }
}

/// A table of a state, by itself.
fn table(
    of: impl Fn(&mut eframe::egui::Ui, &mut Workbench) + 'static,
    selection: Selection,
) -> Harness<'static, Workbench> {
    let scene = Scene::from_toml(include_str!("../assets/scenes/two-discs.toml")).unwrap();
    let document = sinew::app::Document::new(scene).unwrap();
    let backend = Box::new(Inline::to_the_end());
    let mut bench = Workbench::new(document, backend, Preferences::default());
    bench.poll();
    bench.selection = selection;
    let mut harness = Harness::builder()
        .with_size(vec2(820.0, 160.0))
        .with_pixels_per_point(1.0)
        .with_context_setup(sinew::app::look::install)
        .wgpu()
        .build_ui_state(move |ui, bench| of(ui, bench), bench);
    harness.run();
    harness
}

#[test]
fn the_contacts_table_selects_and_tells_forces_where_they_are_known() {
    let with_forces = |ui: &mut eframe::egui::Ui, bench: &mut Workbench| {
        let stiffness = Stiffness::new(1e-3).unwrap();
        let solution = bench.live.solution().unwrap();
        let forces = Statics::of(solution, stiffness);
        tables::contacts(ui, bench, Some(&forces));
    };
    let mut table = table(with_forces, Selection::Nothing);
    table.get_by_label("Force, g");
    let rows: Vec<_> = table.query_all_by_label_contains(" presses on ").collect();
    assert_eq!(rows.len(), 2);
    rows[1].click();
    drop(rows);
    table.run();
    let obstacle = table.state().live.solution().unwrap().contacts[1].obstacle;
    assert_eq!(table.state().selection, Selection::Obstacle(obstacle));
}

#[test]
fn without_a_stiffness_there_is_no_column_of_forces() {
    let table = table(
        |ui, bench| tables::contacts(ui, bench, None),
        Selection::Nothing,
    );
    assert!(table.query_by_label("Force, N").is_none());
    let multiplier = table.state().live.solution().unwrap().contacts[0].multiplier;
    let digits = sinew::view::Quantity::significant(1e-3 * multiplier, "").digits;
    assert!(
        table.query_all_by_label(&digits).next().is_some(),
        "{digits}"
    );
}

#[test]
fn the_obstacles_table_selects() {
    let mut table = table(tables::obstacles, Selection::Nothing);
    let name = table.state().document.scene.obstacles[1]
        .name
        .clone()
        .unwrap();
    let rows: Vec<_> = table.query_all_by_label(&name).collect();
    rows[0].click();
    drop(rows);
    table.run();
    assert_eq!(table.state().selection, Selection::Obstacle(1));
    assert_eq!(table.query_all_by_label("presses").count(), 2);
}

/// Pictures to look at: `SINEW_PICTURES=folder cargo test --test panels`.
#[test]
fn pictures() {
    let Some(folder) = std::env::var_os("SINEW_PICTURES") else {
        return;
    };
    let folder = std::path::PathBuf::from(folder);
    let shapes = Scene::from_toml(include_str!("../assets/scenes/shapes.toml")).unwrap();
    for (theme, name) in [(Theme::Light, "light"), (Theme::Dark, "dark")] {
        for size in [[1280.0, 800.0], [1440.0, 900.0]] {
            let save = |window: &mut Window, what: &str| {
                let file = folder.join(format!("{what}-{name}-{}.png", size[0]));
                window.render().unwrap().save(file).unwrap();
            };
            let mut window = window_with(None, size, theme, true);
            save(&mut window, "summary");
            select(&mut window, "Robot");
            enter(&mut window, "Length", "abc");
            save(&mut window, "robot");
            select(&mut window, "Status: Converged");
            save(&mut window, "certificate");
            let mut window = self::window(Some(shapes.clone()), size, theme);
            select(&mut window, "wedge");
            save(&mut window, "polygon");
            select(&mut window, "block");
            save(&mut window, "box");
        }
    }
    let mut window = window(None, [1024.0, 1400.0], Theme::Light);
    window
        .state_mut()
        .bench_mut()
        .document
        .scene
        .set_pull_mm(16.0);
    window.run();
    select(&mut window, "Status: Branch ended");
    let file = folder.join("certificate-tall.png");
    window.render().unwrap().save(file).unwrap();
    let mut table = table(
        |ui, bench| tables::contacts(ui, bench, None),
        Selection::Obstacle(0),
    );
    table
        .render()
        .unwrap()
        .save(folder.join("contacts.png"))
        .unwrap();
    let mut table = self::table(tables::obstacles, Selection::Nothing);
    table
        .render()
        .unwrap()
        .save(folder.join("obstacles.png"))
        .unwrap();
}

#[test]
fn the_obstacles_table_is_edited_in_place() {
    let mut table = table(tables::obstacles, Selection::Nothing);
    let mut write = |label: &str, text: &str| {
        table.get_by_label(label).click();
        table.run();
        table.key_press_modifiers(Modifiers::COMMAND, Key::A);
        table.event(Event::Text(text.to_owned()));
        table.key_press(Key::Enter);
        table.run();
        let scene = &table.state().document.scene;
        (scene.obstacles[1].shape.clone(), table.state().selection)
    };
    let disc = |center_mm, radius_mm| Shape::Disc {
        center_mm,
        radius_mm,
    };
    let selected = Selection::Obstacle(1);
    let (shape, selection) = write("x of upper", "61.5");
    assert_eq!((shape, selection), (disc([61.5, 140.0], 15.0), selected));
    let (shape, _) = write("y of upper", "14 cm");
    assert_eq!(shape, disc([61.5, 140.0], 15.0));
    let (shape, _) = write("Radius of upper", "12");
    assert_eq!(shape, disc([61.5, 140.0], 12.0));
    let (shape, _) = write("Radius of upper", "-3");
    assert_eq!(shape, disc([61.5, 140.0], 12.0));
}
