//! What is certified of a shape, whatever mechanics it belongs to and whoever
//! recomputed it.

use crate::math::greatest;
use serde::{Deserialize, Serialize};

/// How well a shape satisfies the optimality conditions of eq. 5.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Certificate {
    /// Greatest unbalanced force on a node along its free direction, relative
    /// to the greatest force of a contact or of the free bend.
    pub stationarity: f64,
    /// Greatest error of a link's or disk's length, relative to the backbone's
    /// length.
    pub links: f64,
    /// Greatest depth of a candidate inside an obstacle, relative to the
    /// backbone's length.
    pub penetration: f64,
    /// Greatest |λ g|, relative to the greatest |λ| times the backbone's
    /// length. It counts as a gap too where a force does not act along a
    /// normal of its obstacle.
    pub complementarity: f64,
    /// Greatest negative multiplier, relative to the greatest |λ|.
    pub dual: f64,
    /// Whether every segment keeps the assembly of the straight robot.
    pub orientation: bool,
    /// Whether the reduced Hessian is positive definite, a strict minimum; or,
    /// without pull, whether the energy is zero, its least.
    pub minimum: bool,
    /// dJ*/dl, in rad²/m, from the cable links' multipliers: how the least
    /// energy changes with the pull (envelope theorem).
    pub energy_slope: f64,
}

impl Certificate {
    /// The bound that the residuals of a certified shape stay below. Newton's
    /// last step leaves about 1e-13; 1e-9 leaves room for n = 10⁴ segments.
    pub const BOUND: f64 = 1e-9;

    /// The greatest of the residuals; NaN where one is.
    pub fn residual(&self) -> f64 {
        [
            self.links,
            self.penetration,
            self.complementarity,
            self.dual,
        ]
        .into_iter()
        .fold(self.stationarity, greatest)
    }

    /// Whether the shape is an equilibrium that a robot can rest in.
    pub fn holds(&self) -> bool {
        self.residual() <= Self::BOUND && self.orientation && self.minimum
    }
}
