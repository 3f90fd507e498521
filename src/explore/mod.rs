//! Many equilibria of one robot at once: what it does along its whole pull.
//!
//! A [`PathRun`] follows the robot from its straight shape over a list of
//! pulls, in slices, so that a solver in the background can answer a live
//! request in between. What it leaves is a [`Path`]: the tip, the energy and
//! what presses at every pull, what happened on the way, and where it ended.
//! A path depends on the robot and its obstacles only; whatever is asked of it
//! (the pull that brings the tip nearest to a point, the forces under a load)
//! is a function of its states and solves nothing.
//!
//! A [`Cycle`] goes along a course of waypoints, there and back, and tells what work
//! that took.

mod cycle;
mod load_curve;
mod path;
mod path_run;
mod slope;
mod tip;

pub use cycle::{Course, Cycle, Given, Visit, Work};
pub use load_curve::{LoadCurve, LoadPoint};
pub use path::{End, Path, PathState, Pressing};
pub use path_run::PathRun;
pub use slope::usual_end;
