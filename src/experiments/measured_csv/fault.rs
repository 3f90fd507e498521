//! What can be wrong with a file of measurements.

use crate::scene::MAX_FILE_BYTES;

/// What is wrong with a file of measurements.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum SheetFault {
    /// Too large to be one.
    #[error("the file has {bytes} bytes; measurements have at most {MAX_FILE_BYTES}")]
    TooLarge {
        /// Its size.
        bytes: usize,
    },
    /// Not text.
    #[error("row {row}: this is not UTF-8 text; measurements are a CSV text file")]
    NotText {
        /// The row of the first byte that does not belong.
        row: usize,
    },
    /// Not CSV.
    #[error("this is not CSV: {0}")]
    NotCsv(String),
    /// No numbers.
    #[error(
        "there are no rows of numbers; write them below a head such as x_mm,y_mm or load_g,force_g"
    )]
    Empty,
    /// No head, where one has to tell what the numbers are.
    #[error("row {row}: there is no head; write x_mm,y_mm or load_g,force_g above the numbers")]
    NoHead {
        /// The first row.
        row: usize,
    },
    /// No head, and more columns than x and y.
    #[error(
        "row {row}: there are {fields} columns and no head that tells which are x and y; write one such as node,x_mm,y_mm above the numbers, and numbers as 12.5, with a point"
    )]
    Nameless {
        /// The row.
        row: usize,
        /// How many columns it has.
        fields: usize,
    },
    /// A unit that is none, or not of that kind.
    #[error("row {row}: the unit of {found} is not known; write one of {known}")]
    Unit {
        /// The head's row.
        row: usize,
        /// The head's field, quoted.
        found: String,
        /// The signs of those that are.
        known: String,
    },
    /// One of two columns has a unit.
    #[error("row {row}: {with} names a unit and {without} does not; name that of both")]
    HalfUnit {
        /// The head's row.
        row: usize,
        /// The field with a unit, quoted.
        with: String,
        /// The one without, quoted.
        without: String,
    },
    /// A head without the columns of a backbone.
    #[error("row {row}: the head names no columns x_mm and y_mm (a column node may be there too)")]
    NoBackbone {
        /// The head's row.
        row: usize,
    },
    /// A head of neither kind, or of both.
    #[error(
        "row {row}: the head is {found}; it has to name either x_mm and y_mm, for a backbone, or load_g and force_g, for readings of forces"
    )]
    UnknownHead {
        /// The head's row.
        row: usize,
        /// The head, quoted.
        found: String,
    },
    /// A field that is not there or empty.
    #[error("row {row}: {column} is missing")]
    Missing {
        /// The row.
        row: usize,
        /// The column.
        column: String,
    },
    /// More fields than the head has columns, as decimal commas make them.
    #[error(
        "row {row}: there are {fields} fields below a head of {columns}; write numbers as 12.5, with a point"
    )]
    Extra {
        /// The row.
        row: usize,
        /// How many fields it has.
        fields: usize,
        /// How many columns the head has.
        columns: usize,
    },
    /// A field that is no finite number.
    #[error("row {row}: {column} is {found}, which is not a number; write numbers as 12.5")]
    NotANumber {
        /// The row.
        row: usize,
        /// The column.
        column: String,
        /// The field, quoted.
        found: String,
    },
    /// A number that no scene can hold.
    #[error("row {row}: {column} is {value} {unit}; it has to be {allowed} {unit}")]
    OutOfRange {
        /// The row.
        row: usize,
        /// The column.
        column: String,
        /// The number as one would write it.
        value: String,
        /// The range, such as `from 0 to 10`.
        allowed: String,
        /// The unit's sign.
        unit: &'static str,
    },
    /// A node that is none.
    #[error("row {row}: node is {value}; nodes count 0, 1, 2 and so on from the base")]
    Node {
        /// The row.
        row: usize,
        /// The number.
        value: f64,
    },
    /// No trials.
    #[error(
        "there are no rows of numbers; write them below a head such as load_g,force_g or pull_mm,force_g"
    )]
    NoTrials,
    /// No head, where one has to tell what the numbers of trials are.
    #[error("row {row}: there is no head; write one such as load_g,force_g above the numbers")]
    NoTrialHead {
        /// The first row.
        row: usize,
    },
    /// A column that is neither measured nor a key of a scene.
    #[error(
        "row {row}: {found} is neither load_g, load_from_contact_g, pull_mm or force_g nor a key of the scene such as obstacle[0].point_mm[0]{}",
        .nearest.map(|name| format!("; did you mean `{name}`?")).unwrap_or_default()
    )]
    UnknownColumn {
        /// The head's row.
        row: usize,
        /// The column, quoted.
        found: String,
        /// The known one spelled most like it, when one is near.
        nearest: Option<&'static str>,
    },
    /// Two loads at once.
    #[error("row {row}: both load_g and load_from_contact_g are given; leave one empty")]
    TwoLoads {
        /// The row.
        row: usize,
    },
    /// Neither a load nor a pull.
    #[error(
        "row {row}: nothing tells what was done to the robot; give load_g, load_from_contact_g or pull_mm"
    )]
    NothingGiven {
        /// The row, perhaps the head's.
        row: usize,
    },
    /// Nothing that was measured.
    #[error("row {row}: nothing was measured; give force_g, or pull_mm under a load")]
    NothingRead {
        /// The row, perhaps the head's.
        row: usize,
    },
    /// More rows than a scene can hold.
    #[error("there are {count} rows; at most {limit} are allowed: leave out every other one")]
    TooMany {
        /// How many there are.
        count: usize,
        /// How many there may be.
        limit: usize,
    },
}
