//! The document's files: opening, saving, recent ones, and the guard in front
//! of whatever would throw unsaved work away.
//!
//! An [`Intent`] says what is to take the place of the document. [`request`]
//! carries it out at once, or asks first where there is unsaved work. Files
//! come and go through the [`Platform`]; what comes of them is met in
//! [`arrive`].
//!
//! [`Platform`]: super::platform::Platform

pub mod autosave;
mod drop;
pub mod export;
mod open;
mod photo_path;

pub use drop::{Dropped, announce, take_drops, take_pastes};
pub use open::scene_from;

use super::platform::{Destination, Errand, News};
use super::words::{self, sentence, shown};
use super::workbench::{Arrival, Asked, Intent, Notice, Saved, Trouble, Workbench};
use crate::scene::{Candidates, Mechanics, Scene};
use eframe::egui::{Context, ViewportCommand};
use std::path::{Path, PathBuf};

/// Puts something in the place of the document, after asking where unsaved
/// work would be lost.
pub fn request(bench: &mut Workbench, intent: Intent, ctx: &Context) {
    if bench.document.holds_work() {
        bench.files.guarded = Some(intent);
    } else {
        carry_out(bench, intent, ctx);
    }
}

/// The bending stiffness of a robot that is begun in the window, in N mm²: that
/// of a rod of ABS, 3 mm thick.
const STIFFNESS_NMM2: f64 = 8000.0;

/// A scene that is begun in the window: the paper's robot with nothing around
/// it, its cable sliding, its stiffness known, so that what it presses with is
/// told in grams. Its whole body may touch: the paper lets only nodes touch, and
/// whoever puts an obstacle between them would see it pass through the robot.
pub fn blank() -> Scene {
    let mut scene = Scene::default();
    scene.model.mechanics = Mechanics::Sliding;
    scene.robot.bending_stiffness_nmm2 = Some(STIFFNESS_NMM2);
    scene.contact.candidates = Candidates::Body;
    scene
}

/// Puts something in the place of the document, whatever becomes of it.
pub fn carry_out(bench: &mut Workbench, intent: Intent, ctx: &Context) {
    match intent {
        Intent::New => open::arrive(bench, Arrival::of(blank())),
        Intent::Scene(arrival) => open::arrive(bench, *arrival),
        Intent::Close => {
            bench.files.closing = true;
            ctx.send_viewport_cmd(ViewportCommand::Close);
        }
    }
    ctx.request_repaint();
}

/// Asks for a file. What it would replace is guarded once it is read: whoever
/// changes their mind, or chooses a broken file, is not asked in vain.
pub fn pick(bench: &mut Workbench, errand: Errand) {
    if bench.files.is_asking() {
        return;
    }
    ask(bench, errand);
    let folder = folder(bench);
    bench.files.platform.pick(errand, folder.as_deref());
}

/// Takes the path that was typed where the system has no dialog; none gives the errand
/// up.
pub fn typed(bench: &mut Workbench, path: Option<PathBuf>) {
    let Some((errand, _)) = bench.files.typing.take() else {
        return;
    };
    bench.files.platform.answer(errand, path);
}

/// Reads a scene's file that is known already, to be opened like one that was
/// picked.
pub fn reopen(bench: &mut Workbench, path: PathBuf) {
    bench.files.platform.read(Errand::Scene, path);
}

/// Notes that a dialog is open.
fn ask(bench: &mut Workbench, errand: Errand) {
    let opened = bench.opened;
    bench.files.asking = Some(Asked { errand, opened });
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
pub fn save(bench: &mut Workbench, how: Saving, then: Option<Intent>) {
    if bench.files.is_asking() || bench.files.saving.is_some() {
        return;
    }
    let scene = bench.document.scene.clone();
    bench.files.saving = Some(Saved {
        scene: scene.clone(),
        opened: bench.opened,
        then,
    });
    let keeps_paths = bench.files.platform.keeps_paths();
    let to = match (&bench.document.file, how) {
        (Some(path), Saving::InPlace) if keeps_paths => Destination::Known(path.clone()),
        _ => Destination::Ask {
            name: file_name(bench, "toml"),
            folder: folder(bench),
        },
    };
    if matches!(to, Destination::Ask { .. }) {
        ask(bench, Errand::Save);
    }
    let contents = Box::new(move |path: &Path| {
        let scene = photo_path::as_kept_in(&scene, path.parent());
        let text = scene.to_toml().map_err(|fault| fault.to_string())?;
        Ok(text.into_bytes())
    });
    bench.files.platform.write(Errand::Save, to, contents);
}

/// Meets what the system has sent.
pub fn arrive(bench: &mut Workbench, ctx: &Context) {
    while let Some(news) = bench.files.platform.poll() {
        meet(bench, news, ctx);
    }
}

fn meet(bench: &mut Workbench, news: News, ctx: &Context) {
    match news {
        News::Read {
            errand,
            path,
            bytes,
        } => {
            let asked = bench.files.answered(errand);
            let is_late = asked.is_some_and(|opened| opened != bench.opened);
            match errand {
                Errand::Measurements | Errand::Photo if is_late => {
                    bench.notices.tell(Notice::trouble(words::too_late(&path)))
                }
                Errand::Scene => open::scene_file(bench, path, &bytes, ctx),
                Errand::Measurements => super::measured::import(bench, &path, &bytes),
                Errand::Photo | Errand::KnownPhoto => {
                    super::photo::take(bench, errand, path, bytes);
                }
                Errand::Save | Errand::Picture(_) | Errand::Table => {}
            }
        }
        News::Written { errand, path } => {
            bench.files.answered(errand);
            let told = format!("Saved {}", shown(&path));
            bench.notices.tell(Notice::success(told));
            if errand == Errand::Save
                && let Some(intent) = saved(bench, path)
            {
                // What has changed since is guarded again.
                request(bench, intent, ctx);
            }
        }
        News::Failed {
            errand,
            path,
            reason,
        } => {
            bench.files.answered(errand);
            failed(bench, errand, path, reason);
        }
        News::Cancelled(errand) => {
            bench.files.answered(errand);
            if errand == Errand::Save {
                bench.files.saving = None;
            }
        }
        News::NoDialog { errand, suggested } => {
            bench.files.typing = Some((errand, suggested.to_string_lossy().into_owned()));
        }
    }
}

/// Notes that the document is kept in a file, if it is still the one that was
/// written. What is to follow.
fn saved(bench: &mut Workbench, path: PathBuf) -> Option<Intent> {
    bench.files.remember(&path);
    let saved = bench.files.saving.take()?;
    if saved.opened == bench.opened {
        bench.document.mark_kept_as(saved.scene);
        bench.document.file = Some(path);
        return saved.then;
    }
    if bench.document.file.as_ref() == Some(&path) {
        // The other document was written over what this one was opened from.
        bench.document.mark_unkept();
    }
    None
}

fn failed(bench: &mut Workbench, errand: Errand, path: Option<PathBuf>, reason: String) {
    let name = match &path {
        Some(path) => shown(path),
        None => format!("The {}", errand.noun()),
    };
    match errand {
        Errand::KnownPhoto => {
            super::photo::missing(bench, path, reason);
            return;
        }
        Errand::Save => {
            bench.files.saving = None;
        }
        Errand::Scene => {
            // What cannot be opened is no longer offered.
            bench
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
    bench.trouble = Some(match errand {
        Errand::Save => Trouble::new(title, vec![reason])
            .with("Your work is still here. Save it in another place:")
            .offering("Save as …", super::commands::Command::SaveAs),
        Errand::Scene => Trouble::new(title, vec![reason])
            .offering("Open another …", super::commands::Command::Open),
        _ => Trouble::new(title, vec![reason]),
    });
}

/// The folder that dialogs start in.
fn folder(bench: &Workbench) -> Option<PathBuf> {
    let file = bench.document.file.as_ref().or(bench.files.recent.first());
    file.and_then(|file| file.parent()).map(Path::to_owned)
}

/// A file's name for what is in the window, with an ending.
pub fn file_name(bench: &Workbench, ending: &str) -> String {
    let stem = match &bench.document.file {
        Some(file) => file
            .file_stem()
            .map(|stem| stem.to_string_lossy().into_owned()),
        None => bench.document.scene.title.as_deref().map(plain),
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
pub fn title(bench: &mut Workbench, ctx: &Context) {
    let changed = if bench.document.is_changed() {
        "• "
    } else {
        ""
    };
    let title = format!("{changed}{} – Sinew", bench.document.name());
    if title != bench.files.title {
        ctx.send_viewport_cmd(ViewportCommand::Title(title.clone()));
        bench.files.title = title;
    }
}

/// Keeps the window open where closing it would lose work, and asks.
pub fn guard_closing(bench: &mut Workbench, ctx: &Context) {
    if !ctx.input(|input| input.viewport().close_requested()) {
        return;
    }
    if bench.document.holds_work() && !bench.files.closing {
        ctx.send_viewport_cmd(ViewportCommand::CancelClose);
        bench.files.guarded = Some(Intent::Close);
    } else {
        bench.files.closing = true;
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
