//! The obstacles' shapes as a hand sets, holds and changes them. In millimetres
//! of the scene; knows no screen but the size of its points.

mod handles;
mod place;
mod tool;

pub use handles::{
    Handle, Turned, add_vertex, convex, drag, edge_near, handles, moved, neat, remove_vertex,
    vertices, written,
};
pub use place::{clicked, copied, dragged};
pub use tool::Tool;
