//! Every key a scene file may have, with what it means and may hold.
//!
//! The one table behind the messages about unknown, missing and mistyped keys
//! and behind the JSON Schema. The values themselves are read by serde into
//! the types of this layer; a test holds the two together.

mod table;

use super::limits::{Limits, Unit};
use super::{SceneError, VERSION};
pub(super) use table::{SCENE, SHAPE, SHAPES, SPACING};

/// A key of a table.
pub(super) struct Key {
    /// The key as written.
    pub name: &'static str,
    /// What it means: a phrase without a full stop.
    pub about: &'static str,
    /// What it may hold.
    pub kind: Kind,
    /// Whether it may be left out.
    pub presence: Presence,
    /// The version of the file format that it came with.
    pub since: u32,
}

/// Whether a key may be left out.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Presence {
    Required,
    Optional,
    /// Exactly one of the table's keys of this kind is there.
    OneOf,
}

/// What a key may hold.
pub(super) enum Kind {
    Version,
    Number(Limits),
    Whole(Limits),
    Text,
    Word(&'static [&'static str]),
    /// Two numbers, x and y, or width and height.
    Pair(Limits),
    /// Pairs, so many at least and at most.
    #[cfg_attr(
        not(feature = "cli"),
        expect(dead_code, reason = "only the JSON Schema tells how many")
    )]
    Points(Limits, usize, usize),
    /// Whole numbers, so many at most.
    #[cfg_attr(
        not(feature = "cli"),
        expect(dead_code, reason = "only the JSON Schema tells how many")
    )]
    Wholes(Limits, usize),
    Table(&'static [Key]),
    /// Tables, so many at most, with the end of the sentence on how to write
    /// them.
    #[cfg_attr(
        not(feature = "cli"),
        expect(dead_code, reason = "only the JSON Schema tells how many")
    )]
    Tables(&'static [Key], usize, &'static str),
    /// Tables whose keys depend on their `shape`.
    Obstacles,
}

/// The keys of one shape of obstacle.
pub(super) struct ShapeKeys {
    pub word: &'static str,
    #[cfg_attr(
        not(feature = "cli"),
        expect(dead_code, reason = "only the JSON Schema tells it")
    )]
    pub about: &'static str,
    pub keys: &'static [Key],
}

/// An optional key that files of version 1 do not have.
const fn newer(name: &'static str, about: &'static str, kind: Kind) -> Key {
    Key {
        name,
        about,
        kind,
        presence: Presence::Optional,
        since: 2,
    }
}

const fn required(name: &'static str, about: &'static str, kind: Kind) -> Key {
    Key {
        name,
        about,
        kind,
        presence: Presence::Required,
        since: 1,
    }
}

const fn optional(name: &'static str, about: &'static str, kind: Kind) -> Key {
    Key {
        name,
        about,
        kind,
        presence: Presence::Optional,
        since: 1,
    }
}

/// The fault of a key that has to be there and is not.
pub(super) fn missing(key: &Key, path: String) -> SceneError {
    let what = match &key.kind {
        Kind::Table(_) => format!("a table headed [{path}] for {}", key.about),
        kind => format!("{}, {}", key.about, expected(kind)),
    };
    SceneError::MissingKey { path, what }
}

/// Like [`missing`], for a key of the top or one of its tables, named from
/// there: `actuation` or `robot.cable_offset_mm`.
pub(super) fn missing_at(path: &str) -> SceneError {
    let named = |keys: &'static [Key], name| keys.iter().find(|key| key.name == name);
    let key = match path.split_once('.') {
        None => named(SCENE, path),
        Some((table, name)) => match named(SCENE, table).map(|key| &key.kind) {
            Some(Kind::Table(keys)) => named(keys, name),
            _ => None,
        },
    };
    match key {
        Some(key) => missing(key, path.to_owned()),
        None => unreachable!("{path} is no key of the table above"),
    }
}

/// What the value has to be, as the end of a sentence: `a number of
/// millimetres, from 1 to 10`.
pub(super) fn expected(kind: &Kind) -> String {
    match kind {
        Kind::Version => format!("the whole number {VERSION}"),
        Kind::Number(range) => number(range),
        Kind::Whole(range) => format!("a whole number, {range}"),
        Kind::Text => "a string, \"in quotes\"".to_owned(),
        Kind::Word(words) => {
            let quoted: Vec<_> = words.iter().map(|word| format!("\"{word}\"")).collect();
            format!("one of {}", quoted.join(", "))
        }
        Kind::Pair(range) => format!("a pair such as [1, 2], each {}", number(range)),
        Kind::Points(..) => {
            "a list of points in millimetres, such as [[0, 0], [1, 0], [0, 1]]".to_owned()
        }
        Kind::Wholes(range, _) => {
            format!("a list of whole numbers such as [0, 2, 4], each {range}")
        }
        Kind::Table(_) => "a table".to_owned(),
        Kind::Tables(_, _, written) => format!("a list of tables, {written}"),
        Kind::Obstacles => "a list of tables, each under its own [[obstacle]]".to_owned(),
    }
}

/// What a number in this range has to be.
pub(super) fn number(range: &Limits) -> String {
    match range.unit {
        Unit::Millimetre => format!("a number of millimetres, {range}"),
        Unit::Degree => format!("a number of degrees, {range}"),
        Unit::Gram => format!("a number of grams, {range}"),
        Unit::NewtonSquareMillimetre => format!("a number of N mm², {range}"),
        Unit::Newton => format!("a number of newtons, {range}"),
        Unit::NewtonMillimetre => format!("a number of N mm, {range}"),
        Unit::MetrePerSecondSquared => format!("a number of m/s², {range}"),
        Unit::One => format!("a number, {range}"),
    }
}
