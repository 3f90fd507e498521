//! What stands around the drawing: the header above it, with what was measured
//! and whether it is to be believed, and the footer with the scales.

use super::{EDGE, LARGE, LINE, PLAIN, SMALL, STRONG, Size, Writer, px, rectangle};
use crate::geometry::Vector;
use crate::report::characters::printable;
use crate::report::text;
use crate::view::{Colour, Quantity, Role, Standing, Theme};
use svg::Node;
use svg::node::element::{Group, LinearGradient, Path as PathElement, Stop, Text};

impl Writer<'_> {
    /// The header and its height.
    pub(super) fn header(&mut self, size: Size) -> (Group, f64) {
        let room = size.width - 2.0 * EDGE;
        let mut header = Group::new();
        let mut y = EDGE - 4.0;
        if let Some(title) = &self.drawing.caption.title {
            y += LARGE;
            let title = text::cut(&printable(title), LARGE, room);
            let mut line = self.text(Vector::new(EDGE, y), "title", &title, |theme| {
                theme.palette().text
            });
            line.assign("font-size", px(LARGE));
            line.assign("font-weight", STRONG);
            header.append(line);
            y += 3.0;
        }
        for line in self.fact_lines(room) {
            y += LINE;
            header.append(line.set("x", px(EDGE)).set("y", px(y)));
        }
        let drawing = self.drawing;
        let mut write = |words: &str, word: &str, colour: fn(Theme) -> Colour| {
            let words = printable(&sentence(words));
            for line in text::lines(&words, SMALL, room).into_iter().take(6) {
                y += LINE;
                let line = text::cut(&line, SMALL, room);
                header.append(self.text(Vector::new(EDGE, y), word, &line, colour));
            }
        };
        match &drawing.standing {
            Standing::Certified => {
                write("certified equilibrium", "standing", |t| t.palette().muted);
            }
            Standing::Greyed { reason, .. } => write(reason, "warning", |t| t.palette().warning),
        }
        if let Some(note) = &drawing.caption.note {
            write(note, "note", |theme| theme.palette().muted);
        }
        (header, y + 12.0)
    }

    /// The facts, in as many lines as they need.
    fn fact_lines(&mut self, room: f64) -> Vec<Text> {
        let mut lines = Vec::new();
        let mut line = Text::new("");
        let mut used = 0.0;
        let facts = &self.drawing.caption.facts;
        for fact in facts {
            // Facts that belong together, such as x and y, stand closer.
            let gap = match fact.name {
                "of" | "y" => 2.0,
                _ => 14.0,
            };
            // The spaces between spans included.
            let text = format!(" {} {}", fact.name, fact.value.text());
            let wide = text::width(&text, SMALL);
            if used > 0.0 && used + gap + wide > room {
                lines.push(std::mem::replace(&mut line, Text::new("")));
                used = 0.0;
            }
            let mut name = self.span(fact.name, |theme| theme.palette().muted);
            if used > 0.0 {
                name.assign("dx", px(gap));
                used += gap;
            }
            used += wide;
            line.append(name);
            self.add_quantity(&mut line, &fact.value, STRONG);
        }
        lines.push(line);
        lines
    }

    /// The scale bar on the left, the contacts' scale on the right.
    pub(super) fn footer(&mut self, size: Size, scale: f64) -> Group {
        let base = size.height - EDGE;
        let mut footer = Group::new();
        let long = self.drawing.scale_bar * scale;
        let data = format!(
            "M{x} {top}V{base}H{end}V{top}",
            x = px(EDGE + 0.5),
            end = px(EDGE + 0.5 + long),
            top = px(base - 6.0),
            base = px(base),
        );
        let mut bar = PathElement::new().set("d", data);
        self.paint(&mut bar, "scale-bar", |theme| {
            vec![
                ("fill", "none".to_owned()),
                ("stroke", theme.palette().muted.to_hex()),
                ("stroke-width", "1.5".to_owned()),
            ]
        });
        footer.append(bar);
        let length = shown_length(self.drawing.scale_bar);
        let at = Vector::new(EDGE + long + 8.0, base);
        let mut label = Text::new("").set("x", px(at.x)).set("y", px(at.y));
        self.add_quantity(&mut label, &length, PLAIN);
        footer.append(label);
        let used = at.x + text::width(&length.text(), SMALL) + EDGE;
        if self.drawing.presses {
            self.legend(&mut footer, [used, size.width - EDGE], base, scale);
        }
        footer
    }

    /// The contacts' scale, from the right edge to the left as far as there is
    /// room, and an arrow that shows how long a round force is.
    fn legend(&mut self, footer: &mut Group, [left, right]: [f64; 2], base: f64, scale: f64) {
        const BAR: f64 = 80.0;
        const ARROW: f64 = 56.0;
        let of = self.drawing.scale;
        let end_text = of.end_written();
        let end = right - text::width(&end_text.text(), SMALL) - 6.0;
        let zero = end - BAR - 6.0;
        if zero - 12.0 < left {
            return;
        }
        let mut label = Text::new("").set("x", px(end + 6.0)).set("y", px(base));
        self.add_quantity(&mut label, &end_text, PLAIN);
        footer.append(label);
        let corner = Vector::new(end - BAR, base - 8.5);
        let bar = rectangle(corner, Vector::new(BAR, 8.0)).set("rx", 2);
        footer.append(bar.set("fill", "url(#contact)"));
        let muted = |theme: Theme| theme.palette().muted;
        let label = self.text(Vector::new(zero, base), "zero", "0", muted);
        footer.append(label.set("text-anchor", "end"));
        let key = of.key(ARROW / scale);
        let value = text::width(&key.value.text(), SMALL);
        let mut free = zero - 24.0 - value;
        if free - ARROW > left {
            let mut label = Text::new("").set("x", px(free)).set("y", px(base));
            self.add_quantity(&mut label, &key.value, PLAIN);
            footer.append(label);
            let tip = [free - 6.0, base - 4.5];
            let tail = [tip[0] - key.length * scale, tip[1]];
            let arrow = self.arrow([tail, tip], Role::Force(key.share));
            if let Some(arrow) = arrow {
                footer.append(arrow.set("class", "key"));
            }
            free = tail[0] - 12.0;
        }
        let words = of.what();
        if free - text::width(words, SMALL) > left {
            let label = self.text(Vector::new(free, base), "words", words, muted);
            footer.append(label.set("text-anchor", "end"));
        }
    }

    pub(super) fn gradient(&mut self) -> LinearGradient {
        let mut gradient = LinearGradient::new().set("id", "contact");
        let greyed = self.drawing.standing.is_greyed();
        for share in [0.0, 0.5, 1.0] {
            let mut stop = Stop::new().set("offset", px(share));
            let standing = &self.drawing.standing;
            self.paint(&mut stop, "stop", |theme| {
                let colour = match theme.style(Role::Force(share), standing).fill {
                    Some(colour) if greyed => colour,
                    _ => theme.contact(share),
                };
                vec![("stop-color", colour.to_hex())]
            });
            gradient.append(stop);
        }
        gradient
    }
}

/// A length in the unit that needs the fewest digits.
fn shown_length(metres: f64) -> Quantity {
    let millimetres = crate::units::millimetres(metres);
    let (value, unit) = if millimetres >= 1000.0 {
        (metres, "m")
    } else {
        (millimetres, "mm")
    };
    // 1, 2 or 5 times a power of ten has no other digits.
    let decimals = (-libm::log10(value).floor()).max(0.0) as usize;
    Quantity::fixed(value, decimals, unit)
}

/// Words with a capital at their start.
fn sentence(words: &str) -> String {
    let mut rest = words.chars();
    match rest.next() {
        Some(first) => first.to_uppercase().chain(rest).collect(),
        None => String::new(),
    }
}
