//! The desktop: its dialogs, its files, a thread for whatever takes time.

use super::drawers::Drawers;
use super::{Contents, Destination, Errand, Left, News, PictureKind, Platform, Taker};
use eframe::egui::{Context, DroppedFileHandle};
use rfd::AsyncFileDialog;
use std::fs::{self, File};
use std::io::{self, Read as _, Write as _};
use std::path::{Path, PathBuf};
use std::sync::mpsc::{Receiver, Sender, channel};
use std::sync::{Arc, Mutex};
use std::thread::Builder;
use std::time::{Duration, Instant};

/// The desktop around a window.
pub struct Native {
    ctx: Context,
    sender: Sender<News>,
    receiver: Receiver<News>,
    /// Not there where the system gives no place for them.
    drawers: Option<Drawers>,
    /// What is to be written as soon as it is known where, if there was no dialog.
    unplaced: Arc<Mutex<Option<Contents>>>,
}

/// A dialog that is answered with nothing within this time was none: a hand takes
/// longer. The system says no more than that it has failed.
const TOO_SOON: Duration = Duration::from_millis(250);

impl Native {
    /// The desktop around the window of a context; `folder` is where the
    /// program keeps what is its own.
    pub fn new(ctx: &Context, folder: Option<PathBuf>) -> Self {
        let (sender, receiver) = channel();
        let drawers = folder.and_then(|folder| {
            let opened = Drawers::open(folder.join("unsaved"));
            opened
                .inspect_err(|error| log::warn!("work that is not saved is not kept: {error}"))
                .ok()
        });
        Self {
            ctx: ctx.clone(),
            sender,
            receiver,
            drawers,
            unplaced: Arc::default(),
        }
    }

    /// Sends what comes of some work on a thread.
    fn run(&self, errand: Errand, work: impl FnOnce() -> News + Send + 'static) {
        let (sender, ctx) = (self.sender.clone(), self.ctx.clone());
        let started = Builder::new().name("files".to_owned()).spawn(move || {
            // Nobody listens only when the window is gone.
            let _ = sender.send(work());
            ctx.request_repaint();
        });
        if let Err(error) = started {
            let _ = self.sender.send(News::Failed {
                errand,
                path: None,
                reason: format!("the system gives no thread for it: {error}"),
            });
        }
    }
}

impl Platform for Native {
    fn pick(&mut self, errand: Errand, folder: Option<&Path>) {
        // Made here and not on the thread: macOS wants dialogs from the main one.
        let picked = dialog(errand, folder).pick_file();
        let suggested = folder.map(|folder| folder.join("")).unwrap_or_default();
        self.run(errand, move || {
            let opened = Instant::now();
            match pollster::block_on(picked) {
                Some(file) => read(errand, file.path().to_owned()),
                None if opened.elapsed() < TOO_SOON => News::NoDialog { errand, suggested },
                None => News::Cancelled(errand),
            }
        });
    }

    fn answer(&mut self, errand: Errand, path: Option<PathBuf>) {
        let unplaced = self.unplaced.lock().ok().and_then(|mut it| it.take());
        match (path, unplaced) {
            (None, _) => {
                // Nobody listens only when the window is gone.
                let _ = self.sender.send(News::Cancelled(errand));
            }
            (Some(path), Some(contents)) => {
                let path = with_ending(errand, &path);
                self.run(errand, move || write(errand, path, contents));
            }
            (Some(path), None) => self.read(errand, path),
        }
    }

    fn read(&mut self, errand: Errand, path: PathBuf) {
        self.run(errand, move || read(errand, path));
    }

    fn take(&mut self, errand: Errand, dropped: DroppedFileHandle) {
        self.read(errand, dropped.path().to_owned());
    }

    fn write(&mut self, errand: Errand, to: Destination, contents: Contents) {
        match to {
            Destination::Known(path) => self.run(errand, move || write(errand, path, contents)),
            Destination::Ask { name, folder } => {
                let suggested = folder.clone().unwrap_or_default().join(&name);
                let picked = dialog(errand, folder.as_deref()).set_file_name(name);
                let picked = picked.save_file();
                let unplaced = Arc::clone(&self.unplaced);
                self.run(errand, move || {
                    let opened = Instant::now();
                    match pollster::block_on(picked) {
                        Some(file) => write(errand, with_ending(errand, file.path()), contents),
                        None if opened.elapsed() < TOO_SOON => {
                            if let Ok(mut unplaced) = unplaced.lock() {
                                *unplaced = Some(contents);
                            }
                            News::NoDialog { errand, suggested }
                        }
                        None => News::Cancelled(errand),
                    }
                });
            }
        }
    }

    fn decode(&mut self, bytes: Vec<u8>, give: Taker) {
        let ctx = self.ctx.clone();
        let started = Builder::new().name("photo".to_owned()).spawn(move || {
            give(crate::app::pixels::decode(&bytes));
            ctx.request_repaint();
        });
        if let Err(error) = started {
            log::warn!("the system gives no thread: {error}");
        }
    }

    fn keep(&mut self, work: Option<String>) {
        if let Some(drawers) = &mut self.drawers {
            drawers.keep(work);
        }
    }

    fn left(&mut self) -> Vec<Left> {
        self.drawers.as_ref().map(Drawers::left).unwrap_or_default()
    }

    fn forget(&mut self, drawer: &str) {
        if let Some(drawers) = &mut self.drawers {
            drawers.forget(drawer);
        }
    }

    fn poll(&mut self) -> Option<News> {
        self.receiver.try_recv().ok()
    }

    fn keeps_paths(&self) -> bool {
        true
    }
}

fn dialog(errand: Errand, folder: Option<&Path>) -> AsyncFileDialog {
    let (title, kind) = match errand {
        Errand::Scene => ("Open a scene", "Scenes"),
        Errand::Measurements => ("Import measurements", "Tables"),
        Errand::Photo | Errand::KnownPhoto => ("Place a photograph", "Photographs"),
        Errand::Save => ("Save the scene", "Scenes"),
        Errand::Picture(PictureKind::Svg) => ("Export as SVG", "SVG pictures"),
        Errand::Picture(PictureKind::Png) => ("Export as PNG", "PNG pictures"),
        Errand::Table => ("Export as CSV", "Tables"),
    };
    let dialog = AsyncFileDialog::new()
        .set_title(title)
        .add_filter(kind, errand.endings());
    match folder {
        Some(folder) => dialog.set_directory(folder),
        None => dialog,
    }
}

/// The path with the errand's ending where the user gave none.
fn with_ending(errand: Errand, path: &Path) -> PathBuf {
    match (path.extension(), errand.endings().first()) {
        (None, Some(ending)) => path.with_extension(ending),
        _ => path.to_owned(),
    }
}

fn read(errand: Errand, path: PathBuf) -> News {
    match contents(errand, &path) {
        Ok(bytes) => News::Read {
            errand,
            path,
            bytes,
        },
        Err(reason) => News::Failed {
            errand,
            path: Some(path),
            reason,
        },
    }
}

fn contents(errand: Errand, path: &Path) -> Result<Vec<u8>, String> {
    let about = fs::metadata(path).map_err(|error| in_words(&error))?;
    if about.is_dir() {
        return Err("it is a folder; choose a file in it".to_owned());
    }
    if !about.is_file() {
        return Err("it is not an ordinary file".to_owned());
    }
    if let Some(reason) = errand.too_large(about.len()) {
        return Err(reason);
    }
    let mut bytes = Vec::new();
    let file = File::open(path).map_err(|error| in_words(&error))?;
    // A file may grow while it is read.
    let read = file.take(errand.most_bytes() + 1).read_to_end(&mut bytes);
    read.map_err(|error| in_words(&error))?;
    match errand.too_large(bytes.len() as u64) {
        Some(reason) => Err(reason),
        None => Ok(bytes),
    }
}

fn write(errand: Errand, path: PathBuf, contents: Contents) -> News {
    let written =
        contents(&path).and_then(|bytes| replace(&path, &bytes).map_err(|error| in_words(&error)));
    match written {
        Ok(()) => News::Written { errand, path },
        Err(reason) => News::Failed {
            errand,
            path: Some(path),
            reason,
        },
    }
}

/// Puts a file in the place of another in one step, so that a crash or a full
/// disk leaves one of the two whole.
pub(super) fn replace(path: &Path, bytes: &[u8]) -> io::Result<()> {
    // A link keeps pointing to where it does.
    let path = fs::canonicalize(path).unwrap_or_else(|_| path.to_owned());
    let name = path
        .file_name()
        .ok_or_else(|| io::Error::from(io::ErrorKind::InvalidInput))?;
    let mut beside = name.to_owned();
    beside.push(format!(".{}.part", std::process::id()));
    let beside = path.with_file_name(beside);
    let written = (|| {
        let mut file = File::create(&beside)?;
        file.write_all(bytes)?;
        file.sync_all()?;
        if let Ok(before) = fs::metadata(&path) {
            if before.permissions().readonly() {
                return Err(io::Error::from(io::ErrorKind::PermissionDenied));
            }
            fs::set_permissions(&beside, before.permissions())?;
        }
        fs::rename(&beside, &path)
    })();
    if written.is_err() {
        let _ = fs::remove_file(&beside);
    }
    written
}

/// An error of the system in words that say what to do.
pub fn in_words(error: &io::Error) -> String {
    match error.kind() {
        io::ErrorKind::NotFound => "it is not there any more".to_owned(),
        io::ErrorKind::IsADirectory => "it is a folder; choose a file in it".to_owned(),
        io::ErrorKind::PermissionDenied => {
            "you may not read or change it; choose another place, or ask whoever owns it".to_owned()
        }
        io::ErrorKind::StorageFull => {
            "the disk is full; make room or choose another place".to_owned()
        }
        io::ErrorKind::ReadOnlyFilesystem => {
            "that place cannot be written to; choose another".to_owned()
        }
        _ => without_number(&error.to_string()),
    }
}

/// An error of the system without its number, which says nothing to anyone.
fn without_number(text: &str) -> String {
    text.split(" (os error")
        .next()
        .unwrap_or(text)
        .to_lowercase()
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;

    /// A folder that is gone with the test.
    pub struct Folder(pub PathBuf);

    impl Folder {
        pub fn new(name: &str) -> Self {
            let folder = std::env::temp_dir().join(format!("sinew-{name}-{}", std::process::id()));
            fs::create_dir_all(&folder).unwrap();
            Self(folder)
        }
    }

    impl Drop for Folder {
        fn drop(&mut self) {
            let _ = fs::remove_dir_all(&self.0);
        }
    }

    #[test]
    fn a_file_is_replaced_whole_and_nothing_else_is_left() {
        let folder = Folder::new("replace");
        let path = folder.0.join("a.toml");
        replace(&path, b"one").unwrap();
        replace(&path, b"two").unwrap();
        assert_eq!(fs::read(&path).unwrap(), b"two");
        assert_eq!(fs::read_dir(&folder.0).unwrap().count(), 1);
        // A name that cannot be: the folder itself.
        assert!(replace(&folder.0, b"three").is_err());
        assert!(replace(&folder.0.join("no/such/folder.toml"), b"").is_err());
        assert_eq!(fs::read_dir(&folder.0).unwrap().count(), 1);
    }

    #[test]
    fn what_cannot_be_read_is_told_in_words() {
        let folder = Folder::new("read");
        let refusal = |path: &Path| contents(Errand::Scene, path).unwrap_err();
        assert!(refusal(&folder.0).contains("folder"));
        assert!(refusal(&folder.0.join("gone.toml")).contains("not there"));
        let large = folder.0.join("large.toml");
        File::create(&large).unwrap().set_len(5 << 20).unwrap();
        assert!(refusal(&large).contains("5.0 MB") && refusal(&large).contains("4 MB at most"));
        assert!(contents(Errand::Photo, &large).is_ok());
    }

    #[test]
    fn a_name_without_an_ending_gets_one() {
        let check = |errand, path: &str, expect: &str| {
            assert_eq!(with_ending(errand, Path::new(path)), Path::new(expect));
        };
        check(Errand::Save, "a", "a.toml");
        check(Errand::Save, "a.txt", "a.txt");
        check(Errand::Picture(PictureKind::Png), "b", "b.png");
    }
}
