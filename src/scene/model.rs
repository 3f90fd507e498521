//! Which mechanics a scene means. No mechanics.

use serde::{Deserialize, Serialize};

/// The model that a scene is to be solved with.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(default)]
pub struct Model {
    /// How the cables act on the robot.
    pub mechanics: Mechanics,
}

/// How the cables act on the robot.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Mechanics {
    /// Each cable slides through the holes of the disks, and is straight from
    /// disk to disk. What a file means that does not say.
    #[default]
    Sliding,
    /// Every segment of the cable shortens alike, as in the paper. What every
    /// file of version 1 means.
    Equal,
}

impl Mechanics {
    /// The word of scene files, such as `sliding`.
    pub fn word(self) -> &'static str {
        match self {
            Mechanics::Sliding => "sliding",
            Mechanics::Equal => "equal",
        }
    }
}
