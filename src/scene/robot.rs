//! The robot as a scene file gives it. No mechanics.

use serde::{Deserialize, Serialize};

/// A backbone with disks, and perhaps the one cable beside it.
///
/// The straight robot points along +y from its base and such a cable lies at
/// +x; `base_angle_deg` then turns it. Each field's range is in [`super::limits`].
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
    /// Distance between the backbone and the one cable, mm (the paper's a);
    /// absent where [`super::Scene::cables`] describes the cables.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub cable_offset_mm: Option<f64>,
    /// Radius of the disks' rim, mm; absent means the largest distance of a
    /// cable from the backbone, and it may not be less. Only contact with the
    /// robot's body and with listed rims looks at it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub disk_radius_mm: Option<f64>,
    /// Thickness of a disk along the backbone, mm.
    #[serde(default)]
    pub disk_thickness_mm: f64,
    /// Diameter of the backbone, mm.
    #[serde(default)]
    pub backbone_diameter_mm: f64,
    /// Diameter of the cable at `cable_offset_mm`, mm.
    #[serde(default, skip_serializing_if = "is_zero")]
    pub cable_diameter_mm: f64,
    /// The backbone's bending stiffness EI, N mm², which turns multipliers into
    /// forces; absent where it is not known. The shape depends on it only under
    /// loads.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub bending_stiffness_nmm2: Option<f64>,
    /// Mass of each disk but the base's, g.
    #[serde(default, skip_serializing_if = "is_zero")]
    pub disk_mass_g: f64,
    /// Mass of the backbone, spread evenly along it, g.
    #[serde(default, skip_serializing_if = "is_zero")]
    pub backbone_mass_g: f64,
    /// Where the backbone starts, [x, y], mm.
    #[serde(default)]
    pub base_mm: [f64; 2],
    /// Turn of the whole robot about its base, counterclockwise from +y, deg.
    #[serde(default)]
    pub base_angle_deg: f64,
}

/// The paper's robot as its solver sees it: 180 mm in 18 segments, the cable
/// 8 mm beside the backbone, everything without thickness.
impl Default for Robot {
    fn default() -> Self {
        Robot {
            length_mm: 180.0,
            segments: 18,
            segments_per_bay: paper_segments_per_bay(),
            cable_offset_mm: Some(8.0),
            disk_radius_mm: None,
            disk_thickness_mm: 0.0,
            backbone_diameter_mm: 0.0,
            cable_diameter_mm: 0.0,
            bending_stiffness_nmm2: None,
            disk_mass_g: 0.0,
            backbone_mass_g: 0.0,
            base_mm: [0.0, 0.0],
            base_angle_deg: 0.0,
        }
    }
}

fn paper_segments_per_bay() -> u32 {
    2
}

fn is_zero(value: &f64) -> bool {
    *value == 0.0
}
