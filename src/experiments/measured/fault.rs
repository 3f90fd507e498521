//! What can be wrong with a measured backbone.

use super::Measured;
use crate::scene::limits::shown;
use crate::units::millimetres;

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
        "row {row}: node {node} does not come after the one before; name each node once, base to tip"
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
    #[error(
        "row {row} turns back along the robot; order rows from base to tip, or name the nodes that they are"
    )]
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
    /// A backbone of another size than the robot's, as numbers in another unit
    /// make it.
    #[error(
        "the points are {} mm long and the robot there is {} mm long{}; {}",
        significant(*.found),
        significant(*.expected),
        likely(*.found, *.expected).map_or_else(String::new, |unit| format!(", as if they were in {}", unit.0)),
        likely(*.found, *.expected).map_or_else(
            || "check their unit and the robot's length, or name the nodes that they are".to_owned(),
            |unit| format!("write them in mm, or name the unit in the head of their table, as in x_{0},y_{0}", unit.1)
        )
    )]
    Length {
        /// Their length, in metres.
        found: f64,
        /// That of the robot where they belong, in metres.
        expected: f64,
    },
}

/// The unit that numbers taken for millimetres are in by what they measure: its
/// name and sign. A scan may be of half a robot.
fn likely(found: f64, expected: f64) -> Option<(&'static str, &'static str)> {
    match expected / found {
        7.0..16.0 => Some(("centimetres", "cm")),
        18.0..40.0 => Some(("inches", "in")),
        700.0..2500.0 => Some(("metres", "m")),
        _ => None,
    }
}

/// A length in mm with three digits.
fn significant(length: f64) -> String {
    let rounded = format!("{:.2e}", millimetres(length));
    rounded.parse().map_or(rounded, shown)
}
