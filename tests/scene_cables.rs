//! Cables, loads and friction in scene files: both ways to describe a cable,
//! one way to read it, and what is told of what cannot be meant.

use sinew::equilibrium::{Settings, Start, solve};
use sinew::mechanics::Problem;
use sinew::robot::{self, Robot};
use sinew::scene::{
    Actuation, Cable, Candidates, Contact, Drive, Line, Listed, Mechanics, Scene, Shape,
};

const CABLES: &str = include_str!("cases/scene/cables.toml");
const FULL: &str = include_str!("cases/scene/full.toml");

#[track_caller]
fn check(text: &str, expected: &[&str]) {
    let found: Vec<String> = match Scene::from_toml(text) {
        Ok(scene) => scene.faults().iter().map(ToString::to_string).collect(),
        Err(error) => vec![error.to_string()],
    };
    assert_eq!(found, expected, "in:\n{text}");
}

#[track_caller]
fn check_edit(old: &str, new: &str, expected: &[&str]) {
    assert!(CABLES.contains(old), "{old:?} is not in the scene");
    check(&CABLES.replacen(old, new, 1), expected);
}

/// The paper's robot with its cable in a list of its own.
fn one_in_a_list(drive: Drive) -> Scene {
    let mut scene = Scene {
        actuation: None,
        cables: vec![Cable {
            offset_mm: 8.0,
            drive,
            to_disk: None,
            axial_stiffness_n: None,
            diameter_mm: 0.5,
        }],
        ..Scene::default()
    };
    scene.robot.cable_offset_mm = None;
    scene
}

#[test]
fn cables_are_read_as_written_and_written_as_read() {
    check(CABLES, &[]);
    let scene = Scene::from_toml(CABLES).unwrap();
    let first = Cable {
        offset_mm: 8.5,
        drive: Drive::LoadG(300.0),
        to_disk: None,
        axial_stiffness_n: None,
        diameter_mm: 0.5,
    };
    let second = Cable {
        offset_mm: -7.5,
        drive: Drive::PullMm(-2.0),
        to_disk: Some(7),
        axial_stiffness_n: Some(20_000.0),
        diameter_mm: 0.0,
    };
    assert_eq!(scene.each_cable().collect::<Vec<_>>(), [first, second]);
    assert_eq!((scene.rim_mm(), scene.last_disk()), (8.5, 9));
    let [on_cable, rim] = scene.contact.listed[..] else {
        panic!("{:?}", scene.contact);
    };
    let expected = Listed {
        line: Line::Cable,
        cable: 1,
        node: 14,
    };
    assert_eq!(on_cable, expected);
    assert_eq!((rim.line, rim.cable, rim.node), (Line::Rim, 0, 8));
    assert_eq!(Scene::from_toml(&scene.to_toml().unwrap()), Ok(scene));
    // Whole numbers, too.
    assert_eq!(
        Scene::from_toml(&CABLES.replace(".0\n", "\n")),
        Scene::from_toml(CABLES)
    );
}

#[test]
fn either_way_to_describe_one_cable_reads_and_sets_the_same() {
    let mut with_robot = Scene::default();
    with_robot.robot.cable_diameter_mm = 0.5;
    let mut in_list = one_in_a_list(Drive::PullMm(0.0));
    for scene in [&mut with_robot, &mut in_list] {
        assert_eq!((scene.cable_count(), scene.offset_mm()), (1, 8.0));
        scene.set_pull_mm(4.0);
        assert_eq!(scene.pull_mm(), 4.0);
        scene.set_drive(0, Drive::LoadG(200.0));
        assert_eq!((scene.pull_mm(), scene.rim_mm()), (0.0, 8.0));
        scene.set_offset_mm(7.0);
        scene.set_cable_diameter_mm(0.25);
        scene.set_pull_mm(5.0);
    }
    assert_eq!(with_robot.cable(0), in_list.cable(0));
    assert_eq!(with_robot.cable(0).diameter_mm, 0.25);
    let names = |scene: &Scene| ["offset_mm", "load_g"].map(|key| scene.cable_field(0, key));
    assert_eq!(
        names(&with_robot),
        ["robot.cable_offset_mm", "actuation.load_g"]
    );
    assert_eq!(names(&in_list), ["cable[0].offset_mm", "cable[0].load_g"]);

    // And is the same problem to the paper's model.
    let problem = |scene| format!("{:?}", Problem::new(scene).unwrap());
    assert_eq!(problem(&with_robot), problem(&in_list));
    let mut other = Scene::default();
    other.take_drives(&in_list);
    assert_eq!(other.pull_mm(), 5.0);
}

#[test]
fn scenes_half_edited_have_no_cable_and_no_panic() {
    let mut none = Scene {
        actuation: None,
        ..Scene::default()
    };
    assert_eq!(none.cable_count(), 0);
    none.set_pull_mm(3.0);
    none.set_offset_mm(3.0);
    none.robot.segments_per_bay = 0;
    let read = (none.pull_mm(), none.offset_mm(), none.rim_mm());
    assert_eq!((read, none.last_disk()), ((0.0, 0.0, 0.0), 0));
    assert!(!none.faults().is_empty());
}

#[test]
fn cables_are_described_one_way_or_the_other() {
    let both = "stands beside [[cable]], and cables are described one way or the other; remove robot.cable_offset_mm and [actuation], or every [[cable]]";
    check_edit(
        "segments = 18",
        "segments = 18\ncable_offset_mm = 8",
        &[&format!("robot.cable_offset_mm {both}")],
    );
    check_edit(
        "[contact]",
        "[actuation]\npull_mm = 1\n[contact]",
        &[&format!("actuation {both}")],
    );
    check_edit(
        "segments = 18",
        "segments = 18\ncable_diameter_mm = 1",
        &[
            "robot.cable_diameter_mm stands beside [[cable]], and there each cable has its own; write it as diameter_mm under each [[cable]]",
        ],
    );
    let (head, _) = FULL.split_once("[actuation]").unwrap();
    check(
        head,
        &["actuation is missing; add a table headed [actuation] for what drives the robot"],
    );
    let neither = head.replace("cable_offset_mm = 8.0", "");
    check(
        &neither,
        &[
            "actuation is missing; add robot.cable_offset_mm with a table headed [actuation] for one cable, or a table under its own [[cable]] for each",
        ],
    );
    check(
        &format!("cable = []\n{neither}"),
        &[
            "actuation is missing; add robot.cable_offset_mm with a table headed [actuation] for one cable, or a table under its own [[cable]] for each",
        ],
    );
}

#[test]
fn a_cable_has_exactly_one_drive() {
    check_edit(
        "load_g = 300.0",
        "load_g = 300.0\npull_mm = 3",
        &["cable[0].load_g stands beside pull_mm; remove one of them"],
    );
    check_edit(
        "pull_mm = -2.0",
        "",
        &[
            "cable[1].pull_mm is missing; add the length of cable drawn in, negative to let cable out, a number of millimetres, from -100000 to 100000; or load_g, the weight that hangs on the cable, a number of grams, from 0 to 1000000",
        ],
    );
    check(
        &FULL.replace("pull_mm = 5.0", "pull_mm = 5.0\nload_g = 3"),
        &["actuation.load_g stands beside pull_mm; remove one of them"],
    );
    check(&FULL.replace("pull_mm = 5.0", "load_g = 3"), &[]);
}

#[test]
fn numbers_of_cables_are_kept_in_range() {
    for (old, new, expected) in [
        (
            "offset_mm = 8.5",
            "offset_mm = 0",
            "cable[0].offset_mm is 0 mm; set it to a value from 0.01 to 10000, or from -10000 to -0.01 mm",
        ),
        (
            "offset_mm = -7.5",
            "offset_mm = -20000",
            "cable[1].offset_mm is -20000 mm; set it to a value from -10000 to 10000 mm",
        ),
        (
            "load_g = 300.0",
            "load_g = -1",
            "cable[0].load_g is -1 g; set it to a value from 0 to 1000000 g",
        ),
        (
            "pull_mm = -2.0",
            "pull_mm = nan",
            "cable[1].pull_mm is nan, not a number; set it to a value from -100000 to 100000 mm",
        ),
        (
            "to_disk = 7",
            "to_disk = 0",
            "cable[1].to_disk is 0; set it to a value from 1 to 100000",
        ),
        (
            "to_disk = 7",
            "to_disk = 10",
            "cable[1].to_disk is 10; set it to a value from 1 to the last disk, 9",
        ),
        (
            "20000.0",
            "0",
            "cable[1].axial_stiffness_n is 0 N; set it to a value from 1e-6 to 1000000000000 N",
        ),
        (
            "diameter_mm = 0.5",
            "diameter_mm = -0.5",
            "cable[0].diameter_mm is -0.5 mm; set it to a value from 0 to 10000 mm",
        ),
        (
            "segments = 18",
            "segments = 18\ndisk_radius_mm = 8.25",
            "robot.disk_radius_mm is 8.25 mm; set it to a value from cable[0].offset_mm, 8.5, to 10000 mm",
        ),
        (
            "to_disk = 7",
            "to_disk = 7.5",
            "cable[1].to_disk is 7.5, a number with a decimal point; it must be a whole number, from 1 to 100000",
        ),
        (
            "20000.0",
            "\"stiff\"",
            "cable[1].axial_stiffness_n is \"stiff\", a string; it must be a number of newtons, from 1e-6 to 1000000000000",
        ),
        (
            "to_disk",
            "to_disc",
            "cable[1].to_disc is not a key of a scene; did you mean `to_disk`?",
        ),
        (
            "\"sliding\"",
            "\"slides\"",
            "model.mechanics is \"slides\"; did you mean `sliding`?",
        ),
        (
            "[[cable]]",
            "[[cables]]",
            "cables is not a key of a scene; did you mean `cable`?",
        ),
    ] {
        check_edit(old, new, &[expected]);
    }
    let other_side = CABLES.replace("= -7.5", "= -9").replacen(
        "segments = 18",
        "segments = 18\ndisk_radius_mm = 8.75",
        1,
    );
    check(
        &other_side,
        &[
            "robot.disk_radius_mm is 8.75 mm; set it to a value from the amount of cable[1].offset_mm, 9, to 10000 mm",
        ],
    );
    let cable = "[[cable]]\noffset_mm = 8.5\nload_g = 1\n";
    let many = CABLES.replacen("[contact]", &format!("{}[contact]", cable.repeat(15)), 1);
    check(
        &many,
        &["cable has 17 entries; at most 16 are allowed: remove 1"],
    );
}

#[test]
fn listed_nodes_are_on_lines_that_are_there() {
    for (new, expected) in [
        (
            "line = \"cable\", cable = 2, node = 14",
            "contact.listed[0].cable is 2; set it to a value from 0 to the last cable, 1",
        ),
        (
            "line = \"cable\", cable = 16, node = 14",
            "contact.listed[0].cable is 16; set it to a value from 0 to 15",
        ),
        (
            "line = \"backbone\", cable = 1, node = 14",
            "contact.listed[0].cable is 1, and the node is on no cable; leave it out",
        ),
        (
            "line = \"cable\", cable = 1, node = 15",
            "contact.listed[0].node is 15; set it to a value from 1 to the end of cable[1], 14",
        ),
        (
            "line = \"rim\", node = 7",
            "contact.listed[0].node is 7, a node without a disk, and so without a rim, as robot.segments_per_bay is 2; name a node that it divides",
        ),
        (
            "line = \"rim\", node = 8",
            "contact.listed[1] is the same node as contact.listed[0]; remove one of them",
        ),
    ] {
        check_edit("line = \"cable\", cable = 1, node = 14", new, &[expected]);
    }
    check_edit(
        "line = \"cable\", cable = 1, node = 14",
        "line = \"cable\", node = 18",
        &[],
    );
}

#[test]
fn a_listed_rim_keeps_both_ends_of_its_disk_out() {
    let wall = Shape::Wall {
        point_mm: [40.0, 100.0],
        rotation_deg: 180.0,
        corner_radius_mm: 0.0,
    };
    let mut scene = Scene {
        obstacles: vec![wall.into()],
        ..Scene::default()
    };
    scene.robot.disk_radius_mm = Some(10.0);
    // Only a body has a thickness.
    scene.robot.disk_thickness_mm = 3.0;
    scene.set_pull_mm(6.0);
    scene.contact = Contact {
        candidates: Candidates::Listed,
        listed: vec![Listed {
            line: Line::Rim,
            cable: 0,
            node: 18,
        }],
    };
    assert_eq!(scene.faults(), []);
    let robot = Robot::of(&scene);
    let ends: Vec<_> = robot
        .candidates(&scene.contact)
        .iter()
        .map(|end| (end.line, end.node, end.lever(), end.radius))
        .collect();
    let [near, far] = [robot::Line::RimCableSide, robot::Line::RimFarSide];
    assert_eq!(ends, [(near, 18, 0.010, 0.0), (far, 18, 0.010, 0.0)]);
    let solution = solve(
        &Problem::new(&scene).unwrap(),
        Start::Straight,
        Settings::default(),
    );
    assert!(solution.certificate.holds());
    let pressing: Vec<_> = solution.contacts.iter().map(|found| found.line).collect();
    assert_eq!(pressing, [near]);
}

#[test]
fn what_a_stiffness_decides_needs_one() {
    let needs = |value: &str| {
        format!(
            "{value}, and what that does to the robot depends on its stiffness; set robot.bending_stiffness_nmm2"
        )
    };
    check_edit(
        "bending_stiffness_nmm2 = 8000.0",
        "",
        &[
            &needs("cable[0].load_g is 300 g"),
            &needs("cable[1].axial_stiffness_n is 20000 N"),
        ],
    );
    let without = FULL.replace("bending_stiffness_nmm2 = 8700.0", "");
    check(
        &without,
        &[
            &needs("loads.tip_force_n is [0.25, -0.15] N"),
            &needs("loads.gravity_m_s2 is [0.375, -9.80665] m/s²"),
            &needs("loads.tip_moment_nmm is 12.5 N mm"),
        ],
    );
    // Under the paper's model, too, a load needs it.
    let mut equal = Scene {
        actuation: Some(Actuation {
            drive: Drive::LoadG(300.0),
        }),
        ..Scene::default()
    };
    assert_eq!(
        equal.check().unwrap_err().to_string(),
        needs("actuation.load_g is 300 g")
    );
    equal.robot.bending_stiffness_nmm2 = Some(8000.0);
    assert_eq!(equal.faults(), []);
}

#[test]
fn the_papers_model_refuses_what_it_does_not_know() {
    let slide = "leave it out, or set model.mechanics to \"sliding\"";
    let equal = |text: &str| text.replace("\"sliding\"", "\"equal\"");
    check(
        &equal(FULL),
        &[
            &format!(
                "robot.disk_mass_g is 1.25 g, and nothing weighs in the paper's model; {slide}"
            ),
            &format!(
                "robot.backbone_mass_g is 4.5 g, and nothing weighs in the paper's model; {slide}"
            ),
            &format!("friction.holes is 0.275, and nothing rubs in the paper's model; {slide}"),
            &format!("friction.contacts is 0.225, and nothing rubs in the paper's model; {slide}"),
            &format!("friction.base_loss is 0.165, and nothing rubs in the paper's model; {slide}"),
            &format!(
                "loads.tip_force_n is [0.25, -0.15] N, and nothing acts on the paper's model but its cable and obstacles; {slide}"
            ),
            &format!(
                "loads.gravity_m_s2 is [0.375, -9.80665] m/s², and nothing acts on the paper's model but its cable and obstacles; {slide}"
            ),
            &format!(
                "loads.tip_moment_nmm is 12.5 N mm, and nothing acts on the paper's model but its cable and obstacles; {slide}"
            ),
        ],
    );
    check(
        &equal(CABLES),
        &[
            "cable has 2 entries, and the robot of the paper's model has one cable; remove 1, or set model.mechanics to \"sliding\"",
        ],
    );
    let mut scene = one_in_a_list(Drive::PullMm(2.0));
    scene.cables[0].offset_mm = -8.0;
    scene.cables[0].to_disk = Some(8);
    scene.cables[0].axial_stiffness_n = Some(2e4);
    let told: Vec<_> = scene.faults().iter().map(ToString::to_string).collect();
    assert_eq!(
        told,
        [
            "cable[0].offset_mm is -8 mm, and the cable of the paper's model is on the +x side; make it positive, or set model.mechanics to \"sliding\"".to_owned(),
            format!(
                "cable[0].to_disk is 8, and the cable of the paper's model ends at the last, 9; {slide}"
            ),
            format!(
                "cable[0].axial_stiffness_n is 20000 N, and the cable of the paper's model does not stretch; {slide}"
            ),
        ]
    );
    // What is named and changes nothing is no fault.
    scene.cables[0].offset_mm = 8.0;
    scene.cables[0].to_disk = Some(9);
    scene.cables[0].axial_stiffness_n = None;
    assert_eq!(scene.faults(), []);
    scene.model.mechanics = Mechanics::Sliding;
    assert_eq!(scene.faults(), []);
}

#[test]
fn a_number_with_its_unit_is_told_apart() {
    check_edit(
        "= 20000.0",
        "= 20000 N",
        &[
            "line 25, column 21 is not valid TOML: write the number alone, `axial_stiffness_n = 20000`; the end of its key names the unit, newtons",
        ],
    );
}
