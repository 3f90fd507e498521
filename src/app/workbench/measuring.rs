//! What was measured, against the robot: the distances of the shape, and the
//! search for the pull that suits best.

use crate::experiments::{MeasuredFault, ShapeError, ShapeFit};
use crate::scene::Scene;
use crate::solving::TaskId;

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
    /// The solver's name for it.
    pub task: TaskId,
    /// The share of it that is done, from 0 to 1.
    pub share: f64,
}

/// The pull that suits the measurement best.
#[derive(Clone, Debug, PartialEq)]
pub struct Best {
    /// The scene it was found for.
    pub scene: Scene,
    /// The distances that are left at that pull, or why there is no such pull.
    pub fit: Result<ShapeFit, ShapeError>,
}

impl Measuring {
    /// Notes how far a search is.
    pub(super) fn go_on(&mut self, task: TaskId, share: f64) {
        if let Some(search) = self.search.as_mut().filter(|search| search.task == task) {
            search.share = share;
        }
    }

    /// Takes what a search has found; nothing of one that was given up.
    pub(super) fn end(&mut self, task: TaskId, fit: Result<ShapeFit, ShapeError>) {
        if let Some(search) = self.search.take_if(|search| search.task == task) {
            let scene = search.scene;
            self.best = Some(Best { scene, fit });
        }
    }

    /// Gives up a search that is not for this scene, whatever its pull is, and
    /// says which.
    pub(super) fn give_up(&mut self, scene: &Scene) -> Option<TaskId> {
        let search = &mut self.search;
        let given_up = search.take_if(|search| !same_but_for_pull(&search.scene, scene));
        given_up.map(|search| search.task)
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
    a.take_drives(b);
    // Looks change nothing.
    a.photo.clone_from(&b.photo);
    a.title.clone_from(&b.title);
    a == *b
}
