//! The settings: theme, size of everything, and whether things move by
//! themselves.

use crate::app::commands::Command;
use crate::app::look::{Tokens, icon_button, semibold};
use crate::app::workbench::{Preferences, Workbench};
use eframe::egui::{
    Align, Frame, Id, Layout, Margin, Popup, PopupCloseBehavior, RichText, Slider, ThemePreference,
    Ui,
};

/// The id of the settings' popover, to open it from elsewhere.
pub fn settings_id() -> Id {
    Id::unique("settings")
}

/// Shows the button of the settings, and the settings while they are open.
pub fn show(ui: &mut Ui, bench: &mut Workbench) {
    let tip = Command::Settings.tip(ui.ctx());
    let button = icon_button(ui, Command::Settings.entry().icon, &tip);
    if button.clicked() {
        Popup::toggle_id(ui.ctx(), settings_id());
    }
    Popup::menu(&button)
        .id(settings_id())
        .open_memory(None)
        .frame(Frame::menu(ui.style()).inner_margin(Margin::same(12)))
        .close_behavior(PopupCloseBehavior::CloseOnClickOutside)
        .show(|ui| contents(ui, &mut bench.preferences));
}

fn contents(ui: &mut Ui, preferences: &mut Preferences) {
    ui.set_width(280.0);
    ui.spacing_mut().item_spacing.y = 10.0;
    ui.label(RichText::new("Settings").font(semibold(14.0)));
    row(ui, "Theme", |ui| {
        for (theme, name) in [
            (ThemePreference::Dark, "Dark"),
            (ThemePreference::Light, "Light"),
            (ThemePreference::System, "System"),
        ] {
            ui.selectable_value(&mut preferences.theme, theme, name);
        }
    });
    row(ui, "Size", |ui| {
        let (least, most) = Preferences::ZOOMS;
        // Changing the size of the slider under the pointer would make it run
        // away: it is taken when the pointer lets go.
        let id = ui.scope_id().with("size");
        let held = ui.data(|data| data.get_temp::<f32>(id));
        let mut percent = held.unwrap_or(100.0 * preferences.zoom);
        let slider = Slider::new(&mut percent, 100.0 * least..=100.0 * most)
            .step_by(5.0)
            .fixed_decimals(0)
            .suffix(" %");
        let response = ui.add(slider).on_hover_text("Size of everything");
        if response.dragged() {
            ui.data_mut(|data| data.insert_temp(id, percent));
        } else {
            if response.changed() || held.is_some() {
                preferences.zoom = percent / 100.0;
                preferences.bring_into_range();
            }
            ui.data_mut(|data| data.remove_temp::<f32>(id));
        }
    });
    ui.checkbox(&mut preferences.still, "Reduced motion");
    ui.label(
        RichText::new("Kept for the next time.")
            .small()
            .color(Tokens::in_ui(ui).muted),
    );
}

fn row(ui: &mut Ui, name: &str, content: impl FnOnce(&mut Ui)) {
    ui.horizontal(|ui| {
        ui.label(name);
        ui.with_layout(Layout::right_to_left(Align::Center), content);
    });
}
