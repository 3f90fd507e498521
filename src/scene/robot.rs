//! The robot and its actuation as a scene file gives them. No mechanics.

use serde::{Deserialize, Serialize};

/// A backbone with disks and one cable beside it.
///
/// The straight robot points along +y from its base and its cable lies at +x;
/// `base_angle_deg` then turns it. Each field's range is in [`super::limits`].
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Robot {
    /// Length of the backbone, mm.
    pub length_mm: f64,
    /// Number of segments the backbone is divided into.
    pub segments: u32,
    /// Segments between neighbouring disks: with 2, disks sit on the nodes
    /// 0, 2, 4 and so on. Must divide `segments`.
    #[serde(default = "paper_segments_per_bay")]
    pub segments_per_bay: u32,
    /// Distance between backbone and cable, mm (the paper's a).
    pub cable_offset_mm: f64,
    /// Radius of the disks' rim, mm; absent means the cable offset, and it
    /// may not be less. Only contact with the robot's body looks at it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub disk_radius_mm: Option<f64>,
    /// Thickness of a disk along the backbone, mm.
    #[serde(default)]
    pub disk_thickness_mm: f64,
    /// Diameter of the backbone, mm.
    #[serde(default)]
    pub backbone_diameter_mm: f64,
    /// Diameter of the cable, mm.
    #[serde(default)]
    pub cable_diameter_mm: f64,
    /// The backbone's bending stiffness EI, N mm², which turns multipliers into
    /// forces; absent where it is not known. The shape does not depend on it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub bending_stiffness_nmm2: Option<f64>,
    /// Where the backbone starts, [x, y], mm.
    #[serde(default)]
    pub base_mm: [f64; 2],
    /// Turn of the whole robot about its base, counterclockwise from +y, deg.
    #[serde(default)]
    pub base_angle_deg: f64,
}

impl Robot {
    /// Radius of the disks' rim, mm: the one given, or else the cable offset.
    pub fn rim_mm(&self) -> f64 {
        self.disk_radius_mm.unwrap_or(self.cable_offset_mm)
    }
}

/// The paper's robot as its solver sees it: 180 mm in 18 segments, the cable
/// 8 mm beside the backbone, everything without thickness.
impl Default for Robot {
    fn default() -> Self {
        Robot {
            length_mm: 180.0,
            segments: 18,
            segments_per_bay: paper_segments_per_bay(),
            cable_offset_mm: 8.0,
            disk_radius_mm: None,
            disk_thickness_mm: 0.0,
            backbone_diameter_mm: 0.0,
            cable_diameter_mm: 0.0,
            bending_stiffness_nmm2: None,
            base_mm: [0.0, 0.0],
            base_angle_deg: 0.0,
        }
    }
}

fn paper_segments_per_bay() -> u32 {
    2
}

/// What drives the robot.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Actuation {
    /// Length of cable drawn in at the base, mm; negative lets cable out.
    ///
    /// Only a generous bound is checked here: how far the segments' linkages
    /// let the cable go is known to the model.
    pub pull_mm: f64,
}
