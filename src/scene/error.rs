//! What can be wrong with a scene, in sentences for whoever wrote it.
//!
//! A path such as `obstacle[1].radius_mm` counts from 0, in file order. Values
//! of out-of-range numbers appear as one would write them in the file.

use super::limits::{Limits, shown};
use super::{MAX_FILE_BYTES, PolygonFault, VERSION};

/// A fault of a scene file or of the scene it holds.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum SceneError {
    /// There is nothing in the file.
    #[error(
        "the scene is empty; it needs at least `version = {VERSION}`, a [robot] table and an [actuation] table"
    )]
    Empty,

    /// The file is not UTF-8 text.
    #[error("the file is not UTF-8 text (first at byte {byte}); a scene is a TOML text file")]
    NotText {
        /// Offset of the first byte that does not belong, from 0.
        byte: usize,
    },

    /// The file is too large to be a scene.
    #[error("the file has {bytes} bytes; a scene has at most {MAX_FILE_BYTES}, so this is not one")]
    TooLarge {
        /// Its size.
        bytes: usize,
    },

    /// The text breaks the rules of TOML.
    #[error("line {line}, column {column} is not valid TOML: {message}")]
    NotToml {
        /// The line, from 1.
        line: usize,
        /// The column in characters, from 1.
        column: usize,
        /// What is wrong there.
        message: String,
    },

    /// Lists or tables inside one another without end.
    #[error("lists or tables are nested too deeply; no part of a scene lies more than four deep")]
    TooDeep,

    /// A version of the format that this program does not know.
    #[error(
        "version is {found}; this program reads versions 1 to {VERSION}: write `version = {VERSION}`, or open the scene with the program that wrote it"
    )]
    Version {
        /// The version in the file.
        found: i64,
    },

    /// A key that means nothing where it stands.
    #[error("{path} is not a key of a scene; {}", suggestion(.nearest, .known))]
    UnknownKey {
        /// The key with the tables it is in.
        path: String,
        /// The known key spelled most like it, when one is near.
        nearest: Option<&'static str>,
        /// The keys that may stand there.
        known: Vec<&'static str>,
    },

    /// A key that came with a later version than the file's.
    #[error(
        "{path} needs version = {since}; write `version = {since}` and, to keep the paper's model, [model] with mechanics = \"equal\""
    )]
    NewerKey {
        /// The key with the tables it is in.
        path: String,
        /// The version it came with.
        since: u32,
    },

    /// A key that means something in scenes, and nothing in this one.
    #[error("{path} is not in the scene; {advice}")]
    NotThere {
        /// The key with the tables it is in.
        path: String,
        /// What is there, and what to do.
        advice: String,
    },

    /// A word outside the choice.
    #[error("{path} is {found}; {}", suggestion(.nearest, .known))]
    UnknownWord {
        /// The field.
        path: String,
        /// The word, quoted.
        found: String,
        /// The word of the choice spelled most like it, when one is near.
        nearest: Option<&'static str>,
        /// The choice.
        known: Vec<&'static str>,
    },

    /// A key that has to be there and is not.
    #[error("{path} is missing; add {what}")]
    MissingKey {
        /// The key with the tables it belongs in.
        path: String,
        /// What it means, and what it has to be.
        what: String,
    },

    /// A value of the wrong kind, such as a string for a number.
    #[error("{path} is {found}; it must be {expected}")]
    WrongType {
        /// The field.
        path: String,
        /// The value and its kind.
        found: String,
        /// What it has to be, with its unit and range.
        expected: String,
    },

    /// A table whose keys and kinds of values were found fine and which is no
    /// scene all the same.
    #[error("the file does not describe a scene: {message}")]
    NotAScene {
        /// What is wrong.
        message: String,
    },

    /// A scene that cannot be written as TOML.
    #[error("the scene cannot be written as TOML: {message}")]
    NotWritable {
        /// What is in the way.
        message: String,
    },

    /// A number that is not one.
    #[error("{field} is nan, not a number; set it to a value {allowed}{}", spaced(.unit))]
    NotANumber {
        /// The field.
        field: String,
        /// The range, such as `from 1 to 10`.
        allowed: String,
        /// The unit's sign; empty for plain counts.
        unit: &'static str,
    },

    /// A number outside its range.
    #[error("{field} is {value}{0}; set it to a value {allowed}{0}", spaced(.unit))]
    OutOfRange {
        /// The field.
        field: String,
        /// The value as one would write it.
        value: String,
        /// The range, such as `from 1 to 10`.
        allowed: String,
        /// The unit's sign; empty for plain counts.
        unit: &'static str,
    },

    /// A list that is too long.
    #[error("{field} has {count} entries; at most {limit} are allowed: remove {}", count - limit)]
    TooMany {
        /// The list.
        field: String,
        /// Its length.
        count: usize,
        /// The most it may have.
        limit: usize,
    },

    /// A list that is too short.
    #[error("{field} has {count} of the at least {least} entries it needs; add some, or remove it")]
    TooFew {
        /// The list.
        field: String,
        /// Its length.
        count: usize,
        /// The least it may have.
        least: usize,
    },

    /// A text with nothing in it where something has to be named.
    #[error("{field} is empty; {advice}")]
    Blank {
        /// The field.
        field: String,
        /// What to do.
        advice: String,
    },

    /// A list of points that bounds no convex polygon.
    #[error("{field} {problem}")]
    Polygon {
        /// The list of points.
        field: String,
        /// What is wrong with them.
        problem: PolygonFault,
    },

    /// Two fields that contradict each other.
    #[error("{field} {problem}; {advice}")]
    Conflict {
        /// The field to change.
        field: String,
        /// What contradicts what: the sentence that starts with the field.
        problem: String,
        /// What to do.
        advice: String,
    },

    /// Fields that are fine each and cannot exist together in the plane, such
    /// as an obstacle over the base or a pull that no linkage can take.
    #[error("{field} {problem}; {advice}")]
    Geometry {
        /// The field to change.
        field: String,
        /// What cannot be: the sentence that starts with the field.
        problem: String,
        /// What to do.
        advice: String,
    },
}

impl SceneError {
    /// The field that is at fault, such as `obstacle[1].radius_mm`; `None`
    /// where it is the file as a whole.
    pub fn field(&self) -> Option<&str> {
        match self {
            SceneError::Empty
            | SceneError::NotText { .. }
            | SceneError::TooLarge { .. }
            | SceneError::NotToml { .. }
            | SceneError::TooDeep
            | SceneError::NotAScene { .. }
            | SceneError::NotWritable { .. } => None,
            SceneError::Version { .. } => Some("version"),
            SceneError::UnknownKey { path: field, .. }
            | SceneError::NewerKey { path: field, .. }
            | SceneError::NotThere { path: field, .. }
            | SceneError::UnknownWord { path: field, .. }
            | SceneError::MissingKey { path: field, .. }
            | SceneError::WrongType { path: field, .. }
            | SceneError::NotANumber { field, .. }
            | SceneError::OutOfRange { field, .. }
            | SceneError::TooMany { field, .. }
            | SceneError::TooFew { field, .. }
            | SceneError::Blank { field, .. }
            | SceneError::Polygon { field, .. }
            | SceneError::Conflict { field, .. }
            | SceneError::Geometry { field, .. } => Some(field),
        }
    }

    /// The fault of `value` being outside `limits`: [`SceneError::NotANumber`]
    /// for NaN, [`SceneError::OutOfRange`] for everything else.
    pub fn outside(field: impl Into<String>, value: f64, limits: &Limits) -> SceneError {
        SceneError::not_within(field, value, limits.to_string(), limits.unit.symbol())
    }

    /// Like [`SceneError::outside`], for a range that depends on other fields
    /// and is given in words, such as `from robot.cable_offset_mm, 8, to 10`.
    pub fn not_within(
        field: impl Into<String>,
        value: f64,
        allowed: impl Into<String>,
        unit: &'static str,
    ) -> SceneError {
        let (field, allowed) = (field.into(), allowed.into());
        if value.is_nan() {
            SceneError::NotANumber {
                field,
                allowed,
                unit,
            }
        } else {
            SceneError::OutOfRange {
                field,
                value: shown(value),
                allowed,
                unit,
            }
        }
    }
}

fn suggestion(nearest: &Option<&str>, known: &[&str]) -> String {
    match nearest {
        Some(name) => format!("did you mean `{name}`?"),
        None => format!("use one of {}", known.join(", ")),
    }
}

fn spaced(unit: &str) -> String {
    if unit.is_empty() {
        String::new()
    } else {
        format!(" {unit}")
    }
}
