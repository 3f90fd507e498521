//! Files, and everything that guards work: opening, saving, dropping, pasting,
//! restoring, and the sheets over the window, worked as a person would.

mod desk;

use desk::{Desk, Storage};
use eframe::App as _;
use eframe::egui::{
    Event, Key, Modifiers, OutputCommand, Theme, ViewportCommand, ViewportEvent, ViewportId, vec2,
};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable;
use egui_tiles::Tile;
use sinew::app::backend::Inline;
use sinew::app::dock::{Arrangement, Dock};
use sinew::app::window::stored::Stored;
use sinew::app::{Command, Preferences, Selection, Sinew, Views, Workbench};
use sinew::scene::{Candidates, Scene};
use std::path::Path;

type Window = Harness<'static, Sinew>;

const SIZE: [f32; 2] = [1280.0, 800.0];

fn window_with(desk: &Desk, stored: Stored, size: [f32; 2], theme: Theme) -> Window {
    let desk = desk.clone();
    let mut stored = stored;
    stored.preferences.theme = theme.into();
    let mut window = Harness::builder()
        .with_size(vec2(size[0], size[1]))
        .with_pixels_per_point(1.0)
        .with_theme(theme)
        .with_max_steps(400)
        .wgpu()
        .build_eframe(move |cc| {
            let backend = Box::new(Inline::to_the_end());
            let window = Sinew::new(&cc.egui_ctx, None, backend, Preferences::default());
            window.unwrap().on(Box::new(desk), stored)
        });
    window.run();
    window
}

/// A window on the first example with a desk around it.
fn window(desk: &Desk) -> Window {
    window_with(desk, Stored::default(), SIZE, Theme::Light)
}

fn bench(window: &Window) -> &Workbench {
    window.state().bench()
}

fn scene(window: &Window) -> &Scene {
    &bench(window).document.scene
}

fn pull(window: &mut Window, pull_mm: f64) {
    let scene = &mut window.state_mut().bench_mut().document.scene;
    scene.set_pull_mm(pull_mm);
    window.run();
}

#[test]
fn a_path_is_typed_where_the_system_has_no_dialog() {
    let desk = Desk::default();
    desk.put(
        "/home/free.toml",
        include_str!("../assets/scenes/free.toml"),
    );
    desk.lose_dialogs();
    let mut window = window(&desk);
    ctrl(&mut window, Key::O);
    let field = window.get_by_label("Path");
    field.type_text("free.toml");
    window.run();
    window.key_press(Key::Enter);
    window.run();
    assert_eq!(scene(&window).title.as_deref(), Some("Free (Fig. 3b)"));
    assert!(!window.state().is_covered());
    // To be saved elsewhere: the name is offered, and Escape gives it up.
    ctrl_shift(&mut window, Key::S);
    window.get_by_label("Path");
    window.key_press(Key::Escape);
    window.run();
    assert!(!window.state().is_covered() && !bench(&window).files.is_asking());
    ctrl_shift(&mut window, Key::S);
    window.get_by_label("Save").click();
    window.run();
    assert!(desk.text("/home/free.toml").contains("Free (Fig. 3b)"));
    assert!(!bench(&window).files.is_asking());
}

/// A change that cost work.
fn edit(window: &mut Window) {
    let scene = &mut window.state_mut().bench_mut().document.scene;
    let title = scene.title.clone().unwrap_or_default();
    scene.title = Some(format!("{title} edited"));
    window.run();
}

fn ctrl(window: &mut Window, key: Key) {
    window.key_press_modifiers(Modifiers::COMMAND, key);
    window.run();
}

fn ctrl_shift(window: &mut Window, key: Key) {
    window.key_press_modifiers(Modifiers::COMMAND | Modifiers::SHIFT, key);
    window.run();
}

fn press(window: &mut Window, label: &str) {
    window.get_by_label(label).click();
    window.run();
}

fn says(window: &Window, text: &str) -> bool {
    window.query_all_by_label_contains(text).next().is_some()
}

fn drop_on(window: &mut Window, desk: &Desk, path: &str) {
    window.input_mut().dropped_files.push(desk.dropped(path));
    window.run();
}

/// The titles that the system was told.
fn commands(window: &Window) -> Vec<ViewportCommand> {
    let outputs = window.output().viewport_output.values();
    outputs.flat_map(|output| output.commands.clone()).collect()
}

fn arrangement(window: &Window) -> &Arrangement {
    window.state().dock().arrangement()
}

fn stored_by(window: &mut Window) -> Storage {
    let mut storage = Storage::default();
    window.state_mut().save(&mut storage);
    storage
}

#[test]
fn a_saved_scene_is_reopened_as_it_was() {
    let desk = Desk::default();
    let mut window = window(&desk);
    pull(&mut window, 3.25);
    assert!(bench(&window).document.is_changed());
    let saved = scene(&window).clone();
    desk.answer(Some("/home/a/first.toml"));
    ctrl(&mut window, Key::S);
    assert_eq!(desk.offered(), ["two-posts.toml"]);
    assert!(!bench(&window).document.is_changed());
    assert!(says(&window, "Saved first.toml"));
    // Saved again without a question.
    pull(&mut window, 3.5);
    ctrl(&mut window, Key::S);
    assert!(desk.text("/home/a/first.toml").contains("pull_mm = 3.5"));
    pull(&mut window, 3.25);
    ctrl(&mut window, Key::S);
    ctrl(&mut window, Key::N);
    assert_ne!(*scene(&window), saved);
    desk.answer(Some("/home/a/first.toml"));
    ctrl(&mut window, Key::O);
    assert_eq!(*scene(&window), saved);
    let file = bench(&window).document.file.as_deref();
    assert_eq!(file, Some(Path::new("/home/a/first.toml")));
    assert_eq!(
        bench(&window).files.recent,
        [Path::new("/home/a/first.toml")]
    );
    // Undo does not lead to another scene under this file's name.
    ctrl(&mut window, Key::Z);
    assert_eq!(*scene(&window), saved);
}

#[test]
fn a_broken_file_is_told_fault_by_fault_and_changes_nothing() {
    let desk = Desk::default();
    let broken = "version = 2\n[robot]\nlength_mm = -180\nsegments = 0\ncable_offset_mm = 8\n\
                  [actuation]\npull_mm = 5\n";
    desk.put("/home/a/broken.toml", broken);
    desk.put("/home/a/text.toml", "version = 1\n[robot");
    desk.put("/home/a/large.toml", vec![b' '; 5 << 20]);
    let mut window = window(&desk);
    pull(&mut window, 3.0);
    let before = scene(&window).clone();
    let mut check = |path: &str, parts: &[&str]| {
        drop_on(&mut window, &desk, path);
        for part in parts {
            assert!(says(&window, part), "{path}: {part}");
        }
        press(&mut window, "Close");
        assert!(!says(&window, parts[0]));
        assert_eq!(*scene(&window), before);
    };
    check(
        "/home/a/broken.toml",
        &[
            "broken.toml cannot be opened",
            "2 faults",
            "length_mm is -180",
            "segments is 0",
        ],
    );
    check(
        "/home/a/text.toml",
        &["text.toml cannot be opened", "ine 2, column"],
    );
    check(
        "/home/a/large.toml",
        &["large.toml cannot be opened", "5.0 MB"],
    );
    // A way out: another file.
    drop_on(&mut window, &desk, "/home/a/text.toml");
    desk.answer(None);
    press(&mut window, "Open another …");
    assert_eq!(*scene(&window), before);
}

#[test]
fn unsaved_work_is_guarded() {
    let desk = Desk::default();
    let mut window = window(&desk);
    let first = scene(&window).clone();
    // Nothing is asked where nothing would be lost.
    ctrl(&mut window, Key::N);
    let empty = scene(&window).clone();
    assert!(empty.obstacles.is_empty());
    // Whatever is put beside the robot keeps all of it out.
    assert_eq!(empty.contact.candidates, Candidates::Body);
    ctrl(&mut window, Key::Z);
    assert_eq!(*scene(&window), first);
    // The scene that was undone to differs from what is open: it is guarded.
    let question = "Save the changes to";
    ctrl(&mut window, Key::N);
    assert!(says(&window, question));
    press(&mut window, "Cancel");
    assert_eq!(*scene(&window), first);
    ctrl(&mut window, Key::N);
    window.key_press(Key::Escape);
    window.run();
    assert!(!says(&window, question));
    assert_eq!(*scene(&window), first);
    // Saving that is given up gives the rest up, too.
    ctrl(&mut window, Key::N);
    desk.answer(None);
    press(&mut window, "Save");
    assert_eq!(*scene(&window), first);
    assert!(bench(&window).document.is_changed());
    ctrl(&mut window, Key::N);
    desk.answer(Some("/home/a/kept.toml"));
    press(&mut window, "Save");
    assert_eq!(
        Scene::from_toml(&desk.text("/home/a/kept.toml")).unwrap(),
        first
    );
    assert_eq!(*scene(&window), empty);
    edit(&mut window);
    ctrl(&mut window, Key::N);
    press(&mut window, "Discard");
    assert_eq!(*scene(&window), empty);
    // To pull the cable of what is kept nowhere is not work.
    pull(&mut window, 2.0);
    ctrl(&mut window, Key::N);
    assert_eq!(*scene(&window), empty);
}

#[test]
fn a_window_with_unsaved_work_asks_before_it_closes() {
    let desk = Desk::default();
    let mut window = window(&desk);
    let close = |window: &mut Window| {
        let root = window
            .input_mut()
            .viewports
            .entry(ViewportId::ROOT)
            .or_default();
        root.events.push(ViewportEvent::Close);
        window.step();
        let commands = commands(window);
        let root = window
            .input_mut()
            .viewports
            .entry(ViewportId::ROOT)
            .or_default();
        root.events.clear();
        commands.contains(&ViewportCommand::CancelClose)
    };
    assert!(!close(&mut window), "nothing is unsaved");
    let mut window = self::window(&desk);
    edit(&mut window);
    assert!(close(&mut window));
    window.run();
    assert!(says(&window, "before the window closes"));
    window.get_by_label("Discard").click();
    let mut closed = false;
    for _ in 0..4 {
        window.step();
        closed |= commands(&window).contains(&ViewportCommand::Close);
    }
    assert!(closed);
    assert!(!close(&mut window), "it was decided");
}

#[test]
fn a_crash_loses_nothing() {
    let desk = Desk::default();
    let mut window = window(&desk);
    pull(&mut window, 3.75);
    let lost = scene(&window).clone();
    drop(window);
    // The next window goes on as usual and offers what was lost.
    let mut window = self::window(&desk);
    assert_ne!(*scene(&window), lost);
    assert!(says(&window, "was not saved"));
    // As long as nobody decides, it is kept: also by whoever would lose
    // something and thinks better of it.
    edit(&mut window);
    press(&mut window, "Restore");
    assert!(says(&window, "Save the changes to"));
    press(&mut window, "Cancel");
    assert!(says(&window, "was not saved"));
    ctrl(&mut window, Key::Z);
    drop(window);
    let mut window = self::window(&desk);
    press(&mut window, "Restore");
    assert_eq!(*scene(&window), lost);
    assert!(bench(&window).document.is_changed());
    assert!(!says(&window, "was not saved"));
    // Until it is saved, this window may crash, too.
    drop(window);
    let mut window = self::window(&desk);
    press(&mut window, "Discard");
    assert!(!says(&window, "was not saved"));
    // Whoever saves or discards it is not asked again.
    drop(window);
    assert!(!says(&self::window(&desk), "was not saved"));
}

#[test]
fn files_and_lost_work_of_version_1_open_and_are_saved_as_version_2() {
    let desk = Desk::default();
    let old = include_str!("cases/version-1/grip.toml");
    desk.put("/home/a/old.toml", old);
    let left = toml::Table::from_iter([
        ("name".to_owned(), "Old".into()),
        ("scene".to_owned(), old.into()),
    ]);
    desk.leave(&toml::to_string(&left).unwrap());
    let mut window = window(&desk);
    assert!(says(&window, "Old was not saved"));
    press(&mut window, "Restore");
    let successor = Scene::from_toml(include_str!("../assets/scenes/grip.toml")).unwrap();
    assert_eq!(*scene(&window), successor);
    desk.answer(Some("/home/a/restored.toml"));
    ctrl(&mut window, Key::S);
    assert!(
        desk.text("/home/a/restored.toml")
            .starts_with("version = 2\n")
    );

    drop_on(&mut window, &desk, "/home/a/old.toml");
    assert_eq!(*scene(&window), successor);
    assert!(!bench(&window).document.is_changed());
    pull(&mut window, 3.25);
    ctrl(&mut window, Key::S);
    let saved = desk.text("/home/a/old.toml");
    assert!(saved.starts_with("version = 2\n"), "{saved}");
    assert!(
        saved.contains("\n[model]\nmechanics = \"equal\"\n"),
        "{saved}"
    );
    assert!(saved.contains("pull_mm = 3.25"), "{saved}");
}

#[test]
fn two_windows_that_crash_lose_nothing() {
    let desk = Desk::default();
    let mut windows = [window(&desk), window(&desk)];
    for (index, pull_mm) in [(0, 1.25), (1, 2.25), (0, 3.25)] {
        let window = &mut windows[index];
        pull(window, pull_mm);
        // What another window has open is not offered.
        assert!(!says(window, "was not saved"));
    }
    let lost = [scene(&windows[0]).clone(), scene(&windows[1]).clone()];
    drop(windows);
    let mut third = window(&desk);
    for scene in lost {
        press(&mut third, "Restore");
        assert_eq!(*self::scene(&third), scene);
        // Nothing is to be guarded before the next one.
        let at = Some("/home/a/restored.toml");
        desk.answer(at);
        ctrl(&mut third, Key::S);
    }
    assert!(!says(&third, "was not saved"));
}

/// A dialog may stay open while another scene is opened.
#[test]
fn what_is_chosen_for_one_scene_is_not_done_to_the_next() {
    let desk = Desk::default();
    let mut window = window(&desk);
    pull(&mut window, 3.75);
    let first = scene(&window).clone();
    let other = Scene::default().to_toml().unwrap();
    desk.put("/home/a/other.toml", other.clone());
    desk.take_its_time();
    ctrl_shift(&mut window, Key::S);
    drop_on(&mut window, &desk, "/home/a/other.toml");
    assert_eq!(*scene(&window), Scene::default());
    desk.answer_now("/home/a/first.toml");
    window.run();
    assert!(says(&window, "Saved first.toml"));
    let saved = Scene::from_toml(&desk.text("/home/a/first.toml")).unwrap();
    assert_eq!(saved, first);
    // The other one has its own name, and saving it changes its own file.
    let file = bench(&window).document.file.as_deref();
    assert_eq!(file, Some(Path::new("/home/a/other.toml")));
    pull(&mut window, 1.5);
    assert!(bench(&window).document.is_changed());
    ctrl(&mut window, Key::S);
    let saved = Scene::from_toml(&desk.text("/home/a/first.toml")).unwrap();
    assert_eq!(saved, first);
    assert!(desk.text("/home/a/other.toml").contains("pull_mm = 1.5"));

    // The same with what is brought into a scene.
    desk.put("/home/a/measured.csv", "x_mm,y_mm\n0,0\n0,60\n2,120\n");
    desk.put("/home/a/robot.png", png(64, 48));
    for (command, path) in [
        (Command::ImportMeasurements, "/home/a/measured.csv"),
        (Command::PlacePhoto, "/home/a/robot.png"),
    ] {
        window.state_mut().bench_mut().commands.push(command);
        window.run();
        drop_on(&mut window, &desk, "/home/a/first.toml");
        desk.answer_now(path);
        window.run();
        assert_eq!(*scene(&window), first);
        let name = path.strip_prefix("/home/a/").unwrap();
        let told = format!("{name} was chosen for the scene before this one");
        assert!(says(&window, &told));
    }
}

/// A picture that comes by itself closes no dialog.
#[test]
fn a_dialog_stays_the_only_one_until_it_is_answered() {
    let desk = Desk::default();
    desk.put("/home/a/robot.png", png(64, 48));
    let mut window = window(&desk);
    drop_on(&mut window, &desk, "/home/a/robot.png");
    desk.answer(Some("/home/a/first.toml"));
    ctrl(&mut window, Key::S);
    desk.take_its_time();
    ctrl_shift(&mut window, Key::S);
    // Its photograph is read again.
    drop_on(&mut window, &desk, "/home/a/first.toml");
    ctrl(&mut window, Key::O);
    assert_eq!(desk.open_dialogs(), 1);
    desk.answer_now("/home/a/second.toml");
    window.run();
    ctrl(&mut window, Key::O);
    assert_eq!(desk.open_dialogs(), 1);
}

#[test]
fn stored_nonsense_is_told_and_left_out() {
    let mut storage = Storage::default();
    storage
        .0
        .insert("preferences".to_owned(), "(zoom: \"large\")".to_owned());
    storage
        .0
        .insert("recent".to_owned(), "[\"/home/a/b.toml\"]".to_owned());
    let stored = Stored::of(Some(&storage));
    assert_eq!(stored.lost, ["your settings"]);
    assert_eq!(stored.recent, [Path::new("/home/a/b.toml")]);
    let desk = Desk::default();
    desk.leave("name = \"x\"\nscene = \"no\"\n");
    desk.leave("(torn");
    let mut window = window_with(&desk, stored, SIZE, Theme::Light);
    assert!(says(&window, "your settings cannot be read"));
    let before = scene(&window).clone();
    for name in ["A scene", "x"] {
        assert!(says(&window, &format!("{name} was not saved")));
        press(&mut window, "Restore");
        assert_eq!(*scene(&window), before);
        // Only whoever is asked throws it away.
        press(&mut window, "Discard");
    }
    assert!(!says(&window, "was not saved"));
}

#[test]
fn choices_outlive_the_window() {
    let desk = Desk::default();
    let mut window = window(&desk);
    ctrl(&mut window, Key::Plus);
    ctrl(&mut window, Key::Plus);
    window.key_press(Key::G);
    window.run();
    assert_eq!(bench(&window).preferences.zoom, 1.25);
    let stored = Stored::of(Some(&stored_by(&mut window)));
    assert_eq!(stored.preferences, bench(&window).preferences);
    assert!(!stored.preferences.grid);
    for _ in 0..20 {
        ctrl(&mut window, Key::Plus);
    }
    assert_eq!(bench(&window).preferences.zoom, Preferences::ZOOMS.1);
    ctrl(&mut window, Key::Num0);
    assert_eq!(bench(&window).preferences.zoom, 1.0);
}

#[test]
fn the_plots_stay_where_they_were_put() {
    let desk = Desk::default();
    let mut earlier = window(&desk);
    earlier.key_press(Key::A);
    earlier.run();
    let spread = arrangement(&earlier).clone();
    let stored = Stored::of(Some(&stored_by(&mut earlier)));
    let mut later = window_with(&desk, stored, SIZE, Theme::Light);
    assert_eq!(*arrangement(&later), spread);
    // All five plots are shown, where the tabs show three at a time.
    for plot in ["Force against load", "Energy over the pull"] {
        assert!(later.query_by_label_contains(plot).is_some(), "{plot}");
    }
    let commands = &mut later.state_mut().bench_mut().commands;
    commands.push(Command::GroupPlots);
    later.run();
    assert_ne!(*arrangement(&later), spread);
    assert_eq!(*arrangement(&later), *arrangement(&window(&desk)));

    // Panes that are missing would never be seen again.
    let mut dock = Dock::default();
    let mut poor = spread.clone();
    let pane = poor
        .tiles
        .tile_ids()
        .find(|id| matches!(poor.tiles.get(*id), Some(Tile::Pane(_))));
    poor.tiles.remove(pane.unwrap());
    dock.arrange(poor);
    assert_eq!(dock.arrangement(), Dock::default().arrangement());
}

#[test]
fn the_palette_runs_commands_and_opens_examples() {
    let desk = Desk::default();
    let mut window = window(&desk);
    let type_text = |window: &mut Window, text: &str| {
        window.event(Event::Text(text.to_owned()));
        window.run();
    };
    ctrl(&mut window, Key::K);
    type_text(&mut window, "grid");
    window.key_press(Key::Enter);
    window.run();
    assert!(!bench(&window).preferences.grid);
    assert!(!window.state().is_covered());
    // Arrows go on to the next line; letters are not shortcuts meanwhile.
    ctrl_shift(&mut window, Key::P);
    type_text(&mut window, "view");
    type_text(&mut window, "zzz");
    assert!(says(&window, "Nothing is called that."));
    window.key_press(Key::Escape);
    window.run();
    assert!(!window.state().is_covered());
    assert_eq!(bench(&window).preferences.views, Views::Plane);
    ctrl(&mut window, Key::K);
    type_text(&mut window, "exone disc");
    window.key_press(Key::Enter);
    window.run();
    assert_eq!(scene(&window).title.as_deref(), Some("One disc (Fig. 4a)"));
    // A command that would do nothing is not run, and the palette stays.
    ctrl(&mut window, Key::K);
    type_text(&mut window, "duplicate");
    window.key_press(Key::Enter);
    window.run();
    assert!(window.state().is_covered());
}

#[test]
fn a_measured_backbone_is_dropped_compared_and_fitted() {
    let desk = Desk::default();
    let mut window = window(&desk);
    let solution = bench(&window).live.solution().unwrap();
    let rows = solution
        .backbone()
        .map(|point| format!("{},{}", 1e3 * point.x, 1e3 * point.y));
    let table = format!("x_mm,y_mm\n{}\n", rows.collect::<Vec<_>>().join("\n"));
    desk.put("/home/a/measured.csv", table);
    desk.put("/home/a/inches.csv", "x_mm,y_mm\n0,0\n0,600\n0,7000\n");
    desk.put("/home/a/forces.csv", "load_g,force_g\n100,6\n200,12.5\n");
    let measured_at = scene(&window).pull_mm();
    drop_on(&mut window, &desk, "/home/a/measured.csv");
    assert!(says(
        &window,
        "Imported 19 points of a backbone from measured.csv"
    ));
    assert_eq!(bench(&window).selection, Selection::Measured);
    assert!(says(&window, "0.00 mm"));
    pull(&mut window, 4.0);
    press(&mut window, "Find the best pull");
    assert!(says(&window, "Best pull 5.55 mm"));
    press(&mut window, "Apply");
    assert!((scene(&window).pull_mm() - measured_at).abs() < 1e-3);
    let before = scene(&window).clone();
    drop_on(&mut window, &desk, "/home/a/inches.csv");
    assert!(says(&window, "inches.csv cannot be imported") && says(&window, "Row 3"));
    press(&mut window, "Close");
    assert_eq!(*scene(&window), before);
    drop_on(&mut window, &desk, "/home/a/forces.csv");
    let measured = scene(&window).measured.as_ref().unwrap();
    assert_eq!((measured.points_mm.len(), measured.forces.len()), (19, 2));
    // Delete takes it away; undo brings it back.
    window.key_press(Key::Delete);
    window.run();
    assert!(scene(&window).measured.is_none());
    ctrl(&mut window, Key::Z);
    assert!(scene(&window).measured.is_some());
}

fn png(width: u32, height: u32) -> Vec<u8> {
    let picture = image::RgbaImage::from_fn(width, height, |x, y| {
        let shade = if (x / 32 + y / 32) % 2 == 0 { 220 } else { 150 };
        image::Rgba([shade, shade, shade.saturating_sub(30), 255])
    });
    let mut bytes = std::io::Cursor::new(Vec::new());
    picture
        .write_to(&mut bytes, image::ImageFormat::Png)
        .unwrap();
    bytes.into_inner()
}

#[test]
fn a_photograph_is_dropped_kept_beside_the_scene_and_found_again() {
    let desk = Desk::default();
    desk.put("/home/a/pictures/robot.png", png(640, 480));
    let mut window = window(&desk);
    drop_on(&mut window, &desk, "/home/a/pictures/robot.png");
    let photo = scene(&window).photo.clone().unwrap();
    assert_eq!(photo.file, "/home/a/pictures/robot.png");
    assert_eq!(bench(&window).selection, Selection::Photo);
    assert!(says(&window, "robot.png, 640 × 480 pixels"));
    desk.answer(Some("/home/a/scene.toml"));
    ctrl(&mut window, Key::S);
    let text = desk.text("/home/a/scene.toml");
    assert!(text.contains("\"pictures/robot.png\""), "{text}");
    assert!(!bench(&window).document.is_changed());
    // Both have moved together.
    desk.put("/mnt/scene.toml", text);
    desk.put("/mnt/pictures/robot.png", png(640, 480));
    desk.remove("/home/a/pictures/robot.png");
    drop_on(&mut window, &desk, "/mnt/scene.toml");
    assert_eq!(bench(&window).selection, Selection::Nothing);
    assert_eq!(
        scene(&window).photo.as_ref().unwrap().file,
        "/mnt/pictures/robot.png"
    );
    press(&mut window, "Photograph");
    assert!(says(&window, "robot.png, 640 × 480 pixels"));
    // Without the picture the scene opens all the same, and says so.
    drop_on(&mut window, &desk, "/home/a/scene.toml");
    press(&mut window, "Photograph");
    assert!(says(
        &window,
        "robot.png is not shown. It is not there any more."
    ));
    let place = scene(&window).photo.clone().unwrap();
    desk.answer(Some("/mnt/pictures/robot.png"));
    press(&mut window, "Choose the picture …");
    let found = scene(&window).photo.clone().unwrap();
    assert_eq!(found.file, "/mnt/pictures/robot.png");
    assert_eq!(
        (found.center_mm, found.width_mm),
        (place.center_mm, place.width_mm)
    );
}

#[test]
fn a_huge_or_strange_picture_is_refused_with_its_numbers() {
    let desk = Desk::default();
    desk.put("/home/a/wide.png", png(9000, 1));
    desk.put("/home/a/large.jpg", vec![0; 65 << 20]);
    desk.put("/home/a/cat.png", "not a picture");
    desk.put("/home/a/notes.pdf", "%PDF");
    let mut window = window(&desk);
    let before = scene(&window).clone();
    let mut check = |path: &str, parts: [&str; 2]| {
        drop_on(&mut window, &desk, path);
        for part in parts {
            assert!(says(&window, part), "{path}: {part}");
        }
        press(&mut window, "Close");
        assert_eq!(*scene(&window), before);
    };
    check("/home/a/wide.png", ["wide.png cannot", "9000 × 1 pixels"]);
    check("/home/a/large.jpg", ["large.jpg cannot", "65.0 MB"]);
    check(
        "/home/a/cat.png",
        ["cat.png cannot", "neither a PNG nor a JPEG"],
    );
    drop_on(&mut window, &desk, "/home/a/notes.pdf");
    assert!(says(&window, "notes.pdf cannot be used here"));
    // Errors stay until they are dismissed.
    press(&mut window, "Dismiss");
    assert!(!says(&window, "notes.pdf"));
}

#[test]
fn two_points_give_a_photograph_its_scale() {
    let desk = Desk::default();
    desk.put("/home/a/robot.png", png(400, 300));
    let mut window = window(&desk);
    drop_on(&mut window, &desk, "/home/a/robot.png");
    let before = scene(&window).photo.clone().unwrap();
    press(&mut window, "Scale by two points");
    assert!(says(&window, "Click a first point"));
    let canvas = window.get_by_label_contains("Robot and obstacles").rect();
    for shift in [-60.0, 60.0] {
        let at = canvas.center() + vec2(shift, 0.0);
        window.hover_at(at);
        window.run();
        window.drag_at(at);
        window.run();
        window.drop_at(at);
        window.run();
    }
    assert!(says(&window, "Type how far apart they are."));
    let scaling = window
        .state_mut()
        .bench_mut()
        .photos
        .scaling
        .as_mut()
        .unwrap();
    scaling.distance_mm *= 2.0;
    window.run();
    press(&mut window, "Apply");
    let after = scene(&window).photo.clone().unwrap();
    assert!((after.width_mm / before.width_mm - 2.0).abs() < 1e-9);
}

#[test]
fn a_link_holds_the_whole_scene() {
    let desk = Desk::default();
    let mut window = window(&desk);
    pull(&mut window, 3.125);
    let sent = scene(&window).clone();
    // Into one frame, whose output is looked at.
    let modifiers = Modifiers::COMMAND | Modifiers::SHIFT;
    let events = &mut window.input_mut().events;
    events.push(Event::ModifiersChanged(modifiers));
    events.push(Event::Key {
        key: Key::C,
        physical_key: None,
        pressed: true,
        repeat: false,
        modifiers,
    });
    events.push(Event::ModifiersChanged(Modifiers::NONE));
    window.step();
    let copied = &window.output().platform_output.commands;
    let link = copied.iter().find_map(|command| match command {
        OutputCommand::CopyText(text) => Some(text.clone()),
        _ => None,
    });
    let link = link.unwrap();
    assert!(link.starts_with("sinew:#s1."), "{link}");
    let mut other = self::window(&desk);
    other.event(Event::Paste(link.clone()));
    other.run();
    assert_eq!(*scene(&other), sent);
    // Over unsaved work it asks first.
    edit(&mut other);
    other.event(Event::Paste(link));
    other.run();
    press(&mut other, "Discard");
    assert_eq!(*scene(&other), sent);
    // A scene's text opens, too; anything else says what it is not.
    other.event(Event::Paste(Scene::default().to_toml().unwrap()));
    other.run();
    assert_eq!(*scene(&other), Scene::default());
    other.event(Event::Paste("hello".to_owned()));
    other.run();
    assert!(says(&other, "This is no link to a scene"));
}

#[test]
fn examples_open_from_cards_with_real_drawings() {
    let desk = Desk::default();
    let mut window = window(&desk);
    ctrl(&mut window, Key::E);
    assert!(says(&window, "The paper"));
    window.get_by_label_contains("Free (Fig. 3b).").click();
    window.run();
    assert_eq!(scene(&window).title.as_deref(), Some("Free (Fig. 3b)"));
    assert!(!window.state().is_covered());
    // By keyboard: the first card has the focus.
    ctrl(&mut window, Key::E);
    let first = window.get_by_label_contains("Two posts.");
    assert!(first.is_focused());
    window.key_press(Key::Enter);
    window.run();
    assert_eq!(scene(&window).title.as_deref(), Some("Two posts"));
    // Over unsaved work it asks, and giving up leads back to the cards.
    pull(&mut window, 2.0);
    edit(&mut window);
    ctrl(&mut window, Key::E);
    window.get_by_label_contains("Free (Fig. 3b).").click();
    window.run();
    assert!(says(&window, "Save the changes to"));
    press(&mut window, "Cancel");
    assert!(window.state().is_covered());
    assert_eq!(scene(&window).pull_mm(), 2.0);
}

#[test]
fn what_cannot_be_written_is_told_and_the_work_stays() {
    let desk = Desk::default();
    let mut window = window(&desk);
    pull(&mut window, 2.0);
    desk.fill_up();
    desk.answer(Some("/full/a.toml"));
    ctrl(&mut window, Key::S);
    assert!(says(&window, "a.toml is not saved") && says(&window, "The disk is full."));
    assert!(bench(&window).document.is_changed());
    assert_eq!(bench(&window).document.file, None);
    desk.answer(None);
    press(&mut window, "Save as …");
    assert_eq!(scene(&window).pull_mm(), 2.0);
}

#[test]
fn a_recent_file_that_is_gone_is_told_and_forgotten() {
    let desk = Desk::default();
    let stored = Stored {
        recent: vec!["/home/a/gone.toml".into()],
        ..Stored::default()
    };
    let mut window = window_with(&desk, stored, SIZE, Theme::Light);
    ctrl(&mut window, Key::K);
    window.event(Event::Text("recent gone".to_owned()));
    window.run();
    window.key_press(Key::Enter);
    window.run();
    assert!(says(&window, "gone.toml cannot be opened"));
    assert!(bench(&window).files.recent.is_empty());
}

#[test]
fn the_canvas_is_exported_as_svg_and_png() {
    let desk = Desk::default();
    let mut window = window(&desk);
    desk.answer(Some("/home/a/a.svg"));
    ctrl_shift(&mut window, Key::V);
    let text = desk.text("/home/a/a.svg");
    let picture = roxmltree::Document::parse(&text).unwrap();
    assert_eq!(picture.root_element().tag_name().name(), "svg");
    desk.answer(Some("/home/a/a.png"));
    ctrl_shift(&mut window, Key::E);
    let bytes = desk.get("/home/a/a.png").unwrap();
    let pixels = image::load_from_memory(&bytes).unwrap();
    let width: u32 = picture
        .root_element()
        .attribute("width")
        .unwrap()
        .parse()
        .unwrap();
    assert_eq!(pixels.width(), 2 * width);
    assert_eq!(desk.offered(), ["two-posts.svg", "two-posts.png"]);
}

#[test]
fn the_help_lists_every_shortcut_and_the_menu_every_command() {
    let desk = Desk::default();
    let mut window = window(&desk);
    window.key_press(Key::F1);
    window.run();
    assert!(says(&window, "Mouse and touch") && says(&window, "Ctrl+Shift+S"));
    window.key_press(Key::Escape);
    window.run();
    assert!(!says(&window, "Mouse and touch"));
    press(&mut window, "Menu");
    press(&mut window, "File");
    assert!(says(&window, "Copy a link to the scene"));
}

/// Every sheet in both themes and on a phone, for eyes: into the folder that
/// `PICTURES` names.
#[test]
fn every_sheet_can_be_drawn() {
    let desk = Desk::default();
    desk.put("/home/a/broken.toml", "version = 2\n[robot]\nlength_mm = -180\nsegments = 0\ncable_offset_mm = 8\n[actuation]\npull_mm = 5\n");
    desk.put("/home/a/robot.png", png(640, 480));
    let table = "x_mm,y_mm\n0.2,20\n1.1,41\n4.5,65\n11,92\n19,113\n31,137\n46,163\n";
    desk.put("/home/a/measured.csv", table);
    let folder = std::env::var_os("PICTURES");
    for (theme, called) in [(Theme::Light, "light"), (Theme::Dark, "dark")] {
        for (size, wide) in [(SIZE, "wide"), ([390.0, 780.0], "phone")] {
            let mut earlier = window_with(&desk, Stored::default(), size, theme);
            edit(&mut earlier);
            drop(earlier);
            let mut window = window_with(&desk, Stored::default(), size, theme);
            let save = |window: &mut Window, name: &str| {
                let picture = window.render().unwrap();
                if let Some(folder) = &folder {
                    let name = format!("{name}-{called}-{wide}.png");
                    picture.save(Path::new(folder).join(name)).unwrap();
                }
            };
            save(&mut window, "window");
            press(&mut window, "Discard");
            ctrl(&mut window, Key::E);
            save(&mut window, "gallery");
            window.key_press(Key::Escape);
            window.run();
            ctrl(&mut window, Key::K);
            save(&mut window, "palette");
            window.event(Event::Text("open".to_owned()));
            window.run();
            save(&mut window, "palette-typed");
            window.key_press(Key::Escape);
            window.run();
            window.key_press(Key::F1);
            window.run();
            save(&mut window, "help");
            window.key_press(Key::Escape);
            window.run();
            press(&mut window, "Menu");
            press(&mut window, "File");
            save(&mut window, "menu");
            window.key_press(Key::Escape);
            window.run();
            ctrl(&mut window, Key::Comma);
            save(&mut window, "settings");
            window.key_press(Key::Escape);
            window.run();
            drop_on(&mut window, &desk, "/home/a/broken.toml");
            save(&mut window, "faults");
            press(&mut window, "Close");
            drop_on(&mut window, &desk, "/home/a/measured.csv");
            pull(&mut window, 4.0);
            if size == SIZE {
                press(&mut window, "Find the best pull");
            }
            save(&mut window, "measured");
            drop_on(&mut window, &desk, "/home/a/robot.png");
            save(&mut window, "photo");
            ctrl(&mut window, Key::N);
            save(&mut window, "guard");
            press(&mut window, "Cancel");
            window
                .input_mut()
                .hovered_files
                .push(eframe::egui::HoveredFile {
                    path: Some("/home/a/other.toml".into()),
                    mime: String::new(),
                });
            // A window that files hang over is drawn again and again.
            window.run_steps(3);
            save(&mut window, "drop");
        }
    }
}
