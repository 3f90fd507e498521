//! Robots of every size among obstacles of every kind, small and large, sharp and
//! round, many of them over the straight robot: how many solves end without
//! knowing why, and that none shows a shape that is not certified.
//!
//! `SINEW_SCENES=5000 cargo test --release --test hard_scenes -- --nocapture` tells
//! the rate over many, and which took the most iterations.

mod seeded;

use seeded::{Random, scenes};
use sinew::equilibrium::{Settings, Start, Status, solve};
use sinew::mechanics::Problem;
use sinew::scene::{Candidates, Scene, Shape};

/// An obstacle near a robot of a length, in mm, of a three-hundredth of it to a
/// quarter.
fn shape(random: &mut Random, length: f64) -> Shape {
    let center_mm = [
        random.between(-0.3, 0.7) * length,
        random.between(0.05, 1.05) * length,
    ];
    let size = length * libm::exp10(random.between(-2.5, -0.6));
    let rotation_deg = random.between(0.0, 360.0);
    let rounded = random.one_of(2) == 1;
    let corner = if rounded {
        libm::exp10(random.between(-3.0, -0.5))
    } else {
        0.0
    };
    match random.one_of(6) {
        0 => Shape::Disc {
            center_mm,
            radius_mm: size,
        },
        1 => {
            let size_mm = [0, 1].map(|_| size * random.between(0.3, 2.0));
            Shape::Box {
                center_mm,
                size_mm,
                rotation_deg,
                corner_radius_mm: corner * size_mm[0].min(size_mm[1]),
            }
        }
        2 => Shape::Capsule {
            center_mm,
            length_mm: size * random.between(0.5, 3.0),
            radius_mm: size * random.between(0.05, 0.5),
            rotation_deg,
        },
        3 | 4 => {
            let corners = 3 + random.one_of(4);
            let turn = std::f64::consts::TAU / f64::from(corners);
            let points_mm = (0..corners).map(|i| {
                let angle = turn * (f64::from(i) + random.between(0.1, 0.9));
                let [x, y] = center_mm;
                [x + size * libm::cos(angle), y + size * libm::sin(angle)]
            });
            Shape::Polygon {
                points_mm: points_mm.collect(),
                rotation_deg,
                corner_radius_mm: 0.3 * corner * size,
            }
        }
        _ => {
            let side = if center_mm[0] < 0.0 { -1.0 } else { 1.0 };
            Shape::Wall {
                point_mm: [center_mm[0] + 0.1 * side * length, center_mm[1]],
                rotation_deg: 90.0 + 90.0 * side + random.between(-40.0, 40.0),
                corner_radius_mm: 0.0,
            }
        }
    }
}

fn scene(seed: u64) -> Scene {
    let random = &mut Random::of(seed);
    let mut scene = Scene::default();
    let robot = &mut scene.robot;
    let length = libm::exp10(random.between(1.0, 3.3));
    robot.length_mm = length;
    robot.segments = 1 + random.one_of(60);
    robot.segments_per_bay = if robot.segments % 2 == 0 { 2 } else { 1 };
    let offset = length * random.between(0.01, 0.1);
    robot.cable_offset_mm = Some(offset);
    if random.one_of(2) == 0 {
        robot.disk_thickness_mm = length * random.between(0.0, 0.01);
        robot.backbone_diameter_mm = length * random.between(0.0, 0.02);
        robot.cable_diameter_mm = length * random.between(0.0, 0.005);
        robot.disk_radius_mm = Some(offset * random.between(1.0, 1.5));
    }
    scene.set_pull_mm(offset * random.between(-0.5, 2.5));
    scene.contact.candidates = [Candidates::Nodes, Candidates::Body][random.one_of(2) as usize];
    let obstacles = 1 + random.one_of(5);
    scene.obstacles = (0..obstacles)
        .map(|_| shape(random, length).into())
        .collect();
    scene
}

#[test]
fn hardly_any_solve_ends_without_a_reason_and_none_without_a_certificate() {
    let (mut solved, mut unexplained, mut most) = (0_u32, 0_u32, (0, 0));
    for seed in 0..scenes(400) {
        let Ok(problem) = Problem::new(&scene(seed)) else {
            continue;
        };
        let solution = solve(&problem, Start::Straight, Settings::default());
        assert!(
            solution.certificate.holds(),
            "{seed}: {:?} {:?}",
            solution.status,
            solution.certificate
        );
        solved += 1;
        most = most.max((solution.iterations, seed));
        if matches!(
            solution.status,
            Status::IterationLimit | Status::NumericalFailure
        ) {
            unexplained += 1;
            println!("{seed}: {}", solution.status.reason());
        }
    }
    let share = f64::from(unexplained) / f64::from(solved);
    println!(
        "{unexplained} of {solved}, {:.2} %, end without a reason; at most {} iterations, in {}",
        100.0 * share,
        most.0,
        most.1
    );
    assert!(share <= 0.01, "{share}");
}
