//! Rows of a table that hold nothing, and the sentence that says so.

use super::record::Record;
use std::fmt;

/// Rows named in the sentence; of more than these, only the number is told.
const NAMED: usize = 5;

/// The rows that were left out, because they are blank or NaN.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct LeftOut(Vec<usize>);

impl LeftOut {
    /// These rows, lines of the file from 1.
    pub(super) fn new(rows: Vec<usize>) -> Self {
        Self(rows)
    }

    /// The rows, from the top.
    pub fn rows(&self) -> &[usize] {
        &self.0
    }

    /// Those records with something in the columns and no NaN; the others are
    /// left out.
    pub(super) fn rest_of<'a, const N: usize>(
        &mut self,
        records: &'a [Record],
        columns: [usize; N],
    ) -> Vec<&'a Record> {
        let holds_nothing = |record: &&Record| {
            columns.iter().any(|column| record.is_nan(*column))
                || columns.iter().all(|column| record.is_empty(*column))
        };
        let (nothing, kept): (Vec<&Record>, Vec<&Record>) = records.iter().partition(holds_nothing);
        self.0.extend(nothing.iter().map(|record| record.row));
        self.0.sort_unstable();
        kept
    }
}

/// `rows 4, 7 and 9 hold no numbers and were left out`; nothing without rows.
impl fmt::Display for LeftOut {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (last, others) = match &self.0[..] {
            [] => return Ok(()),
            [row] => return write!(f, "row {row} holds no numbers and was left out"),
            rows @ [.., last] if rows.len() <= NAMED => (last.to_string(), &rows[..rows.len() - 1]),
            rows => (format!("{} more", rows.len() - NAMED), &rows[..NAMED]),
        };
        let others: Vec<String> = others.iter().map(usize::to_string).collect();
        let others = others.join(", ");
        write!(
            f,
            "rows {others} and {last} hold no numbers and were left out"
        )
    }
}
