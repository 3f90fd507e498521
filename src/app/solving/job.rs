//! The work of a background solver, in slices: first the shape, then the path.
//! Knows no thread; each backend calls [`Job::work`] until there is nothing
//! left or a newer request has come.

use super::{Request, Shape, StartFrom, Update};
use crate::equilibrium::{Progress, Run, Settings, Start};
use std::sync::Arc;
use web_time::Instant;

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
    seconds: f64,
}

impl Job {
    /// Takes a request in the place of the one it works on.
    pub fn take(&mut self, request: Request) {
        match &mut self.run {
            Some(run) if request.from == StartFrom::Shown => run.retarget(&request.problem),
            run => {
                let settings = Settings::default();
                *run = Some(Run::new(&request.problem, Start::Straight, settings));
            }
        }
        self.seconds = 0.0;
        self.request = Some(request);
    }

    /// Works for a moment.
    pub fn work(&mut self) -> Work {
        let (Some(run), Some(request)) = (&mut self.run, &self.request) else {
            return Work::Done;
        };
        let begin = Instant::now();
        let progress = run.advance(SLICE);
        self.seconds += begin.elapsed().as_secs_f64();
        match progress {
            Progress::Running => Work::More,
            Progress::Done => {
                let shape = Shape {
                    generation: request.generation,
                    problem: run.problem().clone(),
                    solution: run.solution().clone(),
                    placed: run.obstacles_are_placed(),
                    seconds: self.seconds,
                };
                self.request = None;
                Work::Found(Update::Shape(Arc::new(shape)))
            }
        }
    }
}
