//! What a study would take, from a few of its samples.

use std::io::{self, Write};
use std::ops::Range;
use std::path::Path;
use std::time::{Duration, Instant};

use super::super::output::{paragraph, printable, write_out};
use super::super::{Failure, Outcome};
use super::count;
use super::pool::duration;
use super::report::{threads, title};
use crate::scene::limits::shown;
use crate::study::log::{CHECKSUM_BYTES, CHUNK_HEAD_BYTES, HEAD_BYTES, chunk};
use crate::study::{Parameter, Sampler, Scale, Study, Values};

/// Most samples that are tried, and the time after which no other is.
const TRIED: u64 = 64;
const PATIENCE: Duration = Duration::from_millis(500);

/// What a few samples took.
struct Tried {
    samples: u64,
    seconds: f64,
    /// Bytes of their rows in a log, and in the table.
    log: u64,
    table: u64,
}

/// Tells how many samples there are, and what they take.
pub(super) fn explain(
    study: &Study,
    todo: &[Range<u64>],
    on: usize,
    folder: &Path,
) -> Result<Outcome, Failure> {
    let tried = try_some(study, todo);
    write_out(|out| text(out, study, count(todo), &tried, on, folder))?;
    Ok(Outcome::Done)
}

/// Computes a few samples, from all over the ranges.
fn try_some(study: &Study, todo: &[Range<u64>]) -> Tried {
    let all = count(todo);
    let mut tried = Tried {
        samples: 0,
        seconds: 0.0,
        log: 0,
        table: 0,
    };
    let started = Instant::now();
    for turn in 0..TRIED.min(all) {
        // The golden section's: spread over all, however soon it ends.
        let share = (0.5 + 0.618_033_988_749_895 * turn as f64).fract();
        let index = at(todo, ((share * all as f64) as u64).min(all - 1));
        let began = Instant::now();
        let row = study.compute(index);
        tried.seconds += began.elapsed().as_secs_f64();
        tried.samples += 1;
        let cells = study.cells(index, &row);
        tried.table += cells.iter().map(|cell| cell.len() as u64 + 1).sum::<u64>();
        tried.log += (chunk(index, &[row]).len() - CHUNK_HEAD_BYTES - CHECKSUM_BYTES) as u64;
        if started.elapsed() > PATIENCE {
            break;
        }
    }
    tried
}

/// The index at a place of ranges one after the other.
fn at(ranges: &[Range<u64>], mut place: u64) -> u64 {
    for range in ranges {
        let length = range.end - range.start;
        if place < length {
            return range.start + place;
        }
        place -= length;
    }
    unreachable!("a place beyond all ranges")
}

fn text(
    out: &mut impl Write,
    study: &Study,
    todo: u64,
    tried: &Tried,
    on: usize,
    folder: &Path,
) -> io::Result<()> {
    writeln!(out, "{}\n", title(study))?;
    let sampler = match study.file().sampler {
        Sampler::Grid => "on a grid".to_owned(),
        Sampler::Latin => format!("of a Latin hypercube with seed {}", study.file().seed),
        Sampler::Sobol => format!("of Sobol's sequence with seed {}", study.file().seed),
    };
    let to_do = match study.samples() {
        all if all == todo => String::new(),
        _ => format!(", {todo} of them to do"),
    };
    writeln!(out, "  samples     {} {sampler}{to_do}", study.samples())?;
    for (place, parameter) in study.parameters().iter().enumerate() {
        let label = if place == 0 { "parameters" } else { "" };
        writeln!(out, "  {label:<10}  {}", values(parameter))?;
    }
    let outputs: Vec<&str> = study.outputs().iter().map(|one| one.name()).collect();
    paragraph(out, "  outputs     ", &outputs.join(", "))?;
    writeln!(
        out,
        "  each        followed from the straight robot, in steps of at most 1/16 of its cable \
         offset"
    )?;
    if tried.samples == 0 {
        return writeln!(out, "  nothing is left to do");
    }
    let one = tried.seconds / tried.samples as f64;
    writeln!(
        out,
        "  time        about {} on {}, by {} samples that took {} each",
        duration(one * todo as f64 / on as f64),
        threads(on),
        tried.samples,
        duration(one)
    )?;
    let share = todo as f64 / tried.samples as f64;
    let log = HEAD_BYTES as f64 + share * tried.log as f64;
    writeln!(
        out,
        "  room        about {} of log and {} of table in {}",
        bytes(log),
        bytes(share * tried.table as f64),
        printable(&folder.display().to_string())
    )
}

/// A parameter with its values.
fn values(parameter: &Parameter) -> String {
    let mut text = format!("{}: ", printable(&parameter.key));
    match &parameter.values {
        Values::List(list) if list.len() <= 8 => {
            let list: Vec<String> = list.iter().copied().map(shown).collect();
            text += &list.join(", ");
        }
        Values::List(list) => {
            let (least, most) = parameter.values.ends();
            text += &format!("{} values, {} to {}", list.len(), shown(least), shown(most));
        }
        Values::Range {
            from,
            to,
            steps,
            scale,
        } => {
            text += &format!("{} to {}", shown(*from), shown(*to));
            if let Some(steps) = steps {
                text += &format!(" in {steps} values");
            }
            if *scale == Scale::Log {
                text += ", at equal ratios";
            }
        }
    }
    if let Some(name) = &parameter.name {
        text += &format!(" (with others of the name {})", printable(name));
    }
    text
}

/// Bytes in the unit that people would use.
fn bytes(count: f64) -> String {
    match count {
        1e9.. => format!("{:.1} GB", 1e-9 * count),
        1e6.. => format!("{:.1} MB", 1e-6 * count),
        1e3.. => format!("{:.1} kB", 1e-3 * count),
        _ => format!("{count:.0} bytes"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn places_go_on_from_range_to_range() {
        let ranges = [3..5, 9..10, 20..22];
        let all: Vec<u64> = (0..5).map(|place| at(&ranges, place)).collect();
        assert_eq!(all, [3, 4, 9, 20, 21]);
    }

    #[test]
    fn bytes_have_the_unit_that_people_use() {
        assert_eq!(bytes(999.0), "999 bytes");
        assert_eq!(bytes(12_345.0), "12.3 kB");
        assert_eq!(bytes(2.5e6), "2.5 MB");
        assert_eq!(bytes(1e10), "10.0 GB");
    }
}
