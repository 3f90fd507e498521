//! Equilibria of cables that slide, by solvers of other kinds: their shapes, tensions
//! and forces.

use serde_json::Value;
use sinew::contact::{Class, Contact};
use sinew::equilibrium::{Settings, Solution, Start, Status, solve};
use sinew::geometry::{Core, Obstacle, Vector};
use sinew::mechanics::{Drive, DrivenCable, Input, Loads, Problem};
use sinew::robot::{Cable, Candidate, Line, PlanarNode, Robot, Sizes};

fn cases(text: &str) -> Vec<Value> {
    let file: Value = serde_json::from_str(text).unwrap();
    file["cases"].as_array().unwrap().clone()
}

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap()
}

fn numbers(value: &Value) -> Vec<f64> {
    value.as_array().unwrap().iter().map(number).collect()
}

/// A straight robot along +y whose disks are as wide as its cable, from millimetres.
fn robot(case: &Value, segments_per_bay: usize) -> Robot {
    let offset = number(&case["cable_offset_mm"]) * 1e-3;
    let rim = case["disk_radius_mm"].as_f64().map(|mm| mm * 1e-3);
    Robot {
        length: number(&case["length_mm"]) * 1e-3,
        segments: case["segments"].as_u64().unwrap() as usize,
        segments_per_bay,
        offset,
        sizes: Sizes {
            rim: rim.unwrap_or(offset),
            disk: 0.0,
            backbone: 0.0,
            cable: 0.0,
        },
        base: PlanarNode {
            position: Vector::zeros(),
            disk: Vector::x(),
            angle: 0.0,
        },
    }
}

fn obstacles(case: &Value) -> Vec<Obstacle> {
    let none = Vec::new();
    let circles = case["circles"].as_array().unwrap_or(&none);
    let disc = |circle: &Value| {
        let [x, y, radius] = [0, 1, 2].map(|i| number(&circle[i]) * 1e-3);
        Obstacle::new(Core::Point, radius, Vector::new(x, y), 0.0)
    };
    circles.iter().map(disc).collect()
}

/// Backbone and cables at every node.
fn at_nodes(robot: &Robot, cables: &[Cable]) -> Vec<Candidate> {
    let all = cables.iter().enumerate();
    (1..=robot.segments)
        .flat_map(|node| {
            let on_cables = all
                .clone()
                .filter_map(move |(index, cable)| robot.cable_point(index, cable, node));
            std::iter::once(robot.backbone_point(node)).chain(on_cables)
        })
        .collect()
}

fn check_points(found: impl Iterator<Item = Vector>, expected: &Value, allowed: f64, what: &str) {
    for (node, point) in found.enumerate() {
        for axis in 0..2 {
            let expected = number(&expected[node][axis]);
            let miss = (point[axis] * 1e3 - expected).abs();
            assert!(miss < allowed, "{what} {node}: {miss} mm");
        }
    }
}

fn pressing(solution: &Solution) -> Vec<&Contact> {
    let contacts = solution.contacts.iter();
    contacts.filter(|c| c.class == Class::Pressing).collect()
}

/// Node to node: shapes to 1e-6 mm and multipliers to 1e-5 of themselves, the accuracy
/// the reference was stored and solved with.
#[test]
fn shapes_tensions_and_multipliers_are_those_of_another_solver() {
    for (index, case) in cases(include_str!("cases/sliding_cases.json"))
        .iter()
        .enumerate()
    {
        let robot = robot(case, 1);
        let drive = Drive::of_pull(&robot, number(&case["pull_mm"]) * 1e-3);
        let cables = [drive.cables[0].cable];
        let problem = Problem::sliding(robot, drive, at_nodes(&robot, &cables), obstacles(case));
        let solution = solve(&problem, Start::Straight, Settings::default());
        assert_eq!(
            solution.status,
            Status::Converged,
            "case {index}: {:?}",
            solution.certificate
        );
        let what = format!("case {index}, node");
        check_points(solution.backbone(), &case["backbone"], 1e-6, &what);
        check_points(solution.cable(), &case["cable"], 1e-6, &what);
        let close = |found: f64, expected: &Value| {
            let expected = number(expected);
            assert!(
                (found - expected).abs() < 1e-5 * expected,
                "case {index}: {found} {expected}"
            );
        };
        close(solution.energy, &case["energy"]);
        close(solution.energy_slope() * 1e-3, &case["tension_multiplier"]);
        let contacts = pressing(&solution);
        let expected = case["contacts"].as_array().unwrap();
        assert_eq!(contacts.len(), expected.len(), "case {index}");
        for (contact, expected) in contacts.iter().zip(expected) {
            assert_eq!(
                contact.obstacle as u64,
                expected["obstacle"].as_u64().unwrap()
            );
            assert_eq!(contact.node as u64, expected["node"].as_u64().unwrap());
            assert_eq!(contact.line.name(), expected["line"].as_str().unwrap());
            close(contact.multiplier * 1e-3, &expected["multiplier"]);
            close(
                contact.multiplier / solution.energy_slope(),
                &expected["force_over_tension"],
            );
        }
    }
}

/// Disk to disk, under pull, load, a force at the tip, by one cable and by two: shapes
/// to 1e-5 mm, tensions and forces to 1e-5 of themselves or 1e-5 N.
#[test]
fn pulls_loads_rims_and_antagonists_are_those_of_another_solver() {
    for case in cases(include_str!("cases/planar_sliding_cases.json")) {
        let name = case["name"].as_str().unwrap();
        let robot = robot(&case, 2);
        let stiffness = number(&case["EI_Nmm2"]) * 1e-6;
        let is_load = case["mode"] == "load";
        let inputs = numbers(&case["input"]);
        let sides = [1.0, -1.0];
        let cables = inputs.iter().zip(sides).map(|(input, side)| DrivenCable {
            cable: Cable {
                offset: side * robot.offset,
                last_disk: 9,
                compliance: 0.0,
                diameter: 0.0,
            },
            input: if is_load {
                Input::Load(*input)
            } else {
                Input::Pull(input * 1e-3)
            },
        });
        let mut loads = Loads::default();
        if let Some(tip) = case.get("tip_load") {
            loads.tip_force = Vector::new(number(&tip[0]), number(&tip[1]));
            loads.tip_moment = number(&tip[2]) * 1e-3;
        }
        let drive = Drive {
            cables: cables.collect(),
            loads,
            stiffness: Some(stiffness),
            friction: Default::default(),
        };
        let cables: Vec<Cable> = drive.cables.iter().map(|driven| driven.cable).collect();
        let mut candidates = at_nodes(&robot, &cables);
        if case.get("disk_radius_mm").is_some() {
            candidates.retain(|candidate| candidate.line == Line::Backbone);
            for node in (2..=robot.segments).step_by(2) {
                candidates.extend(robot.rim_points(node));
            }
        }
        let problem = Problem::sliding(robot, drive, candidates, obstacles(&case));
        let solution = solve(&problem, Start::Straight, Settings::default());
        assert_eq!(
            solution.status,
            Status::Converged,
            "{name}: {:?}",
            solution.certificate
        );
        check_points(solution.backbone(), &case["backbone_mm"], 1e-5, name);
        let per_bend = stiffness / (2.0 * robot.segment_length());
        let close = |found: f64, expected: f64| {
            let miss = (found - expected).abs();
            assert!(
                miss < 1e-5 * expected.abs().max(1.0),
                "{name}: {found} {expected}"
            );
        };
        for (state, tension) in solution.cables.iter().zip(numbers(&case["tension_N"])) {
            close(per_bend * state.tension, tension);
        }
        for (state, length) in solution
            .cables
            .iter()
            .zip(numbers(&case["cable_length_mm"]))
        {
            if !state.is_slack {
                close(1e3 * (robot.length - state.pull), length);
            }
        }
        let contacts = pressing(&solution);
        let expected = case["contacts"].as_array().unwrap();
        assert_eq!(contacts.len(), expected.len(), "{name}: {contacts:?}");
        for (contact, expected) in contacts.iter().zip(expected) {
            assert_eq!(contact.node as u64, expected["node"].as_u64().unwrap());
            close(per_bend * contact.multiplier, number(&expected["force_N"]));
        }
    }
}

/// Another group's solver of the same mechanics, with contacts in the middle of straight
/// stretches: with two arcs a bay, which let the backbone give way between disks.
#[test]
fn contacts_between_disks_are_those_of_a_peer() {
    let cases = cases(include_str!("cases/peer_opentdcr_6.json"));
    let expected = [("O1", 1, 1e-6), ("O3", 2, 0.006), ("O5", 2, 0.001)];
    for (case, (id, arcs, allowed)) in cases.into_iter().zip(expected) {
        assert_eq!(case["id"], id);
        let mut robot = robot(&case, arcs);
        robot.segments *= arcs;
        let drive = Drive::of_pull(&robot, number(&case["pull_mm"]) * 1e-3);
        let near: Cable = drive.cables[0].cable;
        let far = Cable {
            offset: -robot.offset,
            ..near
        };
        let sides = |node| [near, far].map(|cable| robot.cable_point(0, &cable, node));
        let candidates = (1..=robot.segments).flat_map(sides).flatten().collect();
        let problem = Problem::sliding(robot, drive, candidates, obstacles(&case));
        let solved = solve(&problem, Start::Straight, Settings::default());
        assert_eq!(
            solved.status,
            Status::Converged,
            "{id}: {:?}",
            solved.certificate
        );
        for (node, expected) in case["peer"]["backbone_mm"]
            .as_array()
            .unwrap()
            .iter()
            .enumerate()
        {
            let found = 1e3 * solved.nodes[node * arcs].position;
            let expected = Vector::new(number(&expected[0]), number(&expected[1]));
            let miss = (found - expected).norm();
            // The file's last digit is a millionth of a millimetre.
            assert!(miss < allowed + 1e-6, "{id}, node {node}: {miss} mm");
        }
        let expected = case["ours"]["contacts"].as_array().unwrap();
        assert_eq!(pressing(&solved).len(), expected.len(), "{id}");
    }
}
