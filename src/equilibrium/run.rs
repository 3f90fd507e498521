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
//! solve ends. Where this holds at no step size the branch has ended: if the
//! solve finds an equilibrium from there, the robot has jumped, and the run
//! goes on from it with an [`super::Event`]; if not, the run ends.

use super::approach;
use super::event::{Event, Occurrence};
use super::solution::Solution;
use super::status::{Conflict, EndReason, Status};
use crate::geometry::Obstacle;
use crate::model::{PlanarNode, Problem, RowKind};
use crate::solver::{
    Chain, Control, Outcome, Progress as SolveProgress, RowId, Settings as SolveSettings, Sqp,
    Tunnelling,
};

/// Limits of a run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Settings {
    /// Iterations of the whole run before it is given up.
    pub iterations: usize,
    /// Greatest change of the pull in a step, over the cable offset: 1/16 turns
    /// the free robot's tip by 3.6°, a tenth of a segment's usual reach.
    pub pull_step: f64,
    /// Greatest motion of an obstacle in a step, over the backbone's length.
    pub obstacle_step: f64,
}

impl Default for Settings {
    fn default() -> Self {
        Self {
            iterations: 50_000,
            pull_step: 1.0 / 16.0,
            obstacle_step: 1.0 / 40.0,
        }
    }
}

/// What a run starts from.
#[derive(Clone, Copy, Debug)]
pub enum Start<'a> {
    /// The straight robot without pull, with obstacles over it grown from
    /// nothing: the paper's way, and the definition of the physical answer.
    Straight,
    /// An earlier problem with its solution. One that is not an equilibrium
    /// costs time and leads to [`Occurrence::StartRefused`].
    From(&'a Problem, &'a Solution),
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
/// A step is refused where any segment turns by more than this, in radians.
const MOST_TURNED: f64 = 0.3;
/// Share of the predicted turn that the rest of the solve may add …
const UNPREDICTED: f64 = 0.4;
/// … and what it may add in any case, in radians.
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
    multipliers: Vec<(RowId, f64)>,
    nodes: Vec<PlanarNode>,
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
    /// Where the present leg starts and ends, and the problem in between that
    /// is being solved.
    from: Problem,
    to: Problem,
    now: Problem,
    /// The problem of the anchor, where obstacles move.
    here: Problem,
    goal: Problem,
    /// Whether obstacles move on the present leg.
    moving: bool,
    /// Whether the present leg ends at the goal.
    last_leg: bool,
    /// Share of the present leg done, and the next step's share.
    at: f64,
    step: f64,
    most_step: f64,
    least_step: f64,
    anchor: Anchor,
    /// Where the first iteration of the step's solve led, at full length.
    predicted: Vec<Control<1>>,
    started: Vec<Control<1>>,
    sqp: Sqp<Problem, 3, 1>,
    phase: Phase,
    iterations: usize,
    solution: Solution,
}

/// Solves a problem: a run from `start` to its end.
pub fn solve(problem: &Problem, start: Start<'_>, settings: Settings) -> Solution {
    let mut run = Run::new(problem, start, settings);
    run.finish();
    run.into_solution()
}

impl Run {
    /// A run to `problem`.
    pub fn new(problem: &Problem, start: Start<'_>, settings: Settings) -> Self {
        let mut run = Self {
            settings,
            from: problem.clone(),
            to: problem.clone(),
            now: problem.clone(),
            here: problem.clone(),
            goal: problem.clone(),
            moving: false,
            last_leg: true,
            at: 0.0,
            step: 0.0,
            most_step: 0.0,
            least_step: 0.0,
            anchor: Anchor::default(),
            predicted: Vec::new(),
            started: Vec::new(),
            sqp: Sqp::default(),
            phase: Phase::Between,
            iterations: 0,
            solution: Solution::default(),
        };
        match start {
            Start::Straight => run.start_straight(),
            Start::From(problem, solution) => run.start_from(problem, solution),
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
        self.goal.clone_from(problem);
        self.set_now(self.at);
        if self.now.resembles(problem) {
            self.from.clone_from(&self.now);
            self.to.clone_from(&self.goal);
            self.begin_leg(true);
        } else if self.now.robot() == problem.robot()
            && self.now.candidates() == problem.candidates()
        {
            let known = self.now.obstacles().to_vec();
            self.meet_obstacles(&known, self.now.pull());
        } else {
            self.start_straight();
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

    /// The result, without a copy.
    pub fn into_solution(self) -> Solution {
        self.solution
    }

    /// The problem that [`Run::solution`] is a solution of: the goal, or the
    /// last one on the way to it that has an equilibrium.
    pub fn problem(&self) -> &Problem {
        &self.now
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
        self.meet_obstacles(&[], 0.0);
    }

    fn start_from(&mut self, problem: &Problem, solution: &Solution) {
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
                && farthest(&controls, &self.sqp.point().controls) < UNNOTICED;
        }
        if accepted {
            self.from = problem.clone();
            self.to = problem.clone();
            self.now = problem.clone();
            self.take_anchor();
            let goal = self.goal.clone();
            self.retarget(&goal);
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
        self.phase = Phase::Direct;
    }

    /// Begins at the anchor, at a pull, with the goal's obstacles where they
    /// are `known` to be or, where none of the kind is known, grown from
    /// nothing if they overlap.
    fn meet_obstacles(&mut self, known: &[Obstacle], pull: f64) {
        let mut first = self.goal.clone();
        first.set_pull(pull);
        let mut overlapping = false;
        for (index, obstacle) in self.goal.obstacles().iter().enumerate() {
            let here = known.get(index).filter(|here| here.resembles(obstacle));
            if let Some(here) = here {
                first.set_obstacle(index, here.clone());
            } else if let Some(seed) = approach::seed(&self.goal, obstacle, &self.anchor.nodes) {
                overlapping = true;
                first.set_obstacle(index, seed.obstacle);
                let what = Occurrence::PushedAside {
                    obstacle: index,
                    direction: seed.direction,
                };
                self.solution.events.push(Event { pull, what });
            }
        }
        self.from = first;
        self.to.clone_from(&self.goal);
        if overlapping {
            self.to.set_pull(pull);
        }
        // Names of rows count the obstacles.
        self.anchor.multipliers.clear();
        self.begin_leg(!overlapping);
    }

    fn begin_leg(&mut self, last_leg: bool) {
        self.last_leg = last_leg;
        self.now.clone_from(&self.from);
        self.here.clone_from(&self.from);
        self.at = 0.0;
        let length = self.goal.length();
        let pull = (self.to.pull() - self.from.pull()).abs();
        let obstacles = self.from.obstacles().iter().zip(self.to.obstacles());
        let moved = obstacles.map(|(a, b)| a.change(b)).fold(0.0, f64::max);
        self.moving = moved > 0.0;
        let steps = (pull / (self.settings.pull_step * self.goal.robot().offset))
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

    /// The share of the leg that the next step leads to.
    fn target(&self) -> f64 {
        let target = self.at + self.step;
        // Rounding of repeated steps must not leave a last step of nothing.
        if target > 1.0 - 1e-9 { 1.0 } else { target }
    }

    fn begin_step(&mut self) {
        if self.iterations >= self.settings.iterations {
            self.end(Status::IterationLimit);
            return;
        }
        self.iterations += 1;
        self.set_now(self.target());
        if self.moving {
            // The obstacles move first, past the robot as it stands.
            self.here.set_between(&self.from, &self.to, self.at);
            let nodes = &self.anchor.nodes;
            if self.here.motion_passes(&self.now, nodes, nodes) {
                self.shorten(EndReason::Blocked);
                return;
            }
        }
        self.phase = Phase::Solving;
        let settings = SolveSettings {
            iterations: if self.step > self.least_step {
                STEP_ITERATIONS
            } else {
                LAST_ITERATIONS
            },
            ..SolveSettings::default()
        };
        self.started.clone_from(&self.anchor.controls);
        self.sqp
            .start(&self.now, &self.started, &self.anchor.multipliers, settings);
        self.predicted.clear();
    }

    fn iterate_step(&mut self) {
        let progress = self.sqp.step(&self.now);
        self.iterations += 1;
        if self.predicted.is_empty() {
            self.predicted.clone_from(&self.sqp.point().controls);
        }
        let SolveProgress::Done(outcome) = progress else {
            return;
        };
        let locked = self.locked_segment();
        let follows = self.follows();
        let last_try = self.step <= self.least_step;
        if outcome == Outcome::Converged && locked.is_none() && (follows || last_try) {
            self.accept(follows);
            return;
        }
        if !last_try {
            self.shorten(EndReason::Fold);
            return;
        }
        let status = match outcome {
            Outcome::Converged => self.end_of_branch(EndReason::LinkageLimit, locked),
            Outcome::Infeasible => Status::Infeasible {
                conflicts: self.conflicts(),
            },
            Outcome::Blocked => self.end_of_branch(EndReason::Blocked, locked),
            Outcome::Saddle | Outcome::Stalled => self.end_of_branch(EndReason::Fold, locked),
            Outcome::IterationLimit => Status::IterationLimit,
            Outcome::OutsideDomain => Status::NumericalFailure,
        };
        self.end(status);
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

    /// Whether the step's end is on the branch the anchor is on: its first
    /// iteration, the tangent, explains most of it.
    fn follows(&self) -> bool {
        let end = &self.sqp.point().controls;
        let turned = farthest(&self.started, end);
        let predicted = farthest(&self.started, &self.predicted);
        let rest = farthest(&self.predicted, end);
        turned <= MOST_TURNED && rest <= UNPREDICTED * predicted + UNNOTICED
    }

    fn shorten(&mut self, reason: EndReason) {
        self.phase = Phase::Between;
        if self.step <= self.least_step {
            let status = self.end_of_branch(reason, None);
            self.end(status);
        } else {
            self.step = (0.5 * self.step).max(self.least_step);
        }
    }

    /// Takes the step; one that does not follow the branch is a jump.
    fn accept(&mut self, follows: bool) {
        if !follows {
            let (node, distance) = self.farthest_node();
            self.note(Occurrence::Jump { node, distance });
        }
        self.note_contacts();
        let easy = self.sqp.trace().len() <= EASY + 1;
        self.take_anchor();
        self.at = self.target();
        if !follows || easy {
            self.step = (2.0 * self.step).min(self.most_step);
        }
        self.phase = Phase::Between;
        if self.at == 1.0 {
            if self.last_leg {
                self.keep_trace();
                self.fill(Status::Converged);
            } else {
                self.from.clone_from(&self.to);
                self.to.clone_from(&self.goal);
                self.begin_leg(true);
            }
        }
    }

    /// Ends short of the goal with the last equilibrium, and the trace of the
    /// solve that did not lead on.
    fn end(&mut self, status: Status) {
        if let Status::BranchEnded { reason, segment } = status {
            self.note(Occurrence::BranchEnded { reason, segment });
        }
        self.keep_trace();
        self.set_now(self.at);
        let (controls, multipliers) = (&self.anchor.controls, &self.anchor.multipliers);
        let settings = SolveSettings::default();
        self.sqp.start(&self.now, controls, multipliers, settings);
        self.fill(status);
    }

    fn keep_trace(&mut self) {
        self.solution.trace.clear();
        self.solution.trace.extend_from_slice(self.sqp.trace());
    }

    fn fill(&mut self, status: Status) {
        self.solution
            .fill(&self.now, self.sqp.point(), self.sqp.multipliers());
        let certified = self.solution.certificate.holds();
        self.solution.status = match status {
            Status::Converged if !certified => Status::NumericalFailure,
            status => status,
        };
        self.solution.iterations = self.iterations;
        self.phase = Phase::Done;
    }

    fn take_anchor(&mut self) {
        let point = self.sqp.point();
        self.anchor.controls.clone_from(&point.controls);
        self.anchor.nodes.clone_from(&point.nodes);
        self.anchor.multipliers.clear();
        let rows = point.rows.iter().zip(self.sqp.multipliers());
        let active = rows.filter(|(_, multiplier)| **multiplier > 0.0);
        self.anchor
            .multipliers
            .extend(active.map(|(row, multiplier)| (row.id, *multiplier)));
    }

    fn note(&mut self, what: Occurrence) {
        self.solution.events.push(Event {
            pull: self.now.pull(),
            what,
        });
    }

    /// Notes which contacts the step made and lost.
    fn note_contacts(&mut self) {
        let count = self.now.obstacles().len();
        let rows = self.sqp.point().rows.iter().zip(self.sqp.multipliers());
        let mut old = self.anchor.multipliers.iter().map(|(id, _)| *id).peekable();
        let pull = self.now.pull();
        let events = &mut self.solution.events;
        let candidates = self.now.candidates();
        let mut push = |id: RowId, made: bool| {
            if let RowKind::Contact {
                candidate,
                obstacle,
                ..
            } = RowKind::of(id, count)
            {
                let (line, node) = (candidates[candidate].line, candidates[candidate].node);
                let what = if made {
                    Occurrence::ContactMade {
                        line,
                        node,
                        obstacle,
                    }
                } else {
                    Occurrence::ContactLost {
                        line,
                        node,
                        obstacle,
                    }
                };
                events.push(Event { pull, what });
            }
        };
        for (row, multiplier) in rows {
            if *multiplier > 0.0 {
                while let Some(id) = old.next_if(|id| *id < row.id) {
                    push(id, false);
                }
                if old.next_if_eq(&row.id).is_none() {
                    push(row.id, true);
                }
            }
        }
        old.for_each(|id| push(id, false));
    }

    /// The node that the step moved farthest, and how far.
    fn farthest_node(&self) -> (usize, f64) {
        let pairs = self.anchor.nodes.iter().zip(&self.sqp.point().nodes);
        let distances = pairs.map(|(a, b)| (b.position - a.position).norm());
        distances.enumerate().fold(
            (0, 0.0),
            |most, next| if next.1 > most.1 { next } else { most },
        )
    }

    /// The rows whose multipliers are largest where the rows' violation is
    /// stationary: those within a thousandth of the bound.
    fn conflicts(&self) -> Vec<Conflict> {
        let count = self.now.obstacles().len();
        let multipliers = self.sqp.multipliers();
        let most = multipliers.iter().fold(0.0_f64, |a, b| a.max(*b));
        let rows = self.sqp.point().rows.iter().zip(multipliers);
        let mut conflicts: Vec<Conflict> = rows
            .filter(|(_, multiplier)| **multiplier > 1e-3 * most)
            .filter_map(|(row, _)| match RowKind::of(row.id, count) {
                RowKind::Contact {
                    candidate,
                    obstacle,
                    ..
                } => {
                    let candidate = &self.now.candidates()[candidate];
                    Some(Conflict {
                        line: candidate.line,
                        node: candidate.node,
                        obstacle,
                    })
                }
                RowKind::TurnLimit { .. } => None,
            })
            .collect();
        conflicts.dedup();
        conflicts
    }

    /// The segment that the solve left pressing against the limit of its
    /// linkage. Eq. 5 knows no such limit: a shape that needs it is none of
    /// its equilibria.
    fn locked_segment(&self) -> Option<usize> {
        let count = self.now.obstacles().len();
        let mut rows = self.sqp.point().rows.iter().zip(self.sqp.multipliers());
        rows.find_map(|(row, multiplier)| match RowKind::of(row.id, count) {
            RowKind::TurnLimit { segment, .. } if *multiplier > 0.0 => Some(segment),
            _ => None,
        })
    }

    /// The end of the branch at the anchor: where a segment locks, that is the
    /// reason.
    fn end_of_branch(&self, reason: EndReason, locked: Option<usize>) -> Status {
        let turns = self.anchor.controls.iter().map(|control| control[0].abs());
        let most = turns.enumerate().fold(
            (0, 0.0),
            |most, next| {
                if next.1 > most.1 { next } else { most }
            },
        );
        Status::BranchEnded {
            reason: locked.map_or(reason, |_| EndReason::LinkageLimit),
            segment: locked.unwrap_or(most.0 + 1),
        }
    }
}

/// The greatest difference between two sets of controls.
fn farthest(a: &[Control<1>], b: &[Control<1>]) -> f64 {
    a.iter()
        .zip(b)
        .map(|(a, b)| (a - b).amax())
        .fold(0.0, f64::max)
}
