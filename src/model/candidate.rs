//! Which parts of the robot may touch obstacles, and how they move with its
//! nodes. It holds no clearances.

use super::robot::Robot;
use crate::geometry::Vector;
use crate::solver::State;
use serde::{Deserialize, Serialize};

/// A line of the robot that contacts are reported on.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
pub enum Line {
    /// A node of the backbone.
    Backbone,
    /// A node of the cable.
    Cable,
    /// The end of a disk on the cable's side.
    RimCableSide,
    /// The end of a disk away from the cable.
    RimFarSide,
    /// The inside of a backbone link.
    BackboneLink,
    /// The inside of a cable link.
    CableLink,
    /// The inside of a disk, its flat face.
    Disk,
}

impl Line {
    /// The line's name in files and reports.
    pub fn name(self) -> &'static str {
        match self {
            Line::Backbone => "backbone",
            Line::Cable => "cable",
            Line::RimCableSide => "rim_cable_side",
            Line::RimFarSide => "rim_far_side",
            Line::BackboneLink => "backbone_link",
            Line::CableLink => "cable_link",
            Line::Disk => "disk",
        }
    }

    /// Whether its parts are points, which only a node moves, and not the
    /// lines between them.
    pub fn is_point(self) -> bool {
        !matches!(self, Line::BackboneLink | Line::CableLink | Line::Disk)
    }

    /// The part of the robot that this line has at a node, in words: `the
    /// cable between nodes 9 and 10`.
    pub fn part(self, node: usize) -> String {
        let link = |name| format!("the {name} between nodes {} and {node}", node - 1);
        match self {
            Line::Backbone | Line::Cable => format!("{} node {node}", self.name()),
            Line::RimCableSide => format!("the cable-side rim at node {node}"),
            Line::RimFarSide => format!("the far rim at node {node}"),
            Line::BackboneLink => link("backbone"),
            Line::CableLink => link("cable"),
            Line::Disk => format!("the disk at node {node}"),
        }
    }
}

/// The shape of a candidate. Levers are distances from the backbone along a
/// disk, positive towards the cable, in metres.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub enum Element {
    /// A point of the candidate's node.
    Point {
        /// The point's lever.
        lever: f64,
    },
    /// A link from the node before to the candidate's node.
    Link {
        /// The lever of both ends.
        lever: f64,
    },
    /// A disk, from one rim to the other.
    Across {
        /// The lever of the cable's side; the other end has its negative.
        lever: f64,
    },
}

/// A part of the robot that may touch obstacles.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Candidate {
    /// What it is reported as.
    pub line: Line,
    /// Its node, from 1; a link's upper one.
    pub node: usize,
    /// Its shape.
    pub element: Element,
    /// How thick it is around its point or line, in metres.
    pub radius: f64,
}

impl Candidate {
    /// How far from the backbone the candidate is, at most.
    pub fn lever(&self) -> f64 {
        match self.element {
            Element::Point { lever } | Element::Link { lever } | Element::Across { lever } => {
                lever.abs()
            }
        }
    }

    /// The candidate's point, or its two ends, from the nodes.
    pub fn ends(&self, nodes: &[super::PlanarNode]) -> (Vector, Vector) {
        let node = &nodes[self.node];
        match self.element {
            Element::Point { lever } => (node.at(lever), node.at(lever)),
            Element::Link { lever } => (nodes[self.node - 1].at(lever), node.at(lever)),
            Element::Across { lever } => (node.at(-lever), node.at(lever)),
        }
    }
}

/// How thick the robot's parts are, whether they may touch or not: half of
/// each thickness, in metres.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Body {
    /// Radius of the disks' rim.
    pub rim: f64,
    /// Half of a disk's thickness.
    pub disk: f64,
    /// Radius of the backbone.
    pub backbone: f64,
    /// Radius of the cable.
    pub cable: f64,
}

impl Body {
    /// Everything solid between a node and the one before: both links, and the
    /// node's disk where it has one. Of the base, which is node 0, the disk.
    pub fn parts(&self, robot: &Robot, node: usize) -> Vec<Candidate> {
        let part = |line, element, radius| Candidate {
            line,
            node,
            element,
            radius,
        };
        let point = |lever| Element::Point { lever };
        let link = |lever| Element::Link { lever };
        let mut parts = Vec::new();
        if node > 0 {
            parts.extend([
                part(Line::Backbone, point(0.0), self.backbone),
                part(Line::Cable, point(robot.offset), self.cable),
                part(Line::BackboneLink, link(0.0), self.backbone),
                part(Line::CableLink, link(robot.offset), self.cable),
            ]);
        }
        if robot.has_disk(node) {
            let across = Element::Across { lever: self.rim };
            parts.extend([
                part(Line::RimCableSide, point(self.rim), self.disk),
                part(Line::RimFarSide, point(-self.rim), self.disk),
                part(Line::Disk, across, self.disk),
            ]);
        }
        parts
    }
}

/// A point of a disk as a function of its node's state.
#[derive(Clone, Copy, Debug)]
pub(super) struct DiskPoint<'a> {
    pub node: &'a super::PlanarNode,
    pub lever: f64,
}

impl DiskPoint<'_> {
    /// The gradient of w·x, where x is the point.
    pub fn gradient(&self, weight: Vector) -> State<3> {
        let turn = self.lever * weight.dot(&self.node.normal());
        nalgebra::vector![weight.x, weight.y, turn]
    }

    /// The second derivative of w·x in φ; all others are zero.
    pub fn curvature(&self, weight: Vector) -> f64 {
        -self.lever * weight.dot(&self.node.disk)
    }

    /// The displacement of the point under a unit change of state component
    /// `index`.
    pub fn displacement(&self, index: usize) -> Vector {
        match index {
            0 => Vector::x(),
            1 => Vector::y(),
            _ => self.lever * self.node.normal(),
        }
    }
}
