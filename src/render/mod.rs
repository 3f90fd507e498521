//! Pictures by the graphics processor, in single precision: the clearance field
//! and the robot in space. One Rust file for each shader in `shaders/`.
