//! Whether a TOML table has the shape of a scene: keys known, keys present,
//! values of the right kind. Ranges of numbers are not its business.

use toml::{Table, Value};

use super::keys::{Key, Kind, Presence, SCENE, SHAPE, SHAPES, expected, number};
use super::limits::{Limits, shown};
use super::{SceneError, VERSION};

/// Nothing, when serde can read the table as a scene without loss.
///
/// # Errors
/// The first fault: the version, then in each table unknown keys before
/// missing and mistyped ones.
pub(super) fn scene(table: &Table) -> Result<(), SceneError> {
    if table.is_empty() {
        return Err(SceneError::Empty);
    }
    // A later version may have other keys, so it is named before they are.
    if let Some(Value::Integer(found)) = table.get("version")
        && *found != i64::from(VERSION)
    {
        return Err(SceneError::Version { found: *found });
    }
    keys_of(table, SCENE, "")
}

fn keys_of(table: &Table, keys: &[Key], path: &str) -> Result<(), SceneError> {
    if let Some(stranger) = table
        .keys()
        .find(|name| keys.iter().all(|key| key.name != **name))
    {
        let known: Vec<_> = keys.iter().map(|key| key.name).collect();
        return Err(SceneError::UnknownKey {
            path: join(path, &bare_or_quoted(stranger)),
            nearest: nearest(stranger, &known),
            known,
        });
    }
    for key in keys {
        let path = join(path, key.name);
        match table.get(key.name) {
            Some(found) => value(found, &key.kind, &path)?,
            None if key.presence == Presence::Required => {
                let what = match &key.kind {
                    Kind::Table(_) => format!("a table headed [{path}] for {}", key.about),
                    kind => format!("{}, {}", key.about, expected(kind)),
                };
                return Err(SceneError::MissingKey { path, what });
            }
            None => {}
        }
    }
    Ok(())
}

fn value(found: &Value, kind: &Kind, path: &str) -> Result<(), SceneError> {
    let mistyped = || wrong_type(path, found, expected(kind));
    match (kind, found) {
        (Kind::Number(_), Value::Float(_) | Value::Integer(_)) => Ok(()),
        // Other versions were refused by `scene`.
        (Kind::Version, Value::Integer(_)) | (Kind::Text, Value::String(_)) => Ok(()),
        (Kind::Whole(range), Value::Integer(count)) => match u32::try_from(*count) {
            Ok(_) => Ok(()),
            Err(_) => Err(SceneError::OutOfRange {
                field: path.to_owned(),
                value: count.to_string(),
                allowed: range.to_string(),
                unit: range.unit.symbol(),
            }),
        },
        (Kind::Wholes(range, _), Value::Array(numbers)) => each(numbers, path, |number, path| {
            value(number, &Kind::Whole(*range), path)
        }),
        (Kind::Word(words), Value::String(word)) if !words.contains(&word.as_str()) => {
            Err(SceneError::UnknownWord {
                path: path.to_owned(),
                found: quoted(word),
                nearest: nearest(word, words),
                known: words.to_vec(),
            })
        }
        (Kind::Word(_), Value::String(_)) => Ok(()),
        (Kind::Pair(range), Value::Array(numbers)) if numbers.len() == 2 => {
            each(numbers, path, |item, path| {
                number_of_pair(item, range, path)
            })
        }
        (Kind::Points(range, ..), Value::Array(points)) => each(points, path, |point, path| {
            value(point, &Kind::Pair(*range), path)
        }),
        (Kind::Table(keys), Value::Table(table)) => keys_of(table, keys, path),
        (Kind::Tables(keys, ..), Value::Array(tables)) => {
            each(tables, path, |item, path| match item {
                Value::Table(table) => keys_of(table, keys, path),
                other => Err(wrong_type(path, other, "a table, { … }".to_owned())),
            })
        }
        (Kind::Obstacles, Value::Array(obstacles)) => {
            each(obstacles, path, |item, path| match item {
                Value::Table(table) => obstacle(table, path),
                other => Err(wrong_type(
                    path,
                    other,
                    "a table under its own [[obstacle]]".to_owned(),
                )),
            })
        }
        _ => Err(mistyped()),
    }
}

fn obstacle(table: &Table, path: &str) -> Result<(), SceneError> {
    let shape = match table.get(SHAPE.name) {
        Some(Value::String(word)) => SHAPES.iter().find(|shape| shape.word == word),
        _ => None,
    };
    match (shape, table.get(SHAPE.name)) {
        (Some(shape), _) => keys_of(table, shape.keys, path),
        (None, Some(word)) => value(word, &SHAPE.kind, &join(path, SHAPE.name)),
        (None, None) => Err(SceneError::MissingKey {
            path: join(path, SHAPE.name),
            what: format!("{}, {}", SHAPE.about, expected(&SHAPE.kind)),
        }),
    }
}

fn number_of_pair(item: &Value, range: &Limits, path: &str) -> Result<(), SceneError> {
    match item {
        Value::Float(_) | Value::Integer(_) => Ok(()),
        other => Err(wrong_type(path, other, number(range))),
    }
}

fn each(
    items: &[Value],
    path: &str,
    check: impl Fn(&Value, &str) -> Result<(), SceneError>,
) -> Result<(), SceneError> {
    items
        .iter()
        .enumerate()
        .try_for_each(|(i, item)| check(item, &format!("{path}[{i}]")))
}

fn wrong_type(path: &str, found: &Value, expected: String) -> SceneError {
    let found = match found {
        Value::String(text) => format!("{}, a string", quoted(text)),
        Value::Integer(number) => format!("{number}, a number"),
        Value::Float(number) => format!("{}, a number with a decimal point", decimal(*number)),
        Value::Boolean(truth) => format!("{truth}, a truth value"),
        Value::Datetime(date) => format!("{date}, a date or time"),
        Value::Array(items) => format!("a list of {}", items.len()),
        Value::Table(_) => "a table".to_owned(),
    };
    SceneError::WrongType {
        path: path.to_owned(),
        found,
        expected,
    }
}

/// A float as written in TOML, where `18.0` is another thing than `18`.
fn decimal(number: f64) -> String {
    let text = shown(number);
    if text
        .bytes()
        .all(|byte| byte.is_ascii_digit() || byte == b'-')
    {
        format!("{text}.0")
    } else {
        text
    }
}

fn join(path: &str, key: &str) -> String {
    if path.is_empty() {
        key.to_owned()
    } else {
        format!("{path}.{key}")
    }
}

fn bare_or_quoted(key: &str) -> String {
    let bare = |c: char| c.is_ascii_alphanumeric() || c == '_' || c == '-';
    if !key.is_empty() && key.len() <= 60 && key.chars().all(bare) {
        key.to_owned()
    } else {
        quoted(key)
    }
}

/// The text in quotes, on one line and cut to what a sentence can hold.
pub(crate) fn quoted(text: &str) -> String {
    let shortened: String = text.chars().take(40).collect();
    if shortened.len() < text.len() {
        format!("{:?}", shortened + "…")
    } else {
        format!("{text:?}")
    }
}

/// The name spelled most like the word, if it shares at least half its letters.
fn nearest(word: &str, names: &[&'static str]) -> Option<&'static str> {
    // Measuring takes time quadratic in the length, and no name is that long.
    if word.len() > 60 {
        return None;
    }
    let word = word.to_lowercase();
    names
        .iter()
        .map(|name| (strsim::normalized_damerau_levenshtein(&word, name), *name))
        .filter(|(likeness, _)| *likeness >= 0.5)
        .max_by(|a, b| a.0.total_cmp(&b.0))
        .map(|(_, name)| name)
}
