//! Work that was not saved when its window ended.

use super::files::Arrival;
use crate::app::platform::Platform;
use crate::scene::{Scene, SceneError};
use serde::{Deserialize, Serialize};
use std::path::PathBuf;

/// A scene that differed from what was saved.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Unsaved {
    /// What it was called.
    pub name: String,
    /// The file it was from, if any.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub file: Option<PathBuf>,
    /// The scene as TOML, a photograph's path absolute.
    pub scene: String,
    /// Where it is kept until it is decided on, see [`Platform::left`].
    #[serde(skip)]
    pub drawer: String,
}

impl Unsaved {
    /// What windows that are gone have left. What cannot be read may still
    /// hold a scene for eyes, so it is not thrown away unasked.
    pub fn left(platform: &mut dyn Platform) -> Vec<Self> {
        let left = platform.left().into_iter();
        left.map(|left| match toml::from_str::<Self>(&left.work) {
            Ok(unsaved) => Self {
                drawer: left.drawer,
                ..unsaved
            },
            Err(_) => Self {
                name: "A scene".to_owned(),
                file: None,
                scene: left.work,
                drawer: left.drawer,
            },
        })
        .collect()
    }

    /// The scene, on its way back into a window.
    ///
    /// # Errors
    /// When the text is no scene that this program reads.
    pub fn arrival(&self) -> Result<Arrival, SceneError> {
        Ok(Arrival {
            scene: Scene::from_toml(&self.scene)?,
            file: self.file.clone(),
            told: Some(format!("Restored {}", self.name)),
            kept: false,
            drawer: Some(self.drawer.clone()),
        })
    }
}
