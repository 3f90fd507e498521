//! The window: canvas, panels and plots around a solver that never makes them
//! wait. The only layer that knows egui.

pub mod examples;
pub mod link;
