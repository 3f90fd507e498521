//! From a name on the command line to a problem, or to what is wrong with it.

use std::fs::File;
use std::io::{self, ErrorKind, Read};
use std::path::Path;

use anyhow::bail;

use super::arguments::{Driving, Edits};
use super::output::printable;
use crate::mechanics::Problem;
use crate::scene::{Drive, MAX_FILE_BYTES, Scene, SceneError};

/// What a scene's file should be.
const A_SCENE: &str = "a scene is a TOML text file";

/// What is wrong with what was asked for.
#[derive(Debug, thiserror::Error)]
pub(super) enum BadInput {
    /// There is no scene to be had.
    #[error("{0:#}")]
    Unreadable(#[from] anyhow::Error),
    /// A scene with faults, at least one, and where it came from.
    #[error("{origin} has {} faults", .faults.len())]
    Faulty {
        origin: String,
        faults: Vec<SceneError>,
    },
    /// Arguments that contradict each other.
    #[error("{0}")]
    Arguments(String),
}

impl BadInput {
    /// What to tell, a line each.
    pub fn complaints(&self) -> Vec<String> {
        match self {
            BadInput::Faulty { origin, faults } => faults
                .iter()
                .map(|fault| format!("{origin}: {fault}"))
                .collect(),
            _ => vec![self.to_string()],
        }
    }
}

/// The scene in a file and the problem it describes, after what is to be set in
/// it, and what drives a cable replaced where that is given.
pub(super) fn problem(
    path: &Path,
    edits: &Edits,
    driving: &Driving,
) -> Result<(Scene, Problem), BadInput> {
    let origin = origin(path);
    let mut scene = scene(path, edits)?;
    let driven = drive(&mut scene, driving, &origin)?;
    let mut faults = Problem::faults(&scene);
    if faults.is_empty() {
        match Problem::new(&scene) {
            Ok(problem) => return Ok((scene, problem)),
            Err(fault) => faults.push(fault),
        }
    }
    if let Some((field, option)) = driven {
        for fault in &mut faults {
            name_the_option(fault, &field, option);
        }
    }
    Err(BadInput::Faulty { origin, faults })
}

/// The scene in a file, after what is to be set in it, with whatever faults it has.
pub(super) fn scene(path: &Path, edits: &Edits) -> Result<Scene, BadInput> {
    let mut scene = bytes(path, A_SCENE)
        .and_then(|bytes| Ok(Scene::from_toml_bytes(&bytes)?))
        .map_err(|error: anyhow::Error| error.context(origin(path)))?;
    for edit in &edits.set {
        set(&mut scene, edit)?;
    }
    Ok(scene)
}

/// Sets what drives a cable, where that is given. Returns the scene's field for it and
/// the option.
fn drive(
    scene: &mut Scene,
    driving: &Driving,
    origin: &str,
) -> Result<Option<(String, &'static str)>, BadInput> {
    let (drive, option) = match (driving.pull, driving.load) {
        (Some(pull_mm), _) => (Drive::PullMm(pull_mm), "--pull"),
        (None, Some(load_g)) => (Drive::LoadG(load_g), "--load"),
        (None, None) => return Ok(None),
    };
    let count = scene.cable_count();
    let refused = match (driving.cable, count) {
        (_, 0) => return Ok(None),
        (None, 2..) => format!(
            "{option} names no cable, and {origin} has {count}; add --cable with 0 to {}",
            count - 1
        ),
        (Some(cable), count) if cable >= count => match count {
            1 => format!("--cable {cable} is not there; {origin} has one cable, 0"),
            _ => format!(
                "--cable {cable} is not there; {origin} has cables 0 to {}",
                count - 1
            ),
        },
        (cable, _) => {
            let cable = cable.unwrap_or(0);
            scene.set_drive(cable, drive);
            return Ok(Some((scene.cable_field(cable, drive.key()), option)));
        }
    };
    Err(BadInput::Arguments(refused))
}

/// Sets what `--set` was given.
fn set(scene: &mut Scene, edit: &str) -> Result<(), BadInput> {
    let option = format!("--set {}", printable(edit));
    let Some((key, value)) = edit.split_once('=') else {
        return Err(BadInput::Arguments(format!(
            "{option} has no value; write it as --set {}=VALUE",
            printable(edit)
        )));
    };
    scene
        .set(key, value)
        .map_err(|fault| BadInput::Arguments(format!("{option}: {fault}")))
}

/// A fault of what was given on the command line names that, not the file.
fn name_the_option(fault: &mut SceneError, given: &str, option: &str) {
    if let SceneError::NotANumber { field, .. } | SceneError::OutOfRange { field, .. } = fault
        && field == given
    {
        option.clone_into(field);
    }
}

fn is_standard_input(path: &Path) -> bool {
    path.as_os_str() == "-"
}

/// What a path was given as, to name it in messages.
pub(super) fn origin(path: &Path) -> String {
    if is_standard_input(path) {
        "standard input".to_owned()
    } else {
        printable(&path.display().to_string())
    }
}

/// The bytes of a file, or of standard input; `what` says what the file should
/// be.
pub(super) fn bytes(path: &Path, what: &str) -> anyhow::Result<Vec<u8>> {
    if is_standard_input(path) {
        return limited(io::stdin().lock());
    }
    let told = |error| told(error, what);
    let file = File::open(path).map_err(told)?;
    let about = file.metadata().map_err(told)?;
    if about.is_dir() {
        bail!("this is a directory; {what}");
    }
    // Before reading any of it. A pipe or a device has no length of its own.
    match usize::try_from(about.len()) {
        Ok(bytes) if bytes <= MAX_FILE_BYTES => limited(file),
        Ok(bytes) => Err(SceneError::TooLarge { bytes }.into()),
        Err(_) => Err(SceneError::TooLarge { bytes: usize::MAX }.into()),
    }
}

/// Everything a reader gives, unless that is more than a scene can be.
fn limited(reader: impl Read) -> anyhow::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    reader
        .take(MAX_FILE_BYTES as u64 + 1)
        .read_to_end(&mut bytes)
        .map_err(|error| told(error, A_SCENE))?;
    if bytes.len() > MAX_FILE_BYTES {
        bail!("this has more than {MAX_FILE_BYTES} bytes, the most a scene has");
    }
    Ok(bytes)
}

/// The system's error in words.
fn told(error: io::Error, what: &str) -> anyhow::Error {
    match error.kind() {
        ErrorKind::NotFound => anyhow::anyhow!("there is no such file"),
        ErrorKind::PermissionDenied => anyhow::anyhow!("you may not read this file"),
        ErrorKind::IsADirectory => {
            anyhow::anyhow!("this is a directory; {what}")
        }
        _ => anyhow::Error::new(error).context("this cannot be read"),
    }
}
