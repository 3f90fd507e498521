//! Photographs behind the robot: fetched, decoded, kept as textures by their
//! files, so that undo and redo need nothing again. Where one lies is the
//! scene's ([`crate::scene::Photo`]).

mod place;

pub use place::{Scaling, interact, outline, paint};

use super::files;
use super::pixels::Decoded;
use super::platform::Errand;
use super::sheets::Sheet;
use super::state::{Selection, State};
use super::words::{sentence, shown};
use crate::scene::{Photo, limits};
use crate::units::millimetres;
use crate::view::Bounds;
use eframe::egui::{Context, TextureHandle, TextureOptions};
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::mpsc::{Receiver, TryRecvError, channel};

/// How much of a new photograph shows.
const OPACITY: f64 = 0.6;

/// What is known of a photograph's file.
pub enum Photograph {
    /// It is being read.
    Coming,
    /// It is here.
    Here {
        /// Its pixels, perhaps fewer than in the file.
        texture: TextureHandle,
        /// Width and height in the file, in pixels.
        size: [u32; 2],
    },
    /// It cannot be shown, for this reason.
    Missing(String),
}

/// The photographs that were seen.
#[derive(Default)]
pub struct Photos {
    known: BTreeMap<PathBuf, Photograph>,
    coming: Vec<Coming>,
    /// The scale tool, while it is in the hand.
    pub scaling: Option<Scaling>,
    /// Where the photograph is held while it is dragged, from its centre, in
    /// metres.
    held: Option<crate::geometry::Vector>,
}

/// A photograph that is being decoded.
struct Coming {
    errand: Errand,
    /// The document that it was chosen for, see [`State::opened`].
    opened: u64,
    path: PathBuf,
    result: Receiver<Result<Decoded, String>>,
}

impl Photos {
    /// What is known of a photograph.
    pub fn get(&self, photo: &Photo) -> Option<&Photograph> {
        self.known.get(Path::new(&photo.file))
    }

    /// Height over width, where it is known.
    fn ratio(&self, photo: &Photo) -> Option<f64> {
        match self.get(photo)? {
            Photograph::Here { size, .. } => Some(f64::from(size[1]) / f64::from(size[0])),
            _ => None,
        }
    }
}

/// Reads the photograph that the scene names; one that is known stays until
/// it has been read anew.
pub fn fetch(state: &mut State) {
    let Some(photo) = &state.document.scene.photo else {
        return;
    };
    let path = PathBuf::from(&photo.file);
    let known = &mut state.photos.known;
    match known.get(&path) {
        Some(Photograph::Coming) => return,
        Some(Photograph::Here { .. }) => {}
        Some(Photograph::Missing(_)) | None => {
            known.insert(path.clone(), Photograph::Coming);
        }
    }
    state.files.platform.read(Errand::KnownPhoto, path);
}

/// Takes a photograph's bytes and decodes them while the window goes on.
pub fn take(state: &mut State, errand: Errand, path: PathBuf, bytes: Vec<u8>) {
    let (sender, result) = channel();
    state.photos.coming.push(Coming {
        errand,
        opened: state.opened,
        path,
        result,
    });
    let give = Box::new(move |decoded| {
        // Nobody listens only when the window is gone.
        let _ = sender.send(decoded);
    });
    state.files.platform.decode(bytes, give);
}

/// Notes that the photograph that the scene names cannot be read.
pub fn missing(state: &mut State, path: Option<PathBuf>, reason: String) {
    if let Some(path) = path {
        state
            .photos
            .known
            .insert(path, Photograph::Missing(sentence(&reason)));
    }
}

/// Takes the photographs that have been decoded.
pub fn arrive(state: &mut State, ctx: &Context) {
    let mut coming = std::mem::take(&mut state.photos.coming);
    coming.retain(|one| match one.result.try_recv() {
        Err(TryRecvError::Empty) => true,
        Err(TryRecvError::Disconnected) => {
            let reason = "decoding it has failed".to_owned();
            arrived(state, one, Err(reason), ctx);
            false
        }
        Ok(result) => {
            arrived(state, one, result, ctx);
            false
        }
    });
    coming.append(&mut state.photos.coming);
    state.photos.coming = coming;
}

fn arrived(state: &mut State, one: &Coming, result: Result<Decoded, String>, ctx: &Context) {
    let (errand, path) = (one.errand, &*one.path);
    if errand == Errand::Photo && one.opened != state.opened {
        files::too_late(state, path);
        return;
    }
    match result {
        Ok(Decoded { image, size }) => {
            let name = path.to_string_lossy();
            let texture = ctx.load_texture(name, image, TextureOptions::LINEAR);
            // Before the file is known: whether one is waiting for a picture.
            let waiting = state.document.scene.photo.clone().filter(|photo| {
                matches!(state.photos.get(photo), Some(Photograph::Missing(_)) | None)
            });
            let here = Photograph::Here { texture, size };
            state.photos.known.insert(path.to_owned(), here);
            if errand == Errand::Photo {
                lay(state, path, size, waiting);
            }
        }
        Err(reason) if errand == Errand::Photo => {
            let title = format!("{} cannot be laid behind the robot", shown(path));
            let trouble = Sheet::trouble(title, vec![sentence(&reason)])
                .with("Nothing has changed here. Choose another picture:")
                .offering("Choose …", super::Command::PlacePhoto);
            state.sheets.show(trouble);
        }
        Err(reason) => missing(state, Some(path.to_owned()), reason),
    }
}

/// Lays a photograph behind the robot: over everything, or in the place of
/// one that could not be shown.
fn lay(state: &mut State, path: &Path, size: [u32; 2], waiting: Option<Photo>) {
    let file = path.to_string_lossy().into_owned();
    let photo = match waiting {
        Some(place) => Photo { file, ..place },
        None => over(&state.live.drawing().bounds, file, size),
    };
    state.document.scene.photo = Some(photo);
    state.selection = Selection::Photo;
    let told = format!("Laid {} behind the robot", shown(path));
    state.notices.tell(super::notices::Notice::success(told));
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
