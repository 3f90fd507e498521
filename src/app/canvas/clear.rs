//! What words over the canvas keep clear of: the robot's tip and base, what it touches,
//! where it got stuck, the tools and the legend; and where there is room for them.

use super::banner::stuck_places;
use super::view::Canvas;
use crate::app::paint::to_screen;
use crate::app::workbench::Workbench;
use eframe::egui::{Pos2, Rect, Vec2, pos2};

/// Room around a point of the robot, in points.
const AROUND: f32 = 16.0;
/// Height of what is along the lower edge: the legend and the scale bar.
const LEGEND: f32 = 40.0;
/// Room between words and the canvas's edges, and the distance of places that are tried.
const EDGE: f32 = 12.0;
const STEP: f32 = 16.0;

/// Where words go where nothing is in the way.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rather {
    /// Near the upper edge.
    Above,
    /// Near the lower one.
    Below,
}

/// What words keep clear of, as far as the canvas shows it.
pub fn kept(canvas: &Canvas, bench: &Workbench) -> Vec<Rect> {
    let rect = canvas.rect;
    if !rect.is_positive() {
        return Vec::new();
    }
    let frame = canvas.frame();
    let mut kept = vec![
        Rect::from_min_max(pos2(rect.left(), rect.bottom() - LEGEND), rect.max),
        canvas.strip,
    ];
    if let Some(solved) = bench.live.solution() {
        let ends = [solved.nodes.first(), solved.nodes.last()];
        let ends = ends.into_iter().flatten().map(|node| node.position);
        let touched = solved.contacts.iter().map(|contact| contact.point);
        let points = ends.chain(touched).chain(stuck_places(&bench.live));
        let around =
            |point| Rect::from_center_size(to_screen(&frame, point), Vec2::splat(2.0 * AROUND));
        kept.extend(points.map(around));
    }
    kept.retain(|area| area.is_finite() && area.intersects(rect));
    kept
}

/// The corner of a box of this size in a window that keeps as clear as can be of what
/// is kept, as near as possible to where it would rather be.
pub fn place(window: Rect, size: Vec2, kept: &[Rect], rather: Rather) -> Pos2 {
    let room = window.shrink(EDGE);
    let free = (room.size() - size).max(Vec2::ZERO);
    let count = (free.y / STEP).floor() as usize;
    let mut best: Option<(f32, Pos2)> = None;
    for row in 0..=count {
        for (far, share) in [(0.0, 0.5), (1.0, 0.0), (1.0, 1.0)] {
            let down = row as f32 * STEP;
            let y = match rather {
                Rather::Above => room.top() + down,
                Rather::Below => room.bottom() - size.y - down,
            };
            let corner = pos2(room.left() + share * free.x, y.max(room.top()));
            let area = Rect::from_min_size(corner, size);
            let covered = kept.iter().filter(|other| other.intersects(area)).count();
            let cost = 1e4 * covered as f32 + down + STEP * far;
            if best.is_none_or(|(least, _)| cost < least) {
                best = Some((cost, corner));
            }
        }
    }
    best.map_or(room.min, |(_, corner)| corner)
}

#[cfg(test)]
mod tests {
    use super::*;
    use eframe::egui::vec2;

    #[test]
    fn words_go_where_nothing_is_in_the_way() {
        let window = Rect::from_min_size(Pos2::ZERO, vec2(400.0, 600.0));
        let size = vec2(300.0, 60.0);
        let at = |kept: &[Rect]| place(window, size, kept, Rather::Above);
        assert_eq!(at(&[]), pos2(50.0, 12.0));
        // Beside it where that is enough, else below.
        let tip = Rect::from_center_size(pos2(340.0, 40.0), vec2(32.0, 32.0));
        assert_eq!(at(&[tip]), pos2(12.0, 12.0));
        let tip = Rect::from_center_size(pos2(200.0, 40.0), vec2(32.0, 32.0));
        let found = Rect::from_min_size(at(&[tip]), size);
        assert!(!found.intersects(tip) && found.top() < 80.0, "{found:?}");
        // Where everything is in the way, somewhere inside.
        let found = Rect::from_min_size(at(&[window]), size);
        assert!(window.contains_rect(found));
        assert_eq!(
            place(window, size, &[], Rather::Below).y,
            600.0 - 12.0 - 60.0
        );
    }
}
