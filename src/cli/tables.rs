//! Measurements from files: the paper's Table 1 and measured backbones. How CSV
//! is read is not its business.

use std::path::Path;

use super::input::{self, BadInput};
use crate::experiments::measured_csv::{self, LeftOut, records};
use crate::experiments::{ForceRow, ForceTable, Measured, MeasuredPoint};
use crate::mechanics::Problem;
use anyhow::{Context, anyhow, bail};

/// The paper's Table 1, which is part of the program.
const TABLE_1: &str = include_str!("../../assets/measured/table-1.csv");

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
            let measured = (1..=count).map(|k| Ok(record.number(k, "a force")?));
            Ok(ForceRow {
                load_g: record.number(0, "the load")?,
                measured_g: measured.collect::<anyhow::Result<_>>()?,
                theory_g: record.number(count + 1, "the theory")?,
            })
        })
        .collect();
    Ok(ForceTable::new(distances_mm, rows?)?)
}

/// A measured backbone from a file, checked against the robot it belongs to, and
/// the rows that hold nothing.
pub(super) fn measured(path: &Path, problem: &Problem) -> Result<(Measured, LeftOut), BadInput> {
    let bytes = input::bytes(path, "a measured backbone is a CSV text file");
    let parsed = bytes.and_then(|bytes| {
        let (rows, left_out) = measured_csv::backbone(&bytes)?;
        let points = rows.into_iter().map(MeasuredPoint::from);
        Ok((Measured::new(points.collect(), problem)?, left_out))
    });
    Ok(parsed.map_err(|error| error.context(input::origin(path)))?)
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
}
