//! A field for a path, where the system has no dialog for files to show.

use super::frame::{main_button, modal, plain_button, room};
use crate::app::files;
use crate::app::look::semibold;
use crate::app::platform::Errand;
use crate::app::workbench::Workbench;
use eframe::egui::{Align, Context, Key, Layout, RichText, TextEdit};
use std::path::PathBuf;

pub(super) fn show(ctx: &Context, bench: &mut Workbench) {
    let Some((errand, text)) = &mut bench.files.typing else {
        return;
    };
    let errand = *errand;
    let (title, action) = match errand {
        Errand::Scene => ("Open a scene", "Open"),
        Errand::Measurements => ("Import measurements", "Import"),
        Errand::Photo | Errand::KnownPhoto => ("Place a photograph", "Place"),
        Errand::Save => ("Save the scene", "Save"),
        Errand::Picture(_) => ("Export a picture", "Save"),
        Errand::Table => ("Export a table", "Save"),
    };
    let (width, _) = room(ctx, 520.0, 0.0);
    let response = modal(ctx, "path").show(ctx, |ui| {
        ui.set_width(width);
        ui.label(RichText::new(title).font(semibold(18.0)));
        ui.add_space(4.0);
        ui.label("This system shows no dialog for files. Type where the file is:");
        ui.add_space(8.0);
        let field = TextEdit::singleline(text).desired_width(f32::INFINITY);
        let field = ui.add(field).accessible_name("Path");
        // Before it takes the focus again.
        let entered = field.lost_focus() && ui.input(|input| input.key_pressed(Key::Enter));
        if ui.memory(|memory| memory.focused().is_none()) {
            field.request_focus();
        }
        ui.add_space(16.0);
        let mut answer = None;
        let is_typed = !text.trim().is_empty();
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            let done = ui
                .add_enabled_ui(is_typed, |ui| main_button(ui, action))
                .inner;
            if is_typed && (done.clicked() || entered) {
                answer = Some(Some(PathBuf::from(text.trim())));
            }
            if plain_button(ui, "Cancel").clicked() {
                answer = Some(None);
            }
        });
        answer
    });
    let answer = match response.inner {
        None if response.should_close() => Some(None),
        answer => answer,
    };
    if let Some(path) = answer {
        files::typed(bench, path);
    }
}
