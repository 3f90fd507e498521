//! Multipliers as forces: what presses where, the cable's tension, what the
//! base holds, and whether all of it balances.
//!
//! With U = (EI/2l_0) J and J = Σ β_i², and λ_i how J rises with the clearance
//! asked for at contact i,
//!
//! ```text
//! F_i = (EI/2l_0) λ_i          along the normal out of the obstacle
//! T   = (EI/2l_0) dJ/dl        the cable's tension (envelope theorem)
//! ```
//!
//! so that F_i/T is free of EI. A cable that slides has one tension all along. The
//! paper's model shortens every cable segment equally, as if the cable were held in
//! every disk: the links' tensions differ along the robot ([`Statics::tensions`]),
//! and T, which does the work, is their mean.
//!
//! Differs from the paper: it reads forces off virtual work only
//! ([`super::VirtualWork`]) and uses multipliers just to find the contacts.

use super::sections::{Section, Sections};
use super::stiffness::Stiffness;
use crate::contact::Contact;
use crate::equilibrium::{Solution, Solved};
use crate::geometry::{Vector, cross};
use crate::math::greatest;

/// A force and a couple: what a set of forces amounts to, about the base node.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Resultant {
    /// The force, in N.
    pub force: Vector,
    /// The moment about the base node, counterclockwise, in N·m.
    pub moment: f64,
}

impl Default for Resultant {
    fn default() -> Self {
        Self {
            force: Vector::zeros(),
            moment: 0.0,
        }
    }
}

/// A contact with its force.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ContactForce {
    /// The contact: part, obstacle, point and normal.
    pub contact: Contact,
    /// What the obstacle exerts on the robot, in N: along the contact's normal, and
    /// friction across it.
    pub on_robot: Vector,
    /// The normal force F, in N, ≥ 0.
    pub normal_force: f64,
}

/// The forces on a robot of known stiffness.
#[derive(Clone, Debug, PartialEq)]
pub struct Statics {
    /// By contact, in the solution's order.
    pub contacts: Vec<ContactForce>,
    /// T, the first cable's tension, in N; in the paper's model negative where the
    /// cable would have to push, as it does at a negative pull.
    pub tension: f64,
    /// The tensions of every cable, in N, base first: of each stretch from disk to
    /// disk or, in the paper's model, of each link.
    pub tensions: Vec<Vec<f64>>,
    /// What the contacts exert on the robot, all together.
    pub pressed: Resultant,
    /// What the mount of the first disk exerts on the robot: the paper's R_x,
    /// R_y and M_r.
    pub clamp: Resultant,
    /// What the cables below the first disk exert on the robot.
    pub cable: Resultant,
    /// What weight, and force and moment on the tip, amount to.
    pub loads: Resultant,
    /// By segment, base first: what a cut through it transmits; n.
    pub sections: Vec<Section>,
    /// What is left of the sum of all forces, and of every section's, relative
    /// to the largest force.
    pub unbalanced_force: f64,
    /// What is left of the sum of all moments about the base, and of every
    /// section's, relative to the largest moment.
    pub unbalanced_moment: f64,
}

impl Statics {
    /// Relative size of what may be left of sums that should vanish: the
    /// bound of the certificate, which vouches for the shape.
    pub const BOUND: f64 = 1e-9;

    /// The forces on a solution's shape with this stiffness.
    pub fn of(solved: &Solved, stiffness: Stiffness) -> Self {
        Self::of_scale(solved, stiffness.per_bend(solved.problem()))
    }

    /// The same with EI/2l_0 in N·m; with 1, forces come in rad²/m, the unit of
    /// multipliers.
    pub fn of_scale(solved: &Solved, per_bend: f64) -> Self {
        let sections = Sections::of(solved, per_bend);
        let base = solved.nodes[0].position;
        let mut pressed = Resultant::default();
        let contacts: Vec<ContactForce> = solved
            .contacts
            .iter()
            .map(|contact| {
                let normal_force = per_bend * contact.multiplier;
                ContactForce {
                    contact: *contact,
                    on_robot: contact.force(per_bend),
                    normal_force,
                }
            })
            .collect();
        // The largest of anything that is summed, so that sums of large
        // forces that cancel are not called unbalanced for their rounding.
        let (mut largest, mut largest_moment) = (0.0_f64, 0.0_f64);
        for force in &contacts {
            let moment = cross(force.contact.point - base, force.on_robot);
            pressed.force += force.on_robot;
            pressed.moment += moment;
            largest = largest.max(force.on_robot.norm());
            largest_moment = largest_moment.max(moment.abs());
        }
        let (clamp, cable, loads) = (sections.clamp, sections.cable, loads(solved, per_bend));
        for resultant in [clamp, cable, loads] {
            largest = largest.max(resultant.force.norm());
            largest_moment = largest_moment.max(resultant.moment.abs());
        }
        let force = (pressed.force + clamp.force + cable.force + loads.force).norm();
        let moment = (pressed.moment + clamp.moment + cable.moment + loads.moment).abs();
        let moment = greatest(moment, sections.moment_residual());
        Self {
            contacts,
            tension: per_bend * solved.energy_slope(),
            pressed,
            clamp,
            cable,
            loads,
            unbalanced_force: relative(greatest(force, sections.residual()), largest),
            unbalanced_moment: relative(moment, largest_moment),
            tensions: sections.tensions,
            sections: sections.sections,
        }
    }

    /// Whether forces and moments sum to zero, to [`Statics::BOUND`] of the
    /// largest.
    pub fn balances(&self) -> bool {
        greatest(self.unbalanced_force, self.unbalanced_moment) <= Self::BOUND
    }
}

/// What the dead loads amount to, in the unit that `per_bend` gives forces.
fn loads(solved: &Solved, per_bend: f64) -> Resultant {
    let problem = solved.problem();
    let (robot, drive) = (problem.robot(), problem.drive());
    let mut sum = Resultant::default();
    let Some(stiffness) = drive.stiffness.filter(|_| drive.loads.any()) else {
        return sum;
    };
    let scale = per_bend * 2.0 * robot.segment_length() / stiffness;
    let given = &drive.loads;
    let base = solved.nodes[0].position;
    let mut add = |at: Vector, force: Vector| {
        sum.force += scale * force;
        sum.moment += scale * cross(at - base, force);
    };
    add(solved.tip().position, given.tip_force);
    let disks = solved.nodes.iter().skip(1);
    for node in disks
        .skip(robot.segments_per_bay - 1)
        .step_by(robot.segments_per_bay)
    {
        add(node.position, given.disk);
    }
    for ends in solved.nodes.windows(2) {
        let middle = 0.5 * (ends[0].position + ends[1].position);
        add(middle, given.backbone / robot.segments as f64);
    }
    sum.moment -= scale * given.tip_moment;
    sum
}

/// F/T of a contact, a pure number, which needs no stiffness; `None` where the first cable
/// carries no tension.
pub fn share_of_tension(solution: &Solution, contact: &Contact) -> Option<f64> {
    let slope = solution.energy_slope();
    (slope != 0.0).then(|| contact.multiplier / slope)
}

fn relative(left: f64, largest: f64) -> f64 {
    if largest > 0.0 { left / largest } else { left }
}
