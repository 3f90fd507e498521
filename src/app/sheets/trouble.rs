//! Something that did not work: what, every reason, and a way out.

use super::frame::{Stays, caption, main_button, modal, plain_button, room};
use crate::app::look::{Tokens, icon_font, icons, semibold};
use crate::app::workbench::{Trouble, Workbench};
use eframe::egui::{Align, Context, Layout, RichText, ScrollArea};

pub(super) fn show(ctx: &Context, bench: &mut Workbench, trouble: &Trouble, fresh: bool) -> Stays {
    let (width, height) = room(ctx, 520.0, 360.0);
    let response = modal(ctx, "trouble").show(ctx, |ui| {
        ui.set_width(width);
        let tokens = Tokens::in_ui(ui);
        ui.horizontal(|ui| {
            let sign = RichText::new(icons::WARNING_CIRCLE).font(icon_font(22.0));
            ui.label(sign.color(tokens.error));
            ui.label(RichText::new(&trouble.title).font(semibold(18.0)));
        });
        ui.add_space(8.0);
        if trouble.reasons.len() > 1 {
            caption(ui, &format!("{} faults", trouble.reasons.len()));
        }
        ScrollArea::vertical().max_height(height).show(ui, |ui| {
            for reason in &trouble.reasons {
                ui.horizontal_top(|ui| {
                    if trouble.reasons.len() > 1 {
                        ui.label(RichText::new("•").color(tokens.muted));
                    }
                    ui.label(reason);
                });
                ui.add_space(2.0);
            }
        });
        if let Some(advice) = &trouble.advice {
            ui.add_space(8.0);
            ui.label(RichText::new(advice).color(tokens.muted));
        }
        ui.add_space(16.0);
        let mut closed = false;
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            let first = match &trouble.offer {
                Some((label, command)) => {
                    let offer = main_button(ui, label);
                    if offer.clicked() {
                        bench.commands.push(*command);
                        closed = true;
                    }
                    closed |= plain_button(ui, "Close").clicked();
                    offer
                }
                None => {
                    let close = main_button(ui, "Close");
                    closed = close.clicked();
                    close
                }
            };
            if fresh {
                first.request_focus();
            }
        });
        closed
    });
    Stays::unless(response.inner || response.should_close())
}
