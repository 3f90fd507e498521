//! Where windows on the desktop keep what is not saved: a drawer for each, in
//! a folder of the user's, so that none writes over another's.
//!
//! A drawer is a number: `3.lock`, which the drawer's window holds locked, and
//! `3.toml`, what it keeps. However a window ends, the system lets go of its
//! lock. Lock files stay where they are: taken away and made anew, one number
//! could be the drawer of two windows.

use super::{Left, native::replace};
use std::fs::{self, File, TryLockError};
use std::io;
use std::path::{Path, PathBuf};
use std::thread::{Builder, JoinHandle};

/// The drawers as one window sees them.
pub struct Drawers {
    folder: PathBuf,
    mine: Drawer,
    /// What is in it.
    kept: Option<String>,
    /// Those of windows that are gone, as long as nobody has decided.
    left: Vec<Drawer>,
    /// The last writing, which may still go on.
    writing: Option<JoinHandle<()>>,
}

/// A drawer that this window holds, until this is dropped.
struct Drawer {
    number: u32,
    _lock: File,
}

impl Drawers {
    /// The drawers in a folder, one of which is this window's from now on. So
    /// are those with something in them that no window holds.
    ///
    /// # Errors
    /// When there can be no such folder, or no drawer in it.
    pub fn open(folder: PathBuf) -> io::Result<Self> {
        fs::create_dir_all(&folder)?;
        let numbers = numbers(&folder)?;
        let mut left = Vec::new();
        let mut mine = None;
        for number in &numbers {
            let Some(drawer) = claim(&folder, *number)? else {
                continue;
            };
            if file(&folder, *number).exists() {
                left.push(drawer);
            } else if mine.is_none() {
                mine = Some(drawer);
            }
        }
        let mut next = numbers.last().map_or(0, |last| last + 1);
        let mine = loop {
            match mine {
                Some(mine) => break mine,
                // Another window may have been quicker.
                None => mine = claim(&folder, next)?,
            }
            next += 1;
        };
        Ok(Self {
            folder,
            mine,
            kept: None,
            left,
            writing: None,
        })
    }

    /// What windows that are gone have left, the newest first.
    pub fn left(&self) -> Vec<Left> {
        let read = |drawer: &Drawer| {
            let path = file(&self.folder, drawer.number);
            let written = fs::metadata(&path).and_then(|about| about.modified());
            let left = Left {
                drawer: drawer.number.to_string(),
                work: fs::read_to_string(path).ok()?,
            };
            Some((written.ok(), left))
        };
        let mut left: Vec<_> = self.left.iter().filter_map(read).collect();
        left.sort_by_key(|(written, _)| std::cmp::Reverse(*written));
        left.into_iter().map(|(_, left)| left).collect()
    }

    /// Puts something into this window's drawer, in the place of what is there.
    pub fn keep(&mut self, work: Option<String>) {
        if work == self.kept {
            return;
        }
        self.wait();
        let path = file(&self.folder, self.mine.number);
        self.kept.clone_from(&work);
        let write = move || {
            let done = match work {
                Some(work) => replace(&path, work.as_bytes()),
                None => fs::remove_file(&path),
            };
            if let Err(error) = done {
                log::warn!("{}: {error}", path.display());
            }
        };
        match Builder::new().name("drawer".to_owned()).spawn(write) {
            Ok(writing) => self.writing = Some(writing),
            Err(error) => log::warn!("no thread to keep the scene with: {error}"),
        }
    }

    /// Empties a drawer of a window that is gone.
    pub fn forget(&mut self, drawer: &str) {
        // What takes its place is written first.
        self.wait();
        self.left.retain(|left| {
            let is_meant = left.number.to_string() == drawer;
            if is_meant && let Err(error) = fs::remove_file(file(&self.folder, left.number)) {
                log::warn!("drawer {drawer}: {error}");
            }
            !is_meant
        });
    }

    fn wait(&mut self) {
        if let Some(writing) = self.writing.take() {
            // A panic in it has been told already.
            let _ = writing.join();
        }
    }
}

impl Drop for Drawers {
    fn drop(&mut self) {
        self.wait();
    }
}

/// What is in a drawer.
fn file(folder: &Path, number: u32) -> PathBuf {
    folder.join(format!("{number}.toml"))
}

/// The numbers of all drawers that there are, ascending.
fn numbers(folder: &Path) -> io::Result<Vec<u32>> {
    let mut numbers = Vec::new();
    for entry in fs::read_dir(folder)? {
        let name = PathBuf::from(entry?.file_name());
        let stem = name.file_stem().and_then(|stem| stem.to_str());
        numbers.extend(stem.and_then(|stem| stem.parse::<u32>().ok()));
    }
    numbers.sort_unstable();
    numbers.dedup();
    Ok(numbers)
}

/// Takes a drawer, unless a window holds it.
fn claim(folder: &Path, number: u32) -> io::Result<Option<Drawer>> {
    let path = folder.join(format!("{number}.lock"));
    let mut options = File::options();
    options.write(true);
    let (lock, is_new) = match options.clone().create_new(true).open(&path) {
        Err(error) if error.kind() == io::ErrorKind::AlreadyExists => (options.open(&path)?, false),
        opened => (opened?, true),
    };
    let is_ours = match lock.try_lock() {
        Ok(()) => true,
        Err(TryLockError::WouldBlock) => false,
        // A file system without locks: a new drawer is nobody's, and work is
        // rather offered twice than never.
        Err(TryLockError::Error(_)) => is_new || file(folder, number).exists(),
    };
    Ok(is_ours.then_some(Drawer {
        number,
        _lock: lock,
    }))
}

#[cfg(test)]
mod tests {
    use super::super::native::tests::Folder;
    use super::*;

    fn open(folder: &Folder) -> Drawers {
        Drawers::open(folder.0.join("drawers")).unwrap()
    }

    fn works(drawers: &Drawers) -> Vec<String> {
        let left = drawers.left().into_iter();
        let mut works: Vec<_> = left.map(|left| left.work).collect();
        works.sort();
        works
    }

    #[test]
    fn two_windows_keep_their_own_and_a_third_finds_both() {
        let folder = Folder::new("drawers-two");
        let (mut one, mut other) = (open(&folder), open(&folder));
        one.keep(Some("one".to_owned()));
        other.keep(Some("other".to_owned()));
        one.keep(Some("one more".to_owned()));
        // What a window holds is not offered by another.
        assert!(works(&open(&folder)).is_empty());
        drop((one, other));
        let third = open(&folder);
        assert_eq!(works(&third), ["one more", "other"]);
        // It is the third's to decide on, as long as it is there …
        assert!(works(&open(&folder)).is_empty());
        drop(third);
        // … and if nobody has decided, it is offered again.
        assert_eq!(works(&open(&folder)), ["one more", "other"]);
    }

    #[test]
    fn what_was_decided_on_or_saved_is_gone() {
        let folder = Folder::new("drawers-decided");
        let mut one = open(&folder);
        one.keep(Some("one".to_owned()));
        drop(one);
        let mut two = open(&folder);
        two.keep(Some("one, restored".to_owned()));
        two.forget(&two.left()[0].drawer.clone());
        drop(two);
        let mut three = open(&folder);
        assert_eq!(works(&three), ["one, restored"]);
        three.keep(Some("three".to_owned()));
        three.keep(None);
        drop(three);
        assert_eq!(works(&open(&folder)), ["one, restored"]);
        // Drawers are used again: there are no more than there were windows.
        assert!(numbers(&folder.0.join("drawers")).unwrap().len() <= 3);
    }
}
