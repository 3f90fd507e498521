//! The bar that offers work which an earlier window did not save. It blocks
//! nothing; as long as nobody decides, the work is kept.

use crate::app::files::{self, autosave};
use crate::app::look::{Tokens, icon, icons};
use crate::app::words::sentence;
use crate::app::workbench::{Intent, Notice, Workbench};
use eframe::egui::{Align, Button, Frame, Layout, Margin, Panel, Ui};

/// Shows the bar where there is such work.
pub fn show(ui: &mut Ui, bench: &mut Workbench) {
    let Some(unsaved) = bench.files.unsaved.first().cloned() else {
        return;
    };
    let tokens = Tokens::in_ui(ui);
    let frame = Frame::new()
        .fill(tokens.accent_soft)
        .inner_margin(Margin::symmetric(12, 6));
    Panel::top("restore").frame(frame).show(ui, |ui| {
        ui.horizontal_wrapped(|ui| {
            ui.label(icon(icons::CLOCK_COUNTER_CLOCKWISE));
            ui.label(format!(
                "{} was not saved when the window last ended.",
                unsaved.name
            ));
            ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
                if ui
                    .add(Button::new("Discard").frame_when_inactive(false))
                    .clicked()
                {
                    autosave::forget(bench, &unsaved.drawer);
                }
                if ui.button("Restore").clicked() {
                    match unsaved.arrival() {
                        Ok(arrival) => {
                            let intent = Intent::Scene(Box::new(arrival));
                            files::request(bench, intent, ui.ctx());
                        }
                        Err(fault) => {
                            let fault = sentence(&fault.to_string());
                            bench.notices.tell(Notice::trouble(fault));
                        }
                    }
                }
            });
        });
    });
}
