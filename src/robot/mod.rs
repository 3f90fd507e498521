//! The planar robot itself: its dimensions, its parts, what they are called, and
//! a pose of one of its nodes. It knows neither what bends it nor what is around
//! it.

mod cable;
mod candidate;
mod dimensions;
mod from_scene;
mod names;
mod node;
mod sizes;
mod strung;

pub use cable::Cable;
pub use candidate::{Candidate, Element, Joins, Line};
pub use dimensions::Robot;
pub use names::{disk_name, part_name};
pub use node::{Nodes, PlanarNode};
pub use sizes::Sizes;
