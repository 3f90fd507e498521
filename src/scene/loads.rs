//! What acts on the robot beside its cables and obstacles, as a scene file
//! gives it. No mechanics.

use serde::{Deserialize, Serialize};

/// Dead loads: they keep their direction in the scene's frame, however the
/// robot and its base are turned.
///
/// Each field's range is in [`super::limits`].
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct Loads {
    /// The force on the backbone's tip, [x, y], N.
    pub tip_force_n: [f64; 2],
    /// The moment on the last disk, clockwise, N mm.
    pub tip_moment_nmm: f64,
    /// The acceleration by gravity, [x, y], m/s², which acts on the masses of
    /// disks and backbone.
    pub gravity_m_s2: [f64; 2],
}

impl Loads {
    /// The standard acceleration of gravity, downward, [x, y], m/s².
    pub const EARTHS_GRAVITY_M_S2: [f64; 2] = [0.0, -9.80665];

    /// Whether nothing acts.
    pub fn is_none(&self) -> bool {
        *self == Loads::default()
    }
}
