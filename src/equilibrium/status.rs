//! How a run ended. Data, never an error: every run ends in one of these.

use crate::robot::Line;
use serde::{Deserialize, Serialize};

/// The outcome of a run.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum Status {
    /// The goal is reached and its shape is a certified equilibrium.
    Converged,
    /// The run is not over, or was given up by its owner.
    Unfinished,
    /// No shape of the robot near the last good one avoids the obstacles.
    Infeasible {
        /// The contacts that cannot all be met.
        conflicts: Vec<Conflict>,
    },
    /// The branch of equilibria does not lead to the goal. The solution is the
    /// last equilibrium on it.
    BranchEnded {
        /// Why it ends.
        reason: EndReason,
        /// The segment, from 1, that was most strained there.
        segment: usize,
    },
    /// The allowed iterations are used up.
    IterationLimit,
    /// Rounding keeps the solve from its tolerances.
    NumericalFailure,
}

/// Why a branch of equilibria ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum EndReason {
    /// A segment's linkage is at the limit of its assembly and locks.
    LinkageLimit,
    /// The equilibrium stops being a minimum and no other is reached from it:
    /// the robot slips away.
    Fold,
    /// Every way on leads through an obstacle.
    Blocked,
    /// The disks at the inner side of a bend touch each other, or a segment of a robot
    /// with sliding cables bends by a quarter turn.
    DisksTouch,
    /// No friction in holes and at contacts was found that holds the robot still.
    FrictionUnsettled,
    /// Cables that do not stretch are drawn in against each other.
    CablesOppose,
}

impl EndReason {
    /// The reason in one word, as in JSON output.
    pub fn word(self) -> &'static str {
        match self {
            EndReason::LinkageLimit => "linkage_limit",
            EndReason::Fold => "fold",
            EndReason::Blocked => "blocked",
            EndReason::DisksTouch => "disks_touch",
            EndReason::FrictionUnsettled => "friction_unsettled",
            EndReason::CablesOppose => "cables_oppose",
        }
    }
}

/// A contact that takes part in a conflict.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Conflict {
    /// The line of the robot.
    pub line: Line,
    /// The node, from 1.
    pub node: usize,
    /// The obstacle's index.
    pub obstacle: usize,
}

impl Status {
    /// The status in one word, as in JSON output.
    pub fn word(&self) -> &'static str {
        match self {
            Status::Converged => "converged",
            Status::Unfinished => "unfinished",
            Status::Infeasible { .. } => "infeasible",
            Status::BranchEnded { .. } => "branch_ended",
            Status::IterationLimit => "iteration_limit",
            Status::NumericalFailure => "numerical_failure",
        }
    }

    /// One sentence on what happened. Names nodes and obstacles by index.
    pub fn reason(&self) -> String {
        match self {
            Status::Converged => "the shape is a certified equilibrium".to_owned(),
            Status::Unfinished => "the solve was stopped before its end".to_owned(),
            Status::Infeasible { conflicts } => {
                let list: Vec<String> = conflicts
                    .iter()
                    .map(|c| {
                        format!(
                            "{} node {} on obstacle {}",
                            c.line.name(),
                            c.node,
                            c.obstacle
                        )
                    })
                    .collect();
                if list.is_empty() {
                    "what the robot's own parts allow conflicts with what drives it".to_owned()
                } else {
                    format!(
                        "no shape near the last good one keeps clear of the obstacles; in \
                         conflict: {}",
                        list.join(", ")
                    )
                }
            }
            Status::BranchEnded { reason, segment } => {
                let why = match reason {
                    EndReason::LinkageLimit => "its linkage is at the limit of its assembly",
                    EndReason::Fold => "the equilibrium folds back and the robot slips away",
                    EndReason::Blocked => "every way on leads through an obstacle",
                    EndReason::DisksTouch => "its disks touch on the inner side of the bend",
                    EndReason::CablesOppose => {
                        "its cables are drawn in against each other and do not stretch"
                    }
                    EndReason::FrictionUnsettled => {
                        "no friction was found that holds the robot still"
                    }
                };
                format!("the branch ends at segment {segment}: {why}")
            }
            Status::IterationLimit => {
                "the allowed iterations were used up before the goal was reached".to_owned()
            }
            Status::NumericalFailure => {
                "rounding keeps the solve from its tolerances at this size".to_owned()
            }
        }
    }
}
