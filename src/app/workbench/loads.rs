//! The load on the cable in the place of its pull: each amounts to the other
//! along the path, where the stiffness is known.

use super::document::Document;
use super::live::Live;
use crate::explore::Path;
use crate::units::{grams, metres, millimetres, newtons};
use std::sync::Arc;

/// Loads of the present robot.
#[derive(Clone, Debug)]
pub struct Loads {
    path: Arc<Path>,
    /// What 1 rad²/m amounts to, in N.
    newtons: f64,
}

impl Loads {
    /// `None` where the stiffness is not known, or the path not yet.
    pub fn of(document: &Document, live: &Live) -> Option<Self> {
        let newtons = document.newtons_per_multiplier()?;
        Self::on(Arc::clone(live.path()?), newtons)
    }

    /// Loads along a path, of so many newtons for a multiplier of 1 rad²/m; `None`
    /// where it has no states.
    pub(super) fn on(path: Arc<Path>, newtons: f64) -> Option<Self> {
        path.range()?;
        Some(Self { path, newtons })
    }

    /// The load that holds the robot at a pull, in grams.
    pub fn load_g(&self, pull_mm: f64) -> f64 {
        let (first, last) = self.path.range().unwrap_or_default();
        let state = self.path.at(metres(pull_mm).clamp(first, last));
        state.map_or(0.0, |state| grams(self.newtons * state.load()))
    }

    /// The pull that a load amounts to, in mm: for more than any shape needs,
    /// the last pull of all.
    pub fn pull_mm(&self, load_g: f64) -> f64 {
        let pull = self.path.pull_at_load(newtons(load_g) / self.newtons);
        let last = self.path.range().map_or(0.0, |range| range.1);
        millimetres(pull.unwrap_or(last))
    }

    /// The greatest load that is offered, in grams. The last few shapes before a
    /// branch ends need more, without bound.
    pub fn most_g(&self) -> f64 {
        grams(self.newtons * self.path.usual_load())
    }
}
