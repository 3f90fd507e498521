//! The robot and its parts from a scene, in the file's units.

use super::candidate::{Candidate, Element, Joins, Line};
use super::dimensions::Robot;
use super::node::PlanarNode;
use super::sizes::Sizes;
use crate::geometry::Vector;
use crate::scene::{self, Candidates};
use crate::units::{metres, radians};

impl Robot {
    /// The robot that a scene describes, whose fields are in their ranges.
    pub fn of(described: &scene::Robot) -> Self {
        let angle = radians(described.base_angle_deg);
        Self {
            length: metres(described.length_mm),
            segments: described.segments as usize,
            segments_per_bay: described.segments_per_bay as usize,
            offset: metres(described.cable_offset_mm),
            sizes: Sizes::of(described),
            base: PlanarNode {
                position: Vector::from(described.base_mm.map(metres)),
                disk: Vector::new(libm::cos(angle), libm::sin(angle)),
                angle,
            },
        }
    }

    /// The parts of the robot that a scene lets touch.
    pub fn candidates(&self, contact: &scene::Contact) -> Vec<Candidate> {
        let nodes = 1..=self.segments;
        let cable = self.offset;
        let at = |line, node, lever| Candidate {
            line,
            node,
            element: Element::Point { lever },
            radius: 0.0,
            joins: Joins::Nothing,
            span: 1,
            cable: 0,
        };
        match contact.candidates {
            Candidates::Nodes => nodes
                .flat_map(|i| [at(Line::Backbone, i, 0.0), at(Line::Cable, i, cable)])
                .collect(),
            Candidates::Listed => {
                let listed = contact.listed.iter().map(|listed| {
                    let node = listed.node as usize;
                    match listed.line {
                        scene::Line::Backbone => at(Line::Backbone, node, 0.0),
                        scene::Line::Cable => at(Line::Cable, node, cable),
                    }
                });
                listed.collect()
            }
            Candidates::Body => nodes.flat_map(|node| self.parts(node)).collect(),
        }
    }
}
