//! The question in front of whatever would throw unsaved work away.

use super::frame::{main_button, modal, plain_button, room};
use crate::app::files::{self, Saving};
use crate::app::look::semibold;
use crate::app::workbench::{Intent, Workbench};
use eframe::egui::{Align, Context, Key, Layout, Modifiers, RichText};

/// What was answered.
#[derive(Clone, Copy)]
enum Answer {
    Save,
    Discard,
    Cancel,
}

pub(super) fn show(ctx: &Context, bench: &mut Workbench) {
    let Some(intent) = &bench.files.guarded else {
        return;
    };
    let what = match intent {
        Intent::Close => "before the window closes",
        _ => "before another scene takes its place",
    };
    let title = format!("Save the changes to {}?", bench.document.name());
    let (width, _) = room(ctx, 440.0, 0.0);
    let response = modal(ctx, "guard").show(ctx, |ui| {
        ui.set_width(width);
        ui.label(RichText::new(title).font(semibold(18.0)));
        ui.add_space(4.0);
        ui.label(format!(
            "What you have changed is not saved. Save it {what}, or discard it."
        ));
        ui.add_space(16.0);
        let mut answer = None;
        ui.horizontal(|ui| {
            if plain_button(ui, "Discard").clicked() {
                answer = Some(Answer::Discard);
            }
            ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
                let save = main_button(ui, "Save");
                if save.clicked() {
                    answer = Some(Answer::Save);
                }
                if plain_button(ui, "Cancel").clicked() {
                    answer = Some(Answer::Cancel);
                }
                // The keyboard starts at what loses nothing.
                if ui.memory(|memory| memory.focused().is_none()) {
                    save.request_focus();
                }
            });
        });
        if ui.input_mut(|input| input.consume_key(Modifiers::COMMAND, Key::S)) {
            answer = Some(Answer::Save);
        }
        answer
    });
    let answer = match response.inner {
        None if response.should_close() => Some(Answer::Cancel),
        answer => answer,
    };
    let Some(answer) = answer else {
        return;
    };
    let Some(intent) = bench.files.guarded.take() else {
        return;
    };
    match answer {
        Answer::Cancel => {}
        Answer::Discard => files::carry_out(bench, intent, ctx),
        Answer::Save => files::save(bench, Saving::InPlace, Some(intent)),
    }
}
