//! Small numerical pieces that know nothing of robots, solvers or geometry.

mod anderson;
mod asinc;
mod digits;
mod greatest;
mod packed_cholesky;
mod within;

pub use anderson::Anderson;
pub use asinc::asinc;
pub use digits::{decimals, shortest, typeset, unsigned_zero, with_minus};
pub use greatest::greatest;
pub use packed_cholesky::PackedCholesky;
pub use within::within;
