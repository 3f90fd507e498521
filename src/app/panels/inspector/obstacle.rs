//! An obstacle's fields, by its shape.

use crate::app::commands::Command;
use crate::app::look::{icon, semibold};
use crate::app::widgets::{Form, Number, button, row, understated, with_form};
use crate::app::words;
use crate::app::workbench::Workbench;
use crate::scene::limits::{ANGLE, COORDINATE, CORNER_RADIUS, RADIUS, SIDE};
use crate::scene::{Scene, Shape};
use crate::units::per_millimetre;
use crate::view::Quantity;
use eframe::egui::{Align, Layout, RichText, ScrollArea, Ui, vec2};

/// Room for a polygon's points before they scroll, in rows.
const ROWS: f32 = 6.0;

/// Shows the fields of an obstacle.
pub fn show(ui: &mut Ui, bench: &mut Workbench, index: usize) {
    let Some(found) = bench.document.scene.obstacles.get(index) else {
        return;
    };
    let (glyph, word) = (words::shape_icon(&found.shape), words::shape(&found.shape));
    ui.horizontal(|ui| {
        ui.label(icon(glyph));
        ui.label(RichText::new(word).font(semibold(14.0)));
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            button(ui, bench, Command::Delete);
        });
    });
    ui.add_space(4.0);
    with_form(bench, |scene, form| fields(ui, form, scene, index));
    pressing(ui, bench, index);
}

fn fields(ui: &mut Ui, form: &mut Form<'_>, scene: &mut Scene, index: usize) {
    let Some(obstacle) = scene.obstacles.get_mut(index) else {
        return;
    };
    let at = format!("obstacle[{index}]");
    form.text(ui, &format!("{at}.name"), "Name", &mut obstacle.name);
    match &mut obstacle.shape {
        Shape::Disc {
            center_mm,
            radius_mm,
        } => {
            point(
                ui,
                form,
                &at,
                "center_mm",
                ["Centre x", "Centre y"],
                center_mm,
            );
            radius(ui, form, &at, radius_mm);
        }
        Shape::Wall {
            point_mm,
            rotation_deg,
            corner_radius_mm,
        } => {
            point(ui, form, &at, "point_mm", ["Point x", "Point y"], point_mm);
            rotation(ui, form, &at, rotation_deg);
            corner(ui, form, &at, "Moved outward", corner_radius_mm);
        }
        Shape::Box {
            center_mm,
            size_mm,
            rotation_deg,
            corner_radius_mm,
        } => {
            point(
                ui,
                form,
                &at,
                "center_mm",
                ["Centre x", "Centre y"],
                center_mm,
            );
            for (axis, name) in ["Width", "Height"].into_iter().enumerate() {
                let number = Number::length(format!("{at}.size_mm[{axis}]"), name, SIDE);
                form.number(ui, &number, &mut size_mm[axis]);
            }
            rotation(ui, form, &at, rotation_deg);
            corner(ui, form, &at, "Corner radius", corner_radius_mm);
        }
        Shape::Capsule {
            center_mm,
            length_mm,
            radius_mm,
            rotation_deg,
        } => {
            point(
                ui,
                form,
                &at,
                "center_mm",
                ["Centre x", "Centre y"],
                center_mm,
            );
            let number = Number::length(format!("{at}.length_mm"), "Length", SIDE);
            form.number(ui, &number, length_mm);
            radius(ui, form, &at, radius_mm);
            rotation(ui, form, &at, rotation_deg);
        }
        shape @ Shape::Polygon { .. } => polygon(ui, form, &at, shape),
    }
    // What is wrong with it as a whole, such as lying over the base.
    form.notes(ui, &at);
}

fn point(
    ui: &mut Ui,
    form: &mut Form<'_>,
    at: &str,
    key: &str,
    names: [&str; 2],
    value: &mut [f64; 2],
) {
    for (axis, name) in names.into_iter().enumerate() {
        let number = Number::length(format!("{at}.{key}[{axis}]"), name, COORDINATE);
        form.number(ui, &number, &mut value[axis]);
    }
}

fn radius(ui: &mut Ui, form: &mut Form<'_>, at: &str, value: &mut f64) {
    let number = Number::length(format!("{at}.radius_mm"), "Radius", RADIUS);
    form.number(ui, &number, value);
}

fn rotation(ui: &mut Ui, form: &mut Form<'_>, at: &str, value: &mut f64) {
    let number = Number::angle(format!("{at}.rotation_deg"), "Rotation", ANGLE);
    form.number(ui, &number, value);
}

fn corner(ui: &mut Ui, form: &mut Form<'_>, at: &str, name: &str, value: &mut f64) {
    let number = Number::length(format!("{at}.corner_radius_mm"), name, CORNER_RADIUS);
    form.number(ui, &number, value);
}

fn polygon(ui: &mut Ui, form: &mut Form<'_>, at: &str, shape: &mut Shape) {
    let mut middle = shape.anchor_mm();
    let before = middle;
    point(
        ui,
        form,
        at,
        "middle_mm",
        ["Middle x", "Middle y"],
        &mut middle,
    );
    if middle != before {
        shape.move_to_mm(middle);
    }
    let Shape::Polygon {
        points_mm,
        rotation_deg,
        corner_radius_mm,
    } = shape
    else {
        return;
    };
    rotation(ui, form, at, rotation_deg);
    corner(ui, form, at, "Corner radius", corner_radius_mm);
    ui.add_space(12.0);
    row::heading(ui, "Vertices, in mm");
    let height = row::height(ui);
    let most = ROWS * (height + ui.spacing().item_spacing.y);
    ScrollArea::vertical()
        .id_salt("vertices")
        .max_height(most)
        .auto_shrink([false, true])
        .show_rows(ui, height, points_mm.len(), |ui, rows| {
            for row in rows {
                ui.horizontal(|ui| {
                    ui.weak(format!("{row}"));
                    ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
                        let width = 88.0;
                        for (axis, letter) in [(1, "y"), (0, "x")] {
                            let path = format!("{at}.points_mm[{row}][{axis}]");
                            let name = format!("Vertex {row} {letter}");
                            let number = Number::length(path, &name, COORDINATE);
                            let value = &mut points_mm[row][axis];
                            form.value(ui, &number, value, vec2(width, row::height(ui)), |field| {
                                field.accessible_name(name.as_str())
                            });
                        }
                    });
                });
                for axis in 0..2 {
                    form.notes(ui, &format!("{at}.points_mm[{row}][{axis}]"));
                }
            }
        });
    form.notes(ui, &format!("{at}.points_mm"));
}

/// How hard the robot presses on the obstacle.
fn pressing(ui: &mut Ui, bench: &mut Workbench, index: usize) {
    let Some(solution) = bench.live.solution() else {
        return;
    };
    let on = solution.contacts.iter().filter(|it| it.obstacle == index);
    let total: f64 = on.clone().map(|contact| contact.multiplier).sum();
    ui.add_space(12.0);
    row::heading(ui, "Contact");
    let count = Quantity::fixed(on.count() as f64, 0, "");
    row::fact(ui, "Contacts", "", &count);
    let written = Quantity::significant(per_millimetre(total), "rad²/mm");
    if let Some(force) = bench.document.force(total) {
        row::fact(ui, "Forces", "Σ F", &force);
        understated(ui, bench);
    }
    row::fact(ui, "Multipliers", "Σ λ", &written);
}
