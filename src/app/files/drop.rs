//! Files dropped on the window and text pasted into it: told apart by their
//! ending or what they say, and announced while they still hang over it.

use super::{open, request};
use crate::app::link;
use crate::app::look::{Tokens, icon_font, icons, semibold};
use crate::app::platform::Errand;
use crate::app::words::{sentence, shown};
use crate::app::workbench::{Arrival, Intent, Notice, Workbench};
use crate::scene::Scene;
use eframe::egui::{
    Align2, Context, CornerRadius, Event, FontId, Id, LayerId, Order, Stroke, StrokeKind, Ui,
};
use std::path::Path;

/// What a dropped file is taken for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Dropped {
    /// Something that the window can use.
    For(Errand),
    /// Something else.
    Useless,
}

impl Dropped {
    /// What a file of this name is taken for.
    pub fn of(path: &Path) -> Self {
        let ending = path.extension().map(|e| e.to_string_lossy().to_lowercase());
        let ending = ending.unwrap_or_default();
        let known = [Errand::Scene, Errand::Measurements, Errand::Photo];
        let errand = known
            .into_iter()
            .find(|errand| errand.endings().contains(&&*ending));
        errand.map_or(Dropped::Useless, Dropped::For)
    }

    /// Like [`Dropped::of`], from what browsers say of a file that still hangs
    /// over the window.
    fn of_mime(mime: &str) -> Self {
        match mime {
            "image/png" | "image/jpeg" => Dropped::For(Errand::Photo),
            "text/csv" => Dropped::For(Errand::Measurements),
            // Browsers do not know TOML.
            "" | "application/toml" | "text/plain" => Dropped::For(Errand::Scene),
            _ => Dropped::Useless,
        }
    }

    /// What will happen to it.
    fn promise(self) -> (&'static str, &'static str) {
        match self {
            Dropped::For(Errand::Measurements) => (icons::TABLE, "Drop to import the measurements"),
            Dropped::For(Errand::Photo) => {
                (icons::IMAGE, "Drop to lay the photograph behind the robot")
            }
            Dropped::For(_) => (icons::FOLDER_OPEN, "Drop to open the scene"),
            Dropped::Useless => (icons::WARNING_CIRCLE, USELESS),
        }
    }
}

const USELESS: &str = "Drop a scene (.toml), measurements (.csv) or a photograph (.png, .jpg)";

/// Takes the files that were dropped on the window.
pub fn take_drops(bench: &mut Workbench, ctx: &Context) {
    for file in ctx.input(|input| input.raw.dropped_files.clone()) {
        match Dropped::of(file.path()) {
            Dropped::For(errand) => bench.files.platform.take(errand, file),
            Dropped::Useless => {
                let name = shown(file.path());
                bench.notices.tell(Notice::trouble(format!(
                    "{name} cannot be used here. {USELESS}."
                )));
            }
        }
    }
}

/// Says what will happen to the files that hang over the window.
pub fn announce(ui: &Ui) {
    let ctx = ui.ctx();
    let hovering = ctx.input(|input| input.raw.hovered_files.clone());
    let Some(first) = hovering.first() else {
        return;
    };
    let kind = match &first.path {
        Some(path) => Dropped::of(path),
        None => Dropped::of_mime(&first.mime),
    };
    let (glyph, promise) = kind.promise();
    let tokens = Tokens::in_ui(ui);
    let colour = match kind {
        Dropped::For(_) => tokens.accent,
        Dropped::Useless => tokens.warning,
    };
    let painter = ctx.layer_painter(LayerId::new(Order::Foreground, Id::unique("drop")));
    let window = ctx.content_rect();
    painter.rect_filled(window, 0.0, tokens.canvas.gamma_multiply(0.86));
    let inner = window.shrink(16.0);
    painter.rect(
        inner,
        CornerRadius::same(12),
        tokens.accent_soft.gamma_multiply(0.35),
        Stroke::new(2.0, colour),
        StrokeKind::Inside,
    );
    let middle = inner.center();
    painter.text(
        middle - eframe::egui::vec2(0.0, 30.0),
        Align2::CENTER_CENTER,
        glyph,
        icon_font(40.0),
        colour,
    );
    let text = painter.layout(
        promise.to_owned(),
        semibold(18.0),
        tokens.text,
        inner.width() - 48.0,
    );
    let at = middle + eframe::egui::vec2(-0.5 * text.size().x, 10.0);
    let below = at.y + text.size().y + 16.0;
    painter.galley(at, text, tokens.text);
    if let Some(path) = &first.path {
        let more = hovering.len() - 1;
        let names = match more {
            0 => shown(path),
            _ => format!("{} and {more} more", shown(path)),
        };
        painter.text(
            eframe::egui::pos2(middle.x, below),
            Align2::CENTER_CENTER,
            names,
            FontId::proportional(14.0),
            tokens.muted,
        );
    }
}

/// Opens a link to a scene, or a scene's text, that was pasted while no text
/// was being written.
pub fn take_pastes(bench: &mut Workbench, ctx: &Context) {
    if ctx.text_edit_focused() {
        return;
    }
    let pasted = ctx.input_mut(|input| {
        let place = input
            .events
            .iter()
            .position(|event| matches!(event, Event::Paste(_)))?;
        match input.events.remove(place) {
            Event::Paste(text) => Some(text),
            _ => None,
        }
    });
    if let Some(text) = pasted {
        open_text(bench, &text, ctx);
    }
}

/// Opens a link to a scene or a scene's text.
pub fn open_text(bench: &mut Workbench, text: &str, ctx: &Context) {
    let (scene, told) = if is_scene(text) {
        match open::scene_from(text.as_bytes(), None) {
            Ok(scene) => (scene, "Opened the pasted scene"),
            Err(faults) => {
                open::refuse(bench, "The pasted scene", &faults);
                return;
            }
        }
    } else {
        match link::decode(text) {
            Ok(scene) => (scene, "Opened the link’s scene"),
            Err(fault) => {
                let fault = sentence(&fault.to_string());
                bench.notices.tell(Notice::trouble(fault));
                return;
            }
        }
    };
    let arrival = Arrival::of(scene).telling(told);
    request(bench, Intent::Scene(Box::new(arrival)), ctx);
}

/// Whether text is meant as a scene's, faults or not.
fn is_scene(text: &str) -> bool {
    let has = |start: &str| {
        text.lines()
            .any(|line| line.trim_start().starts_with(start))
    };
    has("[robot]") || has("robot") || has("version") || Scene::from_toml(text).is_ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn endings_tell_files_apart() {
        let check = |name: &str, expect| assert_eq!(Dropped::of(Path::new(name)), expect);
        check("a.toml", Dropped::For(Errand::Scene));
        check("A.TOML", Dropped::For(Errand::Scene));
        check("a.csv", Dropped::For(Errand::Measurements));
        check("a.JPG", Dropped::For(Errand::Photo));
        check("a.pdf", Dropped::Useless);
        check("toml", Dropped::Useless);
    }

    #[test]
    fn a_scenes_text_is_no_link() {
        assert!(is_scene("# a\nversion = 2\n"));
        assert!(is_scene("  [robot]\nlength_mm = 'x'"));
        assert!(!is_scene("https://example.org/#s1.abc"));
    }
}
