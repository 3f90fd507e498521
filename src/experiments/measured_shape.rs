//! A measured backbone against computed ones: the paper's measure of accuracy.
//!
//! Points are in the scene's frame, base to tip. A point that names its node is
//! compared with that node, as the paper does; one that does not is compared
//! with the nearest point of the computed backbone.

use crate::equilibrium::{Run, Settings, Solution, Start, Status, solve};
use crate::geometry::Vector;
use crate::model::Problem;
use crate::scene::Measurements;
use crate::scene::limits::LEAST_MEASURED_POINTS;
use crate::units::{metres, millimetres};
use std::f64::consts::TAU;

/// A measured point of the backbone.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MeasuredPoint {
    /// Its line in the file, from 1, for messages.
    pub row: usize,
    /// Its node, from 0 at the base, where it is known.
    pub node: Option<usize>,
    /// Its place, in metres.
    pub position: Vector,
}

/// A measured backbone that can be compared with a robot.
#[derive(Clone, Debug, PartialEq)]
pub struct Measured {
    points: Vec<MeasuredPoint>,
}

/// What is wrong with measured points.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum MeasuredFault {
    /// No points.
    #[error("there are no measured points; give at least {least}, base to tip", least = Measured::LEAST_POINTS)]
    Empty,
    /// Too few points.
    #[error(
        "there is only {0} of the at least {least} measured points that a comparison needs; add some",
        least = Measured::LEAST_POINTS
    )]
    TooFew(usize),
    /// A coordinate is not finite.
    #[error("row {row}: a coordinate is not a finite number")]
    NotFinite {
        /// The row.
        row: usize,
    },
    /// A point that was there before.
    #[error("row {row} is the same point as row {earlier}; leave one of them out")]
    Duplicate {
        /// The row.
        row: usize,
        /// The row it repeats.
        earlier: usize,
    },
    /// A node that was there before, or one out of order.
    #[error(
        "row {row}: node {node} does not come after the one before; order rows from base to tip"
    )]
    NodesUnsorted {
        /// The row.
        row: usize,
        /// Its node.
        node: usize,
    },
    /// A node the robot does not have.
    #[error("row {row}: there is no node {node}; this robot's are 0 to {last}")]
    NoSuchNode {
        /// The row.
        row: usize,
        /// Its node.
        node: usize,
        /// The tip.
        last: usize,
    },
    /// Some rows name nodes and some do not.
    #[error("row {row} names no node, though others do; name all or none")]
    NodeMissing {
        /// The row.
        row: usize,
    },
    /// The points turn back.
    #[error("row {row} turns back along the robot; order rows from base to tip")]
    Unsorted {
        /// The row.
        row: usize,
    },
    /// A point that the robot cannot reach.
    #[error(
        "row {row} is {:.1} mm from the base, and the robot is {:.1} mm long; check its unit (mm) and \
         its origin (the scene's)",
        millimetres(*.distance),
        millimetres(*.length)
    )]
    FarOff {
        /// The row.
        row: usize,
        /// Its distance from the base, in metres.
        distance: f64,
        /// The robot's length, in metres.
        length: f64,
    },
}

/// A computed shape's distances from a measured one.
#[derive(Clone, Debug, PartialEq)]
pub struct ShapeFit {
    /// The pull of the computed shape, in metres.
    pub pull: f64,
    /// The root of the mean squared distance, in metres: the paper's measure.
    pub rms: f64,
    /// The greatest distance, in metres.
    pub max: f64,
    /// The row of the greatest distance.
    pub max_row: usize,
    /// By measured point, in metres.
    pub distances: Vec<f64>,
}

/// Why there is no best pull.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum ShapeError {
    /// The robot does not even get away from its start.
    #[error("no pull of this robot can be solved for: {}", .0.reason())]
    NotReached(Status),
}

/// How much farther than the robot is long a point may be: errors of measuring
/// a stretched robot, not of units.
const REACH: f64 = 1.1;
/// Points nearer to each other than this, over the length, are one.
const SAME: f64 = 1e-9;
/// Steps of the search over the pull, over the cable offset: the runs' own.
const STEP: f64 = 1.0 / 16.0;
/// The best pull is found to this, over the length: 0.2 µm on the paper's robot.
const GRAIN: f64 = 1e-9;

impl Measured {
    /// The fewest points that are compared, those of a scene's check: two may
    /// be a point on the way and the tip.
    pub const LEAST_POINTS: usize = LEAST_MEASURED_POINTS;

    /// Measured points, checked against the robot that they belong to.
    ///
    /// # Errors
    /// The first fault found, in the order of the rows.
    pub fn new(points: Vec<MeasuredPoint>, problem: &Problem) -> Result<Self, MeasuredFault> {
        let robot = problem.robot();
        let (length, base) = (robot.length, robot.base.position);
        if points.is_empty() {
            return Err(MeasuredFault::Empty);
        }
        let named = points.iter().any(|p| p.node.is_some());
        for (index, point) in points.iter().enumerate() {
            let row = point.row;
            if !(point.position.x.is_finite() && point.position.y.is_finite()) {
                return Err(MeasuredFault::NotFinite { row });
            }
            let distance = (point.position - base).norm();
            if distance > REACH * length {
                return Err(MeasuredFault::FarOff {
                    row,
                    distance,
                    length,
                });
            }
            let earlier = &points[..index];
            let same = |p: &&MeasuredPoint| (p.position - point.position).norm() <= SAME * length;
            if let Some(earlier) = earlier.iter().find(same) {
                let earlier = earlier.row;
                return Err(MeasuredFault::Duplicate { row, earlier });
            }
            match point.node {
                Some(node) if node > robot.segments => {
                    let last = robot.segments;
                    return Err(MeasuredFault::NoSuchNode { row, node, last });
                }
                Some(node) if earlier.last().is_some_and(|p| p.node >= Some(node)) => {
                    return Err(MeasuredFault::NodesUnsorted { row, node });
                }
                None if named => return Err(MeasuredFault::NodeMissing { row }),
                _ => {}
            }
            if let [.., a, b] = earlier
                && (b.position - a.position).dot(&(point.position - b.position)) < 0.0
            {
                return Err(MeasuredFault::Unsorted { row });
            }
        }
        if points.len() < Self::LEAST_POINTS {
            return Err(MeasuredFault::TooFew(points.len()));
        }
        // Two points cannot turn back; the first may yet be the tip.
        let reach = |p: &MeasuredPoint| (p.position - base).norm();
        let (first, last) = (&points[0], &points[points.len() - 1]);
        if reach(first) > reach(last) && reach(first) > 0.5 * length {
            return Err(MeasuredFault::Unsorted { row: last.row });
        }
        Ok(Self { points })
    }

    /// The measured backbone that a scene holds; its rows count from 1 in
    /// `points_mm`.
    ///
    /// # Errors
    /// Those of [`Measured::new`].
    pub fn of_scene(held: &Measurements, problem: &Problem) -> Result<Self, MeasuredFault> {
        let points = held.points_mm.iter().enumerate();
        let points = points.map(|(index, [x, y])| MeasuredPoint {
            row: index + 1,
            node: held.nodes.get(index).map(|node| *node as usize),
            position: Vector::new(metres(*x), metres(*y)),
        });
        Self::new(points.collect(), problem)
    }

    /// The points, base to tip.
    pub fn points(&self) -> &[MeasuredPoint] {
        &self.points
    }

    /// Whether points are compared with their own nodes.
    pub fn by_node(&self) -> bool {
        self.points[0].node.is_some()
    }
}

/// A shape's distances from a measured one.
pub fn compare(solution: &Solution, measured: &Measured) -> ShapeFit {
    let distances: Vec<f64> = measured
        .points
        .iter()
        .map(|point| match point.node {
            Some(node) => (solution.nodes[node].position - point.position).norm(),
            None => from_backbone(solution, point.position),
        })
        .collect();
    let squares: f64 = distances.iter().map(|d| d * d).sum();
    let (worst, max) =
        distances.iter().enumerate().fold(
            (0, 0.0),
            |most, (i, d)| if *d > most.1 { (i, *d) } else { most },
        );
    ShapeFit {
        pull: solution.pull,
        rms: (squares / distances.len() as f64).sqrt(),
        max,
        max_row: measured.points[worst].row,
        distances,
    }
}

/// Distance from the nearest point of the computed backbone, in metres.
fn from_backbone(solution: &Solution, point: Vector) -> f64 {
    let links = solution.nodes.windows(2);
    links
        .map(|ends| {
            let (start, end) = (ends[0].position, ends[1].position);
            let link = end - start;
            let along = (point - start).dot(&link) / link.norm_squared();
            (point - start - along.clamp(0.0, 1.0) * link).norm()
        })
        .fold(f64::INFINITY, f64::min)
}

/// The pull whose shape has the least RMS distance from a measured one, with
/// that shape: a search in steps along the branch from the straight robot, both
/// ways, up to a full turn or the end of the branch, then a golden section.
///
/// # Errors
/// If the robot cannot be solved for at all.
pub fn best_pull(
    problem: &Problem,
    measured: &Measured,
) -> Result<(Problem, Solution, ShapeFit), ShapeError> {
    let mut best: Option<(Problem, Solution, ShapeFit)> = None;
    let robot = problem.robot();
    let step = STEP * robot.offset;
    let (least, most) = robot.pull_range();
    let turn = TAU * robot.offset;
    let mut failed = Status::Unfinished;
    for (side, end) in [(1.0, most.min(turn)), (-1.0, (-least).min(turn))] {
        let mut target = problem.clone();
        target.set_pull(0.0);
        let mut run = Run::new(&target, Start::Straight, Settings::default());
        let steps = (end / step).floor() as usize;
        for k in 0..=steps {
            target.set_pull(side * step * k as f64);
            run.retarget(&target);
            let solution = run.finish();
            if solution.status != Status::Converged {
                failed = solution.status.clone();
                break;
            }
            let fit = compare(solution, measured);
            if best.as_ref().is_none_or(|(_, _, best)| fit.rms < best.rms) {
                best = Some((target.clone(), solution.clone(), fit));
            }
        }
    }
    let best = best.ok_or(ShapeError::NotReached(failed))?;
    Ok(refined(best, measured, step))
}

/// The best of a neighbourhood, by golden section.
fn refined(
    start: (Problem, Solution, ShapeFit),
    measured: &Measured,
    reach: f64,
) -> (Problem, Solution, ShapeFit) {
    let golden = 0.5 * (5.0_f64.sqrt() - 1.0);
    let at = |pull: f64| -> Option<(Problem, Solution, ShapeFit)> {
        let (problem, solution, _) = &start;
        let mut there = problem.clone();
        there.set_pull(pull);
        let solution = solve(&there, Start::From(problem, solution), Settings::default());
        let fit = compare(&solution, measured);
        (solution.status == Status::Converged).then_some((there, solution, fit))
    };
    let rms = |pull: f64| at(pull).map_or(f64::INFINITY, |(_, _, fit)| fit.rms);
    let (mut low, mut high) = (start.2.pull - reach, start.2.pull + reach);
    let (mut a, mut b) = (high - golden * (high - low), low + golden * (high - low));
    let (mut at_a, mut at_b) = (rms(a), rms(b));
    while high - low > GRAIN * start.0.length() {
        if at_a <= at_b {
            (high, b, at_b) = (b, a, at_a);
            a = high - golden * (high - low);
            at_a = rms(a);
        } else {
            (low, a, at_a) = (a, b, at_b);
            b = low + golden * (high - low);
            at_b = rms(b);
        }
    }
    match at(0.5 * (low + high)) {
        Some(found) if found.2.rms <= start.2.rms => found,
        _ => start,
    }
}
