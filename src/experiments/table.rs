//! Table 1 as data: measured forces by load and distance, the paper's theory,
//! and how far a theory is from what was measured.

/// Forces against loads at several distances.
#[derive(Clone, Debug, PartialEq)]
pub struct ForceTable {
    distances_mm: Vec<f64>,
    rows: Vec<ForceRow>,
}

/// A load with its forces.
#[derive(Clone, Debug, PartialEq)]
pub struct ForceRow {
    /// P_l, counted from contact, in grams.
    pub load_g: f64,
    /// The measured F_x by distance, in grams.
    pub measured_g: Vec<f64>,
    /// The paper's theoretical F_x, in grams.
    pub theory_g: f64,
}

/// What is wrong with a table.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum TableFault {
    /// Nothing to compare.
    #[error("the table has no rows or no distances")]
    Empty,
    /// A row that does not fit its table.
    #[error("row {0} of the table has another number of forces than there are distances")]
    Ragged(usize),
    /// A number that makes no sense.
    #[error("row {0} of the table has a load or force that is not positive")]
    NotPositive(usize),
}

/// How far a theory is from what was measured, in grams.
#[derive(Clone, Debug, PartialEq)]
pub struct Errors {
    /// The mean |error| by distance.
    pub by_distance_g: Vec<f64>,
    /// The mean |error| over all.
    pub mean_g: f64,
    /// The greatest |error|.
    pub max_g: f64,
}

impl ForceTable {
    /// A table from its distances, in mm, and rows.
    ///
    /// # Errors
    /// If it is empty, ragged, or holds a load or force that is not positive.
    pub fn new(distances_mm: Vec<f64>, rows: Vec<ForceRow>) -> Result<Self, TableFault> {
        if rows.is_empty() || distances_mm.is_empty() {
            return Err(TableFault::Empty);
        }
        for (index, row) in rows.iter().enumerate() {
            if row.measured_g.len() != distances_mm.len() {
                return Err(TableFault::Ragged(index + 1));
            }
            let mut numbers = row.measured_g.iter().chain([&row.load_g, &row.theory_g]);
            if !numbers.all(|value| *value > 0.0 && value.is_finite()) {
                return Err(TableFault::NotPositive(index + 1));
            }
        }
        Ok(Self { distances_mm, rows })
    }

    /// The distances of the load cell from the backbone, in mm.
    pub fn distances_mm(&self) -> &[f64] {
        &self.distances_mm
    }

    /// The rows, by load.
    pub fn rows(&self) -> &[ForceRow] {
        &self.rows
    }

    /// The force measured at a load and a distance, in grams.
    pub fn measured_g(&self, load_g: f64, distance_mm: f64) -> Option<f64> {
        let column = self.distances_mm.iter().position(|d| *d == distance_mm)?;
        let row = self.rows.iter().find(|row| row.load_g == load_g)?;
        row.measured_g.get(column).copied()
    }

    /// The errors of a theory that gives a force, in grams, for each row.
    pub fn errors(&self, theory_g: impl Fn(&ForceRow) -> f64) -> Errors {
        let error = |row: &ForceRow, k: usize| (theory_g(row) - row.measured_g[k]).abs();
        let count = self.rows.len() as f64;
        let by_distance_g: Vec<f64> = (0..self.distances_mm.len())
            .map(|k| self.rows.iter().map(|row| error(row, k)).sum::<f64>() / count)
            .collect();
        let mean_g = by_distance_g.iter().sum::<f64>() / by_distance_g.len() as f64;
        let all = (0..self.distances_mm.len()).flat_map(|k| self.rows.iter().map(move |r| (r, k)));
        Errors {
            by_distance_g,
            mean_g,
            max_g: all.map(|(row, k)| error(row, k)).fold(0.0, f64::max),
        }
    }
}
