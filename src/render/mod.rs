//! Pictures by the graphics processor, in single precision: the clearance field
//! and the robot in space. One Rust file for each shader in `shaders/`.
//!
//! Stays within what a browser without WebGPU can do: no compute, no storage
//! buffers, data in uniforms and textures. What is drawn is plain data first
//! ([`FieldPicture`], [`Mesh`]); the passes send it and draw it; the callbacks
//! bring them into the window.

mod blit;
mod callbacks;
mod camera;
mod cells;
mod field;
mod gpu;
mod mesh;
mod outline;
mod plate;
mod robot;
mod slots;
mod solid;
mod targets;

pub use callbacks::{field_callback, install, solid_callback};
pub use camera::Camera;
pub use field::{FieldOutput, FieldPass, FieldPicture, contour_spacing};
pub use mesh::{Bounds3, Mesh, Triangles, Vertex};
pub use robot::mesh;
pub use solid::{SolidPass, SolidPicture};
