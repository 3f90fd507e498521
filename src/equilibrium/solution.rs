//! What a run found: the shape, its contacts, its certificate.

use super::event::Event;
use super::split::independent;
use super::status::Status;
use crate::contact::{Class, Contact, Multipliers, RowKind};
use crate::geometry::Vector;
use crate::mechanics::{
    CableState, Certificate, Drag, Drive, Found, Mechanics, Model, Problem, Rubbing, Strand,
};
use crate::robot::{Nodes, PlanarNode};
use crate::solver::{Iteration, Point, RowId};
use serde::{Deserialize, Serialize};

/// A shape of the robot and what is known about it.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Solution {
    /// How the run ended. The shape is an equilibrium whatever it says,
    /// provided that the certificate holds.
    pub status: Status,
    /// The pull of this shape, in metres: the goal's, or the last good one.
    pub pull: f64,
    /// What drives the robot in this shape: the goal's, or the last good one.
    pub drive: Drive,
    /// The nodes, base first; n + 1. Of a run that has only begun, those it
    /// starts from.
    pub nodes: Vec<PlanarNode>,
    /// What the solver solves for, in radians, a number a segment: τ, the turn of the
    /// shorter link of a segment, in the paper's model; b, the bend of an arc, where
    /// cables slide. n.
    pub turns: Vec<f64>,
    /// β, the bend of each segment, in radians, clockwise; n.
    pub bends: Vec<f64>,
    /// ψ, the shear of each segment, in radians, clockwise; n.
    pub shears: Vec<f64>,
    /// J = Σ β², in rad².
    pub energy: f64,
    /// The cables, in the order of the scene.
    pub cables: Vec<CableState>,
    /// What friction keeps of them, in the same order; none where nothing rubs.
    pub strands: Vec<Strand>,
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
}

impl Default for Solution {
    fn default() -> Self {
        Self {
            status: Status::Unfinished,
            pull: 0.0,
            drive: Drive::default(),
            nodes: Vec::new(),
            turns: Vec::new(),
            bends: Vec::new(),
            shears: Vec::new(),
            energy: 0.0,
            cables: Vec::new(),
            strands: Vec::new(),
            contacts: Vec::new(),
            unique_split: true,
            certificate: Certificate::default(),
            events: Vec::new(),
            iterations: 0,
            trace: Vec::new(),
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

    /// The tension of each stretch of a cable that slides, base first, in rad²/m: one
    /// for each of its disks.
    ///
    /// # Panics
    /// If there is no cable of this index.
    pub fn tensions(&self, cable: usize) -> Vec<f64> {
        match self.strands.get(cable) {
            Some(strand) => strand.tensions.clone(),
            None => {
                let disks = self.drive.cables[cable].cable.last_disk;
                vec![self.cables[cable].tension; disks]
            }
        }
    }

    /// The contacts that press.
    pub fn pressing(&self) -> impl Iterator<Item = &Contact> {
        let contacts = self.contacts.iter();
        contacts.filter(|contact| contact.class == Class::Pressing)
    }

    /// The sum of the multipliers of what presses, in rad²/m.
    pub fn pressed(&self) -> f64 {
        self.pressing().map(|contact| contact.multiplier).sum()
    }

    /// What hangs on the first cable, or would hold it, in rad²/m: its tension, and with
    /// friction what is lost below the base.
    pub fn load(&self) -> f64 {
        let first = self.cables.first();
        first.map_or_else(|| self.energy_slope(), |cable| cable.load)
    }

    /// dJ*/dl, in rad²/m: how the least energy rises with the pull, whose product
    /// with EI/2l_0 is the cable's tension.
    pub fn energy_slope(&self) -> f64 {
        self.certificate.energy_slope
    }

    /// The contacts' multipliers in the scaled problem's terms, by row.
    pub(super) fn row_multipliers(&self, problem: &Problem, scale: f64) -> Vec<(RowId, f64)> {
        let pressing = self.contacts.iter().filter(|c| c.multiplier > 0.0);
        let mut multipliers: Vec<(RowId, f64)> = pressing
            .map(|contact| {
                let id = contact.kind().id(problem.obstacles().len());
                (id, contact.multiplier / scale)
            })
            .collect();
        if problem.model() == Model::Sliding {
            let cables = self.cables.iter().enumerate();
            let tense = cables.filter(|(_, state)| state.tension > 0.0);
            multipliers.extend(tense.map(|(cable, state)| {
                let stretch = 1;
                let kind = RowKind::Cable { cable, stretch };
                let id = kind.id(problem.obstacles().len());
                (id, state.tension / scale)
            }));
        }
        sort_by_id(&mut multipliers);
        multipliers
    }

    /// What friction keeps of the shape.
    pub(super) fn rubbing(&self, problem: &Problem) -> Rubbing {
        let count = problem.obstacles().len();
        let pressing = self.contacts.iter().filter(|c| c.multiplier > 0.0);
        let drag = |contact: &Contact| Drag {
            row: contact.kind().id(count),
            force: contact.friction,
            slid: contact.slid,
        };
        let mut drags: Vec<Drag> = pressing.map(drag).collect();
        drags.sort_by_key(|drag| drag.row);
        Rubbing {
            strands: self.strands.clone(),
            drags,
        }
    }

    /// Fills the shape, the contacts and the certificate from a point of the
    /// scaled problem with its multipliers; `rubbing` is what friction keeps there.
    pub(super) fn fill<M: Mechanics<NU>, const NU: usize>(
        &mut self,
        problem: &M,
        point: &Point<M, 3, NU>,
        multipliers: &[f64],
        rubbing: &Rubbing,
        certifier: &mut M::Certifier,
    ) {
        let shape = M::shape(&point.nodes);
        self.pull = problem.pull();
        self.drive.clone_from(problem.drive());
        self.set_nodes(shape);
        problem.write_controls(&point.controls, &mut self.turns);
        self.bends.clear();
        let bends = self.nodes.windows(2).map(|w| w[0].angle - w[1].angle);
        self.bends.extend(bends);
        problem.write_shears(&point.controls, &mut self.shears);
        problem.write_cables(point, multipliers, &mut self.cables);
        self.strands.clear();
        self.strands.extend_from_slice(&rubbing.strands);
        self.energy = self.bends.iter().map(|bend| bend * bend).sum();
        let around = problem.around();
        let found = Multipliers {
            multipliers,
            unit: problem.cost_unit(),
        };
        around.find_contacts(&point.rows, shape, found, &mut self.contacts);
        for drag in &rubbing.drags {
            let kind = RowKind::of(drag.row, problem.obstacles().len());
            let mut contacts = self.contacts.iter_mut();
            if let Some(contact) = contacts.find(|contact| contact.kind() == kind) {
                contact.friction = drag.force;
                contact.slid = drag.slid;
            }
        }
        // Where all press, the solver's set of rows is independent.
        let grazes = self.contacts.iter().any(|c| c.class == Class::Grazing);
        self.unique_split = !grazes || independent(point, problem.length());
        let found = Found {
            nodes: shape,
            contacts: &self.contacts,
            cables: &self.cables,
            strands: &self.strands,
        };
        self.certificate = problem.certify(certifier, found);
        match self.cables.first() {
            Some(first) => self.pull = first.pull,
            // The one cable of the paper's model is held by its links.
            None => self.cables.push(CableState {
                pull: self.pull,
                tension: self.certificate.energy_slope,
                load: self.certificate.energy_slope,
                is_slack: false,
            }),
        }
    }

    /// Sets the nodes to those of a shape.
    pub(super) fn set_nodes<N: Nodes + ?Sized>(&mut self, shape: &N) {
        self.nodes.clear();
        self.nodes.extend(shape.each());
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
}

/// Puts values of rows in the order of these.
pub(super) fn sort_by_id(rows: &mut [(RowId, f64)]) {
    rows.sort_by_key(|(id, _)| *id);
}
