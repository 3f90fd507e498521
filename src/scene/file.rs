//! Scenes from text and to text. Opens no files.

use super::{Scene, SceneError, migrate, slip, walk};

/// The largest scene text that is looked at, in bytes.
///
/// A hand-written scene has a few kilobytes; the largest allowed, a thousand
/// polygons of 64 vertices, has about three million bytes with every digit of
/// its numbers.
pub const MAX_FILE_BYTES: usize = 4 << 20;

impl Scene {
    /// The scene the text describes, its numbers as written: see
    /// [`Scene::check`] for what they may be. A file of version 1 becomes the
    /// scene of version 2 that means the same, with the paper's model.
    ///
    /// # Errors
    /// When the text is larger than [`MAX_FILE_BYTES`], is not TOML, or does
    /// not have the shape of a scene: the first fault found.
    pub fn from_toml(text: &str) -> Result<Scene, SceneError> {
        refuse_large(text.len())?;
        let mut table: toml::Table = text.parse().map_err(|error| not_toml(text, &error))?;
        walk::scene(&table)?;
        migrate::to_present(&mut table);
        Scene::from_table(table)
    }

    /// The scene of a table of the present version, which the walk has passed.
    ///
    /// # Errors
    /// [`SceneError::NotAScene`], which no table is known to lead to.
    pub(super) fn from_table(table: toml::Table) -> Result<Scene, SceneError> {
        // The walk has named every fault that a hand can make; whatever it lets
        // pass and the types refuse is told in serde's words.
        table
            .try_into()
            .map_err(|error: toml::de::Error| SceneError::NotAScene {
                message: error.message().to_owned(),
            })
    }

    /// Like [`Scene::from_toml`], from the bytes of a file.
    ///
    /// # Errors
    /// Those of [`Scene::from_toml`], and when the bytes are not UTF-8.
    pub fn from_toml_bytes(bytes: &[u8]) -> Result<Scene, SceneError> {
        refuse_large(bytes.len())?;
        let text = str::from_utf8(bytes).map_err(|error| SceneError::NotText {
            byte: error.valid_up_to(),
        })?;
        Scene::from_toml(text)
    }

    /// The scene as TOML; [`Scene::from_toml`] reads back the very same scene
    /// when it has no [`Scene::faults`].
    ///
    /// # Errors
    /// When TOML cannot express the scene. No scene is known for which that is
    /// so, half-edited nonsense included.
    pub fn to_toml(&self) -> Result<String, SceneError> {
        toml::to_string(self).map_err(|error| SceneError::NotWritable {
            message: error.to_string(),
        })
    }
}

fn refuse_large(bytes: usize) -> Result<(), SceneError> {
    if bytes > MAX_FILE_BYTES {
        Err(SceneError::TooLarge { bytes })
    } else {
        Ok(())
    }
}

fn not_toml(text: &str, error: &toml::de::Error) -> SceneError {
    let message = error.message();
    // The parser's limits, which it words for programmers.
    if message.contains("recurs") {
        return SceneError::TooDeep;
    }
    let before = error
        .span()
        .and_then(|span| text.get(..span.start))
        .unwrap_or_default();
    let (line_start, line) = match before.rfind('\n') {
        Some(end) => (end + 1, before.matches('\n').count() + 1),
        None => (0, 1),
    };
    let whole_line = text[line_start..].lines().next().unwrap_or_default();
    let message = if message.starts_with("invalid type: integer") {
        "this whole number is too large; write it with a decimal point if it is meant".to_owned()
    } else {
        slip::advice(whole_line).unwrap_or_else(|| message.to_owned())
    };
    SceneError::NotToml {
        line,
        column: before[line_start..].chars().count() + 1,
        message,
    }
}
