//! How a run ends: with which status, and with which shape.

use super::{Branch, Phase};
use crate::contact::RowKind;
use crate::equilibrium::event::Occurrence;
use crate::equilibrium::status::{Conflict, EndReason, Status};
use crate::mechanics::{Mechanics, Model};
use crate::solver::Settings;

impl<M: Mechanics<NU>, const NU: usize> Branch<M, NU> {
    /// Ends short of the goal with the last equilibrium, and the trace of the
    /// solve that did not lead on.
    pub(super) fn end(&mut self, status: Status) {
        if let Status::BranchEnded { reason, segment } = status {
            self.note(Occurrence::BranchEnded { reason, segment });
        }
        self.keep_trace();
        self.set_now(self.at);
        self.show_anchor();
        self.freeze_now();
        let (controls, multipliers) = (&self.anchor.controls, &self.anchor.rows.multipliers);
        let settings = Settings::default();
        self.sqp.start(&self.now, controls, multipliers, settings);
        self.fill(status);
    }

    pub(super) fn keep_trace(&mut self) {
        self.solution.trace.clear();
        self.solution.trace.extend_from_slice(self.sqp.trace());
    }

    pub(super) fn fill(&mut self, status: Status) {
        let (point, multipliers) = (self.sqp.point(), self.sqp.multipliers());
        let (rubbing, certifier) = (&self.anchor.rubbing, &mut self.certifier);
        self.solution
            .fill(&self.now, point, multipliers, rubbing, certifier);
        self.solution.move_by(self.origin);
        self.show_world();
        let certified = self.solution.certificate.holds();
        self.solution.status = match status {
            Status::Converged if !certified => Status::NumericalFailure,
            status => status,
        };
        self.solution.iterations = self.iterations;
        self.phase = Phase::Done;
    }

    /// The rows whose multipliers are largest where the rows' violation is
    /// stationary: those within a thousandth of the bound.
    pub(super) fn conflicts(&self) -> Vec<Conflict> {
        let count = self.now.obstacles().len();
        let multipliers = self.sqp.multipliers();
        let most = multipliers.iter().fold(0.0_f64, |a, b| a.max(*b));
        let rows = self.sqp.point().rows.iter().zip(multipliers);
        let mut conflicts: Vec<Conflict> = rows
            .filter(|(_, multiplier)| **multiplier > 1e-3 * most)
            .filter_map(|(row, _)| match RowKind::of(row.id, count) {
                RowKind::Contact {
                    candidate,
                    obstacle,
                    ..
                } => {
                    let candidate = &self.now.candidates()[candidate];
                    Some(Conflict {
                        line: candidate.line,
                        node: candidate.node,
                        obstacle,
                    })
                }
                RowKind::TurnLimit { .. } | RowKind::Cable { .. } => None,
            })
            .collect();
        conflicts.dedup();
        conflicts
    }

    /// The segment that the solve left pressing against its limit.
    pub(super) fn locked_segment(&self) -> Option<usize> {
        let mut rows = self.sqp.point().rows.iter().zip(self.sqp.multipliers());
        rows.find_map(|(row, multiplier)| {
            let segment = self.now.limited_segment(row.id)?;
            (*multiplier > 0.0).then_some(segment)
        })
    }

    /// The end of the branch at the anchor: where a segment locks, that is the
    /// reason.
    pub(super) fn end_of_branch(&self, reason: EndReason, locked: Option<usize>) -> Status {
        Status::BranchEnded {
            reason: match (locked, self.now.model()) {
                (None, _) => reason,
                (Some(_), Model::Equal) => EndReason::LinkageLimit,
                (Some(_), Model::Sliding) => EndReason::DisksTouch,
            },
            segment: locked.unwrap_or_else(|| self.now.most_strained(&self.anchor.controls)),
        }
    }
}
