//! The work on a request: first the shape, then the path, which is not urgent.

use super::{Request, Shape, StartFrom, Update};
use crate::equilibrium::{Caution, Progress, Run, Settings, Start};
use crate::explore::PathRun;
use crate::forces::Sweep;

/// Iterations between two looks at whether a newer request has come: about
/// 0.1 ms for the paper's robot.
const SLICE: usize = 32;
/// States of a path: a pixel or two apart in a plot.
const STATES: usize = 201;

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
    /// The course and the span that the newest path belongs to …
    course: Option<(u64, (f64, f64))>,
    /// … and that path, as long as it is being followed.
    path: Option<PathRun>,
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
        let course = Some((request.course, request.span));
        if self.course != course {
            let (first, last) = request.span;
            let pulls = Sweep::pulls(first, last, STATES);
            self.path = Some(PathRun::new(&request.problem, pulls));
            self.course = course;
        }
        self.request = Some(request);
    }

    /// Works for a moment.
    pub fn work(&mut self) -> Work {
        match self.solve() {
            Work::Done => self.follow(),
            work => work,
        }
    }

    fn solve(&mut self) -> Work {
        let (Some(run), Some(request)) = (&mut self.run, &self.request) else {
            return Work::Done;
        };
        match run.advance(SLICE) {
            Progress::Running => Work::More,
            Progress::Done => {
                let solved = run.solved_for(&request.problem);
                let shape = Shape {
                    generation: request.generation,
                    placed: run.obstacles_are_placed(),
                    cautions: Caution::all(&solved),
                    solution: solved.into_solution(),
                };
                self.request = None;
                Work::Found(Update::Shape(Box::new(shape)))
            }
        }
    }

    fn follow(&mut self) -> Work {
        let (Some(mut run), Some((course, _))) = (self.path.take(), self.course) else {
            return Work::Done;
        };
        match run.advance(SLICE) {
            Progress::Running => {
                self.path = Some(run);
                Work::More
            }
            Progress::Done => Work::Found(Update::Path {
                course,
                path: Box::new(run.finish()),
            }),
        }
    }
}
