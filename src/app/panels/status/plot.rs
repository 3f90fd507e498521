//! A small picture of a solve: how fast the residuals fell, a decade a line.

use crate::app::look::{Tokens, theme_of};
use crate::solver::Iteration;
use crate::view::{Quantity, Theme};
use eframe::egui::{
    Align2, Color32, FontId, Painter, Pos2, Rect, Role, Sense, Shape, Stroke, Ui, WidgetInfo, pos2,
    vec2,
};

/// Height, in points.
const HEIGHT: f32 = 128.0;
/// Decades shown: what is below the least is as good as zero.
const DECADES: (i32, i32) = (-16, 2);
/// A line of the grid every so many decades.
const EVERY: usize = 6;

/// Shows the residuals of every iteration.
pub fn show(ui: &mut Ui, trace: &[Iteration]) {
    let size = vec2(ui.available_width(), HEIGHT);
    let (rect, response) = ui.allocate_exact_size(size, Sense::hover());
    response.widget_info(|| WidgetInfo::labeled(Role::Image, true, "Residuals by iteration"));
    let theme = theme_of(ui);
    let tokens = Tokens::of(theme);
    let painter = ui.painter_at(rect);
    let area = Rect::from_min_max(rect.min + vec2(40.0, 20.0), rect.max - vec2(12.0, 20.0));
    grid(&painter, area, trace.len(), &tokens);
    let [blue, orange] = hues(theme);
    let mut at = pos2(area.left(), rect.top() + 8.0);
    for (name, ink, value) in [
        (
            "Gradient",
            blue,
            (|it| it.stationarity) as fn(&Iteration) -> f64,
        ),
        ("Violation", orange, |it| it.violation),
    ] {
        let values = trace.iter().map(value).enumerate();
        let points = values.map(|(k, value)| place(area, trace.len(), k, value));
        curve(&painter, points.collect(), ink);
        painter.circle_filled(at + vec2(4.0, 0.0), 3.0, ink);
        let font = FontId::proportional(12.0);
        let name = painter.text(
            at + vec2(12.0, 0.0),
            Align2::LEFT_CENTER,
            name,
            font,
            tokens.muted,
        );
        at.x = name.right() + 16.0;
    }
}

/// Two hues of the Okabe–Ito palette.
fn hues(theme: Theme) -> [Color32; 2] {
    match theme {
        Theme::Light => [
            Color32::from_rgb(0x00, 0x72, 0xb2),
            Color32::from_rgb(0xd5, 0x5e, 0x00),
        ],
        Theme::Dark => [
            Color32::from_rgb(0x56, 0xb4, 0xe9),
            Color32::from_rgb(0xe6, 0x9f, 0x00),
        ],
    }
}

fn grid(painter: &Painter, area: Rect, count: usize, tokens: &Tokens) {
    let font = FontId::proportional(12.0);
    for decade in (DECADES.0..=DECADES.1).rev().step_by(EVERY) {
        let y = height(area, 10f64.powi(decade));
        let stroke = Stroke::new(1.0, tokens.line);
        painter.hline(area.x_range(), y, stroke);
        let text = Quantity::order(10f64.powi(decade), "").digits;
        let text = text.trim_start_matches("1×").to_owned();
        let at = pos2(area.left() - 8.0, y);
        painter.text(at, Align2::RIGHT_CENTER, text, font.clone(), tokens.muted);
    }
    let last = count.saturating_sub(1);
    for k in [0, last] {
        let at = pos2(across(area, count, k), area.bottom() + 12.0);
        painter.text(at, Align2::CENTER_CENTER, k, font.clone(), tokens.muted);
    }
}

fn across(area: Rect, count: usize, k: usize) -> f32 {
    let share = k as f32 / count.saturating_sub(1).max(1) as f32;
    area.left() + share * area.width()
}

fn height(area: Rect, value: f64) -> f32 {
    let (least, most) = (f64::from(DECADES.0), f64::from(DECADES.1));
    // NaN goes to the top, where it is seen.
    let decade = if value.is_nan() {
        most
    } else {
        value.abs().log10().clamp(least, most)
    };
    let share = (decade - least) / (most - least);
    area.bottom() - share as f32 * area.height()
}

fn place(area: Rect, count: usize, k: usize, value: f64) -> Pos2 {
    pos2(across(area, count, k), height(area, value))
}

fn curve(painter: &Painter, points: Vec<Pos2>, ink: Color32) {
    for point in &points {
        painter.circle_filled(*point, 3.0, ink);
    }
    painter.add(Shape::line(points, Stroke::new(1.5, ink)));
}
