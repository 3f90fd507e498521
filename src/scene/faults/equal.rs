//! What the paper's model does not know and a scene asks of it all the same.
//! Only values in their ranges are told; of the others their range is.

use std::fmt::Display;

use super::Faults;
use super::driven::{pair, with_unit};
use crate::scene::limits::{
    AXIAL_STIFFNESS, BASE_LOSS, CABLE_SIDE, CABLES, FRICTION, GRAVITY, Limits, MASS, TIP_FORCE,
    TIP_MOMENT,
};
use crate::scene::{Cable, Scene};

/// What to do about all of it.
const SLIDE: &str = "leave it out, or set model.mechanics to \"sliding\"";

/// Every fault of a scene whose mechanics is
/// [`crate::scene::Mechanics::Equal`].
pub(super) fn faults(faults: &mut Faults, scene: &Scene) {
    let robot = &scene.robot;
    for (key, mass) in [
        ("disk_mass_g", robot.disk_mass_g),
        ("backbone_mass_g", robot.backbone_mass_g),
    ] {
        unknown(faults, format_args!("robot.{key}"), mass, MASS, "weighs");
    }
    let count = scene.cables.len();
    if (2..=CABLES).contains(&count) {
        faults.conflict(
            "cable",
            format!("has {count} entries, and the robot of the paper's model has one cable"),
            format!(
                "remove {}, or set model.mechanics to \"sliding\"",
                count - 1
            ),
        );
    } else if let [only] = &scene.cables[..] {
        cable(faults, only, scene.last_disk());
    }
    let friction = &scene.friction;
    for (key, value, range) in [
        ("holes", friction.holes, FRICTION),
        ("contacts", friction.contacts, FRICTION),
        ("base_loss", friction.base_loss, BASE_LOSS),
    ] {
        unknown(faults, format_args!("friction.{key}"), value, range, "rubs");
    }
    let loads = &scene.loads;
    for (key, [x, y], range) in [
        ("tip_force_n", loads.tip_force_n, TIP_FORCE),
        ("gravity_m_s2", loads.gravity_m_s2, GRAVITY),
    ] {
        if range.contain(x) && range.contain(y) && [x, y] != [0.0; 2] {
            let problem = format!(
                "is {}, and nothing acts on the paper's model but its cable and obstacles",
                pair(x, y, range)
            );
            faults.conflict(format_args!("loads.{key}"), problem, SLIDE);
        }
    }
    let moment = loads.tip_moment_nmm;
    if TIP_MOMENT.contain(moment) && moment != 0.0 {
        let problem = format!(
            "is {}, and nothing acts on the paper's model but its cable and obstacles",
            with_unit(moment, TIP_MOMENT)
        );
        faults.conflict("loads.tip_moment_nmm", problem, SLIDE);
    }
}

fn cable(faults: &mut Faults, cable: &Cable, last_disk: u32) {
    let offset = cable.offset_mm;
    if CABLE_SIDE.contain(offset) && offset < 0.0 {
        let problem = format!(
            "is {}, and the cable of the paper's model is on the +x side",
            with_unit(offset, CABLE_SIDE)
        );
        let advice = "make it positive, or set model.mechanics to \"sliding\"";
        faults.conflict("cable[0].offset_mm", problem, advice);
    }
    if let Some(disk) = cable.to_disk
        && (1..last_disk).contains(&disk)
    {
        let problem =
            format!("is {disk}, and the cable of the paper's model ends at the last, {last_disk}");
        faults.conflict("cable[0].to_disk", problem, SLIDE);
    }
    if let Some(stiffness) = cable.axial_stiffness_n
        && AXIAL_STIFFNESS.contain(stiffness)
    {
        let problem = format!(
            "is {}, and the cable of the paper's model does not stretch",
            with_unit(stiffness, AXIAL_STIFFNESS)
        );
        faults.conflict("cable[0].axial_stiffness_n", problem, SLIDE);
    }
}

/// A number that is 0 in the paper's model, in which nothing does what the verb
/// says.
fn unknown(faults: &mut Faults, field: impl Display, value: f64, range: Limits, verb: &str) {
    if range.contain(value) && value != 0.0 {
        let value = with_unit(value, range);
        let problem = format!("is {value}, and nothing {verb} in the paper's model");
        faults.conflict(field, problem, SLIDE);
    }
}
