//! How cables go through their holes, marked on the lines of their tension: an arrowhead
//! towards the base or the tip where one slips, a bar where it sticks.

use super::cache::Pull;
use super::pane::{Surface, Text, hue};
use crate::app::look::Tokens;
use crate::mechanics::Slip;
use crate::view::Theme;
use eframe::egui::{Align2, Color32, Pos2, Rect, Shape, Stroke, vec2};

/// Half of a mark's height, in points.
const HALF: f32 = 4.0;
/// Room for a mark in the key, in points.
const ROOM: f32 = 14.0;

/// Paints the marks, and in the lower corner what those mean that there are.
pub(super) fn paint(
    surface: &Surface<'_>,
    pulls: &[Pull],
    factor: f64,
    theme: Theme,
    tokens: &Tokens,
) {
    for (index, pull) in pulls.iter().enumerate() {
        for (hole, slip) in pull.slips.iter().enumerate() {
            if let Some((disk, level)) = pull.hole(hole) {
                let at = surface.at(disk, factor * level);
                surface
                    .painter
                    .extend(mark(*slip, at, hue(theme, index), tokens));
            }
        }
    }
    let known = [
        (Slip::In, "slips in, towards the base"),
        (Slip::Out, "slips out"),
        (Slip::Sticks, "sticks"),
    ];
    let mut corner = surface.frame().left_bottom() + vec2(10.0, -12.0);
    for (slip, words) in known {
        let mut all = pulls.iter().flat_map(|pull| &pull.slips);
        if !all.any(|one| *one == slip) {
            continue;
        }
        let text = Text::of(words, tokens.muted);
        let place = corner + vec2(ROOM, 0.0);
        let area = surface.name(place, Align2::LEFT_CENTER, text);
        let at = corner + vec2(HALF, 0.0);
        surface.painter.extend(mark(slip, at, tokens.muted, tokens));
        corner.x = area.right() + ROOM;
    }
}

/// A mark on a seam of the paper's colour, so that the line below does not run into it.
fn mark(slip: Slip, at: Pos2, ink: Color32, tokens: &Tokens) -> Vec<Shape> {
    let seam = Stroke::new(3.0, tokens.panel);
    let shape = |stroke: Stroke| match slip {
        Slip::Sticks => {
            let bar = Rect::from_center_size(at, vec2(0.8 * HALF, 2.0 * HALF));
            Shape::rect_filled(bar.expand(0.5 * stroke.width), 0.0, stroke.color)
        }
        Slip::In | Slip::Out => {
            let way = if slip == Slip::In { -1.0 } else { 1.0 };
            let corners = [(1.1, 0.0), (-0.7, 1.0), (-0.7, -1.0)]
                .map(|(along, aside)| at + HALF * vec2(way * along, aside));
            Shape::convex_polygon(corners.to_vec(), stroke.color, stroke)
        }
    };
    vec![shape(seam), shape(Stroke::new(0.0, ink))]
}
