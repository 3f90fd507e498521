//! A row of names of which one is chosen.

use super::{Tokens, semibold};
use eframe::egui::{
    Button, Color32, FontId, Rect, RichText, Role, Sense, Ui, UiBuilder, WidgetInfo, vec2,
};

/// A name to choose.
pub struct Segment<'a> {
    /// What is written, in a word.
    pub name: &'a str,
    /// What it does, for those who cannot see it.
    pub title: &'a str,
    /// What it does, where the pointer rests on it.
    pub tip: String,
    /// Whether it can be chosen.
    pub enabled: bool,
}

/// Shows segments of one width, in points; which of them was clicked.
pub fn segments(
    ui: &mut Ui,
    width: f32,
    shown: &[Segment<'_>],
    current: Option<usize>,
) -> Option<usize> {
    let tokens = Tokens::in_ui(ui);
    let size = vec2(width, ui.spacing().interact_size.y - 4.0);
    let all = vec2(size.x * shown.len() as f32 + 4.0, size.y + 4.0);
    let (rect, _) = ui.allocate_exact_size(all, Sense::hover());
    ui.painter().rect_filled(rect, 7.0, tokens.sunken);
    let mut corner = rect.min + vec2(2.0, 2.0);
    let mut clicked = None;
    for (index, segment) in shown.iter().enumerate() {
        let chosen = current == Some(index);
        let (fill, ink, font) = if chosen {
            (tokens.raised, tokens.text, semibold(12.0))
        } else {
            (
                Color32::TRANSPARENT,
                tokens.muted,
                FontId::proportional(12.0),
            )
        };
        let button = Button::new(RichText::new(segment.name).font(font).color(ink))
            .fill(fill)
            .corner_radius(5.0);
        let place = UiBuilder::new().max_rect(Rect::from_min_size(corner, size));
        corner.x += size.x;
        let mut cell = ui.new_child(place);
        if !segment.enabled {
            cell.disable();
        }
        let response = cell.add_sized(size, button);
        let response = response
            .on_hover_text(&segment.tip)
            .on_disabled_hover_text(&segment.tip);
        response.widget_info(|| {
            WidgetInfo::selected(Role::RadioButton, segment.enabled, chosen, segment.title)
        });
        if response.clicked() {
            clicked = Some(index);
        }
    }
    clicked
}
