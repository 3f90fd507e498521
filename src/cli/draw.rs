//! `sinew draw`: the picture of a scene's solution, as SVG or PNG.

use std::fs;
use std::io::{self, Write};
use std::path::Path;

use super::arguments::{Draw, Look};
use super::input::{self, BadInput};
use super::output::{printable, reader};
use super::solve::{finish, outcome};
use super::{Failure, Outcome};
use crate::equilibrium::{Run, Settings, Start};
use crate::report::{png, svg};
use crate::view::{self, Drawing, Notes, Theme};

/// Pixels of a PNG to one of the SVG, so that text is sharp on any screen.
const SHARPNESS: f64 = 2.0;

pub(super) fn run(what: &Draw) -> Result<Outcome, Failure> {
    let format = Format::of(&what.output)?;
    let (scene, problem) = input::problem(&what.scene, &what.edits, &what.driving)?;
    let mut run = Run::new(&problem, Start::Straight, Settings::default());
    finish(&mut run, |_| {});
    let drawing = view::draw(&run.solved(), &Notes::of(&scene));
    let picture = render(&drawing, format, what.theme)?;
    match format {
        Format::StandardOutput => {
            reader(io::stdout().lock().write_all(&picture))?;
        }
        Format::Svg | Format::Png => {
            fs::write(&what.output, &picture).map_err(|error| named(&what.output, &error))?;
        }
    }
    Ok(outcome(&run, &problem))
}

/// An error with the path it is about.
pub(super) fn named(path: &Path, error: &io::Error) -> io::Error {
    let path = printable(&path.display().to_string());
    io::Error::new(error.kind(), format!("{path}: {error}"))
}

/// What to write.
#[derive(Clone, Copy)]
enum Format {
    Svg,
    Png,
    /// An SVG, for a pipe.
    StandardOutput,
}

impl Format {
    /// The format that the file's ending asks for.
    fn of(output: &Path) -> Result<Self, BadInput> {
        if output.as_os_str() == "-" {
            return Ok(Format::StandardOutput);
        }
        let ending = output.extension().and_then(|ending| ending.to_str());
        match ending.map(str::to_ascii_lowercase).as_deref() {
            Some("svg") => Ok(Format::Svg),
            Some("png") => Ok(Format::Png),
            _ => Err(BadInput::Arguments(format!(
                "{} does not say what to draw; end it in .svg or .png, or write - for an SVG on \
                 standard output",
                printable(&output.display().to_string())
            ))),
        }
    }
}

fn render(drawing: &Drawing, format: Format, look: Look) -> Result<Vec<u8>, Failure> {
    let size = svg::Size::suiting(drawing);
    let theme = match look {
        Look::Dark => Theme::Dark,
        Look::Light | Look::Auto => Theme::Light,
    };
    match (format, look) {
        (Format::Png, _) => png::render(drawing, theme, size, SHARPNESS)
            .map_err(|error| Failure::Making(error.into())),
        (_, Look::Auto) => Ok(svg::render_adaptive(drawing, size).into_bytes()),
        (_, Look::Light | Look::Dark) => Ok(svg::render(drawing, theme, size).into_bytes()),
    }
}
