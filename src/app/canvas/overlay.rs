//! What lies over the picture: the outline of what is selected, the scale bar
//! and the legend of the contact scale.

use crate::app::look::{Tokens, contact_scale};
use crate::app::paint::{arrow, flattened, to_screen};
use crate::app::words;
use crate::app::workbench::{Live, Selection};
use crate::geometry::Vector;
use crate::units::millimetres;
use crate::view::{Drawing, Frame, Geometry, Quantity, Role, Theme, clip_half_plane, one_two_five};
use eframe::egui::{Align2, FontId, Painter, Pos2, Rect, Shape, Stroke, pos2, vec2};

/// Distance of the overlays from the canvas's edges, in points.
const EDGE: f32 = 16.0;
/// Length of the scale bar, in points, at most.
const BAR: f64 = 120.0;
/// Length of the legend's arrow, in points, at most.
const KEY: f64 = 56.0;
/// A canvas that is no wider leaves the legend's title out, in points.
const NARROW: f32 = 460.0;

/// A line in the accent around the obstacle that is selected.
pub fn selection(painter: &Painter, live: &Live, selected: Selection, frame: &Frame, theme: Theme) {
    if let Selection::Obstacle(index) = selected {
        let stroke = Stroke::new(2.0, Tokens::of(theme).accent);
        outline_of(painter, live, index, frame, stroke);
    }
}

/// A line around an obstacle.
pub fn outline_of(painter: &Painter, live: &Live, index: usize, frame: &Frame, stroke: Stroke) {
    let marks = &live.drawing().marks;
    for mark in marks.iter().filter(|m| m.role == Role::Obstacle(index)) {
        match &mark.geometry {
            Geometry::Path(path) => {
                if let Some(points) = flattened(path, frame) {
                    painter.add(Shape::closed_line(points, stroke));
                }
            }
            Geometry::HalfPlane { point, normal } => {
                let shown = frame.shown().grown(8.0 / frame.scale);
                let clipped = clip_half_plane(*point, *normal, &shown.corners());
                if let Some(surface) = clipped.surface {
                    let ends = surface.map(|end| to_screen(frame, end));
                    painter.line_segment(ends, stroke);
                }
            }
            _ => {}
        }
    }
}

/// A soft ground under the robot that is selected.
pub fn halo(painter: &Painter, live: &Live, frame: &Frame, theme: Theme) {
    let soft = Stroke::new(14.0, Tokens::of(theme).accent_soft);
    let marks = live.drawing().marks.iter();
    for mark in marks.filter(|mark| mark.role == Role::Backbone) {
        if let Geometry::Path(path) = &mark.geometry
            && let Some(points) = flattened(path, frame)
        {
            let ends = [points.first(), points.last()];
            for end in ends.into_iter().flatten() {
                painter.circle_filled(*end, 0.5 * soft.width, soft.color);
            }
            painter.add(Shape::line(points, soft));
        }
    }
}

/// A ring around the tip, which can be dragged.
pub fn tip_ring(painter: &Painter, live: &Live, frame: &Frame, tokens: &Tokens) {
    let tip = live.solution().and_then(|solution| solution.nodes.last());
    if let Some(tip) = tip {
        let at = to_screen(frame, tip.position);
        painter.circle_stroke(at, 9.0, Stroke::new(2.0, tokens.accent));
    }
}

/// A bar of a round length, lower left, beside what is `taken` there.
pub fn scale_bar(painter: &Painter, frame: &Frame, taken: Rect, theme: Theme) {
    let length = one_two_five(BAR / frame.scale);
    let long = (length * frame.scale) as f32;
    let window = painter.clip_rect();
    let tokens = Tokens::of(theme);
    let mut left = pos2(window.left() + EDGE, window.bottom() - EDGE);
    if taken.is_positive() && taken.bottom() > left.y - 2.0 * EDGE {
        left.x = taken.right() + EDGE;
    }
    let right = left + vec2(long, 0.0);
    let stroke = Stroke::new(1.5, tokens.muted);
    let tick = vec2(0.0, 5.0);
    let line = vec![left - tick, left, right, right - tick];
    painter.add(Shape::line(line, stroke));
    painter.text(
        left + vec2(0.5 * long, -4.0),
        Align2::CENTER_BOTTOM,
        shown_length(length),
        FontId::proportional(12.0),
        tokens.muted,
    );
}

/// A length in the unit that suits it.
fn shown_length(metres: f64) -> String {
    let (value, unit) = if metres < 1e-3 {
        (metres * 1e6, "µm")
    } else if metres < 1.0 {
        (millimetres(metres), "mm")
    } else {
        (metres, "m")
    };
    let decimals = if value < 1.0 { 3 } else { 0 };
    Quantity::fixed(value, decimals, unit).text()
}

/// The contact scale with its end and an arrow of a round force, lower right; nothing
/// where nothing presses.
pub fn legend(painter: &Painter, drawing: &Drawing, frame: &Frame, rect: Rect, theme: Theme) {
    if !drawing.presses {
        return;
    }
    let scale = &drawing.scale;
    let tokens = Tokens::of(theme);
    let small = FontId::proportional(12.0);
    let roomy = rect.width() > NARROW;
    let long = if roomy { 96.0 } else { 56.0 };
    let text = |at: Pos2, text: &str, ink| {
        painter.text(at, Align2::RIGHT_CENTER, text, small.clone(), ink)
    };
    let corner = pos2(rect.right() - EDGE, rect.bottom() - EDGE - 8.0);
    let end = text(corner, &scale.end_written().text(), tokens.text);
    let bar = Rect::from_min_max(
        pos2(end.left() - 8.0 - long, corner.y - 4.0),
        pos2(end.left() - 8.0, corner.y + 4.0),
    );
    painter.add(contact_scale(bar, theme));
    let zero = text(bar.left_center() - vec2(8.0, 0.0), "0", tokens.muted);
    let key = scale.key(KEY / frame.scale);
    let value = pos2(zero.left() - 20.0, corner.y);
    let words = key.value.text();
    let galley = painter.layout_no_wrap(words.clone(), small.clone(), tokens.text);
    let tip = Vector::new(
        f64::from(value.x - galley.size().x) - 8.0,
        f64::from(corner.y),
    );
    let tail = tip - Vector::new(key.length * frame.scale, 0.0);
    // Not over the scale bar.
    let taken = f64::from(rect.left() + 2.0 * EDGE) + BAR;
    if tail.x < taken {
        return;
    }
    let style = theme.style(Role::Force(key.share), &drawing.standing);
    text(value, &words, tokens.text);
    arrow(painter, [tail, tip], &style);
    if roomy {
        let what = pos2(tail.x as f32 - 12.0, corner.y);
        text(what, &words::capital(scale.what()), tokens.muted);
    }
}
