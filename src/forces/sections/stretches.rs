//! The forces in a robot whose cables slide: from disk to disk each cable is straight
//! and as tense as the multiplier of its length says and friction in its holes leaves.
//!
//! Cut through arc i and look at what is beyond: contacts, loads, and at every hole
//! the tensions of the stretches on both sides of it, along them. The cut backbone
//! holds any force, so that their sum gives its thrust and its shear; the moment about
//! the arc's centroid is what bends it, since a uniform change of its curvature turns
//! what is beyond about that point:
//!
//! ```text
//! Σ f_j + R_i = 0
//! Σ (q_j − g_i) × f_j + C_i = 0      C_i = (EI/l) b_i
//! ```
//!
//! What the second leaves is the section's residual.

use super::{Load, Section, Sections, carried, sort_from_tip};
use crate::equilibrium::Solved;
use crate::forces::statics::Resultant;
use crate::geometry::{Vector, cross, perpendicular};
use crate::mechanics::Problem;
use crate::robot::PlanarNode;

/// Nodes and weights of Gauss and Legendre's rule of four points on \[0, 1\]: exact to
/// rounding for an arc of half a radian, and to 1e-12 of it for one of two.
const GAUSS: [(f64, f64); 4] = [
    (0.069_431_844_202_973_71, 0.173_927_422_568_726_93),
    (0.330_009_478_207_571_87, 0.326_072_577_431_273_07),
    (0.669_990_521_792_428_1, 0.326_072_577_431_273_07),
    (0.930_568_155_797_026_3, 0.173_927_422_568_726_93),
];

/// The sections of a shape with sliding cables.
pub(super) fn sections(solved: &Solved, per_bend: f64) -> Sections {
    let (problem, solution) = (solved.problem(), solved.solution());
    let nodes = &solution.nodes;
    let robot = problem.robot();
    let (bay, length) = (robot.segments_per_bay, robot.segment_length());
    let base = nodes[0];
    let mut loads = carried(solved, per_bend);
    let mut cable = Resultant::default();
    let mut tensions: Vec<Vec<f64>> = Vec::new();
    let drive = problem.drive();
    for (index, driven) in drive.cables.iter().enumerate() {
        let (offset, last) = (driven.cable.offset, driven.cable.last_disk);
        let stretches: Vec<f64> = solution.tensions(index);
        let pulls = (1..=last).map(|k| {
            let (low, high) = (nodes[(k - 1) * bay].at(offset), nodes[k * bay].at(offset));
            per_bend * stretches[k - 1] * (high - low).normalize()
        });
        for (k, pull) in pulls.enumerate() {
            let mut hole = |disk: usize, force| {
                let node = disk * bay;
                loads.push(Load {
                    node,
                    at: nodes[node].at(offset),
                    force,
                });
            };
            hole(k + 1, -pull);
            if k > 0 {
                hole(k, pull);
            } else {
                cable.force -= pull;
                cable.moment -= cross(offset * base.disk, pull);
            }
        }
        tensions.push(stretches.iter().map(|tension| per_bend * tension).collect());
    }
    let scale = newtons(problem, per_bend);
    add_weights(problem, nodes, scale, &mut loads);
    sort_from_tip(&mut loads);
    let mut above = loads.iter().peekable();
    let mut force = Vector::zeros();
    // Counterclockwise about the base.
    let mut moment = -scale * drive.loads.tip_moment;
    let mut sections = vec![Section::default(); nodes.len() - 1];
    let mut clamp = Resultant::default();
    for i in (1..nodes.len()).rev() {
        while let Some(load) = above.next_if(|load| load.node >= i) {
            force += load.force;
            moment += cross(load.at - base.position, load.force);
        }
        let (from, bend) = (&nodes[i - 1], solution.bends[i - 1]);
        let arm = from.position - base.position + length * centroid(from, bend);
        let couple = 2.0 * per_bend * bend;
        let (sine, cosine) = libm::sincos(from.angle - 0.5 * bend);
        let disk = Vector::new(cosine, sine);
        let through = tensions.iter().filter(|all| i <= all.len() * bay);
        sections[i - 1] = Section {
            cable: through.map(|all| all[(i - 1) / bay]).sum(),
            backbone: -force.dot(&perpendicular(disk)),
            shear: force.dot(&disk),
            couple,
            residual: 0.0,
            moment_residual: (moment - cross(arm, force) + couple).abs(),
        };
        clamp = Resultant {
            force: -force,
            moment: couple - cross(arm, force),
        };
    }
    // What touches the first disk itself, and its share of the first arc's weight.
    for load in above {
        clamp.force -= load.force;
        clamp.moment -= cross(load.at - base.position, load.force);
    }
    Sections {
        sections,
        tensions,
        clamp,
        cable,
    }
}

/// What a newton of load counts, in the unit that `per_bend` gives forces.
pub(super) fn newtons(problem: &Problem, per_bend: f64) -> f64 {
    let stiffness = problem.drive().stiffness;
    let own = stiffness.map(|stiffness| stiffness / (2.0 * problem.robot().segment_length()));
    own.map_or(0.0, |own| per_bend / own)
}

/// The dead loads by node: an arc's weight is shared by its ends.
fn add_weights(problem: &Problem, nodes: &[PlanarNode], scale: f64, loads: &mut Vec<Load>) {
    let (robot, given) = (problem.robot(), &problem.drive().loads);
    let arc = given.backbone / robot.segments as f64;
    let last = nodes.len() - 1;
    for (node, place) in nodes.iter().enumerate() {
        let is_end = node == 0 || node == last;
        let mut force = if is_end { 0.5 * arc } else { arc };
        if node > 0 && robot.has_disk(node) {
            force += given.disk;
        }
        if node == last {
            force += given.tip_force;
        }
        if force != Vector::zeros() {
            loads.push(Load {
                node,
                at: place.position,
                force: scale * force,
            });
        }
    }
}

/// The centroid of an arc of unit length from its start.
fn centroid(from: &PlanarNode, bend: f64) -> Vector {
    // Of the points ∫₀ˢ t(σ) dσ the mean is ∫ (1 − s) t(s) ds.
    let part = |(share, weight): (f64, f64)| {
        let (sine, cosine) = libm::sincos(from.angle - share * bend);
        weight * (1.0 - share) * Vector::new(-sine, cosine)
    };
    GAUSS.into_iter().map(part).sum()
}
