//! Short words at the window's edge: what is being told in passing.
//!
//! Its own few lines rather than a crate's, because they wrap on a phone, can
//! be reached by keyboard and are read out by screen readers.

use crate::app::canvas::{Rather, place};
use crate::app::look::{Tokens, icon_button, icon_font, icons};
use crate::app::workbench::{Notice, Notices, Tone};
use eframe::egui::{
    Align, Area, Context, Frame, Id, Label, Layout, Margin, Order, Rect, RichText, Ui, vec2,
};

/// Shows the notices in a part of the window, near its lower edge but clear of what is
/// kept, and drops those whose time has
/// come.
pub fn show(ctx: &Context, notices: &mut Notices, room: Rect, kept: &[Rect]) {
    if notices.is_empty() {
        return;
    }
    let now = ctx.input(|input| input.time);
    if let Some(left) = notices.pass(now) {
        ctx.request_repaint_after(web_time::Duration::from_secs_f64(left));
    }
    let mut dismissed = None;
    let width = (room.width() - 56.0).clamp(160.0, 400.0);
    // As large as they were in the last frame, with their frame.
    let id = Id::unique("notices height");
    let height = ctx.data(|data| data.get_temp::<f32>(id)).unwrap_or(52.0);
    let size = vec2(width, height);
    let corner = place(room, size, kept, Rather::Below);
    let shown = Area::new(Id::unique("notices"))
        .order(Order::Foreground)
        .fixed_pos(corner)
        .show(ctx, |ui| {
            ui.set_width(width);
            for (index, notice) in notices.iter().enumerate() {
                if one(ui, notice) {
                    dismissed = Some(index);
                }
            }
        });
    let now = shown.response.rect.height();
    if now != height {
        ctx.data_mut(|data| data.insert_temp(id, now));
        ctx.request_repaint();
    }
    if let Some(index) = dismissed {
        notices.dismiss(index);
    }
}

/// Shows a notice; whether it was dismissed.
fn one(ui: &mut Ui, notice: &Notice) -> bool {
    let tokens = Tokens::in_ui(ui);
    let (glyph, colour) = match notice.tone {
        Tone::Success => (icons::CHECK_CIRCLE, tokens.good),
        Tone::Information => (icons::INFO, tokens.accent),
        Tone::Trouble => (icons::WARNING_CIRCLE, tokens.error),
    };
    let frame = Frame::popup(ui.style())
        .corner_radius(10)
        .inner_margin(Margin::symmetric(12, 8));
    frame
        .show(ui, |ui| {
            ui.horizontal(|ui| {
                ui.spacing_mut().item_spacing.x = 8.0;
                ui.label(RichText::new(glyph).font(icon_font(18.0)).color(colour));
                let height = ui.spacing().interact_size.y;
                let words = vec2(ui.available_width() - 36.0, height);
                let layout = Layout::left_to_right(Align::Center);
                ui.allocate_ui_with_layout(words, layout, |ui| {
                    ui.set_min_width(words.x);
                    ui.add(Label::new(&notice.text).wrap());
                });
                icon_button(ui, icons::X, "Dismiss").clicked()
            })
            .inner
        })
        .inner
}
