//! What happened along a run, in order: contacts, jumps, ends.

use super::status::EndReason;
use crate::geometry::Vector;
use crate::robot::Line;
use serde::{Deserialize, Serialize};

/// Something that happened on the way.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Event {
    /// The pull at which it happened, in metres. A contact is interpolated
    /// within its step, to about a hundredth of a millimetre for the paper's
    /// robot, where the two shapes before it tell its trend; otherwise it is
    /// the end of its step. Jumps and ends are met with steps of 1e-5 of the
    /// robot's length.
    pub pull: f64,
    /// The share of the way from what drove the robot at the run's start, nothing where
    /// it was straight, to the goal's: 0 while obstacles over the straight robot grow.
    pub share: f64,
    /// The load on the first cable, in newtons, where that and not its pull is given;
    /// the pull is then 0.
    pub load: Option<f64>,
    /// What.
    pub what: Occurrence,
}

/// What may happen on the way.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub enum Occurrence {
    /// An obstacle over the robot was grown from nothing and pushed it aside.
    PushedAside {
        /// The obstacle's index.
        obstacle: usize,
        /// Unit direction the robot is pushed in.
        direction: Vector,
    },
    /// A part of the robot began to press on an obstacle.
    ContactMade {
        /// The line of the robot.
        line: Line,
        /// The node, from 1.
        node: usize,
        /// The obstacle's index.
        obstacle: usize,
    },
    /// A part of the robot stopped pressing on an obstacle.
    ContactLost {
        /// The line of the robot.
        line: Line,
        /// The node, from 1.
        node: usize,
        /// The obstacle's index.
        obstacle: usize,
    },
    /// The branch ended and the robot went over to another equilibrium.
    Jump {
        /// The node that moved farthest, from 1.
        node: usize,
        /// How far it moved, in metres.
        distance: f64,
    },
    /// The branch ended and no other equilibrium was reached.
    BranchEnded {
        /// Why.
        reason: EndReason,
        /// The segment, from 1, that was most strained there.
        segment: usize,
    },
    /// The earlier shape that was to start from is no equilibrium of its own
    /// problem; the run started from the straight robot instead.
    StartRefused,
    /// Friction could no longer hold the robot on its obstacles and was let go: one that
    /// slips shakes itself free, which no statics follows. It rests, and rubs again from
    /// there.
    FrictionGaveWay,
}

impl Occurrence {
    /// The occurrence in one word, as in JSON output.
    pub fn word(&self) -> &'static str {
        match self {
            Occurrence::PushedAside { .. } => "pushed_aside",
            Occurrence::ContactMade { .. } => "contact_made",
            Occurrence::ContactLost { .. } => "contact_lost",
            Occurrence::Jump { .. } => "jump",
            Occurrence::FrictionGaveWay => "friction_gave_way",
            Occurrence::BranchEnded { .. } => "branch_ended",
            Occurrence::StartRefused => "start_refused",
        }
    }
}
