//! Scenes of earlier versions of the file format, as the present one has them.

use super::{Mechanics, VERSION};
use toml::{Table, Value};

/// Turns a table that the walk has passed into one of the present version that
/// means the same.
pub(super) fn to_present(table: &mut Table) {
    // Version 1 had the paper's model only, and had no word for it.
    if table.get("version") == Some(&Value::Integer(1)) {
        let word = Mechanics::Equal.word().to_owned();
        let model = Table::from_iter([("mechanics".to_owned(), Value::String(word))]);
        table.insert("model".to_owned(), Value::Table(model));
        table.insert("version".to_owned(), Value::Integer(VERSION.into()));
    }
}
