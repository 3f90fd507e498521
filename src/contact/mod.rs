//! Contact: the clearance of every part of the robot from every obstacle as a
//! row of eq. 5 with exact derivatives, and motions that lead through. What
//! bends the robot it does not know: only where its nodes are.

mod clearances;
mod disk_point;
mod from_scene;
mod kinematics;
mod motion;
mod rows;
mod surroundings;
mod touch;

pub use clearances::{Clearance, Place};
pub use from_scene::{covers_base, obstacle};
pub use kinematics::{Inside, Kinematics};
pub use rows::RowKind;
pub use surroundings::Surroundings;
pub use touch::{Class, Contact, Multipliers};
