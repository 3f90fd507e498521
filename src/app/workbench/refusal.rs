//! What was wrong with what was done last, as long as it is told.

use crate::scene::SceneError;

/// An edit that was taken back.
#[derive(Clone, Debug, PartialEq)]
pub struct Refusal {
    /// Why.
    pub faults: Vec<SceneError>,
    /// When, in seconds of the window's clock.
    pub at: f64,
}

/// What was wrong with what was typed last.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Complaint {
    /// The field's path in scene files.
    pub path: String,
    /// A sentence.
    pub text: String,
}
