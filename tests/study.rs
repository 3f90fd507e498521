//! Studies of a design: the same bits whoever computes them, samples that are what a
//! solve of their scene gives, and files and scenes that make no study.

use std::thread;

use sinew::equilibrium::{Occurrence, Run, Settings, Solved, Start, Status, solve};
use sinew::forces::Stiffness;
use sinew::mechanics::Problem;
use sinew::record;
use sinew::scene::Scene;
use sinew::study::{Output, Row, Study, StudyFile, Verdict, checksum, log};

const TWO_DISCS: &str = include_str!("../assets/scenes/two-discs.toml");
const TWO_POSTS: &str = include_str!("../assets/scenes/two-posts.toml");
const BUILT_IN: &str = include_str!("../assets/studies/spacing-and-offset.toml");

fn study_of(scene: &str, file: &str) -> Study {
    let scene = Scene::from_toml(scene).unwrap();
    Study::new(StudyFile::from_toml(file).unwrap(), scene).unwrap()
}

/// The paper's model over number of segments, offset and pull; some samples fail.
fn papers() -> Study {
    study_of(
        TWO_DISCS,
        r#"
        version = 1
        scene = "two-discs.toml"
        sampler = "sobol"
        samples = 64
        seed = 5
        outputs = ["tip_x_mm", "tip_slope_deg", "force_max_n", "tension_n", "clearance_min_mm",
                   "first_contact_load_g", "swept_mm2", "reached_share", "jumps"]
        constraints = ["energy_nmm < 5"]
        parameter = [
            { key = "robot.disks", from = 3, to = 22 },
            { key = "robot.cable_offset_mm", from = -0.5, to = 14 },
            { key = "actuation.pull_mm", from = 0.5, to = 12 },
        ]
        "#,
    )
}

/// A sliding cable that rubs.
fn rubbing() -> Study {
    study_of(
        TWO_POSTS,
        r#"
        version = 1
        scene = "two-posts.toml"
        outputs = ["tip_x_mm", "force_max_n", "tension_n", "load_g", "first_contact_load_g"]
        parameter = [
            { key = "robot.disk_spacing_mm", values = [20, 30, 45] },
            { key = "robot.cable_offset_mm", from = 6, to = 10, steps = 2 },
            { key = "friction.holes", values = [0.275] },
            { key = "friction.base_loss", values = [0.165] },
            { key = "actuation.pull_mm", values = [5.55] },
        ]
        "#,
    )
}

fn rows(study: &Study, indices: impl Iterator<Item = u64>) -> Vec<Row> {
    indices.map(|index| study.compute(index)).collect()
}

/// Every bit of rows that begin a study.
fn hash(rows: &[Row]) -> u64 {
    checksum(&log::chunk(0, rows))
}

#[test]
fn a_study_of_the_papers_model_has_these_bits() {
    let study = papers();
    let all = rows(&study, 0..64);
    let verdicts: Vec<Verdict> = all.iter().map(|row| row.verdict).collect();
    assert!(verdicts.contains(&Verdict::Converged));
    assert!(verdicts.contains(&Verdict::BadScene), "{verdicts:?}");
    assert_eq!(format!("{:016x}", hash(&all)), "6ddcc5d741928030");
}

#[test]
fn the_order_and_the_thread_change_no_bit() {
    for study in [papers(), rubbing()] {
        let count = study.samples();
        let expected = hash(&rows(&study, 0..count));
        let mut backwards = rows(&study, (0..count).rev());
        backwards.reverse();
        assert_eq!(hash(&backwards), expected);
        // Every third on a thread of its own.
        let mut all: Vec<Option<Row>> = vec![None; count as usize];
        thread::scope(|scope| {
            let of = |one: u64| {
                let study = &study;
                scope.spawn(move || rows(study, (one..count).step_by(3)))
            };
            let threads = [of(0), of(1), of(2)];
            for (one, thread) in threads.into_iter().enumerate() {
                for (turn, row) in thread.join().unwrap().into_iter().enumerate() {
                    all[one + 3 * turn] = Some(row);
                }
            }
        });
        let all: Vec<Row> = all.into_iter().map(Option::unwrap).collect();
        assert_eq!(hash(&all), expected);
        // It can fail.
        let mut other = all.clone();
        let number = &mut other[1].numbers[0];
        *number = number.next_up();
        assert_ne!(hash(&other), expected);
    }
}

/// A sample's outputs against the record of a solve of its scene.
fn check_sample(study: &Study, index: u64) -> Solved {
    let scene = study.sample(index).1.unwrap();
    // As it would be in a file.
    let scene = Scene::from_toml(&scene.to_toml().unwrap()).unwrap();
    let problem = Problem::new(&scene).unwrap();
    let solved = solve(&problem, Start::Straight, Settings::default());
    let mut run = Run::new(&problem, Start::Straight, Settings::default());
    run.finish();
    let stiffness = Stiffness::of_scene(&scene).unwrap();
    let record = record::Solution::of(&run, stiffness).unwrap();
    let row = study.compute(index);
    assert_eq!(row.verdict.word(), record.status, "{index}");
    let value = |output| {
        let place = study.computed().iter().position(|one| *one == output);
        place.map(|place| row.numbers[place])
    };
    let check = |output: Output, expected: f64| {
        let Some(found) = value(output) else { return };
        let close = (found - expected).abs() <= 1e-12 * expected.abs();
        assert!(close, "{index} {}: {found} and {expected}", output.name());
    };
    if solved.status != Status::Converged {
        return solved;
    }
    let forces: Vec<f64> = record.contacts.iter().filter_map(|c| c.force_n).collect();
    check(Output::TipX, record.tip_mm[0]);
    check(Output::TipY, record.tip_mm[1]);
    check(Output::TipSlope, record.tip_slope_rad.to_degrees());
    check(Output::Energy, record.energy_nmm.unwrap());
    check(Output::ForceMax, forces.iter().copied().fold(0.0, f64::max));
    check(Output::ForceTotal, forces.iter().sum());
    check(Output::Tension, record.cables[0].tension_n.unwrap());
    check(Output::Load, record.cables[0].load_n.unwrap() / 9.80665e-3);
    check(Output::Pull, record.cables[0].pull_mm);
    solved
}

#[test]
fn a_sample_is_what_a_solve_of_its_scene_gives() {
    let file = |key: &str, values: &str, pull: &str| {
        format!(
            r#"
            version = 1
            scene = "scene.toml"
            outputs = ["tip_x_mm", "tip_y_mm", "tip_slope_deg", "energy_nmm", "force_max_n",
                       "force_total_n", "tension_n", "load_g", "pull_mm"]
            parameter = [
                {{ key = "robot.disk_spacing_mm", values = [20, 22.5, 36] }},
                {{ key = "{key}", values = [{values}] }},
                {{ key = "actuation.{pull}", values = [{}] }},
            ]
            "#,
            if pull == "load_g" {
                "150, 420"
            } else {
                "2, 5.5"
            }
        )
    };
    let friction = "friction.holes";
    for (scene, key, values, pull) in [
        (TWO_DISCS, "robot.cable_offset_mm", "6, 9", "pull_mm"),
        (TWO_POSTS, friction, "0, 0.3", "pull_mm"),
        (TWO_POSTS, friction, "0, 0.3", "load_g"),
    ] {
        let study = study_of(scene, &file(key, values, pull));
        let mut pressing = 0;
        for index in 0..study.samples() {
            let solved = check_sample(&study, index);
            pressing += usize::from(!solved.contacts.is_empty());
        }
        assert!(pressing > 2, "{pressing} of {} press", study.samples());
    }
}

#[test]
fn with_friction_the_load_below_the_base_is_more_than_the_tension() {
    let study = rubbing();
    for index in 0..study.samples() {
        let row = study.compute(index);
        if row.verdict != Verdict::Converged {
            continue;
        }
        let [_, _, tension, load, first] = row.numbers[..] else {
            panic!("{row:?}");
        };
        // Below the base η = 0.835 of the load is left, and of that the base's hole takes a
        // little, e^{−μθ} with the angle θ of the first stretch, a few hundredths.
        let tension_g = tension / 9.80665e-3;
        let kept = tension_g / load / 0.835;
        assert!((0.98..1.0).contains(&kept), "{index}: {kept}");
        assert!(first > 0.0 && first < load, "{index}: {first} of {load}");
    }
}

#[test]
fn the_load_at_first_contact_is_a_free_robots_there() {
    let study = study_of(
        TWO_POSTS,
        r#"
        version = 1
        scene = "two-posts.toml"
        outputs = ["first_contact_load_g", "first_contact_pull_mm"]
        parameter = [{ key = "actuation.pull_mm", values = [1, 5.55] }]
        "#,
    );
    // It has not got there.
    assert!(
        study
            .compute(0)
            .numbers
            .iter()
            .all(|number| number.is_nan())
    );
    let [load, pull] = study.compute(1).numbers[..] else {
        panic!()
    };
    let scene = study.sample(1).1.unwrap();
    let solved = solve(
        &Problem::new(&scene).unwrap(),
        Start::Straight,
        Settings::default(),
    );
    let made = solved.events.iter();
    let mut made = made.filter(|event| matches!(event.what, Occurrence::ContactMade { .. }));
    let first = made.next().unwrap();
    assert!((pull - 1e3 * first.pull).abs() < 1e-9, "{pull}");
    // The load that holds the free robot at that pull, followed from the straight one.
    let mut free = scene.clone();
    free.obstacles.clear();
    free.set_pull_mm(pull);
    let free = solve(
        &Problem::new(&free).unwrap(),
        Start::Straight,
        Settings::default(),
    );
    let per_bend = 8000e-6 / (2.0 * 0.01);
    let expected = per_bend * free.cables[0].load / 9.80665e-3;
    assert!(
        (load - expected).abs() < 1e-7 * expected,
        "{load} and {expected}"
    );
}

#[test]
fn outputs_of_a_free_robot_are_what_they_say() {
    let scene = TWO_DISCS.split("[[obstacle]]").next().unwrap();
    let measured = "[measured]\npoints_mm = [[0, 0], [0, 90], [0, 180]]\nnodes = [0, 9, 18]";
    let study = study_of(
        &format!("{scene}\n{measured}"),
        r#"
        version = 1
        scene = "scene.toml"
        outputs = ["tip_x_mm", "tip_y_mm", "reach_mm", "target_distance_mm", "profile_rms_mm",
                   "swept_mm2", "bend_max_deg", "tip_slope_deg", "reached_share", "contacts",
                   "force_max_n", "clearance_min_mm", "first_contact_pull_mm", "end_pull_mm"]
        target_mm = [3, 4]
        parameter = [{ key = "actuation.pull_mm", values = [4] }]
        "#,
    );
    let row = study.compute(0);
    let [
        x,
        y,
        reach,
        target,
        rms,
        swept,
        bend,
        slope,
        share,
        contacts,
        force,
        rest @ ..,
    ] = &row.numbers[..]
    else {
        panic!("{row:?}");
    };
    let close = |found: f64, expected: f64| {
        assert!(
            (found - expected).abs() < 1e-9 * expected.abs(),
            "{found} and {expected}"
        );
    };
    close(*reach, x.hypot(y - 180.0));
    close(*target, (x - 3.0).hypot(y - 4.0));
    // All segments bend alike, and the tip is turned by what they do together.
    close(18.0 * bend, *slope);
    assert_eq!([*share, *contacts, *force], [1.0, 0.0, 0.0]);
    // No obstacle, no contact, no end: no such numbers.
    assert!(
        rest.len() == 3 && rest.iter().all(|number| number.is_nan()),
        "{rest:?}"
    );

    // The shape and its way at single pulls.
    let problem = |pull_mm: f64| {
        let mut scene = study.scene().clone();
        scene.set_pull_mm(pull_mm);
        let solved = solve(
            &Problem::new(&scene).unwrap(),
            Start::Straight,
            Settings::default(),
        );
        solved
            .backbone()
            .map(|at| [1e3 * at.x, 1e3 * at.y])
            .collect::<Vec<_>>()
    };
    let shape = problem(4.0);
    let squares = [0, 9, 18].map(|node| {
        let [x, y] = shape[node];
        x * x + (y - 10.0 * node as f64).powi(2)
    });
    close(*rms, (squares.iter().sum::<f64>() / 3.0).sqrt());
    let tips: Vec<[f64; 2]> = (0..=200)
        .map(|part| problem(0.02 * f64::from(part))[18])
        .collect();
    let area: f64 = tips
        .windows(2)
        .map(|two| 0.5 * (two[0][0] * two[1][1] - two[0][1] * two[1][0]).abs())
        .sum();
    // By 32 parts of the way: a chord of an arc of 1/32 rad lacks 1e-4 of it.
    assert!((swept - area).abs() < 2e-4 * area, "{swept} and {area}");
}

#[test]
fn the_least_clearance_is_none_where_the_robot_presses() {
    let study = study_of(
        TWO_DISCS,
        r#"
        version = 1
        scene = "two-discs.toml"
        outputs = ["clearance_min_mm", "contacts"]
        parameter = [{ key = "actuation.pull_mm", values = [3, 4.9] }]
        "#,
    );
    let [free, held] = [0, 1].map(|index| study.compute(index).numbers);
    assert_eq!(held, [0.0, 2.0]);
    let scene = study.sample(0).1.unwrap();
    let problem = Problem::new(&scene).unwrap();
    let solved = solve(&problem, Start::Straight, Settings::default());
    // The nearest of the nodes of backbone and cable, the posts being two circles.
    let posts = [[33.0, 89.0, 12.5], [59.0, 140.0, 15.0]];
    let points = solved.backbone().skip(1).chain(solved.cable().skip(1));
    let clearances = points
        .flat_map(|at| posts.map(|[x, y, radius]| (1e3 * at.x - x).hypot(1e3 * at.y - y) - radius));
    let least = clearances.fold(f64::INFINITY, f64::min);
    assert!((free[0] - least).abs() < 1e-9, "{} and {least}", free[0]);
    assert!(least > 1.0 && free[1] == 0.0);
}

#[test]
fn jumps_and_where_there_is_no_shape_any_more_are_told_of_the_sample() {
    let file = |values: &str| {
        format!(
            r#"
            version = 1
            scene = "scene.toml"
            outputs = ["tip_x_mm", "end_pull_mm", "reached_share", "jumps"]
            parameter = [{{ key = "actuation.pull_mm", values = [{values}] }}]
            "#
        )
    };
    // As its file says, the robot jumps at 7.08 mm.
    let slip_off = include_str!("../assets/scenes/slip-off.toml");
    let study = study_of(slip_off, &file("7.0, 7.2"));
    for (index, expected) in [(0, 0.0), (1, 1.0)] {
        let row = study.compute(index);
        let [x, end, share, jumps] = row.numbers[..] else {
            panic!("{row:?}");
        };
        assert!(x.is_finite() && end.is_nan(), "{row:?}");
        assert_eq!([share, jumps], [1.0, expected]);
    }
    // Posts between which it gets stuck.
    let wedge = include_str!("../assets/scenes/wedge.toml");
    let study = study_of(wedge, &file("20"));
    let row = study.compute(0);
    let [x, end, share, _] = row.numbers[..] else {
        panic!("{row:?}");
    };
    assert_eq!(row.verdict, Verdict::Infeasible);
    assert!(x.is_nan() && (end - 20.0 * share).abs() < 1e-9, "{row:?}");
    let near = study_of(wedge, &file(&format!("{}, {}", end - 0.01, end + 0.01)));
    let verdicts = [0, 1].map(|index| near.compute(index).verdict);
    assert_eq!(verdicts, [Verdict::Converged, Verdict::Infeasible]);
}

#[test]
fn a_sample_that_fails_says_why() {
    let study = papers();
    let mut bad = 0;
    for index in 0..study.samples() {
        let row = study.compute(index);
        assert_eq!(row.verdict == Verdict::Converged, row.reason.is_empty());
        if row.verdict == Verdict::BadScene {
            bad += 1;
            assert!(
                row.reason.contains("robot.cable_offset_mm"),
                "{}",
                row.reason
            );
            assert!(row.numbers.iter().all(|number| number.is_nan()));
        }
    }
    assert!(bad > 0);
}

#[test]
fn the_built_in_study_can_be_computed() {
    let study = study_of(TWO_POSTS, BUILT_IN);
    assert_eq!(study.samples(), 13 * 41);
    // 8 disks, the cable 9 mm out and the rim 11.
    let index = 9 * 41 + 20;
    let values = study.values(index);
    assert_eq!(values, [22.5, 9.0, 11.0, 0.275, 0.275, 0.165]);
    let row = study.compute(index);
    assert_eq!(row.verdict, Verdict::Converged, "{}", row.reason);
    let least = row.numbers[..6]
        .iter()
        .copied()
        .fold(f64::INFINITY, f64::min);
    assert!(least > 0.0, "{:?}", row.numbers);
}

/// Checks what is told of a study's file, or of it with the scene.
#[track_caller]
fn check_told(scene: &str, edit: (&str, &str), expected: &str) {
    let text = r#"
version = 1
scene = "scene.toml"
outputs = ["force_max_n"]
constraints = ["force_max_n < 0.2"]
[[parameter]]
key = "robot.cable_offset_mm"
from = 4
to = 14
steps = 40
"#;
    assert!(text.contains(edit.0), "{}", edit.0);
    let text = text.replace(edit.0, edit.1);
    let scene = Scene::from_toml(scene).unwrap();
    let told = match StudyFile::from_toml(&text) {
        Ok(file) => Study::new(file, scene).unwrap_err(),
        Err(told) => told,
    };
    assert_eq!(told.to_string(), expected);
}

#[test]
fn what_makes_no_study_is_told() {
    let check = |edit, expected: &str| check_told(TWO_DISCS, edit, expected);
    check(
        ("from = 4\nto = 14", "from = 14\nto = 4"),
        "parameter[0].to is 4, and from is 14; exchange them: values rise from `from` to `to`",
    );
    check(
        ("from = 4\nto = 14", "from = 4\nto = 4"),
        "parameter[0].to is 4, and from is 4; give a range with a length, or values = [..] with \
         the one value",
    );
    check(
        ("from = 4\nto = 14\nsteps = 40", "values = []"),
        "parameter[0].values has 0 values; give 1 to 100000",
    );
    check(
        ("steps = 40", "steps = 1000000000000000000"),
        "the study has 1000000000000000000 samples, and at most 1000000000 can be asked for; take \
         fewer steps, or sampler = \"sobol\" with samples = 100000",
    );
    check(
        ("cable_offset_mm", "cable_ofset_mm"),
        "parameter[0].key: robot.cable_ofset_mm is not a key of a scene; did you mean \
         `cable_offset_mm`?",
    );
    check(
        ("[\"force_max_n\"]", "[\"force_maxn\"]"),
        "outputs[0], \"force_maxn\", is not an output; did you mean `force_max_n`?",
    );
    check(
        ("force_max_n < 0.2", "force_mx_n < 0.2"),
        "constraints[0] names `force_mx_n`, which is no output; did you mean `force_max_n`?",
    );
    check(
        ("constraints =", "constraint ="),
        "constraint is not a key of a study; did you mean `constraints`?",
    );
    check(
        ("version = 1", "version = 2"),
        "version is 2; this program reads version 1",
    );
    check(
        ("version = 1", "version = 1 1"),
        "line 2 is not valid TOML: string values must be quoted, expected literal string",
    );
    let without = TWO_DISCS.replace("bending_stiffness_nmm2 = 8000", "");
    check_told(
        &without,
        ("steps = 40", "steps = 40"),
        "outputs asks for force_max_n, which needs robot.bending_stiffness_nmm2; give it in the \
         scene, or as a parameter",
    );
    let odd = TWO_DISCS.replace("segments_per_bay = 2", "segments_per_bay = 5");
    check_told(
        &odd,
        ("steps = 40", "steps = 40"),
        "its scene: robot.segments_per_bay is 5, which does not divide robot.segments, 18, so \
         that no disk sits at the tip; set it to 1, or set segments to 15 or 20",
    );
}

#[test]
fn a_fault_that_a_parameter_changes_is_a_samples_own() {
    // The scene by itself has no length that its disks divide.
    let odd = TWO_DISCS.replace("segments = 18", "segments = 17");
    let study = study_of(
        &odd,
        r#"
        version = 1
        scene = "scene.toml"
        outputs = ["tip_x_mm"]
        parameter = [{ key = "robot.segments", values = [17, 18] }]
        "#,
    );
    assert_eq!(study.compute(0).verdict, Verdict::BadScene);
    assert_eq!(study.compute(1).verdict, Verdict::Converged);
}

#[test]
fn the_digest_is_of_all_that_results_depend_on() {
    let file = StudyFile::from_toml(BUILT_IN).unwrap();
    let scene = Scene::from_toml(TWO_POSTS).unwrap();
    let digest =
        |file: &StudyFile, scene: &Scene| Study::new(file.clone(), scene.clone()).unwrap().digest();
    let known = digest(&file, &scene);
    let mut other = file.clone();
    other.title = None;
    other.scene = "elsewhere.toml".to_owned();
    assert_eq!(digest(&other, &scene), known);
    other.outputs.push("jumps".to_owned());
    assert_ne!(digest(&other, &scene), known);
    let mut moved = scene.clone();
    moved.set("obstacle[0].radius_mm", "12.6").unwrap();
    assert_ne!(digest(&file, &moved), known);
}

#[test]
fn a_file_that_is_written_is_read() {
    let file = StudyFile::from_toml(BUILT_IN).unwrap();
    assert_eq!(StudyFile::from_toml(&file.to_toml()), Ok(file));
}
