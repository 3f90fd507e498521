//! Courses there and back: the work that a loop takes, and the command for it.

use std::process::Command;

use serde_json::Value;
use sinew::explore::{Course, Cycle, Given};
use sinew::mechanics::Problem;
use sinew::scene::Scene;

const ROBOT: &str = "version = 2\n[robot]\nlength_mm = 180\nsegments = 18\nsegments_per_bay = 2\n\
                     cable_offset_mm = 8\nbending_stiffness_nmm2 = 8000\n[actuation]\n";

fn problem(rest: &str) -> Problem {
    Problem::new(&Scene::from_toml(&format!("{ROBOT}{rest}")).unwrap()).unwrap()
}

/// Done, stored and of the loop, in N mm.
fn work(problem: &Problem, given: Given, waypoints: &[f64]) -> [f64; 3] {
    let course = Course {
        cable: 0,
        given,
        waypoints: waypoints.to_vec(),
        steps: 40,
    };
    let cycle = Cycle::follow(problem, &course, |_| {});
    assert_eq!(cycle.end, None);
    assert_eq!(cycle.visits.len(), 1 + 40 * (waypoints.len() - 1));
    let work = cycle.work(0);
    let per_bend = problem.drive().stiffness.unwrap() / 0.02;
    [work.done, work.stored, work.of_cable].map(|work| 1e3 * per_bend * work)
}

fn near(found: f64, expected: f64, allowed: f64) {
    assert!(
        (found - expected).abs() <= allowed,
        "{found} for {expected}"
    );
}

/// Figures of an independent solver: 0-5-0-5 N at μ = 0.3 take 17.93 N mm, of which
/// 14.63 are stored.
#[test]
fn a_cycle_with_friction_takes_the_work_of_another_solver() {
    let rubs = problem("load_g = 0\n[friction]\nholes = 0.3\n");
    let [done, stored, _] = work(&rubs, Given::Load, &[0.0, 5.0, 0.0, 5.0]);
    near(done, 17.93, 0.01);
    near(stored, 14.63, 0.01);
}

#[test]
fn without_friction_nothing_is_lost_whatever_works() {
    for rest in [
        "load_g = 0\n",
        "load_g = 0\n[loads]\ntip_force_n = [0.05, -0.1]\ntip_moment_nmm = 3\n",
    ] {
        let slides = problem(rest);
        let [done, stored, _] = work(&slides, Given::Load, &[0.0, 4.0, 1.0, 4.0]);
        near(done, stored, 2e-3 * stored);
        let [_, _, of_loop] = work(&slides, Given::Load, &[4.0, 1.0, 4.0]);
        near(of_loop, 0.0, 1e-9);
    }
}

#[test]
fn the_command_prints_a_loop_and_refuses_no_course() {
    let sinew = |arguments: &[&str]| {
        let mut command = Command::new(env!("CARGO_BIN_EXE_sinew"));
        command.arg("cycle").arg("assets/scenes/two-posts.toml");
        command.args(arguments).output().unwrap()
    };
    let out = sinew(&[
        "--load",
        "0:300:0",
        "--steps",
        "6",
        "--set",
        "friction.holes=0.3",
        "--format",
        "json",
    ]);
    assert_eq!(out.status.code(), Some(0), "{out:?}");
    let told: Value = serde_json::from_slice(&out.stdout).unwrap();
    let rows = told["rows"].as_array().unwrap();
    assert_eq!(rows.len(), 13);
    assert_eq!(rows[12]["leg"], 2);
    let pull = |row: usize| rows[row]["pull_mm"].as_f64().unwrap();
    // On the way back the cable sticks, and draws in more under the same load.
    assert!(pull(9) > pull(3) + 0.1, "{} {}", pull(9), pull(3));
    assert!(told["work"]["lost_nmm"].as_f64().unwrap() > 0.1);
    for wrong in [
        &["--load", "0"][..],
        &["--pull", "0:x:0"],
        &["--pull", "0:1e6:0"],
        &["--load", "0:-3:0"],
        &[],
    ] {
        assert_eq!(sinew(wrong).status.code(), Some(2), "{wrong:?}");
    }
    let ended = sinew(&["--pull", "0:120:0", "--steps", "4", "--format", "csv"]);
    assert_eq!(ended.status.code(), Some(3));
    assert!(
        String::from_utf8(ended.stdout)
            .unwrap()
            .starts_with("leg,pull_mm,load_n")
    );
}
