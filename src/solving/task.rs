//! What can be done in a batch: each kind of task as data that can go to
//! another thread or to a worker, its work in slices, and its answer. Which
//! task has its turn is the executor's business.

use crate::equilibrium::{Progress, Run, Settings, Solution, Start};
use crate::experiments::{Measured, PullSearch, ShapeError, ShapeFit};
use crate::explore::{Path, PathRun};
use crate::forces::Sweep;
use crate::mechanics::Problem;
use serde::{Deserialize, Serialize};

/// Iterations of a slice, as in live work: about 0.1 ms for the paper's robot.
const SLICE: usize = 32;
/// States of a path, as in live work: a pixel or two apart in a plot.
const STATES: usize = 201;

/// Names a task among those of one window.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct TaskId(pub u64);

/// Something that is done once, however long it takes.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub enum Task {
    /// The search for the pull whose shape is nearest to a measured one.
    BestPull {
        /// The robot and its obstacles; its own pull does not matter.
        problem: Problem,
        /// What was measured of it.
        measured: Measured,
    },
    /// The shape that a robot comes to from the straight one.
    Shape {
        /// The robot, what drives it and its obstacles.
        problem: Problem,
    },
    /// What a robot does along the pull of its first cable.
    Path {
        /// The robot, what drives it and its obstacles; its own pull does not matter.
        problem: Problem,
        /// The pulls to be covered, in metres.
        span: (f64, f64),
    },
}

/// What a task has led to.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub enum Answer {
    /// The distances that are left at the best pull, or why there is none.
    BestPull(Result<ShapeFit, ShapeError>),
    /// The shape, of the problem asked for or of the last one on the way to it that
    /// has an equilibrium.
    Shape(Box<Solution>),
    /// The robot along its pull.
    Path(Box<Path>),
}

/// A task that was begun.
#[derive(Debug)]
pub(super) enum Doing {
    BestPull(Box<PullSearch>),
    Shape(Box<(Problem, Run)>),
    Path(Box<PathRun>),
}

impl Doing {
    pub fn begin(task: Task) -> Self {
        match task {
            Task::BestPull { problem, measured } => {
                Self::BestPull(Box::new(PullSearch::new(problem, measured)))
            }
            Task::Shape { problem } => {
                let run = Run::new(&problem, Start::Straight, Settings::default());
                Self::Shape(Box::new((problem, run)))
            }
            Task::Path { problem, span } => {
                let pulls = Sweep::pulls(span.0, span.1, STATES);
                Self::Path(Box::new(PathRun::new(&problem, pulls)))
            }
        }
    }

    /// Works for a moment.
    pub fn work(&mut self) -> Progress {
        match self {
            Self::BestPull(search) => search.advance(SLICE),
            Self::Shape(shape) => shape.1.advance(SLICE),
            Self::Path(run) => run.advance(SLICE),
        }
    }

    /// What share of it is done, from 0 to 1.
    pub fn share(&self) -> f64 {
        match self {
            Self::BestPull(search) => search.share(),
            Self::Shape(shape) => shape.1.share(),
            Self::Path(run) => run.share(),
        }
    }

    /// The answer, of one that is done.
    pub fn answer(self) -> Answer {
        match self {
            Self::BestPull(search) => Answer::BestPull(search.finish().map(|(_, fit)| fit)),
            Self::Shape(shape) => {
                let (problem, run) = *shape;
                Answer::Shape(Box::new(run.solved_for(&problem).into_solution()))
            }
            Self::Path(run) => Answer::Path(Box::new(run.finish())),
        }
    }
}
