//! What becomes of scene files, good and bad. Every sentence a user can get to
//! read from the scene layer is here.

use std::path::PathBuf;

use sinew::scene::{
    Candidates, ForceReading, Friction, Line, Listed, Loads, MAX_FILE_BYTES, Measurements,
    Mechanics, Obstacle, Photo, Robot, Scene, SceneError, Shape, limits,
};

/// A scene with every key there is but those of `[[cable]]`, one to a line; the
/// edits below count on how its values are spelled.
const FULL: &str = include_str!("cases/scene/full.toml");

/// The sentences about a scene text: what keeps it from being read, or else
/// every fault; empty when it is fine.
fn sentences(text: &str) -> Vec<String> {
    match Scene::from_toml(text) {
        Ok(scene) => scene.faults().iter().map(ToString::to_string).collect(),
        Err(error) => vec![error.to_string()],
    }
}

#[track_caller]
fn check(text: &str, expected: &[&str]) {
    assert_eq!(sentences(text), expected, "in:\n{text}");
}

/// Checks [`FULL`] after replacing the first `old` by `new`.
#[track_caller]
fn check_edit(old: &str, new: &str, expected: &[&str]) {
    assert!(FULL.contains(old), "{old:?} is not in the full scene");
    check(&FULL.replacen(old, new, 1), expected);
}

#[test]
fn the_full_scene_is_fine_and_read_as_written() {
    check(FULL, &[]);
    let scene = Scene::from_toml(FULL).unwrap();
    assert_eq!(scene.title.as_deref(), Some("Full"));
    assert_eq!((scene.robot.segments, scene.rim_mm()), (18, 10.0));
    assert_eq!(
        (scene.robot.base_mm, scene.robot.base_angle_deg),
        ([1.0, 2.0], 4.0)
    );
    assert_eq!(scene.model.mechanics, Mechanics::Sliding);
    assert_eq!((scene.cable_count(), scene.pull_mm()), (1, 5.0));
    assert_eq!((scene.offset_mm(), scene.cable(0).diameter_mm), (8.0, 0.5));
    assert_eq!(scene.robot.disk_mass_g, 1.25);
    assert_eq!(scene.robot.backbone_mass_g, 4.5);
    let friction = Friction {
        holes: 0.275,
        contacts: 0.225,
        base_loss: 0.165,
    };
    assert_eq!(scene.friction, friction);
    let loads = Loads {
        tip_force_n: [0.25, -0.15],
        tip_moment_nmm: 12.5,
        gravity_m_s2: [0.375, -9.80665],
    };
    assert_eq!(scene.loads, loads);
    assert_eq!(scene.contact.candidates, Candidates::Listed);
    assert_eq!(
        scene.contact.listed[0],
        Listed {
            line: Line::Cable,
            cable: 0,
            node: 14
        }
    );
    let words: Vec<_> = scene
        .obstacles
        .iter()
        .map(|obstacle| obstacle.shape.word())
        .collect();
    assert_eq!(words, ["disc", "wall", "box", "capsule", "polygon"]);
    assert_eq!(scene.obstacles[0].name.as_deref(), Some("a"));
    let turns: Vec<_> = scene
        .obstacles
        .iter()
        .map(|obstacle| obstacle.shape.rotation_deg())
        .collect();
    assert_eq!(turns, [0.0, 180.0, 20.0, 80.0, 25.0]);
    let anchors: Vec<_> = scene
        .obstacles
        .iter()
        .map(|obstacle| obstacle.shape.anchor_mm())
        .collect();
    let expected = [
        [44.0, 104.0],
        [26.0, 127.0],
        [80.0, 40.0],
        [-28.0, 150.0],
        [100.0, 155.0],
    ];
    assert_eq!(anchors, expected);
    assert_eq!(scene.robot.bending_stiffness_nmm2, Some(8700.0));
    let measured = scene.measured.unwrap();
    assert_eq!(measured.points_mm[1], [6.5, 92.0]);
    assert_eq!(measured.nodes, [0, 9, 17]);
    assert_eq!(measured.forces.len(), 2);
    let chosen = ForceReading {
        load_g: 250.0,
        force_g: 17.75,
    };
    assert_eq!(measured.calibrating(), Some(&chosen));
    let expected = Photo {
        file: "photo.jpg".to_owned(),
        center_mm: [20.0, 90.0],
        width_mm: 300.0,
        rotation_deg: -1.5,
        opacity: 0.75,
    };
    assert_eq!(scene.photo, Some(expected));
}

#[test]
fn the_least_scene_is_fine_and_takes_the_defaults() {
    let text = "version = 2
        model = { mechanics = \"equal\" }
        robot = { length_mm = 180, segments = 18, cable_offset_mm = 8 }
        actuation = { pull_mm = 0 }";
    check(text, &[]);
    assert_eq!(Scene::from_toml(text), Ok(Scene::default()));
    assert_eq!(Scene::default().rim_mm(), 8.0);
    assert_eq!(Scene::default().measured, None);

    let photo = "[photo]\nfile = \"a.png\"\ncenter_mm = [0, 90]\nwidth_mm = 200";
    let scene = Scene::from_toml(&format!("{text}\n[measured]\n{photo}")).unwrap();
    assert_eq!(scene.faults(), []);
    let photo = scene.photo.unwrap();
    assert_eq!((photo.rotation_deg, photo.opacity), (0.0, 1.0));
    let nothing = scene.measured.unwrap();
    assert_eq!(nothing, Measurements::default());
    assert_eq!(nothing.calibrating(), None);
}

#[test]
fn every_word_of_each_choice_is_read() {
    for (word, expected) in [("nodes", Candidates::Nodes), ("body", Candidates::Body)] {
        let text = FULL
            .replace("\"listed\"", &format!("\"{word}\""))
            .replace("listed = ", "# ");
        assert_eq!(
            Scene::from_toml(&text).unwrap().contact.candidates,
            expected
        );
        check(&text, &[]);
    }
    let lines = Scene::from_toml(FULL).unwrap().contact.listed;
    assert_eq!(
        [lines[0].line, lines[1].line],
        [Line::Cable, Line::Backbone]
    );
}

#[test]
fn whole_numbers_serve_where_fractions_may_stand() {
    assert_eq!(
        Scene::from_toml(&FULL.replace(".0", "")),
        Scene::from_toml(FULL)
    );
}

#[test]
fn every_asset_is_fine() {
    let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("assets/scenes");
    let mut names: Vec<_> = std::fs::read_dir(folder)
        .unwrap()
        .map(|entry| entry.unwrap().path())
        .collect();
    names.sort();
    assert!(names.len() >= 6);
    for path in names {
        let scene = Scene::from_toml_bytes(&std::fs::read(&path).unwrap()).unwrap();
        assert_eq!(scene.faults(), [], "{}", path.display());
        assert!(scene.title.is_some(), "{}", path.display());
        assert_eq!(
            Scene::from_toml(&scene.to_toml().unwrap()),
            Ok(scene),
            "{}",
            path.display()
        );
    }
}

#[test]
fn what_is_written_is_read_back_the_same() {
    let mut scene = Scene::from_toml(FULL).unwrap();
    scene.title = Some("quotes \" ''' and \\ and\nlines, ångström, \u{1f}".to_owned());
    scene.robot.length_mm = 0.1 + 0.2 + 100.0;
    scene.set_pull_mm(f64::MIN_POSITIVE);
    scene.robot.base_mm = [-1e6, 1.0 / 3.0];
    assert_eq!(Scene::from_toml(&scene.to_toml().unwrap()), Ok(scene));

    let mut half_edited = Scene::default();
    half_edited.robot.length_mm = f64::INFINITY;
    half_edited.set_pull_mm(-1e300);
    half_edited.robot.segments = u32::MAX;
    half_edited.robot.bending_stiffness_nmm2 = Some(f64::NEG_INFINITY);
    half_edited.measured = Some(Measurements {
        points_mm: vec![[f64::INFINITY, -0.0]],
        nodes: vec![7, 3],
        calibration: Some(u32::MAX),
        forces: vec![],
    });
    half_edited.photo = Some(Photo {
        file: String::new(),
        center_mm: [0.0; 2],
        width_mm: -1.0,
        rotation_deg: 1e300,
        opacity: 7.0,
    });
    half_edited.obstacles.push(Obstacle::from(Shape::Polygon {
        points_mm: vec![],
        rotation_deg: 0.0,
        corner_radius_mm: 0.0,
    }));
    assert_eq!(
        Scene::from_toml(&half_edited.to_toml().unwrap()),
        Ok(half_edited)
    );
}

#[test]
fn the_largest_scene_allowed_can_be_read_back() {
    let round = |i: u32| (f64::from(i) / 64.0 * std::f64::consts::TAU).sin_cos();
    let points_mm: Vec<_> = (0..64)
        .map(round)
        .map(|(sin, cos)| [-9e5 + cos, -9e5 + sin])
        .collect();
    let polygon = Obstacle {
        name: Some("one of a thousand".to_owned()),
        shape: Shape::Polygon {
            points_mm,
            rotation_deg: 1.0 / 3.0,
            corner_radius_mm: 1.0 / 7.0,
        },
    };
    let scene = Scene {
        obstacles: vec![polygon; limits::OBSTACLES],
        measured: Some(largest_measurements()),
        robot: Robot {
            length_mm: 1e5,
            segments: 1e5 as u32,
            ..Robot::default()
        },
        ..Scene::default()
    };
    assert_eq!(scene.check(), Ok(()));
    assert_eq!(Scene::from_toml(&scene.to_toml().unwrap()), Ok(scene));
}

fn largest_measurements() -> Measurements {
    let points = (0..limits::MEASURED_POINTS).map(|i| [1.0 / 3.0, i as f64 / 7.0]);
    let reading = ForceReading {
        load_g: 1e5 / 3.0,
        force_g: 1e4 / 7.0,
    };
    Measurements {
        points_mm: points.collect(),
        nodes: (90_000..).take(limits::MEASURED_POINTS).collect(),
        calibration: Some(limits::READINGS as u32 - 1),
        forces: vec![reading; limits::READINGS],
    }
}

#[test]
fn text_that_is_no_scene_is_refused_with_its_place() {
    let empty = "the scene is empty; it needs at least `version = 2`, a [robot] table and an [actuation] table";
    check("", &[empty]);
    check(" \n\t\r\n  ", &[empty]);
    check("# nothing but a comment", &[empty]);
    check("\u{feff}", &[empty]);
    check(
        "hello world",
        &["line 1, column 7 is not valid TOML: key with no value, expected `=`"],
    );
    check(
        "version = 2\nå = = 2",
        &["line 2, column 5 is not valid TOML: extra `=`, expected nothing"],
    );
    check(
        "version = 2\nversion = 2",
        &["line 2, column 1 is not valid TOML: duplicate key"],
    );
    check(
        "[robot]\n[actuation]\n[robot]",
        &["line 3, column 2 is not valid TOML: duplicate key"],
    );
    check(
        "version = 99999999999999999999",
        &[
            "line 1, column 11 is not valid TOML: this whole number is too large; write it with a decimal point if it is meant",
        ],
    );
    check(
        "version = 1e999",
        &["line 1, column 11 is not valid TOML: floating-point number overflowed"],
    );
    check(
        "\0",
        &["line 1, column 2 is not valid TOML: key with no value, expected `=`"],
    );
}

#[test]
fn bytes_that_are_no_text_are_refused() {
    assert_eq!(
        Scene::from_toml_bytes(FULL.as_bytes()),
        Scene::from_toml(FULL)
    );
    let error = Scene::from_toml_bytes(b"version = 2\n# \xff").unwrap_err();
    assert_eq!(error, SceneError::NotText { byte: 14 });
    assert_eq!(
        error.to_string(),
        "the file is not UTF-8 text (first at byte 14); a scene is a TOML text file"
    );
}

#[test]
fn large_files_are_refused_unread() {
    // Not UTF-8 either: the size is told first, so the bytes were not read.
    let huge = vec![0xff; 100_000_000];
    let error = Scene::from_toml_bytes(&huge).unwrap_err();
    assert_eq!(
        error.to_string(),
        "the file has 100000000 bytes; a scene has at most 4194304, so this is not one"
    );
    let at_limit = format!("{FULL}#{}", " ".repeat(MAX_FILE_BYTES - FULL.len() - 1));
    check(&at_limit, &[]);
    assert_eq!(
        Scene::from_toml(&(at_limit + " ")),
        Err(SceneError::TooLarge {
            bytes: MAX_FILE_BYTES + 1
        })
    );
}

#[test]
fn deep_nesting_is_refused_on_the_usual_stack() {
    let deep = 100_000;
    let too_deep =
        &["lists or tables are nested too deeply; no part of a scene lies more than four deep"];
    check(
        &format!("title = {}{}", "[".repeat(deep), "]".repeat(deep)),
        too_deep,
    );
    check(&format!("title = {}", "[".repeat(deep)), too_deep);
    check(
        &format!("title = {}1{}", "{a=".repeat(deep), "}".repeat(deep)),
        too_deep,
    );
    check(&format!("{}=1", vec!["a"; deep].join(".")), too_deep);
    check(&format!("[{}]", vec!["a"; deep].join(".")), too_deep);
    check(
        &FULL.replace("\"Full\"", "[[[[1]]]]"),
        &["title is a list of 1; it must be a string, \"in quotes\""],
    );
}

#[test]
fn other_versions_are_named_before_anything_else() {
    for version in ["0", "3", "-1", "9223372036854775807"] {
        check_edit(
            "version = 2",
            &format!("version = {version}\nnovelty = 1"),
            &[&format!(
                "version is {version}; this program reads versions 1 to 2: write `version = 2`, or open the scene with the program that wrote it"
            )],
        );
    }
    check_edit(
        "version = 2",
        "version = \"1\"",
        &["version is \"1\", a string; it must be the whole number 2"],
    );
    check_edit(
        "version = 2",
        "version = 1.0",
        &["version is 1.0, a number with a decimal point; it must be the whole number 2"],
    );
    check_edit(
        "version = 2",
        "",
        &["version is missing; add the version of the file format, the whole number 2"],
    );
    let newer = Scene {
        version: 3,
        ..Scene::default()
    };
    assert_eq!(newer.check(), Err(SceneError::Version { found: 3 }));
}

#[test]
fn unknown_keys_name_the_nearest_known_one() {
    for (old, new, expected) in [
        (
            "title",
            "titel",
            "titel is not a key of a scene; did you mean `title`?",
        ),
        (
            "[robot]",
            "[robots]",
            "robots is not a key of a scene; did you mean `robot`?",
        ),
        (
            "length_mm",
            "lenght_mm",
            "robot.lenght_mm is not a key of a scene; did you mean `length_mm`?",
        ),
        (
            "length_mm",
            "length",
            "robot.length is not a key of a scene; did you mean `length_mm`?",
        ),
        (
            "cable_offset_mm",
            "offset_mm",
            "robot.offset_mm is not a key of a scene; did you mean `cable_offset_mm`?",
        ),
        (
            "pull_mm",
            "Pull_MM",
            "actuation.Pull_MM is not a key of a scene; did you mean `pull_mm`?",
        ),
        (
            "pull_mm",
            "pull_mm = 5\nforce",
            "actuation.force is not a key of a scene; use one of pull_mm, load_g",
        ),
        (
            "candidates",
            "candidate",
            "contact.candidate is not a key of a scene; did you mean `candidates`?",
        ),
        (
            "line =",
            "lin =",
            "contact.listed[0].lin is not a key of a scene; did you mean `line`?",
        ),
        (
            "center_mm",
            "centre_mm",
            "obstacle[0].centre_mm is not a key of a scene; did you mean `center_mm`?",
        ),
        (
            "size_mm",
            "extent",
            "obstacle[2].extent is not a key of a scene; use one of shape, name, center_mm, size_mm, rotation_deg, corner_radius_mm",
        ),
        (
            "load_g",
            "laod_g",
            "measured.force[0].laod_g is not a key of a scene; did you mean `load_g`?",
        ),
        (
            "[[measured.force]]",
            "[[measured.forces]]",
            "measured.forces is not a key of a scene; did you mean `force`?",
        ),
        (
            "[photo]",
            "[foto]",
            "foto is not a key of a scene; did you mean `photo`?",
        ),
        (
            "opacity",
            "alpha",
            "photo.alpha is not a key of a scene; use one of file, center_mm, width_mm, rotation_deg, opacity",
        ),
        (
            "title",
            "\"ti\\ntle\"",
            "\"ti\\ntle\" is not a key of a scene; did you mean `title`?",
        ),
    ] {
        check_edit(old, new, &[expected]);
    }
    let long = sentences(&FULL.replace("title", &"x".repeat(1_000_000)));
    assert!(long[0].len() < 200 && long[0].contains('…'), "{}", long[0]);
}

#[test]
fn unknown_words_name_the_choice() {
    check_edit(
        "\"disc\"",
        "\"disk\"",
        &["obstacle[0].shape is \"disk\"; did you mean `disc`?"],
    );
    check_edit(
        "\"disc\"",
        "\"\"",
        &["obstacle[0].shape is \"\"; use one of disc, wall, box, capsule, polygon"],
    );
    check_edit(
        "\"listed\"",
        "\"all\"",
        &["contact.candidates is \"all\"; use one of nodes, body, listed"],
    );
    check_edit(
        "\"cable\"",
        "\"Cable\"",
        &["contact.listed[0].line is \"Cable\"; did you mean `cable`?"],
    );
}

#[test]
fn missing_keys_say_what_to_add() {
    let lines: Vec<&str> = FULL.lines().collect();
    let without = |key: &str| {
        let kept: Vec<_> = lines
            .iter()
            .filter(|line| !line.starts_with(key))
            .copied()
            .collect();
        kept.join("\n")
    };
    for (key, expected) in [
        (
            "length_mm",
            "robot.length_mm is missing; add the length of the backbone, a number of millimetres, from 1 to 100000",
        ),
        (
            "segments =",
            "robot.segments is missing; add the number of segments the backbone is divided into, a whole number, from 1 to 100000",
        ),
        (
            "cable_offset_mm",
            "robot.cable_offset_mm is missing; add the distance between backbone and cable, a number of millimetres, from 0.01 to 10000",
        ),
        (
            "pull_mm",
            "actuation.pull_mm is missing; add the length of cable drawn in, negative to let cable out, a number of millimetres, from -100000 to 100000; or load_g, the weight that hangs on the cable, a number of grams, from 0 to 1000000",
        ),
        (
            "shape",
            "obstacle[0].shape is missing; add the shape of the obstacle, one of \"disc\", \"wall\", \"box\", \"capsule\", \"polygon\"",
        ),
        (
            "center_mm",
            "obstacle[0].center_mm is missing; add its centre, a pair such as [1, 2], each a number of millimetres, from -1000000 to 1000000",
        ),
        (
            "radius_mm",
            "obstacle[0].radius_mm is missing; add its radius, a number of millimetres, from 0.001 to 1000000",
        ),
        (
            "point_mm",
            "obstacle[1].point_mm is missing; add a point of the wall's surface, a pair such as [1, 2], each a number of millimetres, from -1000000 to 1000000",
        ),
        (
            "size_mm",
            "obstacle[2].size_mm is missing; add its outer width and height before its turn, a pair such as [1, 2], each a number of millimetres, from 0.001 to 1000000",
        ),
        (
            "points_mm",
            "obstacle[4].points_mm is missing; add its vertices in order, either way round, a list of points in millimetres, such as [[0, 0], [1, 0], [0, 1]]",
        ),
        (
            "load_g",
            "measured.force[0].load_g is missing; add the weight on the cable, counted from contact, a number of grams, from 0 to 1000000",
        ),
        (
            "force_g",
            "measured.force[0].force_g is missing; add the contact force that was read, as a weight, a number of grams, from -1000000 to 1000000",
        ),
        (
            "file",
            "photo.file is missing; add the picture's file, from the folder of the scene file, a string, \"in quotes\"",
        ),
        (
            "width_mm",
            "photo.width_mm is missing; add its width in the scene before its turn, a number of millimetres, from 0.001 to 1000000",
        ),
    ] {
        check(&without(key), &[expected]);
    }
    check(
        "version = 2\n[actuation]\npull_mm = 1",
        &["robot is missing; add a table headed [robot] for the robot"],
    );
    check_edit(
        ", node = 14",
        "",
        &[
            "contact.listed[0].node is missing; add the index of the node, the base being 0 and the tip robot.segments, a whole number, from 1 to 100000",
        ],
    );
}

#[test]
fn wrong_kinds_are_told_in_plain_words() {
    for (old, new, expected) in [
        (
            "180.0",
            "\"long\"",
            "robot.length_mm is \"long\", a string; it must be a number of millimetres, from 1 to 100000",
        ),
        (
            "180.0",
            "true",
            "robot.length_mm is true, a truth value; it must be a number of millimetres, from 1 to 100000",
        ),
        (
            "180.0",
            "1979-05-27",
            "robot.length_mm is 1979-05-27, a date or time; it must be a number of millimetres, from 1 to 100000",
        ),
        (
            "180.0",
            "[180.0]",
            "robot.length_mm is a list of 1; it must be a number of millimetres, from 1 to 100000",
        ),
        (
            "180.0",
            "{ mm = 180 }",
            "robot.length_mm is a table; it must be a number of millimetres, from 1 to 100000",
        ),
        (
            "\"Full\"",
            "7",
            "title is 7, a number; it must be a string, \"in quotes\"",
        ),
        (
            "= 18\n",
            "= 18.0\n",
            "robot.segments is 18.0, a number with a decimal point; it must be a whole number, from 1 to 100000",
        ),
        (
            "= 18\n",
            "= nan\n",
            "robot.segments is nan, a number with a decimal point; it must be a whole number, from 1 to 100000",
        ),
        (
            "[1.0, 2.0]",
            "[1.0]",
            "robot.base_mm is a list of 1; it must be a pair such as [1, 2], each a number of millimetres, from -1000000 to 1000000",
        ),
        (
            "[1.0, 2.0]",
            "[1, 2, 3]",
            "robot.base_mm is a list of 3; it must be a pair such as [1, 2], each a number of millimetres, from -1000000 to 1000000",
        ),
        (
            "[1.0, 2.0]",
            "[1, \"2\"]",
            "robot.base_mm[1] is \"2\", a string; it must be a number of millimetres, from -1000000 to 1000000",
        ),
        (
            "= 4.0",
            "= \"4\"",
            "robot.base_angle_deg is \"4\", a string; it must be a number of degrees, from -36000 to 36000",
        ),
        (
            "\"listed\"",
            "1",
            "contact.candidates is 1, a number; it must be one of \"nodes\", \"body\", \"listed\"",
        ),
        (
            "[{ line = \"cable\", node = 14 }, ",
            "[14, ",
            "contact.listed[0] is 14, a number; it must be a table, { … }",
        ),
        (
            "\"disc\"",
            "0.5",
            "obstacle[0].shape is 0.5, a number with a decimal point; it must be one of \"disc\", \"wall\", \"box\", \"capsule\", \"polygon\"",
        ),
        (
            "[110.0, 140.0]",
            "110.0",
            "obstacle[4].points_mm[1] is 110.0, a number with a decimal point; it must be a pair such as [1, 2], each a number of millimetres, from -1000000 to 1000000",
        ),
        (
            "[110.0, 140.0]",
            "[110.0, {}]",
            "obstacle[4].points_mm[1][1] is a table; it must be a number of millimetres, from -1000000 to 1000000",
        ),
        (
            "8700.0",
            "\"stiff\"",
            "robot.bending_stiffness_nmm2 is \"stiff\", a string; it must be a number of N mm², from 1e-6 to 1000000000000",
        ),
        (
            "[0, 9, 17]",
            "7",
            "measured.nodes is 7, a number; it must be a list of whole numbers such as [0, 2, 4], each from 0 to 100000",
        ),
        (
            "[0, 9, 17]",
            "[0, 9.5, 17]",
            "measured.nodes[1] is 9.5, a number with a decimal point; it must be a whole number, from 0 to 100000",
        ),
        (
            "[6.5, 92.0]",
            "[6.5, nan, 3]",
            "measured.points_mm[1] is a list of 3; it must be a pair such as [1, 2], each a number of millimetres, from -1000000 to 1000000",
        ),
        (
            "calibration = 1",
            "calibration = 1.0",
            "measured.calibration is 1.0, a number with a decimal point; it must be a whole number, from 0 to 999",
        ),
        (
            "\"photo.jpg\"",
            "7",
            "photo.file is 7, a number; it must be a string, \"in quotes\"",
        ),
        (
            "= 0.75",
            "= \"half\"",
            "photo.opacity is \"half\", a string; it must be a number, from 0 to 1",
        ),
    ] {
        check_edit(old, new, &[expected]);
    }
    let (head, _) = FULL.split_once("[[measured.force]]").unwrap();
    check(
        &format!("{head}force = 3"),
        &[
            "measured.force is 3, a number; it must be a list of tables, each under its own [[measured.force]]",
        ],
    );
    let rest = "version = 2\nactuation = { pull_mm = 1 }\n";
    check(
        &format!("{rest}robot = 3"),
        &["robot is 3, a number; it must be a table"],
    );
    let robot = "robot = { length_mm = 9, segments = 2, cable_offset_mm = 1 }\n";
    check(
        &format!("{rest}{robot}[obstacle]\nshape = \"disc\""),
        &["obstacle is a table; it must be a list of tables, each under its own [[obstacle]]"],
    );
    check(
        &format!("{rest}{robot}obstacle = [1]"),
        &["obstacle[0] is 1, a number; it must be a table under its own [[obstacle]]"],
    );
}

/// Every number of [`FULL`] that may have a fraction, with its place.
const NUMBERS: [(&str, &str, &str); 33] = [
    (
        "length_mm = 180.0",
        "robot.length_mm",
        "from 1 to 100000 mm",
    ),
    (
        "cable_offset_mm = 8.0",
        "robot.cable_offset_mm",
        "from 0.01 to 10000 mm",
    ),
    (
        "disk_radius_mm = 10.0",
        "robot.disk_radius_mm",
        "from 0.01 to 10000 mm",
    ),
    (
        "disk_thickness_mm = 3.0",
        "robot.disk_thickness_mm",
        "from 0 to 10000 mm",
    ),
    (
        "backbone_diameter_mm = 1.0",
        "robot.backbone_diameter_mm",
        "from 0 to 10000 mm",
    ),
    (
        "cable_diameter_mm = 0.5",
        "robot.cable_diameter_mm",
        "from 0 to 10000 mm",
    ),
    (
        "disk_mass_g = 1.25",
        "robot.disk_mass_g",
        "from 0 to 1000000 g",
    ),
    (
        "backbone_mass_g = 4.5",
        "robot.backbone_mass_g",
        "from 0 to 1000000 g",
    ),
    (
        "tip_force_n = [0.25",
        "loads.tip_force_n[0]",
        "from -1000000 to 1000000 N",
    ),
    (
        "gravity_m_s2 = [0.375",
        "loads.gravity_m_s2[0]",
        "from -1000 to 1000 m/s²",
    ),
    (
        "base_mm = [1.0",
        "robot.base_mm[0]",
        "from -1000000 to 1000000 mm",
    ),
    (
        "base_angle_deg = 4.0",
        "robot.base_angle_deg",
        "from -36000 to 36000 deg",
    ),
    (
        "pull_mm = 5.0",
        "actuation.pull_mm",
        "from -100000 to 100000 mm",
    ),
    (
        "center_mm = [44.0",
        "obstacle[0].center_mm[0]",
        "from -1000000 to 1000000 mm",
    ),
    (
        "radius_mm = 15.0",
        "obstacle[0].radius_mm",
        "from 0.001 to 1000000 mm",
    ),
    (
        "point_mm = [26.0",
        "obstacle[1].point_mm[0]",
        "from -1000000 to 1000000 mm",
    ),
    (
        "rotation_deg = 180.0",
        "obstacle[1].rotation_deg",
        "from -36000 to 36000 deg",
    ),
    (
        "corner_radius_mm = 0.125",
        "obstacle[1].corner_radius_mm",
        "from 0 to 1000000 mm",
    ),
    (
        "size_mm = [50.0",
        "obstacle[2].size_mm[0]",
        "from 0.001 to 1000000 mm",
    ),
    (
        "rotation_deg = 20.0",
        "obstacle[2].rotation_deg",
        "from -36000 to 36000 deg",
    ),
    (
        "corner_radius_mm = 5.0",
        "obstacle[2].corner_radius_mm",
        "from 0 to 1000000 mm",
    ),
    (
        "length_mm = 30.0",
        "obstacle[3].length_mm",
        "from 0.001 to 1000000 mm",
    ),
    (
        "radius_mm = 7.0",
        "obstacle[3].radius_mm",
        "from 0.001 to 1000000 mm",
    ),
    (
        "rotation_deg = 80.0",
        "obstacle[3].rotation_deg",
        "from -36000 to 36000 deg",
    ),
    (
        "[115.0",
        "obstacle[4].points_mm[2][0]",
        "from -1000000 to 1000000 mm",
    ),
    (
        "rotation_deg = 25.0",
        "obstacle[4].rotation_deg",
        "from -36000 to 36000 deg",
    ),
    (
        "corner_radius_mm = 2.0",
        "obstacle[4].corner_radius_mm",
        "from 0 to 1000000 mm",
    ),
    (
        "[6.5",
        "measured.points_mm[1][0]",
        "from -1000000 to 1000000 mm",
    ),
    (
        "load_g = 50.0",
        "measured.force[0].load_g",
        "from 0 to 1000000 g",
    ),
    (
        "force_g = 3.5",
        "measured.force[0].force_g",
        "from -1000000 to 1000000 g",
    ),
    (
        "center_mm = [20.0",
        "photo.center_mm[0]",
        "from -1000000 to 1000000 mm",
    ),
    (
        "width_mm = 300.0",
        "photo.width_mm",
        "from 0.001 to 1000000 mm",
    ),
    (
        "rotation_deg = -1.5",
        "photo.rotation_deg",
        "from -36000 to 36000 deg",
    ),
];

#[test]
fn numbers_out_of_range_give_field_value_range_and_unit() {
    for (place, field, range) in NUMBERS {
        let (_, unit) = range.rsplit_once(' ').unwrap();
        let key = &place[..place.rfind([' ', '[']).unwrap() + 1];
        let mut bad = vec!["inf", "-inf", "1e300", "-1e300", "1000000.5", "-1000000.5"];
        if range.starts_with("from 0 ") {
            bad.extend(["-5", "-0.0001"]);
        } else if !range.starts_with("from -") {
            bad.extend(["-5", "0", "-0.0", "1e-9"]);
        }
        for value in bad {
            check_edit(
                place,
                &format!("{key}{value}"),
                &[&format!(
                    "{field} is {value} {unit}; set it to a value {range}"
                )],
            );
        }
        for nan in ["nan", "-nan"] {
            check_edit(
                place,
                &format!("{key}{nan}"),
                &[&format!(
                    "{field} is nan, not a number; set it to a value {range}"
                )],
            );
        }
    }
}

#[test]
fn stiffnesses_and_shares_have_ranges_of_their_own() {
    let stiffness = "from 1e-6 to 1000000000000";
    for value in ["inf", "-inf", "1e300", "0", "-0.0", "-5", "9e-7"] {
        let expected = format!(
            "robot.bending_stiffness_nmm2 is {value} N mm²; set it to a value {stiffness} N mm²"
        );
        check_edit("8700.0", value, &[&expected]);
    }
    check_edit("8700.0", "1e12", &[]);
    for value in ["inf", "-inf", "1.5", "-0.0001", "1e300"] {
        let expected = format!("photo.opacity is {value}; set it to a value from 0 to 1");
        check_edit("0.75", value, &[&expected]);
    }
    check_edit("0.75", "0", &[]);
    for (place, field, range) in [
        ("holes = 0.275", "friction.holes", "from 0 to 1000"),
        ("contacts = 0.225", "friction.contacts", "from 0 to 1000"),
        ("base_loss = 0.165", "friction.base_loss", "from 0 to 0.999"),
    ] {
        let key = &place[..=place.rfind(' ').unwrap()];
        for value in ["inf", "-0.0001", "1000.5"] {
            let expected = format!("{field} is {value}; set it to a value {range}");
            check_edit(place, &format!("{key}{value}"), &[&expected]);
        }
        check_edit(place, &format!("{key}0"), &[]);
    }
    check_edit("holes = 0.275", "holes = 100", &[]);
    check_edit(
        "base_loss = 0.165",
        "base_loss = 1",
        &["friction.base_loss is 1; set it to a value from 0 to 0.999"],
    );
    for value in ["inf", "-1.5e9"] {
        let expected = format!(
            "loads.tip_moment_nmm is {value} N mm; set it to a value from -1000000000 to 1000000000 N mm"
        )
        .replace("1.5e9", "1500000000");
        check_edit("12.5", value, &[&expected]);
    }
    for nan in ["nan", "-nan"] {
        let expected = "robot.bending_stiffness_nmm2 is nan, not a number; set it to a value from 1e-6 to 1000000000000 N mm²";
        check_edit("8700.0", nan, &[expected]);
        let expected = "photo.opacity is nan, not a number; set it to a value from 0 to 1";
        check_edit("0.75", nan, &[expected]);
    }
}

#[test]
fn measurements_that_contradict_themselves_are_named() {
    let points = "[[1.0, 2.0], [6.5, 92.0], [30.0, 175.0]]";
    let both = format!("points_mm = {points}\nnodes = [0, 9, 17]");
    check_edit(&both, "", &[]);
    check_edit(
        &both,
        "points_mm = [[1, 2]]",
        &["measured.points_mm has 1 of the at least 2 entries it needs; add some, or remove it"],
    );
    check_edit("nodes = [0, 9, 17]", "", &[]);
    check_edit(
        "[0, 9, 17]",
        "[0, 9]",
        &[
            "measured.nodes has 2 entries, and measured.points_mm has 3; name one node for each point, or remove nodes",
        ],
    );
    check_edit(
        "[0, 9, 17]",
        "[0, 9, 9]",
        &[
            "measured.nodes[2] is 9, which does not come after the 9 before it; order points and nodes from base to tip",
        ],
    );
    check_edit(
        "[0, 9, 17]",
        "[0, 9, 19]",
        &["measured.nodes[2] is 19; set it to a value from 0 to robot.segments, 18"],
    );
    for value in ["-1", "100001", "9223372036854775807"] {
        check_edit(
            "[0, 9, 17]",
            &format!("[0, 9, {value}]"),
            &[&format!(
                "measured.nodes[2] is {value}; set it to a value from 0 to 100000"
            )],
        );
    }
    for value in ["-1", "1000", "4294967296"] {
        check_edit(
            "calibration = 1",
            &format!("calibration = {value}"),
            &[&format!(
                "measured.calibration is {value}; set it to a value from 0 to 999"
            )],
        );
    }
    check_edit(
        "calibration = 1",
        "calibration = 2",
        &["measured.calibration is 2; set it to a value from 0 to the last [[measured.force]], 1"],
    );
    for force in ["0", "-3"] {
        check_edit(
            "force_g = 17.75",
            &format!("force_g = {force}"),
            &[&format!(
                "measured.calibration is 1, a reading of {force} g under 250 g, which fixes no ratio; choose a reading with a positive load and force"
            )],
        );
    }
    let (head, _) = FULL.split_once("[[measured.force]]").unwrap();
    check(
        head,
        &[
            "measured.calibration is 1, and there are no readings; add them, each under its own [[measured.force]], or remove calibration",
        ],
    );
    for blank in ["\"\"", "\" \\t\""] {
        check_edit(
            "\"photo.jpg\"",
            blank,
            &["photo.file is empty; name the picture's file, or remove [photo]"],
        );
    }
}

#[test]
fn too_many_measurements_are_counted() {
    let mut measured = largest_measurements();
    measured.points_mm.push([f64::NAN; 2]);
    measured.nodes.clear();
    measured.forces.extend([measured.forces[0]; 5]);
    let scene = Scene {
        measured: Some(measured),
        ..Scene::default()
    };
    let sentences: Vec<_> = scene.faults().iter().map(ToString::to_string).collect();
    assert_eq!(
        sentences,
        [
            "measured.points_mm has 10001 entries; at most 10000 are allowed: remove 1",
            "measured.force has 1005 entries; at most 1000 are allowed: remove 5",
        ]
    );
}

#[test]
fn counts_out_of_range_give_field_value_and_range() {
    for (place, field) in [
        ("segments = 18", "robot.segments"),
        ("segments_per_bay = 2", "robot.segments_per_bay"),
        ("node = 14", "contact.listed[0].node"),
    ] {
        let key = &place[..=place.rfind(' ').unwrap()];
        for value in [
            "0",
            "-3",
            "100001",
            "9223372036854775807",
            "-9223372036854775808",
        ] {
            let expected = format!("{field} is {value}; set it to a value from 1 to 100000");
            check_edit(place, &format!("{key}{value}"), &[&expected]);
        }
    }
}

#[test]
fn fields_that_contradict_each_other_are_named() {
    check_edit(
        "segments_per_bay = 2",
        "segments_per_bay = 4",
        &[
            "robot.segments_per_bay is 4, which does not divide robot.segments, 18, so that no disk sits at the tip; set it to 1, or set segments to 16 or 20",
        ],
    );
    check_edit(
        "segments_per_bay = 2",
        "segments_per_bay = 9",
        &["robot.segments_per_bay is 9; set it to a value from 1 to 8 where the cable slides"],
    );
    let mut equal = Scene::default();
    equal.robot.segments_per_bay = 9;
    assert_eq!(equal.faults(), []);
    equal.robot.segments_per_bay = 20;
    assert_eq!(
        equal.check().unwrap_err().to_string(),
        "robot.segments_per_bay is 20, which does not divide robot.segments, 18, so that no disk sits at the tip; set it to 1, or set segments to 20"
    );
    check_edit(
        "disk_radius_mm = 10.0",
        "disk_radius_mm = 7.5",
        &[
            "robot.disk_radius_mm is 7.5 mm; set it to a value from robot.cable_offset_mm, 8, to 10000 mm",
        ],
    );
    check_edit(
        "node = 14",
        "node = 19",
        &["contact.listed[0].node is 19; set it to a value from 1 to robot.segments, 18"],
    );
    check_edit(
        "\"backbone\", node = 18",
        "\"cable\", node = 14",
        &["contact.listed[1] is the same node as contact.listed[0]; remove one of them"],
    );
    check_edit(
        "candidates = \"listed\"",
        "",
        &[
            "contact.listed names nodes while contact.candidates is not \"listed\"; remove the list, or set candidates to \"listed\"",
        ],
    );
    let none = "contact.listed names no node while contact.candidates is \"listed\"; list at least one, such as [{ line = \"cable\", node = 1 }], or set candidates to \"nodes\"";
    check_edit("listed = [", "listed = [] # ", &[none]);
    check_edit("listed = [", "# ", &[none]);
    check_edit(
        "corner_radius_mm = 5.0",
        "corner_radius_mm = 15.5",
        &[
            "obstacle[2].corner_radius_mm is 15.5 mm; set it to a value from 0 to half the smaller side of obstacle[2].size_mm, 15 mm",
        ],
    );
    check_edit("corner_radius_mm = 5.0", "corner_radius_mm = 15", &[]);
}

#[test]
fn polygons_that_bound_nothing_convex_are_told_apart() {
    let old = "[[75.0, 150.0], [110.0, 140.0], [115.0, 175.0]]";
    for (points, expected) in [
        (
            "[]",
            "has 0 of the at least 3 vertices a polygon needs; add some",
        ),
        (
            "[[1, 2], [3, 4]]",
            "has 2 of the at least 3 vertices a polygon needs; add some",
        ),
        (
            "[[1, 2], [3, 4], [1, 2]]",
            "has its vertices 0 and 2 in one place; remove one, or move them at least 0.001 mm apart",
        ),
        (
            "[[1, 1], [2, 2], [5, 5]]",
            "has all its vertices on one line, so it encloses nothing; move one aside, or use a capsule",
        ),
        (
            "[[0, 0], [4, 0], [1, 1], [0, 4]]",
            "is not convex at vertex 2; remove that vertex, or split the shape into convex obstacles",
        ),
        (
            "[[0, 10], [6, -8], [-10, 3], [10, 3], [-6, -8]]",
            "crosses itself before vertex 2; list the vertices in order once around",
        ),
    ] {
        check_edit(old, points, &[&format!("obstacle[4].points_mm {expected}")]);
    }
    let many: Vec<_> = (0..65).map(|i| format!("[{i}, {}]", i * i)).collect();
    check_edit(
        old,
        &format!("[{}]", many.join(", ")),
        &["obstacle[4].points_mm has 65 entries; at most 64 are allowed: remove 1"],
    );
}

#[test]
fn too_many_obstacles_are_counted() {
    let disc = Obstacle::from(Shape::Disc {
        center_mm: [99.0, 99.0],
        radius_mm: 1.0,
    });
    let scene = Scene {
        obstacles: vec![disc; 1003],
        ..Scene::default()
    };
    assert_eq!(
        scene.check().unwrap_err().to_string(),
        "obstacle has 1003 entries; at most 1000 are allowed: remove 3"
    );
}

#[test]
fn faults_come_all_and_in_file_order() {
    let text = FULL
        .replace("radius_mm = 15.0", "radius_mm = -15")
        .replace("length_mm = 180.0", "length_mm = nan")
        .replace("pull_mm = 5.0", "pull_mm = inf")
        .replace("width_mm = 300.0", "width_mm = 0")
        .replace("= 8700.0", "= -1.0")
        .replace("[6.5, 92.0]", "[nan, 92.0]");
    check(
        &text,
        &[
            "robot.length_mm is nan, not a number; set it to a value from 1 to 100000 mm",
            "robot.bending_stiffness_nmm2 is -1 N mm²; set it to a value from 1e-6 to 1000000000000 N mm²",
            "actuation.pull_mm is inf mm; set it to a value from -100000 to 100000 mm",
            "obstacle[0].radius_mm is -15 mm; set it to a value from 0.001 to 1000000 mm",
            "measured.points_mm[1][0] is nan, not a number; set it to a value from -1000000 to 1000000 mm",
            "photo.width_mm is 0 mm; set it to a value from 0.001 to 1000000 mm",
        ],
    );
    let scene = Scene::from_toml(&text).unwrap();
    assert_eq!(
        scene.check().unwrap_err().to_string(),
        scene.faults()[0].to_string()
    );
}
