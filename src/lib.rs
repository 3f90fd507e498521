//! Live simulation of cable-driven continuum robots in contact.

#[cfg(feature = "cli")]
pub mod cli;
pub mod geometry;
pub mod math;
pub mod equilibrium;
pub mod model;
pub mod scene;
pub mod solver;
pub mod units;
