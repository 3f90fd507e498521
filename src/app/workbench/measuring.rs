//! What was measured, against the robot: the distances of the shape, and the
//! search for the pull that suits best.

use crate::experiments::{MeasuredFault, ShapeFit};
use crate::scene::Scene;
use std::sync::mpsc::Receiver;

/// Measurements against the robot.
#[derive(Default)]
pub struct Measuring {
    /// What the comparison is of, and how it turned out.
    pub compared: Option<(Basis, Result<ShapeFit, MeasuredFault>)>,
    /// The search for the best pull, while it goes on.
    pub search: Option<Search>,
    /// What it has found.
    pub best: Option<Best>,
}

/// What a comparison rests on; a new one is needed when this changes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Basis {
    /// Counts the drawings, which change with both the scene and the shape.
    pub revision: u64,
}

/// A search for the best pull.
pub struct Search {
    /// The scene it was started for.
    pub scene: Scene,
    /// Where what it finds comes.
    pub result: Receiver<Result<ShapeFit, String>>,
}

/// The pull that suits the measurement best.
#[derive(Clone, Debug, PartialEq)]
pub struct Best {
    /// The scene it was found for.
    pub scene: Scene,
    /// The distances that are left at that pull, or why there is no such pull.
    pub fit: Result<ShapeFit, String>,
}

impl Measuring {
    /// Whether the best pull is being searched for.
    pub fn is_searching(&self) -> bool {
        self.search.is_some()
    }

    /// The best pull, if it was found for this scene, whatever its pull is now.
    pub fn best(&self, scene: &Scene) -> Option<&Best> {
        self.best
            .as_ref()
            .filter(|best| same_but_for_pull(&best.scene, scene))
    }
}

fn same_but_for_pull(a: &Scene, b: &Scene) -> bool {
    let mut a = a.clone();
    a.actuation.clone_from(&b.actuation);
    // Looks change nothing.
    a.photo.clone_from(&b.photo);
    a.title.clone_from(&b.title);
    a == *b
}
