//! What a figure or table of the paper shows, as numbers: computed, the
//! paper's, measured. How they are drawn is not their business.

use crate::forces::{Rates, Sweep, Window};
use crate::geometry::Vector;
use crate::scene::Friction;

/// The numbers behind one drawing, or two that share them.
#[derive(Clone, Debug)]
pub enum Data {
    /// The backbone at several pulls.
    Backbones(Vec<Backbone>),
    /// Multipliers by node, of each post.
    Multipliers(Vec<PostMultipliers>),
    /// The tip along the pull.
    TipMotion(TipMotion),
    /// The force on the load cell against the load.
    CellForces(Vec<CellForces>),
    /// The force at several disks against the load.
    DiskForces(DiskModel, Vec<DiskForces>),
    /// How well each measured point would do as the one that fixes μ.
    CalibrationErrors(Vec<CalibrationErrors>),
}

/// A backbone at a pull.
#[derive(Clone, Debug)]
pub struct Backbone {
    /// The pull, in mm.
    pub pull_mm: f64,
    /// Its points, in metres, base first.
    pub points: Vec<Vector>,
}

/// What a post's contacts with the cable carry.
#[derive(Clone, Debug)]
pub struct PostMultipliers {
    /// The paper's name of its constraint, and which post it is.
    pub name: &'static str,
    /// The multipliers of the cable's nodes, rad²/m, from node 1 to the tip; 0
    /// where a node does not press.
    pub by_node: Vec<f64>,
}

/// A robot's tip along the pull, with the lines of eq. 7.
#[derive(Clone, Debug)]
pub struct TipMotion {
    /// The tip at every pull of the window; not empty.
    pub sweep: Sweep,
    /// The lines through it.
    pub rates: Rates,
    /// The pulls of the lines.
    pub window: Window,
}

/// Whose forces they are.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Forces {
    /// Eq. 11, computed here.
    Ours,
    /// The paper's theory column.
    Papers,
    /// Of a cable that slides without friction, computed here.
    Sliding {
        /// The cell's distance d from the straight backbone, in mm.
        distance_mm: f64,
    },
    /// Of a cable that slides with friction that was fitted to the readings.
    Rubbing {
        /// The cell's distance d from the straight backbone, in mm.
        distance_mm: f64,
    },
    /// The load cell's readings.
    Measured {
        /// The cell's distance d from the straight backbone, in mm.
        distance_mm: f64,
    },
}

impl Forces {
    /// Of a cable that slides with this friction, which was fitted where there is any.
    pub(super) fn of_sliding(friction: &Friction, distance_mm: f64) -> Self {
        if friction.is_none() {
            Self::Sliding { distance_mm }
        } else {
            Self::Rubbing { distance_mm }
        }
    }
}

/// By which model forces at other disks are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DiskModel {
    /// Eq. 11.
    VirtualWork,
    /// A cable that slides without friction.
    Frictionless,
    /// A cable that slides with friction, fitted at disk 3 from the top.
    Rubbing,
}

/// Forces on the load cell.
#[derive(Clone, Debug)]
pub struct CellForces {
    /// Whose.
    pub of: Forces,
    /// The load P_l, counted from contact, and the force F_x, both in grams.
    pub by_load_g: Vec<(f64, f64)>,
}

/// Forces of a contact at a disk.
#[derive(Clone, Debug)]
pub struct DiskForces {
    /// The disk, from 1 at the tip.
    pub from_top: usize,
    /// The load P_l, counted from contact, and the force F_x, both in grams.
    pub by_load_g: Vec<(f64, f64)>,
}

impl DiskForces {
    /// The disk in words.
    pub fn name(&self) -> String {
        format!("disk {} from the top", self.from_top)
    }
}

/// The errors of eq. 11 where the points measured at one distance fix μ.
#[derive(Clone, Debug)]
pub struct CalibrationErrors {
    /// The cell's distance d from the straight backbone, in mm.
    pub distance_mm: f64,
    /// The load of the point that fixes μ, and the mean |error| over the whole
    /// table, both in grams.
    pub by_load_g: Vec<(f64, f64)>,
}
