//! The records of a CSV text with their lines in the file. What they mean, and
//! which of them is a head, is not its business.

use csv::{Position, ReaderBuilder, Trim};
use std::borrow::Cow;

use super::SheetFault;
use super::record::Record;
use crate::scene::MAX_FILE_BYTES;

/// What stands in a CSV text.
pub(super) struct Table {
    /// The rows that hold something.
    pub records: Vec<Record>,
    /// The last comment above the first record, as a record of its own, where it
    /// has as many fields: numpy writes heads there.
    pub comment: Option<Record>,
    /// The lines of rows that hold nothing, among those that do.
    pub blank: Vec<usize>,
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
#[cfg(feature = "cli")]
pub(crate) fn records(text: &str) -> Result<Vec<Record>, SheetFault> {
    Ok(Table::read(text)?.records)
}

impl Table {
    /// What stands in a text. A first line `sep=;` names the separator, as
    /// spreadsheets write it; else it is a comma, a semicolon, a tab or spaces,
    /// the first of these that the first record has.
    ///
    /// # Errors
    /// Those of [`records`].
    pub fn read(text: &str) -> Result<Table, SheetFault> {
        let text = text.strip_prefix('\u{feff}').unwrap_or(text);
        let (named, from) = named_separator(text);
        let separator = named.unwrap_or_else(|| separator(text));
        let text = match separator {
            b' ' => Cow::Owned(single_spaced(text)),
            _ => Cow::Borrowed(text),
        };
        let mut table = Table::of(&text, separator, from)?;
        // What follows the last row ends the file.
        let last = table.records.last().map_or(0, |record| record.row);
        table.blank.retain(|row| *row < last);
        if let Some(first) = table.records.first() {
            let columns = first.filled();
            let comment = comment_above(&text, first.row)?;
            table.comment = comment.filter(|comment| comment.fields.len() == columns);
        }
        Ok(table)
    }

    /// The records of a text with a known separator, from an offset on.
    fn of(text: &str, separator: u8, from: usize) -> Result<Table, SheetFault> {
        let body = text.get(from..).unwrap_or_default();
        let mut reader = ReaderBuilder::new()
            .has_headers(false)
            .flexible(true)
            .comment(Some(b'#'))
            .delimiter(separator)
            .trim(Trim::All)
            .from_reader(body.as_bytes());
        let mut table = Table {
            records: Vec::new(),
            comment: None,
            blank: Vec::new(),
        };
        let (mut row, mut counted) = (1, 0);
        for record in reader.records() {
            let record = record.map_err(|error| SheetFault::NotCsv(error.to_string()))?;
            let start = from + record.position().map_or(0, Position::byte) as usize;
            let passed = text.get(counted..start).unwrap_or_default();
            row += newlines(passed.as_bytes());
            counted = start;
            // The reader ends a record at the first byte of \r\n.
            let ends_here = text
                .as_bytes()
                .get(..start)
                .is_some_and(|t| t.ends_with(b"\r"));
            for (index, line) in idle_lines(text.get(start..).unwrap_or_default()).enumerate() {
                let ends_record = index == 0 && ends_here && line == "\n";
                if line.trim().is_empty() && !ends_record && !table.records.is_empty() {
                    table.blank.push(row);
                }
                row += newlines(line.as_bytes());
                counted += line.len();
            }
            let fields = record.iter().map(str::to_owned).collect();
            let record = Record { row, fields };
            if record.filled() > 0 {
                table.records.push(record);
            } else if !table.records.is_empty() {
                table.blank.push(row);
            }
        }
        Ok(table)
    }
}

/// The separator that a first line such as `sep=;` names, and where the lines
/// after it begin.
fn named_separator(text: &str) -> (Option<u8>, usize) {
    let line = text.lines().next().unwrap_or_default();
    let bare = line.trim_end().trim_matches('"').to_ascii_lowercase();
    let name = bare.strip_prefix("sep=").map(str::as_bytes);
    match name {
        // A tab at a line's end has been trimmed.
        Some([]) if line.ends_with('\t') => (Some(b'\t'), line.len()),
        Some([separator @ (b',' | b';' | b'|')]) => (Some(*separator), line.len()),
        _ => (None, 0),
    }
}

/// What separates columns: what the first record has, a comma before others.
fn separator(text: &str) -> u8 {
    let mut lines = text.lines();
    let first = lines.find(|line| !line.trim().is_empty() && !is_comment(line));
    let there = |separator: &u8| first.is_some_and(|line| line.as_bytes().contains(separator));
    let known = b",;\t".iter().copied().find(|s| there(s));
    let spaced = first.is_some_and(|line| line.split_whitespace().nth(1).is_some());
    known.unwrap_or(if spaced { b' ' } else { b',' })
}

/// A text whose columns are separated by spaces, with one space between them:
/// those that align columns go, and so does that before a unit in brackets.
fn single_spaced(text: &str) -> String {
    let mut spaced = String::with_capacity(text.len());
    for line in text.split_inclusive('\n') {
        let words = line.split_whitespace();
        for (index, word) in words.enumerate() {
            if index > 0 && !word.starts_with(['(', '[']) {
                spaced.push(' ');
            }
            spaced.push_str(word);
        }
        if line.ends_with('\n') {
            spaced.push('\n');
        }
    }
    spaced
}

/// The comment right above a row, if there is one.
fn comment_above(text: &str, row: usize) -> Result<Option<Record>, SheetFault> {
    let above = text.lines().take(row.saturating_sub(1));
    let Some((index, line)) = above.enumerate().filter(|(_, l)| is_comment(l)).last() else {
        return Ok(None);
    };
    let line = line.trim_start_matches('#').trim();
    // A head may be separated otherwise than what is below it.
    let separator = separator(line);
    let line = match separator {
        b' ' => Cow::Owned(single_spaced(line)),
        _ => Cow::Borrowed(line),
    };
    let words = Table::of(&line, separator, 0)?.records;
    let first = words.into_iter().next();
    Ok(first.map(|record| Record {
        row: index + 1,
        ..record
    }))
}

fn newlines(bytes: &[u8]) -> usize {
    bytes.iter().filter(|byte| **byte == b'\n').count()
}

/// The empty lines and comments at a text's start, which the reader counts as
/// part of the record after them.
fn idle_lines(text: &str) -> impl Iterator<Item = &str> {
    let lines = text.split_inclusive('\n');
    lines.take_while(|line| line.trim_end_matches(['\r', '\n']).is_empty() || is_comment(line))
}

fn is_comment(line: &str) -> bool {
    line.starts_with('#')
}
