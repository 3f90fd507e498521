//! A scene's way into the window: read, checked, put in the place of the
//! present one. One that cannot be solved changes nothing and is told with all
//! of its faults.

use super::{autosave, photo_path, request};
use crate::app::commands::Command;
use crate::app::words::{faults_of, shown};
use crate::app::workbench::{Arrival, Document, History, Intent, Notice, Trouble, Workbench};
use crate::scene::{Scene, SceneError};
use eframe::egui::Context;
use std::path::{Path, PathBuf};

/// The scene in a file's bytes, which can be solved.
///
/// # Errors
/// All of its faults that can be told: where the text is not even a scene, the
/// first one.
pub fn scene_from(bytes: &[u8], file: Option<&Path>) -> Result<Scene, Vec<SceneError>> {
    let scene = Scene::from_toml_bytes(bytes).map_err(|fault| vec![fault])?;
    let folder = file.and_then(Path::parent);
    let scene = photo_path::as_opened_from(scene, folder.filter(|f| !f.as_os_str().is_empty()));
    Document::new(scene.clone())?;
    Ok(scene)
}

/// Opens what a file holds, after asking where unsaved work would be lost.
pub(super) fn scene_file(bench: &mut Workbench, path: PathBuf, bytes: &[u8], ctx: &Context) {
    match scene_from(bytes, Some(&path)) {
        Ok(scene) => {
            let arrival = Arrival {
                scene,
                file: Some(path),
                told: None,
                kept: true,
                drawer: None,
            };
            request(bench, Intent::Scene(Box::new(arrival)), ctx);
        }
        Err(faults) => refuse(bench, &shown(&path), &faults),
    }
}

/// Says why a scene is not opened.
pub(super) fn refuse(bench: &mut Workbench, name: &str, faults: &[SceneError]) {
    let trouble = Trouble::new(format!("{name} cannot be opened"), faults_of(faults))
        .with("Nothing has changed here. Correct the file and open it again, or open another:")
        .offering("Open another …", Command::Open);
    bench.trouble = Some(trouble);
}

/// Puts a scene in the place of the present one.
pub(super) fn arrive(bench: &mut Workbench, arrival: Arrival) {
    let Arrival {
        scene,
        file,
        told,
        kept,
        drawer,
    } = arrival;
    let name = file
        .as_deref()
        .map_or_else(|| "The scene".to_owned(), shown);
    if let Err(faults) = bench.open(scene) {
        refuse(bench, &name, &faults);
        return;
    }
    if let Some(file) = file {
        // Undo must not lead to another file's scene under this one's name.
        bench.history = History::new(&bench.document.scene);
        bench.files.remember(&file);
        bench.document.file = Some(file);
    }
    if !kept {
        bench.document.mark_unkept();
    }
    if let Some(drawer) = drawer {
        // It is this window's to keep before it is no other's.
        autosave::keep(bench);
        autosave::forget(bench, &drawer);
    }
    bench.trouble = None;
    crate::app::photo::fetch(bench);
    if let Some(told) = told {
        bench.notices.tell(Notice::success(told));
    }
}
