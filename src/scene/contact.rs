//! Which parts of the robot may touch obstacles. Not the contacts themselves.

use serde::{Deserialize, Serialize};

/// The parts of the robot that obstacles keep out.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct Contact {
    /// Which parts take part.
    pub candidates: Candidates,
    /// The nodes that take part. Not empty with [`Candidates::Listed`], empty
    /// otherwise, without repetition.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub listed: Vec<Listed>,
}

/// A choice of what obstacles keep out.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Candidates {
    /// Every node of the backbone and of the cable, as in the paper's eq. 5.
    #[default]
    Nodes,
    /// The nodes, every link between them and every disk, at their own size.
    Body,
    /// Only the nodes listed, as in the paper's eq. 12.
    Listed,
}

/// A point or a rim at a node that obstacles keep out.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
pub struct Listed {
    /// The line the node is on.
    pub line: Line,
    /// The cable that the node is on, from 0; 0 for the other lines.
    #[serde(default, skip_serializing_if = "is_first")]
    pub cable: u32,
    /// The node's index, from 1 to the number of segments: node 0 is the base
    /// and does not move. A rim's carries a disk. The paper counts from 1, so
    /// its node 15 is 14 here.
    pub node: u32,
}

fn is_first(cable: &u32) -> bool {
    *cable == 0
}

/// A line of the robot that a scene can name nodes on.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Line {
    /// The elastic middle line.
    Backbone,
    /// A cable beside it.
    Cable,
    /// Both ends of a disk.
    Rim,
}
