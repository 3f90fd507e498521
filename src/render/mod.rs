//! Pictures by the graphics processor, in single precision: the clearance field
//! and the robot in space. One Rust file for each shader in `shaders/`.

mod cells;
mod field;
mod gpu;
mod slots;

pub use field::{FieldOutput, FieldPass, FieldPicture, contour_spacing};
