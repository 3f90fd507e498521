//! How each role looks, by day and by night. Widths and sizes are in points
//! of the screen; nothing here knows where anything is.
//!
//! Contacts have one sequential scale over amber, away from the background: from
//! pale to dark by day and from dark to bright by night. Its lightness changes one
//! way, so that it can be read without seeing hues. What is next to nothing fades;
//! all else that presses has an edge that stands out from the background.

use super::drawing::{Role, Standing};
use crate::contact::Class;

/// A choice of colours.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Theme {
    /// Dark on light.
    #[default]
    Light,
    /// Light on dark.
    Dark,
}

/// A colour with opacity: red, green, blue from 0 to 255 in sRGB.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Colour {
    /// Red, green and blue.
    pub rgb: [u8; 3],
    /// Opacity from 0 to 1.
    pub opacity: f64,
}

impl Colour {
    const fn hex(rgb: u32) -> Self {
        Self {
            rgb: [(rgb >> 16) as u8, (rgb >> 8) as u8, rgb as u8],
            opacity: 1.0,
        }
    }

    const fn faded(self, opacity: f64) -> Self {
        Self {
            rgb: self.rgb,
            opacity,
        }
    }

    /// The colour a share `t` of the way to another.
    fn towards(self, other: Self, t: f64) -> Self {
        let mix = |i: usize| {
            let (a, b) = (f64::from(self.rgb[i]), f64::from(other.rgb[i]));
            (a + t * (b - a)).round() as u8
        };
        Self {
            rgb: [mix(0), mix(1), mix(2)],
            opacity: self.opacity + t * (other.opacity - self.opacity),
        }
    }

    /// The relative luminance, from 0 to 1, as WCAG 2 defines it.
    pub fn luminance(&self) -> f64 {
        let linear = self.rgb.map(|part| {
            let part = f64::from(part) / 255.0;
            if part <= 0.04045 {
                part / 12.92
            } else {
                libm::pow((part + 0.055) / 1.055, 2.4)
            }
        });
        0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]
    }

    /// `#rrggbb`, without the opacity.
    pub fn to_hex(self) -> String {
        let [red, green, blue] = self.rgb;
        format!("#{red:02x}{green:02x}{blue:02x}")
    }
}

/// The colours that are not a mark's.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Palette {
    /// Behind everything.
    pub background: Colour,
    /// Lines of the grid.
    pub grid: Colour,
    /// Titles and numbers.
    pub text: Colour,
    /// Units, names of facts.
    pub muted: Colour,
    /// Names of obstacles.
    pub quiet: Colour,
    /// Warnings, always with a word.
    pub warning: Colour,
    /// The scale of contacts at 0, ½ and 1.
    pub contact: [Colour; 3],
    /// The edge of arrows and contacts.
    casing: Colour,
    ink: Colour,
    node: Colour,
    disk: Colour,
    cable: Colour,
    obstacle: Colour,
    obstacle_edge: Colour,
    greyed: Colour,
}

const LIGHT: Palette = Palette {
    background: Colour::hex(0xfafaf7),
    grid: Colour::hex(0xeeeee9),
    text: Colour::hex(0x1c2028),
    muted: Colour::hex(0x6a6e77),
    quiet: Colour::hex(0x77766f),
    warning: Colour::hex(0xa84a06),
    contact: [
        Colour::hex(0xf3d3a2),
        Colour::hex(0xdb7a1c),
        Colour::hex(0x7d2a06),
    ],
    casing: Colour::hex(0x4a220c),
    ink: Colour::hex(0x1c2430),
    node: Colour::hex(0xfafaf7),
    disk: Colour::hex(0xa3a8b1),
    cable: Colour::hex(0x2468d8),
    obstacle: Colour::hex(0xe4e3dc),
    obstacle_edge: Colour::hex(0xc2c0b6),
    greyed: Colour::hex(0xb4b5b6),
};

const DARK: Palette = Palette {
    background: Colour::hex(0x15171c),
    grid: Colour::hex(0x1e2127),
    text: Colour::hex(0xe9ebef),
    muted: Colour::hex(0x8f95a0),
    quiet: Colour::hex(0x8f96a3),
    warning: Colour::hex(0xf2a33c),
    contact: [
        Colour::hex(0x8a4a24),
        Colour::hex(0xe8892b),
        Colour::hex(0xffe08a),
    ],
    casing: Colour::hex(0x15171c),
    ink: Colour::hex(0xeef1f5),
    node: Colour::hex(0x15171c),
    disk: Colour::hex(0x626975),
    cable: Colour::hex(0x64a1ff),
    obstacle: Colour::hex(0x2a2e37),
    obstacle_edge: Colour::hex(0x454b58),
    greyed: Colour::hex(0x5b606a),
};

/// How a mark looks; widths and radii in points of the screen. A width of 0 is no
/// line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Style {
    /// What areas, dots and arrows are filled with.
    pub fill: Option<Colour>,
    /// What lines and edges are drawn with.
    pub stroke: Option<Colour>,
    /// The width of lines and edges.
    pub width: f64,
    /// The radius of dots.
    pub radius: f64,
    /// A ring around a dot: its radius and its width, in the stroke's colour.
    pub ring: Option<(f64, f64)>,
    /// A soft disc behind a dot: its radius and its colour.
    pub glow: Option<(f64, Colour)>,
}

/// The sizes of arrows, in points.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Arrowhead {
    /// Length of the head; a shorter arrow is all head.
    pub length: f64,
    /// Half the width of the head.
    pub half_width: f64,
    /// Width of the shaft.
    pub shaft: f64,
}

impl Arrowhead {
    /// The arrowhead of every picture.
    pub const STANDARD: Self = Self {
        length: 10.0,
        half_width: 4.5,
        shaft: 2.4,
    };

    /// The outline of an arrow on the screen, from its tail round to its
    /// tail: seven points. Empty where the arrow has no length.
    pub fn outline(&self, tail: [f64; 2], tip: [f64; 2]) -> Vec<[f64; 2]> {
        let along = [tip[0] - tail[0], tip[1] - tail[1]];
        let length = libm::hypot(along[0], along[1]);
        if length.is_nan() || length <= 0.0 {
            return Vec::new();
        }
        let [ux, uy] = [along[0] / length, along[1] / length];
        let at = |forward: f64, aside: f64| {
            [
                tail[0] + forward * ux - aside * uy,
                tail[1] + forward * uy + aside * ux,
            ]
        };
        // A short arrow keeps its shape and shrinks.
        let size = (length / (1.4 * self.length)).min(1.0);
        let neck = length - size * self.length;
        let (shaft, half_width) = (0.5 * size * self.shaft, size * self.half_width);
        vec![
            at(0.0, shaft),
            at(neck, shaft),
            at(neck, half_width),
            at(length, 0.0),
            at(neck, -half_width),
            at(neck, -shaft),
            at(0.0, -shaft),
        ]
    }
}

impl Theme {
    /// The theme's colours.
    pub fn palette(self) -> &'static Palette {
        match self {
            Theme::Light => &LIGHT,
            Theme::Dark => &DARK,
        }
    }

    /// The colour of a multiplier, as a share of the greatest from 0 to 1.
    pub fn contact(self, share: f64) -> Colour {
        let [low, middle, high] = self.palette().contact;
        let share = if share.is_nan() {
            0.0
        } else {
            share.clamp(0.0, 1.0)
        };
        if share < 0.5 {
            low.towards(middle, 2.0 * share)
        } else {
            middle.towards(high, 2.0 * share - 1.0)
        }
    }

    /// How a role looks in a drawing of this standing.
    pub fn style(self, role: Role, standing: &Standing) -> Style {
        let palette = self.palette();
        let believed = |colour: Colour| {
            if standing.is_greyed() {
                palette.greyed
            } else {
                colour
            }
        };
        let line = |colour, width| Style {
            stroke: Some(believed(colour)),
            width,
            ..Style::NOTHING
        };
        match role {
            Role::Obstacle(_) => Style {
                fill: Some(palette.obstacle),
                stroke: Some(palette.obstacle_edge),
                width: 1.0,
                ..Style::NOTHING
            },
            Role::Base => line(palette.disk, 2.0),
            Role::BaseHatch => line(palette.disk, 1.0),
            Role::TipTrace => Style {
                stroke: Some(palette.cable.faded(0.45)),
                width: 1.25,
                ..Style::NOTHING
            },
            Role::Disk => line(palette.disk, 1.75),
            // Between a disk and its force: as bright as that it would be taken for
            // another arrow.
            Role::TouchedDisk(share) => {
                let pressed = self.contact(share);
                line(palette.disk.towards(pressed, 0.55 * strength(share)), 2.25)
            }
            Role::Cable => line(palette.cable, 1.75),
            Role::SlackCable => line(palette.cable.faded(0.7), 1.0),
            Role::Backbone => line(palette.ink, 3.5),
            Role::Node => Style {
                fill: Some(palette.node.faded(0.9)),
                radius: 0.9,
                ..Style::NOTHING
            },
            Role::Tip => Style {
                fill: Some(palette.background),
                stroke: Some(believed(palette.ink)),
                width: 2.0,
                radius: 3.5,
                ..Style::NOTHING
            },
            Role::Force(share) => Style {
                fill: Some(believed(self.contact(share)).faded(strength(share))),
                stroke: Some(if standing.is_greyed() {
                    palette.background
                } else {
                    palette.casing.faded(strength(share))
                }),
                width: 1.0,
                ..Style::NOTHING
            },
            Role::Cone { share, slides } => {
                let pressed = believed(self.contact(share));
                let edge = if slides { 0.8 } else { 0.4 };
                Style {
                    fill: Some(pressed.faded(0.16 * strength(share))),
                    stroke: Some(pressed.faded(edge * strength(share))),
                    width: if slides { 1.25 } else { 0.75 },
                    ..Style::NOTHING
                }
            }
            // Of the force's colour, which means grams, and told from it by its way.
            Role::Friction(share) => self.style(Role::Force(share), standing),
            Role::Contact { share, class } => {
                let colour = believed(self.contact(share));
                let pressing = class == Class::Pressing;
                let ring = if pressing { (7.0, 1.75) } else { (5.5, 0.9) };
                Style {
                    fill: pressing.then_some(colour),
                    stroke: Some(if pressing {
                        believed(palette.ring(colour))
                    } else {
                        believed(palette.muted)
                    }),
                    width: 0.0,
                    radius: if pressing { 3.75 } else { 0.0 },
                    ring: Some(ring),
                    glow: pressing
                        .then_some((14.0, colour.faded((0.22 + 0.2 * share) * strength(share)))),
                }
            }
        }
    }
}

/// How much is seen of what a share of the scale lights up: all of it from a
/// twentieth on.
fn strength(share: f64) -> f64 {
    (20.0 * share).min(1.0)
}

impl Style {
    const NOTHING: Self = Self {
        fill: None,
        stroke: None,
        width: 0.0,
        radius: 0.0,
        ring: None,
        glow: None,
    };
}

impl Palette {
    /// The colour of a contact's ring: its own by night, its edge by day,
    /// where the bright end would not stand out.
    fn ring(&self, colour: Colour) -> Colour {
        if self.background.luminance() > 0.5 {
            self.casing
        } else {
            colour
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_contact_scale_goes_away_from_the_background() {
        for theme in [Theme::Light, Theme::Dark] {
            let light: Vec<f64> = (0..=50)
                .map(|i| theme.contact(f64::from(i) / 50.0).luminance())
                .collect();
            let rises = theme == Theme::Dark;
            let goes = |pair: &[f64]| (pair[0] < pair[1]) == rises;
            assert!(light.windows(2).all(goes), "{light:?}");
        }
    }

    /// WCAG 2 asks for 4.5 for text and 3 for parts of a picture.
    #[test]
    fn text_and_ink_stand_out() {
        let contrast = |a: Colour, b: Colour| {
            let (a, b) = (a.luminance() + 0.05, b.luminance() + 0.05);
            (a / b).max(b / a)
        };
        for theme in [Theme::Light, Theme::Dark] {
            let palette = theme.palette();
            for text in [palette.text, palette.muted, palette.warning] {
                assert!(contrast(text, palette.background) >= 4.5, "{text:?}");
            }
            assert!(contrast(palette.quiet, palette.obstacle) >= 3.0);
            for line in [palette.ink, palette.cable] {
                assert!(contrast(line, palette.background) >= 3.0, "{line:?}");
            }
        }
    }

    #[test]
    fn a_short_arrow_ends_where_it_should() {
        let head = Arrowhead::STANDARD;
        for length in [0.5, 8.0, 100.0] {
            let outline = head.outline([3.0, 4.0], [3.0, 4.0 - length]);
            assert_eq!(outline[3], [3.0, 4.0 - length]);
            assert!(outline.iter().all(|p| p[1] <= 4.0 + 1e-12));
        }
        assert!(head.outline([1.0, 1.0], [1.0, 1.0]).is_empty());
    }
}
