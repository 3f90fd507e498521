//! The forces of the paper's links, from the shape and the contact forces alone.
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
//! The links transmit forces along themselves only.

use super::{Load, Section, Sections, carried};
use crate::equilibrium::Solved;
use crate::forces::statics::Resultant;
use crate::geometry::{Vector, cross, perpendicular};
use crate::mechanics::Problem;
use crate::robot::PlanarNode;

/// The sections of a shape of the paper's model.
pub(super) fn sections(solved: &Solved, per_bend: f64) -> Sections {
    let (problem, solution) = (solved.problem(), solved.solution());
    let nodes = &solution.nodes;
    let offset = problem.robot().offset;
    let loads = carried(solved, per_bend);
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
            ..Section::default()
        };
    }
    let (clamp, cable) = at_base(problem, nodes, &sections[0], above);
    Sections {
        tensions: vec![sections.iter().map(|section| section.cable).collect()],
        sections,
        clamp,
        cable,
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
