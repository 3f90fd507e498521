//! The rows of logs as one table in CSV, in the order of the samples, whoever computed
//! them and whenever; and a summary of them, made on the way.

use std::io::Write;
use std::path::Path;

use super::super::Failure;
use super::super::output::csv_row;
use super::folder::{Chunk, Log, write_whole};
use crate::study::{Output, Row, Study, Verdict};

/// What a table's rows come to.
#[derive(Debug, Default)]
pub(super) struct Summary {
    /// How many rows there are.
    pub rows: u64,
    /// How many ended in which way, in the order of [`Verdict::ALL`].
    pub verdicts: [u64; Verdict::ALL.len()],
    /// How many meet all constraints.
    pub feasible: u64,
    /// Of every output with a number, the least and the greatest with their samples.
    pub ends: Vec<(Output, Option<Ends>)>,
}

/// The least and the greatest of some numbers, each with the first sample that has it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Ends {
    pub least: (f64, u64),
    pub greatest: (f64, u64),
}

/// Writes the table of all rows that logs have into a file, which is there whole or not at
/// all.
///
/// # Errors
/// If a log cannot be read or the file not be written.
pub(super) fn write(study: &Study, logs: &[Log], path: &Path) -> Result<Summary, Failure> {
    write_whole(path, |file| write_to(study, logs, file))
}

/// Writes the table of all rows that logs have.
///
/// # Errors
/// If a log cannot be read or the table not be written.
pub(super) fn write_to(
    study: &Study,
    logs: &[Log],
    out: &mut impl Write,
) -> Result<Summary, Failure> {
    let mut table = ::csv::Writer::from_writer(out);
    csv_row(&mut table, study.columns())?;
    let told: Vec<(usize, Output)> = study.told().collect();
    let mut summary = Summary {
        ends: told.iter().map(|(_, output)| (*output, None)).collect(),
        ..Summary::default()
    };
    let mut chunks: Vec<(&Log, &Chunk)> = logs
        .iter()
        .flat_map(|log| log.chunks().iter().map(move |chunk| (log, chunk)))
        .collect();
    chunks.sort_by_key(|(_, chunk)| chunk.samples.start);
    let mut next = 0;
    for (log, chunk) in chunks {
        // Two processes may have computed the same: then it is the same.
        if chunk.samples.end <= next {
            continue;
        }
        for (index, row) in chunk.samples.clone().zip(log.rows(chunk)?) {
            if index >= next {
                csv_row(&mut table, study.cells(index, &row))?;
                summary.add(study, index, &row, &told);
                next = index + 1;
            }
        }
    }
    table.flush()?;
    Ok(summary)
}

impl Summary {
    fn add(&mut self, study: &Study, index: u64, row: &Row, told: &[(usize, Output)]) {
        self.rows += 1;
        let verdict = Verdict::ALL.iter().position(|one| *one == row.verdict);
        self.verdicts[verdict.unwrap_or_default()] += 1;
        self.feasible += u64::from(study.is_feasible(row));
        for ((place, _), (_, ends)) in told.iter().zip(&mut self.ends) {
            let number = row.numbers[*place];
            if number.is_nan() {
                continue;
            }
            let here = (number, index);
            let ends = ends.get_or_insert(Ends {
                least: here,
                greatest: here,
            });
            if number < ends.least.0 {
                ends.least = here;
            }
            if number > ends.greatest.0 {
                ends.greatest = here;
            }
        }
    }
}
