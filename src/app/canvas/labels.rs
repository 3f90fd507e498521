//! The labels of a drawing: placed once for each drawing and view, then kept.

use crate::app::look::{Tokens, colour, semibold};
use crate::geometry::Vector;
use crate::view::{
    Bounds, Drawing, Frame, LabelText, Placed, Quantity, Theme, place_labels_beside,
};
use eframe::egui::{Align2, Color32, FontId, Painter, Rect, pos2, vec2};

/// Placed labels, and what they were placed for.
#[derive(Debug)]
pub struct Labels {
    revision: u64,
    frame: Option<Frame>,
    taken: Rect,
    placed: Vec<Placed>,
}

impl Default for Labels {
    fn default() -> Self {
        Self {
            revision: 0,
            frame: None,
            taken: Rect::NOTHING,
            placed: Vec::new(),
        }
    }
}

impl Labels {
    /// What the labels cover of the screen.
    pub fn areas(&self) -> impl Iterator<Item = Rect> + '_ {
        self.placed.iter().map(|place| {
            let corner = |at: Vector| pos2(at.x as f32, at.y as f32);
            Rect::from_min_max(corner(place.area.least), corner(place.area.most))
        })
    }

    /// Paints the labels of a drawing, which `revision` tells from others,
    /// beside what is `taken` of the canvas.
    pub fn paint(
        &mut self,
        painter: &Painter,
        (drawing, revision): (&Drawing, u64),
        frame: &Frame,
        taken: Rect,
        theme: Theme,
    ) {
        if self.revision != revision || self.frame != Some(*frame) || self.taken != taken {
            let area = Bounds::of([taken.min, taken.max].map(|at| {
                let at = at.to_vec2();
                Vector::new(f64::from(at.x), f64::from(at.y))
            }));
            let taken_areas: &[Bounds] = if taken.is_positive() { &[area] } else { &[] };
            let measure = |text: &LabelText| measure(painter, text);
            self.placed = place_labels_beside(drawing, frame, taken_areas, measure);
            self.revision = revision;
            self.frame = Some(*frame);
            self.taken = taken;
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
                    // A plate, so that grid and outlines do not run through digits.
                    let corner = |at: Vector| pos2(at.x as f32, at.y as f32);
                    let plate =
                        Rect::from_min_max(corner(place.area.least), corner(place.area.most));
                    painter.rect_filled(plate.expand(2.0), 4.0, tokens.canvas.gamma_multiply(0.8));
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
