//! `sinew explore`: samples of a study, computed on all processors into a folder that
//! survives being stopped anywhere, and told of. What a sample is, [`crate::study`] says.

mod explain;
mod folder;
mod merge;
mod pool;
mod report;
mod table;

use std::io::Write;
use std::num::NonZero;
use std::ops::Range;
use std::path::{Path, PathBuf};
use std::thread;

use super::arguments::{Edits, Explore};
use super::input::{self, BadInput};
use super::output::write_out;
use super::progress::Progress;
use super::{Failure, Outcome, tell};
use crate::study::{Output, Ranges, Study, StudyFile, shard};
use folder::Folder;

pub(super) use merge::run as merge;

/// What a study's file should be.
const A_STUDY: &str = "a study is a TOML text file";
/// Steps of the progress bar.
const RESOLUTION: u32 = 1000;

pub(super) fn run(what: &Explore) -> Result<Outcome, Failure> {
    if what.outputs {
        return list_outputs();
    }
    // The command line asks for one where the list is not asked for.
    let path = what.study.as_deref().unwrap_or(Path::new("-"));
    let study = study(path, &what.edits)?;
    let threads = threads(what.threads);
    let part = part(what.shard.as_deref())?;
    let range = match part {
        Some((part, parts)) => shard(study.samples(), part, parts),
        None => 0..study.samples(),
    };
    let folder = Folder::new(&what.out, &study);
    if what.explain {
        let done = if what.resume {
            folder::done(&folder.logs()?)
        } else {
            Ranges::default()
        };
        let todo = done.missing(range);
        return explain::explain(&study, &todo, threads, &what.out);
    }
    let name = match part {
        Some((part, parts)) => format!("results-{part}-of-{parts}.log"),
        None => "results.log".to_owned(),
    };
    // Before anything is changed there.
    folder.logs()?;
    folder.make()?;
    let mut log = folder.open(&name, range.clone())?;
    let logs = folder.logs()?;
    let todo = folder::done(&logs).missing(range.clone());
    if !what.resume {
        refuse_what_is_there(&folder, &todo, &range)?;
    }
    folder.keep_study()?;
    if let Some(note) = log.mend(&logs)? {
        tell(&note);
    }
    let told = report::Told::begin(&study, &todo, threads);
    let mut progress = Progress::new("exploring", RESOLUTION);
    let computed = pool::compute(&study, &todo, threads, |first, rows, so_far| {
        log.append(first, rows)?;
        let share = so_far.done as f64 / so_far.all as f64;
        progress.say(so_far.pace());
        progress.at((share * f64::from(RESOLUTION)) as u32);
        Ok(())
    });
    drop(progress);
    let seconds = computed?;
    log.finish()?;
    let summary = match part {
        None => Some(table::write(&study, &folder.logs()?, &folder.csv())?),
        Some(_) => None,
    };
    write_out(|out| told.end(out, &folder, summary.as_ref(), seconds))?;
    Ok(Outcome::Done)
}

/// Refuses to compute again what a folder has, and to write over what it does not know.
fn refuse_what_is_there(
    folder: &Folder<'_>,
    todo: &[Range<u64>],
    range: &Range<u64>,
) -> Result<(), BadInput> {
    let there = range.end - range.start - count(todo);
    if there > 0 {
        return Err(BadInput::Arguments(format!(
            "{} has {there} of these {} samples already; go on with --resume, or name another \
             folder with --out",
            input::origin(folder.path()),
            range.end - range.start
        )));
    }
    let table = folder.csv();
    match table.exists() {
        true => Err(BadInput::Arguments(format!(
            "{} is there already, without the results that it would be made of; name another \
             folder with --out",
            input::origin(&table)
        ))),
        false => Ok(()),
    }
}

/// How many samples there are in ranges.
fn count(ranges: &[Range<u64>]) -> u64 {
    ranges.iter().map(|one| one.end - one.start).sum()
}

/// A study from its file, with its scene.
fn study(path: &Path, edits: &Edits) -> Result<Study, BadInput> {
    let origin = input::origin(path);
    let file = input::bytes(path, A_STUDY)
        .and_then(|bytes| Ok(StudyFile::from_toml_bytes(&bytes)?))
        .map_err(|error: anyhow::Error| error.context(origin.clone()))?;
    let scene = scene_path(path, &file.scene);
    let scene = input::scene(&scene, edits)?;
    let study = Study::new(file, scene);
    study.map_err(|error| anyhow::Error::new(error).context(origin).into())
}

/// A study's scene lies where its file says, from the folder of the study's file.
fn scene_path(study: &Path, scene: &str) -> PathBuf {
    match study.parent() {
        Some(folder) => folder.join(scene),
        None => PathBuf::from(scene),
    }
}

/// The threads to compute on: those that were asked for, or one a processor.
fn threads(asked: Option<u32>) -> usize {
    let here = || thread::available_parallelism().map_or(1, NonZero::get);
    asked.map_or_else(here, |asked| asked as usize)
}

/// A part K of N parts, from `K/N`.
fn part(text: Option<&str>) -> Result<Option<(u64, u64)>, BadInput> {
    let Some(text) = text else { return Ok(None) };
    let numbers = text.split_once('/').and_then(|(part, parts)| {
        let number = |text: &str| text.trim().parse::<u64>().ok();
        Some((number(part)?, number(parts)?))
    });
    match numbers {
        Some((part, parts)) if (1..=parts).contains(&part) && parts <= MOST_PARTS => {
            Ok(Some((part, parts)))
        }
        _ => Err(BadInput::Arguments(format!(
            "--shard is \"{}\"; write K/N with K from 1 to N, and N at most {MOST_PARTS}, such as \
             2/8",
            super::output::printable(text)
        ))),
    }
}

/// The most parts that a study is cut into.
const MOST_PARTS: u64 = 100_000;

fn list_outputs() -> Result<Outcome, Failure> {
    let width = Output::all().map(|one| one.name().len()).max().unwrap_or(0);
    write_out(|out| {
        Output::all().try_for_each(|one| {
            let (name, unit) = (one.name(), one.unit());
            writeln!(out, "{name:<width$}  {unit:<4}  {}", one.meaning())
        })
    })?;
    Ok(Outcome::Done)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parts_are_k_of_n() {
        let of = |text| part(Some(text)).ok().flatten();
        assert_eq!(of("2/8"), Some((2, 8)));
        assert_eq!(of(" 8 / 8"), Some((8, 8)));
        for wrong in [
            "", "2", "0/8", "9/8", "-1/8", "1/0", "1/2/3", "a/b", "1/100001",
        ] {
            assert!(part(Some(wrong)).is_err(), "{wrong}");
        }
    }

    #[test]
    fn a_scene_lies_beside_its_study() {
        let of = |study: &str| scene_path(Path::new(study), "a.toml");
        assert_eq!(of("studies/s.toml"), Path::new("studies/a.toml"));
        assert_eq!(of("s.toml"), Path::new("a.toml"));
        assert_eq!(of("-"), Path::new("a.toml"));
    }
}
