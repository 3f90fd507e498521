//! The labels of a drawing: placed once for each drawing and view, then kept.

use crate::app::look::{Tokens, colour, semibold};
use crate::geometry::Vector;
use crate::view::{Drawing, Frame, LabelText, Placed, Quantity, Theme, place_labels};
use eframe::egui::{Align2, Color32, FontId, Painter, pos2, vec2};

/// Placed labels, and what they were placed for.
#[derive(Debug, Default)]
pub struct Labels {
    revision: u64,
    frame: Option<Frame>,
    placed: Vec<Placed>,
}

impl Labels {
    /// Paints the labels of a drawing, which `revision` tells from others.
    pub fn paint(
        &mut self,
        painter: &Painter,
        drawing: &Drawing,
        revision: u64,
        frame: &Frame,
        theme: Theme,
    ) {
        if self.revision != revision || self.frame != Some(*frame) {
            self.placed = place_labels(drawing, frame, |text| measure(painter, text));
            self.revision = revision;
            self.frame = Some(*frame);
        }
        let tokens = Tokens::of(theme);
        for place in &self.placed {
            let Some(label) = drawing.labels.get(place.label) else {
                continue;
            };
            let middle = place.area.centre();
            let middle = pos2(middle.x as f32, middle.y as f32);
            match &label.text {
                LabelText::Name(name) => {
                    let quiet = colour(theme.palette().quiet);
                    painter.text(middle, Align2::CENTER_CENTER, name, small(), quiet);
                }
                LabelText::Value(value) => {
                    let mut at = pos2(place.area.least.x as f32, middle.y);
                    for (text, font, ink) in [
                        (value.digits.clone(), semibold(12.0), tokens.text),
                        (unit(value), small(), tokens.muted),
                    ] {
                        let galley = painter.layout_no_wrap(text, font, ink);
                        let size = galley.size();
                        painter.galley(at - vec2(0.0, 0.5 * size.y), galley, ink);
                        at.x += size.x;
                    }
                }
            }
        }
    }
}

fn small() -> FontId {
    FontId::proportional(12.0)
}

/// The unit with the space before it.
fn unit(value: &Quantity) -> String {
    format!("\u{2009}{}", value.unit)
}

fn measure(painter: &Painter, text: &LabelText) -> Vector {
    let size = |text: &str, font: FontId| {
        painter
            .layout_no_wrap(text.to_owned(), font, Color32::WHITE)
            .size()
    };
    let size = match text {
        LabelText::Name(name) => size(name, small()),
        LabelText::Value(value) => {
            let digits = size(&value.digits, semibold(12.0));
            let unit = size(&unit(value), small());
            vec2(digits.x + unit.x, digits.y.max(unit.y))
        }
    };
    Vector::new(f64::from(size.x), f64::from(size.y))
}
