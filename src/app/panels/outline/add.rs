//! New obstacles: where they are put and how large they are.

use super::icon_menu;
use crate::app::look::{icon, icons};
use crate::app::state::{Selection, State};
use crate::app::words;
use crate::scene::{Obstacle, Robot, Shape};
use crate::units::radians;
use eframe::egui::{Button, Ui};

/// A menu of the shapes there are.
pub fn menu(ui: &mut Ui, state: &mut State) {
    icon_menu(ui, icons::PLUS, "Add an obstacle", |ui| {
        for shape in shapes(&state.document.scene.robot) {
            let text = (icon(words::shape_icon(&shape)), words::shape(&shape));
            if ui.add(Button::new(text)).clicked() {
                insert(state, shape.into());
                ui.close();
            }
        }
    });
}

/// Adds a disc.
pub fn disc(state: &mut State) {
    let [disc, ..] = shapes(&state.document.scene.robot);
    insert(state, disc.into());
}

/// Adds a second one like an obstacle, beside it.
pub fn twin(state: &mut State, index: usize) {
    if let Some(obstacle) = state.document.scene.obstacles.get(index) {
        insert(state, obstacle.clone());
    }
}

/// One of every shape, in a size that suits the robot: a tenth of its length.
fn shapes(robot: &Robot) -> [Shape; 5] {
    let size = whole(0.1 * robot.length_mm);
    let center_mm = [0.0, 0.0];
    [
        Shape::Disc {
            center_mm,
            radius_mm: size,
        },
        Shape::Box {
            center_mm,
            size_mm: [2.0 * size, size],
            rotation_deg: 0.0,
            corner_radius_mm: 0.0,
        },
        Shape::Capsule {
            center_mm,
            length_mm: 2.0 * size,
            radius_mm: 0.25 * size,
            rotation_deg: 0.0,
        },
        Shape::Polygon {
            points_mm: vec![[-size, -size], [size, -size], [0.0, size]],
            rotation_deg: 0.0,
            corner_radius_mm: 0.0,
        },
        Shape::Wall {
            point_mm: center_mm,
            rotation_deg: 180.0 + robot.base_angle_deg,
            corner_radius_mm: 0.0,
        },
    ]
}

/// Puts an obstacle on the cable's side, where the robot comes when it is
/// pulled, and farther out until it is clear of the base and of the others.
fn insert(state: &mut State, mut obstacle: Obstacle) {
    let scene = &mut state.document.scene;
    let robot = &scene.robot;
    let (sine, cosine) = radians(robot.base_angle_deg).sin_cos();
    let length = robot.length_mm;
    let place = |out: f64, up: f64| {
        [
            whole(robot.base_mm[0] + cosine * out - sine * up),
            whole(robot.base_mm[1] + sine * out + cosine * up),
        ]
    };
    let taken: Vec<[f64; 2]> = scene
        .obstacles
        .iter()
        .map(|it| it.shape.anchor_mm())
        .collect();
    let near = 0.15 * length;
    let places = (0..40).map(|step| place(length * (0.3 + 0.1 * f64::from(step)), 0.6 * length));
    let free = |at: &[f64; 2]| {
        let away = |other: &[f64; 2]| (at[0] - other[0]).hypot(at[1] - other[1]) > near;
        taken.iter().all(away)
    };
    let Some(at) = places.clone().find(free).or_else(|| places.clone().last()) else {
        return;
    };
    obstacle.shape.move_to_mm(at);
    let index = scene.obstacles.len();
    scene.obstacles.push(obstacle);
    state.selection = Selection::Obstacle(index);
}

/// Millimetres that read well.
fn whole(value: f64) -> f64 {
    if value.abs() < 5.0 {
        value
    } else {
        value.round()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::Problem;
    use crate::scene::Scene;

    #[test]
    fn every_new_shape_is_one_that_can_be_solved() {
        for angle in [0.0, 90.0, -37.0] {
            let robot = Robot {
                base_angle_deg: angle,
                base_mm: [12.0, -7.0],
                ..Robot::default()
            };
            for mut shape in shapes(&robot) {
                let (sine, cosine) = radians(angle).sin_cos();
                let [out, up] = [0.3 * robot.length_mm, 0.6 * robot.length_mm];
                shape.move_to_mm([
                    12.0 + cosine * out - sine * up,
                    -7.0 + sine * out + cosine * up,
                ]);
                let scene = Scene {
                    robot: robot.clone(),
                    obstacles: vec![shape.into()],
                    ..Scene::default()
                };
                assert_eq!(Problem::faults(&scene), []);
            }
        }
    }
}
