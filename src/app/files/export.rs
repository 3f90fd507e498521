//! The canvas as a picture's file, and the scene as a link.

use super::file_name;
use crate::app::link;
use crate::app::platform::{Contents, Destination, Errand, PictureKind};
use crate::app::words::sentence;
use crate::app::workbench::{Notice, Workbench};
use crate::report::svg;
use crate::view::{Drawing, Theme};
use eframe::egui::Context;
use std::path::Path;

/// Exports the robot and its obstacles as a picture, in the window's theme.
pub fn picture(bench: &mut Workbench, kind: PictureKind, ctx: &Context) {
    let theme = match ctx.theme() {
        eframe::egui::Theme::Light => Theme::Light,
        eframe::egui::Theme::Dark => Theme::Dark,
    };
    let ending = match kind {
        PictureKind::Svg => "svg",
        PictureKind::Png => "png",
    };
    let name = file_name(bench, ending);
    let drawing = bench.live.drawing().clone();
    let contents = Box::new(move |_: &Path| {
        let size = svg::Size::suiting(&drawing);
        match kind {
            PictureKind::Svg => Ok(svg::render(&drawing, theme, size).into_bytes()),
            PictureKind::Png => pixels(&drawing, theme, size),
        }
    });
    write(bench, Errand::Picture(kind), name, contents);
}

#[cfg(not(target_arch = "wasm32"))]
fn pixels(drawing: &Drawing, theme: Theme, size: svg::Size) -> Result<Vec<u8>, String> {
    let png = crate::report::png::render(drawing, theme, size, crate::app::pixels::SCALE);
    png.map_err(|error| error.to_string())
}

/// A browser makes the pixels itself, of lines that bring their fonts along:
/// see [`crate::app::platform::Platform::write`] of the web.
#[cfg(target_arch = "wasm32")]
fn pixels(drawing: &Drawing, theme: Theme, size: svg::Size) -> Result<Vec<u8>, String> {
    let picture = svg::render(drawing, theme, size);
    let (start, rest) = picture.split_once('>').unwrap_or_default();
    let fonts = crate::app::look::fonts_for_svg();
    Ok(format!("{start}><style>{fonts}</style>{rest}").into_bytes())
}

/// Exports a plot as a picture or as its numbers.
pub fn plot(bench: &mut Workbench, word: &str, ending: &str, bytes: Vec<u8>) {
    let errand = match ending {
        "svg" => Errand::Picture(PictureKind::Svg),
        _ => Errand::Table,
    };
    let scene = file_name(bench, ending);
    let scene = scene.strip_suffix(&format!(".{ending}")).unwrap_or(&scene);
    let name = format!("{scene}-{word}.{ending}");
    write(bench, errand, name, Box::new(move |_: &Path| Ok(bytes)));
}

/// Asks where a file is to go, unless something is being asked already.
fn write(bench: &mut Workbench, errand: Errand, name: String, contents: Contents) {
    if bench.files.is_asking() {
        return;
    }
    let folder = super::folder(bench);
    super::ask(bench, errand);
    let to = Destination::Ask { name, folder };
    bench.files.platform.write(errand, to, contents);
}

/// Copies a link that holds the whole scene.
pub fn copy_link(bench: &mut Workbench, ctx: &Context) {
    match link::encode(&bench.document.scene) {
        Ok(fragment) => {
            let address = bench.files.platform.address();
            ctx.copy_text(format!("{address}{fragment}"));
            let told = "Copied a link that holds the whole scene";
            bench.notices.tell(Notice::success(told));
        }
        Err(fault) => {
            let told = format!("There is no link to this scene: {fault}");
            bench.notices.tell(Notice::trouble(sentence(&told)));
        }
    }
}
