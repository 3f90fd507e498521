//! The pull that a load draws in, and the forces there: from a weight on the
//! cable to the robot's state, by multipliers.
//!
//! Loads count from contact, as the paper's P_l: the cable carries the tension
//! that it had when the robot began to press, and P_l more.

use super::statics::Statics;
use super::stiffness::Stiffness;
use super::sweep::SweepError;
use crate::equilibrium::{EndReason, Settings, Solved, Start, Status, solve};
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

/// A robot that is drawn in by weights, one load after the other.
#[derive(Clone, Debug)]
pub struct LoadSteps {
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

/// Steps of the pull, over the greatest cable offset: the runs' own.
const STEP: f64 = 1.0 / 16.0;
/// Pulls are found to this, over the backbone's length: 2 nm on the paper's
/// robot, where a tension of a hundred grams changes by less than 1e-4 g.
const GRAIN: f64 = 1e-11;

/// What hangs on the first cable: its tension, and with friction what is lost below.
fn tension(state: &Solved, per_bend: f64) -> f64 {
    per_bend * state.load()
}

fn presses(state: &Solved) -> bool {
    state.pressing().next().is_some()
}

/// The state a step on along the pull, or the last one before it with the
/// reason why there is none after that.
fn stepped(state: &Solved) -> (Solved, Option<SweepError>) {
    let problem = state.problem();
    let (_, most) = problem.pull_range();
    let pull = state.pull;
    if pull >= most {
        // All segments are alike.
        let (reason, segment) = (EndReason::LinkageLimit, 1);
        let status = Status::BranchEnded { reason, segment };
        return (state.clone(), Some(SweepError::NotReached { pull, status }));
    }
    let there = solved(
        state,
        (pull + STEP * problem.drive().pull_scale()).min(most),
    );
    let end = fault(&there);
    match end {
        Some(_) if !there.certificate.holds() => (state.clone(), end),
        _ => (there, end),
    }
}

/// The state at a pull near a known one, or the last one before it.
fn solved(near: &Solved, pull: f64) -> Solved {
    let mut problem = near.problem().clone();
    problem.set_pull(pull);
    solve(&problem, Start::From(near), Settings::default())
}

/// Why it is not the state that was asked for.
fn fault(state: &Solved) -> Option<SweepError> {
    let (pull, status) = (state.pull, state.status.clone());
    (status != Status::Converged).then_some(SweepError::NotReached { pull, status })
}

impl LoadSteps {
    /// The states under loads on the first cable, in N, at a stiffness: for each the
    /// first pull, from contact on, at which the cable's tension is the load's. A
    /// robot that meets nothing within a full turn is loaded from its straight shape
    /// on. What else is given, other cables' inputs and dead loads, acts from the
    /// start. Where its branch ends, the loads after that are left out.
    ///
    /// # Errors
    /// If the straight robot cannot be solved for.
    pub fn of(problem: &Problem, stiffness: Stiffness, loads: &[f64]) -> Result<Self, SweepError> {
        let per_bend = stiffness.per_bend(problem);
        let straight = straight(problem)?;
        let touching = first_contact(&straight);
        let contact = touching.as_ref().map(|state| state.pull);
        let mut here = touching.unwrap_or(straight);
        let datum = contact.map_or(0.0, |_| tension(&here, per_bend));
        let mut order: Vec<usize> = (0..loads.len()).collect();
        order.sort_by(|a, b| loads[*a].total_cmp(&loads[*b]));
        let mut waiting = order.into_iter().peekable();
        let mut found: Vec<(usize, Loaded)> = Vec::with_capacity(loads.len());
        let mut end = None;
        while let Some(&index) = waiting.peek() {
            let (next, ended) = stepped(&here);
            let reached = |state: &Solved| tension(state, per_bend) >= datum + loads[index];
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
                pull: there.pull,
                statics: Statics::of(&there, stiffness),
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

fn straight(problem: &Problem) -> Result<Solved, SweepError> {
    let mut problem = problem.clone();
    problem.set_pull(0.0);
    let state = solve(&problem, Start::Straight, Settings::default());
    fault(&state).map_or(Ok(state), Err)
}

/// Where the robot begins to press, within a full turn of its branch.
fn first_contact(straight: &Solved) -> Option<Solved> {
    let mut here = straight.clone();
    if presses(&here) {
        return Some(here);
    }
    let problem = straight.problem();
    let turn = TAU * problem.drive().pull_scale();
    while !problem.obstacles().is_empty() && here.pull < turn {
        let (next, ended) = stepped(&here);
        if presses(&next) {
            return Some(edge(&here, &next, presses));
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
fn edge(before: &Solved, after: &Solved, holds: impl Fn(&Solved) -> bool) -> Solved {
    let grain = GRAIN * before.problem().length();
    let (mut low, mut high) = (before.pull, after.pull);
    let mut found = after.clone();
    while high - low > grain {
        let middle = 0.5 * (low + high);
        let there = solved(before, middle);
        if fault(&there).is_none() && holds(&there) {
            (high, found) = (middle, there);
        } else {
            low = middle;
        }
    }
    found
}
