//! How thick the robot's parts are: the one source for contacts and pictures.
//! The mechanics do not depend on it, but through what may touch.

use crate::scene::Scene;
use crate::units::metres;
use serde::{Deserialize, Serialize};

/// Sizes of a robot's parts, in metres; zero where a scene does not give them.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Sizes {
    /// Radius of the disks' rim, at least the cable offset.
    pub rim: f64,
    /// Thickness of a disk along the backbone.
    pub disk: f64,
    /// Diameter of the backbone.
    pub backbone: f64,
    /// Diameter of the cable.
    pub cable: f64,
}

impl Sizes {
    /// The sizes of a scene's robot, whose fields are in their ranges.
    pub fn of(scene: &Scene) -> Self {
        let described = &scene.robot;
        let cable_mm = scene
            .each_cable()
            .next()
            .map_or(0.0, |first| first.diameter_mm);
        Self {
            rim: metres(scene.rim_mm()),
            disk: metres(described.disk_thickness_mm),
            backbone: metres(described.backbone_diameter_mm),
            cable: metres(cable_mm),
        }
    }
}
