//! What lies over the window: the gallery, the palette, the help, and words
//! that have to be answered. One sheet at a time, and over it, where unsaved
//! work is at stake, the guard.

mod frame;
mod gallery;
mod guard;
mod help;
mod palette;
mod path;
mod trouble;

use crate::app::workbench::{Trouble, Workbench};
use eframe::egui::Context;
use frame::Stays;

/// A sheet.
#[derive(Clone, Debug, PartialEq)]
pub enum Sheet {
    /// The examples.
    Gallery,
    /// All commands, searched.
    Palette,
    /// Keys, gestures, colours and the model.
    Help,
    /// Something that did not work.
    Trouble(Trouble),
}

impl From<Trouble> for Sheet {
    fn from(trouble: Trouble) -> Self {
        Sheet::Trouble(trouble)
    }
}

/// What lies over the window.
#[derive(Default)]
pub struct Sheets {
    /// The sheet that is open.
    sheet: Option<Sheet>,
    palette: palette::Palette,
    gallery: gallery::Gallery,
    /// Whether the sheet was opened in this frame, so that it takes the focus.
    fresh: bool,
    /// The document that it has seen, see [`Workbench::opened`].
    opened: u64,
}

impl Sheets {
    /// Opens a sheet in the place of the one that is open.
    pub fn open(&mut self, sheet: impl Into<Sheet>) {
        self.sheet = Some(sheet.into());
        self.palette = palette::Palette::default();
        self.fresh = true;
    }

    /// Takes what the workbench has for it: another document closes the sheet,
    /// and trouble opens one.
    pub fn take_news(&mut self, bench: &mut Workbench) {
        if self.opened != bench.opened {
            self.opened = bench.opened;
            self.sheet = None;
        }
        if let Some(trouble) = bench.trouble.take() {
            self.open(trouble);
        }
    }

    /// Whether anything lies over the window, now that it has taken its news.
    pub fn is_open(&self, bench: &Workbench) -> bool {
        let files = &bench.files;
        self.sheet.is_some() || files.guarded.is_some() || files.typing.is_some()
    }
}

/// Shows what lies over the window.
pub fn show(ctx: &Context, sheets: &mut Sheets, bench: &mut Workbench) {
    sheets.take_news(bench);
    let fresh = std::mem::take(&mut sheets.fresh);
    let stays = match &sheets.sheet {
        None => Stays::Open,
        Some(Sheet::Gallery) => gallery::show(ctx, &mut sheets.gallery, bench, fresh),
        Some(Sheet::Palette) => palette::show(ctx, &mut sheets.palette, bench, fresh),
        Some(Sheet::Help) => help::show(ctx),
        Some(Sheet::Trouble(trouble)) => trouble::show(ctx, bench, trouble, fresh),
    };
    sheets.take_news(bench);
    // A sheet that opened another one does not close that.
    if stays == Stays::Closed && !sheets.fresh {
        sheets.sheet = None;
    }
    guard::show(ctx, bench);
    path::show(ctx, bench);
    sheets.take_news(bench);
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::Scene;

    #[test]
    fn another_document_closes_a_sheet_and_trouble_opens_one() {
        let mut bench = Workbench::with(Scene::default());
        let mut sheets = Sheets::default();
        sheets.open(Sheet::Gallery);
        sheets.take_news(&mut bench);
        assert!(sheets.is_open(&bench));
        bench.open(Scene::default()).unwrap();
        sheets.take_news(&mut bench);
        assert!(!sheets.is_open(&bench));
        let trouble = Trouble::new("It cannot be opened", vec!["It is empty.".to_owned()]);
        bench.open(Scene::default()).unwrap();
        bench.trouble = Some(trouble.clone());
        sheets.take_news(&mut bench);
        assert_eq!(sheets.sheet, Some(Sheet::Trouble(trouble)));
        // It is told once.
        assert_eq!(bench.trouble, None);
    }
}
