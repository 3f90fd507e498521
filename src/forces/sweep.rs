//! A node's place and slope as functions of the pull (eq. 6), by continuation.

use crate::equilibrium::{Run, Settings, Start, Status};
use crate::mechanics::{FreeArc, Model, Problem};
use crate::units::millimetres;

/// A node of the robot at one pull.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SweepPoint {
    /// The pull, in metres.
    pub pull: f64,
    /// The x of the node's backbone point, in metres.
    pub x: f64,
    /// The same point's y, in metres.
    pub y: f64,
    /// φ, the direction of its disk, in radians, counterclockwise: it falls as
    /// the robot bends.
    pub angle: f64,
    /// dJ/dl, in rad²/m: the cable's tension without its stiffness.
    pub energy_slope: f64,
    /// Number of contacts that press.
    pub pressing: usize,
}

/// What a node does along the pull: eq. 6's x_e, y_e and θ_e.
#[derive(Clone, Debug, PartialEq)]
pub struct Sweep {
    /// The node, from 0 at the base.
    pub node: usize,
    /// By pull, in the order asked for.
    pub points: Vec<SweepPoint>,
}

/// Why there is no sweep.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum SweepError {
    /// The node is not one of the robot's that move.
    #[error(
        "node {node} does not move or is not there; the robot's nodes that move are 1 to {last}"
    )]
    NoSuchNode {
        /// The node asked for.
        node: usize,
        /// The tip.
        last: usize,
    },
    /// A pull is outside what the linkage allows.
    #[error(
        "a pull of {:.3} mm is outside what the segments allow, {:.2} to {:.2} mm",
        millimetres(*.pull),
        millimetres(*.least),
        millimetres(*.most)
    )]
    OutOfRange {
        /// The pull asked for, in metres.
        pull: f64,
        /// The least pull, in metres.
        least: f64,
        /// The greatest pull, in metres.
        most: f64,
    },
    /// The robot does not get to a pull.
    #[error(
        "the sweep stops at a pull of {:.3} mm: {}",
        millimetres(*.pull),
        .status.reason()
    )]
    NotReached {
        /// The last good pull, in metres.
        pull: f64,
        /// How the run ended.
        status: Status,
    },
}

impl Sweep {
    /// The node's path of a problem over these pulls, in metres, each solved
    /// from the one before and the first from the straight robot.
    ///
    /// # Errors
    /// For a node that is not there, a pull that no linkage can take, or one
    /// that the robot does not get to.
    pub fn of(problem: &Problem, node: usize, pulls: &[f64]) -> Result<Self, SweepError> {
        let last = problem.robot().segments;
        if node == 0 || node > last {
            return Err(SweepError::NoSuchNode { node, last });
        }
        let (least, most) = problem.pull_range();
        let mut target = problem.clone();
        let mut run: Option<Run> = None;
        let mut points = Vec::with_capacity(pulls.len());
        for &pull in pulls {
            if !(least..=most).contains(&pull) {
                return Err(SweepError::OutOfRange { pull, least, most });
            }
            target.set_pull(pull);
            let run = match &mut run {
                Some(run) => {
                    run.retarget(&target);
                    run
                }
                none => none.insert(Run::new(&target, Start::Straight, Settings::default())),
            };
            let solution = run.finish();
            if solution.status != Status::Converged {
                return Err(SweepError::NotReached {
                    pull: solution.pull,
                    status: solution.status.clone(),
                });
            }
            let there = solution.nodes[node];
            points.push(SweepPoint {
                pull,
                x: there.position.x,
                y: there.position.y,
                angle: there.angle,
                energy_slope: solution.energy_slope(),
                pressing: solution.pressing().count(),
            });
        }
        Ok(Self { node, points })
    }

    /// The path of the tip without obstacles over these pulls, in metres, those
    /// outside the range moved to its ends. In the paper's model it is an arc at
    /// every pull, so that nothing is solved. A sliding robot that does not get to a
    /// pull stays where it got to.
    pub fn free(problem: &Problem, pulls: &[f64]) -> Self {
        let (least, most) = problem.pull_range();
        let pulls = pulls.iter().map(|pull| pull.clamp(least, most));
        let points = match problem.model() {
            Model::Equal => pulls.map(|pull| free_arc(problem, pull)).collect(),
            Model::Sliding => free_sliding(problem, pulls),
        };
        Self {
            points,
            node: problem.robot().segments,
        }
    }

    /// `count` pulls from `first` to `last`, both included and in metres; at least
    /// two.
    pub fn pulls(first: f64, last: f64, count: usize) -> Vec<f64> {
        let steps = count.max(2) - 1;
        (0..=steps)
            .map(|k| first + (last - first) * k as f64 / steps as f64)
            .collect()
    }
}

fn free_arc(problem: &Problem, pull: f64) -> SweepPoint {
    let robot = problem.robot();
    let FreeArc { bend, tip } = robot.free_arc(pull);
    SweepPoint {
        pull,
        x: tip.position.x,
        y: tip.position.y,
        angle: tip.angle,
        // J = n β² with sin(β/2) = l/(2an).
        energy_slope: 2.0 * bend / (robot.offset * libm::cos(0.5 * bend)),
        pressing: 0,
    }
}

fn free_sliding(problem: &Problem, pulls: impl Iterator<Item = f64>) -> Vec<SweepPoint> {
    let mut free = problem.without_obstacles();
    free.set_pull(0.0);
    let mut run = Run::new(&free, Start::Straight, Settings::default());
    run.finish();
    let points = pulls.map(|pull| {
        free.set_pull(pull);
        run.retarget(&free);
        let solution = run.finish();
        let tip = solution.tip();
        SweepPoint {
            pull,
            x: tip.position.x,
            y: tip.position.y,
            angle: tip.angle,
            energy_slope: solution.energy_slope(),
            pressing: 0,
        }
    });
    points.collect()
}
