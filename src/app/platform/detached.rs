//! A window without files around it: says so when asked for one.

use super::{Contents, Destination, Errand, News, Platform};
use eframe::egui::DroppedFileHandle;
use std::collections::VecDeque;
use std::path::{Path, PathBuf};

/// No system. For windows that are only looked at, as in tests.
#[derive(Debug, Default)]
pub struct Detached {
    news: VecDeque<News>,
}

impl Detached {
    fn refuse(&mut self, errand: Errand, path: Option<PathBuf>) {
        let reason = "this window has no access to files".to_owned();
        self.news.push_back(News::Failed {
            errand,
            path,
            reason,
        });
    }
}

impl Platform for Detached {
    fn pick(&mut self, errand: Errand, _folder: Option<&Path>) {
        self.refuse(errand, None);
    }

    fn answer(&mut self, errand: Errand, path: Option<PathBuf>) {
        self.refuse(errand, path);
    }

    fn read(&mut self, errand: Errand, path: PathBuf) {
        self.refuse(errand, Some(path));
    }

    fn take(&mut self, errand: Errand, dropped: DroppedFileHandle) {
        self.refuse(errand, Some(dropped.path().to_owned()));
    }

    fn write(&mut self, errand: Errand, to: Destination, _contents: Contents) {
        let path = match to {
            Destination::Known(path) => Some(path),
            Destination::Ask { .. } => None,
        };
        self.refuse(errand, path);
    }

    #[cfg(target_arch = "wasm32")]
    fn decode(&mut self, _bytes: Vec<u8>, give: super::Taker) {
        give(Err("this window has no access to files".to_owned()));
    }

    fn keep(&mut self, _work: Option<String>) {}

    fn left(&mut self) -> Vec<super::Left> {
        Vec::new()
    }

    fn forget(&mut self, _drawer: &str) {}

    fn poll(&mut self) -> Option<News> {
        self.news.pop_front()
    }

    fn keeps_paths(&self) -> bool {
        false
    }
}
