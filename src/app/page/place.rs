//! Where the window is in the browser's history: each example that is opened
//! is a place of its own in the page's address, to which there is a way back.

use crate::app::examples::{EXAMPLES, Example};
use crate::app::words::sentence;
use crate::app::workbench::Document;
use crate::scene::Scene;

/// What a fragment that names an example begins with.
const EXAMPLE: &str = "#example=";

/// The example that a fragment names, if it names any; or a sentence on why
/// there is none.
pub fn example(fragment: &str) -> Option<Result<Scene, String>> {
    let id = fragment.strip_prefix(EXAMPLE)?;
    let Some(example) = Example::named(id) else {
        let known: Vec<_> = EXAMPLES.iter().map(|example| example.id).collect();
        let known = known.join(", ");
        return Some(Err(format!(
            "The link names an example that is not there; there are {known}."
        )));
    };
    let scene = example.scene();
    Some(scene.map_err(|fault| sentence(&fault.to_string())))
}

/// The place in the page's address, and what was open there.
pub struct Place {
    /// The fragment of what is open.
    fragment: String,
    /// The fragment that the browser told last; it lags behind.
    told: String,
    kept: Scene,
    scene: Scene,
}

impl Place {
    /// The place of a document that was opened from a fragment.
    pub fn new(fragment: String, document: &Document) -> Self {
        Self {
            told: fragment.clone(),
            fragment,
            kept: document.kept().clone(),
            scene: document.scene.clone(),
        }
    }

    /// Whether the browser tells of a fragment that is to be opened, rather than
    /// of one that it was sent to.
    pub fn is_news(&mut self, told: &str) -> bool {
        if self.told == told {
            return false;
        }
        told.clone_into(&mut self.told);
        if self.fragment == told {
            return false;
        }
        told.clone_into(&mut self.fragment);
        true
    }

    /// The fragment to go to, where another document was opened but by its
    /// fragment.
    pub fn visit(&mut self, document: &Document) -> Option<&str> {
        let is_other = self.kept != *document.kept();
        let is_changed = self.scene != document.scene;
        if is_changed {
            self.scene.clone_from(&document.scene);
        }
        if !is_other {
            return None;
        }
        self.kept.clone_from(document.kept());
        // Saving makes another of what is kept, but of the same scene.
        if !is_changed || linked(&self.fragment).is_some_and(|scene| scene == self.kept) {
            return None;
        }
        let is_open = |example: &&Example| example.scene().is_ok_and(|scene| scene == self.kept);
        let fragment = match EXAMPLES.iter().find(is_open) {
            Some(example) => format!("{EXAMPLE}{}", example.id),
            None => String::new(),
        };
        if self.fragment == fragment {
            return None;
        }
        self.fragment = fragment;
        Some(&self.fragment)
    }
}

/// The scene that a fragment leads to, if any; without one, to the first
/// example.
fn linked(fragment: &str) -> Option<Scene> {
    let scene = super::linked(fragment).ok()?;
    scene.or_else(|| EXAMPLES.first()?.scene().ok())
}
