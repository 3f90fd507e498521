//! The records of a CSV text with their lines, and the numbers in them.

use csv::{Position, ReaderBuilder, Trim};

use super::SheetFault;
use crate::scene::limits::{Limits, shown};
use crate::scene::{MAX_FILE_BYTES, quoted};

/// A record with its line in the file.
pub(crate) struct Record {
    /// The line, from 1.
    pub row: usize,
    /// What stands between its separators.
    pub fields: Vec<String>,
}

impl Record {
    /// Whether it names columns: nothing in it is a number.
    pub fn is_head(&self) -> bool {
        self.fields
            .iter()
            .all(|field| field.parse::<f64>().is_err())
    }

    /// The first column with one of these names.
    pub fn column(&self, names: &[&str]) -> Option<usize> {
        self.fields
            .iter()
            .position(|field| names.contains(&field.to_lowercase().as_str()))
    }

    /// The finite number in a column.
    pub fn number(&self, index: usize, column: &'static str) -> Result<f64, SheetFault> {
        let row = self.row;
        let Some(field) = self.fields.get(index).filter(|field| !field.is_empty()) else {
            return Err(SheetFault::Missing { row, column });
        };
        match field.parse::<f64>() {
            Ok(value) if value.is_finite() => Ok(value),
            _ => Err(SheetFault::NotANumber {
                row,
                column,
                found: quoted(field),
            }),
        }
    }

    /// The number in a column, in a range.
    pub fn within(
        &self,
        index: usize,
        column: &'static str,
        range: &Limits,
    ) -> Result<f64, SheetFault> {
        let value = self.number(index, column)?;
        if range.contain(value) {
            return Ok(value);
        }
        Err(SheetFault::OutOfRange {
            row: self.row,
            column,
            value: shown(value),
            allowed: range.to_string(),
            unit: range.unit.symbol(),
        })
    }

    /// The node in a column.
    pub fn node(&self, index: usize) -> Result<u32, SheetFault> {
        let value = self.number(index, "node")?;
        if value.fract() == 0.0 && (0.0..=1e9).contains(&value) {
            Ok(value as u32)
        } else {
            let row = self.row;
            Err(SheetFault::Node { row, value })
        }
    }
}

/// The bytes of a file as text.
pub(super) fn text(bytes: &[u8]) -> Result<&str, SheetFault> {
    if bytes.len() > MAX_FILE_BYTES {
        let bytes = bytes.len();
        return Err(SheetFault::TooLarge { bytes });
    }
    str::from_utf8(bytes).map_err(|error| {
        let before = bytes.get(..error.valid_up_to()).unwrap_or_default();
        let row = 1 + newlines(before);
        SheetFault::NotText { row }
    })
}

/// All records of a CSV text; `#` starts a comment.
///
/// # Errors
/// When the text is not CSV. No text is known that is not.
pub(crate) fn records(text: &str) -> Result<Vec<Record>, SheetFault> {
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    let mut reader = ReaderBuilder::new()
        .has_headers(false)
        .flexible(true)
        .comment(Some(b'#'))
        .delimiter(separator(text))
        .trim(Trim::All)
        .from_reader(text.as_bytes());
    let mut found = Vec::new();
    let (mut row, mut counted) = (1, 0);
    for record in reader.records() {
        let record = record.map_err(|error| SheetFault::NotCsv(error.to_string()))?;
        let from = record.position().map_or(0, Position::byte) as usize;
        let at = from + skipped(text.get(from..).unwrap_or_default());
        row += newlines(text.as_bytes().get(counted..at).unwrap_or_default());
        counted = at;
        let fields = record.iter().map(str::to_owned).collect();
        found.push(Record { row, fields });
    }
    Ok(found)
}

/// What separates columns: what the first record has, a comma before others.
fn separator(text: &str) -> u8 {
    let rest = text.get(skipped(text)..).unwrap_or_default();
    let first = rest.lines().next().unwrap_or_default();
    let there = |separator: &u8| first.as_bytes().contains(separator);
    b",;\t".iter().copied().find(|s| there(s)).unwrap_or(b',')
}

fn newlines(bytes: &[u8]) -> usize {
    bytes.iter().filter(|byte| **byte == b'\n').count()
}

/// The bytes of blank lines and comments at a text's start, which the reader
/// counts as part of the record after them.
fn skipped(text: &str) -> usize {
    let lines = text.split_inclusive('\n');
    let empty = |line: &&str| line.trim().is_empty() || line.starts_with('#');
    lines.take_while(empty).map(str::len).sum()
}
