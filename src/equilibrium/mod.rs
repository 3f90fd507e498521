//! From a problem to certified equilibria: the façade of the library.
//!
//! ```
//! use sinew::equilibrium::{Settings, Start, solve};
//! use sinew::mechanics::Problem;
//! use sinew::scene::Scene;
//!
//! let scene = Scene::from_toml(include_str!("../../assets/scenes/two-discs.toml"))?;
//! let solution = solve(&Problem::new(&scene)?, Start::Straight, Settings::default());
//! assert!(solution.certificate.holds());
//! let nodes: Vec<usize> = solution.contacts.iter().map(|contact| contact.node).collect();
//! assert_eq!(nodes, [10, 16]);
//! # Ok::<(), sinew::scene::SceneError>(())
//! ```

mod approach;
mod branch;
mod caution;
mod event;
mod run;
mod solution;
mod solved;
mod split;
mod status;

pub use branch::Settings;
pub use caution::Caution;
pub use event::{Event, Occurrence};
pub use run::{Progress, Run, Start, solve};
pub use solution::Solution;
pub use solved::Solved;
pub use status::{Conflict, EndReason, Status};
