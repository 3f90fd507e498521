//! What bends the robot, as a chain for the solver.
//!
//! [`Problem::new`] parses a scene once into something that cannot be wrong;
//! what it gives implements [`crate::solver::Chain`]. SI units throughout.

mod certificate;
mod condition;
mod four_bar;
mod from_scene;
mod problem;

pub use certificate::Certificate;
pub use condition::{Answers, Condition, ConditionKind};
pub use four_bar::{Bend, Certifier, FourBar, FreeArc, MOST_BEND, MOST_TURN};
pub use problem::Problem;
