//! Studies of a design: parameters of a scene, samples of them, and what is asked of
//! each. *Which disk spacing and cable offset halve the contact force?*
//!
//! A [`StudyFile`] is what a study's TOML file says; a [`Study`] is one whose names are
//! all known, with its scene. Its samples count from 0 and each is found by its index
//! alone, so that any machine can compute any of them: [`Study::compute`] follows the
//! robot from the straight one, as it would get there, and has the same bits whoever
//! does it. Results are kept as [`log`]s of bytes, which survive being cut off anywhere.
//!
//! ```
//! use sinew::scene::Scene;
//! use sinew::study::{Study, StudyFile, Verdict};
//!
//! let file = StudyFile::from_toml(r#"
//!     version = 1
//!     scene = "two-posts.toml"
//!     outputs = ["force_max_n"]
//!     constraints = ["force_max_n < 0.1"]
//!     parameter = [{ key = "robot.cable_offset_mm", from = 6, to = 8, steps = 3 }]
//! "#)?;
//! let scene = Scene::from_toml(include_str!("../../assets/scenes/two-posts.toml")).unwrap();
//! let study = Study::new(file, scene)?;
//! assert_eq!(study.samples(), 3);
//! assert_eq!(study.values(1), [7.0]);
//! let row = study.compute(1);
//! assert_eq!(row.verdict, Verdict::Converged);
//! println!("{} N, {}", row.numbers[0], study.is_feasible(&row));
//! # Ok::<(), sinew::study::StudyError>(())
//! ```

mod compute;
mod constraint;
mod design;
mod error;
mod file;
mod hash;
pub mod log;
mod output;
mod parameter;
mod ranges;
mod row;
mod sampler;
mod sobol;
mod table;

pub use constraint::Constraint;
pub use design::Study;
pub use error::StudyError;
pub use file::{StudyFile, VERSION};
pub use hash::checksum;
pub use output::Output;
pub use parameter::{Parameter, Scale, Values};
pub use ranges::{Ranges, shard};
pub use row::{Row, Verdict};
pub use sampler::Sampler;
pub use sobol::MOST_DIMENSIONS;

/// The most samples of a study: a day's on a hundred cores.
pub const MAX_SAMPLES: u64 = 1_000_000_000;
