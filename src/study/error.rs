//! What can be wrong with a study, in sentences for whoever wrote it.

use super::MAX_SAMPLES;
use crate::scene::{MAX_FILE_BYTES, SceneError};

/// A fault of a study file, or of a study with the scene that it is about.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum StudyError {
    /// The file is larger than a study can be.
    #[error("the file has {bytes} bytes; a study has at most {MAX_FILE_BYTES}, so this is not one")]
    TooLarge {
        /// Its size.
        bytes: usize,
    },

    /// The file is not UTF-8 text.
    #[error("the file is not UTF-8 text (first at byte {byte}); a study is a TOML text file")]
    NotText {
        /// Offset of the first byte that does not belong, from 0.
        byte: usize,
    },

    /// The text breaks the rules of TOML.
    #[error("line {line} is not valid TOML: {message}")]
    NotToml {
        /// The line, from 1.
        line: usize,
        /// What is wrong there.
        message: String,
    },

    /// A key or a word that means nothing where it stands.
    #[error("{field} is not {what}; {}", suggestion(.nearest, .known))]
    Unknown {
        /// The key, or the field with the word.
        field: String,
        /// What it should be, such as `a key of a study`.
        what: &'static str,
        /// The known one that is spelled most like it, when one is near.
        nearest: Option<&'static str>,
        /// All that may stand there.
        known: Vec<&'static str>,
    },

    /// A key that has to be there and is not.
    #[error("{field} is missing; add {what}")]
    Missing {
        /// The key.
        field: String,
        /// What it should hold.
        what: &'static str,
    },

    /// A value of the wrong kind.
    #[error("{field} is {found}; write {expected}")]
    WrongType {
        /// The field.
        field: String,
        /// What it holds.
        found: String,
        /// What it should hold.
        expected: &'static str,
    },

    /// A value, or several together, that cannot be meant.
    #[error("{field} {problem}; {advice}")]
    Conflict {
        /// The field to change.
        field: String,
        /// What is wrong: the sentence that starts with the field.
        problem: String,
        /// What to do.
        advice: String,
    },

    /// More samples than anybody can wait for.
    #[error(
        "the study has {samples} samples, and at most {MAX_SAMPLES} can be asked for; take fewer steps, \
         or sampler = \"sobol\" with samples = 100000"
    )]
    TooMany {
        /// How many there are.
        samples: u128,
    },

    /// A fault of the scene that no parameter changes.
    #[error("its scene: {fault}")]
    Scene {
        /// What is wrong with it.
        fault: SceneError,
    },

    /// A parameter that the scene does not take.
    #[error("{field}: {fault}")]
    Parameter {
        /// The parameter's field.
        field: String,
        /// What the scene says to it.
        fault: SceneError,
    },
}

impl StudyError {
    pub(super) fn conflict(
        field: impl Into<String>,
        problem: impl Into<String>,
        advice: impl Into<String>,
    ) -> Self {
        Self::Conflict {
            field: field.into(),
            problem: problem.into(),
            advice: advice.into(),
        }
    }
}

fn suggestion(nearest: &Option<&str>, known: &[&str]) -> String {
    match nearest {
        Some(name) => format!("did you mean `{name}`?"),
        None => format!("use one of {}", known.join(", ")),
    }
}
