//! Measurements from the bytes of CSV files: backbones and force readings. Opens
//! no files, and knows no robot that they could be of.
//!
//! A file has a head that names its columns, in any order: `x_mm`, `y_mm` and
//! perhaps `node` for a backbone, `load_g` and `force_g` for readings, or the
//! same in other units, as `x (m)` or `force [N]`. `#` starts a comment; the one
//! above the first row may be the head. Columns may be separated by commas,
//! semicolons, tabs or spaces. Rows that hold nothing, or NaN, are left out.
//! Every fault names its row, as an editor counts lines, and its column.

mod columns;
mod fault;
mod left_out;
mod record;
mod table;
#[cfg(test)]
mod tests;
#[cfg(feature = "cli")]
mod trials;

use super::MeasuredPoint;
use crate::geometry::Vector;
use crate::scene::{ForceReading, Measurements, limits, quoted};
use crate::units::metres;
use columns::{Backbone, Forces};
use record::Record;
use table::{Table, text};

pub use fault::SheetFault;
pub use left_out::LeftOut;
#[cfg(feature = "cli")]
pub(crate) use table::records;
#[cfg(feature = "cli")]
pub use trials::{Trial, Trials, Weight};

/// What a file of measurements holds.
#[derive(Clone, Debug, PartialEq)]
pub enum Sheet {
    /// A measured backbone, base to tip.
    Backbone(Vec<BackboneRow>),
    /// Readings of the contact force.
    Forces(Vec<ForceReading>),
}

/// A point of a measured backbone.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BackboneRow {
    /// Its line in the file, from 1.
    pub row: usize,
    /// Its node, from 0 at the base, where the file names nodes.
    pub node: Option<u32>,
    /// Its place in the scene's frame, [x, y], mm.
    pub point_mm: [f64; 2],
}

impl Sheet {
    /// What the bytes of a file hold, by the columns that its head names, and
    /// the rows that hold nothing.
    ///
    /// # Errors
    /// The first fault, from the top.
    pub fn read(bytes: &[u8]) -> Result<(Sheet, LeftOut), SheetFault> {
        let table = Table::read(text(bytes)?)?;
        let mut left_out = LeftOut::new(table.blank);
        let [first, rows @ ..] = &table.records[..] else {
            return Err(SheetFault::Empty);
        };
        let (head, rows) = match &table.comment {
            _ if first.is_head() => (first, rows),
            Some(comment) => (comment, &table.records[..]),
            None => return Err(SheetFault::NoHead { row: first.row }),
        };
        let row = head.row;
        let sheet = match (Backbone::named(head)?, Forces::named(head)?) {
            (Some(columns), None) => {
                Sheet::Backbone(points(below(head, rows)?, &columns, &mut left_out)?)
            }
            (None, Some(columns)) => {
                Sheet::Forces(readings(below(head, rows)?, &columns, &mut left_out)?)
            }
            _ if !first.is_head() => return Err(SheetFault::NoHead { row: first.row }),
            _ => {
                let found = quoted(&head.fields.join(","));
                return Err(SheetFault::UnknownHead { row, found });
            }
        };
        let empty = match &sheet {
            Sheet::Backbone(rows) => rows.is_empty(),
            Sheet::Forces(readings) => readings.is_empty(),
        };
        if empty {
            return Err(SheetFault::Empty);
        }
        Ok((sheet, left_out))
    }

    /// Puts the sheet into a scene's measurements, in the place of what is there
    /// of its kind. With other readings none is chosen to calibrate.
    pub fn put_into(self, held: &mut Measurements) {
        match self {
            Sheet::Backbone(rows) => {
                held.points_mm = rows.iter().map(|row| row.point_mm).collect();
                held.nodes = rows.iter().filter_map(|row| row.node).collect();
            }
            Sheet::Forces(readings) => {
                held.forces = readings;
                held.calibration = None;
            }
        }
    }
}

/// The points of a measured backbone, and the rows that hold nothing. Without a
/// head there are two columns, x and y in mm. There may be no points.
///
/// # Errors
/// The first fault, from the top.
pub fn backbone(bytes: &[u8]) -> Result<(Vec<BackboneRow>, LeftOut), SheetFault> {
    let table = Table::read(text(bytes)?)?;
    let mut left_out = LeftOut::new(table.blank);
    let commented = table.comment.as_ref().map(Backbone::named).transpose()?;
    let points = match (&table.records[..], commented.flatten()) {
        ([head, rows @ ..], _) if head.is_head() => {
            let row = head.row;
            let columns = Backbone::named(head)?.ok_or(SheetFault::NoBackbone { row })?;
            points(below(head, rows)?, &columns, &mut left_out)
        }
        (rows, Some(columns)) => points(rows, &columns, &mut left_out),
        (rows, None) => {
            let columns = Backbone::without_head();
            points(two_columns(rows)?, &columns, &mut left_out)
        }
    };
    Ok((points?, left_out))
}

impl From<BackboneRow> for MeasuredPoint {
    fn from(read: BackboneRow) -> Self {
        let [x, y] = read.point_mm;
        MeasuredPoint {
            row: read.row,
            node: read.node.map(|node| node as usize),
            position: Vector::new(metres(x), metres(y)),
        }
    }
}

/// The points in rows, base to tip: where nodes are named, these order them.
fn points(
    rows: &[Record],
    columns: &Backbone,
    left_out: &mut LeftOut,
) -> Result<Vec<BackboneRow>, SheetFault> {
    let Backbone { x, y, node } = columns;
    let rows = left_out.rest_of(rows, [x.index, y.index]);
    at_most(rows.len(), limits::MEASURED_POINTS)?;
    let point = |record: &&Record| {
        let node = node.map(|column| record.node(column));
        let [x, y] = [x, y].map(|column| {
            record.within(column.index, &column.name, column.unit, &limits::COORDINATE)
        });
        Ok(BackboneRow {
            row: record.row,
            node: node.transpose()?,
            point_mm: [x?, y?],
        })
    };
    let mut points = rows.iter().map(point).collect::<Result<Vec<_>, _>>()?;
    points.sort_by_key(|point| point.node);
    Ok(points)
}

fn readings(
    rows: &[Record],
    columns: &Forces,
    left_out: &mut LeftOut,
) -> Result<Vec<ForceReading>, SheetFault> {
    let Forces { load, force } = columns;
    let rows = left_out.rest_of(rows, [load.index, force.index]);
    at_most(rows.len(), limits::READINGS)?;
    let reading = |record: &&Record| {
        Ok(ForceReading {
            load_g: record.within(load.index, &load.name, load.unit, &limits::LOAD)?,
            force_g: record.within(force.index, &force.name, force.unit, &limits::FORCE)?,
        })
    };
    rows.iter().map(reading).collect()
}

/// The rows below a head, if none has more fields than it names.
fn below<'a>(head: &Record, rows: &'a [Record]) -> Result<&'a [Record], SheetFault> {
    let columns = head.fields.len();
    match rows.iter().find(|record| record.filled() > columns) {
        Some(record) => Err(SheetFault::Extra {
            row: record.row,
            fields: record.filled(),
            columns,
        }),
        None => Ok(rows),
    }
}

/// Rows without a head, if none has more fields than x and y.
fn two_columns(rows: &[Record]) -> Result<&[Record], SheetFault> {
    match rows.iter().find(|record| record.filled() > 2) {
        Some(record) => Err(SheetFault::Nameless {
            row: record.row,
            fields: record.filled(),
        }),
        None => Ok(rows),
    }
}

fn at_most(count: usize, limit: usize) -> Result<(), SheetFault> {
    if count > limit {
        return Err(SheetFault::TooMany { count, limit });
    }
    Ok(())
}
