//! The robot and its parts from a scene, in the file's units.

use super::candidate::{Candidate, Line};
use super::dimensions::Robot;
use super::node::PlanarNode;
use super::sizes::Sizes;
use crate::geometry::Vector;
use crate::scene::{self, Candidates, Scene};
use crate::units::{metres, radians};

impl Robot {
    /// The robot that a scene describes, whose fields are in their ranges.
    pub fn of(scene: &Scene) -> Self {
        let described = &scene.robot;
        let angle = radians(described.base_angle_deg);
        Self {
            length: metres(described.length_mm),
            segments: described.segments as usize,
            segments_per_bay: described.segments_per_bay as usize,
            offset: metres(scene.offset_mm()),
            sizes: Sizes::of(scene),
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
        let at = |line, node, lever| self.bare(line, node, lever);
        match contact.candidates {
            Candidates::Nodes => nodes
                .flat_map(|i| [at(Line::Backbone, i, 0.0), at(Line::Cable, i, cable)])
                .collect(),
            Candidates::Listed => {
                let rim = self.sizes.rim;
                let listed = contact.listed.iter().flat_map(|listed| {
                    let node = listed.node as usize;
                    let (first, second) = match listed.line {
                        scene::Line::Backbone => (at(Line::Backbone, node, 0.0), None),
                        scene::Line::Cable => (at(Line::Cable, node, cable), None),
                        scene::Line::Rim => (
                            at(Line::RimCableSide, node, rim),
                            Some(at(Line::RimFarSide, node, -rim)),
                        ),
                    };
                    [Some(first), second].into_iter().flatten()
                });
                listed.collect()
            }
            Candidates::Body => nodes.flat_map(|node| self.parts(node)).collect(),
        }
    }
}
