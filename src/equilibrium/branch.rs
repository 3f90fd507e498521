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
mod friction;
mod history;
mod meet;
mod settings;
mod step;

pub use settings::Settings;

use super::event::{Event, Occurrence};
use super::run::{Progress, Start};
use super::solution::Solution;
use super::status::{EndReason, Status};
use crate::contact::RowKind;
use crate::geometry::Vector;
use crate::mechanics::{Drive, Input, Mechanics, Problem, Rubbing};
use crate::solver::{
    Control, Outcome, Progress as SolveProgress, RowId, Settings as SolveSettings, Sqp, Tunnelling,
};
use follow::farthest;
use frame::at_base;
use friction::with_tensions;
use meet::reordered;

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
#[derive(Clone, Debug)]
struct Anchor<M: Mechanics<NU>, const NU: usize> {
    controls: Vec<Control<NU>>,
    nodes: Vec<M::Node>,
    rows: Rows,
    /// What friction keeps of it.
    rubbing: Rubbing,
}

impl<M: Mechanics<NU>, const NU: usize> Default for Anchor<M, NU> {
    fn default() -> Self {
        Self {
            controls: Vec::new(),
            nodes: Vec::new(),
            rows: Rows::default(),
            rubbing: Rubbing::default(),
        }
    }
}

/// The rows of a shape on the branch, by id.
#[derive(Clone, Debug, Default)]
struct Rows {
    /// λ of those that press.
    multipliers: Vec<(RowId, f64)>,
    /// Clearances of all that are near.
    clearances: Vec<(RowId, f64)>,
}

/// What the next call of [`Branch::advance`] does.
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

/// A run with one mechanics. See [`super::Run`], which is one of any.
#[derive(Clone, Debug)]
pub(super) struct Branch<M: Mechanics<NU>, const NU: usize> {
    settings: Settings,
    /// The base's place in the world. Every problem and shape below is relative
    /// to it, so that a robot far from the world's origin keeps its digits; only
    /// the solution is in the world.
    origin: Vector,
    /// `now` in the world, where that is not the same.
    world: Option<Problem>,
    /// Where the present leg starts and ends, and the problem in between that
    /// is being solved.
    from: M,
    to: M,
    now: M,
    /// The problem of the anchor, or one near the step's end to look back from.
    here: M,
    goal: M,
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
    anchor: Anchor<M, NU>,
    /// The rows of the shape before the anchor on the same leg, and the share
    /// of the leg at which it stood.
    before: Rows,
    before_at: Option<f64>,
    /// Where the first iteration of the step's solve led, at full length.
    predicted: Vec<Control<NU>>,
    started: Vec<Control<NU>>,
    sqp: Sqp<M, 3, NU>,
    /// The solve that looks back from a step's end, and what presses there.
    back: Sqp<M, 3, NU>,
    pressing: Vec<(RowId, f64)>,
    phase: Phase,
    iterations: usize,
    certifier: M::Certifier,
    solution: Solution,
}

impl<M: Mechanics<NU>, const NU: usize> Branch<M, NU> {
    /// A run to `problem`.
    pub fn new(problem: &Problem, start: Start<'_>, settings: Settings) -> Self {
        let origin = problem.robot().base.position;
        let elsewhere = origin != Vector::zeros();
        let world = elsewhere.then(|| problem.clone());
        let problem = M::new(at_base(problem).into_owned());
        let mut run = Self {
            settings,
            origin,
            world,
            from: problem.clone(),
            to: problem.clone(),
            now: problem.clone(),
            here: problem.clone(),
            goal: problem,
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
            certifier: M::Certifier::default(),
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
    pub(super) fn retarget(&mut self, problem: &Problem) {
        self.solution.events.clear();
        self.iterations = 0;
        if self.anchor.controls.is_empty() {
            *self = Self::new(problem, Start::Straight, self.settings);
            return;
        }
        let origin = std::mem::replace(&mut self.origin, problem.robot().base.position);
        self.go_to(&at_base(problem), origin);
    }

    /// Changes the goal to a problem relative to its base. `from` is where the
    /// base of the present problem is in the world.
    fn go_to(&mut self, problem: &Problem, from: Vector) {
        self.goal.change(|goal| goal.clone_from(problem));
        self.set_now(self.at);
        let same_robot = from == self.origin
            && self.now.robot() == problem.robot()
            && self.now.same_candidates(problem)
            && self.now.drive().same_cables(problem.drive());
        if same_robot && !self.now.drive().resembles(problem.drive()) {
            self.adopt_inputs();
        }
        self.show_world();
        if !same_robot {
            self.start_straight();
        } else if self.now.resembles(problem) && !reordered(&self.now, problem) {
            self.from.clone_from(&self.now);
            self.to.clone_from(&self.goal);
            self.grown_first = false;
            self.begin_leg(true);
        } else {
            let known = self.now.obstacles().to_vec();
            let drive = self.now.drive().clone();
            self.meet_obstacles(&known, &drive);
        }
    }

    pub(super) fn settings(&self) -> Settings {
        self.settings
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

    /// The result of a run that is done. Before, its status is
    /// [`Status::Unfinished`].
    pub fn solution(&self) -> &Solution {
        &self.solution
    }

    /// The result, without a copy.
    pub fn into_solution(self) -> Solution {
        self.solution
    }

    /// The problem that [`Branch::solution`] is a solution of: the goal, or the
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

    /// The share of the way that what drives the robot has gone, at a share of the
    /// present leg.
    fn drive_share(&self, at: f64) -> f64 {
        if self.last_leg { at } else { 0.0 }
    }

    /// The share that it has gone by now, from 0 to 1.
    pub fn driven_share(&self) -> f64 {
        self.drive_share(self.at)
    }

    /// What drives the robot at a share of its way.
    pub fn drive_at(&self, share: f64) -> Drive {
        let mut drive = self.to.drive().clone();
        drive.set_between(self.from.drive(), self.to.drive(), share);
        drive
    }

    /// Whether the obstacles are where the goal has them. They are not while
    /// those over the robot still grow, nor before the end of a drag.
    pub fn obstacles_are_placed(&self) -> bool {
        !self.moving || self.at == 1.0
    }

    fn start_straight(&mut self) {
        let mut here = self.goal.clone();
        let slack = self.goal.drive().slackened();
        here.change(|problem| problem.set_drive(&slack));
        self.anchor.controls = here.free_controls();
        self.anchor.nodes.clear();
        self.anchor.nodes.push(here.base());
        for k in 1..=here.stages() {
            let (node, ..) = here.stage(k, &self.anchor.nodes[k - 1], &Control::zeros());
            self.anchor.nodes.push(node);
        }
        self.anchor.rows = Rows::default();
        self.anchor.rubbing = Rubbing::default();
        self.solution.set_nodes(M::shape(&self.anchor.nodes));
        self.solution.move_by(self.origin);
        self.meet_obstacles(&[], &slack);
    }

    fn start_from(&mut self, problem: &Problem, solution: &Solution) {
        let origin = problem.robot().base.position;
        let mut problem = M::new(at_base(problem).into_owned());
        let mut accepted = false;
        if let Some(controls) = problem.read_controls(&solution.turns) {
            let settings = SolveSettings {
                iterations: 10,
                ..SolveSettings::default()
            };
            let multipliers = solution.row_multipliers(&problem, problem.cost_unit());
            self.sqp.start(&problem, &controls, &multipliers, settings);
            if problem.rubs() {
                let rubbing = solution.rubbing(&problem);
                let obstacles = problem.obstacles().to_vec();
                problem.freeze(&obstacles, &self.sqp.point().nodes, &rubbing);
                let multipliers = with_tensions(&problem, &multipliers);
                self.sqp.start(&problem, &controls, &multipliers, settings);
            }
            let outcome = self.sqp.run(&problem);
            accepted = outcome == Outcome::Converged
                && farthest(&controls, &self.sqp.point().controls)
                    < UNNOTICED * problem.control_scale();
        }
        if accepted {
            self.from = problem.clone();
            self.to = problem.clone();
            self.now = problem;
            self.take_anchor();
            self.anchor.rubbing = solution.rubbing(&self.now);
            self.solution.events.clear();
            self.iterations = 0;
            let goal = Problem::clone(&self.goal);
            self.go_to(&goal, origin);
        } else {
            self.solution.events.push(Event {
                pull: self.goal.pull(),
                share: 0.0,
                load: self.goal.drive().load(),
                what: Occurrence::StartRefused,
            });
            self.start_straight();
        }
    }

    /// Goes straight to the goal. With friction the answer depends on the way, and
    /// there is none but that of [`Branch::start_straight`].
    fn start_direct(&mut self) {
        if self.now.rubs() {
            self.start_straight();
            return;
        }
        let settings = SolveSettings {
            iterations: LAST_ITERATIONS,
            tunnelling: Tunnelling::Allowed,
            ..SolveSettings::default()
        };
        self.started = self.now.free_controls();
        self.sqp.start(&self.now, &self.started, &[], settings);
        self.solution.set_nodes(M::shape(&self.sqp.point().nodes));
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
        let (from, to) = (self.from.drive(), self.to.drive());
        let pull = from.change(to, self.goal.robot());
        let obstacles = self.from.obstacles().iter().zip(self.to.obstacles());
        let moved = obstacles.map(|(a, b)| a.change(b)).fold(0.0, f64::max);
        self.moving = moved > 0.0;
        let steps = (pull / (self.settings.pull_step * self.goal.drive().pull_scale()))
            .max(moved / (self.settings.obstacle_step * length));
        self.most_step = 1.0 / steps.max(1.0);
        self.step = self.most_step;
        self.least_step = LEAST_STEP * length / pull.max(moved).max(LEAST_STEP * length);
        // A goal that is where the run already stands is solved once all the
        // same: its answer is certified like any other.
        self.phase = Phase::Between;
        self.solution.status = Status::Unfinished;
    }

    /// Makes `here` the problem of the anchor.
    fn show_anchor(&mut self) {
        let (from, to, at) = (&self.from, &self.to, self.at);
        self.here.change(|here| here.set_between(from, to, at));
    }

    fn set_now(&mut self, at: f64) {
        let (from, to) = (&self.from, &self.to);
        self.now.change(|now| now.set_between(from, to, at));
    }

    /// Turns what drives the present problem into inputs of the goal's kinds, with the
    /// values that hold its shape: a load is the tension that a pull led to, and the
    /// other way round.
    fn adopt_inputs(&mut self) {
        let (controls, multipliers) = (&self.anchor.controls, &self.anchor.rows.multipliers);
        let settings = SolveSettings::default();
        self.sqp.start(&self.now, controls, multipliers, settings);
        let mut cables = Vec::new();
        let found = self.sqp.multipliers();
        self.now.write_cables(self.sqp.point(), found, &mut cables);
        let drive = self.goal.drive().at(&cables, self.now.robot());
        let (unit, count) = (self.now.cost_unit(), self.now.obstacles().len());
        let rows = &mut self.anchor.rows.multipliers;
        rows.retain(|(id, _)| !matches!(RowKind::of(*id, count), RowKind::Cable { .. }));
        for (cable, (driven, state)) in drive.cables.iter().zip(&cables).enumerate() {
            if let (Input::Pull(_), true) = (driven.input, state.tension > 0.0) {
                let id = RowKind::Cable { cable, stretch: 1 }.id(count);
                rows.push((id, state.tension / unit));
            }
        }
        self.now.change(|now| now.set_drive(&drive));
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
        multipliers.extend(pressing(&self.sqp));
        let (point, multipliers) = (self.sqp.point(), self.sqp.multipliers());
        let rubbing = &mut self.anchor.rubbing;
        self.now.write_rubbing(point, multipliers, rubbing);
    }
}

/// The rows that press at the point of a solve, with their multipliers.
fn pressing<M: Mechanics<NU>, const NU: usize>(
    sqp: &Sqp<M, 3, NU>,
) -> impl Iterator<Item = (RowId, f64)> + '_ {
    let multipliers = sqp.multipliers().iter().enumerate();
    multipliers
        .filter(|(_, multiplier)| **multiplier > 0.0)
        .map(|(row, multiplier)| (sqp.point().row_id(row), *multiplier))
}
