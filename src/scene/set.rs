//! Single values of a scene by the names that messages give them, such as
//! `obstacle[0].center_mm[0]`, for command lines and tables of variants.

use toml::{Table, Value};

use super::keys::{Key, Kind, Presence, SCENE, SPACING};
use super::limits::{DISK_SPACING, DISKS, LENGTH, shown};
use super::{Scene, SceneError, walk};

impl Scene {
    /// Sets a value: a key as messages print it (`robot.length_mm`,
    /// `obstacle[0].center_mm[0]`, `cable[1].load_g`) and what to set it to, as
    /// a scene file would have it; texts and words do without quotes.
    ///
    /// A key that may be left out need not be there before. `pull_mm` and
    /// `load_g` take each other's place. Two keys that no file has stand for
    /// `robot.segments`, and keep the robot's length and its segments a bay:
    /// `robot.disks`, the number of disks without the base's, and
    /// `robot.disk_spacing_mm`, which divides the length to one part in 10⁹.
    ///
    /// # Errors
    /// For a key that no scene has or that is not in this one, and for a value
    /// of the wrong kind; the scene is then as it was. That the value can be
    /// meant is for [`Scene::faults`] to say.
    pub fn set(&mut self, key: &str, value: &str) -> Result<(), SceneError> {
        let key = key.trim();
        match key.strip_prefix("robot.") {
            Some("disks") => return self.set_disks(value),
            Some("disk_spacing_mm") => {
                let found = parsed(value);
                let spacing = match &found {
                    Value::Float(number) => *number,
                    Value::Integer(number) => *number as f64,
                    other => return Err(mistyped(key, other, &SPACING[0])),
                };
                return self.set_disk_spacing(spacing);
            }
            _ => {}
        }
        let mut table = Table::try_from(&*self).map_err(|error| SceneError::NotWritable {
            message: error.to_string(),
        })?;
        let steps = steps(key)?;
        set_in_table(&mut table, SCENE, &steps, "", value)?;
        walk::scene(&table)?;
        *self = Scene::from_table(table)?;
        Ok(())
    }

    fn set_disks(&mut self, value: &str) -> Result<(), SceneError> {
        let key = &SPACING[1];
        let found = parsed(value);
        let disks = found
            .as_integer()
            .ok_or_else(|| mistyped("robot.disks", &found, key))?;
        match u32::try_from(disks) {
            Ok(count) if DISKS.contain(count.into()) => self.put_disks(count),
            _ => return Err(SceneError::outside("robot.disks", disks as f64, &DISKS)),
        }
        Ok(())
    }

    pub(super) fn set_disk_spacing(&mut self, spacing: f64) -> Result<(), SceneError> {
        let field = "robot.disk_spacing_mm";
        let length = self.robot.length_mm;
        if !DISK_SPACING.contain(spacing) {
            return Err(SceneError::outside(field, spacing, &DISK_SPACING));
        }
        if !LENGTH.contain(length) {
            return Err(SceneError::outside("robot.length_mm", length, &LENGTH));
        }
        let bays = (length / spacing).round();
        let is_even = (length - bays * spacing).abs() <= 1e-9 * length;
        if is_even && DISKS.contain(bays) {
            self.put_disks(bays as u32);
            return Ok(());
        }
        // The divisors of the length on either side, where there are such.
        let fewer = (length / spacing).floor();
        let nearest: Vec<String> = [fewer + 1.0, fewer]
            .into_iter()
            .filter(|bays| DISKS.contain(*bays))
            .map(|bays| {
                let disks = if bays > 1.0 { "disks" } else { "disk" };
                format!("{} for {bays} {disks}", shown(length / bays))
            })
            .collect();
        let (spacing, length) = (shown(spacing), shown(length));
        Err(SceneError::Conflict {
            field: field.to_owned(),
            problem: format!("is {spacing} mm, which does not divide robot.length_mm, {length}"),
            advice: format!("set it to {}", nearest.join(" or ")),
        })
    }

    pub(super) fn put_disks(&mut self, disks: u32) {
        let robot = &mut self.robot;
        robot.segments = disks.saturating_mul(robot.segments_per_bay);
    }
}

/// Whether a key holds a whole number, such as `robot.disks` or `cable[0].to_disk`, and
/// no other. A key that no scene has does not.
pub fn is_count(key: &str) -> bool {
    if key.trim() == "robot.disks" {
        return true;
    }
    let Ok(steps) = steps(key.trim()) else {
        return false;
    };
    let mut keys = SCENE;
    let mut found = None;
    for step in steps {
        let Step::Key(name) = step else { continue };
        found = keys
            .iter()
            .find(|key| key.name == name)
            .map(|key| &key.kind);
        keys = match found {
            Some(Kind::Table(keys) | Kind::Tables(keys, ..)) => keys,
            _ => &[],
        };
    }
    matches!(found, Some(Kind::Whole(_) | Kind::Wholes(..)))
}

/// A step into a scene.
#[derive(Clone, Copy)]
pub(super) enum Step<'a> {
    Key(&'a str),
    Index(usize),
}

/// The steps of a name such as `obstacle[0].center_mm[0]`.
pub(super) fn steps(name: &str) -> Result<Vec<Step<'_>>, SceneError> {
    let mut steps = Vec::new();
    for part in name.split('.') {
        let (key, indices) = part.split_at(part.find('[').unwrap_or(part.len()));
        steps.push(Step::Key(key));
        for index in indices.split_terminator(']') {
            let index = index.strip_prefix('[').and_then(|index| index.parse().ok());
            let odd = || walk::unknown(name, SCENE.iter(), "");
            steps.push(Step::Index(index.ok_or_else(odd)?));
        }
    }
    Ok(steps)
}

fn set_in_table(
    table: &mut Table,
    keys: &'static [Key],
    steps: &[Step<'_>],
    path: &str,
    value: &str,
) -> Result<(), SceneError> {
    let (name, rest) = match steps {
        [Step::Key(name), rest @ ..] => (*name, rest),
        // A table in a list has no parts but by their keys.
        _ => return Err(walk::unknown("", keys.iter(), path)),
    };
    let spacing = if path == "robot" { SPACING } else { &[] };
    let Some(key) = keys.iter().find(|key| key.name == name) else {
        return Err(walk::unknown(name, keys.iter().chain(spacing), path));
    };
    let path = walk::join(path, name);
    if rest.is_empty() && key.presence == Presence::OneOf {
        for other in keys.iter().filter(|key| key.presence == Presence::OneOf) {
            table.remove(other.name);
        }
    }
    let place = table.entry(name).or_insert_with(|| nothing_of(&key.kind));
    set_in_value(place, &key.kind, rest, &path, value)
}

fn set_in_value(
    place: &mut Value,
    kind: &'static Kind,
    steps: &[Step<'_>],
    path: &str,
    value: &str,
) -> Result<(), SceneError> {
    let Some((step, rest)) = steps.split_first() else {
        *place = match kind {
            Kind::Text | Kind::Word(_) => text(value),
            _ => parsed(value),
        };
        return Ok(());
    };
    match (kind, step, place) {
        (Kind::Table(keys), Step::Key(_), Value::Table(table)) => {
            set_in_table(table, keys, steps, path, value)
        }
        (_, Step::Index(index), Value::Array(items)) => {
            let count = items.len();
            let Some(item) = items.get_mut(*index) else {
                return Err(not_there(path, *index, count));
            };
            let path = format!("{path}[{index}]");
            match (kind, item) {
                (Kind::Tables(keys, ..), Value::Table(table)) if !rest.is_empty() => {
                    set_in_table(table, keys, rest, &path, value)
                }
                (Kind::Obstacles, Value::Table(table)) if !rest.is_empty() => {
                    let keys = walk::keys_of_obstacle(table).unwrap_or_default();
                    set_in_table(table, keys, rest, &path, value)
                }
                (_, Value::Array(numbers)) => match rest {
                    [Step::Index(index)] => {
                        let count = numbers.len();
                        let number = numbers.get_mut(*index);
                        let absent = || not_there(&path, *index, count);
                        *number.ok_or_else(absent)? = parsed(value);
                        Ok(())
                    }
                    [] => {
                        *numbers = match parsed(value) {
                            Value::Array(numbers) => numbers,
                            other => vec![other],
                        };
                        Ok(())
                    }
                    _ => Err(no_parts(&path)),
                },
                (_, item) if rest.is_empty() => {
                    *item = parsed(value);
                    Ok(())
                }
                _ => Err(no_parts(&path)),
            }
        }
        _ => Err(no_parts(path)),
    }
}

/// What a key that was left out holds before a part of it is set.
fn nothing_of(kind: &Kind) -> Value {
    match kind {
        Kind::Table(_) => Value::Table(Table::new()),
        Kind::Pair(_) => Value::Array(vec![Value::Float(0.0); 2]),
        Kind::Tables(..) | Kind::Obstacles | Kind::Points(..) | Kind::Wholes(..) => {
            Value::Array(Vec::new())
        }
        Kind::Version | Kind::Number(_) | Kind::Whole(_) | Kind::Text | Kind::Word(_) => {
            Value::String(String::new())
        }
    }
}

/// A value as a scene file has it; whatever is none, as text.
fn parsed(value: &str) -> Value {
    let value = value.trim();
    let line: Result<Table, _> = format!("value = {value}").parse();
    match line {
        Ok(mut table) if table.len() == 1 => table.remove("value"),
        _ => None,
    }
    .unwrap_or_else(|| Value::String(value.to_owned()))
}

/// A text, in quotes or not.
fn text(value: &str) -> Value {
    match parsed(value) {
        Value::String(text) => Value::String(text),
        _ => Value::String(value.to_owned()),
    }
}

fn mistyped(field: &str, found: &Value, key: &Key) -> SceneError {
    walk::wrong_type(field, found, super::keys::expected(&key.kind))
}

fn not_there(list: &str, index: usize, count: usize) -> SceneError {
    let advice = match (list, count) {
        ("cable", 0) => "its cable is described by robot.cable_offset_mm and actuation".to_owned(),
        (_, 0) => format!("there is no {list}: add it to the file"),
        (_, 1) => format!("the only one is {list}[0]"),
        _ => format!("name one from {list}[0] to {list}[{}]", count - 1),
    };
    SceneError::NotThere {
        path: format!("{list}[{index}]"),
        advice,
    }
}

fn no_parts(path: &str) -> SceneError {
    SceneError::NotThere {
        path: format!("that part of {path}"),
        advice: format!("set {path} as a whole"),
    }
}
