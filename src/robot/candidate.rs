//! Which parts of the robot may touch something, and where they are in a shape.
//! It knows no obstacle.

use super::dimensions::Robot;
use super::node::Nodes;
use super::sizes::Sizes;
use crate::geometry::Vector;
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
    /// The flat face of a disk, without its rims.
    DiskFace,
}

impl Line {
    /// Whether its parts are points, which only a node moves, and not the
    /// lines between them.
    pub fn is_point(self) -> bool {
        !matches!(self, Line::BackboneLink | Line::CableLink | Line::DiskFace)
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
    /// A link to the candidate's node from the one its span below.
    Link {
        /// The lever of both ends.
        lever: f64,
    },
    /// The point of a link, one that spans several nodes, at the candidate's node.
    OnLink {
        /// The lever of the link's ends.
        lever: f64,
        /// How many nodes above the candidate's its upper end is, less than its span.
        above: usize,
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
    /// Which edges of the robot, at least as thick, end in its point.
    pub joins: Joins,
    /// How many nodes apart the ends of its link are, or of the links that end in its
    /// point: 1, or, of a cable that is straight from disk to disk, a bay's segments.
    pub span: usize,
    /// The cable it belongs to, from 0; 0 where it belongs to none.
    pub cable: usize,
}

/// What ends in a point of the robot.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Joins {
    /// No edge that may touch.
    Nothing,
    /// The links from the node below and, but for the last node, to the next.
    Links,
    /// The disk.
    Disk,
}

impl Candidate {
    /// How far from the backbone the candidate is, at most.
    pub fn lever(&self) -> f64 {
        self.signed_lever().abs()
    }

    /// The lever of its point, or of its end on the cable's side.
    pub fn signed_lever(&self) -> f64 {
        match self.element {
            Element::Point { lever }
            | Element::Link { lever }
            | Element::OnLink { lever, .. }
            | Element::Across { lever } => lever,
        }
    }

    /// Whether it is a point, and not a line between two.
    pub fn is_point(&self) -> bool {
        matches!(self.element, Element::Point { .. } | Element::OnLink { .. })
    }

    /// The candidate's point, or its two ends, from the nodes.
    #[inline]
    pub fn ends<N: Nodes + ?Sized>(&self, nodes: &N) -> (Vector, Vector) {
        let node = nodes.node(self.node);
        match self.element {
            Element::Point { lever } => (node.at(lever), node.at(lever)),
            Element::Link { lever } => {
                (nodes.node(self.node - self.span).at(lever), node.at(lever))
            }
            Element::OnLink { lever, above } => {
                let upper = self.node + above;
                let (below, above) = (nodes.node(upper - self.span), nodes.node(upper));
                let (start, end) = (below.at(lever), above.at(lever));
                let point = start + self.share() * (end - start);
                (point, point)
            }
            Element::Across { lever } => (node.at(-lever), node.at(lever)),
        }
    }

    /// The nodes that bear a force at a place on its edge, from 0 at the lower end to 1,
    /// each with its share by the rule of the lever.
    pub fn bearers(&self, along: f64) -> [(usize, f64); 2] {
        let (upper, along) = match self.element {
            Element::Point { .. } | Element::Across { .. } => {
                return [(self.node, 1.0), (self.node, 0.0)];
            }
            Element::Link { .. } => (self.node, along),
            Element::OnLink { above, .. } => (self.node + above, self.share()),
        };
        [(upper - self.span, 1.0 - along), (upper, along)]
    }

    /// Where on its link a point is, from 0 at the lower end to 1; 1 for all others.
    pub fn share(&self) -> f64 {
        match self.element {
            Element::OnLink { above, .. } => 1.0 - above as f64 / self.span as f64,
            _ => 1.0,
        }
    }
}

impl Robot {
    /// A part on the backbone or on a disk, which touches by itself.
    pub(super) fn bare(&self, line: Line, node: usize, lever: f64) -> Candidate {
        Candidate {
            line,
            node,
            element: Element::Point { lever },
            radius: 0.0,
            joins: Joins::Nothing,
            span: 1,
            cable: 0,
        }
    }

    /// Everything solid between a node and the one before: both links, and the
    /// node's disk where it has one. Of the base, which is node 0, the disk.
    pub fn parts(&self, node: usize) -> Vec<Candidate> {
        let Sizes {
            rim,
            disk,
            backbone,
            cable,
        } = self.sizes;
        // At the cable, and no thicker than it.
        let rim_is_joint = rim <= self.offset && disk <= cable;
        let part = |line, element, thickness: f64| Candidate {
            line,
            node,
            element,
            radius: 0.5 * thickness,
            span: 1,
            cable: 0,
            joins: match line {
                Line::Backbone | Line::Cable => Joins::Links,
                Line::RimFarSide => Joins::Disk,
                Line::RimCableSide if rim_is_joint && node > 0 => Joins::Links,
                Line::RimCableSide => Joins::Disk,
                Line::BackboneLink | Line::CableLink | Line::DiskFace => Joins::Nothing,
            },
        };
        let point = |lever| Element::Point { lever };
        let link = |lever| Element::Link { lever };
        let mut parts = Vec::new();
        if node > 0 {
            parts.extend([
                part(Line::Backbone, point(0.0), backbone),
                part(Line::Cable, point(self.offset), cable),
                part(Line::BackboneLink, link(0.0), backbone),
                part(Line::CableLink, link(self.offset), cable),
            ]);
        }
        if self.has_disk(node) {
            parts.extend([
                part(Line::RimCableSide, point(rim), disk),
                part(Line::RimFarSide, point(-rim), disk),
                part(Line::DiskFace, Element::Across { lever: rim }, disk),
            ]);
        }
        parts
    }
}
