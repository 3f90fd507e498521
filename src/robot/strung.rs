//! The parts of a robot whose cables are straight from disk to disk, of which there may
//! be several on either side. Those of the paper's robot are in [`super::candidate`].

use super::cable::Cable;
use super::candidate::{Candidate, Element, Joins, Line};
use super::dimensions::Robot;
use super::sizes::Sizes;
use crate::scene::{self, Candidates};

impl Robot {
    /// The point of the backbone at a node, from 1, without thickness.
    pub fn backbone_point(&self, node: usize) -> Candidate {
        self.bare(Line::Backbone, node, 0.0)
    }

    /// The point of a cable at a node, from 1, without thickness: a hole's or one of
    /// the straight stretch between two. `None` beyond the cable's last disk.
    pub fn cable_point(&self, index: usize, cable: &Cable, node: usize) -> Option<Candidate> {
        let bay = self.segments_per_bay;
        let lever = cable.offset;
        let above = (bay - node % bay) % bay;
        let element = match above {
            0 => Element::Point { lever },
            above => Element::OnLink { lever, above },
        };
        (node <= cable.last_disk * bay).then(|| Candidate {
            element,
            span: bay,
            cable: index,
            ..self.bare(Line::Cable, node, lever)
        })
    }

    /// The two ends of a node's disk, without thickness: on the cable's side, and on
    /// the other.
    pub fn rim_points(&self, node: usize) -> [Candidate; 2] {
        let rim = self.sizes.rim;
        [
            self.bare(Line::RimCableSide, node, rim),
            self.bare(Line::RimFarSide, node, -rim),
        ]
    }

    /// The parts that a scene lets touch.
    pub fn strung_candidates(&self, cables: &[Cable], contact: &scene::Contact) -> Vec<Candidate> {
        let nodes = 1..=self.segments;
        let all = |node| {
            let on_cables = cables.iter().enumerate();
            on_cables.filter_map(move |(index, cable)| self.cable_point(index, cable, node))
        };
        match contact.candidates {
            Candidates::Nodes => nodes
                .flat_map(|node| std::iter::once(self.backbone_point(node)).chain(all(node)))
                .collect(),
            Candidates::Body => nodes
                .flat_map(|node| self.strung_parts(cables, node))
                .collect(),
            Candidates::Listed => {
                let mut parts = Vec::new();
                for listed in &contact.listed {
                    let node = listed.node as usize;
                    match listed.line {
                        scene::Line::Backbone => parts.push(self.backbone_point(node)),
                        scene::Line::Cable => {
                            let index = listed.cable as usize;
                            let cable = cables.get(index);
                            let point = cable.and_then(|c| self.cable_point(index, c, node));
                            parts.extend(point);
                        }
                        scene::Line::Rim => parts.extend(self.rim_points(node)),
                    }
                }
                parts
            }
        }
    }

    /// Everything solid between a node and the one before, and of cables whatever ends
    /// at the node's disk. Of the base, which is node 0, the disk.
    pub fn strung_parts(&self, cables: &[Cable], node: usize) -> Vec<Candidate> {
        let Sizes {
            rim,
            disk,
            backbone,
            ..
        } = self.sizes;
        let bay = self.segments_per_bay;
        let mut parts = Vec::new();
        if node > 0 {
            let point = Candidate {
                radius: 0.5 * backbone,
                joins: Joins::Links,
                ..self.backbone_point(node)
            };
            parts.push(point);
            parts.push(Candidate {
                line: Line::BackboneLink,
                element: Element::Link { lever: 0.0 },
                joins: Joins::Nothing,
                ..point
            });
        }
        if !self.has_disk(node) {
            return parts;
        }
        let running = || {
            let all = cables.iter().enumerate();
            all.filter(|(_, cable)| node > 0 && node <= cable.last_disk * bay)
        };
        for (index, cable) in running() {
            let lever = cable.offset;
            let point = Candidate {
                radius: 0.5 * cable.diameter,
                joins: Joins::Links,
                span: bay,
                cable: index,
                ..self.bare(Line::Cable, node, lever)
            };
            parts.push(point);
            parts.push(Candidate {
                line: Line::CableLink,
                element: Element::Link { lever },
                joins: Joins::Nothing,
                ..point
            });
        }
        for point in self.rim_points(node) {
            // At a cable, and no thicker than it, a rim is where stretches meet.
            let is_joint = running().any(|(_, cable)| {
                cable.offset * point.signed_lever() >= rim * rim && disk <= cable.diameter
            });
            parts.push(Candidate {
                radius: 0.5 * disk,
                joins: if is_joint { Joins::Links } else { Joins::Disk },
                span: bay,
                ..point
            });
        }
        parts.push(Candidate {
            line: Line::DiskFace,
            element: Element::Across { lever: rim },
            radius: 0.5 * disk,
            ..self.bare(Line::DiskFace, node, rim)
        });
        parts
    }
}
