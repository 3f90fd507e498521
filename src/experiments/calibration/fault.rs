//! What keeps constants from being fitted.

use crate::scene::SceneError;

/// Why nothing was fitted.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum CalibrationError {
    /// A word that is no constant.
    #[error(
        "{found} cannot be fitted; give some of ei, holes, contacts, base_loss with commas between{}",
        .nearest.map(|name| format!("; did you mean `{name}`?")).unwrap_or_default()
    )]
    UnknownConstant {
        /// The word, quoted.
        found: String,
        /// The known one spelled most like it, when one is near.
        nearest: Option<&'static str>,
    },
    /// A constant that comes twice.
    #[error("{0} is to be fitted twice; name it once")]
    Twice(&'static str),
    /// A constant that a column sets, too.
    #[error("row {row}: the column {key} sets what is to be fitted; leave it out of either")]
    Set {
        /// The head's row.
        row: usize,
        /// The key.
        key: &'static str,
    },
    /// The scene has no stiffness.
    #[error(
        "robot.bending_stiffness_nmm2 is missing, without which nothing is known in grams; set \
         it, if only as a guess that the fit starts from"
    )]
    NoStiffness,
    /// A scene that a row describes has a fault.
    #[error("row {row}: {fault}")]
    Scene {
        /// The row.
        row: usize,
        /// The fault.
        fault: SceneError,
    },
    /// A pull that no robot of this length has.
    #[error("row {row}: pull_mm is {pull_mm} mm; it has to be from -{most_mm} to {most_mm} mm")]
    OutOfReach {
        /// The row.
        row: usize,
        /// The pull, as one would write it.
        pull_mm: String,
        /// The robot's length.
        most_mm: String,
    },
    /// Too few readings.
    #[error(
        "{readings} readings do not fix {constants} constants; it takes at least one reading \
         more than constants"
    )]
    TooFew {
        /// How many there are.
        readings: usize,
        /// How many are to be fitted.
        constants: usize,
    },
    /// A row that no equilibrium follows from.
    #[error("row {row}: with {constants} no equilibrium is found: {reason}")]
    NoEquilibrium {
        /// The row.
        row: usize,
        /// The constants, in words.
        constants: String,
        /// Why.
        reason: String,
    },
    /// The load of a row counts from a contact that never comes.
    #[error(
        "row {row}: with {constants} the robot comes to press on nothing, so that \
         load_from_contact_g has nothing to count from; give load_g"
    )]
    NoContact {
        /// The row.
        row: usize,
        /// The constants, in words.
        constants: String,
    },
    /// The fit found no end.
    #[error(
        "the fit did not converge within {0} steps; start nearer, with --set, or fit fewer \
         constants"
    )]
    NotConverged(usize),
    /// The fit gave up.
    #[error("the fit gave up: {0}")]
    Refused(String),
}

impl CalibrationError {
    /// Whether it is a matter of the solver and not of what was asked.
    pub fn is_of_the_solver(&self) -> bool {
        matches!(
            self,
            Self::NoEquilibrium { .. } | Self::NotConverged(_) | Self::Refused(_)
        )
    }
}
