//! A browser: files come from its chooser or are dropped on the page, and go
//! where its downloads go. It tells nobody where that is, so no file can be
//! opened or written again without the user.

use super::{Contents, Destination, Errand, Left, News, PictureKind, Platform, Taker};
use crate::app::pixels::{Decoded, MOST_SIDE, SCALE, SHOWN_SIDE, neither, too_large};
use eframe::egui::{ColorImage, Context, DroppedFileHandle};
use js_sys::{Array, Promise, Uint8Array};
use std::cell::RefCell;
use std::collections::VecDeque;
use std::path::{Path, PathBuf};
use std::rc::Rc;
use wasm_bindgen::prelude::*;
use wasm_bindgen_futures::{JsFuture, spawn_local};

#[wasm_bindgen(js_namespace = sinew_page)]
extern "C" {
    /// A file of the user's choice among those with such endings; nothing
    /// where they change their mind.
    fn pick(endings: &str) -> Promise;
    /// Hands a file to the browser's downloads.
    fn download(name: &str, bytes: &[u8]);
    /// The same with a picture of lines, as pixels, so many for each of its
    /// own.
    fn download_pixels(name: &str, svg: &str, scale: f64);
    /// A picture's bytes as its width and height, the right way up; those with
    /// which it is shown, at most so many pixels; and its pixels then, red,
    /// green, blue and opacity. Rejects what is no picture.
    fn decode(bytes: &[u8], most: u32) -> Promise;
    /// The page's address without its fragment.
    fn address() -> String;
    /// Keeps work that is not saved, or nothing any more.
    fn keep(work: Option<String>);
    /// What pages that are gone have kept, the newest first: their drawers'
    /// names and what is in them, by turns.
    fn left() -> Array;
    /// Empties such a drawer.
    fn forget(drawer: &str);
}

/// The browser around a window.
pub struct Web {
    news: Rc<Newsstand>,
}

/// Where what becomes of errands is left.
struct Newsstand {
    ctx: Context,
    news: RefCell<VecDeque<News>>,
}

impl Newsstand {
    fn leave(&self, news: News) {
        self.news.borrow_mut().push_back(news);
        self.ctx.request_repaint();
    }

    fn fail(&self, errand: Errand, path: Option<PathBuf>, reason: String) {
        self.leave(News::Failed {
            errand,
            path,
            reason,
        });
    }

    fn read(&self, errand: Errand, path: PathBuf, bytes: Vec<u8>) {
        self.leave(News::Read {
            errand,
            path,
            bytes,
        });
    }
}

impl Web {
    /// The browser around the window of a context.
    pub fn new(ctx: &Context) -> Self {
        let news = RefCell::default();
        let ctx = ctx.clone();
        Self {
            news: Rc::new(Newsstand { ctx, news }),
        }
    }
}

impl Platform for Web {
    fn pick(&mut self, errand: Errand, _folder: Option<&Path>) {
        let endings: Vec<_> = errand.endings().iter().map(|e| format!(".{e}")).collect();
        let picked = pick(&endings.join(","));
        let news = Rc::clone(&self.news);
        spawn_local(async move {
            let file = JsFuture::from(picked).await;
            match file.ok().and_then(|file| file.dyn_into().ok()) {
                Some(file) => read(&news, errand, &file).await,
                None => news.leave(News::Cancelled(errand)),
            }
        });
    }

    /// A page always has one.
    fn answer(&mut self, errand: Errand, _path: Option<PathBuf>) {
        self.news.leave(News::Cancelled(errand));
    }

    fn read(&mut self, errand: Errand, path: PathBuf) {
        let reason = "a browser opens no file by its name; choose it again".to_owned();
        self.news.fail(errand, Some(path), reason);
    }

    fn take(&mut self, errand: Errand, dropped: DroppedFileHandle) {
        let news = Rc::clone(&self.news);
        spawn_local(async move {
            match dropped.web_file() {
                Some(file) => read(&news, errand, file).await,
                None => news.leave(News::Cancelled(errand)),
            }
        });
    }

    fn write(&mut self, errand: Errand, to: Destination, contents: Contents) {
        let path = match to {
            Destination::Known(path) => path,
            Destination::Ask { name, .. } => PathBuf::from(name),
        };
        match contents(&path) {
            Ok(bytes) => {
                let name = path.file_name().unwrap_or_default().to_string_lossy();
                match errand {
                    Errand::Picture(PictureKind::Png) => {
                        let svg = String::from_utf8_lossy(&bytes);
                        download_pixels(&name, &svg, SCALE);
                    }
                    _ => download(&name, &bytes),
                }
                self.news.leave(News::Written { errand, path });
            }
            Err(reason) => self.news.fail(errand, Some(path), reason),
        }
    }

    fn keep(&mut self, work: Option<String>) {
        keep(work);
    }

    fn left(&mut self) -> Vec<Left> {
        let words = left();
        let mut words = words.iter().filter_map(|word| word.as_string());
        let mut found = Vec::new();
        while let (Some(drawer), Some(work)) = (words.next(), words.next()) {
            found.push(Left { drawer, work });
        }
        found
    }

    fn forget(&mut self, drawer: &str) {
        forget(drawer);
    }

    fn poll(&mut self) -> Option<News> {
        self.news.news.borrow_mut().pop_front()
    }

    fn decode(&mut self, bytes: Vec<u8>, give: Taker) {
        let ctx = self.news.ctx.clone();
        spawn_local(async move {
            give(decoded(&bytes).await);
            ctx.request_repaint();
        });
    }

    fn address(&self) -> String {
        address()
    }

    fn keeps_paths(&self) -> bool {
        false
    }
}

/// The photograph in a file's bytes.
async fn decoded(bytes: &[u8]) -> Result<Decoded, String> {
    let is_known = bytes.starts_with(b"\x89PNG\r\n\x1a\n") || bytes.starts_with(b"\xff\xd8\xff");
    if !is_known {
        return Err(neither());
    }
    let damaged = |_| "it is damaged; save it again".to_owned();
    let parts = JsFuture::from(decode(bytes, SHOWN_SIDE)).await;
    let parts = Array::from(&parts.map_err(damaged)?);
    let side = |index| parts.get(index).as_f64().unwrap_or_default() as u32;
    let size = [side(0), side(1)];
    if size.iter().any(|side| *side > MOST_SIDE) {
        return Err(too_large(size[0], size[1]));
    }
    let shown = [side(2) as usize, side(3) as usize];
    let pixels = Uint8Array::new(&parts.get(4)).to_vec();
    Ok(Decoded {
        image: ColorImage::from_rgba_unmultiplied(shown, &pixels),
        size,
    })
}

async fn read(news: &Newsstand, errand: Errand, file: &web_sys::File) {
    let path = PathBuf::from(file.name());
    if let Some(reason) = errand.too_large(file.size() as u64) {
        return news.fail(errand, Some(path), reason);
    }
    match JsFuture::from(file.array_buffer()).await {
        Ok(bytes) => news.read(errand, path, Uint8Array::new(&bytes).to_vec()),
        Err(_) => {
            let reason = "the browser cannot read it; it may have changed since".to_owned();
            news.fail(errand, Some(path), reason);
        }
    }
}
