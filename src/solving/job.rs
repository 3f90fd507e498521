//! The work on a request: first the shape, then what is less urgent.

use super::{Request, Shape, StartFrom, Update};
use crate::equilibrium::{Progress, Run, Settings, Start};

/// Iterations between two looks at whether a newer request has come: about
/// 0.1 ms for the paper's robot.
const SLICE: usize = 32;

/// What a slice of work led to.
#[derive(Debug)]
pub enum Work {
    /// Nothing yet: call again.
    More,
    /// A result; call again for the next.
    Found(Update),
    /// Nothing is left to do.
    Done,
}

/// Solves requests, each from where the one before it ended.
#[derive(Debug, Default)]
pub struct Job {
    run: Option<Run>,
    /// The request whose shape is being solved.
    request: Option<Request>,
}

impl Job {
    /// Takes a request in the place of the one it works on.
    pub fn take(&mut self, request: Request) {
        match &mut self.run {
            Some(run) if request.from == StartFrom::Last => run.retarget(&request.problem),
            run => {
                let settings = Settings::default();
                *run = Some(Run::new(&request.problem, Start::Straight, settings));
            }
        }
        self.request = Some(request);
    }

    /// Works for a moment.
    pub fn work(&mut self) -> Work {
        let (Some(run), Some(request)) = (&mut self.run, &self.request) else {
            return Work::Done;
        };
        match run.advance(SLICE) {
            Progress::Running => Work::More,
            Progress::Done => {
                let shape = Shape {
                    generation: request.generation,
                    solution: run.solution().clone(),
                    placed: run.obstacles_are_placed(),
                };
                self.request = None;
                Work::Found(Update::Shape(shape))
            }
        }
    }
}
