//! Live simulation of cable-driven continuum robots in contact.

pub mod equilibrium;
pub mod geometry;
pub mod math;
pub mod model;
pub mod scene;
pub mod solver;
pub mod units;
