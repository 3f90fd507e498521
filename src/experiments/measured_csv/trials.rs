//! Rows of what was done to a robot and what was read: loads, pulls and forces, and the
//! values of the scene that they were measured at. Which scene that is, is not its
//! business.

use super::SheetFault;
use super::columns::{Column, LENGTHS, found, weights};
use super::record::Record;
use super::table::{Table, text};
use super::{at_most, below, left_out::LeftOut};
use crate::scene::limits::{self, Limits};
use crate::scene::{nearest, quoted};

/// The columns of measurements; every other one is a key of the scene.
const COLUMNS: [&str; 4] = ["load_g", "load_from_contact_g", "pull_mm", "force_g"];

/// A table of trials.
#[derive(Clone, Debug, PartialEq)]
pub struct Trials {
    /// The line of the head in the file, from 1.
    pub head: usize,
    /// The keys of the scene that columns are named by.
    pub keys: Vec<String>,
    /// The rows, from the top.
    pub rows: Vec<Trial>,
}

/// A weight on the first cable, in grams.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Weight {
    /// All of it.
    Whole(f64),
    /// What came on after the robot had begun to press.
    FromContact(f64),
}

/// A row.
#[derive(Clone, Debug, PartialEq)]
pub struct Trial {
    /// Its line in the file, from 1.
    pub row: usize,
    /// What hung on the cable.
    pub weight: Option<Weight>,
    /// How much cable was drawn in, in mm: what was given, or read under a weight.
    pub pull_mm: Option<f64>,
    /// The force on the obstacles that was read, in grams.
    pub force_g: Option<f64>,
    /// The values of [`Trials::keys`], as they are written.
    pub settings: Vec<String>,
}

impl Trials {
    /// The trials in the bytes of a file, and the rows that hold nothing. There is at
    /// least one.
    ///
    /// # Errors
    /// The first fault, from the top.
    pub fn read(bytes: &[u8]) -> Result<(Self, LeftOut), SheetFault> {
        let table = Table::read(text(bytes)?)?;
        let mut left_out = LeftOut::new(table.blank);
        let [first, rows @ ..] = &table.records[..] else {
            return Err(SheetFault::NoTrials);
        };
        let (head, rows) = match &table.comment {
            _ if first.is_head() => (first, rows),
            Some(comment) => (comment, &table.records[..]),
            None => return Err(SheetFault::NoTrialHead { row: first.row }),
        };
        let columns = Columns::of(head)?;
        let rows = left_out.rest_of(below(head, rows)?, columns.places());
        at_most(rows.len(), limits::READINGS)?;
        let rows = rows.into_iter().map(|record| columns.trial(record));
        let rows = rows.collect::<Result<Vec<_>, _>>()?;
        if rows.is_empty() {
            return Err(SheetFault::NoTrials);
        }
        let keys = columns.keys.iter().map(|(_, key)| key.clone());
        Ok((
            Self {
                head: head.row,
                keys: keys.collect(),
                rows,
            },
            left_out,
        ))
    }
}

struct Columns {
    load: Option<Column>,
    from_contact: Option<Column>,
    pull: Option<Column>,
    force: Option<Column>,
    /// The place and name of every other column.
    keys: Vec<(usize, String)>,
}

impl Columns {
    fn of(head: &Record) -> Result<Self, SheetFault> {
        let row = head.row;
        let units = weights();
        let column = |name: &[&str], units| -> Result<Option<Column>, SheetFault> {
            Ok(found(head, name, units)?.map(|named| named.column))
        };
        let mut columns = Self {
            load: column(&["load"], &units)?,
            from_contact: column(&["load", "from", "contact"], &units)?,
            pull: column(&["pull"], &LENGTHS)?,
            force: column(&["force"], &units)?,
            keys: Vec::new(),
        };
        let places: Vec<usize> = columns.measured().map(|column| column.index).collect();
        for (index, field) in head.fields.iter().enumerate() {
            if places.contains(&index) {
                continue;
            }
            // All that a measurement can set has a table in its name.
            if !field.contains('.') {
                return Err(SheetFault::UnknownColumn {
                    row,
                    found: quoted(field),
                    nearest: nearest(field, &COLUMNS),
                });
            }
            columns.keys.push((index, field.clone()));
        }
        let Self { load, pull, .. } = &columns;
        if load.is_none() && columns.from_contact.is_none() && pull.is_none() {
            return Err(SheetFault::NothingGiven { row });
        }
        let weighed = load.is_some() || columns.from_contact.is_some();
        if columns.force.is_none() && !(weighed && pull.is_some()) {
            return Err(SheetFault::NothingRead { row });
        }
        Ok(columns)
    }

    fn measured(&self) -> impl Iterator<Item = &Column> + Clone {
        let all = [&self.load, &self.from_contact, &self.pull, &self.force];
        all.into_iter().flatten()
    }

    /// The places of all that is measured; some of them twice.
    fn places(&self) -> [usize; 4] {
        let mut places = [0; 4];
        for (place, column) in places.iter_mut().zip(self.measured().cycle()) {
            *place = column.index;
        }
        places
    }

    fn trial(&self, record: &Record) -> Result<Trial, SheetFault> {
        let row = record.row;
        let number = |column: &Option<Column>, range: &Limits| {
            let column = column.as_ref().filter(|c| !record.is_empty(c.index));
            let number = column.map(|c| record.within(c.index, &c.name, c.unit, range));
            number.transpose()
        };
        let whole = number(&self.load, &limits::LOAD)?;
        let from_contact = number(&self.from_contact, &limits::LOAD)?;
        let weight = match (whole, from_contact) {
            (Some(_), Some(_)) => return Err(SheetFault::TwoLoads { row }),
            (Some(load), None) => Some(Weight::Whole(load)),
            (None, Some(load)) => Some(Weight::FromContact(load)),
            (None, None) => None,
        };
        let pull_mm = number(&self.pull, &limits::PULL)?;
        let force_g = number(&self.force, &limits::FORCE)?;
        if weight.is_none() && pull_mm.is_none() {
            return Err(SheetFault::NothingGiven { row });
        }
        if force_g.is_none() && !(weight.is_some() && pull_mm.is_some()) {
            return Err(SheetFault::NothingRead { row });
        }
        let setting = |(index, key): &(usize, String)| match record.fields.get(*index) {
            Some(field) if !field.is_empty() => Ok(field.clone()),
            _ => Err(SheetFault::Missing {
                row,
                column: key.clone(),
            }),
        };
        let settings = self.keys.iter().map(setting);
        Ok(Trial {
            row,
            weight,
            pull_mm,
            force_g,
            settings: settings.collect::<Result<_, _>>()?,
        })
    }
}
