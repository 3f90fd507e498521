//! Small numerical pieces that know nothing of robots, solvers or geometry.

mod asinc;
mod packed_cholesky;

pub use asinc::asinc;
pub use packed_cholesky::PackedCholesky;
