//! What a robot that jumps leaves behind: its old shape, which fades.

use crate::app::look::Tokens;
use crate::app::paint::to_screen;
use crate::geometry::Vector;
use crate::view::Frame;
use eframe::egui::{Painter, Pos2, Shape, Stroke, Ui};
use std::time::Duration;

/// How long a shade stays, in seconds; it fades in the second half.
const STAYS: f64 = 1.6;

/// An old shape.
#[derive(Clone, Debug)]
pub struct Shade {
    backbone: Vec<Vector>,
    /// When it was first shown, in seconds of the window's clock.
    since: Option<f64>,
}

impl Shade {
    /// The shade of a backbone, its nodes in metres.
    pub fn of(backbone: Vec<Vector>) -> Self {
        Self {
            backbone,
            since: None,
        }
    }

    /// Paints the shade, dashed. Whether it is still there.
    pub fn paint(&mut self, ui: &Ui, painter: &Painter, frame: &Frame) -> bool {
        let now = ui.input(|input| input.time);
        let age = now - *self.since.get_or_insert(now);
        if age >= STAYS {
            return false;
        }
        let still = ui.style().animation_time == 0.0;
        let next = if still {
            Duration::from_secs_f64(STAYS - age)
        } else {
            Duration::from_millis(33)
        };
        ui.ctx().request_repaint_after(next);
        let left = if still {
            1.0
        } else {
            (2.0 * (1.0 - age / STAYS)).min(1.0)
        };
        let points: Vec<Pos2> = self.backbone.iter().map(|p| to_screen(frame, *p)).collect();
        if points.iter().all(|point| point.is_finite()) {
            let ink = Tokens::in_ui(ui).warning.gamma_multiply(0.8 * left as f32);
            painter.extend(Shape::dashed_line(&points, Stroke::new(2.0, ink), 6.0, 5.0));
        }
        true
    }
}
