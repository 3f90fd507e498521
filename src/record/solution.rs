//! The record of a solution.

use serde::Serialize;

use crate::contact::Contact as Touch;
use crate::equilibrium::{Caution as Finding, Event as Happening, Occurrence, Run};
use crate::forces::{Statics, Stiffness};
use crate::geometry::Vector;
use crate::mechanics::{Drive, Slip};
use crate::robot::Line;
use crate::units::{millimetres, per_millimetre};

use super::cables::{Cable, Driven, point_mm};
use super::certificate::Certificate;
use super::statics::{Balance, Base};
use super::timing::Timing;

/// The version of the keys below.
const SCHEMA: &str = "sinew-solution-2";

/// A solution, in the order of its keys in JSON. Points, directions and forces are in
/// the scene's frame. What needs a bending stiffness is null without one.
#[derive(Serialize)]
pub struct Solution {
    /// The version of the keys.
    pub schema: &'static str,
    /// How the run ended, in a word.
    pub status: &'static str,
    /// The status in a sentence.
    pub reason: String,
    /// `sliding` or `equal`, as in the scene.
    pub mechanics: &'static str,
    /// `plane`.
    pub space: &'static str,
    /// How much of the way from the straight robot has been gone, from 0 to 1: the part
    /// of all pulls and loads that acts.
    pub share: f64,
    /// The length of cable drawn in, negative where it is let out; where there is one
    /// cable.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub pull_mm: Option<f64>,
    /// Where the last node is.
    pub tip_mm: [f64; 2],
    /// How far the tip points clockwise of the base.
    pub tip_slope_rad: f64,
    /// Σ bend², rad².
    pub energy: f64,
    /// The elastic energy of the backbone, in N mm.
    pub energy_nmm: Option<f64>,
    /// Whether weights on the cables would hold the shape, too; null in the paper's
    /// model.
    pub stable_under_load: Option<bool>,
    /// n + 1 points, base first.
    pub backbone_mm: Vec<[f64; 2]>,
    /// n + 1 points, base first, or as far as it goes; where there is one cable.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub cable_mm: Option<Vec<[f64; 2]>>,
    /// In the order of the scene.
    pub cables: Vec<Cable>,
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
    /// What the mount of the first disk exerts on the robot.
    pub base: Option<Base>,
    /// What is left of sums that should vanish; null where a shape that is none leaves
    /// no numbers.
    pub balance: Option<Balance>,
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
    /// Which cable it is on, from 0; null where it is on none.
    pub cable: Option<usize>,
    /// Index from 0 at the base.
    pub node: usize,
    /// `pressing` or `grazing`.
    pub class: &'static str,
    /// In rad²/mm, for a clearance in mm.
    pub multiplier: f64,
    /// The obstacle's force on the robot, along the normal, in N.
    pub force_n: Option<f64>,
    /// Along the normal turned by 90° clockwise, in N; null without friction.
    pub friction_n: Option<f64>,
    /// How the robot slips past it: `forward` along that direction, `back`, or `sticks`;
    /// null without friction.
    pub slips: Option<&'static str>,
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
    /// How much of the way had been gone.
    pub share: f64,
    /// What was given of every cable there.
    pub cables: Vec<Driven>,
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
        let rubs = !solution.drive.friction.is_none();
        let per_bend = stiffness.map(|stiffness| stiffness.per_bend(problem));
        let statics = Statics::of_scale(solved, per_bend.unwrap_or(1.0));
        let cautions = Finding::all(solved);
        let is_one = solution.cables.len() == 1;
        let contacts = solution.contacts.iter();
        let events = solution.events.iter();
        let state = Self {
            schema: SCHEMA,
            status: solution.status.word(),
            reason: solution.status.reason(),
            mechanics: problem.model().word(),
            space: "plane",
            share: run.driven_share(),
            pull_mm: is_one.then(|| millimetres(solution.pull)),
            tip_mm: solution.backbone().last().map(point_mm).unwrap_or_default(),
            tip_slope_rad: solution.bends.iter().sum(),
            energy: solution.energy,
            energy_nmm: per_bend.map(|per_bend| millimetres(per_bend * solution.energy)),
            stable_under_load: solved.rests_under_load(),
            backbone_mm: solution.backbone().map(point_mm).collect(),
            cable_mm: is_one.then(|| solved.cable().map(point_mm).collect()),
            cables: (0..solution.cables.len())
                .map(|index| Cable::of(solved, index, per_bend))
                .collect(),
            bends_rad: solution.bends.clone(),
            shears_rad: solution.shears.clone(),
            contacts: contacts
                .map(|touch| contact(touch, per_bend, rubs))
                .collect(),
            unique_split: solution.unique_split,
            obstacles_placed: run.obstacles_are_placed(),
            base: per_bend.and_then(|_| Base::of(&statics)),
            balance: Balance::of(&statics),
            certificate: Certificate::of(&solution.certificate),
            cautions: cautions.into_iter().map(caution).collect(),
            events: events
                .map(|happening| event(happening, &run.drive_at(happening.share)))
                .collect(),
            iterations: solution.iterations,
            timing_us: None,
        };
        state.is_finite().then_some(state)
    }

    /// The same state with another caution.
    pub fn with_caution(mut self, finding: Option<Finding>) -> Self {
        self.cautions.extend(finding.map(caution));
        self
    }

    /// The same state as the end of a part of a longer way, from one of its shares to
    /// another.
    pub fn on_the_way(mut self, from: f64, to: f64) -> Self {
        let whole = |share: f64| (1.0 - share) * from + share * to;
        self.share = whole(self.share);
        for event in &mut self.events {
            event.share = whole(event.share);
        }
        self
    }

    fn is_finite(&self) -> bool {
        let points = self.backbone_mm.iter().flatten();
        let angles = self.bends_rad.iter().chain(&self.shears_rad);
        let contacts = self.contacts.iter().flat_map(|contact| {
            let [x, y] = contact.point_mm;
            let [u, v] = contact.normal;
            [contact.multiplier, contact.clearance_mm, x, y, u, v]
        });
        let events = self.events.iter().flat_map(|event| {
            let [u, v] = event.direction.unwrap_or_default();
            [event.share, event.distance_mm.unwrap_or_default(), u, v]
        });
        let given = self.events.iter().flat_map(|event| &event.cables);
        let cautions = self.cautions.iter().filter_map(|caution| caution.depth_mm);
        [self.share, self.energy, self.tip_slope_rad]
            .into_iter()
            .chain(self.cables.iter().flat_map(Cable::numbers))
            .chain(given.flat_map(Driven::numbers))
            .chain(cautions)
            .chain(points.copied())
            .chain(angles.copied())
            .chain(contacts)
            .chain(self.certificate.numbers())
            .chain(events)
            .all(f64::is_finite)
    }
}

fn contact(touch: &Touch, per_bend: Option<f64>, rubs: bool) -> Contact {
    let is_cable = matches!(touch.line, Line::Cable | Line::CableLink);
    Contact {
        obstacle: touch.obstacle,
        line: touch.line.name(),
        cable: is_cable.then_some(touch.cable),
        node: touch.node,
        class: touch.class.word(),
        multiplier: per_millimetre(touch.multiplier),
        force_n: per_bend.map(|per_bend| per_bend * touch.multiplier),
        friction_n: per_bend
            .filter(|_| rubs)
            .map(|per_bend| per_bend * touch.friction),
        slips: rubs.then(|| Slip::of(touch.slid).word_at_contact()),
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
        Finding::CablePushes | Finding::Weightless => Place::default(),
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

fn event(happening: &Happening, drive: &Drive) -> Event {
    let mut event = Event {
        share: happening.share,
        cables: Driven::all(drive),
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
        Occurrence::FrictionGaveWay | Occurrence::StartRefused => {}
    }
    event
}

fn pair(vector: Vector) -> [f64; 2] {
    [vector.x, vector.y]
}
