//! Measurements from the bytes of CSV files: backbones and force readings. Opens
//! no files, and knows no robot that they could be of.
//!
//! A file has a head that names its columns, in any order: `x_mm`, `y_mm` and
//! perhaps `node` for a backbone, `load_g` and `force_g` for readings. `#` starts
//! a comment. Columns may be separated by commas, semicolons or tabs. Every
//! fault names its row, as an editor counts lines, and its column.

mod fault;
mod record;

use super::MeasuredPoint;
use crate::geometry::Vector;
use crate::scene::{ForceReading, Measurements, limits, quoted};
use crate::units::metres;
use record::{Record, text};

pub use fault::SheetFault;
pub(crate) use record::records;

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
    /// What the bytes of a file hold, by the columns that its head names.
    ///
    /// # Errors
    /// The first fault, from the top.
    pub fn read(bytes: &[u8]) -> Result<Sheet, SheetFault> {
        let records = records(text(bytes)?)?;
        let [head, rows @ ..] = &records[..] else {
            return Err(SheetFault::Empty);
        };
        let row = head.row;
        if !head.is_head() {
            return Err(SheetFault::NoHead { row });
        }
        let sheet = match (Columns::of_backbone(head), Columns::of_forces(head)) {
            (Some(columns), None) => Sheet::Backbone(points(below(head, rows)?, columns)?),
            (None, Some((load, force))) => {
                Sheet::Forces(readings(below(head, rows)?, load, force)?)
            }
            _ => {
                let found = quoted(&head.fields.join(","));
                return Err(SheetFault::UnknownHead { row, found });
            }
        };
        match rows {
            [] => Err(SheetFault::Empty),
            _ => Ok(sheet),
        }
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

/// The points of a measured backbone; without a head, the columns are x and y.
/// There may be none.
///
/// # Errors
/// The first fault, from the top.
pub fn backbone(bytes: &[u8]) -> Result<Vec<BackboneRow>, SheetFault> {
    let records = records(text(bytes)?)?;
    match &records[..] {
        [head, rows @ ..] if head.is_head() => {
            let row = head.row;
            let columns = Columns::of_backbone(head).ok_or(SheetFault::NoBackbone { row })?;
            points(below(head, rows)?, columns)
        }
        rows => points(rows, Columns::WITHOUT_HEAD),
    }
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

/// The columns of a measured backbone, from 0.
#[derive(Clone, Copy)]
struct Columns {
    x: usize,
    y: usize,
    node: Option<usize>,
}

impl Columns {
    const WITHOUT_HEAD: Columns = Columns {
        x: 0,
        y: 1,
        node: None,
    };

    fn of_backbone(head: &Record) -> Option<Columns> {
        Some(Columns {
            x: head.column(&["x_mm", "x"])?,
            y: head.column(&["y_mm", "y"])?,
            node: head.column(&["node"]),
        })
    }

    /// Those of load and force.
    fn of_forces(head: &Record) -> Option<(usize, usize)> {
        let load = head.column(&["load_g", "load"])?;
        Some((load, head.column(&["force_g", "force"])?))
    }
}

fn points(rows: &[Record], columns: Columns) -> Result<Vec<BackboneRow>, SheetFault> {
    at_most(rows, limits::MEASURED_POINTS)?;
    let point = |record: &Record| {
        let node = columns.node.map(|column| record.node(column));
        let coordinate = |column, name| record.within(column, name, &limits::COORDINATE);
        Ok(BackboneRow {
            row: record.row,
            node: node.transpose()?,
            point_mm: [
                coordinate(columns.x, "x_mm")?,
                coordinate(columns.y, "y_mm")?,
            ],
        })
    };
    rows.iter().map(point).collect()
}

fn readings(rows: &[Record], load: usize, force: usize) -> Result<Vec<ForceReading>, SheetFault> {
    at_most(rows, limits::READINGS)?;
    let reading = |record: &Record| {
        Ok(ForceReading {
            load_g: record.within(load, "load_g", &limits::LOAD)?,
            force_g: record.within(force, "force_g", &limits::FORCE)?,
        })
    };
    rows.iter().map(reading).collect()
}

/// The rows below a head, if none has more fields than it names.
fn below<'a>(head: &Record, rows: &'a [Record]) -> Result<&'a [Record], SheetFault> {
    let columns = head.fields.len();
    let filled = |record: &Record| {
        let last = record.fields.iter().rposition(|field| !field.is_empty());
        last.map_or(0, |last| last + 1)
    };
    match rows.iter().find(|record| filled(record) > columns) {
        Some(record) => Err(SheetFault::Extra {
            row: record.row,
            fields: filled(record),
            columns,
        }),
        None => Ok(rows),
    }
}

fn at_most(rows: &[Record], limit: usize) -> Result<(), SheetFault> {
    match rows.len() {
        count if count > limit => Err(SheetFault::TooMany { count, limit }),
        _ => Ok(()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::MAX_FILE_BYTES;

    #[track_caller]
    fn check_refused(text: &str, expected: &str) {
        assert_eq!(
            Sheet::read(text.as_bytes()).unwrap_err().to_string(),
            expected
        );
    }

    fn rows(text: &str) -> Vec<usize> {
        let all = backbone(text.as_bytes()).unwrap();
        all.iter().map(|point| point.row).collect()
    }

    #[test]
    fn heads_name_columns_in_any_order() {
        let all = backbone(b"node, y, x\n0, 0, 0\n1, 10, 0.5\n").unwrap();
        let expected = BackboneRow {
            row: 3,
            node: Some(1),
            point_mm: [0.5, 10.0],
        };
        assert_eq!(all[1], expected);
        let point = MeasuredPoint::from(all[1]);
        assert_eq!((point.row, point.node), (3, Some(1)));
        assert_eq!(point.position, Vector::new(metres(0.5), metres(10.0)));
        let sheet = Sheet::read(b"force_g,remark,LOAD_G\n3.5,ok,50\n").unwrap();
        let reading = ForceReading {
            load_g: 50.0,
            force_g: 3.5,
        };
        assert_eq!(sheet, Sheet::Forces(vec![reading]));
    }

    #[test]
    fn rows_count_as_an_editor_counts_lines() {
        assert_eq!(rows("# none\n1,2\n"), [2]);
        assert_eq!(rows("\n1,2\r\n\r\n# a\n# b\n3,4\n5,6"), [2, 6, 7]);
        assert_eq!(rows("\u{feff}x,y\n1,2"), [2]);
        assert!(rows("").is_empty());
    }

    #[test]
    fn spreadsheets_of_every_country_are_read() {
        for text in [
            "x_mm,y_mm\n1,2.5\n",
            "x_mm;y_mm\r\n1;2.5\r\n",
            "# tabs\nx_mm\ty_mm\n1\t2.5\n",
        ] {
            let sheet = Sheet::read(text.as_bytes()).unwrap();
            let Sheet::Backbone(rows) = sheet else {
                panic!("{sheet:?}");
            };
            assert_eq!((rows.len(), rows[0].point_mm), (1, [1.0, 2.5]), "{text:?}");
        }
    }

    #[test]
    fn a_sheet_takes_the_place_of_its_kind_only() {
        let mut held = Measurements {
            points_mm: vec![[1.0, 1.0], [2.0, 2.0]],
            nodes: vec![],
            calibration: Some(0),
            forces: vec![ForceReading {
                load_g: 1.0,
                force_g: 1.0,
            }],
        };
        let before = held.clone();
        let read = |text: &str| Sheet::read(text.as_bytes()).unwrap();
        read("node,x_mm,y_mm\n0,0,0\n9,0,90\n").put_into(&mut held);
        assert_eq!(held.points_mm, [[0.0, 0.0], [0.0, 90.0]]);
        assert_eq!(held.nodes, [0, 9]);
        assert_eq!((held.calibration, &held.forces), (Some(0), &before.forces));
        read("x_mm,y_mm\n0,0\n0,90\n0,95\n").put_into(&mut held);
        assert_eq!((held.points_mm.len(), held.nodes.len()), (3, 0));
        read("load_g,force_g\n50,4\n100,7\n").put_into(&mut held);
        assert_eq!((held.forces.len(), held.calibration), (2, None));
        assert_eq!(held.points_mm.len(), 3);
    }

    #[test]
    fn faults_name_row_and_column() {
        let empty = "there are no rows of numbers; write them below a head such as x_mm,y_mm or load_g,force_g";
        check_refused("", empty);
        check_refused("# only this\n\n", empty);
        check_refused("load_g,force_g\n", empty);
        check_refused(
            "\n0,0\n1,2\n",
            "row 2: there is no head; write x_mm,y_mm or load_g,force_g above the numbers",
        );
        for head in ["left,right", "x_mm,force_g", "x_mm,y_mm,load_g,force_g"] {
            check_refused(
                &format!("{head}\n1,2,3,4\n"),
                &format!(
                    "row 1: the head is \"{head}\"; it has to name either x_mm and y_mm, for a backbone, or load_g and force_g, for readings of forces"
                ),
            );
        }
        check_refused(
            "load_g,force_g\n50,4\n\n100,\n",
            "row 4: force_g is missing",
        );
        check_refused("load_g,force_g\n50\n", "row 2: force_g is missing");
        check_refused(
            "load_g,force_g\n50,3,5\n",
            "row 2: there are 3 fields below a head of 2; write numbers as 12.5, with a point",
        );
        for field in ["4 g", "nan", "inf", "4;5"] {
            check_refused(
                &format!("load_g,force_g\n50,{field}\n"),
                &format!(
                    "row 2: force_g is \"{field}\", which is not a number; write numbers as 12.5"
                ),
            );
        }
        check_refused(
            "load_g,force_g\n-50,4\n",
            "row 2: load_g is -50 g; it has to be from 0 to 1000000 g",
        );
        check_refused(
            "x_mm,y_mm\n0,0\n1e7,0\n",
            "row 3: x_mm is 10000000 mm; it has to be from -1000000 to 1000000 mm",
        );
        check_refused(
            "node,x_mm,y_mm\n1.5,0,0\n",
            "row 2: node is 1.5; nodes count 0, 1, 2 and so on from the base",
        );
        let long = format!("load_g,force_g\n50,{}\n", "x".repeat(100_000));
        let told = Sheet::read(long.as_bytes()).unwrap_err().to_string();
        assert!(told.len() < 200 && told.contains('…'), "{told}");
    }

    #[test]
    fn what_is_no_table_is_refused() {
        let of = |bytes: &[u8]| Sheet::read(bytes).unwrap_err().to_string();
        assert_eq!(
            of(b"x_mm,y_mm\n1,\xff\n"),
            "row 2: this is not UTF-8 text; measurements are a CSV text file"
        );
        assert_eq!(
            of(&vec![b'1'; MAX_FILE_BYTES + 1]),
            "the file has 4194305 bytes; measurements have at most 4194304"
        );
        let many = format!("load_g,force_g\n{}", "1,1\n".repeat(1001));
        assert_eq!(
            of(many.as_bytes()),
            "there are 1001 rows; at most 1000 are allowed: leave out every other one"
        );
    }
}
