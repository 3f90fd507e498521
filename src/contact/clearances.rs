//! Where a part of the robot is nearest to an obstacle, and by how much.

use super::surroundings::Surroundings;
use super::touch::Contact;
use crate::geometry::{Edge, Obstacle, PointClearance, Vector};
use crate::robot::{Candidate, Element, Joins, Nodes, PlanarNode};

/// Where a candidate is nearest to an obstacle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Place {
    /// The candidate's point or the point of its edge, in metres.
    pub point: Vector,
    /// The unit normal from the obstacle.
    pub normal: Vector,
    /// Where on its edge, from 0 to 1, and beyond by a little in the notch between
    /// two links; 1 for a point.
    pub along: f64,
}

impl Candidate {
    /// The clearance of a point candidate from an obstacle; `None` where the
    /// edges that end in it are nearer.
    pub fn point_clearance<N: Nodes + ?Sized>(
        &self,
        nodes: &N,
        obstacle: &Obstacle,
    ) -> Option<PointClearance> {
        let lever = match self.element {
            Element::Point { lever } => lever,
            Element::OnLink { .. } => return Some(obstacle.clearance(self.ends(nodes).0)),
            Element::Link { .. } | Element::Across { .. } => return None,
        };
        let node = nodes.node(self.node);
        let point = node.at(lever);
        let at = |node: usize| nodes.find(node).map(|node| node.at(lever));
        match self.joins {
            Joins::Nothing => Some(obstacle.clearance(point)),
            Joins::Links => {
                let (below, above) = (self.node.checked_sub(self.span), self.node + self.span);
                obstacle.end_clearance(point, [below.and_then(at), at(above)])
            }
            Joins::Disk => obstacle.end_clearance(point, [Some(node.at(-lever)), None]),
        }
    }

    /// The candidate's edge from the nodes, joined to the links below and above
    /// it where it is a link itself; of no length for a point.
    pub fn edge<N: Nodes + ?Sized>(&self, nodes: &N) -> Edge {
        let (start, end) = self.ends(nodes);
        let mut edge = Edge::alone(start, end);
        if let Element::Link { lever } = self.element {
            let at = |node: usize| nodes.find(node).map(|node| node.at(lever));
            let below = self.node.checked_sub(2 * self.span);
            edge.joined = [below.and_then(at), at(self.node + self.span)];
        }
        edge
    }

    /// Where the candidate is nearest to an obstacle, for an edge to one of
    /// its vertices.
    pub fn place<N: Nodes + ?Sized>(
        &self,
        nodes: &N,
        obstacle: &Obstacle,
        vertex: Option<usize>,
    ) -> Place {
        let (start, end) = self.ends(nodes);
        let clearance = self.point_clearance(nodes, obstacle);
        let mut place = Place {
            point: end,
            normal: clearance.unwrap_or_else(|| obstacle.clearance(end)).normal,
            along: 1.0,
        };
        let facing = vertex.and_then(|v| obstacle.edge_clearance(&self.edge(nodes), v));
        if let Some(clearance) = facing {
            place = Place {
                point: start + clearance.along * (end - start),
                normal: clearance.normal,
                along: clearance.along,
            };
        }
        place
    }

    /// The least clearance of this candidate from an obstacle, in metres;
    /// infinite for an edge whose inside faces no vertex.
    pub fn least_clearance<N: Nodes + ?Sized>(&self, nodes: &N, obstacle: &Obstacle) -> f64 {
        let mut least = f64::INFINITY;
        self.clearances(nodes, obstacle, |_, clearance| least = least.min(clearance));
        least
    }

    /// The clearances of this candidate from an obstacle, each with its
    /// vertex: one for a point, any number for an edge, and one without a
    /// vertex for an edge that crosses the obstacle's core.
    pub fn clearances<N: Nodes + ?Sized>(
        &self,
        nodes: &N,
        obstacle: &Obstacle,
        mut each: impl FnMut(Option<usize>, f64),
    ) {
        let (start, end) = self.ends(nodes);
        match self.element {
            Element::Point { .. } | Element::OnLink { .. } => {
                let clearance = obstacle.clearance(start);
                each(None, clearance.distance - self.radius);
            }
            _ => {
                if let Some(depth) = obstacle.crossing_depth(start, end) {
                    each(None, -depth - self.radius);
                }
                obstacle.edge_clearances(&self.edge(nodes), |clearance| {
                    each(Some(clearance.vertex), clearance.distance - self.radius);
                });
            }
        }
    }
}

/// The clearance of one candidate from one obstacle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Clearance {
    /// Index of the candidate.
    pub candidate: usize,
    /// Index of the obstacle.
    pub obstacle: usize,
    /// Signed distance less the candidate's radius, in metres.
    pub clearance: f64,
    /// λ, in rad²/m, summed where an edge touches two vertices.
    pub multiplier: f64,
}

impl Surroundings {
    /// The clearance and multiplier of every candidate from every obstacle, by
    /// candidate; an edge whose inside faces no vertex has none.
    pub fn clearances(&self, nodes: &[PlanarNode], contacts: &[Contact]) -> Vec<Clearance> {
        let mut all = Vec::new();
        for (index, candidate) in self.candidates.iter().enumerate() {
            for (obstacle_index, obstacle) in self.obstacles.iter().enumerate() {
                let least = candidate.least_clearance(nodes, obstacle);
                if least.is_finite() {
                    let touching = contacts.iter().filter(|contact| {
                        contact.candidate == index && contact.obstacle == obstacle_index
                    });
                    all.push(Clearance {
                        candidate: index,
                        obstacle: obstacle_index,
                        clearance: least,
                        multiplier: touching.map(|contact| contact.multiplier).sum(),
                    });
                }
            }
        }
        all
    }
}
