//! The robot with cables that slide through its disks: the mechanics of a real
//! tendon-driven robot. Each cable has one tension all along, so that the backbone
//! bends with the forces that a load cell would show.
//!
//! Between its nodes the backbone is a circular arc, and disks stand square on it; a
//! cable is straight from disk to disk, fixed in its last one.
//!
//! ```text
//! minimise  (EI/2l) Σ b²   subject to   Σ len_k ⪯ L − pull,   obstacles ⪰ 0
//! ```
//!
//! The multiplier of a cable's length is its tension T ⪰ 0; it is slack where that is
//! 0. Differs from the paper, whose cable shortens by as much in every segment: there
//! it cannot slide, and near a contact the backbone gives way in shear instead.

mod arc;
mod bay;
mod branch;
mod certifier;
mod chain;
mod friction;
mod stretch;

pub use certifier::rests_under_load;
pub use chain::Sliding;
