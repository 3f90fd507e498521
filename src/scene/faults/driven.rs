//! Faults of what drives the robot and acts on it: cables, friction, loads.

use std::fmt::Display;

use super::Faults;
use crate::scene::keys::missing_at;
use crate::scene::limits::{
    AXIAL_STIFFNESS, BASE_LOSS, CABLE_OFFSET, CABLE_SIDE, CABLES, FRICTION, GRAVITY, LINE_DIAMETER,
    LOAD, Limits, PULL, TIP_FORCE, TIP_MOMENT, TO_DISK, shown,
};
use crate::scene::{Cable, Drive, Friction, Mechanics, Scene, SceneError};

/// Cables are described one way or the other, and each can be meant.
pub(super) fn cables(faults: &mut Faults, scene: &Scene) {
    one_way(faults, scene);
    if let Some(actuation) = scene.actuation {
        driven(faults, scene, "actuation", actuation.drive);
    }
    if faults.count("cable", scene.cables.len(), CABLES) {
        for (k, cable) in scene.cables.iter().enumerate() {
            one(faults, scene, format_args!("cable[{k}]"), cable);
        }
    }
}

fn one_way(faults: &mut Faults, scene: &Scene) {
    let robot = &scene.robot;
    let with_robot = (robot.cable_offset_mm, &scene.actuation);
    if scene.cables.is_empty() {
        match with_robot {
            (Some(_), Some(_)) => {}
            (Some(_), None) => faults.0.push(missing_at("actuation")),
            (None, Some(_)) => faults.0.push(missing_at("robot.cable_offset_mm")),
            (None, None) => faults.0.push(SceneError::MissingKey {
                path: "actuation".to_owned(),
                what: "robot.cable_offset_mm with a table headed [actuation] for one cable, or a \
                       table under its own [[cable]] for each"
                    .to_owned(),
            }),
        }
        return;
    }
    let stray = match with_robot {
        (Some(_), _) => "robot.cable_offset_mm",
        (None, Some(_)) => "actuation",
        (None, None) => {
            if robot.cable_diameter_mm != 0.0 {
                faults.conflict(
                    "robot.cable_diameter_mm",
                    "stands beside [[cable]], and there each cable has its own",
                    "write it as diameter_mm under each [[cable]]",
                );
            }
            return;
        }
    };
    faults.conflict(
        stray,
        "stands beside [[cable]], and cables are described one way or the other",
        "remove robot.cable_offset_mm and [actuation], or every [[cable]]",
    );
}

fn one(faults: &mut Faults, scene: &Scene, at: impl Display + Copy, cable: &Cable) {
    let offset = cable.offset_mm;
    if faults.number(at, "offset_mm", offset, CABLE_SIDE) && !CABLE_OFFSET.contain(offset.abs()) {
        let (least, most) = (shown(CABLE_OFFSET.min), shown(CABLE_OFFSET.max));
        let allowed = format!("from {least} to {most}, or from -{most} to -{least}");
        faults.not_within(at, "offset_mm", offset, allowed, CABLE_SIDE);
    }
    driven(faults, scene, at, cable.drive);
    if let Some(disk) = cable.to_disk {
        let last_disk = scene.last_disk();
        let fine = faults.number(at, "to_disk", disk.into(), TO_DISK);
        if fine && last_disk > 0 && disk > last_disk {
            let allowed = format!("from 1 to the last disk, {last_disk}");
            faults.not_within(at, "to_disk", disk.into(), allowed, TO_DISK);
        }
    }
    if let Some(stiffness) = cable.axial_stiffness_n {
        let key = "axial_stiffness_n";
        let fine = faults.number(at, key, stiffness, AXIAL_STIFFNESS);
        // What the paper's model does not know needs no stiffness either.
        if fine && scene.model.mechanics == Mechanics::Sliding {
            let value = || with_unit(stiffness, AXIAL_STIFFNESS);
            needs_stiffness(faults, scene, format_args!("{at}.{key}"), value);
        }
    }
    faults.number(at, "diameter_mm", cable.diameter_mm, LINE_DIAMETER);
}

fn driven(faults: &mut Faults, scene: &Scene, at: impl Display, drive: Drive) {
    let key = drive.key();
    match drive {
        Drive::PullMm(pull) => {
            faults.number(at, key, pull, PULL);
        }
        Drive::LoadG(load) => {
            if faults.number(&at, key, load, LOAD) {
                let value = || with_unit(load, LOAD);
                needs_stiffness(faults, scene, format_args!("{at}.{key}"), value);
            }
        }
    }
}

pub(super) fn friction(faults: &mut Faults, friction: &Friction) {
    let at = "friction";
    faults.number(at, "holes", friction.holes, FRICTION);
    faults.number(at, "contacts", friction.contacts, FRICTION);
    faults.number(at, "base_loss", friction.base_loss, BASE_LOSS);
}

pub(super) fn loads(faults: &mut Faults, scene: &Scene) {
    let loads = &scene.loads;
    // What the paper's model does not know needs no stiffness either.
    let sliding = scene.model.mechanics == Mechanics::Sliding;
    for (key, [x, y], range) in [
        ("tip_force_n", loads.tip_force_n, TIP_FORCE),
        ("gravity_m_s2", loads.gravity_m_s2, GRAVITY),
    ] {
        let field = format_args!("loads.{key}");
        let fine = faults.pair(field, [x, y], range);
        if fine && sliding && [x, y] != [0.0; 2] {
            needs_stiffness(faults, scene, field, || pair(x, y, range));
        }
    }
    let (key, moment) = ("tip_moment_nmm", loads.tip_moment_nmm);
    let fine = faults.number("loads", key, moment, TIP_MOMENT);
    if fine && sliding && moment != 0.0 {
        let value = || with_unit(moment, TIP_MOMENT);
        needs_stiffness(faults, scene, format_args!("loads.{key}"), value);
    }
}

/// What a force does to a robot depends on its stiffness.
fn needs_stiffness(
    faults: &mut Faults,
    scene: &Scene,
    field: impl Display,
    value: impl FnOnce() -> String,
) {
    if scene.robot.bending_stiffness_nmm2.is_none() {
        let problem = format!(
            "is {}, and what that does to the robot depends on its stiffness",
            value()
        );
        faults.conflict(field, problem, "set robot.bending_stiffness_nmm2");
    }
}

/// A number as one would write it, with its unit.
pub(super) fn with_unit(value: f64, range: Limits) -> String {
    let unit = range.unit.symbol();
    let space = if unit.is_empty() { "" } else { " " };
    format!("{}{space}{unit}", shown(value))
}

/// Two numbers as one would write them, with their unit.
pub(super) fn pair(x: f64, y: f64, range: Limits) -> String {
    format!("[{}, {}] {}", shown(x), shown(y), range.unit.symbol())
}
