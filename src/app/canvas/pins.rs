//! Pinned robots as ghosts behind the live one: backbone and disks, with their letter at
//! the tip.

use crate::app::look::{Tokens, semibold};
use crate::app::paint::to_screen;
use crate::app::workbench::Pin;
use crate::geometry::Vector;
use crate::view::Frame;
use eframe::egui::{Align2, Painter, Pos2, Shape, Stroke, vec2};

/// Paints them.
pub fn paint(painter: &Painter, pins: &[Pin], frame: &Frame, tokens: &Tokens) {
    for pin in pins {
        let at = |point: Vector| to_screen(frame, point);
        let backbone: Vec<Pos2> = pin.solved.backbone().map(at).collect();
        if !backbone.iter().all(|point| point.is_finite()) {
            continue;
        }
        let ink = pin.ink(tokens).gamma_multiply(0.75);
        let robot = pin.solved.problem().robot();
        for (index, node) in pin.solved.nodes.iter().enumerate() {
            if robot.has_disk(index) {
                let rim = robot.sizes.rim;
                let ends = [at(node.at(-rim)), at(node.at(rim))];
                painter.line_segment(ends, Stroke::new(1.0, ink.gamma_multiply(0.6)));
            }
        }
        let tip = backbone[backbone.len() - 1];
        painter.add(Shape::line(backbone, Stroke::new(2.0, ink)));
        let place = tip + vec2(0.0, -12.0);
        painter.circle_filled(place, 9.0, tokens.canvas.gamma_multiply(0.85));
        let letter = pin.letter.to_string();
        painter.text(place, Align2::CENTER_CENTER, letter, semibold(12.0), ink);
    }
}
