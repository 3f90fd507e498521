//! Measurements from CSV: the paper's Table 1 and measured backbones. Every
//! complaint names its row, as an editor counts lines.

use std::path::Path;

use super::input::{self, BadInput};
use crate::experiments::{ForceRow, ForceTable, Measured, MeasuredPoint};
use crate::geometry::Vector;
use crate::model::Problem;
use crate::units::metres;
use anyhow::{Context, anyhow, bail};

/// The paper's Table 1, which is part of the program.
const TABLE_1: &str = include_str!("../../assets/measured/table-1.csv");

/// A record with its line in the file.
struct Record {
    row: usize,
    fields: Vec<String>,
}

/// All records of a CSV text; `#` starts a comment.
fn records(text: &str) -> anyhow::Result<Vec<Record>> {
    let mut reader = ::csv::ReaderBuilder::new()
        .has_headers(false)
        .flexible(true)
        .comment(Some(b'#'))
        .trim(::csv::Trim::All)
        .from_reader(text.as_bytes());
    let mut found = Vec::new();
    let (mut row, mut counted) = (1, 0);
    for record in reader.records() {
        let record = record.context("this is not CSV")?;
        let from = record.position().map_or(0, ::csv::Position::byte) as usize;
        let at = from + skipped(text.get(from..).unwrap_or_default());
        let newlines = text.as_bytes().get(counted..at).unwrap_or_default();
        row += newlines.iter().filter(|byte| **byte == b'\n').count();
        counted = at;
        let fields = record.iter().map(str::to_owned).collect();
        found.push(Record { row, fields });
    }
    Ok(found)
}

/// The bytes of blank lines and comments at a text's start, which the reader
/// counts as part of the record after them.
fn skipped(text: &str) -> usize {
    let lines = text.split_inclusive('\n');
    let empty = |line: &&str| line.trim().is_empty() || line.starts_with('#');
    lines.take_while(empty).map(str::len).sum()
}

/// The number in a field.
fn number(record: &Record, column: usize, name: &str) -> anyhow::Result<f64> {
    let row = record.row;
    let Some(field) = record.fields.get(column).filter(|f| !f.is_empty()) else {
        bail!("row {row}: {name} is missing");
    };
    match field.parse::<f64>() {
        Ok(value) if value.is_finite() => Ok(value),
        _ => bail!(
            "row {row}: {name} is \"{}\", which is not a number; write numbers as 12.5",
            super::output::printable(field)
        ),
    }
}

/// The paper's Table 1.
pub(super) fn table_1() -> Result<ForceTable, BadInput> {
    Ok(force_table(TABLE_1).context("assets/measured/table-1.csv")?)
}

fn force_table(text: &str) -> anyhow::Result<ForceTable> {
    let records = records(text)?;
    let [head, rows @ ..] = &records[..] else {
        bail!("the table is empty");
    };
    let distance = |name: &String| {
        let inside = name.strip_prefix("force_")?.strip_suffix("_mm_g")?;
        inside.parse::<f64>().ok()
    };
    let [load, forces @ .., theory] = &head.fields[..] else {
        bail!("row {}: the table has fewer than two columns", head.row);
    };
    if load != "load_g" || theory != "theory_g" {
        bail!(
            "row {}: the table is not load_g, forces, theory_g",
            head.row
        );
    }
    let distances_mm: Option<Vec<f64>> = forces.iter().map(distance).collect();
    let distances_mm =
        distances_mm.ok_or_else(|| anyhow!("row {}: a force has no distance", head.row))?;
    let count = distances_mm.len();
    let rows: anyhow::Result<Vec<ForceRow>> = rows
        .iter()
        .map(|record| {
            let measured = (1..=count).map(|k| number(record, k, "a force"));
            Ok(ForceRow {
                load_g: number(record, 0, "the load")?,
                measured_g: measured.collect::<anyhow::Result<_>>()?,
                theory_g: number(record, count + 1, "the theory")?,
            })
        })
        .collect();
    Ok(ForceTable::new(distances_mm, rows?)?)
}

/// A measured backbone from a file, checked against the robot it belongs to.
pub(super) fn measured(path: &Path, problem: &Problem) -> Result<Measured, BadInput> {
    let bytes = input::bytes(path, "a measured backbone is a CSV text file");
    let parsed = bytes.and_then(|bytes| {
        let text = String::from_utf8(bytes).map_err(|_| anyhow!("this is not UTF-8 text"))?;
        Ok(Measured::new(points(&text)?, problem)?)
    });
    Ok(parsed.map_err(|error| error.context(input::origin(path)))?)
}

/// The columns of a measured backbone.
struct Columns {
    x: usize,
    y: usize,
    node: Option<usize>,
}

fn points(text: &str) -> anyhow::Result<Vec<MeasuredPoint>> {
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    let records = records(text)?;
    let mut rows = &records[..];
    let mut columns = Columns {
        x: 0,
        y: 1,
        node: None,
    };
    // A first row without any number is a head; without a head it is x, y.
    if let [head, rest @ ..] = rows
        && head
            .fields
            .iter()
            .all(|field| field.parse::<f64>().is_err())
    {
        columns = named(head)?;
        rows = rest;
    }
    rows.iter()
        .map(|record| {
            let node = columns.node.map(|column| node(record, column));
            Ok(MeasuredPoint {
                row: record.row,
                node: node.transpose()?,
                position: Vector::new(
                    metres(number(record, columns.x, "x_mm")?),
                    metres(number(record, columns.y, "y_mm")?),
                ),
            })
        })
        .collect()
}

fn named(head: &Record) -> anyhow::Result<Columns> {
    let find = |names: &[&str]| {
        head.fields
            .iter()
            .position(|field| names.contains(&field.to_lowercase().as_str()))
    };
    match (find(&["x_mm", "x"]), find(&["y_mm", "y"])) {
        (Some(x), Some(y)) => Ok(Columns {
            x,
            y,
            node: find(&["node"]),
        }),
        _ => bail!(
            "row {}: the head names no columns x_mm and y_mm (a column node may be there too)",
            head.row
        ),
    }
}

fn node(record: &Record, column: usize) -> anyhow::Result<usize> {
    let value = number(record, column, "node")?;
    if value.fract() == 0.0 && (0.0..=1e9).contains(&value) {
        Ok(value as usize)
    } else {
        bail!(
            "row {}: node is {value}; nodes count 0, 1, 2 and so on from the base",
            record.row
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_papers_table_is_the_one_in_its_text() {
        let table = table_1().unwrap();
        assert_eq!(table.distances_mm(), [24.0, 31.0, 36.0, 51.0]);
        assert_eq!(table.rows().len(), 7);
        assert_eq!(table.measured_g(350.0, 24.0), Some(23.0));
        assert_eq!(table.rows()[6].theory_g, 24.9);
    }

    #[test]
    fn heads_name_columns_in_any_order() {
        let all = points("node, y, x\n0, 0, 0\n1, 10, 0.5\n").unwrap();
        assert_eq!(all[1].node, Some(1));
        assert_eq!(all[1].position, Vector::new(metres(0.5), metres(10.0)));
        let rows = |text| -> Vec<usize> {
            let all = points(text).unwrap();
            all.iter().map(|point| point.row).collect()
        };
        assert_eq!(rows("# none\n1,2\n"), [2]);
        assert_eq!(rows("\n1,2\r\n\r\n# a\n# b\n3,4\n5,6"), [2, 6, 7]);
    }
}
