//! The scene: what a scene file says, and nothing computed from it.
//!
//! Owns every persisted type. The types have the file's shape, its keys and
//! its units (millimetres and degrees, as each name says), and may hold
//! half-edited nonsense: [`Scene::from_toml`] refuses what does not have the
//! shape of a scene, [`Scene::faults`] finds what has the shape and cannot be
//! meant. Reads no files: text in, text out.
//!
//! ```
//! use sinew::scene::Scene;
//!
//! let text = r#"
//!     version = 2
//!     model = { mechanics = "equal" }
//!     robot = { length_mm = 180, segments = 18, cable_offset_mm = 8 }
//!     actuation = { pull_mm = 5 }
//! "#;
//! let scene = Scene::from_toml(text)?;
//! scene.check()?;
//! assert_eq!(scene.robot.segments_per_bay, 2);
//! assert_eq!((scene.cable_count(), scene.offset_mm()), (1, 8.0));
//!
//! let typo = Scene::from_toml(&text.replace("pull_mm", "pul_mm"));
//! assert_eq!(
//!     typo.unwrap_err().to_string(),
//!     "actuation.pul_mm is not a key of a scene; did you mean `pull_mm`?",
//! );
//! # Ok::<(), sinew::scene::SceneError>(())
//! ```

mod cable;
mod contact;
mod error;
mod faults;
mod file;
mod friction;
mod keys;
pub mod limits;
mod loads;
mod measured;
mod migrate;
mod model;
mod obstacle;
mod polygon;
mod robot;
#[cfg(feature = "cli")]
pub mod schema;
mod set;
mod slip;
mod walk;

use serde::{Deserialize, Serialize};

pub use cable::{Actuation, Cable, Drive};
pub use contact::{Candidates, Contact, Line, Listed};
pub use error::SceneError;
pub use file::MAX_FILE_BYTES;
pub use friction::Friction;
pub use loads::Loads;
pub use measured::{ForceReading, Measurements, Photo};
pub use model::{Mechanics, Model};
pub use obstacle::{Obstacle, Shape};
pub use polygon::PolygonFault;
pub use robot::Robot;
#[cfg(feature = "cli")]
pub(crate) use walk::nearest;
#[cfg(any(feature = "app", feature = "cli"))]
pub(crate) use walk::quoted;

/// The version of the file format that is written. Files of every version from
/// 1 on are read; a scene that was read is of this one.
pub const VERSION: u32 = 2;

/// A robot, what pulls it, what stands around it and what was measured on it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Scene {
    /// The version of the file format; only [`VERSION`] is accepted.
    pub version: u32,
    /// What the scene is called.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub title: Option<String>,
    /// What it is to be solved with.
    #[serde(default)]
    pub model: Model,
    /// The robot.
    pub robot: Robot,
    /// What drives the one cable at [`Robot::cable_offset_mm`]; absent where
    /// `cables` describes the cables. [`Scene::cable`] reads both.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub actuation: Option<Actuation>,
    /// The cables, where they are not described with the robot; at most
    /// [`limits::CABLES`].
    #[serde(default, rename = "cable", skip_serializing_if = "Vec::is_empty")]
    pub cables: Vec<Cable>,
    /// Where the robot rubs.
    #[serde(default, skip_serializing_if = "Friction::is_none")]
    pub friction: Friction,
    /// What acts on the robot beside its cables and obstacles.
    #[serde(default, skip_serializing_if = "Loads::is_none")]
    pub loads: Loads,
    /// Which parts of the robot may touch an obstacle.
    #[serde(default)]
    pub contact: Contact,
    /// What stands around the robot; at most [`limits::OBSTACLES`].
    #[serde(default, rename = "obstacle", skip_serializing_if = "Vec::is_empty")]
    pub obstacles: Vec<Obstacle>,
    /// What was measured on the robot.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub measured: Option<Measurements>,
    /// A photograph behind the robot.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub photo: Option<Photo>,
}

/// The paper's robot and its model, straight and with nothing around it.
impl Default for Scene {
    fn default() -> Self {
        Scene {
            version: VERSION,
            title: None,
            model: Model {
                mechanics: Mechanics::Equal,
            },
            robot: Robot::default(),
            actuation: Some(Actuation {
                drive: Drive::PullMm(0.0),
            }),
            cables: Vec::new(),
            friction: Friction::default(),
            loads: Loads::default(),
            contact: Contact::default(),
            obstacles: Vec::new(),
            measured: None,
            photo: None,
        }
    }
}
