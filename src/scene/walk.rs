//! Whether a TOML table has the shape of a scene: keys known, keys present,
//! values of the right kind. Ranges of numbers are not its business.

use toml::{Table, Value};

use super::keys::{Key, Kind, Presence, SCENE, SHAPE, SHAPES, expected, missing, number};
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
    let version = match table.get("version") {
        Some(Value::Integer(found)) => match u32::try_from(*found) {
            Ok(version @ 1..=VERSION) => version,
            _ => return Err(SceneError::Version { found: *found }),
        },
        _ => VERSION,
    };
    Walk { version }.keys_of(table, SCENE, "")
}

/// A walk through a file of a version.
struct Walk {
    version: u32,
}

impl Walk {
    fn keys_of(&self, table: &Table, keys: &[Key], path: &str) -> Result<(), SceneError> {
        for name in table.keys() {
            match keys.iter().find(|key| key.name == *name) {
                None => return Err(self.unknown(name, keys, path)),
                Some(key) if key.since > self.version => {
                    return Err(SceneError::NewerKey {
                        path: join(path, key.name),
                        since: key.since,
                    });
                }
                Some(_) => {}
            }
        }
        for key in keys {
            let path = join(path, key.name);
            match table.get(key.name) {
                Some(found) => self.value(found, &key.kind, &path)?,
                None if key.presence == Presence::Required => return Err(missing(key, path)),
                None => {}
            }
        }
        self.one_of(table, keys, path)
    }

    /// Of the keys that exclude each other one is there.
    fn one_of(&self, table: &Table, keys: &[Key], path: &str) -> Result<(), SceneError> {
        let mut choice = keys
            .iter()
            .filter(|key| key.presence == Presence::OneOf && key.since <= self.version);
        let is_there = |key: &&Key| table.contains_key(key.name);
        let mut there = choice.clone().filter(is_there);
        if let (Some(first), Some(second)) = (there.next(), there.next()) {
            return Err(SceneError::Conflict {
                field: join(path, second.name),
                problem: format!("stands beside {}", first.name),
                advice: "remove one of them".to_owned(),
            });
        }
        match choice.next() {
            Some(first) if !choice.clone().chain([first]).any(|key| is_there(&key)) => {
                let or: String = choice
                    .map(|key| format!("; or {}, {}, {}", key.name, key.about, expected(&key.kind)))
                    .collect();
                Err(match missing(first, join(path, first.name)) {
                    SceneError::MissingKey { path, what } => SceneError::MissingKey {
                        path,
                        what: what + &or,
                    },
                    other => other,
                })
            }
            _ => Ok(()),
        }
    }

    fn unknown(&self, name: &str, keys: &[Key], path: &str) -> SceneError {
        let known = keys.iter().filter(|key| key.since <= self.version);
        unknown(name, known, path)
    }

    fn value(&self, found: &Value, kind: &Kind, path: &str) -> Result<(), SceneError> {
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
            (Kind::Wholes(range, _), Value::Array(numbers)) => {
                each(numbers, path, |number, path| {
                    self.value(number, &Kind::Whole(*range), path)
                })
            }
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
                self.value(point, &Kind::Pair(*range), path)
            }),
            (Kind::Table(keys), Value::Table(table)) => self.keys_of(table, keys, path),
            (Kind::Tables(keys, ..), Value::Array(tables)) => {
                each(tables, path, |item, path| match item {
                    Value::Table(table) => self.keys_of(table, keys, path),
                    other => Err(wrong_type(path, other, "a table, { … }".to_owned())),
                })
            }
            (Kind::Obstacles, Value::Array(obstacles)) => {
                each(obstacles, path, |item, path| match item {
                    Value::Table(table) => self.obstacle(table, path),
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

    fn obstacle(&self, table: &Table, path: &str) -> Result<(), SceneError> {
        match (keys_of_obstacle(table), table.get(SHAPE.name)) {
            (Some(keys), _) => self.keys_of(table, keys, path),
            (None, Some(word)) => self.value(word, &SHAPE.kind, &join(path, SHAPE.name)),
            (None, None) => Err(missing(&SHAPE, join(path, SHAPE.name))),
        }
    }
}

/// The keys of an obstacle, which depend on its shape; `None` where it has no
/// known shape.
pub(super) fn keys_of_obstacle(table: &Table) -> Option<&'static [Key]> {
    let word = table.get(SHAPE.name)?.as_str()?;
    let shape = SHAPES.iter().find(|shape| shape.word == word);
    shape.map(|shape| shape.keys)
}

/// The fault of a key that is none of those that are known.
pub(super) fn unknown<'a>(
    name: &str,
    known: impl Iterator<Item = &'a Key>,
    path: &str,
) -> SceneError {
    let known: Vec<_> = known.map(|key| key.name).collect();
    SceneError::UnknownKey {
        path: join(path, &bare_or_quoted(name)),
        nearest: nearest(name, &known),
        known,
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

pub(super) fn wrong_type(path: &str, found: &Value, expected: String) -> SceneError {
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

pub(super) fn join(path: &str, key: &str) -> String {
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
pub(crate) fn nearest(word: &str, names: &[&'static str]) -> Option<&'static str> {
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
