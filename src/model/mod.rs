//! The robot, what it may touch and what bends it, under one name.

pub use crate::contact::*;
pub use crate::mechanics::*;
pub use crate::robot::*;
