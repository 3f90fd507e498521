//! The paper's experiments as data: each figure and table recomputed, with the
//! paper's value beside ours, and measured shapes against computed ones.
//!
//! [`reproduce`] makes an [`Item`]: numbers compared ([`Check`]), what its
//! curves are made of ([`Data`]), shapes ([`Picture`]), what the text leaves
//! out. Nothing is drawn or printed here, and no value that the text does not
//! give is invented: where the photograph or the pull is missing, the item says
//! so.
//!
//! Items are for readers, so their numbers are in the units of reports:
//! millimetres, grams, degrees.

mod best_pull;
#[cfg(feature = "cli")]
pub mod calibration;
mod data;
mod item;
mod links;
mod load_cell;
mod measured;
#[cfg(any(feature = "app", feature = "cli"))]
pub mod measured_csv;
mod other_disks;
mod scenes;
mod shape_fit;
mod shapes;
mod sliding_cell;
mod table;
mod tip;
mod window;

pub use best_pull::{PullSearch, ShapeError, best_pull};
pub use data::{
    Backbone, CalibrationErrors, CellForces, Data, DiskForces, DiskModel, Forces, PostMultipliers,
    TipMotion,
};
pub use item::{Check, Id, Item, Picture, Verdict};
pub use measured::{Measured, MeasuredFault, MeasuredPoint};
pub use scenes::PaperScene;
pub use shape_fit::{ShapeFit, compare};
pub use table::{Errors, ForceRow, ForceTable, TableFault};
pub use window::{PullWindow, pull_window};

use crate::forces::{SweepError, VirtualWorkError};
use crate::scene::SceneError;

/// Why an item cannot be made. With the paper's own scenes none of this is
/// known to happen.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum ExperimentError {
    /// A scene of the paper cannot be solved for.
    #[error("the scene of this experiment is faulty: {0}")]
    Scene(#[from] SceneError),
    /// The robot does not get to a pull of the experiment.
    #[error(transparent)]
    Sweep(#[from] SweepError),
    /// A force cannot be estimated.
    #[error(transparent)]
    VirtualWork(#[from] VirtualWorkError),
    /// The table lacks the calibration point.
    #[error("the table of forces has no value at {load_g} g and {distance_mm} mm to calibrate on")]
    NoCalibration {
        /// The load looked for.
        load_g: f64,
        /// The distance looked for.
        distance_mm: f64,
    },
    /// The robot does not touch where it should.
    #[error("the robot of this experiment does not touch as expected: {0}")]
    NoContact(&'static str),
}

/// One figure or table of the paper, recomputed. The table holds the paper's
/// own numbers.
///
/// # Errors
/// If the robot cannot be solved for on the way, or the table lacks the
/// calibration point.
pub fn reproduce(id: Id, table: &ForceTable) -> Result<Item, ExperimentError> {
    match id {
        Id::Fig3b => shapes::figure_3b(),
        Id::Fig4a => shapes::figure_4a(),
        Id::Fig4b => shapes::figure_4b(),
        Id::Fig5 => shapes::figure_5(),
        Id::Fig7 => tip::figure_7(),
        Id::Fig9 => load_cell::figure_9(table),
        Id::Fig10a => load_cell::figure_10a(table),
        Id::Fig10b => other_disks::figure_10b(table),
        Id::Table1 => load_cell::table_1(table),
    }
}
