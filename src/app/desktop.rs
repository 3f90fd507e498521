//! The window on the desktop: opened from the command line's arguments, with
//! a solver thread behind it.

use super::backend::{Inline, SolverBackend, Thread};
use super::commands::Command;
use super::files::scene_from;
use super::platform::{Native, in_words};
use super::window::Sinew;
use super::window::stored::Stored;
use super::words::{faults_of, sentence};
use super::workbench::{Preferences, Trouble};
use crate::report::on_a_terminal;
use crate::scene::Scene;
use eframe::egui::{Context, ViewportBuilder, vec2};
use std::ffi::OsString;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use web_time::Duration;

/// What the headless commands are, for machines that have no display.
const HEADLESS: &str = "without one there are the commands `sinew solve`, `draw`, `force`, \
                        `compare` and `reproduce` (see `sinew help`)";
/// What the system knows the program by.
const APP_ID: &str = "sinew";
/// Where nothing gives a thread, the window solves in slices of this length
/// between its frames.
const SLICE: Duration = Duration::from_millis(4);

/// What the window is to open.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Opening {
    /// What was open last, or the first example.
    Anything,
    /// A scene file.
    File(PathBuf),
}

/// What the program's arguments, its own name left out, ask the window to
/// open: nothing but a scene file, or nothing at all. `None` where they are
/// the command line's.
pub fn asked_for(mut arguments: impl Iterator<Item = OsString>) -> Option<Opening> {
    let Some(first) = arguments.next() else {
        return Some(Opening::Anything);
    };
    let file = PathBuf::from(first);
    let is_scene = file.extension().is_some_and(|ending| ending == "toml");
    (is_scene && arguments.next().is_none()).then_some(Opening::File(file))
}

/// Opens the window and stays until it is closed. The exit code is 0, or 1
/// where there is no display, or 2 where there is none and the scene file cannot be
/// opened either; with a display the window says so.
pub fn open(opening: &Opening) -> ExitCode {
    let mut trouble = None;
    let (scene, file) = match opening {
        Opening::Anything => (None, None),
        Opening::File(file) => match read(file) {
            Ok((scene, file)) => (Some(scene), Some(file)),
            Err(faults) => {
                for fault in &faults {
                    let text = format!("{}: {fault}", file.display());
                    eprintln!("error: {}", on_a_terminal(&text));
                }
                if !has_display() {
                    return ExitCode::from(2);
                }
                trouble = Some(not_opened(file, &faults));
                (None, None)
            }
        },
    };
    if !has_display() {
        eprintln!("error: there is no display to open a window on; {HEADLESS}");
        return ExitCode::from(1);
    }
    let viewport = ViewportBuilder::default()
        .with_app_id(APP_ID)
        .with_inner_size(vec2(1440.0, 900.0))
        .with_min_inner_size(vec2(360.0, 480.0));
    let options = eframe::NativeOptions {
        viewport,
        ..eframe::NativeOptions::default()
    };
    let opened = eframe::run_native(
        "Sinew",
        options,
        Box::new(|cc| {
            if let Some(gpu) = &cc.wgpu_render_state {
                crate::render::install(gpu);
            }
            let backend = backend(&cc.egui_ctx);
            let stored = Stored::of(cc.storage);
            let window = Sinew::new(&cc.egui_ctx, scene, backend, Preferences::default());
            let window = window.map_err(|faults| faults_of(&faults).join(" "))?;
            let desktop = Native::new(&cc.egui_ctx, eframe::storage_dir(APP_ID));
            let window = window.on(Box::new(desktop), stored);
            let mut window = match file {
                Some(file) => window.from_file(file),
                None => window,
            };
            window.bench_mut().trouble = trouble;
            Ok(Box::new(window))
        }),
    );
    match opened {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: the window cannot be opened: {error}; {HEADLESS}");
            ExitCode::from(1)
        }
    }
}

/// The scene in a file, and the file's path from the root.
fn read(file: &Path) -> Result<(Scene, PathBuf), Vec<String>> {
    let bytes = std::fs::read(file).map_err(|error| {
        vec![match error.kind() {
            std::io::ErrorKind::NotFound => "there is no such file".to_owned(),
            _ => in_words(&error),
        }]
    })?;
    let file = std::path::absolute(file).unwrap_or_else(|_| file.to_owned());
    let scene = scene_from(&bytes, Some(&file));
    let scene =
        scene.map_err(|faults| faults.iter().map(ToString::to_string).collect::<Vec<_>>())?;
    Ok((scene, file))
}

/// What the window tells of a file that its arguments name and that is none of a scene.
fn not_opened(file: &Path, faults: &[String]) -> Trouble {
    let reasons = faults.iter().map(|fault| sentence(fault)).collect();
    Trouble::new(format!("{} cannot be opened", file.display()), reasons)
        .with("What was there before is open instead. Correct the file, or open another:")
        .offering("Open another …", Command::Open)
}

/// Whether there is a display; elsewhere than on Unix with X11 or Wayland
/// there always is.
fn has_display() -> bool {
    let elsewhere = cfg!(any(target_os = "macos", target_os = "windows"));
    let named = |name| std::env::var_os(name).is_some_and(|value| !value.is_empty());
    elsewhere || named("DISPLAY") || named("WAYLAND_DISPLAY")
}

fn backend(ctx: &Context) -> Box<dyn SolverBackend> {
    let painter = ctx.clone();
    match Thread::new(move || painter.request_repaint()) {
        Ok(thread) => Box::new(thread),
        Err(error) => {
            log::warn!("no thread for the solver, so the window solves by itself: {error}");
            Box::new(Inline::sliced(SLICE))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_that_is_not_there_is_told_in_words() {
        let file = Path::new("no/such/scene.toml");
        let faults = read(file).unwrap_err();
        assert_eq!(faults, ["there is no such file"]);
        let trouble = not_opened(file, &faults);
        assert_eq!(trouble.title, "no/such/scene.toml cannot be opened");
        assert_eq!(trouble.reasons, ["There is no such file."]);
    }

    #[test]
    fn no_argument_or_a_scene_file_is_the_windows() {
        let check = |arguments: &[&str], expect| {
            let arguments = arguments.iter().map(OsString::from);
            assert_eq!(asked_for(arguments), expect);
        };
        check(&[], Some(Opening::Anything));
        check(&["a.toml"], Some(Opening::File("a.toml".into())));
        check(&["solve", "a.toml"], None);
        check(&["a.toml", "--pull"], None);
        check(&["--help"], None);
    }
}
