//! What a certified shape does not promise: findings about the robot that the
//! equations leave out, each in a sentence. A caution changes no answer and no
//! status.

mod coil;
mod crossing;

use super::solved::Solved;
use crate::geometry::Vector;
use crate::math::decimals;
use crate::robot::Line;
use crate::scene::Scene;
use crate::units::millimetres;
use serde::{Deserialize, Serialize};

/// Energy slopes below this, times the cable offset, are none: far above their
/// rounding, and that of a pull of a billionth of the offset.
const NO_SLOPE: f64 = 1e-9;

/// Something about a shape that whoever relies on it has to know.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub enum Caution {
    /// A part of the robot is inside an obstacle, and no candidate sees it.
    /// The deepest of the parts inside this obstacle.
    Crosses {
        /// The part's line.
        line: Line,
        /// Its node, from 0 at the base; the upper one of a link.
        node: usize,
        /// The obstacle's index.
        obstacle: usize,
        /// How deep it is inside, in metres, > 0.
        depth: f64,
    },
    /// An obstacle stands between backbone and cable, and no candidate sees
    /// how it came there.
    Encloses {
        /// The upper node of the segment that it is in, from 1.
        node: usize,
        /// The obstacle's index.
        obstacle: usize,
    },
    /// The robot lies over itself: one of the places where it does.
    Coils {
        /// The node of the part nearer to the base; a link's upper one.
        lower: usize,
        /// The node of the part that lies over it.
        upper: usize,
    },
    /// The shape needs a cable that pushes.
    CablePushes,
    /// Gravity acts on a robot without any mass.
    Weightless,
}

impl Caution {
    /// All cautions about a solution: by obstacle, then those of the robot as a
    /// whole. None of a solution without a shape.
    pub fn all(solved: &Solved) -> Vec<Caution> {
        let problem = solved.problem();
        if solved.nodes.is_empty() {
            return Vec::new();
        }
        let mut cautions = crossing::find(problem, &solved.nodes);
        cautions.extend(coil::find(problem, &solved.nodes));
        if solved.energy_slope() * problem.drive().pull_scale() < -NO_SLOPE {
            cautions.push(Caution::CablePushes);
        }
        cautions
    }

    /// The cautions that a scene by itself gives, whatever its shape.
    pub fn of_scene(scene: &Scene) -> Option<Caution> {
        let robot = &scene.robot;
        let falls = scene.loads.gravity_m_s2 != [0.0; 2];
        let masses = [robot.disk_mass_g, robot.backbone_mass_g];
        (falls && masses == [0.0; 2]).then_some(Caution::Weightless)
    }

    /// The caution in one word, as in JSON output.
    pub fn word(&self) -> &'static str {
        match self {
            Caution::Crosses { .. } => "crosses_obstacle",
            Caution::Encloses { .. } => "encloses_obstacle",
            Caution::Coils { .. } => "coils_through_itself",
            Caution::CablePushes => "cable_pushes",
            Caution::Weightless => "weightless",
        }
    }

    /// One sentence, without a capital or a stop, on what is the matter.
    /// `obstacle` names an obstacle by its index.
    pub fn sentence(&self, obstacle: impl Fn(usize) -> String) -> String {
        match *self {
            Caution::Crosses {
                line,
                node,
                obstacle: index,
                depth,
            } => format!(
                "{} is {} inside {}, where the contact candidates do not see it",
                line.part(node),
                shown(depth),
                obstacle(index)
            ),
            Caution::Encloses {
                node,
                obstacle: index,
            } => format!(
                "{} stands between backbone and cable below node {node}, where the contact \
                 candidates do not see it",
                obstacle(index)
            ),
            Caution::Coils { lower, upper } => format!(
                "the robot lies over itself, at nodes {lower} and {upper}: in a plane it cannot"
            ),
            Caution::CablePushes => {
                "the cable would have to push to hold this shape, and a cable can only pull"
                    .to_owned()
            }
            Caution::Weightless => "gravity does nothing: neither the disks nor the backbone have \
                 a mass, which robot.disk_mass_g and robot.backbone_mass_g give them"
                .to_owned(),
        }
    }

    /// What the scene would need, as a line of its file; `None` where no
    /// setting of it helps.
    pub fn remedy(&self) -> Option<&'static str> {
        match self {
            Caution::Crosses { .. } | Caution::Encloses { .. } => {
                Some("contact.candidates = \"body\"")
            }
            Caution::Coils { .. } | Caution::CablePushes | Caution::Weightless => None,
        }
    }
}

/// A depth in millimetres, with two figures where it is small.
fn shown(depth: f64) -> String {
    let depth = millimetres(depth);
    let count = if depth < 0.1 { 4 } else { 2 };
    format!("{} mm", decimals(depth, count))
}

/// A box along the axes.
#[derive(Clone, Copy)]
struct Extent {
    least: Vector,
    most: Vector,
}

impl Extent {
    /// The box that holds nothing.
    const EMPTY: Extent = Extent {
        least: Vector::new(f64::INFINITY, f64::INFINITY),
        most: Vector::new(f64::NEG_INFINITY, f64::NEG_INFINITY),
    };

    fn with(self, point: Vector) -> Self {
        Self {
            least: self.least.inf(&point),
            most: self.most.sup(&point),
        }
    }

    fn joined(self, other: Self) -> Self {
        Self {
            least: self.least.inf(&other.least),
            most: self.most.sup(&other.most),
        }
    }

    fn meets(&self, other: &Self) -> bool {
        let apart = |axis: usize| {
            self.least[axis] > other.most[axis] || other.least[axis] > self.most[axis]
        };
        !apart(0) && !apart(1)
    }
}
