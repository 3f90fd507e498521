//! One step along the branch: its solve, and whether to take it.

use super::{Branch, EASY, LAST_ITERATIONS, NARROWEST, Phase, STEP_ITERATIONS};
use crate::equilibrium::event::Occurrence;
use crate::equilibrium::status::{EndReason, Status};
use crate::mechanics::{Mechanics, Settling};
use crate::robot::Nodes;
use crate::solver::{Outcome, Progress, Settings};

impl<M: Mechanics<NU>, const NU: usize> Branch<M, NU> {
    /// The share of the leg that the next step leads to.
    pub(super) fn target(&self) -> f64 {
        let target = self.at + self.step;
        // Rounding of repeated steps must not leave a last step of nothing.
        if target > 1.0 - 1e-9 { 1.0 } else { target }
    }

    pub(super) fn begin_step(&mut self) {
        if self.iterations >= self.settings.iterations {
            self.end(Status::IterationLimit);
            return;
        }
        self.iterations += 1;
        self.set_now(self.target());
        // Between the anchor and where the solve starts, the obstacles have moved
        // and so has the robot, by the change of the pull at the same turns.
        self.show_anchor();
        self.freeze_now();
        self.phase = Phase::Solving;
        let settings = Settings {
            iterations: if self.step > self.least_step {
                STEP_ITERATIONS
            } else {
                LAST_ITERATIONS
            },
            ..Settings::default()
        };
        self.started.clone_from(&self.anchor.controls);
        self.sqp.start(
            &self.now,
            &self.started,
            &self.anchor.rows.multipliers,
            settings,
        );
        let (before, after) = (&self.anchor.nodes, &self.sqp.point().nodes);
        let (before, after) = (M::shape(before), M::shape(after));
        let (here, now) = (self.here.around(), self.now.around());
        if before.count() == after.count() && here.motion_passes(now, before, after) {
            self.shorten(EndReason::Blocked, NARROWEST * self.least_step);
            return;
        }
        self.predicted.clear();
    }

    pub(super) fn iterate_step(&mut self) {
        let progress = self.sqp.step(&self.now);
        self.iterations += 1;
        if self.predicted.is_empty() {
            self.predicted.clone_from(&self.sqp.point().controls);
        }
        let Progress::Done(outcome) = progress else {
            return;
        };
        let settling = match outcome {
            Outcome::Converged if self.now.rubs() => self.settle(),
            _ => Settling::Settled,
        };
        if settling == Settling::Again {
            return;
        }
        if settling == Settling::Settled && outcome == Outcome::Converged && self.now.rubs() {
            self.predict_with_friction();
        }
        let outcome = match settling {
            Settling::Failed => Outcome::IterationLimit,
            _ => outcome,
        };
        let gave_way = !matches!(
            outcome,
            Outcome::Converged | Outcome::Infeasible | Outcome::OutsideDomain
        );
        if gave_way && self.step <= self.least_step && self.now.let_go() {
            self.solve_again();
            return;
        }
        let locked = self.locked_segment();
        let last_try = self.step <= self.least_step;
        if outcome == Outcome::Converged && locked.is_none() && (last_try || !self.dips()) {
            let follows = self.follows();
            if follows || last_try {
                self.accept(follows);
                return;
            }
        }
        if !last_try {
            self.shorten(EndReason::Fold, self.least_step);
            return;
        }
        let status = match outcome {
            _ if locked.is_none() && self.now.drive().cables_oppose() => {
                self.end_of_branch(EndReason::CablesOppose, None)
            }
            Outcome::Converged => self.end_of_branch(EndReason::LinkageLimit, locked),
            Outcome::Infeasible => Status::Infeasible {
                conflicts: self.conflicts(),
            },
            Outcome::Blocked => self.end_of_branch(EndReason::Blocked, locked),
            Outcome::Saddle | Outcome::Stalled => self.end_of_branch(EndReason::Fold, locked),
            Outcome::IterationLimit if self.now.rubs() => {
                self.end_of_branch(EndReason::FrictionUnsettled, locked)
            }
            Outcome::IterationLimit => Status::IterationLimit,
            Outcome::OutsideDomain => Status::NumericalFailure,
        };
        self.end(status);
    }

    /// Halves the step, down to `least`; the branch ends for this reason where
    /// it is there already.
    fn shorten(&mut self, reason: EndReason, least: f64) {
        self.phase = Phase::Between;
        if self.step <= least {
            let status = self.end_of_branch(reason, None);
            self.end(status);
        } else {
            self.step = (0.5 * self.step).max(least);
        }
    }

    /// Takes the step; one that does not follow the branch is a jump.
    pub(super) fn accept(&mut self, follows: bool) {
        let let_go = self.now.has_let_go();
        if let_go {
            self.note(Occurrence::FrictionGaveWay);
        }
        if !follows {
            let (node, distance) = self.farthest_node();
            self.note(Occurrence::Jump { node, distance });
        }
        self.note_contacts();
        let easy = self.sqp.trace().len() <= EASY + 1;
        std::mem::swap(&mut self.before, &mut self.anchor.rows);
        self.before_at = follows.then_some(self.at);
        self.take_anchor();
        self.at = self.target();
        if !follows || easy || let_go {
            self.step = (2.0 * self.step).min(self.most_step);
        }
        self.phase = Phase::Between;
        if self.at == 1.0 {
            if self.last_leg {
                self.keep_trace();
                self.fill(Status::Converged);
            } else {
                self.from.clone_from(&self.to);
                self.to.clone_from(&self.goal);
                self.begin_leg(true);
            }
        }
    }
}
