//! A robot's body amid shapes of every kind, for derivatives.

use sinew::mechanics::{Equal, Mechanics, Problem};
use sinew::scene::{Candidates, Scene, Shape};
use sinew::solver::{Chain, Control};

/// A robot's body amid shapes so near that points, links and disks have rows.
pub fn crowded() -> Equal {
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
    Equal::new(Problem::new(&scene).unwrap())
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
