//! Whether a step's end is on the branch that the step started from. It only
//! judges; what is then done about it, the step decides.
//!
//! A solve can end at a minimum of another branch while that of the anchor is
//! still there: past a small disc, whose linearised clearance says nothing
//! about its far side, the first subproblem itself leads over. Seen from the
//! start such an end looks well predicted. Seen from the end it does not: the
//! tangent there leads on along the other branch, not back to the anchor. So a
//! step is judged from both ends.

use super::{Branch, UNNOTICED, pressing};
use crate::contact::RowKind;
use crate::mechanics::Mechanics;
use crate::solver::{Control, Settings, Tunnelling};

/// A step that moves no part of a disk farther than this, over the backbone's
/// length, follows the branch: nobody would call it a jump (at 180 mm, 0.02 mm).
/// A robot that is wedged between obstacles may have nothing but such steps before
/// it.
const UNSEEN: f64 = 1e-4;
/// Any other is refused where a control changes by more than this, over what its
/// mechanics calls a large change.
const MOST_TURNED: f64 = 0.3;
/// Share of the predicted turn that the rest of the solve may add, besides
/// what is not noticed.
const UNPREDICTED: f64 = 0.4;
/// A step explained to this share, with the same contacts at both ends, is not
/// looked back on: that would take a third of its time once more.
const WELL_PREDICTED: f64 = 0.2;
/// A step explained to this share, with other contacts at its end, may differ
/// from the end's tangent by as much as that tangent leads.
const NEARLY_PREDICTED: f64 = 0.3;
/// How far back the tangent at a step's end is measured, as a share of the
/// step: so near that what presses stays the same, but far above rounding.
const LOOK_BACK: f64 = 0.05;
/// How far, as a cosine, an obstacle's normal may turn where a point slides or
/// lifts off: by 45°.
const SLIDE: f64 = 0.7;

impl<M: Mechanics<NU>, const NU: usize> Branch<M, NU> {
    /// Whether the step's end is on the branch the anchor is on: its first
    /// iteration explains most of it, and so does the tangent at its end.
    pub(super) fn follows(&mut self) -> bool {
        let end = &self.sqp.point().controls;
        let turned = farthest(&self.started, end);
        let predicted = farthest(&self.started, &self.predicted);
        let rest = farthest(&self.predicted, end);
        let (from, to) = (&self.anchor.nodes, &self.sqp.point().nodes);
        let (from, to) = (M::shape(from), M::shape(to));
        let seen = self.now.around().greatest_motion(from, to) > UNSEEN * self.now.length();
        let scale = self.now.control_scale();
        let unnoticed = UNNOTICED * scale;
        if turned <= unnoticed || !seen {
            return true;
        }
        if turned > MOST_TURNED * scale || rest > UNPREDICTED * predicted + unnoticed {
            return false;
        }
        self.find_pressing();
        let before = self.anchor.rows.multipliers.iter().map(|(id, _)| id);
        let same = before.eq(self.pressing.iter().map(|(id, _)| id));
        if same && rest <= WELL_PREDICTED * predicted {
            return true;
        }
        // A contact made or lost within the step leaves the end's tangent only
        // a part of the way to explain.
        let nearly = !same && rest <= NEARLY_PREDICTED * predicted;
        self.leads_back(if nearly { 1.0 } else { UNPREDICTED })
    }

    /// Whether some point of the robot steps over an obstacle, or over the
    /// better part of its front: chords that are no motion along a branch.
    pub(super) fn dips(&self) -> bool {
        let count = self.now.obstacles().len();
        let least_cosine = |candidate, obstacle| {
            let kind = RowKind::Contact {
                candidate,
                obstacle,
                vertex: None,
            };
            let id = kind.id(count);
            let before = &self.anchor.rows.multipliers;
            let rows = self.sqp.point().rows.iter().zip(self.sqp.multipliers());
            let mut pressing = rows.filter(|(_, multiplier)| **multiplier > 0.0);
            let touches = before.iter().any(|(other, _)| *other == id)
                || pressing.any(|(row, _)| row.id == id);
            if touches { SLIDE } else { 1.0 }
        };
        let (from, to) = (&self.anchor.nodes, &self.sqp.point().nodes);
        let (from, to) = (M::shape(from), M::shape(to));
        self.here
            .around()
            .motion_dips(self.now.around(), from, to, least_cosine)
    }

    /// Whether the tangent at the step's end, drawn back over the whole step,
    /// meets the anchor but for this share of its length.
    fn leads_back(&mut self, share: f64) -> bool {
        let target = self.target();
        let near = target - LOOK_BACK * (target - self.at);
        let (from, to) = (&self.from, &self.to);
        self.here.change(|here| here.set_between(from, to, near));
        self.here.freeze_like(&self.now);
        let settings = Settings {
            tunnelling: Tunnelling::Allowed,
            ..Settings::default()
        };
        let end = &self.sqp.point().controls;
        self.back.start(&self.here, end, &self.pressing, settings);
        self.back.step(&self.here);
        self.iterations += 1;
        let back = self.back.point().controls.iter();
        let (mut led, mut rest) = (0.0_f64, 0.0_f64);
        for ((back, end), start) in back.zip(end).zip(&self.started) {
            let tangent = (back - end) / LOOK_BACK;
            led = led.max(tangent.amax());
            rest = rest.max((start - end - tangent).amax());
        }
        rest <= share * led + UNNOTICED * self.now.control_scale()
    }

    fn find_pressing(&mut self) {
        self.pressing.clear();
        self.pressing.extend(pressing(&self.sqp));
    }
}

/// The greatest difference between two sets of controls.
pub(super) fn farthest<const NU: usize>(a: &[Control<NU>], b: &[Control<NU>]) -> f64 {
    a.iter()
        .zip(b)
        .map(|(a, b)| (a - b).amax())
        .fold(0.0, f64::max)
}
