//! Friction of cables in their holes: cycles of loading and unloading by an independent
//! solver, the laws of every hole, and the certificate's own reading of them.

mod random_scene;

use proptest::strategy::{Strategy, ValueTree};
use proptest::test_runner::TestRunner;
use serde_json::Value;
use sinew::equilibrium::{EndReason, Occurrence, Run, Settings, Solved, Start, Status, solve};
use sinew::forces::Statics;
use sinew::geometry::Vector;
use sinew::mechanics::{Input, Problem, Slip};
use sinew::scene::{Candidates, Friction, Mechanics, Scene};

const CYCLES: &str = include_str!("cases/capstan_cycles.json");

fn cycles() -> Vec<Value> {
    let file: Value = serde_json::from_str(CYCLES).unwrap();
    file["cycles"].as_array().unwrap().clone()
}

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap()
}

fn numbers(value: &Value) -> Vec<f64> {
    value.as_array().unwrap().iter().map(number).collect()
}

fn scene(text: &str) -> Problem {
    let head = "version = 2\n[robot]\nlength_mm = 180\nsegments = 18\nsegments_per_bay = 2\n\
                cable_offset_mm = 8\nbending_stiffness_nmm2 = 8000\n";
    let scene = Scene::from_toml(&format!("{head}{text}")).unwrap();
    Problem::new(&scene).unwrap()
}

/// The same problem with another input of its cable, in newtons or metres.
fn with_input(problem: &Problem, input: Input) -> Problem {
    let mut drive = problem.drive().clone();
    drive.cables[0].input = input;
    let mut problem = problem.clone();
    problem.set_drive(&drive);
    problem
}

fn per_bend(solved: &Solved) -> f64 {
    let stiffness = solved.drive.stiffness.unwrap();
    stiffness / (2.0 * solved.problem().robot().segment_length())
}

fn close(found: f64, expected: f64, allowed: f64) {
    let missed = (found - expected).abs();
    assert!(missed <= allowed, "{found} for {expected}: {missed:e}");
}

/// Follows a cycle of the file and compares every row that it keeps.
fn follow(cycle: &Value, problem: &Problem) {
    let key = cycle["input"].as_str().unwrap();
    let input = |value: f64| match key {
        "weight_N" => Input::Load(value),
        _ => Input::Pull(1e-3 * value),
    };
    let mut run = Run::new(
        &with_input(problem, input(0.0)),
        Start::Straight,
        Settings::default(),
    );
    run.finish();
    let scale = cycle["rows"].as_array().unwrap().iter();
    let most = scale
        .map(|row| number(&row["weight_N"]))
        .fold(0.0, f64::max);
    for row in cycle["rows"].as_array().unwrap() {
        run.retarget(&with_input(problem, input(number(&row[key]))));
        run.finish();
        let solved = run.solved();
        assert_eq!(solved.status, Status::Converged, "{row}");
        assert!(solved.certificate.holds(), "{:?}", solved.certificate);
        let newtons = per_bend(&solved);
        close(1e3 * solved.cables[0].pull, number(&row["pull_mm"]), 1e-4);
        close(
            newtons * solved.cables[0].load,
            number(&row["weight_N"]),
            1e-4 * most,
        );
        for (found, expected) in solved.tensions(0).iter().zip(numbers(&row["tensions_N"])) {
            close(newtons * found, expected, 1e-4 * most);
        }
        for (found, expected) in solved.bends.iter().zip(numbers(&row["bends_rad"])) {
            close(*found, expected, 1e-6);
        }
        let force = number(&row["contact_force_N"]);
        let found: f64 = solved
            .contacts
            .iter()
            .map(|contact| contact.multiplier)
            .sum();
        close(newtons * found, force.max(0.0), 1e-4 * most);
        for (slip, expected) in solved.strands[0]
            .slips
            .iter()
            .zip(numbers(&row["hole_status"]))
        {
            let told = match slip {
                Slip::In => 1.0,
                Slip::Out => -1.0,
                Slip::Sticks => 0.0,
            };
            // What did not move sticks, whatever the file says.
            assert!(
                told == expected || told == 0.0,
                "{slip:?} for {expected}: {row}"
            );
        }
    }
}

#[test]
fn cycles_of_a_load_and_of_a_pull_are_those_of_another_solver() {
    let problem = scene("[actuation]\nload_g = 0\n[friction]\nholes = 0.3\n");
    follow(&cycles()[0], &problem);
    let problem = scene("[actuation]\npull_mm = 0\n[friction]\nholes = 0.3\n");
    follow(&cycles()[1], &problem);
}

#[test]
fn a_wall_that_rubs_takes_the_force_of_another_solver() {
    let problem = scene(
        "[actuation]\nload_g = 0\n[friction]\nholes = 0.275\ncontacts = 0.275\n\
         [contact]\ncandidates = \"listed\"\nlisted = [{ line = \"cable\", node = 14 }]\n\
         [[obstacle]]\nshape = \"wall\"\npoint_mm = [31, 127]\nrotation_deg = 180\n",
    );
    follow(&cycles()[2], &problem);
}

/// A robot that leans on a post, by its nodes.
const ON_A_POST: &str = "[contact]\ncandidates = \"nodes\"\n[[obstacle]]\nshape = \"disc\"\n\
                         center_mm = [36, 100]\nradius_mm = 12\n";

fn follow_to(problem: &Problem) -> Solved {
    let solved = solve(problem, Start::Straight, Settings::default());
    assert_eq!(solved.status, Status::Converged);
    assert!(solved.certificate.holds(), "{:?}", solved.certificate);
    solved
}

#[test]
fn every_hole_takes_its_share_and_the_base_its_own() {
    let text = "[actuation]\nload_g = 300\n[friction]\nholes = 0.25\nbase_loss = 0.1\n";
    let solved = follow_to(&scene(text));
    let newtons = per_bend(&solved);
    close(newtons * solved.cables[0].load, 0.3 * 9.80665, 1e-12);
    // The cable stands on the base's disk and turns by half a bay's bend at every hole.
    let turns = solved.holes(0);
    let (mut below, mut tension) = (Vector::y(), 0.9 * 0.3 * 9.80665);
    for (ends, found) in turns.windows(2).zip(solved.tensions(0)) {
        let along = (ends[1] - ends[0]).normalize();
        tension *= libm::exp(-0.25 * libm::acos(below.dot(&along).min(1.0)));
        close(newtons * found, tension, 1e-8);
        below = along;
    }
}

#[test]
fn forces_balance_with_friction_in_holes_and_on_an_obstacle() {
    let text = "[actuation]\nload_g = 400\n[friction]\nholes = 0.3\ncontacts = 0.4\n";
    let solved = follow_to(&scene(&format!("{text}{ON_A_POST}")));
    assert!(
        solved
            .contacts
            .iter()
            .any(|contact| contact.friction != 0.0)
    );
    for contact in &solved.contacts {
        let resists = -contact.slid.signum() * 0.4 * contact.multiplier;
        close(contact.friction, resists, 1e-8 * contact.multiplier);
    }
    let statics = Statics::of_scale(&solved, 1.0);
    assert!(statics.balances(), "{statics:?}");
    // Two forces act on the base's disk: its mount, and what the cable leaves in its hole.
    let sum = statics.pressed.force + statics.clamp.force + statics.cable.force;
    assert!(sum.norm() < 1e-9 * statics.cable.force.norm());
}

#[test]
fn a_cable_held_fast_in_its_holes_keeps_every_stretch() {
    let text = "[actuation]\npull_mm = 5\n[friction]\nholes = 0\n";
    let free = scene(&format!("{text}{ON_A_POST}"));
    let mut held = free.clone();
    let mut drive = held.drive().clone();
    drive.friction.holes = 100.0;
    held.set_drive(&drive);
    let mut run = Run::new(&free, Start::Straight, Settings::default());
    run.finish();
    run.retarget(&held);
    run.finish();
    let stretches = |solved: &Solved| -> Vec<f64> {
        let holes = solved.holes(0);
        holes
            .windows(2)
            .map(|ends| (ends[1] - ends[0]).norm())
            .collect()
    };
    let before = run.solved();
    assert_eq!(before.status, Status::Converged);
    assert!(!before.contacts.is_empty());
    let mut moved = held.clone();
    moved.set_obstacle(0, held.obstacles()[0].moved(Vector::new(-2e-3, 0.0)));
    run.retarget(&moved);
    run.finish();
    let after = run.solved();
    assert_eq!(after.status, Status::Converged);
    let shift = (after.tip().position - before.tip().position).norm();
    assert!(shift > 1e-4, "nothing moved: {shift}");
    for (a, b) in stretches(&before).iter().zip(stretches(&after)) {
        close(b, *a, 1e-12);
    }
}

/// There, a bit back, half the way back, and there again. What is called good is
/// certified, holes' cones and directions with it, and hardly any run is given up.
#[test]
fn random_robots_are_pulled_there_and_back() {
    for (candidates, scenes) in [(Candidates::Nodes, 150), (Candidates::Body, 80)] {
        let strategy = random_scene::rubbing_scene(candidates);
        let mut runner = TestRunner::new(random_scene::config(1));
        let (mut ends, mut given_up) = (0, 0);
        for _ in 0..scenes {
            let scene = strategy.new_tree(&mut runner).unwrap().current();
            let Ok(problem) = Problem::new(&scene) else {
                continue;
            };
            let mut run = Run::new(&problem, Start::Straight, Settings::default());
            for share in [1.0, 0.9, 0.5, 1.0] {
                let input = match problem.drive().cables[0].input {
                    Input::Pull(pull) => Input::Pull(share * pull),
                    Input::Load(load) => Input::Load(share * load),
                };
                run.retarget(&with_input(&problem, input));
                let solution = run.finish();
                let (status, certificate) = (&solution.status, &solution.certificate);
                assert!(*status != Status::NumericalFailure, "{certificate:?}");
                ends += 1;
                if *status == Status::IterationLimit || is_unsettled(status) {
                    given_up += 1;
                } else {
                    assert!(certificate.holds(), "{status:?} {certificate:?}");
                }
            }
        }
        assert!(12 * given_up < ends, "{given_up} of {ends}");
    }
}

fn is_unsettled(status: &Status) -> bool {
    let Status::BranchEnded { reason, .. } = status else {
        return false;
    };
    *reason == EndReason::FrictionUnsettled
}

/// The tip sticks to the upper post until its cone is left; there it slips by two
/// millimetres and more, to where it is held again, and later slides.
#[test]
fn a_tip_that_sticks_slips_when_its_cone_is_left_and_the_run_goes_on() {
    let text = include_str!("../assets/scenes/two-discs.toml");
    let mut scene = Scene::from_toml(text).unwrap();
    scene.model.mechanics = Mechanics::Sliding;
    scene.friction = Friction {
        holes: 0.275,
        contacts: 0.275,
        base_loss: 0.165,
    };
    let mut at = |pull_mm: f64| {
        scene.set_pull_mm(pull_mm);
        let problem = Problem::new(&scene).unwrap();
        let solved = solve(&problem, Start::Straight, Settings::default());
        assert_eq!(solved.status, Status::Converged, "{pull_mm}");
        assert!(solved.certificate.holds(), "{pull_mm}");
        solved
    };
    let slips = |solved: &Solved| -> Vec<f64> {
        let events = solved.events.iter();
        let slips = events.filter(|event| event.what == Occurrence::FrictionGaveWay);
        slips.map(|event| 1e3 * event.pull).collect()
    };
    let used = |solved: &Solved| {
        let [contact] = &solved.contacts[..] else {
            panic!("{:?}", solved.contacts);
        };
        (contact.friction / contact.multiplier, 1e3 * contact.slid)
    };
    let before = at(10.35);
    let (share, slid) = used(&before);
    assert!(
        (0.27..0.275).contains(&share) && slid.abs() < 1e-7,
        "{share} {slid}"
    );
    assert_eq!(slips(&before), [] as [f64; 0]);
    let end = at(12.0);
    let (share, slid) = used(&end);
    assert!(
        (share - 0.275).abs() < 1e-9 && slid < -0.1,
        "{share} {slid}"
    );
    let at_slips = slips(&end);
    assert!((10.35..10.37).contains(&at_slips[0]), "{at_slips:?}");
    let jump = end.events.iter().find_map(|event| match event.what {
        Occurrence::Jump { distance, .. } => Some(1e3 * distance),
        _ => None,
    });
    assert!((2.0..4.0).contains(&jump.unwrap()), "{jump:?}");
}
