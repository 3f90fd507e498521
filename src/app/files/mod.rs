//! The document's files: opening, saving, recent ones, and the guard in front
//! of whatever would throw unsaved work away.
//!
//! An [`Intent`] says what is to take the place of the document. [`request`]
//! carries it out at once, or asks first where there is unsaved work. Files
//! come and go through the [`Platform`]; what comes of them is met in
//! [`arrive`].

pub mod autosave;
mod drop;
pub mod export;
mod open;
mod photo_path;

pub use drop::{Dropped, announce, take_drops, take_pastes};
pub use open::scene_from;

use super::notices::Notice;
use super::platform::{Destination, Errand, News, Platform};
use super::sheets::Sheet;
use super::state::State;
use super::words::{sentence, shown};
use crate::scene::{Candidates, Scene};
use autosave::Unsaved;
use eframe::egui::{Context, ViewportCommand};
use std::path::{Path, PathBuf};

/// Files that are remembered.
const MOST_RECENT: usize = 10;

/// What is to take the place of the document.
#[derive(Clone, Debug, PartialEq)]
pub enum Intent {
    /// The paper's robot with nothing around it, see [`blank`].
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

/// A dialog, and which document it was opened for: another may be there when it
/// is answered.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Asked {
    errand: Errand,
    opened: u64,
}

/// A scene that is being written.
#[derive(Clone, Debug, PartialEq)]
struct Saved {
    scene: Scene,
    /// Whose it is, see [`State::opened`].
    opened: u64,
    /// What follows when it is written.
    then: Option<Intent>,
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
    saving: Option<Saved>,
    /// The dialog of the system that is open, if any.
    asking: Option<Asked>,
    /// Whether the window may close.
    pub closing: bool,
    /// The window's title as the system knows it.
    title: String,
    /// What was last stored.
    stored: Option<autosave::Mark>,
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
            closing: false,
            title: String::new(),
            stored: None,
        }
    }

    /// Whether a dialog is open; a second one would hide behind it.
    pub(super) fn is_asking(&self) -> bool {
        self.asking.is_some()
    }

    /// Closes the dialog of an errand, if it is open. The document that it was
    /// opened for.
    fn answered(&mut self, errand: Errand) -> Option<u64> {
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

/// Puts something in the place of the document, after asking where unsaved
/// work would be lost.
pub fn request(state: &mut State, intent: Intent, ctx: &Context) {
    if state.document.holds_work() {
        state.sheets.guard = Some(intent);
    } else {
        carry_out(state, intent, ctx);
    }
}

/// A scene that is begun in the window: the paper's robot with nothing around
/// it, whose whole body may touch. The paper lets only nodes touch; whoever puts
/// an obstacle between them would see it pass through the robot.
pub fn blank() -> Scene {
    let mut scene = Scene::default();
    scene.contact.candidates = Candidates::Body;
    scene
}

/// Puts something in the place of the document, whatever becomes of it.
pub fn carry_out(state: &mut State, intent: Intent, ctx: &Context) {
    match intent {
        Intent::New => open::arrive(state, Arrival::of(blank())),
        Intent::Scene(arrival) => open::arrive(state, *arrival),
        Intent::Close => {
            state.files.closing = true;
            ctx.send_viewport_cmd(ViewportCommand::Close);
        }
    }
    ctx.request_repaint();
}

/// Asks for a file. What it would replace is guarded once it is read: whoever
/// changes their mind, or chooses a broken file, is not asked in vain.
pub fn pick(state: &mut State, errand: Errand) {
    if state.files.is_asking() {
        return;
    }
    ask(state, errand);
    let folder = folder(state);
    state.files.platform.pick(errand, folder.as_deref());
}

/// Notes that a dialog is open.
fn ask(state: &mut State, errand: Errand) {
    let opened = state.opened;
    state.files.asking = Some(Asked { errand, opened });
}

/// Which way the scene is saved.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Saving {
    /// To its own file, if it has one.
    InPlace,
    /// To a file that the user is to choose.
    As,
}

/// Saves the scene, and does something more when it is saved.
pub fn save(state: &mut State, how: Saving, then: Option<Intent>) {
    if state.files.is_asking() || state.files.saving.is_some() {
        return;
    }
    let scene = state.document.scene.clone();
    state.files.saving = Some(Saved {
        scene: scene.clone(),
        opened: state.opened,
        then,
    });
    let keeps_paths = state.files.platform.keeps_paths();
    let to = match (&state.document.file, how) {
        (Some(path), Saving::InPlace) if keeps_paths => Destination::Known(path.clone()),
        _ => Destination::Ask {
            name: file_name(state, "toml"),
            folder: folder(state),
        },
    };
    if matches!(to, Destination::Ask { .. }) {
        ask(state, Errand::Save);
    }
    let contents = Box::new(move |path: &Path| {
        let scene = photo_path::as_kept_in(&scene, path.parent());
        let text = scene.to_toml().map_err(|fault| fault.to_string())?;
        Ok(text.into_bytes())
    });
    state.files.platform.write(Errand::Save, to, contents);
}

/// Meets what the system has sent.
pub fn arrive(state: &mut State, ctx: &Context) {
    while let Some(news) = state.files.platform.poll() {
        meet(state, news, ctx);
    }
}

fn meet(state: &mut State, news: News, ctx: &Context) {
    match news {
        News::Read {
            errand,
            path,
            bytes,
        } => {
            let asked = state.files.answered(errand);
            let is_late = asked.is_some_and(|opened| opened != state.opened);
            match errand {
                Errand::Measurements | Errand::Photo if is_late => too_late(state, &path),
                Errand::Scene => open::scene_file(state, path, &bytes, ctx),
                Errand::Measurements => super::measured::import(state, &path, &bytes),
                Errand::Photo | Errand::KnownPhoto => {
                    super::photo::take(state, errand, path, bytes);
                }
                Errand::Save | Errand::Picture(_) | Errand::Table => {}
            }
        }
        News::Written { errand, path } => {
            state.files.answered(errand);
            let told = format!("Saved {}", shown(&path));
            state.notices.tell(Notice::success(told));
            if errand == Errand::Save
                && let Some(intent) = saved(state, path)
            {
                // What has changed since is guarded again.
                request(state, intent, ctx);
            }
        }
        News::Failed {
            errand,
            path,
            reason,
        } => {
            state.files.answered(errand);
            failed(state, errand, path, reason);
        }
        News::Cancelled(errand) => {
            state.files.answered(errand);
            if errand == Errand::Save {
                state.files.saving = None;
            }
        }
    }
}

/// Notes that the document is kept in a file, if it is still the one that was
/// written. What is to follow.
fn saved(state: &mut State, path: PathBuf) -> Option<Intent> {
    state.files.remember(&path);
    let saved = state.files.saving.take()?;
    if saved.opened == state.opened {
        state.document.mark_kept_as(saved.scene);
        state.document.file = Some(path);
        return saved.then;
    }
    if state.document.file.as_ref() == Some(&path) {
        // The other document was written over what this one was opened from.
        state.document.mark_unkept();
    }
    None
}

/// Says that what was chosen for another document is not taken.
pub fn too_late(state: &mut State, path: &Path) {
    let name = shown(path);
    let told = format!("{name} was chosen for the scene before this one and is left out.");
    state.notices.tell(Notice::trouble(told));
}

fn failed(state: &mut State, errand: Errand, path: Option<PathBuf>, reason: String) {
    let name = match &path {
        Some(path) => shown(path),
        None => format!("The {}", errand.noun()),
    };
    match errand {
        Errand::KnownPhoto => {
            super::photo::missing(state, path, reason);
            return;
        }
        Errand::Save => {
            state.files.saving = None;
        }
        Errand::Scene => {
            // What cannot be opened is no longer offered.
            state
                .files
                .recent
                .retain(|known| Some(known) != path.as_ref());
        }
        _ => {}
    }
    let title = match errand {
        Errand::Save | Errand::Picture(_) => format!("{name} is not saved"),
        _ => format!("{name} cannot be opened"),
    };
    let reason = sentence(&reason);
    state.sheets.show(match errand {
        Errand::Save => Sheet::trouble(title, vec![reason])
            .with("Your work is still here. Save it in another place:")
            .offering("Save as …", super::commands::Command::SaveAs),
        Errand::Scene => Sheet::trouble(title, vec![reason])
            .offering("Open another …", super::commands::Command::Open),
        _ => Sheet::trouble(title, vec![reason]),
    });
}

/// The folder that dialogs start in.
fn folder(state: &State) -> Option<PathBuf> {
    let file = state.document.file.as_ref().or(state.files.recent.first());
    file.and_then(|file| file.parent()).map(Path::to_owned)
}

/// A file's name for what is in the window, with an ending.
pub fn file_name(state: &State, ending: &str) -> String {
    let stem = match &state.document.file {
        Some(file) => file
            .file_stem()
            .map(|stem| stem.to_string_lossy().into_owned()),
        None => state.document.scene.title.as_deref().map(plain),
    };
    let stem = stem.filter(|stem| !stem.is_empty());
    format!("{}.{ending}", stem.as_deref().unwrap_or("scene"))
}

/// A title in letters that every file system takes.
fn plain(title: &str) -> String {
    let words = title.split(|c: char| !c.is_alphanumeric());
    let words: Vec<String> = words
        .filter(|word| !word.is_empty())
        .map(str::to_lowercase)
        .collect();
    words.join("-").chars().take(60).collect()
}

/// Tells the system what the window is called, where that has changed.
pub fn title(state: &mut State, ctx: &Context) {
    let changed = if state.document.is_changed() {
        "• "
    } else {
        ""
    };
    let title = format!("{changed}{} – Sinew", state.document.name());
    if title != state.files.title {
        ctx.send_viewport_cmd(ViewportCommand::Title(title.clone()));
        state.files.title = title;
    }
}

/// Keeps the window open where closing it would lose work, and asks.
pub fn guard_closing(state: &mut State, ctx: &Context) {
    if !ctx.input(|input| input.viewport().close_requested()) {
        return;
    }
    if state.document.holds_work() && !state.files.closing {
        ctx.send_viewport_cmd(ViewportCommand::CancelClose);
        state.sheets.guard = Some(Intent::Close);
    } else {
        state.files.closing = true;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn titles_become_names_of_files() {
        let check = |title, expect: &str| assert_eq!(plain(title), expect);
        check("Two discs (Fig. 4b)", "two-discs-fig-4b");
        check("../..\\:*?", "");
        check("Größe 3 µm", "größe-3-µm");
    }
}
