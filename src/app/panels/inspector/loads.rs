//! What acts on a robot beside its cables and obstacles: a force on its tip, a moment,
//! gravity with the masses that it acts on.

use crate::app::widgets::{Form, Kind, Number};
use crate::scene::limits::{GRAVITY, Limits, MASS, TIP_FORCE, TIP_MOMENT};
use crate::scene::{Loads, Scene};
use eframe::egui::Ui;

fn plain(path: impl Into<String>, name: &str, limits: Limits) -> Number<'_> {
    Number {
        kind: Kind::Plain,
        ..Number::length(path, name, limits)
    }
}

/// Shows their fields.
pub(super) fn show(ui: &mut Ui, form: &mut Form<'_>, scene: &mut Scene) {
    let loads = &mut scene.loads;
    for (axis, name) in ["Tip force x", "Tip force y"].into_iter().enumerate() {
        let number = plain(format!("loads.tip_force_n[{axis}]"), name, TIP_FORCE);
        form.number(ui, &number, &mut loads.tip_force_n[axis]);
    }
    form.notes(ui, "loads.tip_force_n");
    let number = plain("loads.tip_moment_nmm", "Tip moment", TIP_MOMENT);
    form.number(ui, &number, &mut loads.tip_moment_nmm);
    let mut falls = loads.gravity_m_s2 != [0.0; 2];
    let switch = ui.checkbox(&mut falls, "Gravity");
    let tip = "An arrow on the canvas, which can be turned, shows where to";
    if switch.on_hover_text(tip).changed() {
        loads.gravity_m_s2 = match falls {
            true => Loads::EARTHS_GRAVITY_M_S2,
            false => [0.0; 2],
        };
    }
    if falls {
        for (axis, name) in ["Gravity x", "Gravity y"].into_iter().enumerate() {
            let number = plain(format!("loads.gravity_m_s2[{axis}]"), name, GRAVITY);
            form.number(ui, &number, &mut loads.gravity_m_s2[axis]);
        }
    }
    form.notes(ui, "loads.gravity_m_s2");
    let robot = &mut scene.robot;
    let number = plain("robot.disk_mass_g", "Mass of a disk", MASS);
    form.number(ui, &number, &mut robot.disk_mass_g);
    let number = plain("robot.backbone_mass_g", "Backbone’s mass", MASS);
    form.number(ui, &number, &mut robot.backbone_mass_g);
}
