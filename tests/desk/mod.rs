//! A system in memory around a window: files, answers to its dialogs, what it
//! stores and what it keeps.

use eframe::egui::{DroppedFile, DroppedFileHandle};
use sinew::app::platform::{Contents, Destination, Errand, Left, News, Platform};
use std::collections::{BTreeMap, VecDeque};
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex};

/// The files, and what is to happen next. Clones are the same desk, each for a
/// window of its own.
#[derive(Default)]
pub struct Desk {
    inner: Arc<Mutex<Inner>>,
    /// Which of the clones it is.
    window: usize,
}

impl Clone for Desk {
    fn clone(&self) -> Self {
        let inner = Arc::clone(&self.inner);
        let mut locked = inner.lock().unwrap();
        locked.windows += 1;
        let window = locked.windows;
        drop(locked);
        Self { inner, window }
    }
}

/// However a window ends, what it has kept is anybody's.
impl Drop for Desk {
    fn drop(&mut self) {
        for drawer in &mut self.inner.lock().unwrap().drawers {
            drawer.holder = drawer.holder.filter(|holder| *holder != self.window);
        }
    }
}

/// What a window has kept, and whose it is.
struct Drawer {
    owner: usize,
    holder: Option<usize>,
    work: String,
}

#[derive(Default)]
struct Inner {
    files: BTreeMap<PathBuf, Vec<u8>>,
    answers: VecDeque<Option<PathBuf>>,
    offered: Vec<String>,
    news: VecDeque<News>,
    drawers: Vec<Drawer>,
    windows: usize,
    full: bool,
    /// Whether dialogs stay open.
    waiting: bool,
    /// Whether there are none.
    mute: bool,
    /// What waits for their answers.
    asked: Vec<(Errand, Option<Contents>)>,
}

impl Desk {
    /// Puts a file there.
    pub fn put(&self, path: &str, bytes: impl Into<Vec<u8>>) {
        let mut inner = self.inner.lock().unwrap();
        inner.files.insert(path.into(), bytes.into());
    }

    /// Takes a file away.
    pub fn remove(&self, path: &str) {
        self.inner.lock().unwrap().files.remove(Path::new(path));
    }

    /// What a file holds.
    pub fn get(&self, path: &str) -> Option<Vec<u8>> {
        let inner = self.inner.lock().unwrap();
        inner.files.get(Path::new(path)).cloned()
    }

    /// What a file holds, as text.
    pub fn text(&self, path: &str) -> String {
        String::from_utf8(self.get(path).unwrap()).unwrap()
    }

    /// The next dialog will be answered like this.
    pub fn answer(&self, path: Option<&str>) {
        let answer = path.map(PathBuf::from);
        self.inner.lock().unwrap().answers.push_back(answer);
    }

    /// From now on dialogs stay open.
    pub fn take_its_time(&self) {
        self.inner.lock().unwrap().waiting = true;
    }

    /// Answers the dialog that has been open longest.
    pub fn answer_now(&self, path: &str) {
        let mut inner = self.inner.lock().unwrap();
        let (errand, contents) = inner.asked.remove(0);
        match contents {
            Some(contents) => inner.write(errand, path.into(), contents),
            None => inner.read(errand, path.into()),
        }
    }

    /// From now on there are no dialogs.
    pub fn lose_dialogs(&self) {
        self.inner.lock().unwrap().mute = true;
    }

    /// How many dialogs are open.
    pub fn open_dialogs(&self) -> usize {
        self.inner.lock().unwrap().asked.len()
    }

    /// Puts something where a window that is gone has kept its work.
    pub fn leave(&self, work: &str) {
        let mut window = self.clone();
        window.keep(Some(work.to_owned()));
    }

    /// The names that dialogs have offered for saving.
    pub fn offered(&self) -> Vec<String> {
        self.inner.lock().unwrap().offered.clone()
    }

    /// From now on nothing can be written.
    pub fn fill_up(&self) {
        self.inner.lock().unwrap().full = true;
    }

    /// A file as it is dropped on a window.
    pub fn dropped(&self, path: &str) -> DroppedFileHandle {
        let bytes = self.get(path).unwrap();
        let path = path.into();
        Arc::new(Falling { path, bytes })
    }
}

impl Inner {
    fn read(&mut self, errand: Errand, path: PathBuf) {
        let news = match self.files.get(&path).cloned() {
            None => Err("it is not there any more".to_owned()),
            Some(bytes) => match errand.too_large(bytes.len() as u64) {
                Some(reason) => Err(reason),
                None => Ok(bytes),
            },
        };
        self.news.push_back(match news {
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
        });
    }

    fn write(&mut self, errand: Errand, path: PathBuf, contents: Contents) {
        let written = if self.full {
            Err("the disk is full".to_owned())
        } else {
            contents(&path)
        };
        let news = match written {
            Ok(bytes) => {
                self.files.insert(path.clone(), bytes);
                News::Written { errand, path }
            }
            Err(reason) => News::Failed {
                errand,
                path: Some(path),
                reason,
            },
        };
        self.news.push_back(news);
    }

    fn answered(&mut self, errand: Errand) -> Option<PathBuf> {
        let answer = self.answers.pop_front().expect("a dialog nobody foresaw");
        if answer.is_none() {
            self.news.push_back(News::Cancelled(errand));
        }
        answer
    }
}

impl Platform for Desk {
    fn pick(&mut self, errand: Errand, _folder: Option<&Path>) {
        let mut inner = self.inner.lock().unwrap();
        if inner.mute {
            let suggested = PathBuf::from("/home/");
            inner.news.push_back(News::NoDialog { errand, suggested });
        } else if inner.waiting {
            inner.asked.push((errand, None));
        } else if let Some(path) = inner.answered(errand) {
            inner.read(errand, path);
        }
    }

    fn answer(&mut self, errand: Errand, path: Option<PathBuf>) {
        let mut inner = self.inner.lock().unwrap();
        match (path, inner.asked.pop()) {
            (None, _) => inner.news.push_back(News::Cancelled(errand)),
            (Some(path), Some((_, Some(contents)))) => inner.write(errand, path, contents),
            (Some(path), _) => inner.read(errand, path),
        }
    }

    fn read(&mut self, errand: Errand, path: PathBuf) {
        self.inner.lock().unwrap().read(errand, path);
    }

    fn take(&mut self, errand: Errand, dropped: DroppedFileHandle) {
        let path = dropped.path().to_owned();
        self.inner.lock().unwrap().read(errand, path);
    }

    fn write(&mut self, errand: Errand, to: Destination, contents: Contents) {
        let mut inner = self.inner.lock().unwrap();
        let path = match to {
            Destination::Known(path) => path,
            Destination::Ask { name, .. } => {
                inner.offered.push(name.clone());
                if inner.mute {
                    inner.asked.push((errand, Some(contents)));
                    let suggested = PathBuf::from("/home").join(name);
                    inner.news.push_back(News::NoDialog { errand, suggested });
                    return;
                }
                if inner.waiting {
                    inner.asked.push((errand, Some(contents)));
                    return;
                }
                match inner.answered(errand) {
                    Some(path) => path,
                    None => return,
                }
            }
        };
        inner.write(errand, path, contents);
    }

    fn keep(&mut self, work: Option<String>) {
        let mut inner = self.inner.lock().unwrap();
        inner.drawers.retain(|drawer| drawer.owner != self.window);
        if let Some(work) = work {
            let owner = self.window;
            inner.drawers.push(Drawer {
                owner,
                holder: Some(owner),
                work,
            });
        }
    }

    fn left(&mut self) -> Vec<Left> {
        let mut inner = self.inner.lock().unwrap();
        let drawers = inner.drawers.iter_mut().rev();
        let free = drawers.filter(|drawer| drawer.holder.is_none());
        free.map(|drawer| {
            drawer.holder = Some(self.window);
            Left {
                drawer: drawer.owner.to_string(),
                work: drawer.work.clone(),
            }
        })
        .collect()
    }

    fn forget(&mut self, drawer: &str) {
        let mut inner = self.inner.lock().unwrap();
        inner.drawers.retain(|it| it.owner.to_string() != drawer);
    }

    fn poll(&mut self) -> Option<News> {
        self.inner.lock().unwrap().news.pop_front()
    }

    fn keeps_paths(&self) -> bool {
        true
    }
}

#[derive(Debug)]
struct Falling {
    path: PathBuf,
    bytes: Vec<u8>,
}

impl DroppedFile for Falling {
    fn path(&self) -> &Path {
        &self.path
    }

    fn bytes(&self) -> Result<Vec<u8>, String> {
        Ok(self.bytes.clone())
    }
}

/// What outlives a window.
#[derive(Clone, Debug, Default)]
pub struct Storage(pub BTreeMap<String, String>);

impl eframe::Storage for Storage {
    fn get_string(&self, key: &str) -> Option<String> {
        self.0.get(key).cloned()
    }

    fn set_string(&mut self, key: &str, value: String) {
        self.0.insert(key.to_owned(), value);
    }

    fn remove_string(&mut self, key: &str) {
        self.0.remove(key);
    }

    fn flush(&mut self) {}
}
