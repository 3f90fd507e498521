//! The record of a solution.

use serde::Serialize;

use crate::contact::Contact as Touch;
use crate::equilibrium::{Caution as Finding, Event as Happening, Occurrence, Run};
use crate::forces::Stiffness;
use crate::geometry::Vector;
use crate::robot::Line;
use crate::units::{millimetres, per_millimetre};

use super::certificate::Certificate;
use super::timing::Timing;

/// The version of the keys below.
const SCHEMA: &str = "sinew-solution-1";

/// A solution, in the order of its keys in JSON. Points and directions are in
/// the scene's frame.
#[derive(Serialize)]
pub struct Solution {
    /// The version of the keys.
    pub schema: &'static str,
    /// How the run ended, in a word.
    pub status: &'static str,
    /// The status in a sentence.
    pub reason: String,
    /// The length of cable drawn in; negative where it is let out.
    pub pull_mm: f64,
    /// Where the last node is.
    pub tip_mm: [f64; 2],
    /// How far the tip points clockwise of the base.
    pub tip_slope_rad: f64,
    /// Σ bend², rad².
    pub energy: f64,
    /// Of the cable, where the scene has a bending stiffness.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub tension_n: Option<f64>,
    /// n + 1 points, base first.
    pub backbone_mm: Vec<[f64; 2]>,
    /// n + 1 points, base first.
    pub cable_mm: Vec<[f64; 2]>,
    /// Of n segments, clockwise.
    pub bends_rad: Vec<f64>,
    /// Of n segments, clockwise.
    pub shears_rad: Vec<f64>,
    /// What touches.
    pub contacts: Vec<Contact>,
    /// Whether the multipliers are the only ones possible.
    pub unique_split: bool,
    /// Whether every obstacle had come to its place when the run ended.
    pub obstacles_placed: bool,
    /// The conditions of an equilibrium, recomputed.
    pub certificate: Certificate,
    /// What the certificate does not promise.
    pub cautions: Vec<Caution>,
    /// What happened on the way, by the run's order.
    pub events: Vec<Event>,
    /// Of the solver, over the whole run.
    pub iterations: usize,
    /// How long a solve takes, where that was measured.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub timing_us: Option<Timing>,
}

/// A part of the robot that touches an obstacle.
#[derive(Serialize)]
pub struct Contact {
    /// Index in the file, from 0.
    pub obstacle: usize,
    /// The line of the robot, by [`Line::name`].
    pub line: &'static str,
    /// Index from 0 at the base.
    pub node: usize,
    /// `pressing` or `grazing`.
    pub class: &'static str,
    /// In rad²/mm, for a clearance in mm.
    pub multiplier: f64,
    /// Out of the obstacle, of length 1.
    pub normal: [f64; 2],
    /// Of the obstacle's surface.
    pub point_mm: [f64; 2],
    /// Signed distance less the part's own radius.
    pub clearance_mm: f64,
    /// Which column of a table by node the contact belongs to.
    #[serde(skip)]
    pub side: Side,
}

/// One of the two lines a node has points on.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Side {
    /// The backbone's, with all that is not on the cable's.
    Backbone,
    /// The cable's.
    Cable,
}

/// A part of the robot and what is there; keys that do not apply are left out.
#[derive(Default, Serialize)]
pub struct Place {
    /// The line of the part, by [`Line::name`].
    #[serde(skip_serializing_if = "Option::is_none")]
    pub line: Option<&'static str>,
    /// The part's node, from 0 at the base; of a jump, the one that moved most.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub node: Option<usize>,
    /// The node of a part that lies over it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub other_node: Option<usize>,
    /// The obstacle, by its place in the file from 0.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub obstacle: Option<usize>,
}

impl Place {
    fn of_contact(line: Line, node: usize, obstacle: usize) -> Self {
        Self {
            line: Some(line.name()),
            node: Some(node),
            other_node: None,
            obstacle: Some(obstacle),
        }
    }
}

/// A caution; keys that its kind does not have are left out.
#[derive(Serialize)]
pub struct Caution {
    /// Its kind, in a word.
    pub what: &'static str,
    /// In a sentence, obstacles by their index.
    pub message: String,
    /// Where it is.
    #[serde(flatten)]
    pub place: Place,
    /// How deep the part is inside.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub depth_mm: Option<f64>,
    /// The setting of the scene that removes its cause.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub remedy: Option<&'static str>,
    /// What it was made of, for other sentences.
    #[serde(skip)]
    pub finding: Finding,
}

/// An event; keys that its kind does not have are left out.
#[derive(Default, Serialize)]
pub struct Event {
    /// The pull at which it happened.
    pub pull_mm: f64,
    /// Its kind, in a word.
    pub what: &'static str,
    /// Where it happened.
    #[serde(flatten)]
    pub place: Place,
    /// How far the node moved in a jump.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub distance_mm: Option<f64>,
    /// Why a branch ended, in a word.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub reason: Option<&'static str>,
    /// The segment at which it ended, from 1.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub segment: Option<usize>,
    /// Where an obstacle pushed the robot, of length 1.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub direction: Option<[f64; 2]>,
}

impl Solution {
    /// The state a run is in, with the backbone's stiffness where it is known;
    /// `None` where one of its numbers is not finite, which only a failed solve
    /// can lead to.
    pub fn of(run: &Run, stiffness: Option<Stiffness>) -> Option<Self> {
        let solved = &run.solved();
        let (problem, solution) = (solved.problem(), solved.solution());
        let slope = solution.energy_slope();
        let cautions = Finding::all(solved);
        let state = Self {
            schema: SCHEMA,
            status: solution.status.word(),
            reason: solution.status.reason(),
            pull_mm: millimetres(solution.pull),
            tip_mm: solution.backbone().last().map(point_mm).unwrap_or_default(),
            tip_slope_rad: solution.bends.iter().sum(),
            energy: solution.energy,
            tension_n: stiffness.map(|stiffness| stiffness.per_bend(problem) * slope),
            backbone_mm: solution.backbone().map(point_mm).collect(),
            cable_mm: solved.cable().map(point_mm).collect(),
            bends_rad: solution.bends.clone(),
            shears_rad: solution.shears.clone(),
            contacts: solution.contacts.iter().map(contact).collect(),
            unique_split: solution.unique_split,
            obstacles_placed: run.obstacles_are_placed(),
            certificate: Certificate::of(&solution.certificate),
            cautions: cautions.into_iter().map(caution).collect(),
            events: solution.events.iter().map(event).collect(),
            iterations: solution.iterations,
            timing_us: None,
        };
        state.is_finite().then_some(state)
    }

    fn is_finite(&self) -> bool {
        let points = self.backbone_mm.iter().chain(&self.cable_mm).flatten();
        let angles = self.bends_rad.iter().chain(&self.shears_rad);
        let contacts = self.contacts.iter().flat_map(|contact| {
            let [x, y] = contact.point_mm;
            let [u, v] = contact.normal;
            [contact.multiplier, contact.clearance_mm, x, y, u, v]
        });
        let events = self.events.iter().flat_map(|event| {
            let [u, v] = event.direction.unwrap_or_default();
            [event.pull_mm, event.distance_mm.unwrap_or_default(), u, v]
        });
        let cautions = self.cautions.iter().filter_map(|caution| caution.depth_mm);
        [self.pull_mm, self.energy, self.tip_slope_rad]
            .into_iter()
            .chain(self.tension_n)
            .chain(cautions)
            .chain(points.copied())
            .chain(angles.copied())
            .chain(contacts)
            .chain(self.certificate.numbers())
            .chain(events)
            .all(f64::is_finite)
    }
}

fn contact(touch: &Touch) -> Contact {
    Contact {
        obstacle: touch.obstacle,
        line: touch.line.name(),
        node: touch.node,
        class: touch.class.word(),
        multiplier: per_millimetre(touch.multiplier),
        normal: pair(touch.normal),
        point_mm: point_mm(touch.point),
        clearance_mm: millimetres(touch.clearance),
        side: match touch.line {
            Line::Backbone | Line::BackboneLink | Line::RimFarSide | Line::DiskFace => {
                Side::Backbone
            }
            Line::Cable | Line::CableLink | Line::RimCableSide => Side::Cable,
        },
    }
}

fn caution(finding: Finding) -> Caution {
    let mut depth_mm = None;
    let place = match finding {
        Finding::Crosses {
            line,
            node,
            obstacle,
            depth,
        } => {
            depth_mm = Some(millimetres(depth));
            Place::of_contact(line, node, obstacle)
        }
        Finding::Encloses { node, obstacle } => Place {
            node: Some(node),
            obstacle: Some(obstacle),
            ..Place::default()
        },
        Finding::Coils { lower, upper } => Place {
            node: Some(lower),
            other_node: Some(upper),
            ..Place::default()
        },
        Finding::CablePushes => Place::default(),
    };
    Caution {
        what: finding.word(),
        message: finding.sentence(|index| format!("obstacle {index}")),
        place,
        depth_mm,
        remedy: finding.remedy(),
        finding,
    }
}

fn event(happening: &Happening) -> Event {
    let mut event = Event {
        pull_mm: millimetres(happening.pull),
        what: happening.what.word(),
        ..Event::default()
    };
    match happening.what {
        Occurrence::PushedAside {
            obstacle,
            direction,
        } => {
            event.place.obstacle = Some(obstacle);
            event.direction = Some(pair(direction));
        }
        Occurrence::ContactMade {
            line,
            node,
            obstacle,
        }
        | Occurrence::ContactLost {
            line,
            node,
            obstacle,
        } => event.place = Place::of_contact(line, node, obstacle),
        Occurrence::Jump { node, distance } => {
            event.place.node = Some(node);
            event.distance_mm = Some(millimetres(distance));
        }
        Occurrence::BranchEnded { reason, segment } => {
            event.reason = Some(reason.word());
            event.segment = Some(segment);
        }
        Occurrence::StartRefused => {}
    }
    event
}

fn point_mm(point: Vector) -> [f64; 2] {
    [millimetres(point.x), millimetres(point.y)]
}

fn pair(vector: Vector) -> [f64; 2] {
    [vector.x, vector.y]
}
