//! What is written of a result: plain data in the units of files and reports,
//! with the names of its keys and columns and their versions. The only place
//! that says what they are called; the report on the paper's figures is not
//! among them, for it holds drawings' curves.
//!
//! A record is made of what was solved and holds no more than is written. Its
//! keys carry their unit (`pull_mm`) or their documentation does: lengths are
//! in millimetres, angles in radians, forces in newtons or, where people weigh
//! them, in grams. JSON and tables have every digit and no zero with a sign. It
//! writes no files.

#[cfg(feature = "cli")]
pub mod calibration;
pub mod force;
#[cfg(feature = "cli")]
pub mod json;
pub mod nodes;
pub mod path;

mod cables;
mod certificate;
pub mod cycle;
mod fit;
mod solution;
mod statics;
mod timing;

pub use cables::{Cable, Driven};
pub use certificate::Certificate;
pub use fit::{Fit, FitPoint};
pub use solution::{Caution, Contact, Event, Place, Side, Solution};
pub use statics::{Balance, Base};
pub use timing::{Sample, Timing};
