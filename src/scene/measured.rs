//! What was measured on a robot, and a photograph of it, as a scene file keeps
//! them. Nothing is compared with anything here.

use serde::{Deserialize, Serialize};

/// Measurements of the robot that the scene describes.
///
/// Each field's range is in [`super::limits`].
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct Measurements {
    /// A measured backbone in the scene's frame, [x, y] each, mm, base to tip;
    /// none, or 2 to [`super::limits::MEASURED_POINTS`] of them.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub points_mm: Vec<[f64; 2]>,
    /// The node that each of the points is, in ascending order from 0 at the
    /// base; empty where that is not known.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub nodes: Vec<u32>,
    /// The index of the reading in `forces` that fixes μ, from 0.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub calibration: Option<u32>,
    /// Readings of the contact force; at most [`super::limits::READINGS`].
    #[serde(rename = "force", skip_serializing_if = "Vec::is_empty")]
    pub forces: Vec<ForceReading>,
}

impl Measurements {
    /// The reading that fixes μ, where one is chosen and there.
    pub fn calibrating(&self) -> Option<&ForceReading> {
        self.forces.get(usize::try_from(self.calibration?).ok()?)
    }
}

/// A contact force read under a load.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct ForceReading {
    /// The weight on the cable, counted from the moment of contact, g.
    pub load_g: f64,
    /// The force on the obstacle, as a weight, g. Noise can make it negative.
    pub force_g: f64,
}

/// A photograph that lies behind the robot.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Photo {
    /// The picture's file, from the folder of the scene file.
    pub file: String,
    /// Where the picture's centre lies, [x, y], mm.
    pub center_mm: [f64; 2],
    /// The picture's width in the scene, before its turn, mm.
    pub width_mm: f64,
    /// Its turn about its centre, counterclockwise, deg.
    #[serde(default)]
    pub rotation_deg: f64,
    /// How much of it shows: 0 is nothing, 1 hides what is behind it.
    #[serde(default = "opaque")]
    pub opacity: f64,
}

/// An opacity that hides nothing of the photograph.
fn opaque() -> f64 {
    1.0
}
