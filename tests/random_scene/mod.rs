//! Random robots among random obstacles, for property tests. Not all of them
//! can be solved; all of them must end in a status.

use proptest::prelude::*;
use sinew::scene::{Candidates, Drive, Mechanics, Scene, Shape};

/// One obstacle near a robot of length 1, in shares of its length.
fn shape() -> impl Strategy<Value = Shape> {
    let place = (-0.2..0.6f64, 0.15..1.0f64);
    (place, 0.02..0.13f64, 0.0..360.0f64, 0.0..0.5f64, 0..5u8).prop_map(
        |((x, y), size, turn, corner, kind)| match kind {
            0 => Shape::Disc {
                center_mm: [x, y],
                radius_mm: size,
            },
            1 => Shape::Box {
                center_mm: [x, y],
                size_mm: [2.0 * size, size],
                rotation_deg: turn,
                corner_radius_mm: corner * size,
            },
            2 => Shape::Capsule {
                center_mm: [x, y],
                length_mm: 2.0 * size,
                radius_mm: 0.2 * size,
                rotation_deg: turn,
            },
            3 => Shape::Polygon {
                points_mm: (0..5)
                    .map(|i| {
                        let angle = f64::from(i) * 0.4 * std::f64::consts::PI;
                        [x + size * libm::cos(angle), y + size * libm::sin(angle)]
                    })
                    .collect(),
                rotation_deg: turn,
                corner_radius_mm: 0.0,
            },
            _ => Shape::Wall {
                point_mm: [x + 0.1 * x.signum(), y],
                rotation_deg: 90.0 + x.signum() * (90.0 + 0.1 * (turn - 180.0)),
                corner_radius_mm: 0.0,
            },
        },
    )
}

/// Scales every length of a shape.
fn scaled(shape: Shape, by: f64) -> Shape {
    let point = |[x, y]: [f64; 2]| [by * x, by * y];
    match shape {
        Shape::Disc {
            center_mm,
            radius_mm,
        } => Shape::Disc {
            center_mm: point(center_mm),
            radius_mm: by * radius_mm,
        },
        Shape::Wall {
            point_mm,
            rotation_deg,
            corner_radius_mm,
        } => Shape::Wall {
            point_mm: point(point_mm),
            rotation_deg,
            corner_radius_mm: by * corner_radius_mm,
        },
        Shape::Box {
            center_mm,
            size_mm,
            rotation_deg,
            corner_radius_mm,
        } => Shape::Box {
            center_mm: point(center_mm),
            size_mm: point(size_mm),
            rotation_deg,
            corner_radius_mm: by * corner_radius_mm,
        },
        Shape::Capsule {
            center_mm,
            length_mm,
            radius_mm,
            rotation_deg,
        } => Shape::Capsule {
            center_mm: point(center_mm),
            length_mm: by * length_mm,
            radius_mm: by * radius_mm,
            rotation_deg,
        },
        Shape::Polygon {
            points_mm,
            rotation_deg,
            corner_radius_mm,
        } => Shape::Polygon {
            points_mm: points_mm.into_iter().map(point).collect(),
            rotation_deg,
            corner_radius_mm: by * corner_radius_mm,
        },
    }
}

/// A scene with every length multiplied, angles kept.
#[allow(dead_code, reason = "not every test that makes scenes scales them")]
pub fn scaled_scene(scene: &Scene, by: f64) -> Scene {
    let mut scene = scene.clone();
    scene.robot.length_mm *= by;
    scene.set_offset_mm(by * scene.offset_mm());
    scene.robot.disk_radius_mm = scene.robot.disk_radius_mm.map(|radius| by * radius);
    scene.robot.disk_thickness_mm *= by;
    scene.robot.backbone_diameter_mm *= by;
    scene.robot.cable_diameter_mm *= by;
    scene.set_pull_mm(by * scene.pull_mm());
    for obstacle in &mut scene.obstacles {
        obstacle.shape = scaled(obstacle.shape.clone(), by);
    }
    scene
}

/// A robot with one to four obstacles, pulled or let out.
pub fn scene(candidates: Candidates) -> impl Strategy<Value = Scene> {
    let robot = (80.0..300.0f64, 6..36u32, 4.0..15.0f64, -0.5..2.5f64);
    let obstacles = prop::collection::vec(shape(), 1..=4);
    (robot, obstacles).prop_map(move |((length, segments, offset, pull), shapes)| {
        let mut scene = Scene::default();
        scene.robot.length_mm = length;
        scene.robot.segments = segments;
        scene.robot.segments_per_bay = 1;
        scene.robot.cable_offset_mm = Some(offset);
        scene.set_pull_mm(pull * offset);
        scene.contact.candidates = candidates;
        if candidates == Candidates::Body {
            scene.robot.disk_thickness_mm = 1.0;
            scene.robot.cable_diameter_mm = 0.5;
        }
        scene.obstacles = shapes
            .into_iter()
            .map(|shape| scaled(shape, length).into())
            .collect();
        scene
    })
}

/// The same robot with a cable that slides, straight over one to three segments, under a
/// pull or under the load that bends a free robot by as much.
#[allow(
    dead_code,
    reason = "not every test that makes scenes lets cables slide"
)]
pub fn sliding_scene(candidates: Candidates) -> impl Strategy<Value = Scene> {
    (scene(candidates), 1..=3u32, any::<bool>()).prop_map(|(mut scene, bay, loaded)| {
        scene.model.mechanics = Mechanics::Sliding;
        scene.robot.segments_per_bay = bay;
        scene.robot.segments = bay * scene.robot.segments.div_ceil(bay);
        let (length, offset, pull) = (scene.robot.length_mm, scene.offset_mm(), scene.pull_mm());
        let stiffness = 0.25 * length * length;
        scene.robot.bending_stiffness_nmm2 = Some(stiffness);
        if loaded {
            let newtons = pull.max(0.0) * stiffness / (offset * offset * length);
            scene.set_drive(0, Drive::LoadG(newtons / 9.80665e-3));
        }
        scene
    })
}

/// The same robot with friction in its holes, below its base and on obstacles.
#[allow(dead_code, reason = "not every test that makes scenes lets cables rub")]
pub fn rubbing_scene(candidates: Candidates) -> impl Strategy<Value = Scene> {
    let friction = (0.02..0.7f64, 0.0..0.3f64, -0.4..0.6f64, any::<bool>());
    (sliding_scene(candidates), friction).prop_map(|(mut scene, (holes, lost, contacts, loses))| {
        scene.friction.holes = holes;
        scene.friction.contacts = contacts.max(0.0);
        scene.friction.base_loss = if loses { lost } else { 0.0 };
        scene
    })
}

/// Cases that are the same on every run.
pub fn config(cases: u32) -> ProptestConfig {
    ProptestConfig {
        cases,
        rng_seed: prop::test_runner::RngSeed::Fixed(1),
        failure_persistence: None,
        ..ProptestConfig::default()
    }
}
