//! From a known equilibrium to a goal, for a robot of any mechanics.

use super::branch::{Branch, Settings};
use super::solution::Solution;
use super::solved::Solved;
use super::status::Status;
use crate::mechanics::{Drive, Equal, Model, Problem, Sliding};

/// What a run starts from.
#[derive(Clone, Copy, Debug)]
pub enum Start<'a> {
    /// The straight robot without pull, with obstacles over it grown from
    /// nothing: the paper's way, and the definition of the physical answer.
    Straight,
    /// An earlier solution. One that is not an equilibrium costs time and leads
    /// to [`super::Occurrence::StartRefused`].
    From(&'a Solved),
    /// One solve at the goal from the free shape, with no care for the way:
    /// quick, but where obstacles interfere perhaps on another branch.
    Direct,
}

/// What [`Run::advance`] led to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Progress {
    /// Not done: call again.
    Running,
    /// Done: see [`Run::solution`].
    Done,
}

/// A run, advanced in slices. Dropping it cancels it; [`Run::retarget`]
/// changes its goal and keeps its last equilibrium.
///
/// The solver is compiled for up to two arcs a bay of the sliding cable and for up to
/// eight: every size takes 30 kB of the page, twice over. One arc by itself would be
/// quicker for robots that have no more, whose second control stays at 0.
#[derive(Clone, Debug)]
pub struct Run(Mechanics);

#[derive(Clone, Debug)]
enum Mechanics {
    Equal(Box<Branch<Equal, 1>>),
    SlidingBy2(Box<Branch<Sliding<2>, 2>>),
    SlidingBy8(Box<Branch<Sliding<8>, 8>>),
}

/// What a run of any mechanics does, said once.
macro_rules! each {
    ($run:expr, $branch:ident => $what:expr) => {
        match $run {
            Mechanics::Equal($branch) => $what,
            Mechanics::SlidingBy2($branch) => $what,
            Mechanics::SlidingBy8($branch) => $what,
        }
    };
}

/// Solves a problem: a run from `start` to its end.
pub fn solve(problem: &Problem, start: Start<'_>, settings: Settings) -> Solved {
    let mut run = Run::new(problem, start, settings);
    run.finish();
    let of = run.solved_problem(problem);
    Solved::own(of, each!(run.0, run => run.into_solution()))
}

impl Run {
    /// A run to `problem`.
    pub fn new(problem: &Problem, start: Start<'_>, settings: Settings) -> Self {
        let start = match start {
            Start::From(from) if kind(from.problem()) != kind(problem) => Start::Straight,
            start => start,
        };
        Self(match kind(problem) {
            Kind::Equal => Mechanics::Equal(Box::new(Branch::new(problem, start, settings))),
            Kind::Sliding(2) => {
                Mechanics::SlidingBy2(Box::new(Branch::new(problem, start, settings)))
            }
            Kind::Sliding(_) => {
                Mechanics::SlidingBy8(Box::new(Branch::new(problem, start, settings)))
            }
        })
    }

    /// Changes the goal. The run goes on from its last equilibrium, whether it
    /// was done or not, and forgets its events. To a robot of another mechanics it
    /// starts from the straight one.
    pub fn retarget(&mut self, problem: &Problem) {
        if kind(self.problem()) == kind(problem) {
            each!(&mut self.0, run => run.retarget(problem));
        } else {
            let settings = each!(&self.0, run => run.settings());
            *self = Self::new(problem, Start::Straight, settings);
        }
    }

    /// Steps at most `iterations` iterations.
    pub fn advance(&mut self, iterations: usize) -> Progress {
        each!(&mut self.0, run => run.advance(iterations))
    }

    /// Runs to the end.
    pub fn finish(&mut self) -> &Solution {
        while self.advance(1024) == Progress::Running {}
        self.solution()
    }

    /// The result of a run that is done. Before, its status is
    /// [`super::Status::Unfinished`].
    pub fn solution(&self) -> &Solution {
        each!(&self.0, run => run.solution())
    }

    /// The result with the problem that it is one of: [`Run::problem`].
    pub fn solved(&self) -> Solved {
        Solved::own(self.problem().clone(), self.solution().clone())
    }

    /// The result with the problem that it is one of: the goal, as it was given,
    /// where the obstacles have come to their places. Unlike [`Run::problem`]
    /// it has what the run does not follow, changes of what cannot touch.
    pub fn solved_for(&self, goal: &Problem) -> Solved {
        Solved::own(self.solved_problem(goal), self.solution().clone())
    }

    fn solved_problem(&self, goal: &Problem) -> Problem {
        let placed = self.obstacles_are_placed();
        let mut of = if placed { goal } else { self.problem() }.clone();
        of.set_drive(&self.solution().drive);
        of
    }

    /// The problem that [`Run::solution`] is a solution of: the goal, or the
    /// last one on the way to it that has an equilibrium.
    pub fn problem(&self) -> &Problem {
        each!(&self.0, run => run.problem())
    }

    /// How far the run has got, from 0 to 1. Growing obstacles that overlap the
    /// robot counts as the first half.
    pub fn share(&self) -> f64 {
        each!(&self.0, run => run.share())
    }

    /// The share of the way from what drove the robot at first, nothing where it was
    /// straight, to what the goal asks for, that the solution has reached: 1 at the
    /// goal.
    pub fn driven_share(&self) -> f64 {
        match self.solution().status {
            Status::Converged => 1.0,
            _ => each!(&self.0, run => run.driven_share()),
        }
    }

    /// What is given of the cables at a share of that way: every input and load in
    /// proportion.
    pub fn drive_at(&self, share: f64) -> Drive {
        each!(&self.0, run => run.drive_at(share))
    }

    /// Whether the obstacles are where the goal has them. They are not while
    /// those over the robot still grow, nor before the end of a drag.
    pub fn obstacles_are_placed(&self) -> bool {
        each!(&self.0, run => run.obstacles_are_placed())
    }
}

/// For which mechanics a run is compiled, and for how many arcs a bay.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    Equal,
    Sliding(usize),
}

fn kind(problem: &Problem) -> Kind {
    match problem.model() {
        Model::Equal => Kind::Equal,
        Model::Sliding => match problem.robot().segments_per_bay {
            1 | 2 => Kind::Sliding(2),
            _ => Kind::Sliding(8),
        },
    }
}
