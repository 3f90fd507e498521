//! Numbers of a scene set in place: what [`Scene::set`] does through a table, many times
//! quicker, for who tries thousands of values.

use super::limits::{DISKS, shown};
use super::set::{Step, steps};
use super::{Cable, Drive, Friction, Loads, Robot, Scene, SceneError, Shape};

impl Scene {
    /// Sets a number, in the unit of its key: the same scene as [`Scene::set`] makes of
    /// the number's text, and at once where the key is there already.
    ///
    /// # Errors
    /// Those of [`Scene::set`].
    pub fn set_number(&mut self, key: &str, value: f64) -> Result<(), SceneError> {
        let key = key.trim();
        match key {
            "robot.disk_spacing_mm" => return self.set_disk_spacing(value),
            "robot.disks" if value == libm::trunc(value) && DISKS.contain(value) => {
                self.put_disks(value as u32);
                return Ok(());
            }
            _ => {}
        }
        let steps = steps(key)?;
        if let Some(place) = count(self, &steps) {
            if value.to_bits() == f64::from(value as u32).to_bits() {
                *place = value as u32;
                return Ok(());
            }
            return self.set(key, &shown(value));
        }
        match place(self, &steps) {
            Some(place) => {
                *place = value;
                Ok(())
            }
            None => self.set(key, &shown(value)),
        }
    }
}

/// Where a whole number lies, if it is there.
fn count<'a>(scene: &'a mut Scene, steps: &[Step<'_>]) -> Option<&'a mut u32> {
    match steps {
        [Step::Key("robot"), Step::Key("segments")] => Some(&mut scene.robot.segments),
        [Step::Key("robot"), Step::Key("segments_per_bay")] => {
            Some(&mut scene.robot.segments_per_bay)
        }
        [Step::Key("cable"), Step::Index(item), Step::Key("to_disk")] => {
            scene.cables.get_mut(*item)?.to_disk.as_mut()
        }
        _ => None,
    }
}

/// Where a number with digits after its point lies, if it is there.
fn place<'a>(scene: &'a mut Scene, steps: &[Step<'_>]) -> Option<&'a mut f64> {
    match steps {
        [Step::Key("robot"), Step::Key(field), parts @ ..] => {
            of_robot(&mut scene.robot, field, parts)
        }
        [Step::Key("actuation"), Step::Key(field)] => {
            of_drive(&mut scene.actuation.as_mut()?.drive, field)
        }
        [Step::Key("cable"), Step::Index(item), Step::Key(field)] => {
            of_cable(scene.cables.get_mut(*item)?, field)
        }
        [Step::Key("friction"), Step::Key(field)] => of_friction(&mut scene.friction, field),
        [Step::Key("loads"), Step::Key(field), parts @ ..] => {
            of_loads(&mut scene.loads, field, parts)
        }
        [
            Step::Key("obstacle"),
            Step::Index(item),
            Step::Key(field),
            parts @ ..,
        ] => of_shape(&mut scene.obstacles.get_mut(*item)?.shape, field, parts),
        _ => None,
    }
}

/// A number that has no parts.
fn whole<'a>(number: &'a mut f64, parts: &[Step<'_>]) -> Option<&'a mut f64> {
    parts.is_empty().then_some(number)
}

/// A part of a pair.
fn half<'a>(pair: &'a mut [f64; 2], parts: &[Step<'_>]) -> Option<&'a mut f64> {
    match parts {
        [Step::Index(part)] => pair.get_mut(*part),
        _ => None,
    }
}

fn of_robot<'a>(robot: &'a mut Robot, field: &str, parts: &[Step<'_>]) -> Option<&'a mut f64> {
    let number = match field {
        "base_mm" => return half(&mut robot.base_mm, parts),
        "length_mm" => &mut robot.length_mm,
        "cable_offset_mm" => robot.cable_offset_mm.as_mut()?,
        "disk_radius_mm" => robot.disk_radius_mm.as_mut()?,
        "disk_thickness_mm" => &mut robot.disk_thickness_mm,
        "backbone_diameter_mm" => &mut robot.backbone_diameter_mm,
        "cable_diameter_mm" => &mut robot.cable_diameter_mm,
        "bending_stiffness_nmm2" => robot.bending_stiffness_nmm2.as_mut()?,
        "disk_mass_g" => &mut robot.disk_mass_g,
        "backbone_mass_g" => &mut robot.backbone_mass_g,
        "base_angle_deg" => &mut robot.base_angle_deg,
        _ => return None,
    };
    whole(number, parts)
}

/// What drives a cable, by whichever of the two keys is asked for.
fn of_drive<'a>(drive: &'a mut Drive, field: &str) -> Option<&'a mut f64> {
    let blank = match field {
        "pull_mm" => Drive::PullMm(0.0),
        "load_g" => Drive::LoadG(0.0),
        _ => return None,
    };
    if drive.key() != blank.key() {
        *drive = blank;
    }
    match drive {
        Drive::PullMm(number) | Drive::LoadG(number) => Some(number),
    }
}

fn of_cable<'a>(cable: &'a mut Cable, field: &str) -> Option<&'a mut f64> {
    match field {
        "offset_mm" => Some(&mut cable.offset_mm),
        "axial_stiffness_n" => cable.axial_stiffness_n.as_mut(),
        "diameter_mm" => Some(&mut cable.diameter_mm),
        _ => of_drive(&mut cable.drive, field),
    }
}

fn of_friction<'a>(friction: &'a mut Friction, field: &str) -> Option<&'a mut f64> {
    match field {
        "holes" => Some(&mut friction.holes),
        "contacts" => Some(&mut friction.contacts),
        "base_loss" => Some(&mut friction.base_loss),
        _ => None,
    }
}

fn of_loads<'a>(loads: &'a mut Loads, field: &str, parts: &[Step<'_>]) -> Option<&'a mut f64> {
    match field {
        "tip_force_n" => half(&mut loads.tip_force_n, parts),
        "gravity_m_s2" => half(&mut loads.gravity_m_s2, parts),
        "tip_moment_nmm" => whole(&mut loads.tip_moment_nmm, parts),
        _ => None,
    }
}

fn of_shape<'a>(shape: &'a mut Shape, field: &str, parts: &[Step<'_>]) -> Option<&'a mut f64> {
    let number = match (shape, field) {
        (
            Shape::Disc { center_mm, .. }
            | Shape::Box { center_mm, .. }
            | Shape::Capsule { center_mm, .. },
            "center_mm",
        ) => return half(center_mm, parts),
        (Shape::Wall { point_mm, .. }, "point_mm") => return half(point_mm, parts),
        (Shape::Box { size_mm, .. }, "size_mm") => return half(size_mm, parts),
        (Shape::Polygon { points_mm, .. }, "points_mm") => {
            let [Step::Index(point), part @ ..] = parts else {
                return None;
            };
            return half(points_mm.get_mut(*point)?, part);
        }
        (Shape::Disc { radius_mm, .. } | Shape::Capsule { radius_mm, .. }, "radius_mm") => {
            radius_mm
        }
        (Shape::Capsule { length_mm, .. }, "length_mm") => length_mm,
        (
            Shape::Wall { rotation_deg, .. }
            | Shape::Box { rotation_deg, .. }
            | Shape::Capsule { rotation_deg, .. }
            | Shape::Polygon { rotation_deg, .. },
            "rotation_deg",
        ) => rotation_deg,
        (
            Shape::Wall {
                corner_radius_mm, ..
            }
            | Shape::Box {
                corner_radius_mm, ..
            }
            | Shape::Polygon {
                corner_radius_mm, ..
            },
            "corner_radius_mm",
        ) => corner_radius_mm,
        _ => return None,
    };
    whole(number, parts)
}
