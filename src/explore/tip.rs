//! Which pull brings the tip nearest to a point: how a hand on the tip is
//! turned into a pull.

use super::path::{Path, PathState};
use crate::geometry::Vector;

/// How far the tip may move away from a point on the way to a place that is nearer,
/// over the backbone's length.
const CLIMB: f64 = 0.05;
/// How much nearer that place has to be, over the backbone's length.
const WORTH: f64 = 0.01;

/// A place on the tip's polyline.
#[derive(Clone, Copy)]
struct Nearest {
    pull: f64,
    distance: f64,
}

impl Path {
    /// The pull at which the tip comes nearest to a point, in metres, on
    /// straight lines between the states; `None` without states.
    pub fn nearest_to_tip(&self, point: Vector) -> Option<f64> {
        let links = 0..self.links();
        let nearest = links.map(|link| self.on_link(link, point));
        nearest
            .min_by(|a, b| a.distance.total_cmp(&b.distance))
            .map(|nearest| nearest.pull)
    }

    /// The same on the way from a pull: the nearest place that is reached without
    /// moving away from the point by more than a twentieth of the robot, so that the pull does not hop
    /// to another part of a tip's path that winds, and yet does not stop where the
    /// path turns back for a moment, as it does at a contact. A place behind such a
    /// turn has to be nearer by a hundredth: the pull is not to flicker between two that
    /// are as good. A jump is crossed where its other side is nearer.
    pub fn nearest_to_tip_from(&self, point: Vector, pull: f64) -> Option<f64> {
        let count = self.links();
        if count == 0 {
            return None;
        }
        let after = self.states.partition_point(|state| state.pull < pull);
        let here = after.clamp(1, count) - 1;
        let start = self.on_link(here, point);
        let mut best = start;
        let ways: [&mut dyn Iterator<Item = usize>; 2] =
            [&mut (here + 1..count), &mut (0..here).rev()];
        for way in ways {
            let (mut nearest, mut last) = (start, start);
            let mut climbed = 0.0;
            for link in way {
                let next = self.on_link(link, point);
                // Links that share the nearest end are equally near.
                if next.distance > last.distance {
                    climbed = next.distance - nearest.distance;
                    if climbed > CLIMB * self.length {
                        break;
                    }
                }
                let worth = if climbed > 0.0 { WORTH } else { 0.0 };
                if next.distance <= nearest.distance - worth * self.length {
                    (nearest, climbed) = (next, 0.0);
                }
                last = next;
            }
            if nearest.distance < best.distance {
                best = nearest;
            }
        }
        Some(best.pull)
    }

    /// The number of links of the tip's polyline; a path of one state has one.
    fn links(&self) -> usize {
        match self.states.len() {
            0 => 0,
            1 => 1,
            count => count - 1,
        }
    }

    /// Where a link is nearest to a point. That of a jump is its two ends.
    fn on_link(&self, link: usize, point: Vector) -> Nearest {
        let a = &self.states[link];
        let b = self.states.get(link + 1).unwrap_or(a);
        let (start, end) = (a.tip.position, b.tip.position);
        let along = end - start;
        let squared = along.norm_squared();
        let mut t = if squared > 0.0 {
            ((point - start).dot(&along) / squared).clamp(0.0, 1.0)
        } else {
            0.0
        };
        if a.branch != b.branch {
            t = t.round();
        }
        Nearest {
            pull: between(a, b, t),
            distance: (point - start - t * along).norm(),
        }
    }
}

/// The pull a share `t` of the way, exact at the ends.
fn between(a: &PathState, b: &PathState, t: f64) -> f64 {
    (1.0 - t) * a.pull + t * b.pull
}
