//! What is known of the document's files: recent ones, what is being asked and
//! written, and work that waits for a decision.

use super::unsaved::Unsaved;
use crate::app::platform::{Errand, Platform};
use crate::scene::Scene;
use std::path::{Path, PathBuf};

/// Files that are remembered.
const MOST_RECENT: usize = 10;

/// What is to take the place of the document.
#[derive(Clone, Debug, PartialEq)]
pub enum Intent {
    /// A new scene: the robot with nothing around it.
    New,
    /// A scene that is kept nowhere: an example, a link, a file's contents.
    Scene(Box<Arrival>),
    /// Nothing: the window closes.
    Close,
}

/// A scene on its way into the window.
#[derive(Clone, Debug, PartialEq)]
pub struct Arrival {
    /// The scene.
    pub scene: Scene,
    /// Where it is kept, if anywhere.
    pub file: Option<PathBuf>,
    /// What is told when it is open, if anything.
    pub told: Option<String>,
    /// Whether it counts as saved.
    pub kept: bool,
    /// Where a window that is gone has kept it, if that is where it is from.
    pub drawer: Option<String>,
}

impl Arrival {
    /// A scene that is kept nowhere and does not need to be.
    pub fn of(scene: Scene) -> Self {
        Self {
            scene,
            file: None,
            told: None,
            kept: true,
            drawer: None,
        }
    }

    /// The same, and what is told when it is open.
    #[must_use]
    pub fn telling(mut self, told: impl Into<String>) -> Self {
        self.told = Some(told.into());
        self
    }
}

/// A dialog, and which document it was opened for: another may be there when it
/// is answered.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Asked {
    /// What for.
    pub errand: Errand,
    /// Which, see [`super::Workbench::opened`].
    pub opened: u64,
}

/// A scene that is being written.
#[derive(Clone, Debug, PartialEq)]
pub struct Saved {
    /// What it was when it was asked for.
    pub scene: Scene,
    /// Whose it is, see [`super::Workbench::opened`].
    pub opened: u64,
    /// What follows when it is written.
    pub then: Option<Intent>,
}

/// The document's way to and from files.
pub struct Files {
    /// The system around the window.
    pub platform: Box<dyn Platform>,
    /// Files that were open, the last one first.
    pub recent: Vec<PathBuf>,
    /// Work that an earlier window did not save and nobody has decided on.
    pub unsaved: Vec<Unsaved>,
    /// What is being written, if anything.
    pub saving: Option<Saved>,
    /// The dialog of the system that is open, if any.
    pub asking: Option<Asked>,
    /// What is being typed of a path, where the system has no dialog, and what for.
    pub typing: Option<(Errand, String)>,
    /// Whether the window may close.
    pub closing: bool,
    /// The window's title as the system knows it.
    pub title: String,
    /// What is to happen as soon as it is decided what becomes of unsaved work.
    pub guarded: Option<Intent>,
}

impl Files {
    /// No files yet, on a system.
    pub fn new(platform: Box<dyn Platform>) -> Self {
        Self {
            platform,
            recent: Vec::new(),
            unsaved: Vec::new(),
            saving: None,
            asking: None,
            typing: None,
            closing: false,
            title: String::new(),
            guarded: None,
        }
    }

    /// Whether a dialog is open; a second one would hide behind it.
    pub fn is_asking(&self) -> bool {
        self.asking.is_some()
    }

    /// Closes the dialog of an errand, if it is open. The document that it was
    /// opened for.
    pub fn answered(&mut self, errand: Errand) -> Option<u64> {
        let asked = self.asking.take_if(|asked| asked.errand == errand);
        asked.map(|asked| asked.opened)
    }

    /// Puts a file in front of the recent ones.
    pub fn remember(&mut self, path: &Path) {
        if !self.platform.keeps_paths() {
            return;
        }
        self.recent.retain(|known| known != path);
        self.recent.insert(0, path.to_owned());
        self.recent.truncate(MOST_RECENT);
    }
}
