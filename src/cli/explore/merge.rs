//! `sinew merge`: the table of a study from the logs of its shards.

use std::io::{self, BufWriter, Write};
use std::ops::Range;
use std::path::Path;

use super::super::arguments::{Edits, Merge};
use super::super::input::{BadInput, origin};
use super::super::output::{reader, write_out};
use super::super::{Failure, Outcome};
use super::folder::{Folder, Log, STUDY, done};
use super::{count, report, study, table};

pub(in super::super) fn run(what: &Merge) -> Result<Outcome, Failure> {
    // The command line asks for at least one.
    let first = what.folders.first().map_or(Path::new("."), |path| path);
    let file = first.join(STUDY);
    if !file.exists() {
        let told = format!(
            "{} has no {STUDY}; name a folder that sinew explore has written",
            origin(first)
        );
        return Err(BadInput::Arguments(told).into());
    }
    let study = study(&file, &Edits::default())?;
    let mut logs: Vec<Log> = Vec::new();
    for path in &what.folders {
        let found = Folder::new(path, &study).logs()?;
        if found.is_empty() {
            let told = format!("{} has no results", origin(path));
            return Err(BadInput::Arguments(told).into());
        }
        logs.extend(found);
    }
    let missing = done(&logs).missing(0..study.samples());
    if !missing.is_empty() && !what.partial {
        return Err(BadInput::Arguments(lacking(&missing, study.samples())).into());
    }
    let path = match &what.out {
        Some(path) if path.as_os_str() == "-" => {
            let mut out = BufWriter::new(io::stdout().lock());
            return match table::write_to(&study, &logs, &mut out) {
                Ok(_) => {
                    reader(out.flush())?;
                    Ok(Outcome::Done)
                }
                // Whoever stopped reading has all that was wanted.
                Err(Failure::Output(error)) => {
                    reader(Err(error))?;
                    Ok(Outcome::Done)
                }
                Err(failure) => Err(failure),
            };
        }
        Some(path) => path.clone(),
        None => Folder::new(first, &study).csv(),
    };
    let summary = table::write(&study, &logs, &path)?;
    write_out(|out| {
        writeln!(out, "{}\n", report::title(&study))?;
        report::summary(out, &study, &summary)?;
        writeln!(out, "\n  {}", origin(&path))
    })?;
    Ok(Outcome::Done)
}

/// Which samples are missing, in words.
fn lacking(missing: &[Range<u64>], samples: u64) -> String {
    /// Ranges that are named.
    const NAMED: usize = 4;
    let named = missing
        .iter()
        .take(NAMED)
        .map(|range| match range.end - range.start {
            1 => range.start.to_string(),
            _ => format!("{} to {}", range.start, range.end - 1),
        });
    let mut named = named.collect::<Vec<_>>().join(", ");
    if missing.len() > NAMED {
        named += " and others";
    }
    format!(
        "{} of the {samples} samples are missing: {named}; compute them with sinew explore \
         --resume, name the folders that have them, or add --partial",
        count(missing)
    )
}
