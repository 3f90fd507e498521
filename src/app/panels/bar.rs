//! The bar at the top: menu, examples, what the document is called, steps back
//! and forth, the views, and the way to all commands.

use super::{menu, settings};
use crate::app::commands::Command;
use crate::app::look::{Segment, Tokens, icon, icon_button, icons, segments};
use crate::app::widgets::button;
use crate::app::workbench::{Views, Workbench};
use eframe::egui::{Align, Button, Label, Layout, RichText, Role, Ui, WidgetInfo, vec2};

/// Below these widths, in points, the bar leaves out what can be reached
/// otherwise.
const WIDE: f32 = 980.0;
const MIDDLING: f32 = 640.0;

/// Shows the bar.
pub fn show(ui: &mut Ui, bench: &mut Workbench) {
    let width = ui.available_width();
    ui.horizontal(|ui| {
        ui.spacing_mut().item_spacing.x = 4.0;
        let phone = width < MIDDLING;
        menu::show(ui, bench, !phone);
        if !phone {
            examples(ui, bench);
        }
        button(ui, bench, Command::Undo);
        button(ui, bench, Command::Redo);
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            ui.spacing_mut().item_spacing.x = 4.0;
            if !phone {
                button(ui, bench, Command::Help);
            }
            settings::show(ui, bench);
            if !phone {
                theme(ui, bench);
            }
            button(ui, bench, Command::Dock);
            button(ui, bench, Command::Outline);
            if width >= WIDE {
                ui.add_space(4.0);
                search(ui, bench);
                ui.add_space(4.0);
            } else {
                button(ui, bench, Command::Palette);
            }
            views(ui, bench, phone);
            if !phone {
                ui.add_space(4.0);
                name(ui, bench);
            }
        });
    });
}

/// What the document is called, in what room is left.
fn name(ui: &mut Ui, bench: &Workbench) {
    ui.with_layout(Layout::left_to_right(Align::Center), |ui| {
        ui.add_space(8.0);
        let tokens = Tokens::in_ui(ui);
        let changed = bench.document.is_changed();
        let mark = if changed { " •" } else { "" };
        let name = RichText::new(format!("{}{mark}", bench.document.name()));
        let place = match &bench.document.file {
            Some(file) => file.display().to_string(),
            None => "Not saved to a file".to_owned(),
        };
        let tip = if changed {
            format!("{place} (changed)")
        } else {
            place
        };
        let name = Label::new(name.color(tokens.muted)).truncate();
        ui.add(name).on_hover_text(tip);
    });
}

fn examples(ui: &mut Ui, bench: &mut Workbench) {
    let label = (icon(icons::GRADUATION_CAP), RichText::new("Examples"));
    let button = Button::new(label).frame_when_inactive(false);
    let tip = Command::Examples.tip(ui.ctx());
    if ui.add(button).on_hover_text(tip).clicked() {
        bench.commands.push(Command::Examples);
    }
}

/// The theme that the button leads to.
fn theme(ui: &mut Ui, bench: &mut Workbench) {
    let (glyph, name) = if ui.visuals().dark_mode {
        (icons::SUN, "Light")
    } else {
        (icons::MOON, "Dark")
    };
    let tip = Command::Theme.tip_saying(&format!("{name} theme"), ui.ctx());
    if icon_button(ui, glyph, &tip).clicked() {
        bench.commands.push(Command::Theme);
    }
}

/// The views, of which one is chosen.
fn views(ui: &mut Ui, bench: &mut Workbench, phone: bool) {
    let views = [
        (Views::Plane, "2-D", Command::ViewPlane),
        (Views::Space, "3-D", Command::ViewSpace),
        (Views::Both, "Both", Command::ViewBoth),
    ];
    let shown = views.map(|(_, name, command)| Segment {
        name,
        title: command.entry().title,
        tip: command.tip(ui.ctx()),
        enabled: true,
    });
    // A phone has no room for both.
    let (shown, width) = match phone {
        true => (&shown[..2], 40.0),
        false => (&shown[..], 46.0),
    };
    let current = bench.preferences.views;
    let current = views.iter().position(|(view, ..)| *view == current);
    if let Some(chosen) = segments(ui, width, shown, current) {
        bench.commands.push(views[chosen].2);
    }
}

/// The way to all commands, looking like the field that it leads to.
fn search(ui: &mut Ui, bench: &mut Workbench) {
    let tokens = Tokens::in_ui(ui);
    let entry = Command::Palette.entry();
    let keys = entry
        .shortcut
        .map(|keys| ui.ctx().format_shortcut(&keys))
        .unwrap_or_default();
    let text = RichText::new("Search").color(tokens.muted);
    let button = Button::new((icon(entry.icon).color(tokens.muted), text))
        .shortcut_text(RichText::new(keys).small().color(tokens.muted))
        .fill(tokens.sunken)
        .min_size(vec2(176.0, ui.spacing().interact_size.y));
    let response = ui.add(button).on_hover_text(entry.title);
    response.widget_info(|| WidgetInfo::labeled(Role::Button, true, entry.title));
    if response.clicked() {
        bench.commands.push(Command::Palette);
    }
}
