//! What a cut through the robot transmits, by the method of sections: from the
//! shape, the contact forces and the loads alone. It reads no multiplier of a
//! link, so that it checks those of the
//! [certificate](crate::mechanics::Certificate) too.
//!
//! A contact inside a link, or on a straight stretch of cable, is shared by its
//! two ends by the rule of the lever.

mod links;
mod stretches;

use super::statics::Resultant;
use crate::contact::Contact;
use crate::equilibrium::Solved;
use crate::geometry::Vector;
use crate::math::greatest;
use crate::mechanics::{Model, Problem};
use crate::robot::{Element, PlanarNode};

/// What a cut through one segment transmits.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Section {
    /// T_i, the tension of the cable link; of several cables that slide the sum
    /// of those that run through it. In N.
    pub cable: f64,
    /// N_i, the thrust of the backbone, in N, along its link or, of an arc, along
    /// its middle: positive where pressed.
    pub backbone: f64,
    /// The shear of an arc, in N: what what is below exerts across its middle,
    /// positive away from the disks' direction. Links have none.
    pub shear: f64,
    /// C_i, the couple of the bend on what is above, counterclockwise, in N·m.
    pub couple: f64,
    /// What the balance of forces across the backbone link leaves, in N; an arc
    /// holds any force.
    pub residual: f64,
    /// What the balance of moments about the arc's centroid leaves, in N·m; the
    /// cable link's tension is found from it.
    pub moment_residual: f64,
}

/// The sections of all segments, and what the base has to hold.
#[derive(Clone, Debug, PartialEq)]
pub struct Sections {
    /// By segment, base first; n.
    pub sections: Vec<Section>,
    /// The tensions of every cable, in N, base first: of each stretch from disk to
    /// disk or, in the paper's model, of each link.
    pub tensions: Vec<Vec<f64>>,
    /// What the mount of the first disk exerts on the robot.
    pub clamp: Resultant,
    /// What the cables below the first disk exert on the robot, where their
    /// first stretches start.
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
    /// come in rad²/m, the unit of multipliers. Where loads are given in newtons,
    /// they count as such at the stiffness of the robot's own, and grow with any
    /// other: the shape is an equilibrium under these.
    pub fn of(solved: &Solved, per_bend: f64) -> Self {
        match solved.problem().model() {
            Model::Equal => links::sections(solved, per_bend),
            Model::Sliding => stretches::sections(solved, per_bend),
        }
    }

    /// The greatest residual of a section, in N.
    pub fn residual(&self) -> f64 {
        greatest_of(&self.sections, |section| section.residual)
    }

    /// The greatest residual of a section's moments, in N·m.
    pub fn moment_residual(&self) -> f64 {
        greatest_of(&self.sections, |section| section.moment_residual)
    }

    /// The mean tension of the first cable, in N. Of the paper's it is what does the
    /// work when the pull grows, since every link gives 1/n of it.
    pub fn mean_tension(&self) -> f64 {
        let tensions = &self.tensions[0];
        tensions.iter().sum::<f64>() / tensions.len() as f64
    }
}

fn greatest_of(sections: &[Section], of: impl Fn(&Section) -> f64) -> f64 {
    sections.iter().map(of).fold(0.0, greatest)
}

/// The forces of contacts on the nodes that carry them, from tip to base; in a stable
/// order, so that sums do not depend on luck.
fn carried(solved: &Solved, per_bend: f64) -> Vec<Load> {
    let (problem, solution) = (solved.problem(), solved.solution());
    let mut loads: Vec<Load> = Vec::new();
    for contact in &solution.contacts {
        share(problem, &solution.nodes, contact, per_bend, &mut loads);
    }
    sort_from_tip(&mut loads);
    loads
}

fn sort_from_tip(loads: &mut [Load]) {
    loads.sort_by_key(|load| std::cmp::Reverse(load.node));
}

/// A contact's force on the nodes that carry it.
fn share(
    problem: &Problem,
    nodes: &[PlanarNode],
    contact: &Contact,
    per_bend: f64,
    loads: &mut Vec<Load>,
) {
    let force = contact.force(per_bend);
    let node = contact.node;
    let candidate = &problem.candidates()[contact.candidate];
    // Friction acts on the surface; a normal force there does as on the line.
    let down = if contact.friction == 0.0 {
        Vector::zeros()
    } else {
        -candidate.radius * contact.normal
    };
    let mut shared = |upper: usize, lever: f64, along: f64| {
        for (node, part) in [(upper - candidate.span, 1.0 - along), (upper, along)] {
            loads.push(Load {
                node,
                at: nodes[node].at(lever) + down,
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
