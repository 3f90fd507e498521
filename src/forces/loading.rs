//! The pull that a load draws in, and the forces there: from a weight on the
//! cable to the robot's state, by multipliers.
//!
//! Loads count from contact, as the paper's P_l: the cable carries the tension
//! that it had when the robot began to press, and P_l more.

use super::statics::Statics;
use super::stiffness::Stiffness;
use super::sweep::SweepError;
use crate::equilibrium::{Class, Settings, Solution, Start, Status, solve};
use crate::model::Problem;
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
    /// By load, as asked for.
    pub states: Vec<Loaded>,
}

/// Steps of the pull, over the cable offset: the runs' own.
const STEP: f64 = 1.0 / 16.0;
/// Pulls are found to this, over the backbone's length: 2 nm on the paper's
/// robot, where a tension of a hundred grams changes by less than 1e-4 g.
const GRAIN: f64 = 1e-11;

/// A pull that was solved for.
struct State {
    problem: Problem,
    solution: Solution,
}

impl State {
    fn tension(&self, per_bend: f64) -> f64 {
        per_bend * self.solution.certificate.energy_slope
    }

    fn presses(&self) -> bool {
        let contacts = &self.solution.contacts;
        contacts.iter().any(|c| c.class == Class::Pressing)
    }

    /// How far a step along the pull leads.
    fn step(&self) -> f64 {
        STEP * self.problem.robot().offset
    }

    /// The state a step on.
    fn stepped(&self) -> Result<State, SweepError> {
        let pull = self.solution.pull + self.step();
        let (least, most) = self.problem.robot().pull_range();
        if pull > most {
            return Err(SweepError::OutOfRange { pull, least, most });
        }
        self.at(pull)
    }

    /// The state at a pull near this one.
    fn at(&self, pull: f64) -> Result<State, SweepError> {
        let mut problem = self.problem.clone();
        problem.set_pull(pull);
        let start = Start::From(&self.problem, &self.solution);
        let solution = solve(&problem, start, Settings::default());
        converged(solution).map(|solution| State { problem, solution })
    }
}

fn converged(solution: Solution) -> Result<Solution, SweepError> {
    match solution.status {
        Status::Converged => Ok(solution),
        status => Err(SweepError::NotReached {
            pull: solution.pull,
            status,
        }),
    }
}

impl Loading {
    /// The states under loads, in N, at a stiffness: for each the first pull,
    /// from contact on, at which the cable's tension is the load's. A robot that
    /// meets nothing within a full turn is loaded from its straight shape on.
    ///
    /// # Errors
    /// If the robot does not get to a load: its branch ends before.
    pub fn of(problem: &Problem, stiffness: Stiffness, loads: &[f64]) -> Result<Self, SweepError> {
        let per_bend = stiffness.per_bend(problem);
        let touching = first_contact(problem)?;
        let contact = touching.as_ref().map(|state| state.solution.pull);
        let mut here = match touching {
            Some(state) => state,
            None => straight(problem)?,
        };
        let datum = contact.map_or(0.0, |_| here.tension(per_bend));
        let mut order: Vec<usize> = (0..loads.len()).collect();
        order.sort_by(|a, b| loads[*a].total_cmp(&loads[*b]));
        let mut waiting = order.into_iter().peekable();
        let mut found: Vec<(usize, Loaded)> = Vec::with_capacity(loads.len());
        while let Some(&index) = waiting.peek() {
            let next = here.stepped()?;
            let reached = |state: &State| state.tension(per_bend) >= datum + loads[index];
            if !reached(&next) {
                here = next;
                continue;
            }
            // Two loads may lie in one step, so `here` stays.
            let there = edge(&here, &next, reached)?;
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
        })
    }
}

fn straight(problem: &Problem) -> Result<State, SweepError> {
    let mut problem = problem.clone();
    problem.set_pull(0.0);
    let solution = solve(&problem, Start::Straight, Settings::default());
    converged(solution).map(|solution| State { problem, solution })
}

/// Where the robot begins to press, within a full turn.
fn first_contact(problem: &Problem) -> Result<Option<State>, SweepError> {
    let mut here = straight(problem)?;
    if here.presses() {
        return Ok(Some(here));
    }
    if problem.obstacles().is_empty() {
        return Ok(None);
    }
    let (_, most) = problem.robot().pull_range();
    let turn = TAU * problem.robot().offset;
    while here.solution.pull < (most - here.step()).min(turn) {
        let next = here.stepped()?;
        if next.presses() {
            return edge(&here, &next, State::presses).map(Some);
        }
        here = next;
    }
    Ok(None)
}

/// The first state, between one where something does not hold and one where it
/// does, at which it does, by bisection.
fn edge(
    before: &State,
    after: &State,
    holds: impl Fn(&State) -> bool,
) -> Result<State, SweepError> {
    let grain = GRAIN * before.problem.length();
    let (mut low, mut high) = (before.solution.pull, after.solution.pull);
    let mut found = after.at(high)?;
    while high - low > grain {
        let middle = 0.5 * (low + high);
        let there = before.at(middle)?;
        if holds(&there) {
            (high, found) = (middle, there);
        } else {
            low = middle;
        }
    }
    Ok(found)
}
