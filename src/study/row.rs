//! One sample's row: how it ended, why, and its outputs.

use crate::equilibrium::Status;

/// How a sample ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// A certified equilibrium at the goal.
    Converged,
    /// The obstacles leave the robot no shape.
    Infeasible,
    /// The branch from the straight robot ends before the goal.
    BranchEnded,
    /// The allowed iterations were used up.
    IterationLimit,
    /// Rounding kept the solve from its tolerances.
    NumericalFailure,
    /// The sample's values describe no robot.
    BadScene,
}

impl Verdict {
    /// Every verdict.
    pub const ALL: [Self; 6] = [
        Self::Converged,
        Self::Infeasible,
        Self::BranchEnded,
        Self::IterationLimit,
        Self::NumericalFailure,
        Self::BadScene,
    ];

    /// The verdict in one word, as in tables; that of [`Status`] where there is one.
    pub fn word(self) -> &'static str {
        match self {
            Self::Converged => "converged",
            Self::Infeasible => "infeasible",
            Self::BranchEnded => "branch_ended",
            Self::IterationLimit => "iteration_limit",
            Self::NumericalFailure => "numerical_failure",
            Self::BadScene => "bad_scene",
        }
    }

    pub(super) fn of_word(word: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|verdict| verdict.word() == word)
    }

    pub(super) fn of_status(status: &Status) -> Self {
        match status {
            Status::Converged => Self::Converged,
            Status::Infeasible { .. } => Self::Infeasible,
            Status::BranchEnded { .. } => Self::BranchEnded,
            Status::IterationLimit => Self::IterationLimit,
            Status::Unfinished | Status::NumericalFailure => Self::NumericalFailure,
        }
    }
}

/// What came of a sample.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// How it ended.
    pub verdict: Verdict,
    /// Why it has no shape at its goal, in a sentence; empty of one that converged.
    pub reason: String,
    /// What was asked for, in the order of [`super::Study::computed`]; NaN where there is
    /// no such number.
    pub numbers: Vec<f64>,
}
