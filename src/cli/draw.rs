//! `sinew draw`: the robot's shape as a picture.

use std::fs;
use std::io;
use std::path::Path;

use super::arguments::{Draw, Paint};
use super::input::{self, BadInput};
use super::output::printable;
use super::{Failure, Outcome};
use crate::equilibrium::{Settings, Start, Status, solve};
use crate::report::png::PngError;
use crate::report::{png, svg};
use crate::view::{Drawing, Notes, Theme, draw};

/// Pixels of a PNG in a pixel of its SVG: sharp on today's screens.
const SCALE: f64 = 2.0;

/// What a picture's file holds, told by its name.
enum Kind {
    Svg,
    Png,
}

pub(super) fn run(what: &Draw) -> Result<Outcome, Failure> {
    let kind = kind(&what.out)?;
    let (scene, problem) = input::problem(&what.scene, what.pull)?;
    let solution = solve(&problem, Start::Straight, Settings::default());
    let drawing = draw(&problem, &solution, &Notes::of(&scene));
    let bytes = match kind {
        Kind::Svg => picture(&drawing, what.theme).into_bytes(),
        Kind::Png => raster(&drawing, what).map_err(|error| Failure::Making(error.into()))?,
    };
    fs::write(&what.out, bytes).map_err(|error| named(&what.out, &error))?;
    Ok(match solution.status {
        Status::Converged => Outcome::Done,
        status => Outcome::NotConverged(format!(
            "not converged: {}; the picture shows the last good state",
            status.reason()
        )),
    })
}

/// An error with the path it is about.
pub(super) fn named(path: &Path, error: &io::Error) -> io::Error {
    let path = printable(&path.display().to_string());
    io::Error::new(error.kind(), format!("{path}: {error}"))
}

fn kind(path: &Path) -> Result<Kind, BadInput> {
    let extension = path.extension().map(|e| e.to_string_lossy().to_lowercase());
    match extension.as_deref() {
        Some("svg") => Ok(Kind::Svg),
        Some("png") => Ok(Kind::Png),
        _ => Err(BadInput::Arguments(format!(
            "{} does not say what to draw; end it in .svg or .png",
            printable(&path.display().to_string())
        ))),
    }
}

fn theme(paint: Paint) -> Theme {
    match paint {
        Paint::Auto | Paint::Light => Theme::Light,
        Paint::Dark => Theme::Dark,
    }
}

fn picture(drawing: &Drawing, paint: Paint) -> String {
    let size = svg::Size::suiting(drawing);
    match paint {
        Paint::Auto => svg::render_adaptive(drawing, size),
        _ => svg::render(drawing, theme(paint), size),
    }
}

fn raster(drawing: &Drawing, what: &Draw) -> Result<Vec<u8>, PngError> {
    let size = svg::Size::suiting(drawing);
    png::render(drawing, theme(what.theme), size, SCALE)
}
