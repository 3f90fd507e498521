//! The menu: all commands by group, from their list, and the recent files.

use crate::app::commands::{ALL, Command, Group};
use crate::app::files;
use crate::app::look::{Tokens, fits_fingers, icon, icons, semibold};
use crate::app::widgets::row;
use crate::app::words::shown;
use crate::app::workbench::Workbench;
use eframe::egui::containers::menu::MenuButton;
use eframe::egui::{Button, RichText, Role, ScrollArea, Ui, WidgetInfo, vec2};

/// Height of what a menu of the whole window leaves free, in points.
const BESIDES: f32 = 96.0;

/// Shows the menu's button, with the program's name or without, and the menu while it is open.
pub fn show(ui: &mut Ui, bench: &mut Workbench, named: bool) {
    let tokens = Tokens::in_ui(ui);
    let title = RichText::new("Sinew")
        .font(semibold(14.0))
        .color(tokens.text);
    let button = if named {
        Button::new((icon(icons::LIST), title))
    } else {
        Button::new(icon(icons::LIST)).min_size(vec2(32.0, 32.0))
    };
    let button = button.frame_when_inactive(false);
    let (button, _) = MenuButton::from_button(button).ui(ui, |ui| {
        if fits_fingers(ui) {
            return flat(ui, bench);
        }
        ui.set_min_width(160.0);
        for group in Group::ALL {
            ui.menu_button(group.title(), |ui| {
                ui.set_min_width(248.0);
                items(ui, bench, group);
            });
        }
    });
    button
        .on_hover_text("Menu")
        .widget_info(|| WidgetInfo::labeled(Role::Button, true, "Menu"));
}

/// All groups below each other: a finger does not rest on what opens another
/// menu, and a phone has no room for that beside this one.
fn flat(ui: &mut Ui, bench: &mut Workbench) {
    let most = ui.ctx().content_rect().height() - BESIDES;
    ScrollArea::vertical().max_height(most).show(ui, |ui| {
        ui.set_min_width(248.0);
        for group in Group::ALL {
            ui.add_space(8.0);
            row::heading(ui, group.title());
            items(ui, bench, group);
        }
    });
}

fn items(ui: &mut Ui, bench: &mut Workbench, group: Group) {
    for entry in ALL.iter().filter(|entry| entry.group == group) {
        item(ui, bench, entry.command);
        if entry.command == Command::Open {
            recent(ui, bench);
        }
    }
}

fn item(ui: &mut Ui, bench: &mut Workbench, command: Command) {
    let entry = command.entry();
    let muted = Tokens::in_ui(ui).muted;
    let mut button = Button::new((icon(entry.icon).color(muted), entry.title));
    if let Some(keys) = &entry.shortcut {
        let keys = ui.ctx().format_shortcut(keys);
        button = button.shortcut_text(RichText::new(keys).small().color(muted));
    }
    if ui.add_enabled(bench.allows(command), button).clicked() {
        bench.commands.push(command);
        ui.close();
    }
}

/// The recent files, in a menu of their own.
fn recent(ui: &mut Ui, bench: &mut Workbench) {
    if bench.files.recent.is_empty() {
        return;
    }
    let muted = Tokens::in_ui(ui).muted;
    let mut chosen = None;
    let head = (icon(icons::CLOCK_COUNTER_CLOCKWISE).color(muted), "Recent");
    ui.menu_button(head, |ui| {
        ui.set_min_width(200.0);
        for path in &bench.files.recent {
            let whole = path.to_string_lossy();
            if ui.button(shown(path)).on_hover_text(whole).clicked() {
                chosen = Some(path.clone());
                ui.close();
            }
        }
    });
    if let Some(path) = chosen {
        files::reopen(bench, path);
    }
}
