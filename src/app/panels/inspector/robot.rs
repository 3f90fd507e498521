//! The robot's fields.

use super::{cables, friction, loads, spacing};
use crate::app::look::{Tokens, icon, icons, semibold};
use crate::app::widgets::{Form, Kind, Number, row, with_form};
use crate::app::workbench::{Refinement, Workbench};
use crate::scene::limits::{
    ANGLE, BENDING_STIFFNESS, CABLE_OFFSET, COORDINATE, DISK_RADIUS, DISK_THICKNESS, LENGTH,
    LINE_DIAMETER, Limits,
};
use crate::scene::{Candidates, Contact, Mechanics, Robot, Scene};
use eframe::egui::{self, Button, RichText, Ui, Vec2, WidgetInfo};

/// Shows the robot's fields.
pub fn show(ui: &mut Ui, bench: &mut Workbench) {
    ui.label(RichText::new("Robot").font(semibold(14.0)));
    ui.add_space(4.0);
    with_form(bench, |scene, form| backbone(ui, form, &mut scene.robot));
    meaning(ui, bench);
    ui.add_space(12.0);
    row::heading(ui, "Disks and cable");
    with_form(bench, |scene, form| {
        spacing::disks(ui, form, &mut scene.robot);
        disks(ui, form, scene);
    });
    ui.add_space(12.0);
    row::heading(ui, "Accuracy");
    with_form(bench, |scene, form| spacing::accuracy(ui, form, scene));
    refined(ui, bench);
    ui.add_space(12.0);
    cables::show(ui, bench);
    with_form(bench, |scene, form| {
        if scene.model.mechanics == Mechanics::Sliding {
            row::heading(ui, "Friction");
            friction::show(ui, form, scene);
            ui.add_space(12.0);
            row::heading(ui, "Loads");
            loads::show(ui, form, scene);
            ui.add_space(12.0);
        }
        row::heading(ui, "Base");
        base(ui, form, &mut scene.robot);
        ui.add_space(12.0);
        row::heading(ui, "Contact");
        contact(ui, form, &mut scene.contact);
    });
}

/// Whether what is found changes with the number of segments.
fn refined(ui: &mut Ui, bench: &mut Workbench) {
    let told = match bench
        .refined
        .told(bench.live.solution(), bench.document.stiffness())
    {
        Refinement::Unknown => {
            let button = ui.button("Does it change with n?").on_hover_text(
                "Solves the robot once more from straight, with twice the segments, and tells how \
                 far tip and forces move",
            );
            if button.clicked() {
                bench.refine();
            }
            return;
        }
        Refinement::Solving => "Solving with twice the segments…".to_owned(),
        Refinement::Impossible => "Twice the segments are more than there may be.".to_owned(),
        Refinement::Known(told) => told,
    };
    let muted = Tokens::in_ui(ui).muted;
    ui.add(egui::Label::new(RichText::new(told).small().color(muted)).wrap());
}

/// What the stiffness is good for.
fn meaning(ui: &mut Ui, bench: &Workbench) {
    let text = match bench.document.scene.robot.bending_stiffness_nmm2 {
        Some(_) => "EI: twice as stiff a backbone needs twice the load for the same shape.",
        None => "Without EI there are shapes, but no grams: no loads and no forces.",
    };
    let muted = Tokens::in_ui(ui).muted;
    let text = RichText::new(text).small().color(muted);
    ui.add(egui::Label::new(text).wrap());
}

fn length<'a>(key: &str, name: &'a str, limits: Limits) -> Number<'a> {
    Number::length(format!("robot.{key}"), name, limits)
}

fn backbone(ui: &mut Ui, form: &mut Form<'_>, robot: &mut Robot) {
    let number = length("length_mm", "Length", LENGTH);
    form.number(ui, &number, &mut robot.length_mm);
    let number = length("backbone_diameter_mm", "Diameter", LINE_DIAMETER);
    form.number(ui, &number, &mut robot.backbone_diameter_mm);
    let number = Number {
        symbol: "EI",
        kind: Kind::Plain,
        optional: true,
        meaning: "EI, Young’s modulus times the second moment of area: the moment that bends the \
                  backbone, times the radius it bends to. All forces and loads grow in \
                  proportion; the shape under a pull does not change",
        ..length("bending_stiffness_nmm2", "Stiffness", BENDING_STIFFNESS)
    };
    form.optional(ui, &number, &mut robot.bending_stiffness_nmm2);
}

fn disks(ui: &mut Ui, form: &mut Form<'_>, scene: &mut Scene) {
    if scene.cables.is_empty() {
        cable(ui, form, scene);
    }
    rim(ui, form, scene);
}

/// The one cable that is described with the robot.
fn cable(ui: &mut Ui, form: &mut Form<'_>, scene: &mut Scene) {
    let Some(mut cable) = scene.each_cable().next() else {
        return;
    };
    let field = scene.cable_field(0, "offset_mm");
    let number = Number {
        symbol: "a",
        ..Number::length(field, "Cable offset", CABLE_OFFSET)
    };
    form.number(ui, &number, &mut cable.offset_mm);
    scene.set_offset_mm(cable.offset_mm);
    let field = scene.cable_field(0, "diameter_mm");
    let number = Number::length(field, "Cable diameter", LINE_DIAMETER);
    form.number(ui, &number, &mut cable.diameter_mm);
    scene.set_cable_diameter_mm(cable.diameter_mm);
}

fn rim(ui: &mut Ui, form: &mut Form<'_>, scene: &mut Scene) {
    let offsets = scene.each_cable().map(|cable| cable.offset_mm.abs());
    let widest = offsets.fold(0.0, f64::max);
    let mut rim = scene.rim_mm();
    let robot = &mut scene.robot;
    let number = Number {
        limits: Limits {
            min: widest,
            ..DISK_RADIUS
        },
        ..length("disk_radius_mm", "Disk radius", DISK_RADIUS)
    };
    let mut follows = robot.disk_radius_mm.is_none();
    let changed = form.number_with(ui, &number, &mut rim, |ui| follow(ui, &mut follows));
    if changed {
        robot.disk_radius_mm = Some(rim);
    } else if follows {
        robot.disk_radius_mm = None;
    } else if robot.disk_radius_mm.is_none() {
        robot.disk_radius_mm = Some(rim);
    }
    let number = length("disk_thickness_mm", "Disk thickness", DISK_THICKNESS);
    form.number(ui, &number, &mut robot.disk_thickness_mm);
}

/// Whether the rim follows the cable offset: a link that can be undone.
fn follow(ui: &mut Ui, follows: &mut bool) {
    ui.spacing_mut().button_padding = Vec2::ZERO;
    let tokens = Tokens::in_ui(ui);
    let ink = if *follows {
        tokens.accent
    } else {
        tokens.muted
    };
    let button = Button::new(icon(icons::LINK).color(ink)).frame_when_inactive(false);
    let tip = if *follows {
        "The rim is where the cable is. Click to give it a radius of its own"
    } else {
        "Click to put the rim where the cable is"
    };
    let response = ui
        .add_sized(Vec2::splat(ui.spacing().interact_size.y - 4.0), button)
        .on_hover_text(tip);
    let on = *follows;
    response.widget_info(|| {
        let name = "Disk radius follows the cable offset";
        WidgetInfo::selected(egui::Role::CheckBox, ui.is_enabled(), on, name)
    });
    if response.clicked() {
        *follows = !on;
    }
}

fn base(ui: &mut Ui, form: &mut Form<'_>, robot: &mut Robot) {
    for (axis, name) in ["Base x", "Base y"].into_iter().enumerate() {
        let number = length(&format!("base_mm[{axis}]"), name, COORDINATE);
        form.number(ui, &number, &mut robot.base_mm[axis]);
    }
    let number = Number::angle("robot.base_angle_deg", "Base angle", ANGLE);
    form.number(ui, &number, &mut robot.base_angle_deg);
}

fn contact(ui: &mut Ui, form: &mut Form<'_>, contact: &mut Contact) {
    if contact.candidates == Candidates::Listed {
        let text = match contact.listed.len() {
            1 => "1 listed node".to_owned(),
            count => format!("{count} listed nodes"),
        };
        form.fixed(ui, "Parts", &text);
        form.notes(ui, "contact");
        return;
    }
    let choices = [
        (Candidates::Nodes, "Nodes".to_owned()),
        (Candidates::Body, "Body".to_owned()),
    ];
    form.choice(
        ui,
        "contact.candidates",
        (
            "Parts",
            "What obstacles keep out: the nodes of backbone and cable, as in the paper, or the \
             whole body at its own size",
        ),
        &mut contact.candidates,
        &choices,
    );
}
