//! From a scene, in the file's units, to a problem that cannot be wrong.

use super::problem::Problem;
use crate::contact::{covers_base, obstacle};
use crate::robot::Robot;
use crate::scene::{self, Drive, Mechanics, Scene, SceneError, limits::shown};
use crate::units::{metres, millimetres};

impl Problem {
    /// The problem a scene describes.
    ///
    /// # Errors
    /// The first of [`Problem::faults`].
    pub fn new(scene: &Scene) -> Result<Self, SceneError> {
        match Self::parse(scene) {
            Ok(problem) => Ok(problem),
            Err(mut faults) => Err(faults.swap_remove(0)),
        }
    }

    /// Everything that keeps a scene from being solved, in the order of the
    /// file: fields out of range ([`Scene::faults`]) or, where there are none,
    /// a pull that no linkage can take and obstacles over the base.
    pub fn faults(scene: &Scene) -> Vec<SceneError> {
        Self::parse(scene).err().unwrap_or_default()
    }

    /// The problem a scene describes.
    ///
    /// # Errors
    /// All of [`Problem::faults`], at least one.
    pub fn parse(scene: &Scene) -> Result<Self, Vec<SceneError>> {
        let faults = scene.faults();
        if !faults.is_empty() {
            return Err(faults);
        }
        let pull_mm = pull_mm(scene).map_err(|fault| vec![fault])?;
        let robot = Robot::of(scene);
        let candidates = robot.candidates(&scene.contact);
        let mut faults = Vec::new();
        let pull = metres(pull_mm);
        let (least, most) = robot.pull_range();
        if !(least..=most).contains(&pull) {
            faults.push(SceneError::not_within(
                scene.cable_field(0, "pull_mm"),
                pull_mm,
                format!(
                    "for which the segments' linkages exist, from {} to {}",
                    shown(rounded_towards_zero(millimetres(least))),
                    shown(rounded_towards_zero(millimetres(most)))
                ),
                "mm",
            ));
        }
        let mut obstacles = Vec::new();
        for (index, described) in scene.obstacles.iter().enumerate() {
            match obstacle(&described.shape) {
                Some(obstacle) => {
                    if covers_base(&robot, &scene.contact, &obstacle) {
                        faults.push(over_base(index, described));
                    }
                    obstacles.push(obstacle);
                }
                None => faults.push(SceneError::Geometry {
                    field: format!("obstacle[{index}].points_mm"),
                    problem: "spans no area to within rounding".to_owned(),
                    advice: "move its vertices apart".to_owned(),
                }),
            }
        }
        if faults.is_empty() {
            Ok(Problem::from_parts(robot, pull, candidates, obstacles))
        } else {
            Err(faults)
        }
    }
}

/// The pull of the one cable, where this mechanics can be asked for it.
fn pull_mm(scene: &Scene) -> Result<f64, SceneError> {
    if scene.model.mechanics == Mechanics::Sliding {
        return Err(SceneError::Conflict {
            field: "model.mechanics".to_owned(),
            problem: "is \"sliding\", also where it is left out, and this program cannot solve \
                      that model yet"
                .to_owned(),
            advice: "set it to \"equal\" for the paper's".to_owned(),
        });
    }
    match scene.cable(0).drive {
        Drive::PullMm(pull_mm) => Ok(pull_mm),
        drive @ Drive::LoadG(load_g) => Err(SceneError::Conflict {
            field: scene.cable_field(0, drive.key()),
            problem: format!(
                "is {} g, and this program cannot solve the paper's model for a load yet",
                shown(load_g)
            ),
            advice: "set pull_mm in its place".to_owned(),
        }),
    }
}

/// Two decimals, so that the bound named in a message is itself allowed.
fn rounded_towards_zero(value: f64) -> f64 {
    (value * 100.0).trunc() / 100.0
}

fn over_base(index: usize, obstacle: &scene::Obstacle) -> SceneError {
    let name = obstacle.name.as_deref().unwrap_or(obstacle.shape.word());
    SceneError::Geometry {
        field: format!("obstacle[{index}] ({name})"),
        problem: "covers the robot's base, which cannot move".to_owned(),
        advice: "move or shrink it until it is clear of the first disk".to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::super::four_bar::FourBar;
    use super::*;
    use crate::scene::{Candidates, Shape};

    fn check(edit: impl Fn(&mut Scene), expect: &str) {
        let mut scene = Scene {
            obstacles: vec![
                Shape::Disc {
                    center_mm: [40.0, 100.0],
                    radius_mm: 10.0,
                }
                .into(),
            ],
            ..Scene::default()
        };
        edit(&mut scene);
        let found = match Problem::new(&scene) {
            Ok(_) => "fine".to_owned(),
            Err(error) => error.to_string(),
        };
        assert_eq!(found, expect);
    }

    #[test]
    fn what_cannot_exist_is_told_with_its_bounds() {
        check(|_| {}, "fine");
        check(
            |scene| scene.set_pull_mm(176.5),
            "actuation.pull_mm is 176.5 mm; set it to a value for which the segments' linkages \
             exist, from -286.9 to 176.4 mm",
        );
        check(|scene| scene.set_pull_mm(176.4), "fine");
        check(
            |scene| {
                scene.obstacles[0].shape = Shape::Disc {
                    center_mm: [8.0, 9.0],
                    radius_mm: 10.0,
                }
            },
            "obstacle[0] (disc) covers the robot's base, which cannot move; move or shrink it \
             until it is clear of the first disk",
        );
        // A thin bar between the base's two points covers neither of them.
        check(
            |scene| {
                scene.obstacles[0].shape = Shape::Capsule {
                    center_mm: [4.0, 0.0],
                    length_mm: 20.0,
                    radius_mm: 0.5,
                    rotation_deg: 90.0,
                }
            },
            "fine",
        );
        check(
            |scene| {
                scene.contact.candidates = Candidates::Body;
                scene.obstacles[0].shape = Shape::Capsule {
                    center_mm: [4.0, 0.0],
                    length_mm: 20.0,
                    radius_mm: 0.5,
                    rotation_deg: 90.0,
                }
            },
            "obstacle[0] (capsule) covers the robot's base, which cannot move; move or shrink it \
             until it is clear of the first disk",
        );
    }

    #[test]
    fn the_pull_range_ends_where_the_linkage_does() {
        let robot = Robot::of(&Scene::default());
        let (least, most) = robot.pull_range();
        for pull in [least, most] {
            let n = robot.segments as f64;
            let segment = FourBar::new(robot.length / n, pull / n, robot.offset);
            assert!(segment.free_bend().abs() <= super::super::MOST_BEND + 1e-12);
            assert!(segment.cable() > 0.0 && segment.at(0.0).cost[0].is_finite());
        }
    }
}
