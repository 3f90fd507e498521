//! The force on the tip as an arrow that can be dragged, where cables slide and the
//! stiffness is known. Its length per newton belongs to the robot and changes with
//! nothing else.

use crate::app::look::Tokens;
use crate::app::workbench::{Selection, Workbench};
use crate::geometry::Vector;
use crate::mechanics::Model;
use crate::view::{Arrowhead, Frame, Quantity};
use eframe::egui::{Align2, FontId, Painter, Shape, Stroke, pos2, vec2};

/// Length of the arrow of a force that bends the robot by some radians, EI/L², over the
/// robot's length.
const LENGTH: f64 = 0.25;
/// How far before the tip one takes hold of a force that is not there yet, in points.
const BEFORE: f64 = 34.0;
/// Room between an arrow and its number, in points.
const GAP: f32 = 8.0;

/// Metres of an arrow for a newton; `None` where no force can be given.
pub fn metres_per_newton(bench: &Workbench) -> Option<f64> {
    let problem = bench.document.problem();
    let slides = problem.model() == Model::Sliding;
    let stiffness = bench.document.stiffness().filter(|_| slides)?.value();
    let length = problem.length();
    Some(LENGTH * length * length * length / stiffness)
}

/// The force, in N.
pub fn force(bench: &Workbench) -> Vector {
    Vector::from(bench.document.scene.loads.tip_force_n)
}

/// Where one takes hold of the force, in metres: at its arrow's head or, where there is
/// none and the robot is selected, before the tip.
pub fn grip(bench: &Workbench, frame: &Frame) -> Option<Vector> {
    let scale = metres_per_newton(bench)?;
    let tip = bench.live.solution()?.nodes.last()?;
    let force = force(bench);
    if force != Vector::zeros() {
        return Some(tip.position + scale * force);
    }
    let selected = bench.selection == Selection::Robot;
    selected.then(|| tip.position + BEFORE / frame.scale * tip.normal())
}

/// Paints the arrow with its number, or where one can be begun.
pub fn paint(painter: &Painter, bench: &Workbench, frame: &Frame, tokens: &Tokens) {
    let (Some(grip), Some(tip)) = (
        grip(bench, frame),
        bench.live.solution().and_then(|live| live.nodes.last()),
    ) else {
        return;
    };
    let [from, to] = [tip.position, grip].map(|point| frame.to_screen(point));
    if !(from - to).norm().is_finite() {
        return;
    }
    let head = pos2(to.x as f32, to.y as f32);
    let force = force(bench);
    if force == Vector::zeros() {
        let tail = pos2(from.x as f32, from.y as f32);
        let stroke = Stroke::new(1.25, tokens.accent);
        painter.extend(Shape::dashed_line(&[tail, head], stroke, 3.0, 3.0));
        painter.circle(head, 5.0, tokens.canvas, stroke);
        return;
    }
    let outline = Arrowhead::STANDARD.outline(from.into(), to.into());
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
    let text = Quantity::significant(force.norm(), "N").text();
    let (align, aside) = match force.x < 0.0 {
        true => (Align2::RIGHT_CENTER, vec2(-GAP, 0.0)),
        false => (Align2::LEFT_CENTER, vec2(GAP, 0.0)),
    };
    let galley = painter.layout_no_wrap(text.clone(), FontId::proportional(12.0), tokens.text);
    let place = align.anchor_size(head + aside, galley.size());
    painter.rect_filled(place.expand(2.0), 4.0, tokens.canvas.gamma_multiply(0.85));
    painter.galley(place.min, galley, tokens.text);
}
