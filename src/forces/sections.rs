//! The links' forces by the method of sections, from the shape and the contact
//! forces alone. It reads no multiplier of a link, so that it checks those of
//! the [certificate](crate::mechanics::Certificate) too.
//!
//! Cut through segment i and look at what is above: the contact forces there,
//! the cable link's pull T_i, the backbone link's thrust N_i and the couple C_i
//! of the bend balance,
//!
//! ```text
//! Σ f_j + N_i b_i − T_i k_i = 0
//! Σ (q_j − p_i) × f_j + C_i − (c_i − p_i) × T_i k_i = 0      C_i = (EI/l_0) β_i
//! ```
//!
//! with b_i, k_i the links' directions towards the tip. The second equation
//! gives T_i, the first along b_i gives N_i. The first across b_i has no
//! unknown left: what it leaves is the section's residual, zero only at an
//! equilibrium. (Both forces from the first alone would fail: the links are
//! parallel where nothing touches.)
//!
//! The links transmit forces along themselves only. A contact inside a link
//! is shared by its two ends by the rule of the lever.

use super::statics::Resultant;
use crate::contact::Contact;
use crate::equilibrium::Solved;
use crate::geometry::{Vector, cross, perpendicular};
use crate::mechanics::Problem;
use crate::robot::{Element, PlanarNode};

/// What a cut through one segment transmits.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Section {
    /// T_i, the tension of the cable link, in N.
    pub cable: f64,
    /// N_i, the thrust of the backbone link, in N: positive where pressed.
    pub backbone: f64,
    /// C_i, the couple of the bend on what is above, counterclockwise, in N·m.
    pub couple: f64,
    /// What the balance of forces across the backbone link leaves, in N.
    pub residual: f64,
}

/// The sections of all segments, and what the base has to hold.
#[derive(Clone, Debug, PartialEq)]
pub struct Sections {
    /// By segment, base first; n.
    pub sections: Vec<Section>,
    /// What the mount of the first disk exerts on the robot.
    pub clamp: Resultant,
    /// What the cable below the first disk exerts on the robot, where its
    /// first link starts.
    pub cable: Resultant,
}

/// A force on one node's side of a cut.
struct Load {
    node: usize,
    at: Vector,
    force: Vector,
}

impl Sections {
    /// The sections of a shape. `per_bend` is EI/2l_0, in N·m; with 1, forces
    /// come in rad²/m, the unit of multipliers.
    pub fn of(solved: &Solved, per_bend: f64) -> Self {
        let (problem, solution) = (solved.problem(), solved.solution());
        let nodes = &solution.nodes;
        let offset = problem.robot().offset;
        let mut loads: Vec<Load> = Vec::new();
        for contact in &solution.contacts {
            share(problem, nodes, contact, per_bend, &mut loads);
        }
        // From tip to base; stable, so that sums do not depend on luck.
        loads.sort_by_key(|load| std::cmp::Reverse(load.node));
        let mut above = loads.iter().peekable();
        let (mut force, mut moment) = (Vector::zeros(), 0.0);
        let origin = nodes[0].position;
        let mut sections = vec![Section::default(); nodes.len() - 1];
        for i in (1..nodes.len()).rev() {
            while let Some(load) = above.next_if(|load| load.node >= i) {
                force += load.force;
                moment += cross(load.at - origin, load.force);
            }
            let backbone = (nodes[i].position - nodes[i - 1].position).normalize();
            let cable = (nodes[i].at(offset) - nodes[i - 1].at(offset)).normalize();
            let about_node = moment - cross(nodes[i].position - origin, force);
            let couple = 2.0 * per_bend * solution.bends[i - 1];
            let tension = (about_node + couple) / cross(offset * nodes[i].disk, cable);
            let left = tension * cable - force;
            sections[i - 1] = Section {
                cable: tension,
                backbone: left.dot(&backbone),
                couple,
                residual: left.dot(&perpendicular(backbone)).abs(),
            };
        }
        let (clamp, cable) = at_base(problem, nodes, &sections[0], above);
        Self {
            sections,
            clamp,
            cable,
        }
    }

    /// The greatest residual of a section, in N.
    pub fn residual(&self) -> f64 {
        self.sections
            .iter()
            .map(|section| section.residual)
            .fold(0.0, f64::max)
    }

    /// The mean tension of the cable links, in N: what does the work when the
    /// pull grows, since every link gives 1/n of it.
    pub fn mean_tension(&self) -> f64 {
        let sum: f64 = self.sections.iter().map(|section| section.cable).sum();
        sum / self.sections.len() as f64
    }
}

/// The mount's and the cable's resultants about the base, from the first
/// section and what touches the first disk itself.
fn at_base<'a>(
    problem: &Problem,
    nodes: &[PlanarNode],
    first: &Section,
    on_base: impl Iterator<Item = &'a Load>,
) -> (Resultant, Resultant) {
    let offset = problem.robot().offset;
    let base = nodes[0];
    let backbone = (nodes[1].position - base.position).normalize();
    let cable = (nodes[1].at(offset) - base.at(offset)).normalize();
    let mut clamp = Resultant {
        force: first.backbone * backbone,
        moment: first.couple,
    };
    for load in on_base {
        clamp.force -= load.force;
        clamp.moment -= cross(load.at - base.position, load.force);
    }
    let pulled = -first.cable * cable;
    let cable = Resultant {
        force: pulled,
        moment: cross(offset * base.disk, pulled),
    };
    (clamp, cable)
}

/// A contact's force on the nodes that carry it.
fn share(
    problem: &Problem,
    nodes: &[PlanarNode],
    contact: &Contact,
    per_bend: f64,
    loads: &mut Vec<Load>,
) {
    let force = per_bend * contact.multiplier * contact.normal;
    let node = contact.node;
    let candidate = &problem.candidates()[contact.candidate];
    let mut shared = |upper: usize, lever: f64, along: f64| {
        for (node, part) in [(upper - candidate.span, 1.0 - along), (upper, along)] {
            loads.push(Load {
                node,
                at: nodes[node].at(lever),
                force: part * force,
            });
        }
    };
    match candidate.element {
        Element::Link { lever } => shared(node, lever, contact.along),
        Element::OnLink { lever, above } => shared(node + above, lever, candidate.share()),
        // The point of the surface lies on the force's line of action.
        Element::Point { .. } | Element::Across { .. } => loads.push(Load {
            node,
            at: contact.point,
            force,
        }),
    }
}
