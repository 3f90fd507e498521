//! Photographs behind the robot: fetched, decoded, kept as textures by their
//! files, so that undo and redo need nothing again. Where one lies is the
//! scene's ([`crate::scene::Photo`]).

use super::commands::Command;
use super::pixels::Decoded;
use super::platform::Errand;
use super::words::{self, sentence, shown};
use super::workbench::{Coming, Notice, Photograph, Selection, Trouble, Workbench};
use crate::scene::{Photo, limits};
use crate::units::millimetres;
use crate::view::Bounds;
use eframe::egui::{Context, TextureOptions};
use std::path::{Path, PathBuf};
use std::sync::mpsc::{TryRecvError, channel};

/// How much of a new photograph shows.
const OPACITY: f64 = 0.6;

/// Reads the photograph that the scene names; one that is known stays until
/// it has been read anew.
pub fn fetch(bench: &mut Workbench) {
    let Some(photo) = &bench.document.scene.photo else {
        return;
    };
    let path = PathBuf::from(&photo.file);
    let known = &mut bench.photos.known;
    match known.get(&path) {
        Some(Photograph::Coming) => return,
        Some(Photograph::Here { .. }) => {}
        Some(Photograph::Missing(_)) | None => {
            known.insert(path.clone(), Photograph::Coming);
        }
    }
    bench.files.platform.read(Errand::KnownPhoto, path);
}

/// Takes a photograph's bytes and decodes them while the window goes on.
pub fn take(bench: &mut Workbench, errand: Errand, path: PathBuf, bytes: Vec<u8>) {
    let (sender, result) = channel();
    bench.photos.coming.push(Coming {
        errand,
        opened: bench.opened,
        path,
        result,
    });
    let give = Box::new(move |decoded| {
        // Nobody listens only when the window is gone.
        let _ = sender.send(decoded);
    });
    bench.files.platform.decode(bytes, give);
}

/// Notes that the photograph that the scene names cannot be read.
pub fn missing(bench: &mut Workbench, path: Option<PathBuf>, reason: String) {
    if let Some(path) = path {
        bench
            .photos
            .known
            .insert(path, Photograph::Missing(sentence(&reason)));
    }
}

/// Takes the photographs that have been decoded.
pub fn arrive(bench: &mut Workbench, ctx: &Context) {
    let mut coming = std::mem::take(&mut bench.photos.coming);
    coming.retain(|one| match one.result.try_recv() {
        Err(TryRecvError::Empty) => true,
        Err(TryRecvError::Disconnected) => {
            let reason = "decoding it has failed".to_owned();
            arrived(bench, one, Err(reason), ctx);
            false
        }
        Ok(result) => {
            arrived(bench, one, result, ctx);
            false
        }
    });
    coming.append(&mut bench.photos.coming);
    bench.photos.coming = coming;
}

fn arrived(bench: &mut Workbench, one: &Coming, result: Result<Decoded, String>, ctx: &Context) {
    let (errand, path) = (one.errand, &*one.path);
    if errand == Errand::Photo && one.opened != bench.opened {
        bench.notices.tell(Notice::trouble(words::too_late(path)));
        return;
    }
    match result {
        Ok(Decoded { image, size }) => {
            let name = path.to_string_lossy();
            let texture = ctx.load_texture(name, image, TextureOptions::LINEAR);
            // Before the file is known: whether one is waiting for a picture.
            let waiting = bench.document.scene.photo.clone().filter(|photo| {
                matches!(bench.photos.get(photo), Some(Photograph::Missing(_)) | None)
            });
            let here = Photograph::Here { texture, size };
            bench.photos.known.insert(path.to_owned(), here);
            if errand == Errand::Photo {
                lay(bench, path, size, waiting);
            }
        }
        Err(reason) if errand == Errand::Photo => {
            let title = format!("{} cannot be laid behind the robot", shown(path));
            let trouble = Trouble::new(title, vec![sentence(&reason)])
                .with("Nothing has changed here. Choose another picture:")
                .offering("Choose …", Command::PlacePhoto);
            bench.trouble = Some(trouble);
        }
        Err(reason) => missing(bench, Some(path.to_owned()), reason),
    }
}

/// Lays a photograph behind the robot: over everything, or in the place of
/// one that could not be shown.
fn lay(bench: &mut Workbench, path: &Path, size: [u32; 2], waiting: Option<Photo>) {
    let file = path.to_string_lossy().into_owned();
    let photo = match waiting {
        Some(place) => Photo { file, ..place },
        None => over(&bench.live.drawing().bounds, file, size),
    };
    bench.document.scene.photo = Some(photo);
    bench.selection = Selection::Photo;
    let told = format!("Laid {} behind the robot", shown(path));
    bench.notices.tell(Notice::success(told));
}

/// A photograph that covers a box.
fn over(bounds: &Bounds, file: String, size: [u32; 2]) -> Photo {
    let ratio = f64::from(size[0]) / f64::from(size[1]);
    let room = bounds.size();
    let width = millimetres(room.x.max(room.y * ratio));
    let centre = bounds.centre();
    Photo {
        file,
        center_mm: [millimetres(centre.x), millimetres(centre.y)],
        width_mm: width.clamp(limits::PHOTO_WIDTH.min, limits::PHOTO_WIDTH.max),
        rotation_deg: 0.0,
        opacity: OPACITY,
    }
}
