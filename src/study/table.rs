//! A study's results as a table: its columns, and a sample's cells as text.

use super::design::Study;
use super::output::Output;
use super::row::Row;
use crate::math::shortest;

impl Study {
    /// The names of the columns: the sample's index, the parameters by their keys, how the
    /// sample ended, the outputs, where there are constraints whether it meets them all,
    /// why it has no shape, and [`Study::digest`].
    pub fn columns(&self) -> Vec<&str> {
        let mut columns = vec!["sample"];
        columns.extend(self.parameters().iter().map(|one| one.key.as_str()));
        columns.push(Output::Status.name());
        columns.extend(self.told().map(|(_, output)| output.name()));
        if !self.constraints().is_empty() {
            columns.push("feasible");
        }
        columns.extend(["reason", "study"]);
        columns
    }

    /// A sample's cells, in the order of [`Study::columns`]; numbers with all their digits,
    /// and those that there are not empty.
    ///
    /// # Panics
    /// If there is no such sample.
    pub fn cells(&self, index: u64, row: &Row) -> Vec<String> {
        let mut cells = vec![index.to_string()];
        cells.extend(self.values(index).into_iter().map(shortest));
        cells.push(row.verdict.word().to_owned());
        for (place, _) in self.told() {
            let number = row.numbers.get(place).filter(|number| !number.is_nan());
            cells.push(number.copied().map(shortest).unwrap_or_default());
        }
        if !self.constraints().is_empty() {
            cells.push(u8::from(self.is_feasible(row)).to_string());
        }
        cells.push(row.reason.clone());
        cells.push(format!("{:032x}", self.digest()));
        cells
    }

    /// The outputs with a column of numbers, and their places in a row.
    pub fn told(&self) -> impl Iterator<Item = (usize, Output)> + '_ {
        let outputs = self.outputs().iter().copied().enumerate();
        outputs.filter(|(_, output)| *output != Output::Status)
    }
}
