//! A drawing as SVG text.
//!
//! The picture has a header (title, what was measured, whether it is to be
//! believed), the drawing in the middle, clipped to its window over a faint
//! grid, and a footer with the scale bar and the scale of the contacts.
//!
//! Colours are presentation attributes, which every viewer knows. In
//! [`render_adaptive`] a style sheet with `prefers-color-scheme` overrides
//! them by night; viewers without media queries show the light picture.

mod marks;
mod page;

use super::characters::printable;
use crate::geometry::Vector;
use crate::view::{Bounds, Colour, Drawing, Frame, Quantity, Role, Standing, Theme};
use svg::Node;
use svg::node::Text as Characters;
use svg::node::element::{
    ClipPath, Definitions, Description, Group, Rectangle, SVG, Style as StyleSheet, TSpan, Text,
    Title,
};

/// The size of a picture, in pixels.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Size {
    /// Its width.
    pub width: f64,
    /// Its height, header and footer included.
    pub height: f64,
}

impl Size {
    /// The least and greatest sides a picture may have, in pixels; others are brought
    /// to these.
    pub const RANGE: (f64, f64) = (200.0, 16_384.0);

    /// A size that suits the shape of a drawing, about 640 pixels in its
    /// larger side.
    pub fn suiting(drawing: &Drawing) -> Self {
        let size = drawing.bounds.size();
        let scale = 560.0 / size.x.max(size.y);
        let side = |length: f64| (scale * length / 4.0).round() * 4.0;
        Self {
            width: side(size.x).max(520.0),
            height: side(size.y).max(320.0) + 104.0,
        }
    }

    fn checked(self) -> Self {
        let (least, most) = Self::RANGE;
        // The order also replaces NaN.
        Self {
            width: self.width.max(least).min(most),
            height: self.height.max(least).min(most),
        }
    }
}

/// The drawing in one theme.
pub fn render(drawing: &Drawing, theme: Theme, size: Size) -> String {
    Writer::new(drawing, theme, None).picture(size.checked())
}

/// The drawing in the theme that its reader's system prefers.
pub fn render_adaptive(drawing: &Drawing, size: Size) -> String {
    Writer::new(drawing, Theme::Light, Some(Theme::Dark)).picture(size.checked())
}

/// Distance of text from the picture's edges.
const EDGE: f64 = 16.0;
const SMALL: f64 = 12.0;
const LARGE: f64 = 14.0;
/// The two weights of text.
const PLAIN: u16 = 400;
const STRONG: u16 = 600;
/// Height of a line of small text.
const LINE: f64 = 18.0;
const FOOTER: f64 = 44.0;
const FAMILY: &str = "Inter, system-ui, sans-serif";

/// Attributes of an element.
type Look = Vec<(&'static str, String)>;

struct Writer<'a> {
    drawing: &'a Drawing,
    theme: Theme,
    night: Option<Theme>,
    /// What elements look like by night, each a class of its own.
    rules: Vec<String>,
}

impl<'a> Writer<'a> {
    fn new(drawing: &'a Drawing, theme: Theme, night: Option<Theme>) -> Self {
        Self {
            drawing,
            theme,
            night,
            rules: Vec::new(),
        }
    }

    fn picture(mut self, size: Size) -> String {
        let (header, header_height) = self.header(size);
        let window = Bounds {
            least: Vector::new(0.0, header_height),
            most: Vector::new(size.width, (size.height - FOOTER).max(header_height + 16.0)),
        };
        let frame = Frame::fitting(&self.drawing.bounds, window);
        let corner = window.least;
        let clip = ClipPath::new()
            .set("id", "window")
            .add(rectangle(corner, window.size()));
        let mut whole = rectangle(Vector::zeros(), Vector::new(size.width, size.height));
        self.paint(&mut whole, "background", |theme| {
            vec![("fill", theme.palette().background.to_hex())]
        });
        let mut middle = Group::new().set("clip-path", "url(#window)");
        middle.append(self.grid(&frame));
        for mark in &self.drawing.marks {
            if let Some(group) = self.mark(mark, &frame) {
                middle.append(group);
            }
        }
        middle.append(self.labels(&frame));
        let footer = self.footer(size, frame.scale);
        let mut defs = Definitions::new().add(clip);
        if self.drawing.presses {
            defs.append(self.gradient());
        }
        let mut picture = SVG::new()
            .set("width", px(size.width))
            .set("height", px(size.height))
            .set(
                "viewBox",
                format!("0 0 {} {}", px(size.width), px(size.height)),
            )
            .set("role", "img")
            .set("font-family", FAMILY)
            .set("font-variant-numeric", "tabular-nums")
            .set("font-size", px(SMALL))
            .add(Title::new(self.title()))
            .add(Description::new().add(Characters::new(self.description())));
        if !self.rules.is_empty() {
            picture.append(StyleSheet::new(self.style_sheet()));
        }
        picture = picture
            .add(defs)
            .add(whole)
            .add(middle)
            .add(header)
            .add(footer);
        format!("{picture}\n")
    }

    /// Gives an element its looks, and by night others.
    fn paint(&mut self, element: &mut impl Node, word: &str, look: impl Fn(Theme) -> Look) {
        let by_day = look(self.theme);
        let mut class = word.to_owned();
        if let Some(night) = self.night {
            let by_night = look(night);
            if by_night != by_day {
                let rule: Vec<String> = by_night
                    .iter()
                    .map(|(name, value)| format!("{name}:{value}"))
                    .collect();
                let rule = rule.join(";");
                let known = self.rules.iter().position(|other| *other == rule);
                let index = known.unwrap_or_else(|| {
                    self.rules.push(rule);
                    self.rules.len() - 1
                });
                class = format!("{word} n{index}");
            }
        }
        for (name, value) in by_day {
            element.assign(name, value);
        }
        element.assign("class", class);
    }

    fn style_sheet(&self) -> String {
        let rules: Vec<String> = self
            .rules
            .iter()
            .enumerate()
            .map(|(index, rule)| format!(".n{index}{{{rule}}}"))
            .collect();
        format!("@media (prefers-color-scheme: dark){{{}}}", rules.join(""))
    }

    fn title(&self) -> String {
        let title = self.drawing.caption.title.as_deref();
        printable(title.unwrap_or("Cable-driven continuum robot"))
    }

    fn description(&self) -> String {
        let facts = self.drawing.caption.facts.iter();
        let mut parts: Vec<String> = facts
            .map(|fact| format!("{} {}", fact.name, fact.value.text()))
            .collect();
        let pressing = self
            .drawing
            .marks
            .iter()
            .filter(|mark| matches!(mark.role, Role::Force(_)))
            .count();
        parts.push(match pressing {
            1 => "1 contact presses".to_owned(),
            count => format!("{count} contacts press"),
        });
        parts.push(match &self.drawing.standing {
            Standing::Certified => "certified equilibrium".to_owned(),
            Standing::Greyed { reason, .. } => reason.clone(),
        });
        printable(&parts.join(", "))
    }

    fn span(&mut self, words: &str, colour: fn(Theme) -> Colour) -> TSpan {
        let mut span = TSpan::new(words);
        self.paint(&mut span, "span", |theme| {
            vec![("fill", colour(theme).to_hex())]
        });
        span
    }

    /// Adds a quantity's digits and its unit, muted. The line break
    /// that the writer puts before a span is the space between the two.
    fn add_quantity(&mut self, line: &mut Text, quantity: &Quantity, weight: u16) {
        let degrees = quantity.unit == "°";
        let digits = if degrees {
            quantity.text()
        } else {
            quantity.digits.clone()
        };
        let mut digits = self.span(&digits, |theme| theme.palette().text);
        digits.assign("font-weight", weight);
        line.append(digits);
        if !degrees && !quantity.unit.is_empty() {
            line.append(self.span(quantity.unit, |theme| theme.palette().muted));
        }
    }

    fn text(&mut self, at: Vector, word: &str, words: &str, colour: fn(Theme) -> Colour) -> Text {
        let mut text = Text::new(words).set("x", px(at.x)).set("y", px(at.y));
        self.paint(&mut text, word, |theme| {
            vec![("fill", colour(theme).to_hex())]
        });
        text
    }
}

/// A coordinate to a hundredth of a pixel, in as few characters as it needs.
fn px(value: f64) -> String {
    let rounded = (value * 100.0).round() / 100.0;
    // Adding zero leaves no negative one.
    (rounded + 0.0).to_string()
}

fn rectangle(corner: Vector, size: Vector) -> Rectangle {
    Rectangle::new()
        .set("x", px(corner.x))
        .set("y", px(corner.y))
        .set("width", px(size.x))
        .set("height", px(size.y))
}
