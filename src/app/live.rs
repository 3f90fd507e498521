//! The live solution: what was asked of the solver, what it has answered, and
//! the drawing of it.

use super::backend::SolverBackend;
use crate::equilibrium::{Solution, Status};
use crate::model::Problem;
use crate::solving::{Request, Shape, StartFrom, Update};
use crate::view::{Drawing, Notes, draw};
use web_time::Duration;

/// The solver and the last of its answers.
pub struct Live {
    backend: Box<dyn SolverBackend>,
    /// Requests made.
    generation: u64,
    asked: Problem,
    shape: Option<Shape>,
    /// How long the last answer took.
    time: Duration,
    drawing: Drawing,
    /// Counts the changes of the drawing.
    revision: u64,
}

impl Live {
    /// Asks for the shape of a problem, from the straight robot.
    pub fn new(backend: Box<dyn SolverBackend>, problem: &Problem, notes: &Notes) -> Self {
        let mut live = Self {
            backend,
            generation: 0,
            asked: problem.clone(),
            shape: None,
            time: Duration::ZERO,
            drawing: draw(problem, &Solution::default(), notes),
            revision: 0,
        };
        live.ask(problem, StartFrom::Straight);
        live
    }

    /// Asks for a shape, in the place of whatever is being solved.
    pub fn ask(&mut self, problem: &Problem, from: StartFrom) {
        self.generation += 1;
        self.asked.clone_from(problem);
        self.backend.submit(Request {
            generation: self.generation,
            problem: problem.clone(),
            from,
        });
    }

    /// Takes what the solver has found. Whether there was anything.
    pub fn poll(&mut self) -> bool {
        let mut news = false;
        while let Some(found) = self.backend.poll() {
            match found.update {
                Update::Shape(shape) => {
                    // An answer to an older request shows less than what is
                    // known already.
                    let newest = self.shape.as_ref().map_or(0, |known| known.generation);
                    if shape.generation > newest {
                        self.shape = Some(shape);
                        self.time = found.time;
                        news = true;
                    }
                }
            }
        }
        news
    }

    /// Draws the scene as it is asked for, with the robot as it is known.
    pub fn redraw(&mut self, notes: &Notes) {
        let nothing = Solution::default();
        let solution = self.solution().unwrap_or(&nothing);
        self.drawing = draw(&self.asked, solution, notes);
        self.revision += 1;
    }

    /// The problem last asked for.
    pub fn problem(&self) -> &Problem {
        &self.asked
    }

    /// The last answer.
    pub fn shape(&self) -> Option<&Shape> {
        self.shape.as_ref()
    }

    /// How long the last answer took.
    pub fn time(&self) -> Duration {
        self.time
    }

    /// The last answer's solution.
    pub fn solution(&self) -> Option<&Solution> {
        self.shape.as_ref().map(|shape| &shape.solution)
    }

    /// Whether what is shown is the certified answer to what was last asked.
    pub fn is_settled(&self) -> bool {
        self.shape.as_ref().is_some_and(|shape| {
            shape.generation == self.generation
                && shape.solution.status == Status::Converged
                && shape.solution.certificate.holds()
        })
    }

    /// Whether the solver is at work.
    pub fn is_busy(&self) -> bool {
        self.backend.is_busy()
    }

    /// The picture of all this.
    pub fn drawing(&self) -> &Drawing {
        &self.drawing
    }

    /// Counts the changes of [`Live::drawing`].
    pub fn revision(&self) -> u64 {
        self.revision
    }
}
