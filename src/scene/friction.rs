//! Friction as a scene file gives it. No mechanics.

use serde::{Deserialize, Serialize};

/// Where the robot rubs, and how much. Nothing rubs where nothing is given.
///
/// Each field's range is in [`super::limits`].
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct Friction {
    /// The coefficient of friction of a cable in every hole of a disk (μ).
    pub holes: f64,
    /// The coefficient of friction of the robot on an obstacle (μ_w).
    pub contacts: f64,
    /// The share of a cable's load that is lost below the base, from 0 to
    /// below 1 (1 − η).
    pub base_loss: f64,
}

impl Friction {
    /// Whether nothing rubs anywhere.
    pub fn is_none(&self) -> bool {
        *self == Friction::default()
    }
}
