//! What outlives the window besides unsaved work: the user's choices, recent
//! files, and where the plots are. Windows share a storage for them, where the
//! last one counts. A choice that cannot be read is dropped and told.

use super::Sinew;
use crate::app::dock::{Arrangement, Dock};
use crate::app::files::autosave;
use crate::app::workbench::{Preferences, Workbench};
use crate::scene::Scene;
use eframe::Storage;
use serde::de::DeserializeOwned;
use std::path::PathBuf;

const PREFERENCES: &str = "preferences";
const RECENT: &str = "recent";
const DOCK: &str = "dock";

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

/// Stores the user's choices.
pub fn store(bench: &Workbench, dock: &Dock, storage: &mut dyn Storage) {
    eframe::set_value(storage, PREFERENCES, &bench.preferences);
    eframe::set_value(storage, RECENT, &bench.files.recent);
    eframe::set_value(storage, DOCK, &Some(dock.arrangement()));
}

/// What tells whether anything differs from what was last stored.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Snapshot {
    scene: Scene,
    changed: bool,
    file: Option<PathBuf>,
    preferences: Preferences,
    dock: Arrangement,
}

impl Snapshot {
    fn of(bench: &Workbench, dock: &Dock) -> Self {
        Self {
            scene: bench.document.scene.clone(),
            changed: bench.document.is_changed(),
            file: bench.document.file.clone(),
            preferences: bench.preferences.clone(),
            dock: dock.arrangement().clone(),
        }
    }

    /// Whether nothing differs. Asked in every frame, so it copies nothing.
    fn is_of(&self, bench: &Workbench, dock: &Dock) -> bool {
        self.changed == bench.document.is_changed()
            && self.file == bench.document.file
            && self.preferences == bench.preferences
            && self.dock == *dock.arrangement()
            && self.scene == bench.document.scene
    }
}

impl Sinew {
    /// Keeps and stores at once where anything differs, for the end of a gesture:
    /// an idle window is given no other occasion.
    pub(super) fn store_settled(&mut self, storage: Option<&mut (dyn Storage + 'static)>) {
        let (bench, dock) = (&mut self.bench, &self.dock);
        let known = self.stored.as_ref();
        if known.is_some_and(|known| known.is_of(bench, dock)) {
            return;
        }
        autosave::keep(bench);
        if let Some(storage) = storage {
            store(bench, dock, storage);
            storage.flush();
        }
        self.stored = Some(Snapshot::of(bench, dock));
    }
}
