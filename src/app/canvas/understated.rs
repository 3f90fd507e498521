//! The mark above the legend where the arrows' forces are the paper's.

use crate::app::widgets::{is_understated, understated};
use crate::app::workbench::Workbench;
use crate::contact::Class;
use eframe::egui::{Align, Layout, Rect, Ui, UiBuilder, pos2, vec2};

/// Distance of the mark from the canvas's lower right corner, in points: above the
/// legend.
const FROM_CORNER: (f32, f32) = (12.0, 34.0);
/// Its height, and the room that its words may take, in points.
const SIZE: (f32, f32) = (220.0, 24.0);

/// Shows the mark where something presses and its force is understated.
pub fn show(ui: &mut Ui, bench: &mut Workbench, rect: Rect) {
    let greyed = bench.live.drawing().standing.is_greyed();
    let presses = bench.live.solution().is_some_and(|solution| {
        let mut contacts = solution.contacts.iter();
        contacts.any(|contact| contact.class == Class::Pressing)
    });
    if greyed || !presses || !is_understated(bench) {
        return;
    }
    let corner = pos2(rect.right() - FROM_CORNER.0, rect.bottom() - FROM_CORNER.1);
    let room = Rect::from_min_max(corner - vec2(SIZE.0, SIZE.1), corner);
    let layout = Layout::right_to_left(Align::Center);
    ui.scope_builder(UiBuilder::new().max_rect(room).layout(layout), |ui| {
        understated(ui, bench);
    });
}
