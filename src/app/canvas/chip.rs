//! Chips: a few words or numbers on a small raised ground beside what they are
//! about, kept inside the canvas.

use crate::app::look::{Tokens, icon_font, icons, semibold};
use crate::view::Quantity;
use eframe::egui::text::{LayoutJob, TextFormat};
use eframe::egui::{
    Align, Color32, FontId, Galley, Painter, Pos2, Rect, Shape, Stroke, StrokeKind, Vec2, vec2,
};
use std::sync::Arc;

/// Room between a chip's edge and its text, in points.
const PADDING: Vec2 = vec2(8.0, 5.0);
/// Widest text, in points.
const WIDEST: f32 = 340.0;

/// What a chip says: a title, if any, and named numbers.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Chip {
    /// The first line.
    pub title: Option<String>,
    /// The lines below it: a name and what it is.
    pub rows: Vec<(String, Quantity)>,
}

/// Paints named numbers in one line beside the pointer.
pub fn reading(
    painter: &Painter,
    within: Rect,
    pointer: Pos2,
    numbers: &[(&'static str, Quantity)],
    tokens: &Tokens,
) {
    if numbers.is_empty() {
        return;
    }
    let mut job = LayoutJob::default();
    for (i, (name, value)) in numbers.iter().enumerate() {
        let space = if i == 0 { 0.0 } else { 12.0 };
        job.append(name, space, small(tokens.muted));
        append_value(&mut job, value, 4.0, tokens);
    }
    let galley = painter.layout_job(job);
    place(painter, within, pointer + vec2(18.0, 22.0), galley, tokens);
}

/// Paints a few words with their upper left corner at a place.
pub fn text(painter: &Painter, within: Rect, at: Pos2, words: &str, tokens: &Tokens) {
    let mut job = LayoutJob::default();
    job.wrap.max_width = WIDEST;
    job.append(words, 0.0, small(tokens.text));
    let galley = painter.layout_job(job);
    place(painter, within, at, galley, tokens);
}

/// Paints words after an icon in the colour of what they mean.
pub fn marked(
    painter: &Painter,
    within: Rect,
    at: Pos2,
    (icon, ink): (&str, Color32),
    words: &str,
    tokens: &Tokens,
) -> Rect {
    let mut job = LayoutJob::default();
    job.wrap.max_width = WIDEST;
    let mark = TextFormat {
        valign: Align::Center,
        ..TextFormat::simple(icon_font(14.0), ink)
    };
    job.append(icon, 0.0, mark);
    job.append(words, 6.0, small(tokens.text));
    let galley = painter.layout_job(job);
    place(painter, within, at, galley, tokens)
}

/// Paints a warning.
pub fn warning(painter: &Painter, within: Rect, at: Pos2, words: &str, tokens: &Tokens) -> Rect {
    let mark = (icons::WARNING, tokens.warning);
    marked(painter, within, at, mark, words, tokens)
}

impl Chip {
    /// Paints the chip beside a place.
    pub fn paint(&self, painter: &Painter, within: Rect, beside: Pos2, tokens: &Tokens) {
        let mut job = LayoutJob::default();
        job.wrap.max_width = WIDEST;
        if let Some(title) = &self.title {
            let format = TextFormat::simple(semibold(12.0), tokens.text);
            job.append(title, 0.0, format);
        }
        for (name, value) in &self.rows {
            if !job.is_empty() {
                job.append("\n", 0.0, small(tokens.muted));
            }
            job.append(name, 0.0, small(tokens.muted));
            append_value(&mut job, value, 6.0, tokens);
        }
        let galley = painter.layout_job(job);
        place(painter, within, beside + vec2(14.0, 12.0), galley, tokens);
    }
}

fn append_value(job: &mut LayoutJob, value: &Quantity, space: f32, tokens: &Tokens) {
    job.append(
        &value.digits,
        space,
        TextFormat::simple(semibold(12.0), tokens.text),
    );
    if !value.unit.is_empty() {
        let space = if value.unit == "°" { 0.0 } else { 3.0 };
        job.append(value.unit, space, small(tokens.muted));
    }
}

fn small(ink: Color32) -> TextFormat {
    TextFormat::simple(FontId::proportional(12.0), ink)
}

/// Paints text on a chip whose upper left corner is at a place, or as near to
/// it as the canvas allows.
fn place(painter: &Painter, within: Rect, at: Pos2, galley: Arc<Galley>, tokens: &Tokens) -> Rect {
    let size = galley.size() + 2.0 * PADDING;
    let within = within.shrink(8.0);
    let most = (within.max - size).max(within.min);
    let corner = at.max(within.min).min(most);
    let area = Rect::from_min_size(corner, size);
    let shadow = painter.ctx().global_style().visuals.popup_shadow;
    painter.add(Shape::from(shadow.as_shape(area, 6)));
    let edge = Stroke::new(1.0, tokens.line);
    painter.rect(area, 6, tokens.raised, edge, StrokeKind::Inside);
    painter.galley(corner + PADDING, galley, tokens.text);
    area
}
