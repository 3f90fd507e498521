//! What friction keeps from one shape to the next: of a cable its tensions, which way
//! it slips through every hole, and how much of it was beyond each; of a contact how it
//! is held back.

use crate::solver::RowId;
use serde::{Deserialize, Serialize};

/// How a cable goes through a hole during a step.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub enum Slip {
    /// Towards the base.
    #[default]
    In,
    /// Towards the tip.
    Out,
    /// Not at all.
    Sticks,
}

impl Slip {
    /// The word for it in records.
    pub fn word(self) -> &'static str {
        match self {
            Slip::In => "in",
            Slip::Out => "out",
            Slip::Sticks => "sticks",
        }
    }

    /// The word for it of a contact, whose robot slides forward along the tangent or back.
    pub fn word_at_contact(self) -> &'static str {
        match self {
            Slip::In => "forward",
            Slip::Out => "back",
            Slip::Sticks => "sticks",
        }
    }

    /// The slip of a hole beyond which the length drawn in has grown by this much, in
    /// metres.
    pub fn of(drawn: f64) -> Self {
        if drawn > Self::UNMOVED {
            Slip::In
        } else if drawn < -Self::UNMOVED {
            Slip::Out
        } else {
            Slip::Sticks
        }
    }

    /// A hole through which less cable than this passes in a step, in metres, sticks.
    pub const UNMOVED: f64 = 1e-10;
}

/// A cable in its holes. Hole k is in disk k, the base's being 0; stretch k, from 1,
/// leads from hole k − 1 to the next.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Strand {
    /// The tension of each stretch, base first, in rad²/m.
    pub tensions: Vec<f64>,
    /// How the cable went through each hole in the last step, base first.
    pub slips: Vec<Slip>,
    /// How much shorter the cable beyond each hole was before that step than along the
    /// straight robot, without its stretch, in metres.
    pub before: Vec<f64>,
    /// What hangs on it below the base, or would hold it as it is, in rad²/m.
    pub load: f64,
}

/// How an obstacle holds back a part of the robot that presses on it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Drag {
    /// The contact's row.
    pub row: RowId,
    /// The obstacle's tangential force on the robot, in rad²/m: along the contact's
    /// normal turned 90° clockwise.
    pub force: f64,
    /// How far the robot's material slid along that in the last step, in metres, past
    /// the obstacle.
    pub slid: f64,
}

/// All that friction keeps of a shape.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Rubbing {
    /// By cable; none where nothing rubs.
    pub strands: Vec<Strand>,
    /// By row, in the order of their ids: those that press.
    pub drags: Vec<Drag>,
}

/// How a tension changes at a hole where the cable slips, as T beyond over T below:
/// `lost` = 1 − η of it is lost besides the capstan's share.
///
/// ```text
/// in   η exp(−μ|θ|)        out   exp(μ|θ|)/η
/// ```
pub fn slipping_ratio(slip: Slip, holes: f64, angle: f64, lost: f64) -> f64 {
    let inwards = (1.0 - lost) * libm::exp(-holes * angle.abs());
    match slip {
        Slip::In => inwards,
        Slip::Out => 1.0 / inwards,
        Slip::Sticks => 1.0,
    }
}
