//! A course of one cable's pull or load from waypoint to waypoint, there and back: the
//! loop of load against pull, what work it took and what of that is stored.
//!
//! ```text
//! W = Σ ∫ P dl + ∫ F·dx     stored = U(end) − U(start)     lost = W − stored
//! ```
//!
//! over all cables, with P what hangs on each below the base, and over the dead loads.
//! U is the energy of the bent backbone and of stretched cables. The integral goes from
//! row to row by the trapezoidal rule, which errs by the square of a step. What is lost
//! went into friction, and into jumps.

use crate::equilibrium::{Run, Settings, Solved, Start, Status};
use crate::mechanics::{Input, Problem};

/// What is given along a course.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Given {
    /// The pull, in metres.
    Pull,
    /// The load, in newtons.
    Load,
}

impl Given {
    /// An input of this kind.
    pub fn input(self, value: f64) -> Input {
        match self {
            Given::Pull => Input::Pull(value),
            Given::Load => Input::Load(value),
        }
    }
}

/// A course of one cable.
#[derive(Clone, Debug, PartialEq)]
pub struct Course {
    /// The cable, from 0.
    pub cable: usize,
    /// What is given of it.
    pub given: Given,
    /// Its values in metres or newtons, the first where the course starts.
    pub waypoints: Vec<f64>,
    /// Equal steps from one to the next, at least 1.
    pub steps: usize,
}

/// A state of a course.
#[derive(Clone, Debug)]
pub struct Visit {
    /// Which leg led to it, from 1; 0 of the start.
    pub leg: usize,
    /// The state.
    pub solved: Solved,
}

/// What came of a course.
#[derive(Clone, Debug, Default)]
pub struct Cycle {
    /// The states, the start first.
    pub visits: Vec<Visit>,
    /// Why it went no further, where a leg ended.
    pub end: Option<Status>,
}

/// Work along a course, in rad², of which EI/2l_0 makes newton metres.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Work {
    /// ∮ P dl of the course's cable alone: where it comes back to its pull, the area of
    /// its loop.
    pub of_cable: f64,
    /// What cables and dead loads did on the robot.
    pub done: f64,
    /// What of that is stored at the end.
    pub stored: f64,
}

impl Work {
    /// What friction and jumps took.
    pub fn lost(&self) -> f64 {
        self.done - self.stored
    }
}

impl Cycle {
    /// Follows a course from the straight robot, after each state `each` of the share
    /// that is done.
    ///
    /// # Panics
    /// If the problem has no such cable: a bug of the caller.
    pub fn follow(problem: &Problem, course: &Course, mut each: impl FnMut(f64)) -> Self {
        let at = |value: f64| {
            let mut problem = problem.clone();
            let mut drive = problem.drive().clone();
            drive.cables[course.cable].input = course.given.input(value);
            problem.set_drive(&drive);
            problem
        };
        let mut cycle = Self::default();
        let Some(&first) = course.waypoints.first() else {
            return cycle;
        };
        let mut run = Run::new(&at(first), Start::Straight, Settings::default());
        if !cycle.visit(&mut run, 0) {
            return cycle;
        }
        let legs = course.waypoints.len() - 1;
        for (leg, ends) in course.waypoints.windows(2).enumerate() {
            for step in 1..=course.steps {
                let share = step as f64 / course.steps as f64;
                run.retarget(&at((1.0 - share) * ends[0] + share * ends[1]));
                if !cycle.visit(&mut run, leg + 1) {
                    return cycle;
                }
                each((leg as f64 + share) / legs as f64);
            }
        }
        cycle
    }

    fn visit(&mut self, run: &mut Run, leg: usize) -> bool {
        let status = run.finish().status.clone();
        if status != Status::Converged {
            self.end = Some(status);
            return false;
        }
        let solved = run.solved();
        self.visits.push(Visit { leg, solved });
        true
    }

    /// The work along it, for the cable of its course.
    pub fn work(&self, cable: usize) -> Work {
        let mut work = Work::default();
        for ends in self.visits.windows(2) {
            let (a, b) = (&ends[0].solved, &ends[1].solved);
            for (index, (here, there)) in a.cables.iter().zip(&b.cables).enumerate() {
                let step = 0.5 * (here.load + there.load) * (there.pull - here.pull);
                work.done += step;
                if index == cable {
                    work.of_cable += step;
                }
            }
            work.done += of_loads(a, b);
        }
        if let [first, .., last] = &self.visits[..] {
            work.stored = stored(&last.solved) - stored(&first.solved);
        }
        work
    }
}

/// EI/2l_0, in N m, or 1 where EI is not known and there are neither loads nor cables
/// that stretch.
fn per_bend(solved: &Solved) -> f64 {
    let stiffness = solved.drive.stiffness;
    stiffness.map_or(1.0, |ei| {
        ei / (2.0 * solved.problem().robot().segment_length())
    })
}

/// The energy of backbone and cables, in rad².
fn stored(solved: &Solved) -> f64 {
    let cables = solved.drive.cables.iter().enumerate();
    let stretched = cables.map(|(index, driven)| {
        let tensions = solved.tensions(index);
        let squares: f64 = tensions.iter().map(|tension| tension * tension).sum();
        0.5 * driven.cable.compliance * per_bend(solved) * squares / tensions.len() as f64
    });
    solved.energy + stretched.sum::<f64>()
}

/// What the dead loads, which do not change along a course, do from one state to another,
/// in rad².
fn of_loads(a: &Solved, b: &Solved) -> f64 {
    let loads = &a.drive.loads;
    if !loads.any() {
        return 0.0;
    }
    let robot = a.problem().robot();
    let moved = |node: usize| b.nodes[node].position - a.nodes[node].position;
    let last = a.nodes.len() - 1;
    let arc = loads.backbone / robot.segments as f64;
    let mut work = loads.tip_force.dot(&moved(last));
    work += loads.tip_moment * (a.tip().angle - b.tip().angle);
    for node in 1..=last {
        let share = if node == last { 0.5 } else { 1.0 };
        work += share * arc.dot(&moved(node));
        if robot.has_disk(node) {
            work += loads.disk.dot(&moved(node));
        }
    }
    work / per_bend(a)
}
