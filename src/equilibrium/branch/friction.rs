//! How friction goes on from one shape to the next along a branch.

use super::{Branch, pressing};
use crate::contact::RowKind;
use crate::mechanics::{Mechanics, Settling};
use crate::solver::{RowId, Settings, Tunnelling};

impl<M: Mechanics<NU>, const NU: usize> Branch<M, NU> {
    /// Freezes friction in the present problem as it is at the anchor, where the
    /// obstacles are in `here`.
    pub(super) fn freeze_now(&mut self) {
        let (nodes, rubbing) = (&self.anchor.nodes, &self.anchor.rubbing);
        self.now.freeze(self.here.obstacles(), nodes, rubbing);
        if self.now.rubs() {
            let rows = &self.anchor.rows.multipliers;
            self.anchor.rows.multipliers = with_tensions(&self.now, rows);
        }
    }

    /// Predicts the step's end anew, with friction as it turned out: what holes and
    /// contacts do there is no part of what the step has to explain.
    pub(super) fn predict_with_friction(&mut self) {
        let multipliers = with_tensions(&self.now, &self.anchor.rows.multipliers);
        let settings = Settings {
            tunnelling: Tunnelling::Allowed,
            ..Settings::default()
        };
        self.back
            .start(&self.now, &self.started, &multipliers, settings);
        self.back.step(&self.now);
        self.iterations += 1;
        self.predicted.clone_from(&self.back.point().controls);
    }

    /// Begins the step's solve anew, with friction as it is now frozen.
    pub(super) fn solve_again(&mut self) {
        let multipliers = with_tensions(&self.now, &self.anchor.rows.multipliers);
        let settings = self.sqp.settings();
        self.sqp
            .start(&self.now, &self.started, &multipliers, settings);
        self.predicted.clear();
    }

    /// Lets friction follow the shape that a solve has found.
    pub(super) fn settle(&mut self) -> Settling {
        let settling = self.now.settle(self.sqp.point(), self.sqp.multipliers());
        if settling == Settling::Again {
            let rows: Vec<(RowId, f64)> = pressing(&self.sqp).collect();
            let controls = self.sqp.point().controls.clone();
            let multipliers = with_tensions(&self.now, &rows);
            let settings = self.sqp.settings();
            self.sqp.start(&self.now, &controls, &multipliers, settings);
        }
        settling
    }
}

/// Multipliers of rows, those that hold cables as friction has them frozen.
pub(super) fn with_tensions<M: Mechanics<NU>, const NU: usize>(
    now: &M,
    rows: &[(RowId, f64)],
) -> Vec<(RowId, f64)> {
    let count = now.obstacles().len();
    let is_cable = |id: RowId| matches!(RowKind::of(id, count), RowKind::Cable { .. });
    let others = rows.iter().filter(|(id, _)| !is_cable(*id));
    let mut rows: Vec<(RowId, f64)> = others.copied().collect();
    now.add_tensions(&mut rows);
    rows
}
