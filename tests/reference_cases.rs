//! Ten equilibria of an independent solver, which works on the paper's own
//! coordinates with an interior point and exact derivatives.

use serde_json::Value;
use sinew::contact::Class;
use sinew::equilibrium::{Settings, Solution, Start, Status, solve};
use sinew::mechanics::Problem;
use sinew::robot::Line;
use sinew::scene::{Scene, Shape};

const CASES: &str = include_str!("cases/planar_cases.json");

fn cases() -> Vec<Value> {
    let file: Value = serde_json::from_str(CASES).unwrap();
    file["cases"].as_array().unwrap().clone()
}

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap()
}

fn scene(case: &Value) -> Scene {
    let mut scene = Scene::default();
    scene.robot.length_mm = number(&case["length_mm"]);
    scene.robot.segments = u32::try_from(case["segments"].as_u64().unwrap()).unwrap();
    scene.robot.segments_per_bay = 1;
    scene.robot.cable_offset_mm = Some(number(&case["cable_offset_mm"]));
    scene.set_pull_mm(number(&case["pull_mm"]));
    for circle in case["circles"].as_array().unwrap() {
        scene.obstacles.push(
            Shape::Disc {
                center_mm: [number(&circle[0]), number(&circle[1])],
                radius_mm: number(&circle[2]),
            }
            .into(),
        );
    }
    scene
}

/// Positions to 1e-6 mm, multipliers to 1e-5 of themselves, energy to 1e-9:
/// the accuracy the reference was stored and solved with.
fn check(index: usize, case: &Value, solution: &Solution) {
    assert_eq!(solution.status, Status::Converged, "case {index}");
    let offset = number(&case["cable_offset_mm"]) * 1e-3;
    let lines = [
        ("backbone", solution.backbone().collect::<Vec<_>>()),
        ("cable", solution.cable(offset).collect()),
    ];
    for (name, points) in lines {
        for (node, point) in points.iter().enumerate() {
            for axis in 0..2 {
                let expected = number(&case[name][node][axis]);
                let difference = (point[axis] * 1e3 - expected).abs();
                assert!(
                    difference < 1e-6,
                    "case {index}, {name} {node}: {difference} mm"
                );
            }
        }
    }
    let energy = number(&case["energy"]);
    assert!(
        (solution.energy - energy).abs() < 1e-9 * energy,
        "case {index}"
    );
    let pressing: Vec<_> = solution
        .contacts
        .iter()
        .filter(|contact| contact.class == Class::Pressing)
        .collect();
    let expected = case["contacts"].as_array().unwrap();
    assert_eq!(pressing.len(), expected.len(), "case {index}");
    for contact in expected {
        let line = match contact["line"].as_str().unwrap() {
            "cable" => Line::Cable,
            _ => Line::Backbone,
        };
        let found = pressing.iter().find(|found| {
            found.line == line
                && found.node as u64 == contact["node"].as_u64().unwrap()
                && found.obstacle as u64 == contact["obstacle"].as_u64().unwrap()
        });
        let multiplier = number(&contact["multiplier"]);
        let found = found.unwrap().multiplier * 1e-3;
        assert!(
            (found - multiplier).abs() < 1e-5 * multiplier,
            "case {index}: {found} for {multiplier}"
        );
    }
}

#[test]
fn ten_independent_equilibria_are_met() {
    for (index, case) in cases().iter().enumerate() {
        let problem = Problem::new(&scene(case)).unwrap();
        let solution = solve(&problem, Start::Straight, Settings::default());
        check(index, case, &solution);
    }
}
