//! What is selected, and what the pointer is on.

use crate::mechanics::{Model, Problem};
use std::ops::Range;

/// What is selected.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Selection {
    /// Nothing.
    #[default]
    Nothing,
    /// The robot.
    Robot,
    /// An obstacle, by its index in the scene.
    Obstacle(usize),
    /// The photograph.
    Photo,
    /// What was measured.
    Measured,
}

impl Selection {
    /// The obstacle that is selected, by its index in the scene.
    pub fn obstacle(self) -> Option<usize> {
        match self {
            Selection::Obstacle(index) => Some(index),
            _ => None,
        }
    }
}

/// What the pointer is on, in whichever part of the window: its twins light up
/// in all others.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Hovered {
    /// Nothing that has a twin.
    #[default]
    Nothing,
    /// A node, from 0 at the base.
    Node(usize),
    /// A contact, by its index in the solution.
    Contact(usize),
    /// A stretch of a cable, both from 0, the stretch at the base.
    Stretch {
        /// The cable.
        cable: usize,
        /// The stretch: from disk to disk or, in the paper's model, a link.
        stretch: usize,
    },
    /// An obstacle, by its index in the scene.
    Obstacle(usize),
    /// A pull, in metres.
    Pull(f64),
}

/// The nodes that a stretch of a cable is between, the upper one not among them: those
/// of a bay or, in the paper's model, where every link has its own tension, of a
/// segment.
pub fn nodes_of_stretch(problem: &Problem, stretch: usize) -> Range<usize> {
    let nodes = match problem.model() {
        Model::Sliding => problem.robot().segments_per_bay,
        Model::Equal => 1,
    };
    stretch * nodes..(stretch + 1) * nodes
}
