//! New obstacles: of a size that suits the robot where one clicks, of the size
//! one drags otherwise. In millimetres; knows no screen.

use super::handles::{Turned, neat, written};
use super::tool::Tool;
use crate::geometry::{Vector, cross};
use crate::scene::{Robot, Shape};
use std::f64::consts::SQRT_2;

/// The radius of a new disc, as a share of the robot's length: a post of the
/// paper's for the paper's robot.
const RADIUS: f64 = 0.07;
/// The sides of a clicked box and the radius of its corners, over a new disc's
/// radius: about as large as the disc, and seen to be no square.
const BOX: [f64; 2] = [2.4, 1.6];
const CORNER: f64 = 0.16;
/// The length of a clicked capsule and the radius of any new one, over a new
/// disc's radius: as long as the box, and a bar rather than a pill.
const CAPSULE_LENGTH: f64 = 2.4;
const CAPSULE_RADIUS: f64 = 0.4;
/// What the normal of a wall is a multiple of, in degrees: a click means one of
/// the eight directions, a drag the line that it follows, to what handles turn
/// by.
const CLICKED_STEP_DEG: f64 = 45.0;
const DRAGGED_STEP_DEG: f64 = 0.1;
/// No dragged size is rounded down to less than this, in points of the screen:
/// far below what one sees, and not zero.
const NOT_NOTHING: f64 = 1e-3;
/// Least size while one drags, as a share of the robot's length.
const LEAST: f64 = 0.004;

/// The obstacle of a tool placed with a click; `None` for a tool that places
/// nothing by one click.
pub fn clicked(tool: Tool, at: Vector, robot: &Robot, per_point: f64) -> Option<Shape> {
    let radius = two_digits(RADIUS * robot.length_mm);
    let centre = at.map(|x| neat(x, per_point)).into();
    Some(match tool {
        Tool::Select | Tool::Polygon => return None,
        Tool::Disc => Shape::Disc {
            center_mm: centre,
            radius_mm: radius,
        },
        Tool::Box => Shape::Box {
            center_mm: centre,
            size_mm: BOX.map(|side| two_digits(side * radius)),
            rotation_deg: 0.0,
            corner_radius_mm: two_digits(CORNER * radius),
        },
        Tool::Capsule => Shape::Capsule {
            center_mm: centre,
            length_mm: two_digits(CAPSULE_LENGTH * radius),
            radius_mm: two_digits(CAPSULE_RADIUS * radius),
            rotation_deg: 0.0,
        },
        Tool::Wall => wall(
            centre,
            Vector::from(robot_middle(robot)) - at,
            CLICKED_STEP_DEG,
        ),
    })
}

/// The obstacle of a tool dragged from a place to another: a disc about the
/// first, a box between both, a capsule from one to the other, a wall along
/// the line through both with the robot's base on its free side. `None` for a
/// tool that places nothing by dragging.
pub fn dragged(
    tool: Tool,
    from: Vector,
    to: Vector,
    robot: &Robot,
    per_point: f64,
) -> Option<Shape> {
    let least = LEAST * robot.length_mm;
    let size = |x: f64| neat(x.max(least), per_point).max(per_point * NOT_NOTHING);
    let along = to - from;
    let from = from.map(|x| neat(x, per_point));
    Some(match tool {
        Tool::Select | Tool::Polygon => return None,
        Tool::Disc => Shape::Disc {
            center_mm: from.into(),
            radius_mm: size(along.norm()),
        },
        Tool::Box => {
            let sides = along.map(|x| size(x.abs()));
            let signs = along.map(f64::signum);
            Shape::Box {
                center_mm: written(from + 0.5 * sides.component_mul(&signs)),
                size_mm: sides.into(),
                rotation_deg: 0.0,
                corner_radius_mm: 0.0,
            }
        }
        Tool::Capsule => {
            let radius = two_digits(CAPSULE_RADIUS * RADIUS * robot.length_mm);
            Shape::Capsule {
                center_mm: written(from + 0.5 * along),
                length_mm: size(along.norm()),
                radius_mm: radius,
                rotation_deg: (along.y.atan2(along.x).to_degrees() * 10.0).round() / 10.0,
            }
        }
        // Too short to have a direction.
        Tool::Wall if along.norm() < least => return clicked(tool, from, robot, per_point),
        Tool::Wall => {
            let aside = Vector::new(-along.y, along.x);
            let base = Vector::from(robot.base_mm) - from;
            let normal = if cross(along, base) >= 0.0 {
                aside
            } else {
                -aside
            };
            wall(from.into(), normal, DRAGGED_STEP_DEG)
        }
    })
}

/// A copy beside the shape: to the lower right, or behind a wall.
pub fn copied(shape: &Shape, robot: &Robot) -> Shape {
    let away = two_digits(RADIUS * robot.length_mm);
    let by = match shape {
        Shape::Wall { rotation_deg, .. } => -away * Turned::by(*rotation_deg).x,
        _ => away / SQRT_2 * Vector::new(1.0, -1.0),
    };
    let mut copy = shape.clone();
    copy.move_to_mm(written(Vector::from(shape.anchor_mm()) + by));
    copy
}

/// A wall whose normal is a multiple of a step in degrees.
fn wall(point_mm: [f64; 2], normal: Vector, step: f64) -> Shape {
    let angle = normal.y.atan2(normal.x).to_degrees();
    Shape::Wall {
        point_mm,
        // Tenths are exact as quotients only.
        rotation_deg: (angle / step).round() / (1.0 / step),
        corner_radius_mm: 0.0,
    }
}

/// The middle of the straight robot.
fn robot_middle(robot: &Robot) -> [f64; 2] {
    let up = Turned::by(robot.base_angle_deg).y;
    (Vector::from(robot.base_mm) + 0.5 * robot.length_mm * up).into()
}

/// A positive number with two significant digits.
fn two_digits(value: f64) -> f64 {
    let decimals = 1.0 - value.log10().floor();
    let per_one = 10f64.powi(decimals.clamp(-9.0, 9.0) as i32);
    (value * per_one).round() / per_one
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mechanics::Problem;
    use crate::scene::Scene;

    const TOOLS: [Tool; 4] = [Tool::Disc, Tool::Box, Tool::Capsule, Tool::Wall];

    fn check(shape: Option<Shape>, scene: &Scene) {
        let mut scene = scene.clone();
        scene.obstacles.push(shape.unwrap().into());
        assert_eq!(Problem::faults(&scene), [], "{:?}", scene.obstacles[0]);
    }

    #[test]
    fn new_obstacles_suit_robots_of_every_size() {
        for length_mm in [2.0, 180.0, 4e4] {
            let mut scene = Scene::default();
            scene.robot.length_mm = length_mm;
            scene.set_offset_mm(0.04 * length_mm);
            let at = length_mm * Vector::new(0.5, 0.6);
            let per_point = length_mm / 500.0;
            for tool in TOOLS {
                check(clicked(tool, at, &scene.robot, per_point), &scene);
                let by = |x, y| at + length_mm * Vector::new(x, y);
                for to in [at, by(1e-12, 0.0), by(0.1, 0.3), by(-0.2, 0.1)] {
                    let shape = dragged(tool, at, to, &scene.robot, per_point);
                    check(shape.clone(), &scene);
                    check(Some(copied(&shape.unwrap(), &scene.robot)), &scene);
                }
            }
        }
    }

    #[test]
    fn a_box_lies_between_both_places_and_a_disc_about_the_first() {
        let robot = Robot::default();
        let (from, to) = (Vector::new(80.0, 90.0), Vector::new(60.0, 120.0));
        let Some(Shape::Box {
            center_mm, size_mm, ..
        }) = dragged(Tool::Box, from, to, &robot, 0.35)
        else {
            panic!("no box");
        };
        assert_eq!((center_mm, size_mm), ([70.0, 105.0], [20.0, 30.0]));
        let to = Vector::new(83.0, 94.0);
        let disc = dragged(Tool::Disc, from, to, &robot, 0.35);
        let expect = Shape::Disc {
            center_mm: [80.0, 90.0],
            radius_mm: 5.0,
        };
        assert_eq!(disc, Some(expect));
    }

    #[test]
    fn walls_have_the_robot_on_their_free_side() {
        let robot = Robot::default();
        let (a, b) = (Vector::new(60.0, 0.0), Vector::new(60.0, 100.0));
        for (from, to) in [(a, b), (b, a)] {
            let wall = dragged(Tool::Wall, from, to, &robot, 0.35).unwrap();
            assert_eq!(wall.rotation_deg().abs(), 180.0);
        }
        let wall = clicked(Tool::Wall, Vector::new(90.0, 100.0), &robot, 0.35).unwrap();
        assert_eq!(wall.rotation_deg().abs(), 180.0);
    }
}
