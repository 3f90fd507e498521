//! Tables as CSV. Which columns there are is not its business.

use std::io::{self, Write};

use crate::math::shortest;
use crate::record::Solution;
use crate::record::nodes::{COLUMNS, PULL_COLUMN, rows};

pub(super) fn solution(out: &mut impl Write, state: &Solution) -> io::Result<()> {
    let mut table = ::csv::Writer::from_writer(out);
    csv_row(&mut table, COLUMNS)?;
    for row in rows(state) {
        csv_row(&mut table, row)?;
    }
    table.flush()
}

pub(super) fn path_state(out: &mut impl Write, index: usize, state: &Solution) -> io::Result<()> {
    let mut table = ::csv::Writer::from_writer(out);
    if index == 0 {
        csv_row(&mut table, [PULL_COLUMN].into_iter().chain(COLUMNS))?;
    }
    for row in rows(state) {
        let first = state.cables.first();
        let pull = first.map_or_else(String::new, |cable| shortest(cable.pull_mm));
        csv_row(&mut table, [pull].into_iter().chain(row))?;
    }
    table.flush()
}

/// Writes a row; a closed pipe stays known for one.
pub(in crate::cli) fn csv_row<W: Write, T: AsRef<[u8]>>(
    table: &mut ::csv::Writer<W>,
    fields: impl IntoIterator<Item = T>,
) -> io::Result<()> {
    table
        .write_record(fields)
        .map_err(|error| match error.into_kind() {
            // As it is, so that a closed pipe is known for one.
            ::csv::ErrorKind::Io(error) => error,
            other => io::Error::other(format!("{other:?}")),
        })
}
