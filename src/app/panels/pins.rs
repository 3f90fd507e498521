//! The pinned robots: what the live one has more of than each of them, and the way to
//! let them go.

use crate::app::look::{Tokens, semibold};
use crate::app::widgets::row;
use crate::app::workbench::{Pin, Workbench};
use eframe::egui::{
    self, Align, Align2, FontId, Layout, Rect, RichText, Role, Sense, Ui, WidgetInfo, pos2, vec2,
};

/// Height of a row, in points, and the least width of its name.
const ROW: f32 = 20.0;
const NAME: f32 = 68.0;

/// Shows them; nothing where none is pinned.
pub fn show(ui: &mut Ui, bench: &mut Workbench) {
    if bench.pins.all().is_empty() {
        return;
    }
    ui.horizontal(|ui| {
        row::heading(ui, "Now, less what is pinned");
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            let text = RichText::new("Let all go").small();
            let button = egui::Button::new(text).frame_when_inactive(false);
            if ui
                .add(button)
                .on_hover_text("Removes all pinned robots")
                .clicked()
            {
                bench.pins.clear();
            }
        });
    });
    let tokens = Tokens::in_ui(ui);
    let count = bench.pins.all().len() as f32;
    let width = ((ui.available_width() - NAME) / count).min(72.0);
    let column = |rect: Rect, index: usize| rect.right() - (count - 1.0 - index as f32) * width;
    let mut gone = None;
    let size = vec2(ui.available_width(), ROW);
    let (rect, _) = ui.allocate_exact_size(size, Sense::hover());
    for (index, pin) in bench.pins.all().iter().enumerate() {
        let right = column(rect, index);
        let area = Rect::from_min_max(pos2(right - width, rect.top()), pos2(right, rect.bottom()));
        let response = ui.interact(area, ui.scope_id().with(pin.letter), Sense::click());
        let name = format!("Let {} go", pin.letter);
        response.widget_info(|| WidgetInfo::labeled(Role::Button, true, &name));
        row::focus(ui, &response);
        let at = pos2(right, rect.center().y);
        let letter = pin.letter.to_string();
        let ink = pin.ink(&tokens);
        ui.painter()
            .text(at, Align2::RIGHT_CENTER, letter, semibold(12.0), ink);
        if response.on_hover_text(format!("{name}: click")).clicked() {
            gone = Some(pin.letter);
        }
    }
    if let Some(live) = bench.compared() {
        for measure in Pin::MEASURES {
            let all = bench.pins.all().iter();
            let told: Vec<String> = all
                .map(|pin| {
                    pin.difference(live, measure)
                        .unwrap_or_else(|| "–".to_owned())
                })
                .collect();
            if told.iter().all(|one| one == "–") {
                continue;
            }
            let (rect, response) = ui.allocate_exact_size(size, Sense::hover());
            let words = format!("{}: {}", measure.0, told.join(", "));
            response.widget_info(|| WidgetInfo::labeled(Role::Label, true, &words));
            let small = FontId::proportional(12.0);
            let painter = ui.painter();
            let at = rect.left_center();
            painter.text(
                at,
                Align2::LEFT_CENTER,
                measure.0,
                small.clone(),
                tokens.muted,
            );
            for (index, digits) in told.iter().enumerate() {
                let at = pos2(column(rect, index), rect.center().y);
                painter.text(at, Align2::RIGHT_CENTER, digits, small.clone(), tokens.text);
            }
        }
    }
    if let Some(letter) = gone {
        bench.pins.remove(letter);
    }
    ui.add_space(16.0);
}
