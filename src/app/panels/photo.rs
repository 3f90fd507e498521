//! What can be done with the photograph while it is selected: how much of it
//! shows, where it lies, its scale by two points, and removing it.

use crate::app::commands::Command;
use crate::app::look::{Tokens, icon, icons, semibold};
use crate::app::widgets::{Form, Number, button, row, with_form};
use crate::app::words::shown;
use crate::app::workbench::{Photograph, Scaling, Selection, Workbench};
use crate::scene::limits::{ANGLE, COORDINATE, PHOTO_WIDTH};
use crate::scene::{Photo, Scene};
use eframe::egui::{Align, DragValue, Layout, RichText, Slider, Ui};
use std::path::Path;

/// Shows the photograph's fields.
pub fn show(ui: &mut Ui, bench: &mut Workbench) {
    let Some(photo) = bench.document.scene.photo.clone() else {
        bench.selection = Selection::Nothing;
        return;
    };
    ui.horizontal(|ui| {
        ui.label(icon(icons::IMAGE));
        ui.label(RichText::new("Photograph").font(semibold(14.0)));
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            button(ui, bench, Command::Delete);
        });
    });
    ui.add_space(4.0);
    about(ui, bench, &photo);
    ui.horizontal(|ui| {
        let label = ui.label("Opacity");
        if let Some(photo) = &mut bench.document.scene.photo {
            let mut percent = 100.0 * photo.opacity;
            let slider = Slider::new(&mut percent, 0.0..=100.0)
                .fixed_decimals(0)
                .suffix(" %");
            if ui.add(slider).labelled_by(label.id).changed() {
                photo.opacity = (percent / 100.0).clamp(0.0, 1.0);
            }
        }
    });
    with_form(bench, |scene, form| fields(ui, form, scene));
    ui.add_space(8.0);
    scale(ui, bench);
}

/// Its file and what is known of it.
fn about(ui: &mut Ui, bench: &mut Workbench, photo: &Photo) {
    let tokens = Tokens::in_ui(ui);
    let name = shown(Path::new(&photo.file));
    let (told, colour) = match bench.photos.get(photo) {
        Some(Photograph::Here { size: [w, h], .. }) => {
            (format!("{name}, {w} × {h} pixels"), tokens.muted)
        }
        Some(Photograph::Coming) => (format!("{name} is being read"), tokens.muted),
        Some(Photograph::Missing(reason)) => {
            (format!("{name} is not shown. {reason}"), tokens.warning)
        }
        None => (format!("{name} is not shown."), tokens.warning),
    };
    ui.label(RichText::new(told).small().color(colour))
        .on_hover_text(&photo.file);
    let here = matches!(
        bench.photos.get(photo),
        Some(Photograph::Here { .. } | Photograph::Coming)
    );
    if !here && ui.button("Choose the picture …").clicked() {
        bench.commands.push(Command::PlacePhoto);
    }
    ui.add_space(4.0);
}

fn fields(ui: &mut Ui, form: &mut Form<'_>, scene: &mut Scene) {
    let Some(photo) = &mut scene.photo else {
        return;
    };
    for (axis, name) in ["Centre x", "Centre y"].into_iter().enumerate() {
        let path = format!("photo.center_mm[{axis}]");
        let number = Number::length(path, name, COORDINATE);
        form.number(ui, &number, &mut photo.center_mm[axis]);
    }
    let number = Number::length("photo.width_mm", "Width", PHOTO_WIDTH);
    form.number(ui, &number, &mut photo.width_mm);
    let number = Number::angle("photo.rotation_deg", "Rotation", ANGLE);
    form.number(ui, &number, &mut photo.rotation_deg);
}

/// The scale tool, step by step.
fn scale(ui: &mut Ui, bench: &mut Workbench) {
    let Some(mut scaling) = bench.photos.scaling.clone() else {
        let button = ui.button("Scale by two points");
        if button
            .on_hover_text("Two points of known distance give the photograph its size")
            .clicked()
        {
            bench.photos.scaling = Some(Scaling::default());
        }
        return;
    };
    let mut done = false;
    row::heading(ui, "Scale by two points");
    match scaling.points.len() {
        0 => ui.label("Click a first point of the photograph."),
        1 => ui.label("Click a second one, far from the first."),
        _ => ui.label("Type how far apart they are."),
    };
    if scaling.points.len() == 2 {
        ui.horizontal(|ui| {
            let label = ui.label("Distance");
            let field = DragValue::new(&mut scaling.distance_mm)
                .speed(0.1)
                .range(1e-3..=1e6)
                .fixed_decimals(2)
                .suffix(" mm");
            ui.add(field).labelled_by(label.id);
        });
    }
    ui.horizontal(|ui| {
        let photo = bench.document.scene.photo.as_ref();
        let applied = photo.and_then(|photo| scaling.applied(photo));
        ui.add_enabled_ui(applied.is_some(), |ui| {
            if ui.button("Apply").clicked() {
                bench.document.scene.photo = applied;
                done = true;
            }
        });
        if ui.button("Cancel").clicked() {
            done = true;
        }
    });
    bench.photos.scaling = (!done).then_some(scaling);
}
