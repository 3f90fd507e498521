//! A contact: where a part of the robot touches an obstacle, and how hard.

use super::rows::RowKind;
use super::surroundings::Surroundings;
use crate::geometry::{Vector, perpendicular};
use crate::robot::{Line, Nodes, Robot};
use crate::solver::Row;
use serde::{Deserialize, Serialize};

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
    /// The cable it is on, from 0; 0 where it is on none.
    pub cable: usize,
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
    /// The obstacle's friction on the robot, in rad²/m, along the normal turned 90°
    /// clockwise; 0 where nothing rubs.
    pub friction: f64,
    /// How far the robot's material slid past the obstacle in the last step, along the
    /// same direction, in metres; 0 where nothing rubs.
    pub slid: f64,
    /// Whether it carries a force.
    pub class: Class,
}

impl Contact {
    /// The row it is of.
    pub fn kind(&self) -> RowKind {
        RowKind::Contact {
            candidate: self.candidate,
            obstacle: self.obstacle,
            vertex: self.vertex,
        }
    }

    /// The direction of friction: the normal turned 90° clockwise.
    pub fn tangent(&self) -> Vector {
        -perpendicular(self.normal)
    }

    /// The obstacle's force on the robot, in rad²/m times `per_bend`.
    pub fn force(&self, per_bend: f64) -> Vector {
        let pressed = per_bend * self.multiplier * self.normal;
        if self.friction == 0.0 {
            return pressed;
        }
        pressed + per_bend * self.friction * self.tangent()
    }
}

/// Multipliers above this of a problem scaled to an energy of order 1, over the
/// backbone's length, press: the solver's zeros are exact, so this only guards
/// against rounding.
const PRESSING: f64 = 1e-9;

/// What a solver found for rows.
#[derive(Clone, Copy, Debug)]
pub struct Multipliers<'a> {
    /// Of the scaled problem, one a row.
    pub multipliers: &'a [f64],
    /// The energy, in rad², that the scaled problem counts as 1.
    pub unit: f64,
}

impl Surroundings {
    /// Puts into `contacts` (emptied before) what touches in a shape with these
    /// rows near their bounds.
    pub fn find_contacts<N: Nodes + ?Sized, const NU: usize>(
        &self,
        rows: &[Row<3, NU>],
        nodes: &N,
        found: Multipliers<'_>,
        contacts: &mut Vec<Contact>,
    ) {
        let length = self.length;
        contacts.clear();
        for (row, &multiplier) in rows.iter().zip(found.multipliers) {
            let active = multiplier * length > PRESSING;
            if !active && row.value > Robot::TOUCHING * length {
                continue;
            }
            // Without pull the robot has no energy: what holds a row of the
            // scaled problem then needs no force.
            let multiplier = if active { multiplier * found.unit } else { 0.0 };
            let kind = RowKind::of(row.id, self.obstacles.len());
            let RowKind::Contact {
                candidate: index,
                obstacle,
                vertex,
            } = kind
            else {
                continue;
            };
            let candidate = &self.candidates[index];
            let place = candidate.place(nodes, &self.obstacles[obstacle], vertex);
            contacts.push(Contact {
                candidate: index,
                line: candidate.line,
                cable: candidate.cable,
                node: candidate.node,
                obstacle,
                vertex,
                along: place.along,
                point: place.point - (row.value + candidate.radius) * place.normal,
                normal: place.normal,
                clearance: row.value,
                multiplier,
                friction: 0.0,
                slid: 0.0,
                class: if multiplier > 0.0 {
                    Class::Pressing
                } else {
                    Class::Grazing
                },
            });
        }
    }
}
