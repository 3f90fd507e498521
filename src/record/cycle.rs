//! The record of a course of pulls or loads, there and back.

use serde::Serialize;

use super::cables::point_mm;
use crate::equilibrium::Solved;
use crate::explore::{Cycle as Course, Visit};
use crate::mechanics::Slip;
use crate::units::{degrees, millimetres};

/// The version of the keys below.
pub const SCHEMA: &str = "sinew-cycle-1";

/// A course, in the order of its keys in JSON. What needs a bending stiffness is null
/// without one.
#[derive(Serialize)]
pub struct Cycle {
    /// The version of the keys.
    pub schema: &'static str,
    /// What the scene is called.
    pub title: String,
    /// Its program's version.
    pub version: &'static str,
    /// The cable that was pulled or loaded, from 0.
    pub cable: usize,
    /// The states, the start first.
    pub rows: Vec<Row>,
    /// What work it took.
    pub work: Option<Work>,
    /// Why it went no further.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub reason: Option<String>,
}

/// Work along the course, in N mm.
#[derive(Serialize)]
pub struct Work {
    /// Of the one cable: the integral of its load over its pull, which is the area of
    /// the loop where it comes back.
    pub loop_nmm: f64,
    /// What all cables and dead loads did.
    pub done_nmm: f64,
    /// What of that the bent robot and stretched cables hold at the end.
    pub stored_nmm: f64,
    /// What went into friction, and into jumps.
    pub lost_nmm: f64,
}

/// A state.
#[derive(Serialize)]
pub struct Row {
    /// Which leg led to it, from 1; 0 of the start.
    pub leg: usize,
    /// Of the one cable.
    pub pull_mm: f64,
    /// What hangs on it below the base, or would hold it, in N.
    pub load_n: Option<f64>,
    /// Of its stretches, base first, in N.
    pub tensions_n: Option<Vec<f64>>,
    /// How it went through each hole in the step that led here: `in`, `out`, `sticks`;
    /// null without friction.
    pub slips: Option<Vec<&'static str>>,
    /// Of the tip.
    pub tip_mm: [f64; 2],
    /// Of the tip, clockwise from the base's direction.
    pub tip_bend_deg: f64,
    /// U of the bent backbone, in N mm.
    pub energy_nmm: Option<f64>,
    /// What presses.
    pub contacts: Vec<Contact>,
    /// The backbone, base first.
    pub backbone_mm: Vec<[f64; 2]>,
}

/// What presses.
#[derive(Serialize)]
pub struct Contact {
    /// The obstacle, by its place in the file.
    pub obstacle: usize,
    /// The line of the robot.
    pub line: &'static str,
    /// The node, from 0 at the base.
    pub node: usize,
    /// The obstacle's force on the robot, along its normal, in N.
    pub force_n: Option<f64>,
    /// Along the normal turned 90° clockwise, in N; null without friction.
    pub friction_n: Option<f64>,
    /// `forward` along that, `back`, or `sticks`; null without friction.
    pub slips: Option<&'static str>,
}

impl Cycle {
    /// The record of a course of one cable; `per_bend` is EI/2l, in N m, where it is
    /// known.
    pub fn of(course: &Course, cable: usize, title: String, per_bend: Option<f64>) -> Self {
        let visits = course.visits.iter();
        let work = course.work(cable);
        Self {
            schema: SCHEMA,
            title,
            version: env!("CARGO_PKG_VERSION"),
            cable,
            rows: visits
                .map(|visit| Row::of(visit, cable, per_bend))
                .collect(),
            work: per_bend.map(|per_bend| {
                let nmm = |work: f64| millimetres(per_bend * work);
                Work {
                    loop_nmm: nmm(work.of_cable),
                    done_nmm: nmm(work.done),
                    stored_nmm: nmm(work.stored),
                    lost_nmm: nmm(work.lost()),
                }
            }),
            reason: course.end.as_ref().map(|status| status.reason().to_owned()),
        }
    }
}

impl Row {
    fn of(visit: &Visit, cable: usize, per_bend: Option<f64>) -> Self {
        let solved: &Solved = &visit.solved;
        let state = solved.cables[cable];
        let rubs = !solved.drive.friction.is_none();
        let newtons = |force: f64| per_bend.map(|per_bend| per_bend * force);
        let pressing = solved.contacts.iter().filter(|c| c.multiplier > 0.0);
        Self {
            leg: visit.leg,
            pull_mm: millimetres(state.pull),
            load_n: newtons(state.load),
            tensions_n: per_bend.map(|per_bend| {
                let tensions = solved.tensions(cable);
                tensions.iter().map(|tension| per_bend * tension).collect()
            }),
            slips: solved.strands.get(cable).map(|strand| {
                let words = strand.slips.iter().map(|slip| slip.word());
                words.collect()
            }),
            tip_mm: point_mm(solved.tip().position),
            tip_bend_deg: degrees(solved.nodes[0].angle - solved.tip().angle),
            energy_nmm: newtons(solved.energy).map(millimetres),
            contacts: pressing
                .map(|contact| Contact {
                    obstacle: contact.obstacle,
                    line: contact.line.name(),
                    node: contact.node,
                    force_n: newtons(contact.multiplier),
                    friction_n: newtons(contact.friction).filter(|_| rubs),
                    slips: rubs.then(|| Slip::of(contact.slid).word_at_contact()),
                })
                .collect(),
            backbone_mm: solved.backbone().map(point_mm).collect(),
        }
    }
}
