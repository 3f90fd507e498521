//! A measured backbone that can belong to a robot: its points, and what is
//! refused of them. Where it is measured from is not its business.

use crate::geometry::Vector;
use crate::mechanics::Problem;
use crate::scene::Measurements;
use crate::scene::limits::LEAST_MEASURED_POINTS;
use crate::units::metres;
use serde::{Deserialize, Serialize};

mod fault;
mod order;
mod span;

pub use fault::MeasuredFault;

/// A measured point of the backbone.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct MeasuredPoint {
    /// Its line in the file, from 1, for messages.
    pub row: usize,
    /// Its node, from 0 at the base, where it is known.
    pub node: Option<usize>,
    /// Its place, in metres.
    pub position: Vector,
}

/// A measured backbone that can be compared with a robot.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Measured {
    points: Vec<MeasuredPoint>,
    length: f64,
}

/// How much farther than the robot is long a point may be: errors of measuring
/// a stretched robot, not of units.
const REACH: f64 = 1.1;

impl Measured {
    /// The fewest points that are compared, those of a scene's check: two may
    /// be a point on the way and the tip.
    pub const LEAST_POINTS: usize = LEAST_MEASURED_POINTS;

    /// Measured points, checked against the robot that they belong to.
    ///
    /// # Errors
    /// The first fault of a row, in their order; then those of the whole: its
    /// order and its length.
    pub fn new(points: Vec<MeasuredPoint>, problem: &Problem) -> Result<Self, MeasuredFault> {
        let robot = problem.robot();
        let (length, base) = (robot.length, robot.base.position);
        if points.is_empty() {
            return Err(MeasuredFault::Empty);
        }
        let named = points.iter().any(|p| p.node.is_some());
        let mut before: Option<usize> = None;
        for point in &points {
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
            match point.node {
                Some(node) if node > robot.segments => {
                    let last = robot.segments;
                    return Err(MeasuredFault::NoSuchNode { row, node, last });
                }
                Some(node) if before.is_some_and(|before| before >= node) => {
                    return Err(MeasuredFault::NodesUnsorted { row, node });
                }
                None if named => return Err(MeasuredFault::NodeMissing { row }),
                node => before = node,
            }
        }
        // A robot that is named node by node may lead anywhere, also back to
        // where it was.
        if !named {
            order::check(&points, problem)?;
        }
        if points.len() < Self::LEAST_POINTS {
            return Err(MeasuredFault::TooFew(points.len()));
        }
        let length = span::check(&points, problem)?;
        Ok(Self { points, length })
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

    /// The length of the line through the points, in metres, without what their
    /// noise adds to it.
    pub fn length(&self) -> f64 {
        self.length
    }
}
