//! What a run found: the shape, its contacts, its certificate.

use super::certificate::{Certificate, Certifier};
use super::event::Event;
use super::status::Status;
use crate::contact::RowKind;
use crate::geometry::Vector;
use crate::math::PackedCholesky;
use crate::mechanics::Problem;
use crate::robot::{Line, PlanarNode, Robot};
use crate::solver::{Control, Iteration, Point, RowId};
use serde::{Deserialize, Serialize};

/// Well above the solver's 1e-12.
const TOUCHING: f64 = Robot::TOUCHING;
/// Multipliers of the scaled problem above this, over the backbone's length,
/// press: the solver's zeros are exact, so this only guards against rounding.
const PRESSING: f64 = 1e-9;

/// Whether a contact carries a force.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Class {
    /// The multiplier is positive.
    Pressing,
    /// The clearance is zero and the multiplier is too.
    Grazing,
}

impl Class {
    /// The class in one word, as in JSON output.
    pub fn word(self) -> &'static str {
        match self {
            Class::Pressing => "pressing",
            Class::Grazing => "grazing",
        }
    }
}

/// A part of the robot that touches an obstacle.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Contact {
    /// Index of the candidate in the problem.
    pub candidate: usize,
    /// The line of the robot.
    pub line: Line,
    /// The node, from 1; the upper one of a link.
    pub node: usize,
    /// Index of the obstacle in the problem.
    pub obstacle: usize,
    /// The obstacle's vertex that the inside of an edge touches.
    pub vertex: Option<usize>,
    /// Where on its candidate's edge the contact is, from 0 at the lower node
    /// (or far rim) to 1, and beyond by a little in the notch between two links;
    /// 1 for a point.
    pub along: f64,
    /// The touching point of the obstacle's surface, in metres.
    pub point: Vector,
    /// The unit normal from the obstacle into the robot.
    pub normal: Vector,
    /// Signed distance less the candidate's radius, in metres; zero to
    /// rounding.
    pub clearance: f64,
    /// λ, in rad²/m, ≥ 0.
    pub multiplier: f64,
    /// Whether it carries a force.
    pub class: Class,
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

/// A shape of the robot and what is known about it.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Solution {
    /// How the run ended. The shape is an equilibrium whatever it says,
    /// provided that the certificate holds.
    pub status: Status,
    /// The pull of this shape, in metres: the goal's, or the last good one.
    pub pull: f64,
    /// The nodes, base first; n + 1. Of a run that has only begun, those it
    /// starts from.
    pub nodes: Vec<PlanarNode>,
    /// τ, the turn of each segment's shorter link, in radians; n.
    pub turns: Vec<f64>,
    /// β, the bend of each segment, in radians, clockwise; n.
    pub bends: Vec<f64>,
    /// ψ, the shear of each segment, in radians, clockwise; n.
    pub shears: Vec<f64>,
    /// J = Σ β², in rad².
    pub energy: f64,
    /// What touches, by candidate.
    pub contacts: Vec<Contact>,
    /// Whether the multipliers are the only ones possible. Where they are not
    /// (two obstacles touch the same node alike) their sum a node still is.
    pub unique_split: bool,
    /// The optimality conditions, recomputed.
    pub certificate: Certificate,
    /// What happened on the way.
    pub events: Vec<Event>,
    /// Iterations of the whole run.
    pub iterations: usize,
    /// The iterations of the last solve: the one that led here or, where the
    /// run ended short of its goal, the one that led no further.
    pub trace: Vec<Iteration>,
    #[serde(skip)]
    certifier: Certifier,
}

impl Default for Solution {
    fn default() -> Self {
        Self {
            status: Status::Unfinished,
            pull: 0.0,
            nodes: Vec::new(),
            turns: Vec::new(),
            bends: Vec::new(),
            shears: Vec::new(),
            energy: 0.0,
            contacts: Vec::new(),
            unique_split: true,
            certificate: Certificate::default(),
            events: Vec::new(),
            iterations: 0,
            trace: Vec::new(),
            certifier: Certifier::default(),
        }
    }
}

impl Solution {
    /// The backbone points, in metres, base first; n + 1.
    pub fn backbone(&self) -> impl ExactSizeIterator<Item = Vector> + '_ {
        self.nodes.iter().map(|node| node.position)
    }

    /// The cable points of a robot with this cable offset, in metres, base
    /// first; n + 1.
    pub fn cable(&self, offset: f64) -> impl ExactSizeIterator<Item = Vector> + '_ {
        self.nodes.iter().map(move |node| node.at(offset))
    }

    /// The tip: the last node.
    pub fn tip(&self) -> PlanarNode {
        self.nodes[self.nodes.len() - 1]
    }

    /// The clearance and multiplier of every candidate from every obstacle, by
    /// candidate; an edge whose inside faces no vertex has none.
    pub fn clearances(&self, problem: &Problem) -> Vec<Clearance> {
        let mut all = Vec::new();
        for (index, candidate) in problem.candidates().iter().enumerate() {
            for (obstacle_index, obstacle) in problem.obstacles().iter().enumerate() {
                let mut least = f64::INFINITY;
                candidate.clearances(&self.nodes, obstacle, |_, clearance| {
                    least = least.min(clearance);
                });
                if least.is_finite() {
                    let touching = self.contacts.iter().filter(|contact| {
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

    /// The contacts' multipliers in the scaled problem's terms, by row.
    pub(super) fn row_multipliers(&self, problem: &Problem) -> Vec<(RowId, f64)> {
        let bend = problem.segment().free_bend();
        let scale = bend * bend;
        let pressing = self.contacts.iter().filter(|c| c.multiplier > 0.0);
        let mut multipliers: Vec<(RowId, f64)> = pressing
            .map(|contact| {
                let kind = RowKind::Contact {
                    candidate: contact.candidate,
                    obstacle: contact.obstacle,
                    vertex: contact.vertex,
                };
                let id = kind.id(problem.obstacles().len());
                (id, contact.multiplier / scale)
            })
            .collect();
        multipliers.sort_by_key(|(id, _)| *id);
        multipliers
    }

    /// Fills the shape, the contacts and the certificate from a point of the
    /// scaled problem with its multipliers.
    pub(super) fn fill(
        &mut self,
        problem: &Problem,
        point: &Point<Problem, 3, 1>,
        multipliers: &[f64],
    ) {
        let segment = problem.segment();
        self.pull = problem.pull();
        self.nodes.clone_from(&point.nodes);
        self.turns.clear();
        self.turns.extend(point.controls.iter().map(|u| u[0]));
        self.bends.clear();
        let bends = point.nodes.windows(2).map(|w| w[0].angle - w[1].angle);
        self.bends.extend(bends);
        self.shears.clear();
        self.shears
            .extend(self.turns.iter().map(|turn| segment.shear(*turn)));
        self.energy = self.bends.iter().map(|bend| bend * bend).sum();
        self.find_contacts(problem, point, multipliers);
        let offset = problem.robot().offset;
        let points = point
            .nodes
            .iter()
            .map(|node| (node.position, node.at(offset)));
        self.certificate = self.certifier.certify(problem, points, &self.contacts);
    }

    /// Moves the shape as a whole.
    pub(super) fn move_by(&mut self, by: Vector) {
        if by != Vector::zeros() {
            self.nodes.iter_mut().for_each(|node| node.position += by);
            self.contacts
                .iter_mut()
                .for_each(|contact| contact.point += by);
        }
    }

    fn find_contacts(
        &mut self,
        problem: &Problem,
        point: &Point<Problem, 3, 1>,
        multipliers: &[f64],
    ) {
        let length = problem.length();
        // The solver minimises Σ (β/β*)².
        let bend = problem.segment().free_bend();
        let scale = bend * bend;
        self.contacts.clear();
        self.unique_split = true;
        for (row, &multiplier) in point.rows.iter().zip(multipliers) {
            let active = multiplier * length > PRESSING;
            if !active && row.value > TOUCHING * length {
                continue;
            }
            // Without pull the robot has no energy: what holds a row of the
            // scaled problem then needs no force.
            let multiplier = if active { multiplier * scale } else { 0.0 };
            let kind = RowKind::of(row.id, problem.obstacles().len());
            let RowKind::Contact {
                candidate: index,
                obstacle,
                vertex,
            } = kind
            else {
                continue;
            };
            let candidate = &problem.candidates()[index];
            let place = candidate.place(&point.nodes, &problem.obstacles()[obstacle], vertex);
            self.contacts.push(Contact {
                candidate: index,
                line: candidate.line,
                node: candidate.node,
                obstacle,
                vertex,
                along: place.along,
                point: place.point - (row.value + candidate.radius) * place.normal,
                normal: place.normal,
                clearance: row.value,
                multiplier,
                class: if multiplier > 0.0 {
                    Class::Pressing
                } else {
                    Class::Grazing
                },
            });
        }
        if self.contacts.iter().any(|c| c.class == Class::Grazing) {
            self.unique_split = independent(point, length);
        }
    }
}

/// More touching rows than this are only compared node by node.
const FEW: usize = 64;

/// Whether the gradients of all touching rows are linearly independent. Of
/// more than a few rows only those of the same node are compared with each
/// other, so that the test stays linear in the rows: two obstacles that touch
/// the same nodes alike are found all the same.
fn independent(point: &Point<Problem, 3, 1>, length: f64) -> bool {
    let mut rows: Vec<_> = point.rows.iter().collect();
    rows.retain(|row| row.value <= TOUCHING * length);
    if rows.len() <= FEW {
        return independent_in_controls(point, length);
    }
    rows.sort_by_key(|row| row.stage);
    rows.len() <= point.stages.len()
        && rows.chunk_by(|a, b| a.stage == b.stage).all(|node| {
            let gradients = nalgebra::DMatrix::from_fn(3, node.len(), |axis, i| {
                // Angles count as much as a length of the robot.
                node[i].after[axis] / if axis == 2 { length } else { 1.0 }
            });
            node.len() <= 3 && gradients.rank(1e-9) == node.len()
        })
}

/// Whether they are, each as a gradient in all controls.
fn independent_in_controls(point: &Point<Problem, 3, 1>, length: f64) -> bool {
    let touching: Vec<Vec<Control<1>>> = point
        .rows
        .iter()
        .filter(|row| row.value <= TOUCHING * length)
        .map(|row| point.row_gradient(row))
        .collect();
    let dot = |a: &[Control<1>], b: &[Control<1>]| -> f64 {
        a.iter().zip(b).map(|(a, b)| a.dot(b)).sum()
    };
    let mut factor = PackedCholesky::default();
    touching.iter().enumerate().all(|(i, row)| {
        let column: Vec<f64> = touching[..i].iter().map(|other| dot(row, other)).collect();
        let diagonal = dot(row, row);
        diagonal > 0.0 && factor.append(&column, diagonal, 1e-9 * diagonal).is_ok()
    })
}
