//! The study file: what it says, read from TOML and written as TOML. Opens no files.

use toml::{Table, Value};

use super::error::StudyError;
use super::parameter::{Parameter, Scale, Values};
use super::sampler::Sampler;
use crate::scene::limits::shown;
use crate::scene::{MAX_FILE_BYTES, nearest, quoted};

/// The version of the file format.
pub const VERSION: u32 = 1;

/// Most values of a list.
const MOST_VALUES: usize = 100_000;

/// What a study file says, its names not yet looked up in a scene.
#[derive(Clone, Debug, PartialEq)]
pub struct StudyFile {
    /// What the study is called.
    pub title: Option<String>,
    /// The scene's file, from the study file's folder.
    pub scene: String,
    /// How samples are taken.
    pub sampler: Sampler,
    /// How many samples, where the sampler does not say.
    pub samples: Option<u64>,
    /// What a sampler with chance in it starts from.
    pub seed: u64,
    /// Names of outputs.
    pub outputs: Vec<String>,
    /// Comparisons of outputs.
    pub constraints: Vec<String>,
    /// Where the tip should be, in mm.
    pub target_mm: Option<[f64; 2]>,
    /// What is varied.
    pub parameters: Vec<Parameter>,
}

/// The keys of a study.
pub(super) const STUDY_KEYS: &[&str] = &[
    "version",
    "title",
    "scene",
    "sampler",
    "samples",
    "seed",
    "outputs",
    "constraints",
    "target_mm",
    "parameter",
];

/// The keys of a parameter.
pub(super) const PARAMETER_KEYS: &[&str] =
    &["key", "from", "to", "steps", "values", "scale", "name"];

/// The names of scales.
pub(super) const SCALES: [&str; 2] = ["linear", "log"];

impl StudyFile {
    /// What a study's text says.
    ///
    /// # Errors
    /// The first fault: no TOML, keys that no study has, that are missing or hold what
    /// they cannot, ranges that are none.
    pub fn from_toml_bytes(bytes: &[u8]) -> Result<Self, StudyError> {
        if bytes.len() > MAX_FILE_BYTES {
            return Err(StudyError::TooLarge { bytes: bytes.len() });
        }
        let text = str::from_utf8(bytes).map_err(|error| StudyError::NotText {
            byte: error.valid_up_to(),
        })?;
        Self::from_toml(text)
    }

    /// Like [`StudyFile::from_toml_bytes`], from text.
    ///
    /// # Errors
    /// Those of [`StudyFile::from_toml_bytes`].
    pub fn from_toml(text: &str) -> Result<Self, StudyError> {
        let table: Table = text.parse().map_err(|error: toml::de::Error| {
            let start = error.span().map_or(0, |span| span.start);
            let before = text.get(..start).unwrap_or_default();
            StudyError::NotToml {
                line: before.matches('\n').count() + 1,
                message: error.message().to_owned(),
            }
        })?;
        let keys = Keys {
            table: &table,
            path: String::new(),
        };
        keys.only(STUDY_KEYS, "a key of a study")?;
        match keys.whole("version")? {
            Some(found) if found != u64::from(VERSION) => {
                return Err(StudyError::conflict(
                    "version",
                    format!("is {found}"),
                    format!("this program reads version {VERSION}"),
                ));
            }
            Some(_) => {}
            None => return Err(keys.missing("version", "`version = 1`")),
        }
        let scene = keys.text("scene")?;
        let scene = scene.ok_or_else(|| {
            keys.missing(
                "scene",
                "the scene's file, such as scene = \"two-posts.toml\"",
            )
        })?;
        let sampler = keys.word("sampler", &Sampler::NAMES)?;
        let sampler = sampler.and_then(|name| Sampler::of_name(&name));
        let outputs = keys.texts("outputs")?;
        let outputs = outputs.ok_or_else(|| {
            keys.missing(
                "outputs",
                "what to tell of each sample, such as outputs = [\"force_max_n\"]",
            )
        })?;
        let file = Self {
            title: keys.text("title")?,
            scene,
            sampler: sampler.unwrap_or(Sampler::Grid),
            samples: keys.whole("samples")?,
            seed: keys.whole("seed")?.unwrap_or(0),
            outputs,
            constraints: keys.texts("constraints")?.unwrap_or_default(),
            target_mm: keys.pair("target_mm")?,
            parameters: parameters(&table)?,
        };
        Ok(file)
    }

    /// The study as TOML, from which [`StudyFile::from_toml`] reads the same.
    pub fn to_toml(&self) -> String {
        let mut table = Table::new();
        let mut put = |key: &str, value: Value| {
            table.insert(key.to_owned(), value);
        };
        put("version", Value::Integer(VERSION.into()));
        if let Some(title) = &self.title {
            put("title", Value::String(title.clone()));
        }
        put("scene", Value::String(self.scene.clone()));
        put("sampler", Value::String(self.sampler.name().to_owned()));
        if let Some(samples) = self.samples {
            put("samples", whole(samples));
        }
        put("seed", whole(self.seed));
        put("outputs", texts(&self.outputs));
        put("constraints", texts(&self.constraints));
        if let Some(target) = self.target_mm {
            put("target_mm", numbers(&target));
        }
        let parameters = self
            .parameters
            .iter()
            .map(|one| Value::Table(parameter_table(one)));
        put("parameter", Value::Array(parameters.collect()));
        // A table of plain values can always be written.
        toml::to_string(&table).unwrap_or_default()
    }
}

fn whole(value: u64) -> Value {
    // Greater ones were refused when they were read.
    Value::Integer(i64::try_from(value).unwrap_or(i64::MAX))
}

fn texts(list: &[String]) -> Value {
    Value::Array(list.iter().cloned().map(Value::String).collect())
}

fn numbers(list: &[f64]) -> Value {
    Value::Array(list.iter().copied().map(Value::Float).collect())
}

fn parameter_table(parameter: &Parameter) -> Table {
    let mut table = Table::new();
    let mut put = |key: &str, value: Value| {
        table.insert(key.to_owned(), value);
    };
    put("key", Value::String(parameter.key.clone()));
    match &parameter.values {
        Values::List(values) => put("values", numbers(values)),
        Values::Range {
            from,
            to,
            steps,
            scale,
        } => {
            put("from", Value::Float(*from));
            put("to", Value::Float(*to));
            if let Some(steps) = steps {
                put("steps", whole(*steps));
            }
            put("scale", Value::String(SCALES[*scale as usize].to_owned()));
        }
    }
    if let Some(name) = &parameter.name {
        put("name", Value::String(name.clone()));
    }
    table
}

fn parameters(table: &Table) -> Result<Vec<Parameter>, StudyError> {
    let list = match table.get("parameter") {
        Some(Value::Array(list)) if !list.is_empty() => list,
        None | Some(Value::Array(_)) => {
            return Err(StudyError::Missing {
                field: "parameter".to_owned(),
                what: "at least one [[parameter]] with the key that it varies",
            });
        }
        Some(other) => {
            return Err(mistyped(
                "parameter",
                other,
                "each under its own [[parameter]]",
            ));
        }
    };
    let each = list.iter().enumerate().map(|(index, item)| {
        let path = format!("parameter[{index}]");
        match item {
            Value::Table(table) => parameter(&Keys { table, path }),
            other => Err(mistyped(
                &path,
                other,
                "a table under its own [[parameter]]",
            )),
        }
    });
    each.collect()
}

fn parameter(keys: &Keys<'_>) -> Result<Parameter, StudyError> {
    keys.only(PARAMETER_KEYS, "a key of a parameter")?;
    let key = keys.text("key")?;
    let key = key.ok_or_else(|| {
        keys.missing(
            "key",
            "what it varies, such as key = \"robot.cable_offset_mm\"",
        )
    })?;
    let scale = keys.word("scale", &SCALES)?;
    let values = match keys.numbers("values")? {
        Some(values) => {
            if let Some(other) = ["from", "to", "steps", "scale"]
                .into_iter()
                .find(|key| keys.table.contains_key(*key))
            {
                return Err(StudyError::conflict(
                    keys.field(other),
                    "stands beside values",
                    "remove one of them",
                ));
            }
            if values.is_empty() || values.len() > MOST_VALUES {
                return Err(StudyError::conflict(
                    keys.field("values"),
                    format!("has {} values", values.len()),
                    format!("give 1 to {MOST_VALUES}"),
                ));
            }
            Values::List(values)
        }
        None => range(keys, scale.as_deref() == Some(SCALES[1]))?,
    };
    Ok(Parameter {
        key: key.trim().to_owned(),
        values,
        name: keys.text("name")?,
    })
}

fn range(keys: &Keys<'_>, is_log: bool) -> Result<Values, StudyError> {
    let end = |key| keys.number(key);
    let (Some(from), Some(to)) = (end("from")?, end("to")?) else {
        let lacks = if keys.table.contains_key("from") {
            "to"
        } else {
            "from"
        };
        return Err(keys.missing(
            lacks,
            "the ends of its range, from and to, or values = [..]",
        ));
    };
    let steps = keys.whole("steps")?;
    let shown_range = format!("is {}, and from is {}", shown(to), shown(from));
    if to < from {
        let advice = "exchange them: values rise from `from` to `to`";
        return Err(StudyError::conflict(keys.field("to"), shown_range, advice));
    }
    if to == from && steps != Some(1) {
        let advice = "give a range with a length, or values = [..] with the one value";
        return Err(StudyError::conflict(keys.field("to"), shown_range, advice));
    }
    if steps == Some(0) || (steps == Some(1) && to != from) {
        let problem = format!("is {}", steps.unwrap_or(0));
        let advice = "give at least 2, the ends of the range among them";
        return Err(StudyError::conflict(keys.field("steps"), problem, advice));
    }
    if is_log && from <= 0.0 {
        let problem = format!("is {}, which has no logarithm", shown(from));
        let advice = "with scale = \"log\" both ends are above 0";
        return Err(StudyError::conflict(keys.field("from"), problem, advice));
    }
    let scale = if is_log { Scale::Log } else { Scale::Linear };
    Ok(Values::Range {
        from,
        to,
        steps,
        scale,
    })
}

/// A table and where it stands.
struct Keys<'a> {
    table: &'a Table,
    path: String,
}

impl Keys<'_> {
    fn field(&self, key: &str) -> String {
        match self.path.as_str() {
            "" => key.to_owned(),
            path => format!("{path}.{key}"),
        }
    }

    fn missing(&self, key: &str, what: &'static str) -> StudyError {
        StudyError::Missing {
            field: self.field(key),
            what,
        }
    }

    fn only(&self, known: &[&'static str], what: &'static str) -> Result<(), StudyError> {
        match self.table.keys().find(|key| !known.contains(&key.as_str())) {
            None => Ok(()),
            Some(key) => {
                let bare = |c: char| c.is_ascii_alphanumeric() || c == '_' || c == '-';
                let is_bare = !key.is_empty() && key.len() <= 60 && key.chars().all(bare);
                Err(StudyError::Unknown {
                    field: self.field(&if is_bare { key.clone() } else { quoted(key) }),
                    what,
                    nearest: nearest(key, known),
                    known: known.to_vec(),
                })
            }
        }
    }

    fn text(&self, key: &str) -> Result<Option<String>, StudyError> {
        match self.table.get(key) {
            None => Ok(None),
            Some(Value::String(text)) if !text.trim().is_empty() => Ok(Some(text.clone())),
            Some(Value::String(_)) => {
                let advice = "write something or remove it";
                Err(StudyError::conflict(self.field(key), "is empty", advice))
            }
            Some(other) => Err(mistyped(&self.field(key), other, "a string, \"in quotes\"")),
        }
    }

    fn word(&self, key: &str, known: &[&'static str]) -> Result<Option<String>, StudyError> {
        match self.text(key)? {
            Some(word) if !known.contains(&word.as_str()) => Err(StudyError::Unknown {
                field: format!("{}, {},", self.field(key), quoted(&word)),
                what: "known",
                nearest: nearest(&word, known),
                known: known.to_vec(),
            }),
            word => Ok(word),
        }
    }

    fn texts(&self, key: &str) -> Result<Option<Vec<String>>, StudyError> {
        let expected = "a list of strings, [\"in\", \"quotes\"]";
        let list = match self.table.get(key) {
            None => return Ok(None),
            Some(Value::Array(list)) => list,
            Some(other) => return Err(mistyped(&self.field(key), other, expected)),
        };
        let each = list.iter().enumerate().map(|(index, item)| match item {
            Value::String(text) => Ok(text.clone()),
            other => Err(mistyped(
                &format!("{}[{index}]", self.field(key)),
                other,
                expected,
            )),
        });
        each.collect::<Result<_, _>>().map(Some)
    }

    fn whole(&self, key: &str) -> Result<Option<u64>, StudyError> {
        match self.table.get(key) {
            None => Ok(None),
            Some(Value::Integer(count)) if *count >= 0 => Ok(Some(count.unsigned_abs())),
            Some(other) => Err(mistyped(
                &self.field(key),
                other,
                "a whole number, 0 or more",
            )),
        }
    }

    fn number(&self, key: &str) -> Result<Option<f64>, StudyError> {
        self.table
            .get(key)
            .map(|found| number(&self.field(key), found))
            .transpose()
    }

    fn numbers(&self, key: &str) -> Result<Option<Vec<f64>>, StudyError> {
        let list = match self.table.get(key) {
            None => return Ok(None),
            Some(Value::Array(list)) => list,
            Some(other) => return Err(mistyped(&self.field(key), other, "a list of numbers")),
        };
        let field = self.field(key);
        let each = list.iter().enumerate();
        let each = each.map(|(index, item)| number(&format!("{field}[{index}]"), item));
        each.collect::<Result<_, _>>().map(Some)
    }

    fn pair(&self, key: &str) -> Result<Option<[f64; 2]>, StudyError> {
        match self.numbers(key)?.as_deref() {
            None => Ok(None),
            Some([x, y]) => Ok(Some([*x, *y])),
            Some(list) => Err(StudyError::conflict(
                self.field(key),
                format!("has {} numbers", list.len()),
                "give two, x and y",
            )),
        }
    }
}

fn number(field: &str, found: &Value) -> Result<f64, StudyError> {
    match found {
        Value::Float(number) if number.is_finite() => Ok(*number),
        Value::Integer(number) => Ok(*number as f64),
        other => Err(mistyped(field, other, "a finite number")),
    }
}

fn mistyped(field: &str, found: &Value, expected: &'static str) -> StudyError {
    let found = match found {
        Value::String(text) => format!("{}, a string", quoted(text)),
        Value::Integer(number) => format!("{number}"),
        Value::Float(number) => shown(*number),
        Value::Boolean(truth) => format!("{truth}, a truth value"),
        Value::Datetime(date) => format!("{date}, a date or time"),
        Value::Array(items) => format!("a list of {}", items.len()),
        Value::Table(_) => "a table".to_owned(),
    };
    StudyError::WrongType {
        field: field.to_owned(),
        found,
        expected,
    }
}
