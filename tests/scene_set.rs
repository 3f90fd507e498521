//! Values set by the names that messages give them.

use sinew::scene::{Candidates, Drive, Mechanics, Scene, Shape};

const CABLES: &str = include_str!("cases/scene/cables.toml");
const FULL: &str = include_str!("cases/scene/full.toml");

fn full() -> Scene {
    Scene::from_toml(FULL).unwrap()
}

/// The scene with a value set, which has no faults.
#[track_caller]
fn with(mut scene: Scene, key: &str, value: &str) -> Scene {
    scene.set(key, value).unwrap();
    assert_eq!(scene.faults(), [], "{key} = {value}");
    scene
}

/// Checks what is told of a value that cannot be set, which changes nothing.
#[track_caller]
fn check_refused(mut scene: Scene, key: &str, value: &str, expected: &str) {
    let before = scene.clone();
    let error = scene.set(key, value).unwrap_err();
    assert_eq!(error.to_string(), expected);
    assert_eq!(scene, before);
}

#[test]
fn every_number_of_the_full_scene_can_be_set_by_its_name() {
    // The names as faults give them: every number out of its range is told.
    for (text, least) in [(FULL, 40), (CABLES, 12)] {
        let scene = Scene::from_toml(text).unwrap();
        let table = toml::Table::try_from(&scene).unwrap();
        let mut names = Vec::new();
        leaves(&toml::Value::Table(table), "", &mut names);
        assert!(names.len() >= least, "{names:?}");
        for (name, value) in names {
            let mut same = scene.clone();
            same.set(&name, &value.to_string()).unwrap();
            assert_eq!(same, scene, "{name}");
            if value.is_float() {
                let mut spoiled = scene.clone();
                spoiled.set(&name, "inf").unwrap();
                let faults = spoiled.faults();
                let fields: Vec<_> = faults.iter().filter_map(|fault| fault.field()).collect();
                assert_eq!(fields, [name]);
            }
        }
    }
}

#[test]
fn a_number_set_in_place_is_the_number_set_by_its_text() {
    for text in [FULL, CABLES] {
        let scene = Scene::from_toml(text).unwrap();
        let table = toml::Table::try_from(&scene).unwrap();
        let mut names = Vec::new();
        leaves(&toml::Value::Table(table), "", &mut names);
        names.retain(|(_, value)| value.is_float());
        let mut keys: Vec<String> = names.into_iter().map(|(name, _)| name).collect();
        // What is left out, what stands in another's place, what is none.
        keys.extend(
            [
                "robot.disks",
                "robot.disk_spacing_mm",
                "robot.segments",
                "robot.segments_per_bay",
                "cable[0].to_disk",
                "cable[1].to_disk",
                "cable[1].to_disk[0]",
                "actuation.load_g",
                "cable[1].load_g",
                "cable[1].pull_mm",
                "cable[7].pull_mm",
                "friction.holes",
                "loads.gravity_m_s2[1]",
                "loads.gravity_m_s2[2]",
                "obstacle[0].center_mm",
                "obstacle[0].size_mm[0]",
                "robot.length_mm[0]",
                "robot.lenght_mm",
                "title",
            ]
            .map(str::to_owned),
        );
        for key in keys {
            for value in [9.0, 22.5, 0.1 + 0.2, -3.75, -0.0, 1e300] {
                let (mut by_text, mut in_place) = (scene.clone(), scene.clone());
                let told = by_text.set(&key, &sinew::scene::limits::shown(value));
                assert_eq!(in_place.set_number(&key, value), told, "{key} = {value}");
                assert_eq!(in_place, by_text, "{key} = {value}");
            }
        }
    }
}

/// Every value with its name.
fn leaves(value: &toml::Value, at: &str, names: &mut Vec<(String, toml::Value)>) {
    match value {
        toml::Value::Table(table) => {
            for (key, item) in table {
                let dot = if at.is_empty() { "" } else { "." };
                leaves(item, &format!("{at}{dot}{key}"), names);
            }
        }
        toml::Value::Array(items) => {
            for (index, item) in items.iter().enumerate() {
                leaves(item, &format!("{at}[{index}]"), names);
            }
        }
        leaf => names.push((at.to_owned(), leaf.clone())),
    }
}

#[test]
fn values_are_set_as_a_file_would_have_them() {
    let scene = with(full(), "robot.cable_offset_mm", "7.5");
    assert_eq!(scene.offset_mm(), 7.5);
    let scene = with(full(), "obstacle[0].center_mm[0]", " 50 ");
    assert_eq!(scene.obstacles[0].shape.anchor_mm(), [50.0, 104.0]);
    let scene = with(full(), "obstacle[4].points_mm[2][1]", "170");
    let Shape::Polygon { points_mm, .. } = &scene.obstacles[4].shape else {
        panic!("{scene:?}");
    };
    assert_eq!(points_mm[2], [115.0, 170.0]);
    let scene = with(full(), "obstacle[4].points_mm[2]", "[120, 171]");
    let Shape::Polygon { points_mm, .. } = &scene.obstacles[4].shape else {
        panic!("{scene:?}");
    };
    assert_eq!(points_mm[2], [120.0, 171.0]);
    let scene = with(full(), "measured.force[1].load_g", "225");
    assert_eq!(scene.measured.unwrap().forces[1].load_g, 225.0);
    let scene = with(full(), "contact.listed[1].node", "17");
    assert_eq!(scene.contact.listed[1].node, 17);
    let scene = with(full(), "loads.gravity_m_s2", "[0, -1.62]");
    assert_eq!(scene.loads.gravity_m_s2, [0.0, -1.62]);
    for title in ["Wide = far", "\"Wide = far\"", "'Wide = far'"] {
        let scene = with(full(), "title", title);
        assert_eq!(scene.title.as_deref(), Some("Wide = far"));
    }
    let scene = with(full(), "title", "7");
    assert_eq!(scene.title.as_deref(), Some("7"));
}

#[test]
fn what_was_left_out_is_added() {
    let scene = with(Scene::default(), "robot.bending_stiffness_nmm2", "8e3");
    assert_eq!(scene.robot.bending_stiffness_nmm2, Some(8000.0));
    let scene = with(scene, "contact.candidates", "body");
    assert_eq!(scene.contact.candidates, Candidates::Body);
    let scene = with(scene, "model.mechanics", "sliding");
    assert_eq!(scene.model.mechanics, Mechanics::Sliding);
    let scene = with(scene, "friction.holes", "0.3");
    assert_eq!(scene.friction.holes, 0.3);
    let scene = with(scene, "loads.gravity_m_s2[1]", "-9.80665");
    assert_eq!(scene.loads.gravity_m_s2, [0.0, -9.80665]);
}

#[test]
fn drives_take_each_others_place() {
    let scene = with(full(), "actuation.load_g", "250");
    assert_eq!(scene.cable(0).drive, Drive::LoadG(250.0));
    let scene = with(scene, "actuation.pull_mm", "4");
    assert_eq!(scene.cable(0).drive, Drive::PullMm(4.0));
    let cables = Scene::from_toml(CABLES).unwrap();
    let scene = with(cables, "cable[1].load_g", "40");
    assert_eq!(scene.cable(1).drive, Drive::LoadG(40.0));
    assert_eq!(scene.cable(0).drive, Drive::LoadG(300.0));
}

#[test]
fn disks_and_their_spacing_set_the_segments() {
    let segments = |key: &str, value: &str| {
        let scene = with(Scene::default(), key, value);
        assert_eq!(scene.robot.length_mm, 180.0);
        assert_eq!(scene.robot.segments_per_bay, 2);
        scene.robot.segments
    };
    assert_eq!(segments("robot.disks", "9"), 18);
    assert_eq!(segments("robot.disks", "4"), 8);
    assert_eq!(segments("robot.disk_spacing_mm", "20"), 18);
    assert_eq!(segments("robot.disk_spacing_mm", "22.5"), 16);
    // As near as ten digits give it.
    assert_eq!(segments("robot.disk_spacing_mm", "25.71428571"), 14);
    // One arc a bay first.
    let mut scene = Scene::default();
    scene.set("robot.segments_per_bay", "1").unwrap();
    scene.set("robot.disk_spacing_mm", "10").unwrap();
    assert_eq!(scene.robot.segments, 18);

    let odd = "robot.disk_spacing_mm is 23 mm, which does not divide robot.length_mm, 180; set it to 22.5 for 8 disks or 25.714285714285715 for 7 disks";
    check_refused(Scene::default(), "robot.disk_spacing_mm", "23", odd);
    assert_eq!(segments("robot.disk_spacing_mm", "25.714285714285715"), 14);
    check_refused(
        Scene::default(),
        "robot.disk_spacing_mm",
        "200",
        "robot.disk_spacing_mm is 200 mm, which does not divide robot.length_mm, 180; set it to 180 for 1 disk",
    );
    check_refused(
        Scene::default(),
        "robot.disk_spacing_mm",
        "nan",
        "robot.disk_spacing_mm is nan, not a number; set it to a value from 1e-5 to 100000 mm",
    );
    check_refused(
        Scene::default(),
        "robot.disk_spacing_mm",
        "20 mm",
        "robot.disk_spacing_mm is \"20 mm\", a string; it must be a number of millimetres, from 1e-5 to 100000",
    );
    for bad in ["0", "100001", "-1"] {
        let expected = format!("robot.disks is {bad}; set it to a value from 1 to 100000");
        check_refused(Scene::default(), "robot.disks", bad, &expected);
    }
    check_refused(
        Scene::default(),
        "robot.disks",
        "9.5",
        "robot.disks is 9.5, a number with a decimal point; it must be a whole number, from 1 to 100000",
    );
}

#[test]
fn names_and_values_that_are_none_are_told() {
    for (key, value, expected) in [
        (
            "robot.lenght_mm",
            "3",
            "robot.lenght_mm is not a key of a scene; did you mean `length_mm`?",
        ),
        (
            "robot.disk_spacing",
            "3",
            "robot.disk_spacing is not a key of a scene; did you mean `disk_spacing_mm`?",
        ),
        (
            "frictoin.holes",
            "3",
            "frictoin is not a key of a scene; did you mean `friction`?",
        ),
        (
            "obstacle[0].size_mm",
            "[1, 2]",
            "obstacle[0].size_mm is not a key of a scene; use one of shape, name, center_mm, radius_mm",
        ),
        (
            "obstacle[5].radius_mm",
            "3",
            "obstacle[5] is not in the scene; name one from obstacle[0] to obstacle[4]",
        ),
        (
            "obstacle[0].center_mm[2]",
            "3",
            "obstacle[0].center_mm[2] is not in the scene; name one from obstacle[0].center_mm[0] to obstacle[0].center_mm[1]",
        ),
        (
            "cable[0].load_g",
            "3",
            "cable[0] is not in the scene; its cable is described by robot.cable_offset_mm and actuation",
        ),
        (
            "robot.length_mm",
            "4,9",
            "robot.length_mm is \"4,9\", a string; it must be a number of millimetres, from 1 to 100000",
        ),
        (
            "robot.segments",
            "18.5",
            "robot.segments is 18.5, a number with a decimal point; it must be a whole number, from 1 to 100000",
        ),
        (
            "contact.candidates",
            "boddy",
            "contact.candidates is \"boddy\"; did you mean `body`?",
        ),
        (
            "robot.base_mm",
            "3",
            "robot.base_mm is 3, a number; it must be a pair such as [1, 2], each a number of millimetres, from -1000000 to 1000000",
        ),
        ("robot", "3", "robot is 3, a number; it must be a table"),
        (
            "version",
            "3",
            "version is 3; this program reads versions 1 to 2: write `version = 2`, or open the scene with the program that wrote it",
        ),
        (
            "robot.length_mm",
            "1\nsegments = 3",
            "robot.length_mm is \"1\\nsegments = 3\", a string; it must be a number of millimetres, from 1 to 100000",
        ),
    ] {
        check_refused(full(), key, value, expected);
    }
    // Whatever is asked for, nothing panics and nothing changes.
    for key in [
        "",
        ".",
        "[",
        "]",
        "[0]",
        "robot",
        "robot.",
        "robot..segments",
        "robot[0]",
        "obstacle[",
        "obstacle[x]",
        "obstacle[0",
        "obstacle[0]]",
        "obstacle[0][0]",
        "obstacle[-1].name",
        "robot.base_mm[0][0]",
        "robot.length_mm.x",
        "obstacle[0].center_mm.x",
        "title.x",
        "measured.points_mm[0][0][0]",
        "obstacle[99999999999999999999].name",
        "å",
        "obstacle[0]å",
    ] {
        let mut scene = full();
        let error = scene.set(key, "1").unwrap_err().to_string();
        assert!(
            error.len() < 400 && !error.contains("invalid type"),
            "{key}: {error}"
        );
        assert_eq!(scene, full(), "{key}");
    }
}
