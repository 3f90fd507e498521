//! What is to be thought of the shape on the screen, in a word.

use crate::app::look::{Tokens, icons};
use crate::app::workbench::Live;
use crate::equilibrium::Status;
use crate::view::outcome;
use eframe::egui::Color32;

/// What is to be thought of what is on the screen.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// The solver is at work on what was asked.
    Solving,
    /// A certified equilibrium of what was asked.
    Converged,
    /// An equilibrium short of what was asked, and what became of the solve.
    Short(&'static str),
    /// No equilibrium, and what became of the solve.
    Refused(&'static str),
}

impl Verdict {
    /// The verdict on what is live.
    pub fn of(live: &Live) -> Self {
        let Some(solution) = live.solution() else {
            return Verdict::Solving;
        };
        let word = outcome(solution);
        match solution.status {
            Status::Converged if live.is_settled() => Verdict::Converged,
            Status::Converged if live.is_waiting() => Verdict::Solving,
            Status::Unfinished => Verdict::Solving,
            Status::BranchEnded { .. } | Status::IterationLimit => Verdict::Short(word),
            Status::Converged | Status::Infeasible { .. } | Status::NumericalFailure => {
                Verdict::Refused(word)
            }
        }
    }

    /// The verdict in a word or two, those of every picture.
    pub fn word(self) -> &'static str {
        match self {
            Verdict::Solving => "Solving…",
            Verdict::Converged => "Converged",
            Verdict::Short(word) | Verdict::Refused(word) => word,
        }
    }

    /// Its icon.
    pub fn icon(self) -> &'static str {
        match self {
            Verdict::Solving => icons::GAUGE,
            Verdict::Converged => icons::CHECK_CIRCLE,
            Verdict::Short(_) => icons::WARNING,
            Verdict::Refused(_) => icons::WARNING_CIRCLE,
        }
    }

    /// Its colour.
    pub fn colour(self, tokens: &Tokens) -> Color32 {
        match self {
            Verdict::Solving => tokens.muted,
            Verdict::Converged => tokens.good,
            Verdict::Short(_) => tokens.warning,
            Verdict::Refused(_) => tokens.error,
        }
    }
}
