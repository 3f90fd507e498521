//! A robot's body amid shapes of every kind, for derivatives.

use sinew::mechanics::{Equal, Mechanics, Problem, Sliding};
use sinew::scene::{self, Candidates, Scene, Shape};
use sinew::solver::{Chain, Control};

/// A robot's body amid shapes so near that points, links and disks have rows.
pub fn crowded() -> Equal {
    Equal::new(Problem::new(&crowded_scene()).unwrap())
}

/// Its scene.
fn crowded_scene() -> Scene {
    let mut scene = Scene::default();
    scene.robot.disk_radius_mm = Some(14.0);
    scene.robot.disk_thickness_mm = 1.0;
    scene.robot.cable_diameter_mm = 0.6;
    scene.set_pull_mm(4.0);
    scene.contact.candidates = Candidates::Body;
    let mut add = |shape: Shape| scene.obstacles.push(shape.into());
    add(Shape::Disc {
        center_mm: [27.0, 89.0],
        radius_mm: 6.0,
    });
    add(Shape::Box {
        center_mm: [-16.0, 62.0],
        size_mm: [20.0, 8.0],
        rotation_deg: 30.0,
        corner_radius_mm: 1.0,
    });
    add(Shape::Capsule {
        center_mm: [24.0, 124.0],
        length_mm: 14.0,
        radius_mm: 1.0,
        rotation_deg: 10.0,
    });
    add(Shape::Disc {
        center_mm: [16.0, 144.0],
        radius_mm: 0.5,
    });
    add(Shape::Wall {
        point_mm: [60.0, 150.0],
        rotation_deg: 170.0,
        corner_radius_mm: 0.0,
    });
    scene
}

/// The same body strung with two sliding cables, one under a load and one that
/// stretches, heavy, and pushed at its tip; `segments_per_bay` up to `NU`.
#[allow(dead_code, reason = "not every test lets cables slide")]
pub fn strung<const NU: usize>(segments_per_bay: u32) -> Sliding<NU> {
    let mut scene = crowded_scene();
    scene.model.mechanics = scene::Mechanics::Sliding;
    scene.robot.segments_per_bay = segments_per_bay;
    scene.robot.bending_stiffness_nmm2 = Some(8000.0);
    scene.robot.cable_offset_mm = None;
    scene.robot.cable_diameter_mm = 0.0;
    scene.actuation = None;
    let cable = |offset_mm, drive| scene::Cable {
        offset_mm,
        drive,
        to_disk: None,
        axial_stiffness_n: None,
        diameter_mm: 0.6,
    };
    scene.cables = vec![
        cable(8.0, scene::Drive::PullMm(4.0)),
        scene::Cable {
            to_disk: Some(2),
            axial_stiffness_n: Some(2000.0),
            ..cable(-6.0, scene::Drive::PullMm(-1.0))
        },
        cable(5.0, scene::Drive::LoadG(12.0)),
    ];
    scene.loads.tip_force_n = [0.01, -0.03];
    scene.loads.tip_moment_nmm = 0.4;
    scene.loads.gravity_m_s2 = [1.0, -9.0];
    scene.robot.disk_mass_g = 0.3;
    scene.robot.backbone_mass_g = 0.5;
    Sliding::new(Problem::new(&scene).unwrap())
}

/// Bends of a few hundredths to a few tenths of a radian.
#[allow(dead_code, reason = "not every test lets cables slide")]
pub fn bends<const NU: usize>(sliding: &Sliding<NU>) -> Vec<Control<NU>> {
    let robot = sliding.robot();
    let arcs = robot.segments_per_bay;
    let bend = |i: usize| {
        if i % 7 == 3 {
            4.0
        } else {
            1.2 * (1.7 * i as f64).sin()
        }
    };
    let bay = |k: usize| Control::from_fn(|i, _| if i < arcs { bend(k * arcs + i) } else { 0.0 });
    (0..robot.segments / arcs).map(bay).collect()
}

/// Turns with a large one to either side here and there.
pub fn controls(problem: &Equal) -> Vec<Control<1>> {
    let turn = |i: usize| match i % 9 {
        3 => 1.3,
        7 => -1.4,
        _ => 0.15 * (1.7 * i as f64).sin(),
    };
    let turns = (0..problem.stages()).map(turn);
    turns.map(Control::from_element).collect()
}
