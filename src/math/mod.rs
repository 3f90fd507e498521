//! Small numerical pieces that know nothing of robots, solvers or geometry.

mod asinc;
mod greatest;
mod packed_cholesky;

pub use asinc::asinc;
pub use greatest::greatest;
pub use packed_cholesky::PackedCholesky;
