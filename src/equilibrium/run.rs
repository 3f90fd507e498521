//! From a known equilibrium to a goal, along the branch a robot would follow.
//!
//! The paper increases the cable's contraction in small steps; so does a run,
//! and obstacle motion is treated the same way. A run goes from one problem to
//! another in steps of a share t of the way; each step's solve starts from the
//! last equilibrium and may not pass through an obstacle. This *defines* the
//! answer among the many local minima of eq. 5.
//!
//! Differs from a tangent predictor: the first quadratic subproblem at the new
//! problem is itself the tangent step, and also predicts which contacts come
//! and go. A step is halved unless that prediction explains most of where its
//! solve ends and the tangent there points back to where it started. Where this
//! holds at no step size the branch has ended: if the solve finds an
//! equilibrium from there, the robot has jumped, and the run goes on from it
//! with an [`super::Event`]; if not, the run ends.

mod ending;
mod follow;
mod frame;
mod history;
mod meet;
mod settings;
mod step;

pub use settings::Settings;

use super::event::{Event, Occurrence};
use super::solution::Solution;
use super::solved::Solved;
use super::status::{EndReason, Status};
use crate::geometry::Vector;
use crate::mechanics::Problem;
use crate::robot::PlanarNode;
use crate::solver::{
    Chain, Control, Outcome, Progress as SolveProgress, RowId, Settings as SolveSettings, Sqp,
    Tunnelling,
};
use follow::farthest;
use frame::at_base;
use meet::reordered;

/// What a run starts from.
#[derive(Clone, Copy, Debug)]
pub enum Start<'a> {
    /// The straight robot without pull, with obstacles over it grown from
    /// nothing: the paper's way, and the definition of the physical answer.
    Straight,
    /// An earlier solution. One that is not an equilibrium costs time and leads
    /// to [`Occurrence::StartRefused`].
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

/// Steps below this share of the backbone's length, of pull or of obstacle
/// motion, are not halved any more: the branch ends there.
const LEAST_STEP: f64 = 1e-5;
/// Where the change of the pull alone would carry a part through an obstacle,
/// before the solve that brings it back begins, a step is halved down to this
/// share of the least one: a pull of 1e-5 of the length moves a slender robot's
/// tip by thirty times as much, and a needle is thinner than that near its tip.
const NARROWEST: f64 = 1.0 / 64.0;
/// Change of a control that is not noticed, over what its mechanics calls a large
/// one.
const UNNOTICED: f64 = 2e-3;
/// Iterations a step's solve may take before the step is halved: one that
/// follows the branch takes three to eight.
const STEP_ITERATIONS: usize = 25;
/// Iterations of a solve that cannot be halved any more, and of a direct one.
const LAST_ITERATIONS: usize = 400;
/// A step that needed at most this many iterations is followed by a longer one.
const EASY: usize = 4;

/// A shape on the branch, in the solver's terms.
#[derive(Clone, Debug, Default)]
struct Anchor {
    controls: Vec<Control<1>>,
    nodes: Vec<PlanarNode>,
    rows: Rows,
}

/// The rows of a shape on the branch, by id.
#[derive(Clone, Debug, Default)]
struct Rows {
    /// λ of those that press.
    multipliers: Vec<(RowId, f64)>,
    /// Clearances of all that are near.
    clearances: Vec<(RowId, f64)>,
}

/// What the next call of [`Run::advance`] does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Phase {
    /// Choose a step.
    Between,
    /// Iterate the step's solve.
    Solving,
    /// Iterate the one solve of [`Start::Direct`].
    Direct,
    /// Nothing.
    Done,
}

/// A run, advanced in slices. Dropping it cancels it; [`Run::retarget`]
/// changes its goal and keeps its last equilibrium.
#[derive(Clone, Debug)]
pub struct Run {
    settings: Settings,
    /// The base's place in the world. Every problem and shape below is relative
    /// to it, so that a robot far from the world's origin keeps its digits; only
    /// the solution is in the world.
    origin: Vector,
    /// `now` in the world, where that is not the same.
    world: Option<Problem>,
    /// Where the present leg starts and ends, and the problem in between that
    /// is being solved.
    from: Problem,
    to: Problem,
    now: Problem,
    /// The problem of the anchor, or one near the step's end to look back from.
    here: Problem,
    goal: Problem,
    /// Whether obstacles move on the present leg.
    moving: bool,
    /// Whether the run began by growing obstacles.
    grown_first: bool,
    /// Whether the present leg ends at the goal.
    last_leg: bool,
    /// Share of the present leg done, and the next step's share.
    at: f64,
    step: f64,
    most_step: f64,
    least_step: f64,
    anchor: Anchor,
    /// The rows of the shape before the anchor on the same leg, and the share
    /// of the leg at which it stood.
    before: Rows,
    before_at: Option<f64>,
    /// Where the first iteration of the step's solve led, at full length.
    predicted: Vec<Control<1>>,
    started: Vec<Control<1>>,
    sqp: Sqp<Problem, 3, 1>,
    /// The solve that looks back from a step's end, and what presses there.
    back: Sqp<Problem, 3, 1>,
    pressing: Vec<(RowId, f64)>,
    phase: Phase,
    iterations: usize,
    solution: Solution,
}

/// Solves a problem: a run from `start` to its end.
pub fn solve(problem: &Problem, start: Start<'_>, settings: Settings) -> Solved {
    let mut run = Run::new(problem, start, settings);
    run.finish();
    let of = run.solved_problem(problem);
    Solved::own(of, run.solution)
}

impl Run {
    /// A run to `problem`.
    pub fn new(problem: &Problem, start: Start<'_>, settings: Settings) -> Self {
        let origin = problem.base().position;
        let elsewhere = origin != Vector::zeros();
        let world = elsewhere.then(|| problem.clone());
        let problem = &*at_base(problem);
        let mut run = Self {
            settings,
            origin,
            world,
            from: problem.clone(),
            to: problem.clone(),
            now: problem.clone(),
            here: problem.clone(),
            goal: problem.clone(),
            moving: false,
            grown_first: false,
            last_leg: true,
            at: 0.0,
            step: 0.0,
            most_step: 0.0,
            least_step: 0.0,
            anchor: Anchor::default(),
            before: Rows::default(),
            before_at: None,
            predicted: Vec::new(),
            started: Vec::new(),
            sqp: Sqp::default(),
            back: Sqp::default(),
            pressing: Vec::new(),
            phase: Phase::Between,
            iterations: 0,
            solution: Solution::default(),
        };
        match start {
            Start::Straight => run.start_straight(),
            Start::From(known) => run.start_from(known.problem(), known.solution()),
            Start::Direct => run.start_direct(),
        }
        run
    }

    /// Changes the goal. The run goes on from its last equilibrium, whether it
    /// was done or not, and forgets its events.
    pub fn retarget(&mut self, problem: &Problem) {
        self.solution.events.clear();
        self.iterations = 0;
        if self.anchor.controls.is_empty() {
            *self = Self::new(problem, Start::Straight, self.settings);
            return;
        }
        let origin = std::mem::replace(&mut self.origin, problem.base().position);
        self.go_to(&at_base(problem), origin);
    }

    /// Changes the goal to a problem relative to its base. `from` is where the
    /// base of the present problem is in the world.
    fn go_to(&mut self, problem: &Problem, from: Vector) {
        self.goal.clone_from(problem);
        self.set_now(self.at);
        self.show_world();
        let same_robot = from == self.origin
            && self.now.robot() == problem.robot()
            && self.now.same_candidates(problem);
        if !same_robot {
            self.start_straight();
        } else if self.now.resembles(problem) && !reordered(&self.now, problem) {
            self.from.clone_from(&self.now);
            self.to.clone_from(&self.goal);
            self.grown_first = false;
            self.begin_leg(true);
        } else {
            let known = self.now.obstacles().to_vec();
            self.meet_obstacles(&known, self.now.pull());
        }
    }

    /// Steps at most `iterations` iterations.
    pub fn advance(&mut self, iterations: usize) -> Progress {
        for _ in 0..iterations {
            match self.phase {
                Phase::Between => self.begin_step(),
                Phase::Solving => self.iterate_step(),
                Phase::Direct => self.iterate_direct(),
                Phase::Done => return Progress::Done,
            }
        }
        match self.phase {
            Phase::Done => Progress::Done,
            _ => Progress::Running,
        }
    }

    /// Runs to the end.
    pub fn finish(&mut self) -> &Solution {
        while self.advance(1024) == Progress::Running {}
        &self.solution
    }

    /// The result of a run that is done. Before, its status is
    /// [`Status::Unfinished`].
    pub fn solution(&self) -> &Solution {
        &self.solution
    }

    /// The result with the problem that it is one of: [`Run::problem`].
    pub fn solved(&self) -> Solved {
        Solved::own(self.problem().clone(), self.solution.clone())
    }

    /// The result with the problem that it is one of: the goal, as it was given,
    /// where the obstacles have come to their places. Unlike [`Run::problem`]
    /// it has what the run does not follow, changes of what cannot touch.
    pub fn solved_for(&self, goal: &Problem) -> Solved {
        Solved::own(self.solved_problem(goal), self.solution.clone())
    }

    fn solved_problem(&self, goal: &Problem) -> Problem {
        let placed = self.obstacles_are_placed();
        let mut of = if placed { goal } else { self.problem() }.clone();
        of.set_pull(self.solution.pull);
        of
    }

    /// The problem that [`Run::solution`] is a solution of: the goal, or the
    /// last one on the way to it that has an equilibrium.
    pub fn problem(&self) -> &Problem {
        self.world.as_ref().unwrap_or(&self.now)
    }

    /// How far the run has got, from 0 to 1. Growing obstacles that overlap the
    /// robot counts as the first half.
    pub fn share(&self) -> f64 {
        let legs = if self.grown_first { 2.0 } else { 1.0 };
        let before = if self.grown_first && self.last_leg {
            1.0
        } else {
            0.0
        };
        (before + self.at) / legs
    }

    /// Whether the obstacles are where the goal has them. They are not while
    /// those over the robot still grow, nor before the end of a drag.
    pub fn obstacles_are_placed(&self) -> bool {
        !self.moving || self.at == 1.0
    }

    fn start_straight(&mut self) {
        let mut here = self.goal.clone();
        here.set_pull(0.0);
        self.anchor.controls = here.free_controls();
        self.anchor.nodes.clear();
        self.anchor.nodes.push(here.base());
        for k in 1..=here.stages() {
            let (node, ..) = here.stage(k, &self.anchor.nodes[k - 1], &Control::zeros());
            self.anchor.nodes.push(node);
        }
        self.anchor.rows = Rows::default();
        self.solution.nodes.clone_from(&self.anchor.nodes);
        self.solution.move_by(self.origin);
        self.meet_obstacles(&[], 0.0);
    }

    fn start_from(&mut self, problem: &Problem, solution: &Solution) {
        let origin = problem.base().position;
        let problem = &*at_base(problem);
        let turns = solution.turns.iter();
        let controls: Vec<Control<1>> = turns.map(|turn| Control::from_element(*turn)).collect();
        let fits = controls.len() == problem.stages() && controls.iter().all(|u| u[0].is_finite());
        let mut accepted = false;
        if fits {
            let settings = SolveSettings {
                iterations: 10,
                ..SolveSettings::default()
            };
            let multipliers = solution.row_multipliers(problem);
            self.sqp.start(problem, &controls, &multipliers, settings);
            let outcome = self.sqp.run(problem);
            accepted = outcome == Outcome::Converged
                && farthest(&controls, &self.sqp.point().controls)
                    < UNNOTICED * problem.control_scale();
        }
        if accepted {
            self.from = problem.clone();
            self.to = problem.clone();
            self.now = problem.clone();
            self.take_anchor();
            self.solution.events.clear();
            self.iterations = 0;
            let goal = self.goal.clone();
            self.go_to(&goal, origin);
        } else {
            self.solution.events.push(Event {
                pull: self.goal.pull(),
                what: Occurrence::StartRefused,
            });
            self.start_straight();
        }
    }

    fn start_direct(&mut self) {
        let settings = SolveSettings {
            iterations: LAST_ITERATIONS,
            tunnelling: Tunnelling::Allowed,
            ..SolveSettings::default()
        };
        self.started.clear();
        self.started.resize(self.now.stages(), Control::zeros());
        self.sqp.start(&self.now, &self.started, &[], settings);
        self.solution.nodes.clone_from(&self.sqp.point().nodes);
        self.solution.move_by(self.origin);
        self.phase = Phase::Direct;
    }

    fn begin_leg(&mut self, last_leg: bool) {
        self.last_leg = last_leg;
        self.now.clone_from(&self.from);
        self.here.clone_from(&self.from);
        self.at = 0.0;
        self.before_at = None;
        let length = self.goal.length();
        let pull = (self.to.pull() - self.from.pull()).abs();
        let obstacles = self.from.obstacles().iter().zip(self.to.obstacles());
        let moved = obstacles.map(|(a, b)| a.change(b)).fold(0.0, f64::max);
        self.moving = moved > 0.0;
        let steps = (pull / (self.settings.pull_step * self.goal.pull_scale()))
            .max(moved / (self.settings.obstacle_step * length));
        self.most_step = 1.0 / steps.max(1.0);
        self.step = self.most_step;
        self.least_step = LEAST_STEP * length / pull.max(moved).max(LEAST_STEP * length);
        // A goal that is where the run already stands is solved once all the
        // same: its answer is certified like any other.
        self.phase = Phase::Between;
        self.solution.status = Status::Unfinished;
    }

    fn set_now(&mut self, at: f64) {
        self.now.set_between(&self.from, &self.to, at);
    }

    fn iterate_direct(&mut self) {
        let progress = self.sqp.step(&self.now);
        self.iterations += 1;
        if let SolveProgress::Done(outcome) = progress {
            self.take_anchor();
            self.keep_trace();
            let locked = self.locked_segment();
            let status = match outcome {
                Outcome::Converged if locked.is_some() => {
                    self.end_of_branch(EndReason::LinkageLimit, locked)
                }
                Outcome::Converged => Status::Converged,
                Outcome::Infeasible => Status::Infeasible {
                    conflicts: self.conflicts(),
                },
                Outcome::IterationLimit => Status::IterationLimit,
                Outcome::Saddle => self.end_of_branch(EndReason::Fold, locked),
                Outcome::Stalled | Outcome::Blocked | Outcome::OutsideDomain => {
                    Status::NumericalFailure
                }
            };
            self.fill(status);
        }
    }

    fn take_anchor(&mut self) {
        let point = self.sqp.point();
        self.anchor.controls.clone_from(&point.controls);
        self.anchor.nodes.clone_from(&point.nodes);
        let Rows {
            multipliers,
            clearances,
        } = &mut self.anchor.rows;
        multipliers.clear();
        clearances.clear();
        clearances.extend(point.rows.iter().map(|row| (row.id, row.value)));
        let rows = point.rows.iter().zip(self.sqp.multipliers());
        let active = rows.filter(|(_, multiplier)| **multiplier > 0.0);
        multipliers.extend(active.map(|(row, multiplier)| (row.id, *multiplier)));
    }
}
