//! Forces of a solved robot, in newtons, by two independent ways.
//!
//! * From the multipliers of eq. 5: with a bending stiffness EI the energy is
//!   U = (EI/2l_0) Σ β², so that every multiplier becomes a force:
//!   [`Statics`]. Its equilibrium is checked as a free body by the method of
//!   sections ([`Sections`]), which knows nothing of multipliers of links.
//! * From the kinematics alone, by the paper's virtual work (eq. 6 to 11):
//!   [`VirtualWork`], on straight lines ([`LineFit`]) through a [`Sweep`] of
//!   the pull.
//!
//! Signs, throughout: +x is the side the cable is on while the robot stands
//! straight along +y, angles are counterclockwise (the robot bends clockwise,
//! so that its slope falls with the pull), and a tension is positive.
//!
//! | paper | here | meaning |
//! |---|---|---|
//! | P_l (also F_l) | `load` | the weight on the cable |
//! | P_x, P_y | [`PressingForce`] | what the robot exerts on the obstacle |
//! | f′_x, f′_y, f′_θ | [`Rates`] | how the node moves with the pull |
//! | μ | `friction` | P_y / P_x |
//! | M_e | a P_l | moment of the cable about the backbone |
//! | R_x, R_y, M_r | [`Statics::clamp`] | reaction at the base |
//! | B | [`Stiffness`] | bending stiffness EI |

mod line_fit;
mod load_steps;
mod sections;
mod statics;
mod stiffness;
mod sweep;
mod virtual_work;

pub use line_fit::{FitError, LineFit};
pub use load_steps::{LoadSteps, Loaded};
pub use sections::{Section, Sections};
pub use statics::{ContactForce, Resultant, Statics, share_of_tension};
pub use stiffness::{Profile, Stiffness, StiffnessError};
pub use sweep::{Sweep, SweepError, SweepPoint};
pub use virtual_work::{
    Caveat, PressingForce, Rates, Touch, VirtualWork, VirtualWorkError, Window,
};

/// A number for a message, without what converting its unit did to its last
/// digits.
fn told(value: f64) -> f64 {
    if value == 0.0 || !value.is_finite() {
        return value;
    }
    // The nearest number with nine figures, found in decimal.
    format!("{value:.8e}").parse().unwrap_or(value)
}
