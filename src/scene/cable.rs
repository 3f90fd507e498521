//! Cables and what drives them, as a scene file gives them, and one way to read
//! and set them whichever of the two ways the file is written in. No mechanics.

use super::Scene;
use serde::{Deserialize, Serialize};

/// What drives the one cable at `robot.cable_offset_mm`.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Actuation {
    /// By how much, and in which way.
    #[serde(flatten)]
    pub drive: Drive,
}

/// What a cable is driven by: in a file the one of two keys that is there.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Drive {
    /// Length of cable drawn in at the base, mm; negative lets cable out. In
    /// the range [`super::limits::PULL`], which is generous: how far a robot
    /// lets its cable go is known to the model.
    PullMm(f64),
    /// The weight that hangs on the cable below the base, g, in the range
    /// [`super::limits::LOAD`].
    LoadG(f64),
}

impl Drive {
    /// The key that the drive is written under.
    pub fn key(self) -> &'static str {
        match self {
            Drive::PullMm(_) => "pull_mm",
            Drive::LoadG(_) => "load_g",
        }
    }

    /// Length of cable drawn in, mm; `None` where a load drives the cable.
    pub fn pull_mm(self) -> Option<f64> {
        match self {
            Drive::PullMm(pull_mm) => Some(pull_mm),
            Drive::LoadG(_) => None,
        }
    }
}

/// One cable.
///
/// Each field's range is in [`super::limits`].
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Cable {
    /// Distance from the backbone, mm; negative on the −x side of the straight
    /// robot, never 0.
    pub offset_mm: f64,
    /// What drives it.
    #[serde(flatten)]
    pub drive: Drive,
    /// The disk that it ends at, from 1, the base's being 0; absent means the
    /// last.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub to_disk: Option<u32>,
    /// Its stiffness against stretching EA, N; absent means that it does not
    /// stretch.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub axial_stiffness_n: Option<f64>,
    /// Its diameter, mm.
    #[serde(default)]
    pub diameter_mm: f64,
}

impl Scene {
    /// How many cables the robot has. A scene without faults has at least one.
    pub fn cable_count(&self) -> usize {
        match (&self.robot.cable_offset_mm, &self.actuation) {
            (Some(_), Some(_)) if self.cables.is_empty() => 1,
            _ => self.cables.len(),
        }
    }

    /// A cable, counted from 0, whichever way the scene describes it.
    ///
    /// # Panics
    /// When `k` is not below [`Scene::cable_count`].
    pub fn cable(&self, k: usize) -> Cable {
        match (self.robot.cable_offset_mm, self.actuation) {
            (Some(offset_mm), Some(actuation)) if self.cables.is_empty() && k == 0 => Cable {
                offset_mm,
                drive: actuation.drive,
                to_disk: None,
                axial_stiffness_n: None,
                diameter_mm: self.robot.cable_diameter_mm,
            },
            _ => self.cables[k],
        }
    }

    /// Every cable in the order of the file.
    pub fn each_cable(&self) -> impl Iterator<Item = Cable> + '_ {
        (0..self.cable_count()).map(|k| self.cable(k))
    }

    /// What a key of a cable is called in messages: `cable[1].offset_mm`, or
    /// for the one cable that is described with the robot
    /// `robot.cable_offset_mm`, `robot.cable_diameter_mm`, `actuation.pull_mm`
    /// and `actuation.load_g`.
    pub fn cable_field(&self, k: usize, key: &str) -> String {
        if !self.cables.is_empty() {
            return format!("cable[{k}].{key}");
        }
        match key {
            "pull_mm" | "load_g" => format!("actuation.{key}"),
            _ => format!("robot.cable_{key}"),
        }
    }

    /// Sets what drives a cable.
    ///
    /// # Panics
    /// When `k` is not below [`Scene::cable_count`].
    pub fn set_drive(&mut self, k: usize, drive: Drive) {
        match &mut self.actuation {
            Some(actuation) if self.cables.is_empty() && k == 0 => actuation.drive = drive,
            _ => self.cables[k].drive = drive,
        }
    }

    /// Takes over what drives each cable from another scene, as far as both
    /// have cables.
    pub fn take_drives(&mut self, other: &Scene) {
        for k in 0..self.cable_count().min(other.cable_count()) {
            self.set_drive(k, other.cable(k).drive);
        }
    }

    /// Distance between backbone and first cable, mm (the paper's a), negative
    /// on the −x side; 0 where there is no cable.
    pub fn offset_mm(&self) -> f64 {
        self.each_cable()
            .next()
            .map_or(0.0, |first| first.offset_mm)
    }

    /// Sets the distance between backbone and first cable, mm; does nothing
    /// where there is no cable.
    pub fn set_offset_mm(&mut self, offset_mm: f64) {
        if let Some(first) = self.cables.first_mut() {
            first.offset_mm = offset_mm;
        } else if self.cable_count() == 1 {
            self.robot.cable_offset_mm = Some(offset_mm);
        }
    }

    /// Sets the diameter of the first cable, mm; does nothing where there is
    /// no cable.
    pub fn set_cable_diameter_mm(&mut self, diameter_mm: f64) {
        if let Some(first) = self.cables.first_mut() {
            first.diameter_mm = diameter_mm;
        } else if self.cable_count() == 1 {
            self.robot.cable_diameter_mm = diameter_mm;
        }
    }

    /// Length of the first cable that is drawn in, mm (the paper's l); 0 where
    /// a load drives it or there is no cable.
    pub fn pull_mm(&self) -> f64 {
        let first = self.each_cable().next();
        first
            .and_then(|cable| cable.drive.pull_mm())
            .unwrap_or_default()
    }

    /// Draws in so much of the first cable, mm, in the place of what drove it;
    /// does nothing where there is no cable.
    pub fn set_pull_mm(&mut self, pull_mm: f64) {
        if self.cable_count() > 0 {
            self.set_drive(0, Drive::PullMm(pull_mm));
        }
    }

    /// Radius of the disks' rim, mm: the one given, or else the largest
    /// distance of a cable from the backbone.
    pub fn rim_mm(&self) -> f64 {
        self.robot.disk_radius_mm.unwrap_or_else(|| {
            let widest = self.widest_cable();
            widest.map_or(0.0, |(_, distance_mm)| distance_mm)
        })
    }

    /// The first of the cables farthest from the backbone, with its distance,
    /// mm.
    pub(super) fn widest_cable(&self) -> Option<(usize, f64)> {
        let distances = self.each_cable().map(|cable| cable.offset_mm.abs());
        distances
            .enumerate()
            .reduce(|widest, next| if next.1 > widest.1 { next } else { widest })
    }

    /// The number of the last disk, the base's being 0; 0 where the robot has
    /// no other.
    pub fn last_disk(&self) -> u32 {
        let robot = &self.robot;
        robot
            .segments
            .checked_div(robot.segments_per_bay)
            .unwrap_or_default()
    }
}
