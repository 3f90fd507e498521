//! Hints for the first minute: what can be dragged. Each is gone after its
//! first use, for good.

use super::chip;
use crate::app::look::{Tokens, icons};
use crate::app::paint::to_screen;
use crate::app::workbench::{Hints, Live};
use crate::view::Frame;
use eframe::egui::{Painter, Rect, vec2};

/// Paints the hints that are still of use.
pub fn paint(
    found: Hints,
    painter: &Painter,
    live: &Live,
    frame: &Frame,
    within: Rect,
    tokens: &Tokens,
) {
    let mark = (icons::HAND_POINTING, tokens.accent);
    let mut taken = Rect::NOTHING;
    if !found.obstacle
        && let Some(obstacle) = live.problem().obstacles().first()
    {
        let middle = to_screen(frame, obstacle.position());
        if within.contains(middle) {
            // Clear of the contact, which the robot has on its left, and
            // of the name in the middle.
            let at = middle + vec2(14.0, 12.0);
            taken = chip::marked(painter, within, at, mark, "Drag me", tokens);
        }
    }
    let solution = live.solution();
    if !found.tip
        && let Some(tip) = solution.and_then(|solution| solution.nodes.last())
    {
        let at = to_screen(frame, tip.position);
        let at = at + vec2(16.0, -34.0);
        // One after the other where they would lie over each other.
        let room = Rect::from_min_size(at, vec2(160.0, 28.0));
        if within.contains(at) && !taken.intersects(room) {
            chip::marked(painter, within, at, mark, "Drag the tip to pull", tokens);
        }
    }
}
