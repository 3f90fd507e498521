//! Painting a [`Drawing`] with egui: the same marks that the SVG export writes.

use crate::app::look::colour;
use crate::geometry::Vector;
use crate::view::{
    Arrowhead, Drawing, Frame, Geometry, Mark, Path, Standing, Style, Theme, clip_half_plane,
    hatching, one_two_five,
};
use eframe::egui::{Color32, Painter, Pos2, Shape, Stroke, pos2};

/// Where a point of the plane, in metres, is on the screen.
pub fn to_screen(frame: &Frame, at: Vector) -> Pos2 {
    let at = frame.to_screen(at);
    Pos2::new(at.x as f32, at.y as f32)
}

/// The point of the plane, in metres, that is there on the screen.
pub fn to_world(frame: &Frame, at: Pos2) -> Vector {
    frame.to_world(Vector::new(f64::from(at.x), f64::from(at.y)))
}

/// Distance of grid lines, in points, at least.
const GRID: f64 = 48.0;

/// The grid, its lines at 1, 2 or 5 times a power of ten.
pub fn grid(painter: &Painter, frame: &Frame, theme: Theme) {
    // The least of 1, 2, 5 × 10ⁿ that is far enough.
    let step = 10.0 / one_two_five(10.0 * frame.scale / GRID);
    let shown = frame.shown();
    let stroke = Stroke::new(1.0, colour(theme.palette().grid));
    let window = painter.clip_rect();
    let between = |least: f64, most: f64| {
        let first = (least / step).ceil();
        let count = ((most / step).floor() - first + 1.0).clamp(0.0, 400.0);
        (0..count as usize).map(move |i| (first + i as f64) * step)
    };
    for x in between(shown.least.x, shown.most.x) {
        let x = to_screen(frame, Vector::new(x, 0.0)).x;
        painter.vline(x, window.y_range(), stroke);
    }
    for y in between(shown.least.y, shown.most.y) {
        let y = to_screen(frame, Vector::new(0.0, y)).y;
        painter.hline(window.x_range(), y, stroke);
    }
}

/// The marks, from back to front.
pub fn drawing(painter: &Painter, drawing: &Drawing, frame: &Frame, theme: Theme) {
    for mark in &drawing.marks {
        paint_mark(painter, mark, frame, theme, &drawing.standing);
    }
}

fn paint_mark(painter: &Painter, mark: &Mark, frame: &Frame, theme: Theme, standing: &Standing) {
    let style = theme.style(mark.role, standing);
    match &mark.geometry {
        Geometry::Path(path) => {
            let width = style.width.max(mark.thickness * frame.scale);
            paint_path(painter, path, frame, &style, width);
        }
        Geometry::HalfPlane { point, normal } => {
            paint_wall(painter, *point, *normal, frame, &style);
        }
        Geometry::Dot(point) => paint_dot(painter, to_screen(frame, *point), &style),
        Geometry::Arrow { tail, tip } => {
            arrow(
                painter,
                [tail, tip].map(|point| frame.to_screen(*point)),
                &style,
            );
        }
    }
}

/// The points of a path on the screen; `None` where one of them is nowhere.
pub fn flattened(path: &Path, frame: &Frame) -> Option<Vec<Pos2>> {
    let points = path.flattened(0.1 / frame.scale);
    let points: Vec<Pos2> = points.into_iter().map(|p| to_screen(frame, p)).collect();
    points.iter().all(|p| p.is_finite()).then_some(points)
}

fn stroke_of(style: &Style, width: f64) -> Stroke {
    match style.stroke {
        Some(stroke) if width > 0.0 => Stroke::new(width as f32, colour(stroke)),
        _ => Stroke::NONE,
    }
}

fn paint_path(painter: &Painter, path: &Path, frame: &Frame, style: &Style, width: f64) {
    let Some(points) = flattened(path, frame) else {
        return;
    };
    let stroke = stroke_of(style, width);
    if path.closed {
        // Every obstacle is convex.
        let fill = style.fill.map_or(Color32::TRANSPARENT, colour);
        painter.add(Shape::convex_polygon(points, fill, stroke));
    } else {
        painter.add(Shape::line(points, stroke));
    }
}

fn paint_wall(painter: &Painter, point: Vector, normal: Vector, frame: &Frame, style: &Style) {
    // A little beyond the window, whose edge is not the wall's.
    let shown = frame.shown().grown(8.0 / frame.scale);
    let clipped = clip_half_plane(point, normal, &shown.corners());
    let area: Vec<Pos2> = clipped.area.iter().map(|p| to_screen(frame, *p)).collect();
    if area.len() < 3 || !area.iter().all(|p| p.is_finite()) {
        return;
    }
    let fill = style.fill.map_or(Color32::TRANSPARENT, colour);
    painter.add(Shape::convex_polygon(area, fill, Stroke::NONE));
    if let Some(surface) = clipped.surface {
        let stroke = stroke_of(style, style.width);
        for strokes in hatching(surface, -normal, 9.0 / frame.scale, 6.0 / frame.scale) {
            painter.line_segment(strokes.map(|p| to_screen(frame, p)), stroke);
        }
        let edge = stroke_of(style, 1.75 * style.width);
        painter.line_segment(surface.map(|p| to_screen(frame, p)), edge);
    }
}

fn paint_dot(painter: &Painter, at: Pos2, style: &Style) {
    if !at.is_finite() {
        return;
    }
    if let Some((radius, glow)) = style.glow {
        let glow = colour(glow).gamma_multiply(0.5);
        // Three discs over each other fade better than one.
        for share in [1.0, 0.75, 0.55] {
            painter.circle_filled(at, share * radius as f32, glow);
        }
    }
    if let Some((radius, width)) = style.ring {
        painter.circle_stroke(at, radius as f32, stroke_of(style, width));
    }
    if style.radius > 0.0 {
        let fill = style.fill.map_or(Color32::TRANSPARENT, colour);
        let stroke = stroke_of(style, style.width);
        painter.circle(at, style.radius as f32, fill, stroke);
    }
}

/// An arrow between two places on the screen, in points.
pub fn arrow(painter: &Painter, [tail, tip]: [Vector; 2], style: &Style) {
    let outline = Arrowhead::STANDARD.outline(tail.into(), tip.into());
    paint_arrow(painter, &outline, style);
}

fn paint_arrow(painter: &Painter, outline: &[[f64; 2]], style: &Style) {
    if outline.is_empty() || !outline.iter().flatten().all(|x| x.is_finite()) {
        return;
    }
    let at = |i: usize| pos2(outline[i][0] as f32, outline[i][1] as f32);
    let fill = style.fill.map_or(Color32::TRANSPARENT, colour);
    let stroke = stroke_of(style, style.width);
    // The outline is not convex: the shaft and the head are.
    let shaft = vec![at(0), at(1), at(5), at(6)];
    let head = vec![at(2), at(3), at(4)];
    painter.add(Shape::convex_polygon(shaft, fill, Stroke::NONE));
    painter.add(Shape::convex_polygon(head, fill, Stroke::NONE));
    let outline = (0..outline.len()).map(at).collect();
    painter.add(Shape::closed_line(outline, stroke));
}
