//! The drawing itself: the grid, the marks and their labels, each in the
//! clipped window.

use super::{Look, SMALL, STRONG, Writer, px};
use crate::geometry::Vector;
use crate::report::characters::printable;
use crate::report::text;
use crate::view::{
    Arrowhead, Bounds, Colour, Frame, Geometry, LabelText, Mark, Path, Piece, Role, Style, Theme,
    clip_half_plane, hatching, place_labels,
};
use svg::Node;
use svg::node::element::{Circle, Element, Group, Path as PathElement, Text};

/// Grid lines nearer than this, in pixels, are left out: they would be a grey.
const TELLABLE: f64 = 4.0;
/// A path this many times larger than the window is cut to it: single precision
/// still places a path a few windows large to a thousandth of a pixel.
const FAR_LARGER: f64 = 20.0;

impl Writer<'_> {
    pub(super) fn grid(&mut self, frame: &Frame) -> PathElement {
        let shown = frame.shown();
        let step = self.drawing.grid;
        let mut data = String::new();
        let worthwhile = step * frame.scale >= TELLABLE;
        let between = |least: f64, most: f64| {
            let (first, last) = ((least / step).ceil(), (most / step).floor());
            let count = if worthwhile { last - first + 1.0 } else { 0.0 };
            (0..count.max(0.0) as usize).map(move |i| (first + i as f64) * step)
        };
        let window = frame.window;
        for x in between(shown.least.x, shown.most.x) {
            let x = px(frame.to_screen(Vector::new(x, 0.0)).x);
            data += &format!("M{x} {}V{}", px(window.least.y), px(window.most.y));
        }
        for y in between(shown.least.y, shown.most.y) {
            let y = px(frame.to_screen(Vector::new(0.0, y)).y);
            data += &format!("M{} {y}H{}", px(window.least.x), px(window.most.x));
        }
        let mut grid = PathElement::new().set("d", data);
        self.paint(&mut grid, "grid", |theme| {
            vec![
                ("fill", "none".to_owned()),
                ("stroke", theme.palette().grid.to_hex()),
                ("stroke-width", "1".to_owned()),
            ]
        });
        grid
    }

    /// A mark's elements; `None` for one that cannot be drawn.
    pub(super) fn mark(&mut self, mark: &Mark, frame: &Frame) -> Option<Element> {
        let standing = &self.drawing.standing;
        let role = mark.role;
        let style = |theme: Theme| theme.style(role, standing);
        match &mark.geometry {
            Geometry::Path(path) => {
                let points = path.flattened(0.1 / frame.scale);
                if !points.iter().all(|point| finite(*point)) {
                    return None;
                }
                let mut element = PathElement::new().set("d", path_data(path, points, frame));
                let world = mark.thickness * frame.scale;
                self.paint(&mut element, role.word(), |theme| {
                    line_look(&style(theme), world, path.closed)
                });
                Some(element.into())
            }
            Geometry::HalfPlane { point, normal } => {
                self.wall(*point, *normal, frame, role).map(Into::into)
            }
            Geometry::Dot(point) => {
                let at = frame.to_screen(*point);
                finite(at).then(|| self.dot(at, role).into())
            }
            Geometry::Arrow { tail, tip } => {
                let [tail, tip] = [tail, tip].map(|point| frame.to_screen(*point).into());
                Some(self.arrow([tail, tip], role)?.into())
            }
        }
    }

    /// An arrow between two places on the screen; `None` where they are one.
    pub(super) fn arrow(&mut self, [tail, tip]: [[f64; 2]; 2], role: Role) -> Option<PathElement> {
        let outline = Arrowhead::STANDARD.outline(tail, tip);
        if outline.is_empty() {
            return None;
        }
        let corners: Vec<String> = outline
            .iter()
            .map(|[x, y]| format!("{} {}", px(*x), px(*y)))
            .collect();
        let data = format!("M{}Z", corners.join("L"));
        let mut element = PathElement::new().set("d", data);
        let standing = self.drawing.standing.clone();
        self.paint(&mut element, role.word(), |theme| {
            line_look(&theme.style(role, &standing), 0.0, true)
        });
        Some(element)
    }

    /// A half-plane: its area, its surface, and strokes behind the surface.
    fn wall(&mut self, point: Vector, normal: Vector, frame: &Frame, role: Role) -> Option<Group> {
        // A little beyond the window, whose edge is not the wall's.
        let shown = frame.shown().grown(8.0 / frame.scale);
        let clipped = clip_half_plane(point, normal, &shown.corners());
        if clipped.area.is_empty() || !clipped.area.iter().all(|corner| finite(*corner)) {
            return None;
        }
        let standing = &self.drawing.standing;
        let mut area = PathElement::new().set("d", polygon(&clipped.area, frame));
        self.paint(&mut area, role.word(), |theme| {
            line_look(
                &Style {
                    stroke: None,
                    ..theme.style(role, standing)
                },
                0.0,
                true,
            )
        });
        let mut group = Group::new().add(area);
        if let Some(surface) = clipped.surface {
            let edge = |theme: Theme| {
                let style = theme.style(role, standing);
                line_look(
                    &Style {
                        fill: None,
                        ..style
                    },
                    0.0,
                    false,
                )
            };
            let strokes = hatching(surface, -normal, 9.0 / frame.scale, 6.0 / frame.scale);
            let mut data = String::new();
            for [from, to] in strokes {
                let (from, to) = (frame.to_screen(from), frame.to_screen(to));
                data += &format!("M{}L{}", xy(from), xy(to));
            }
            let mut hatch = PathElement::new().set("d", data);
            self.paint(&mut hatch, "hatch", edge);
            let [from, to] = surface.map(|end| frame.to_screen(end));
            let data = format!("M{}L{}", xy(from), xy(to));
            let mut line = PathElement::new().set("d", data);
            self.paint(&mut line, "surface", |theme| {
                let mut style = theme.style(role, standing);
                style.width *= 1.75;
                line_look(
                    &Style {
                        fill: None,
                        ..style
                    },
                    0.0,
                    false,
                )
            });
            group = group.add(hatch).add(line);
        }
        Some(group)
    }

    /// A dot with what its style puts around it.
    fn dot(&mut self, at: Vector, role: Role) -> Group {
        let standing = &self.drawing.standing;
        let style = |theme: Theme| theme.style(role, standing);
        let circle = |radius: f64| {
            Circle::new()
                .set("cx", px(at.x))
                .set("cy", px(at.y))
                .set("r", px(radius))
        };
        let mut group = Group::new();
        let here = style(self.theme);
        if let Some((radius, _)) = here.glow {
            // Three discs over each other fade better than one.
            for share in [1.0, 0.75, 0.55] {
                let mut glow = circle(share * radius);
                self.paint(&mut glow, "glow", |theme| {
                    let mut colour = style(theme).glow.map_or(theme.palette().grid, |g| g.1);
                    colour.opacity *= 0.5;
                    vec![
                        ("fill", colour.to_hex()),
                        ("fill-opacity", px(colour.opacity)),
                    ]
                });
                group.append(glow);
            }
        }
        if let Some((radius, width)) = here.ring {
            let mut ring = circle(radius);
            self.paint(&mut ring, "ring", |theme| {
                let ring = Style {
                    fill: None,
                    width,
                    ..style(theme)
                };
                line_look(&ring, 0.0, true)
            });
            group.append(ring);
        }
        if here.radius > 0.0 {
            let mut dot = circle(here.radius);
            self.paint(&mut dot, role.word(), |theme| {
                line_look(&style(theme), 0.0, true)
            });
            group.append(dot);
        }
        group
    }

    pub(super) fn labels(&mut self, frame: &Frame) -> Group {
        let measure = |label: &LabelText| match label {
            LabelText::Value(value) => {
                Vector::new(1.05 * text::width(&value.text(), SMALL), SMALL + 2.0)
            }
            LabelText::Name(name) => Vector::new(text::width(name, SMALL), SMALL + 2.0),
        };
        let mut group = Group::new().set("text-anchor", "middle");
        let labels = &self.drawing.labels;
        for placed in place_labels(self.drawing, frame, measure) {
            // The baseline of text whose digits are centred on the box.
            let at = placed.area.centre() + Vector::new(0.0, 0.36 * SMALL);
            match &labels[placed.label].text {
                LabelText::Value(value) => {
                    let mut label = Text::new("").set("x", px(at.x)).set("y", px(at.y));
                    self.paint(&mut label, "value", |theme| {
                        vec![
                            ("stroke", theme.palette().background.to_hex()),
                            ("stroke-width", "3".to_owned()),
                            ("stroke-linejoin", "round".to_owned()),
                            ("paint-order", "stroke".to_owned()),
                        ]
                    });
                    self.add_quantity(&mut label, value, STRONG);
                    group.append(label);
                }
                LabelText::Name(name) => {
                    let name = printable(name);
                    group.append(self.text(at, "name", &name, |theme| theme.palette().quiet));
                }
            }
        }
        group
    }
}

fn finite(point: Vector) -> bool {
    point.x.is_finite() && point.y.is_finite()
}

fn xy(point: Vector) -> String {
    format!("{} {}", px(point.x), px(point.y))
}

fn polygon(points: &[Vector], frame: &Frame) -> String {
    let corners: Vec<String> = points.iter().map(|p| xy(frame.to_screen(*p))).collect();
    format!("M{}Z", corners.join("L"))
}

/// A path's data, with exact arcs. A closed path far larger than the window
/// is cut to the window, because renderers count in single precision.
fn path_data(path: &Path, flattened: Vec<Vector>, frame: &Frame) -> String {
    let shown = frame.shown();
    let reach = Bounds::of(flattened.iter().copied()).size().max();
    if path.closed && reach > FAR_LARGER * shown.size().max() {
        let window = shown.grown(8.0 / frame.scale);
        let sides = [
            (window.least, Vector::new(-1.0, 0.0)),
            (window.least, Vector::new(0.0, -1.0)),
            (window.most, Vector::new(1.0, 0.0)),
            (window.most, Vector::new(0.0, 1.0)),
        ];
        let cut = sides.into_iter().fold(flattened, |area, (point, normal)| {
            clip_half_plane(point, normal, &area).area
        });
        return polygon(&cut, frame);
    }
    let mut data = format!("M{}", xy(frame.to_screen(path.start)));
    let mut from = path.start;
    for piece in &path.pieces {
        match *piece {
            Piece::Line { to } => {
                data += &format!("L{}", xy(frame.to_screen(to)));
                from = to;
            }
            Piece::Arc { centre, to, sweep } => {
                let radius = px(frame.scale * (from - centre).norm());
                // Counterclockwise in the world is so on the screen, which
                // SVG, with y downward, calls the negative direction.
                let flag = u8::from(sweep < 0.0);
                data += &format!("A{radius} {radius} 0 0 {flag} {}", xy(frame.to_screen(to)));
                from = to;
            }
        }
    }
    if path.closed {
        data.push('Z');
    }
    data
}

/// The attributes of a line or area of at least `world` pixels' width.
fn line_look(style: &Style, world: f64, closed: bool) -> Look {
    let colour = |colour: Option<Colour>| colour.map_or("none".to_owned(), Colour::to_hex);
    let mut look = vec![("fill", colour(style.fill.filter(|_| closed)))];
    if let Some(opacity) = style.fill.map(|fill| fill.opacity).filter(|o| *o < 1.0) {
        look.push(("fill-opacity", px(opacity)));
    }
    let stroke = style.stroke.filter(|_| style.width > 0.0);
    look.push(("stroke", colour(stroke)));
    if let Some(stroke) = stroke {
        look.push(("stroke-width", px(style.width.max(world))));
        look.push(("stroke-linejoin", "round".to_owned()));
        look.push(("stroke-linecap", "round".to_owned()));
        if stroke.opacity < 1.0 {
            look.push(("stroke-opacity", px(stroke.opacity)));
        }
    }
    look
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::view::circle;

    #[test]
    fn arcs_keep_their_way_round_on_the_screen() {
        let unit = Bounds::of([Vector::new(-1.0, -1.0), Vector::new(1.0, 1.0)]);
        let window = Bounds::of([Vector::zeros(), Vector::new(200.0, 200.0)]);
        let frame = Frame::fitting(&unit, window);
        let mut path = circle(Vector::zeros(), 0.5);
        path.pieces.truncate(1);
        path.closed = false;
        // Counterclockwise from the right over the top, which is flag 0 where
        // y points down.
        let data = path_data(&path, path.flattened(1e-3), &frame);
        assert_eq!(data, "M150 100A50 50 0 0 0 50 100");
        if let Piece::Arc { sweep, .. } = &mut path.pieces[0] {
            *sweep = -*sweep;
        }
        let data = path_data(&path, path.flattened(1e-3), &frame);
        assert_eq!(data, "M150 100A50 50 0 0 1 50 100");
    }

    #[test]
    fn a_huge_outline_is_cut_to_the_window() {
        let unit = Bounds::of([Vector::new(-1.0, -1.0), Vector::new(1.0, 1.0)]);
        let frame = Frame::fitting(
            &unit,
            Bounds {
                least: Vector::zeros(),
                most: Vector::new(200.0, 200.0),
            },
        );
        let path = circle(Vector::new(1e6, 0.0), 1e6);
        let data = path_data(&path, path.flattened(1e-3), &frame);
        let numbers = data.split(|c: char| !(c.is_ascii_digit() || c == '.' || c == '-'));
        let numbers: Vec<f64> = numbers.filter_map(|n| n.parse().ok()).collect();
        assert!(
            numbers.len() >= 6 && numbers.iter().all(|n| (-10.0..=210.0).contains(n)),
            "{data}"
        );
    }
}
