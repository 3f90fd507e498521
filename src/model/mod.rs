//! The planar robot of eq. 4 and 5 as a chain for the solver.
//!
//! [`Problem::new`] parses a scene once into something that cannot be wrong;
//! what it gives implements [`crate::solver::Chain`] with the state (x, y, φ)
//! and one control τ a segment. SI units throughout; the solver's cost is
//! Σ (β/β*)², see [`FourBar`].

mod candidate;
mod four_bar;
mod free_arc;
mod from_scene;
mod names;
mod node;
mod problem;
mod robot;
mod rows;
mod sizes;

pub use candidate::{Candidate, Element, Joins, Line};
pub use four_bar::{FourBar, MOST_BEND, MOST_TURN};
pub use free_arc::FreeArc;
pub use names::part_name;
pub use node::PlanarNode;
pub use problem::{Bend, Place, Problem};
pub use robot::Robot;
pub use rows::RowKind;
pub use sizes::Sizes;
