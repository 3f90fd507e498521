//! What a run asks of the four-bar robot beyond the chain: which controls it
//! starts from, how large a change of them matters, where it is strained most, and
//! what the solver's cost counts as 1.

use crate::contact::RowKind;
use crate::mechanics::Problem;
use crate::solver::{Control, RowId};

impl Problem {
    /// The controls of the free robot, straight or an arc: no turn anywhere.
    pub fn free_controls(&self) -> Vec<Control<1>> {
        vec![Control::zeros(); self.robot().segments]
    }

    /// The change of a control that is a large one, whatever the number of
    /// segments: a turn of 1 rad.
    pub fn control_scale(&self) -> f64 {
        1.0
    }

    /// The change of the pull that is a large one, in metres: the cable offset,
    /// over which the free robot's tip turns by 1 rad.
    pub fn pull_scale(&self) -> f64 {
        self.robot().offset
    }

    /// The energy, in rad², that the solver's cost Σ (β/β*)² counts as 1; 0
    /// without pull.
    pub fn cost_unit(&self) -> f64 {
        let bend = self.segment().free_bend();
        bend * bend
    }

    /// ψ of each segment, in radians, clockwise.
    pub fn shears<'a>(&'a self, controls: &'a [Control<1>]) -> impl Iterator<Item = f64> + 'a {
        controls.iter().map(|turn| self.segment().shear(turn[0]))
    }

    /// The segment, from 1, that is nearest to the limit of its linkage.
    pub fn most_strained(&self, controls: &[Control<1>]) -> usize {
        let turns = controls.iter().map(|control| control[0].abs());
        let most = turns.enumerate().fold(
            (0, 0.0),
            |most, next| {
                if next.1 > most.1 { next } else { most }
            },
        );
        most.0 + 1
    }

    /// The segment whose limit a row is, if it is one. Eq. 5 knows no such limit:
    /// a shape that presses against it is none of its equilibria.
    pub fn limited_segment(&self, row: RowId) -> Option<usize> {
        match RowKind::of(row, self.obstacles().len()) {
            RowKind::TurnLimit { segment, .. } => Some(segment),
            RowKind::Contact { .. } => None,
        }
    }
}
