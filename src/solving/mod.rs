//! Live solving: what is asked while a scene is being changed, what is
//! answered, and the work in between, in slices.
//!
//! A [`Job`] takes the newest [`Request`] in the place of older ones, even in
//! the middle of their solve, and keeps the last equilibrium, so that each
//! request goes on from the shape that the last one led to. It knows no thread
//! and no clock: whoever owns it calls [`Job::work`] until there is nothing
//! left or a newer request has come.

mod job;
#[cfg(feature = "wire")]
pub mod wire;

pub use job::{Job, Work};

use crate::equilibrium::{Caution, Solution};
use crate::explore::Path;
use crate::mechanics::Problem;
use serde::{Deserialize, Serialize};

/// What to solve.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Request {
    /// Counts the requests; a later one replaces all before it.
    pub generation: u64,
    /// Counts what paths belong to: later requests with the same number differ
    /// in their pulls only, and share a path where they share the span.
    pub course: u64,
    /// The robot, its obstacles and its pull.
    pub problem: Problem,
    /// What the solve starts from.
    pub from: StartFrom,
    /// The pulls that the path is to cover, least and greatest, in metres.
    pub span: (f64, f64),
}

/// What a solve starts from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum StartFrom {
    /// The shape that the last request led to: the branch is kept.
    Last,
    /// The straight robot: the paper's continuation.
    Straight,
}

/// What a request led to.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub enum Update {
    /// The robot's shape; soon after the request.
    Shape(Box<Shape>),
    /// What the robot does along its pull; when there is nothing more urgent,
    /// and once for all requests that share it.
    Path {
        /// The course of the requests that it belongs to.
        course: u64,
        /// From the straight robot over the request's span.
        path: Box<Path>,
    },
}

/// A solved shape.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Shape {
    /// The request it answers.
    pub generation: u64,
    /// The solution: of the problem asked for, or of the last one on the way
    /// to it that has an equilibrium.
    pub solution: Solution,
    /// Whether the obstacles are where the request has them.
    pub placed: bool,
    /// What the solution does not promise.
    pub cautions: Vec<Caution>,
}
