//! What is to be thought of the shape on the screen, in a word.

use crate::app::live::Live;
use crate::app::look::{Tokens, icons};
use crate::equilibrium::Status;
use eframe::egui::Color32;

/// What is to be thought of what is on the screen.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// The solver is at work on what was asked.
    Solving,
    /// A certified equilibrium of what was asked.
    Converged,
    /// The solver believes in it, its certificate does not.
    NotCertified,
    /// An equilibrium short of what was asked.
    BranchEnded,
    /// No shape avoids the obstacles.
    NoShape,
    /// The iterations are used up.
    IterationLimit,
    /// Rounding is in the way.
    Inaccurate,
}

impl Verdict {
    /// The verdict on what is live.
    pub fn of(live: &Live) -> Self {
        let Some(solution) = live.solution() else {
            return Verdict::Solving;
        };
        match solution.status {
            Status::Converged if live.is_settled() => Verdict::Converged,
            Status::Converged if live.is_waiting() => Verdict::Solving,
            Status::Converged => Verdict::NotCertified,
            Status::Unfinished => Verdict::Solving,
            Status::Infeasible { .. } => Verdict::NoShape,
            Status::BranchEnded { .. } => Verdict::BranchEnded,
            Status::IterationLimit => Verdict::IterationLimit,
            Status::NumericalFailure => Verdict::Inaccurate,
        }
    }

    /// The verdict in a word or two.
    pub fn word(self) -> &'static str {
        match self {
            Verdict::Solving => "Solving…",
            Verdict::Converged => "Converged",
            Verdict::NotCertified => "Not certified",
            Verdict::BranchEnded => "Branch ended",
            Verdict::NoShape => "No shape",
            Verdict::IterationLimit => "Iteration limit",
            Verdict::Inaccurate => "Inaccurate",
        }
    }

    /// Its icon.
    pub fn icon(self) -> &'static str {
        match self {
            Verdict::Solving => icons::GAUGE,
            Verdict::Converged => icons::CHECK_CIRCLE,
            Verdict::BranchEnded | Verdict::IterationLimit => icons::WARNING,
            Verdict::NotCertified | Verdict::NoShape | Verdict::Inaccurate => icons::WARNING_CIRCLE,
        }
    }

    /// Its colour.
    pub fn colour(self, tokens: &Tokens) -> Color32 {
        match self {
            Verdict::Solving => tokens.muted,
            Verdict::Converged => tokens.good,
            Verdict::BranchEnded | Verdict::IterationLimit => tokens.warning,
            Verdict::NotCertified | Verdict::NoShape | Verdict::Inaccurate => tokens.error,
        }
    }
}
