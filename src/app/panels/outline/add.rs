//! New obstacles from the outline: the canvas's, put where there is room.

use super::icon_menu;
use crate::app::look::{icon, icons};
use crate::app::shapes::{Tool, clicked};
use crate::app::words;
use crate::app::workbench::{Selection, Workbench};
use crate::geometry::Vector;
use crate::scene::{Robot, Scene, Shape};
use crate::units::radians;
use eframe::egui::{Button, Ui};

/// A menu of the shapes there are.
pub fn menu(ui: &mut Ui, bench: &mut Workbench) {
    icon_menu(ui, icons::PLUS, "Add an obstacle", |ui| {
        for shape in shapes(&bench.document.scene) {
            let name = words::shape(&shape);
            let button = Button::new((icon(words::shape_icon(&shape)), name));
            if ui.add(button).accessible_name(name).clicked() {
                insert(bench, shape);
                ui.close();
            }
        }
    });
}

/// Adds a disc.
pub fn disc(bench: &mut Workbench) {
    if let Some(disc) = shapes(&bench.document.scene).next() {
        insert(bench, disc);
    }
}

fn insert(bench: &mut Workbench, shape: Shape) {
    let obstacles = &mut bench.document.scene.obstacles;
    obstacles.push(shape.into());
    bench.selection = Selection::Obstacle(obstacles.len() - 1);
}

/// One of every shape, where there is room for it.
fn shapes(scene: &Scene) -> impl Iterator<Item = Shape> + use<> {
    let at = room(scene);
    let robot = scene.robot.clone();
    [
        Tool::Disc,
        Tool::Box,
        Tool::Capsule,
        Tool::Polygon,
        Tool::Wall,
    ]
    .into_iter()
    .map(move |tool| {
        clicked(tool, at, &robot, 0.005 * robot.length_mm).unwrap_or_else(|| triangle(at, &robot))
    })
}

fn triangle(at: Vector, robot: &Robot) -> Shape {
    let size = 0.1 * robot.length_mm;
    let corners = [(-1.0, -1.0), (1.0, -1.0), (0.0, 1.0)];
    Shape::Polygon {
        points_mm: corners
            .map(|(x, y)| (at + size * Vector::new(x, y)).into())
            .to_vec(),
        rotation_deg: 0.0,
        corner_radius_mm: 0.0,
    }
}

/// A place on the cable's side, where the robot comes when it is pulled, away
/// from the other obstacles; in mm.
fn room(scene: &Scene) -> Vector {
    let robot = &scene.robot;
    let (sine, cosine) = radians(robot.base_angle_deg).sin_cos();
    let (out, up) = (Vector::new(cosine, sine), Vector::new(-sine, cosine));
    let length = robot.length_mm;
    let near = 0.15 * length;
    let taken = || {
        let others = scene.obstacles.iter();
        others.map(|it| Vector::from(it.shape.anchor_mm()))
    };
    let mut at = Vector::from(robot.base_mm) + length * (0.3 * out + 0.6 * up);
    // Each step may be next to another obstacle once.
    for _ in 0..=scene.obstacles.len() {
        if taken().all(|other| (other - at).norm() > near) {
            break;
        }
        at += near * out;
    }
    at
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mechanics::Problem;

    #[test]
    fn every_new_shape_is_one_that_can_be_solved() {
        for base_angle_deg in [0.0, 90.0, -37.0] {
            let robot = Robot {
                base_angle_deg,
                base_mm: [12.0, -7.0],
                ..Robot::default()
            };
            let empty = Scene {
                robot,
                ..Scene::default()
            };
            assert_eq!(shapes(&empty).count(), 5);
            for shape in shapes(&empty) {
                let mut scene = empty.clone();
                scene.obstacles.push(shape.into());
                assert_eq!(Problem::faults(&scene), []);
            }
        }
    }

    #[test]
    fn each_finds_a_place_of_its_own() {
        let mut scene = Scene::default();
        for _ in 0..5 {
            let disc = shapes(&scene).next().unwrap();
            scene.obstacles.push(disc.into());
        }
        for (index, one) in scene.obstacles.iter().enumerate() {
            for other in &scene.obstacles[index + 1..] {
                let way =
                    Vector::from(one.shape.anchor_mm()) - Vector::from(other.shape.anchor_mm());
                assert!(way.norm() > 0.14 * scene.robot.length_mm);
            }
        }
    }
}
