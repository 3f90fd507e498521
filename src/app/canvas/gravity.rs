//! Gravity as a dial in the canvas's corner, whose arrow is turned by hand, where the
//! scene has any. Turning keeps its size.

use crate::app::look::{Tokens, semibold};
use crate::app::workbench::Workbench;
use crate::geometry::Vector;
use crate::mechanics::Model;
use crate::scene::Scene;
use crate::view::{Arrowhead, Frame, Quantity};
use eframe::egui::{Align2, FontId, Painter, Shape, Stroke, pos2, vec2};

/// The dial's middle, from the upper right corner, and its radius, in points.
const MIDDLE: [f64; 2] = [46.0, 46.0];
const RADIUS: f64 = 26.0;
/// Where one takes hold of the arrow, from the middle, in points.
const GRIP: f64 = 20.0;
/// Marks on the dial, over a turn.
const MARKS: u32 = 8;
/// What a turn is rounded to, in degrees: as it is, and with Shift.
const STEPS_DEG: [f64; 2] = [1.0, 15.0];
/// What components are rounded to, in m/s².
const GRAIN: f64 = 1e-5;

/// Whether a turn is to the degree or to where a ruler would have a mark.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Snap {
    Degrees,
    Marks,
}

/// Gravity, in m/s²; `None` where there is none or nothing that it could act on.
pub fn of(bench: &Workbench) -> Option<Vector> {
    let gravity = Vector::from(bench.document.scene.loads.gravity_m_s2);
    let slides = bench.document.problem().model() == Model::Sliding;
    (slides && gravity != Vector::zeros()).then_some(gravity)
}

/// The dial's middle on the screen, in points.
fn middle(frame: &Frame) -> Vector {
    let window = &frame.window;
    Vector::new(window.most.x - MIDDLE[0], window.least.y + MIDDLE[1])
}

/// Whether a place on the screen is where one takes hold of the arrow.
pub fn is_held_at(bench: &Workbench, frame: &Frame, place: Vector, reach: f64) -> bool {
    of(bench).is_some_and(|gravity| {
        let head = middle(frame) + GRIP * on_screen(gravity.normalize());
        (place - head).norm() <= reach.min(RADIUS)
    })
}

/// Turns gravity towards a place on the screen.
pub fn turn(scene: &mut Scene, frame: &Frame, place: Vector, snap: Snap) {
    let size = Vector::from(scene.loads.gravity_m_s2).norm();
    let towards = on_screen(place - middle(frame));
    if towards.norm() < 1.0 {
        return;
    }
    let step = match snap {
        Snap::Degrees => STEPS_DEG[0],
        Snap::Marks => STEPS_DEG[1],
    };
    let degrees = step * (towards.y.atan2(towards.x).to_degrees() / step).round();
    let (sine, cosine) = degrees.to_radians().sin_cos();
    let component = |share: f64| (size * share / GRAIN).round() * GRAIN;
    let turned = [component(cosine), component(sine)];
    // Turning there and back is to lead to the same numbers.
    scene.loads.gravity_m_s2 = turned.map(|value| (value * 1e5).round() / 1e5 + 0.0);
}

/// The direction of gravity from +x, counterclockwise, as it is written.
pub fn direction(gravity: Vector) -> Quantity {
    Quantity::fixed(gravity.y.atan2(gravity.x).to_degrees(), 0, "°")
}

/// A direction of the world on the screen, and back.
fn on_screen(vector: Vector) -> Vector {
    Vector::new(vector.x, -vector.y)
}

/// Paints the dial.
pub fn paint(painter: &Painter, bench: &Workbench, frame: &Frame, lit: bool, tokens: &Tokens) {
    let Some(gravity) = of(bench) else {
        return;
    };
    let centre = middle(frame);
    let at = |place: Vector| pos2(place.x as f32, place.y as f32);
    let ground = tokens.canvas.gamma_multiply(0.85);
    let edge = if lit { tokens.accent } else { tokens.line };
    painter.circle(at(centre), RADIUS as f32, ground, Stroke::new(1.0, edge));
    for mark in 0..MARKS {
        let turn = f64::from(mark) / f64::from(MARKS) * std::f64::consts::TAU;
        let way = Vector::new(turn.cos(), turn.sin());
        let ends = [RADIUS - 4.0, RADIUS].map(|away| at(centre + away * way));
        painter.line_segment(ends, Stroke::new(1.0, tokens.muted.gamma_multiply(0.6)));
    }
    let way = on_screen(gravity.normalize());
    let (tail, head) = (centre - 0.8 * GRIP * way, centre + (GRIP + 3.0) * way);
    let outline = Arrowhead::STANDARD.outline(tail.into(), head.into());
    let outline: Vec<_> = outline
        .iter()
        .map(|[x, y]| pos2(*x as f32, *y as f32))
        .collect();
    if let [a, b, c, d, e, f, g] = outline[..] {
        // The outline is not convex: the shaft and the head are.
        for part in [vec![a, b, f, g], vec![c, d, e]] {
            painter.add(Shape::convex_polygon(part, tokens.accent, Stroke::NONE));
        }
    }
    let size = Quantity::significant(gravity.norm(), "m/s²");
    let below = at(centre) + vec2(RADIUS as f32, RADIUS as f32 + 6.0);
    let right = painter.text(
        below,
        Align2::RIGHT_TOP,
        size.unit,
        FontId::proportional(12.0),
        tokens.muted,
    );
    painter.text(
        right.left_top() - vec2(3.0, 0.0),
        Align2::RIGHT_TOP,
        format!("g {}", size.digits),
        semibold(12.0),
        tokens.text,
    );
}
