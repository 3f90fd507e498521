//! The paper's mechanics: every segment a four-bar linkage, its cable link
//! shortened by the same amount everywhere (eq. 4). All lengths are kept exactly
//! and one turn a segment is free. The solver's cost is Σ (β/β*)², see
//! [`FourBar`].

mod branch;
mod certifier;
mod chain;
mod free_arc;
mod linkage;

pub use certifier::Certifier;
pub use chain::{Bend, Equal};
pub use free_arc::FreeArc;
pub use linkage::{FourBar, MOST_BEND, MOST_TURN};
