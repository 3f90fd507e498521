//! What outlives the window: the user's choices, recent files, and the scene
//! while it differs from what is saved, so that a crash loses nothing.
//!
//! An orderly end leaves no unsaved scene behind, so one that is found at the
//! start is from a crash (or a system that shut down), and is offered. A stored
//! value that cannot be read is dropped and told.

use super::Arrival;
use crate::app::dock::{Arrangement, Dock};
use crate::app::state::{Preferences, State};
use crate::scene::{Scene, SceneError};
use eframe::Storage;
use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};
use std::path::PathBuf;

const PREFERENCES: &str = "preferences";
const RECENT: &str = "recent";
const UNSAVED: &str = "unsaved";
const DOCK: &str = "dock";

/// Scenes that are kept for a decision, the newest first.
const MOST_UNSAVED: usize = 5;

/// A scene that differed from what was saved.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Unsaved {
    /// What it was called.
    pub name: String,
    /// The file it was from, if any.
    pub file: Option<PathBuf>,
    /// The scene as TOML, a photograph's path absolute.
    pub scene: String,
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
            file: document.file.clone(),
            scene: document.scene.to_toml().ok()?,
        })
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
    /// Scenes that were not saved, the newest first.
    pub unsaved: Vec<Unsaved>,
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
        stored.unsaved = read(storage, UNSAVED, "work that was not saved", lost);
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

/// Stores what is to outlive the window.
pub fn store(state: &State, storage: &mut dyn Storage) {
    let mut unsaved: Vec<Unsaved> = Unsaved::of(state).into_iter().collect();
    unsaved.extend(state.files.unsaved.iter().cloned());
    unsaved.truncate(MOST_UNSAVED);
    eframe::set_value(storage, PREFERENCES, &state.preferences);
    eframe::set_value(storage, RECENT, &state.files.recent);
    eframe::set_value(storage, UNSAVED, &unsaved);
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
    unsaved: usize,
    dock: Option<Arrangement>,
}

impl Mark {
    fn of(state: &State) -> Self {
        Self {
            scene: state.document.scene.clone(),
            changed: state.document.is_changed(),
            file: state.document.file.clone(),
            preferences: state.preferences.clone(),
            unsaved: state.files.unsaved.len(),
            dock: state.dock.as_ref().map(|dock| dock.arrangement().clone()),
        }
    }

    /// Whether nothing differs. Asked in every frame, so it copies nothing.
    fn is_of(&self, state: &State) -> bool {
        self.changed == state.document.is_changed()
            && self.unsaved == state.files.unsaved.len()
            && self.file == state.document.file
            && self.preferences == state.preferences
            && self.dock.as_ref() == state.dock.as_ref().map(Dock::arrangement)
            && self.scene == state.document.scene
    }
}

/// Stores it at once where anything differs, for the end of a gesture: an idle
/// window is given no other occasion.
pub fn store_settled(state: &mut State, storage: Option<&mut (dyn Storage + 'static)>) {
    let Some(storage) = storage else {
        return;
    };
    let known = state.files.stored.as_ref();
    if !known.is_some_and(|mark| mark.is_of(state)) {
        store(state, storage);
        storage.flush();
        state.files.stored = Some(Mark::of(state));
    }
}
