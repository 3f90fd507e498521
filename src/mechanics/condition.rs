//! The conditions that a certificate may hold a shape to, each with all that is
//! written or shown of it. What a mechanics finds of them is in
//! [`super::Certificate`].

use serde::{Deserialize, Serialize};

/// A condition of an equilibrium that a robot can rest in.
///
/// One new here has an entry in `Condition::entry`, and comes last: solver and
/// window tell each other conditions by their order.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Condition {
    /// Greatest unbalanced force on a node along its free direction, relative
    /// to the greatest force of a contact or of the free bend.
    Stationarity,
    /// Greatest error of a link's or disk's length, relative to the backbone's
    /// length.
    Links,
    /// Greatest depth of a candidate inside an obstacle, relative to the
    /// backbone's length.
    Penetration,
    /// Greatest |λ g|, relative to the greatest |λ| times the backbone's
    /// length. It counts as a gap too where a force does not act along a
    /// normal of its obstacle.
    Complementarity,
    /// Greatest negative multiplier, relative to the greatest |λ|.
    Dual,
    /// Whether every segment keeps the assembly of the straight robot.
    Orientation,
    /// Whether the reduced Hessian is positive definite, a strict minimum; or,
    /// without pull, whether the energy is zero, its least.
    Minimum,
    /// Greatest tension outside the cone of a hole where its cable sticks, or off its
    /// edge where it slips, relative to the greatest of the cable.
    Friction,
}

/// What the value of a condition is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ConditionKind {
    /// What is left of it, without unit, at least 0; NaN where that could not
    /// be computed. Up to [`Condition::BOUND`] it is met.
    Residual,
    /// 1 where it is met, and 0 where not.
    YesOrNo(Answers),
}

/// A condition that is met or not, in words for the middle of a sentence.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Answers {
    /// That it is met, such as `a minimum`.
    pub yes: &'static str,
    /// That it is not.
    pub no: &'static str,
    /// What is wrong with the shape then, as a sentence without its full stop.
    pub wrong: &'static str,
}

/// What is written and shown of a condition.
#[derive(Clone, Copy, Debug)]
struct Entry {
    key: &'static str,
    name: &'static str,
    symbols: &'static str,
    meaning: &'static str,
    kind: ConditionKind,
}

impl Condition {
    /// The bound that the residuals of a certified shape stay below. Newton's
    /// last step leaves about 1e-13; 1e-9 leaves room for n = 10⁴ segments.
    pub const BOUND: f64 = 1e-9;

    /// Its key in records.
    pub fn key(self) -> &'static str {
        self.entry().key
    }

    /// Its name for people.
    pub fn name(self) -> &'static str {
        self.entry().name
    }

    /// How the paper writes it; empty where it does not.
    pub fn symbols(self) -> &'static str {
        self.entry().symbols
    }

    /// What it means, in a sentence.
    pub fn meaning(self) -> &'static str {
        self.entry().meaning
    }

    /// What its value is.
    pub fn kind(self) -> ConditionKind {
        self.entry().kind
    }

    /// Whether it is met where this is its value. NaN meets nothing.
    pub fn is_met(self, value: f64) -> bool {
        match self.kind() {
            ConditionKind::Residual => value <= Self::BOUND,
            ConditionKind::YesOrNo(_) => value == 1.0,
        }
    }

    fn entry(self) -> Entry {
        let residual = |key, name, symbols, meaning| Entry {
            key,
            name,
            symbols,
            meaning,
            kind: ConditionKind::Residual,
        };
        match self {
            Self::Stationarity => residual(
                "stationarity",
                "Stationarity",
                "∂J = Σ λ ∂g + Σ μ ∂h",
                "No node is pushed along the way it is free to move.",
            ),
            Self::Links => residual(
                "links",
                "Links",
                "h = 0",
                "Every link and every disk keeps its length.",
            ),
            Self::Penetration => residual(
                "penetration",
                "Penetration",
                "g ≥ 0",
                "Nothing that may touch is inside an obstacle.",
            ),
            Self::Complementarity => residual(
                "complementarity",
                "Complementarity",
                "λ g = 0",
                "Only what touches can press.",
            ),
            Self::Dual => residual(
                "dual",
                "Dual feasibility",
                "λ ≥ 0",
                "Obstacles push and never pull.",
            ),
            Self::Friction => residual(
                "friction",
                "Friction",
                "e^{−μθ} ≤ T/T′ ≤ e^{μθ}",
                "Every cable sticks within friction's limits and slips at them, against its motion.",
            ),
            Self::Orientation => Entry {
                key: "orientation",
                name: "Orientation",
                symbols: "",
                meaning: "Every segment is assembled as in the straight robot.",
                kind: ConditionKind::YesOrNo(Answers {
                    yes: "no segment flipped",
                    no: "a segment flipped",
                    wrong: "a segment is assembled the wrong way round",
                }),
            },
            Self::Minimum => Entry {
                key: "minimum",
                name: "Minimum",
                symbols: "δ²L > 0",
                meaning: "Every small motion that is allowed costs energy: the robot can rest here.",
                kind: ConditionKind::YesOrNo(Answers {
                    yes: "a minimum",
                    no: "no minimum",
                    wrong: "the shape is balanced but not a minimum of the energy",
                }),
            },
        }
    }
}
