//! Constrained minimisation along a chain of stages.
//!
//! A chain is the discrete optimal-control problem
//!
//! ```text
//! minimise    Σ_k L_k(z_{k−1}, u_k)             k = 1 … n
//! subject to  z_k = F_k(z_{k−1}, u_k)           z_0 given
//!             g_r(z_{k−1}, z_k, u_k) ⪰ 0        rows r, each at one stage k
//!             b_s + Σ_k c_sk(u_k) ⪰ 0           rows s summed over the stages
//! ```
//!
//! with a state z of dimension `NX` and a control u of dimension `NU` at each
//! stage. The states are eliminated by rolling the chain out, so the controls
//! are the only unknowns; a Riccati recursion makes each Newton step O(n).
//!
//! | symbol | meaning | identifier |
//! |---|---|---|
//! | z_k, u_k | state, control | `Chain::Node`, [`Control`] |
//! | A_k, B_k | ∂F_k/∂z, ∂F_k/∂u | [`Stage::by_state`], [`Stage::by_control`] |
//! | p_k | adjoint of z_k | `adjoint` |
//! | λ_r | multiplier of row r, ≥ 0 | `multiplier` |
//! | H | Hessian of the Lagrangian in the controls | [`Riccati`] |
//! | S | Schur complement G H⁻¹ Gᵀ of the working set | `WorkingSet` |
//! | ν | exact penalty, the upper bound of λ | `penalty` |
//!
//! What a state, a control or a row measures is for the chain to know: this
//! layer has one unit for all rows, [`Chain::row_scale`], and none else.

mod chain;
mod covariance;
#[cfg(test)]
mod dense_tests;
mod hessian;
#[cfg(test)]
mod linear;
mod point;
mod riccati;
mod sqp;
mod working_set;

pub use chain::{
    Chain, Control, DynamicsCurvature, Row, RowCurvature, RowId, Stage, State, SumRow,
};
pub use hessian::Hessian;
pub use point::{Point, Sum};
pub use riccati::{NotPositive, Riccati, Source};
pub use sqp::{Iteration, Outcome, Progress, Settings, Sqp, Tunnelling};
