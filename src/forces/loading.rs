//! The pull that a load draws in, and the forces there: from a weight on the
//! cable to the robot's state, by multipliers.
//!
//! Loads count from contact, as the paper's P_l: the cable carries the tension
//! that it had when the robot began to press, and P_l more.

use super::statics::Statics;
use super::stiffness::Stiffness;
use super::sweep::SweepError;
use crate::contact::Class;
use crate::equilibrium::{EndReason, Settings, Solution, Start, Status, solve};
use crate::mechanics::Problem;
use std::f64::consts::TAU;

/// A robot under a load.
#[derive(Clone, Debug)]
pub struct Loaded {
    /// P_l, counted from contact, in N.
    pub load: f64,
    /// The pull that the load draws in, in metres.
    pub pull: f64,
    /// The forces there.
    pub statics: Statics,
}

/// A robot that is drawn in by weights.
#[derive(Clone, Debug)]
pub struct Loading {
    /// The pull at which the robot begins to press, in metres; `None` where it
    /// presses on nothing before the loads are reached.
    pub contact: Option<f64>,
    /// The cable's tension there, which loads are counted from, in N; 0 without
    /// contact.
    pub datum: f64,
    /// The loads that are reached, in the order asked for.
    pub states: Vec<Loaded>,
    /// Why the others are not: where the robot's branch ends.
    pub end: Option<SweepError>,
}

/// Steps of the pull, over the cable offset: the runs' own.
const STEP: f64 = 1.0 / 16.0;
/// Pulls are found to this, over the backbone's length: 2 nm on the paper's
/// robot, where a tension of a hundred grams changes by less than 1e-4 g.
const GRAIN: f64 = 1e-11;

/// A pull that was solved for.
#[derive(Clone)]
struct State {
    problem: Problem,
    solution: Solution,
}

impl State {
    fn tension(&self, per_bend: f64) -> f64 {
        per_bend * self.solution.energy_slope()
    }

    fn presses(&self) -> bool {
        let contacts = &self.solution.contacts;
        contacts.iter().any(|c| c.class == Class::Pressing)
    }

    /// The state a step on along the pull, or the last one before it with the
    /// reason why there is none after that.
    fn stepped(&self) -> (State, Option<SweepError>) {
        let robot = self.problem.robot();
        let (_, most) = robot.pull_range();
        let pull = self.solution.pull;
        if pull >= most {
            // All segments are alike.
            let (reason, segment) = (EndReason::LinkageLimit, 1);
            let status = Status::BranchEnded { reason, segment };
            return (self.clone(), Some(SweepError::NotReached { pull, status }));
        }
        let there = self.solved((pull + STEP * robot.offset).min(most));
        let end = there.fault();
        match end {
            Some(_) if !there.solution.certificate.holds() => (self.clone(), end),
            _ => (there, end),
        }
    }

    /// The state at a pull near this one, or the last one before it.
    fn solved(&self, pull: f64) -> State {
        let mut problem = self.problem.clone();
        problem.set_pull(pull);
        let start = Start::From(&self.problem, &self.solution);
        let solution = solve(&problem, start, Settings::default());
        problem.set_pull(solution.pull);
        State { problem, solution }
    }

    /// Why it is not the state that was asked for.
    fn fault(&self) -> Option<SweepError> {
        let (pull, status) = (self.solution.pull, self.solution.status.clone());
        (status != Status::Converged).then_some(SweepError::NotReached { pull, status })
    }
}

impl Loading {
    /// The states under loads, in N, at a stiffness: for each the first pull,
    /// from contact on, at which the cable's tension is the load's. A robot that
    /// meets nothing within a full turn is loaded from its straight shape on.
    /// Where its branch ends, the loads after that are left out.
    ///
    /// # Errors
    /// If the straight robot cannot be solved for.
    pub fn of(problem: &Problem, stiffness: Stiffness, loads: &[f64]) -> Result<Self, SweepError> {
        let per_bend = stiffness.per_bend(problem);
        let straight = straight(problem)?;
        let touching = first_contact(&straight);
        let contact = touching.as_ref().map(|state| state.solution.pull);
        let mut here = touching.unwrap_or(straight);
        let datum = contact.map_or(0.0, |_| here.tension(per_bend));
        let mut order: Vec<usize> = (0..loads.len()).collect();
        order.sort_by(|a, b| loads[*a].total_cmp(&loads[*b]));
        let mut waiting = order.into_iter().peekable();
        let mut found: Vec<(usize, Loaded)> = Vec::with_capacity(loads.len());
        let mut end = None;
        while let Some(&index) = waiting.peek() {
            let (next, ended) = here.stepped();
            let reached = |state: &State| state.tension(per_bend) >= datum + loads[index];
            if !reached(&next) {
                if ended.is_some() {
                    end = ended;
                    break;
                }
                here = next;
                continue;
            }
            // Two loads may lie in one step, so `here` stays.
            let there = edge(&here, &next, reached);
            let loaded = Loaded {
                load: loads[index],
                pull: there.solution.pull,
                statics: Statics::of(&there.problem, &there.solution, stiffness),
            };
            found.push((index, loaded));
            waiting.next();
        }
        found.sort_by_key(|(index, _)| *index);
        Ok(Self {
            contact,
            datum,
            states: found.into_iter().map(|(_, loaded)| loaded).collect(),
            end,
        })
    }
}

fn straight(problem: &Problem) -> Result<State, SweepError> {
    let mut problem = problem.clone();
    problem.set_pull(0.0);
    let solution = solve(&problem, Start::Straight, Settings::default());
    let state = State { problem, solution };
    state.fault().map_or(Ok(state), Err)
}

/// Where the robot begins to press, within a full turn of its branch.
fn first_contact(straight: &State) -> Option<State> {
    let mut here = straight.clone();
    if here.presses() {
        return Some(here);
    }
    let problem = &straight.problem;
    let turn = TAU * problem.robot().offset;
    while !problem.obstacles().is_empty() && here.solution.pull < turn {
        let (next, ended) = here.stepped();
        if next.presses() {
            return Some(edge(&here, &next, State::presses));
        }
        if ended.is_some() {
            break;
        }
        here = next;
    }
    None
}

/// The first state, between one where something does not hold and one where it
/// does, at which it does, by bisection.
fn edge(before: &State, after: &State, holds: impl Fn(&State) -> bool) -> State {
    let grain = GRAIN * before.problem.length();
    let (mut low, mut high) = (before.solution.pull, after.solution.pull);
    let mut found = after.clone();
    while high - low > grain {
        let middle = 0.5 * (low + high);
        let there = before.solved(middle);
        if there.fault().is_none() && holds(&there) {
            (high, found) = (middle, there);
        } else {
            low = middle;
        }
    }
    found
}
