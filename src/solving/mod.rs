//! One executor for all that is solved beside the window: what is asked, what
//! is answered, and the work in between, in slices.
//!
//! Live work is what is asked while a scene is being changed. A [`Job`] takes
//! the newest [`Request`] in the place of older ones, even in the middle of
//! their solve, and keeps the last equilibrium, so that each request goes on
//! from the shape that the last one led to. A [`Task`] is done once, after those
//! before it, unless it is cancelled. The [`Executor`] goes on with tasks while
//! no live work is left. It knows no thread and no clock: whoever owns it calls
//! [`Executor::work`] until there is nothing left, and hands it each [`Order`]
//! as it comes.

mod executor;
mod job;
mod queue;
mod task;
#[cfg(feature = "wire")]
pub mod wire;

pub use executor::Executor;
pub use job::{Job, Work};
pub use queue::Queue;
pub use task::{Answer, Task, TaskId};

use crate::equilibrium::{Caution, Solution};
use crate::explore::Path;
use crate::mechanics::Problem;
use serde::{Deserialize, Serialize};

/// What is asked of an executor.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub enum Order {
    /// Live work, in the place of all before it.
    Live(Request),
    /// A task, after all before it.
    Task(TaskId, Task),
    /// That a task is done no more, begun or not.
    Cancel(TaskId),
}

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

/// What an order led to.
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
    /// How far a task is.
    Share {
        /// Which.
        task: TaskId,
        /// The share of it that is done, from 0 to 1.
        share: f64,
    },
    /// A task is done.
    Answer {
        /// Which.
        task: TaskId,
        /// What it has led to.
        answer: Box<Answer>,
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

#[cfg(test)]
pub(crate) mod tests {
    use super::*;
    use crate::equilibrium::{Settings, Start, solve};
    use crate::experiments::{Measured, MeasuredPoint};
    use crate::scene::Scene;

    pub fn scene() -> Scene {
        Scene::from_toml(include_str!("../../assets/scenes/one-disc.toml")).unwrap()
    }

    pub fn problem() -> Problem {
        Problem::new(&scene()).unwrap()
    }

    pub fn live(generation: u64, from: StartFrom) -> Order {
        Order::Live(Request {
            generation,
            course: 0,
            problem: problem(),
            from,
            span: (0.0, 0.012),
        })
    }

    /// The nodes of the robot at 3 mm of pull.
    pub fn measured() -> Measured {
        let mut problem = problem();
        problem.set_pull(0.003);
        let solution = solve(&problem, Start::Straight, Settings::default());
        let points = solution.backbone().enumerate();
        let points = points.map(|(node, position)| MeasuredPoint {
            row: node + 1,
            node: Some(node),
            position,
        });
        Measured::new(points.collect(), &problem).unwrap()
    }

    pub fn search() -> Task {
        Task::BestPull {
            problem: problem(),
            measured: measured(),
        }
    }
}
