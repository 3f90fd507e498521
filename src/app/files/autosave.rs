//! What outlives the window: the user's choices, recent files, and the scene
//! while it differs from what is saved, so that a crash loses nothing.
//!
//! Windows share a storage for choices, where the last one counts. Unsaved work
//! is kept by each window for itself ([`Platform::keep`]). An orderly end
//! leaves none behind, so what is found at the start is from a crash (or a
//! system that shut down), and is offered. A choice that cannot be read is
//! dropped and told.

use super::Arrival;
use crate::app::dock::{Arrangement, Dock};
use crate::app::platform::Platform;
use crate::app::state::{Preferences, State};
use crate::scene::{Scene, SceneError};
use eframe::Storage;
use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};
use std::path::PathBuf;

const PREFERENCES: &str = "preferences";
const RECENT: &str = "recent";
const DOCK: &str = "dock";

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
    /// The window's scene, if it differs from what is saved.
    fn of(state: &State) -> Option<Self> {
        let document = &state.document;
        if !document.is_changed() || state.files.closing {
            return None;
        }
        Some(Self {
            name: document.name(),
            // A path that is no text cannot be written, which must not cost
            // the work.
            file: document.file.clone().filter(|file| file.to_str().is_some()),
            scene: document.scene.to_toml().ok()?,
            drawer: String::new(),
        })
    }

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

/// What an earlier window has left.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Stored {
    /// The user's choices.
    pub preferences: Preferences,
    /// Files that were open, the last one first.
    pub recent: Vec<PathBuf>,
    /// Where the plots and tables were, if that is known.
    pub dock: Option<Arrangement>,
    /// What could not be read, in words.
    pub lost: Vec<&'static str>,
}

impl Stored {
    /// What is in a storage.
    pub fn of(storage: Option<&dyn Storage>) -> Self {
        let mut stored = Self::default();
        let Some(storage) = storage else {
            return stored;
        };
        let lost = &mut stored.lost;
        stored.preferences = read(storage, PREFERENCES, "your settings", lost);
        stored.preferences.bring_into_range();
        stored.recent = read(storage, RECENT, "the list of recent files", lost);
        stored.dock = read(storage, DOCK, "where the plots were", lost);
        stored
    }
}

/// Whether the user has made choices that are stored.
pub fn has_preferences(storage: &dyn Storage) -> bool {
    storage.get_string(PREFERENCES).is_some()
}

fn read<T: DeserializeOwned + Default>(
    storage: &dyn Storage,
    key: &str,
    what: &'static str,
    lost: &mut Vec<&'static str>,
) -> T {
    let value = eframe::get_value(storage, key);
    if value.is_none() && storage.get_string(key).is_some_and(|text| !text.is_empty()) {
        lost.push(what);
    }
    value.unwrap_or_default()
}

/// Keeps the scene where a crash leaves it, as long as it is not saved.
pub fn keep(state: &mut State) {
    let work = Unsaved::of(state).and_then(|unsaved| toml::to_string(&unsaved).ok());
    state.files.platform.keep(work);
}

/// Throws away what a window that is gone has kept.
pub fn forget(state: &mut State, drawer: &str) {
    state.files.unsaved.retain(|left| left.drawer != drawer);
    state.files.platform.forget(drawer);
}

/// Stores the user's choices.
pub fn store(state: &State, storage: &mut dyn Storage) {
    eframe::set_value(storage, PREFERENCES, &state.preferences);
    eframe::set_value(storage, RECENT, &state.files.recent);
    if let Some(dock) = &state.dock {
        eframe::set_value(storage, DOCK, &Some(dock.arrangement()));
    }
}

/// What tells whether anything differs from what was last stored.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Mark {
    scene: Scene,
    changed: bool,
    file: Option<PathBuf>,
    preferences: Preferences,
    dock: Option<Arrangement>,
}

impl Mark {
    fn of(state: &State) -> Self {
        Self {
            scene: state.document.scene.clone(),
            changed: state.document.is_changed(),
            file: state.document.file.clone(),
            preferences: state.preferences.clone(),
            dock: state.dock.as_ref().map(|dock| dock.arrangement().clone()),
        }
    }

    /// Whether nothing differs. Asked in every frame, so it copies nothing.
    fn is_of(&self, state: &State) -> bool {
        self.changed == state.document.is_changed()
            && self.file == state.document.file
            && self.preferences == state.preferences
            && self.dock.as_ref() == state.dock.as_ref().map(Dock::arrangement)
            && self.scene == state.document.scene
    }
}

/// Keeps and stores at once where anything differs, for the end of a gesture:
/// an idle window is given no other occasion.
pub fn store_settled(state: &mut State, storage: Option<&mut (dyn Storage + 'static)>) {
    let known = state.files.stored.as_ref();
    if known.is_some_and(|mark| mark.is_of(state)) {
        return;
    }
    keep(state);
    if let Some(storage) = storage {
        store(state, storage);
        storage.flush();
    }
    state.files.stored = Some(Mark::of(state));
}
