//! From a scene, in the file's units, to a problem that cannot be wrong.

use super::drive::{Drive, DrivenCable, Input, Loads};
use super::problem::{Model, Problem};
use crate::contact::{covers_base, obstacle};
use crate::geometry::Vector;
use crate::robot::{Cable, Robot};
use crate::scene::{self, Mechanics, Scene, SceneError, limits::shown};
use crate::units::{metres, millimetres, newton_square_metres, newtons};

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
        let robot = Robot::of(scene);
        let (model, drive) = match scene.model.mechanics {
            Mechanics::Equal => {
                let pull_mm = pull_mm(scene).map_err(|fault| vec![fault])?;
                (Model::Equal, Drive::of_pull(&robot, metres(pull_mm)))
            }
            Mechanics::Sliding => {
                let drive = drive(scene, &robot).map_err(|fault| vec![fault])?;
                (Model::Sliding, drive)
            }
        };
        let cables: Vec<Cable> = drive.cables.iter().map(|driven| driven.cable).collect();
        let candidates = match model {
            Model::Equal => robot.candidates(&scene.contact),
            Model::Sliding => robot.strung_candidates(&cables, &scene.contact),
        };
        let mut faults = Vec::new();
        let (least, most) = Problem::pulls(&robot, model);
        for (index, driven) in drive.cables.iter().enumerate() {
            let Input::Pull(pull) = driven.input else {
                continue;
            };
            if !(least..=most).contains(&pull) {
                let why = match model {
                    Model::Equal => "for which the segments' linkages exist, from",
                    Model::Sliding => "within the robot's length, from",
                };
                faults.push(SceneError::not_within(
                    scene.cable_field(index, "pull_mm"),
                    scene.cable(index).drive.pull_mm().unwrap_or_default(),
                    format!(
                        "{why} {} to {}",
                        shown(rounded_towards_zero(millimetres(least))),
                        shown(rounded_towards_zero(millimetres(most)))
                    ),
                    "mm",
                ));
            }
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
            Ok(match model {
                Model::Equal => Problem::from_parts(robot, drive.pull(), candidates, obstacles),
                Model::Sliding => Problem::sliding(robot, drive, candidates, obstacles),
            })
        } else {
            Err(faults)
        }
    }
}

/// The most disks of a robot with friction: where a cable sticks in all their holes,
/// there are as many rows over the whole robot, and a solve takes the cube of that.
const MOST_RUBBING_DISKS: usize = 250;

/// What drives the sliding cables of a scene.
fn drive(scene: &Scene, robot: &Robot) -> Result<Drive, SceneError> {
    let friction = &scene.friction;
    let disks = robot.segments / robot.segments_per_bay;
    if !friction.is_none() && disks > MOST_RUBBING_DISKS {
        return Err(SceneError::Conflict {
            field: "friction".to_owned(),
            problem: format!(
                "is given for a robot of {disks} disks, and each where a cable sticks costs time"
            ),
            advice: format!("take at most {MOST_RUBBING_DISKS} disks, or no friction"),
        });
    }
    let last = robot.segments / robot.segments_per_bay;
    let bay = robot.segment_length() * robot.segments_per_bay as f64;
    let cables = scene.each_cable().map(|described| {
        let last_disk = described.to_disk.map_or(last, |disk| disk as usize);
        let straight = bay * last_disk as f64;
        DrivenCable {
            cable: Cable {
                offset: metres(described.offset_mm),
                last_disk,
                compliance: described.axial_stiffness_n.map_or(0.0, |ea| straight / ea),
                diameter: metres(described.diameter_mm),
            },
            input: match described.drive {
                scene::Drive::PullMm(pull_mm) => Input::Pull(metres(pull_mm)),
                scene::Drive::LoadG(load_g) => Input::Load(newtons(load_g)),
            },
        }
    });
    let gravity = Vector::from(scene.loads.gravity_m_s2);
    let kilograms = |grams: f64| 1e-3 * grams;
    let given = &scene.robot;
    Ok(Drive {
        cables: cables.collect(),
        loads: Loads {
            tip_force: Vector::from(scene.loads.tip_force_n),
            tip_moment: metres(scene.loads.tip_moment_nmm),
            disk: kilograms(given.disk_mass_g) * gravity,
            backbone: kilograms(given.backbone_mass_g) * gravity,
        },
        stiffness: given.bending_stiffness_nmm2.map(newton_square_metres),
        friction: *friction,
    })
}

/// The pull of the one cable, where the paper's mechanics can be asked for it.
fn pull_mm(scene: &Scene) -> Result<f64, SceneError> {
    match scene.cable(0).drive {
        scene::Drive::PullMm(pull_mm) => Ok(pull_mm),
        drive @ scene::Drive::LoadG(load_g) => Err(SceneError::Conflict {
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
