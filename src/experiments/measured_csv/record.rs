//! A row of a table of measurements, and the numbers in it.

use super::SheetFault;
use crate::scene::limits::{Limits, shown};
use crate::scene::quoted;

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

    /// Its fields up to the last that is not empty.
    pub fn filled(&self) -> usize {
        let last = self.fields.iter().rposition(|field| !field.is_empty());
        last.map_or(0, |last| last + 1)
    }

    /// Whether there is nothing in a column.
    pub fn is_empty(&self, index: usize) -> bool {
        self.fields.get(index).is_none_or(String::is_empty)
    }

    /// Whether a column says that there was nothing to measure.
    pub fn is_nan(&self, index: usize) -> bool {
        let field = self.fields.get(index);
        field.is_some_and(|field| field.parse::<f64>().is_ok_and(f64::is_nan))
    }

    /// The finite number in a column.
    pub fn number(&self, index: usize, column: &str) -> Result<f64, SheetFault> {
        let (row, column) = (self.row, column.to_owned());
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

    /// The number in a column, in a unit of so many of the range's, in that
    /// range.
    pub fn within(
        &self,
        index: usize,
        column: &str,
        unit: f64,
        range: &Limits,
    ) -> Result<f64, SheetFault> {
        let value = unit * self.number(index, column)?;
        if range.contain(value) {
            return Ok(value);
        }
        Err(SheetFault::OutOfRange {
            row: self.row,
            column: column.to_owned(),
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
