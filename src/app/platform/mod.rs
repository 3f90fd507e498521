//! What the window asks of the system it runs on: files, photographs, and a
//! place for what is not saved. The only way out of the window besides its
//! solver, so that the desktop, a browser and a test differ in nothing else.
//!
//! Nothing here waits. What was asked for comes later from [`Platform::poll`],
//! which the window asks once a frame; whoever delivers asks for that frame.

mod detached;
#[cfg(not(target_arch = "wasm32"))]
mod drawers;
#[cfg(not(target_arch = "wasm32"))]
mod native;
#[cfg(all(target_arch = "wasm32", feature = "web"))]
mod web;

pub use detached::Detached;
#[cfg(not(target_arch = "wasm32"))]
pub use native::{Native, in_words};
#[cfg(all(target_arch = "wasm32", feature = "web"))]
pub use web::Web;

use crate::app::pixels::Decoded;
use crate::scene::MAX_FILE_BYTES;
use eframe::egui::DroppedFileHandle;
use std::path::{Path, PathBuf};

/// What a file is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Errand {
    /// A scene to be opened.
    Scene,
    /// A measured backbone or force readings, to be brought into the scene.
    Measurements,
    /// A photograph to be put behind the robot.
    Photo,
    /// A photograph that the scene names.
    KnownPhoto,
    /// The scene, to be written.
    Save,
    /// A picture, to be written.
    Picture(PictureKind),
    /// A plot's numbers, to be written.
    Table,
}

/// The kinds of pictures that can be exported.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PictureKind {
    /// Lines and text.
    Svg,
    /// Pixels.
    Png,
}

impl Errand {
    /// What the file is called in sentences.
    pub fn noun(self) -> &'static str {
        match self {
            Errand::Scene | Errand::Save => "scene",
            Errand::Measurements => "table of measurements",
            Errand::Photo | Errand::KnownPhoto => "photograph",
            Errand::Table => "table",
            Errand::Picture(_) => "picture",
        }
    }

    /// The endings of such files, without dots.
    pub fn endings(self) -> &'static [&'static str] {
        match self {
            Errand::Scene | Errand::Save => &["toml"],
            Errand::Measurements => &["csv", "txt"],
            Errand::Table => &["csv"],
            Errand::Photo | Errand::KnownPhoto => &["png", "jpg", "jpeg"],
            Errand::Picture(PictureKind::Svg) => &["svg"],
            Errand::Picture(PictureKind::Png) => &["png"],
        }
    }

    /// The largest such file that is read, in bytes.
    pub fn most_bytes(self) -> u64 {
        match self {
            Errand::Photo | Errand::KnownPhoto => 64 << 20,
            _ => MAX_FILE_BYTES as u64,
        }
    }

    /// Why a file of this size is not read; `None` where it is.
    pub fn too_large(self, bytes: u64) -> Option<String> {
        const MB: f64 = (1 << 20) as f64;
        let most = self.most_bytes();
        (bytes > most).then(|| {
            format!(
                "it has {:.1} MB, and a {} may have {:.0} MB at most",
                bytes as f64 / MB,
                self.noun(),
                most as f64 / MB,
            )
        })
    }
}

/// What a file is to hold, given where it goes; or a sentence why it cannot
/// be made.
pub type Contents = Box<dyn FnOnce(&Path) -> Result<Vec<u8>, String> + Send>;

/// Whoever takes a photograph.
pub type Taker = Box<dyn FnOnce(Result<Decoded, String>) + Send>;

/// Where a file goes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Destination {
    /// There.
    Known(PathBuf),
    /// Wherever the user says, who is offered this name in this folder.
    Ask {
        /// A file's name.
        name: String,
        /// A folder, where one is known.
        folder: Option<PathBuf>,
    },
}

/// What has become of an errand.
#[derive(Clone, Debug, PartialEq)]
pub enum News {
    /// A file was read.
    Read {
        /// What for.
        errand: Errand,
        /// Its path; on the web its name.
        path: PathBuf,
        /// What it holds.
        bytes: Vec<u8>,
    },
    /// A file was written.
    Written {
        /// What for.
        errand: Errand,
        /// Its path; on the web its name.
        path: PathBuf,
    },
    /// It cannot be done.
    Failed {
        /// What was to be done.
        errand: Errand,
        /// The file, where one was chosen.
        path: Option<PathBuf>,
        /// Why, without the file's name: `it has 71.2 MB, …`.
        reason: String,
    },
    /// The user has changed their mind.
    Cancelled(Errand),
    /// The system has no dialog to ask with: see [`Platform::answer`].
    NoDialog {
        /// What a file was wanted for.
        errand: Errand,
        /// A path that may suit, to be changed.
        suggested: PathBuf,
    },
}

/// Work that a window which is gone did not save.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Left {
    /// What the system knows it by.
    pub drawer: String,
    /// What was kept.
    pub work: String,
}

/// The system around the window.
pub trait Platform {
    /// Asks the user for a file and reads it. To be called while a click or a
    /// key is being handled: browsers refuse it at other times.
    fn pick(&mut self, errand: Errand, folder: Option<&Path>);

    /// Goes on with an errand that there was no dialog for, with the path that was typed;
    /// or gives it up.
    fn answer(&mut self, errand: Errand, path: Option<PathBuf>);

    /// Reads a file.
    fn read(&mut self, errand: Errand, path: PathBuf);

    /// Reads a file that was dropped on the window.
    fn take(&mut self, errand: Errand, dropped: DroppedFileHandle);

    /// Writes a file, wholly or not at all: what was there before stays until
    /// the new contents are.
    fn write(&mut self, errand: Errand, to: Destination, contents: Contents);

    /// Decodes a photograph and gives it to someone: or a clause, with `it` for
    /// the file, on why it cannot be shown. At once, unless the system can do it
    /// while the window goes on and asks for a frame when it is done.
    #[cfg(not(target_arch = "wasm32"))]
    fn decode(&mut self, bytes: Vec<u8>, give: Taker) {
        give(crate::app::pixels::decode(&bytes));
    }

    /// The same, by the browser, which can do it already.
    #[cfg(target_arch = "wasm32")]
    fn decode(&mut self, bytes: Vec<u8>, give: Taker);

    /// Keeps this window's work where the end of the program leaves it and no
    /// other window changes it, in the place of what it has kept before; or
    /// keeps nothing any more.
    fn keep(&mut self, work: Option<String>);

    /// What windows that are gone have kept, the newest first. No other window
    /// is given it while this one is there.
    fn left(&mut self) -> Vec<Left>;

    /// Throws such work away.
    fn forget(&mut self, drawer: &str);

    /// What has become of an errand, if anything has.
    fn poll(&mut self) -> Option<News>;

    /// What links to scenes start with: the page's address in a browser; on the
    /// desktop, where no address shows a scene, `sinew:`.
    fn address(&self) -> String {
        "sinew:".to_owned()
    }

    /// Whether a path that was read or written can be read or written again
    /// without asking the user. So on a desktop; in a browser never.
    fn keeps_paths(&self) -> bool;
}
