//! Something that did not work and has to be read.

use crate::app::commands::Command;

/// Something that did not work.
#[derive(Clone, Debug, PartialEq)]
pub struct Trouble {
    /// What.
    pub title: String,
    /// Why, in sentences.
    pub reasons: Vec<String>,
    /// What can be done, leading to the offer.
    pub advice: Option<String>,
    /// The way out besides closing.
    pub offer: Option<(String, Command)>,
}

impl Trouble {
    /// A title, and why, in sentences.
    pub fn new(title: impl Into<String>, reasons: Vec<String>) -> Self {
        Self {
            title: title.into(),
            reasons,
            advice: None,
            offer: None,
        }
    }

    /// The same with what can be done.
    #[must_use]
    pub fn with(mut self, advice: &str) -> Self {
        self.advice = Some(advice.to_owned());
        self
    }

    /// The same with a button.
    #[must_use]
    pub fn offering(mut self, label: &str, command: Command) -> Self {
        self.offer = Some((label.to_owned(), command));
        self
    }
}
