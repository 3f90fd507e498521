//! The certificate of the robot with sliding cables, from the shape alone: forces and
//! moments on every part, cable lengths, obstacles. It shares nothing with the solver
//! but the obstacles' outlines.
//!
//! Cut an arc i off below: of all that acts beyond it the moment about the arc's
//! centroid is what bends it, since a uniform change of its curvature turns what is
//! beyond about that point.
//!
//! ```text
//! (EI/l) b_i = Σ (x_j − g_i) × f_j      clockwise, over all forces beyond arc i
//! ```
//!
//! The forces are those of contacts, of loads, and of the cables on the holes: at each
//! the tensions of the stretches on both sides of it, along them.

mod friction;
mod minimum;
#[cfg(test)]
mod tests;

use super::chain::Sliding;
use crate::geometry::{Vector, cross};
use crate::math::greatest;
use crate::mechanics::touching::certify_contacts;
use crate::mechanics::{CableState, Certificate, Condition, Found, Input, Problem};
use crate::robot::{Candidate, Element, Nodes, PlanarNode};

/// Bends below this, in radians, drown in the rounding of coordinates: the residual is
/// relative to the moment of a bend of at least this much.
const LEAST_BEND: f64 = 1e-5;
/// Moments of forces that cancel are rounded like their largest term; this share of it
/// counts as a moment to compare with.
const CANCELLING: f64 = 1e-4;

/// Storage of a certificate, kept between calls.
#[derive(Clone, Debug, Default)]
pub struct Certifier {
    nodes: Vec<PlanarNode>,
    /// Forces by the node that they move with, in rad²/m.
    forces: Vec<(usize, Vector, Vector)>,
    elimination: minimum::Elimination,
}

impl Certifier {
    /// The certificate of what was found.
    pub(super) fn certify<N: Nodes + ?Sized, const NU: usize>(
        &mut self,
        sliding: &Sliding<NU>,
        found: Found<'_, N>,
    ) -> Certificate {
        let problem = sliding.problem();
        self.nodes.clear();
        self.nodes.extend(found.nodes.each());
        let length = problem.length();
        self.forces.clear();
        self.add_contacts(problem, &found);
        self.add_loads(problem);
        let stretches = self.add_cables(problem, &found);
        let mut certificate = Certificate::default();
        certificate.set(Condition::Stationarity, self.imbalance(problem));
        let lengths = self.lengths(problem, &found);
        let links = greatest(self.arc_error(problem), lengths) / length;
        certificate.set(Condition::Links, links);
        let ends = |candidate: &Candidate| candidate.ends(&self.nodes);
        certify_contacts(problem, found.contacts, ends, &mut certificate);
        let contacts = certificate.get(Condition::Dual).unwrap_or(0.0);
        certificate.set(Condition::Dual, greatest(contacts, pushing(found.cables)));
        certificate.set(Condition::Orientation, stretches);
        if !problem.drive().friction.is_none() {
            let holes = self.outside_cones(problem, &found);
            let contacts = friction::outside_contact_cones(problem, &found);
            certificate.set(Condition::Friction, greatest(holes, contacts));
        }
        let is_minimum = self.is_minimum(problem, found.contacts, (found.cables, found.strands));
        certificate.set(Condition::Minimum, is_minimum);
        certificate.energy_slope = found.cables.first().map_or(0.0, |cable| cable.tension);
        certificate
    }

    fn bend(&self, i: usize) -> f64 {
        self.nodes[i - 1].angle - self.nodes[i].angle
    }

    /// EI/2l, in N m, which turns newtons into rad²/m; 0 where EI is not known.
    fn per_bend(problem: &Problem) -> f64 {
        let segment = problem.robot().segment_length();
        problem
            .drive()
            .stiffness
            .map_or(0.0, |stiffness| stiffness / (2.0 * segment))
    }

    /// The greatest error of an arc's step, or of a disk's direction times the length
    /// of an arc, in metres.
    fn arc_error(&self, problem: &Problem) -> f64 {
        let arc = problem.robot().segment_length();
        let mut worst = 0.0;
        for i in 1..self.nodes.len() {
            let (from, to) = (&self.nodes[i - 1], &self.nodes[i]);
            let half = 0.5 * self.bend(i);
            // The chord stands on the direction half way.
            let sinc = if half == 0.0 {
                1.0
            } else {
                libm::sin(half) / half
            };
            let (sine, cosine) = libm::sincos(from.angle - half);
            let chord = arc * sinc * Vector::new(-sine, cosine);
            let (sine, cosine) = libm::sincos(to.angle);
            let turned = (to.disk - Vector::new(cosine, sine)).norm() * arc;
            let missed = (to.position - from.position - chord).norm();
            worst = greatest(worst, greatest(missed, turned));
        }
        worst
    }

    fn add_contacts<N: Nodes + ?Sized>(&mut self, problem: &Problem, found: &Found<'_, N>) {
        for contact in found.contacts {
            let candidate = &problem.candidates()[contact.candidate];
            let force = contact.force(1.0);
            // Friction acts on the surface.
            let down = -candidate.radius * contact.normal;
            let (start, end) = candidate.ends(&self.nodes);
            let along = match candidate.element {
                Element::Point { .. } | Element::Across { .. } => {
                    let point = start + contact.along * (end - start) + down;
                    self.forces.push((candidate.node, point, force));
                    continue;
                }
                Element::Link { .. } => contact.along,
                Element::OnLink { .. } => candidate.share(),
            };
            let (upper, lever) = match candidate.element {
                Element::OnLink { lever, above } => (candidate.node + above, lever),
                Element::Link { lever } => (candidate.node, lever),
                Element::Point { lever } | Element::Across { lever } => (candidate.node, lever),
            };
            // A force on a link is shared by its ends by the rule of the lever.
            for (node, share) in [(upper - candidate.span, 1.0 - along), (upper, along)] {
                let point = self.nodes[node].at(lever) + down;
                self.forces.push((node, point, share * force));
            }
        }
    }

    fn add_loads(&mut self, problem: &Problem) {
        let loads = &problem.drive().loads;
        if !loads.any() {
            return;
        }
        let unit = Self::per_bend(problem);
        let robot = problem.robot();
        let arc = loads.backbone / robot.segments as f64;
        for i in 1..self.nodes.len() {
            let tip = i + 1 == self.nodes.len();
            let mut force = if tip {
                0.5 * arc + loads.tip_force
            } else {
                arc
            };
            if robot.has_disk(i) {
                force += loads.disk;
            }
            self.forces.push((i, self.nodes[i].position, force / unit));
        }
    }

    /// Adds the forces of the cables on the holes. Returns whether every stretch runs
    /// towards the tip.
    fn add_cables<N: Nodes + ?Sized>(&mut self, problem: &Problem, found: &Found<'_, N>) -> bool {
        let bay = problem.robot().segments_per_bay;
        let mut forward = true;
        let driven = problem.drive().cables.iter().zip(found.cables);
        for (index, (driven, state)) in driven.enumerate() {
            let cable = &driven.cable;
            for k in 1..=cable.last_disk {
                let tension = friction::tension(state, found.strands.get(index), k);
                let (below, above) = ((k - 1) * bay, k * bay);
                let (low, high) = (&self.nodes[below], &self.nodes[above]);
                let (from, to) = (low.at(cable.offset), high.at(cable.offset));
                let direction = (to - from).normalize();
                forward &= direction.dot(&(low.normal() + high.normal())) > 0.0;
                self.forces.push((above, to, -tension * direction));
                self.forces.push((below, from, tension * direction));
            }
        }
        forward
    }

    /// The greatest difference between the moment beyond an arc and its bend's,
    /// relative to the greatest of the moments.
    fn imbalance(&mut self, problem: &Problem) -> f64 {
        let arc = problem.robot().segment_length();
        let base = self.nodes[0].position;
        self.forces
            .sort_by_key(|(node, ..)| std::cmp::Reverse(*node));
        let moment = problem.drive().loads.tip_moment;
        let unit = Self::per_bend(problem);
        // Clockwise about the base.
        let mut turning = if moment == 0.0 { 0.0 } else { moment / unit };
        let mut force = Vector::zeros();
        let mut next = self.forces.iter().peekable();
        let (mut worst, mut largest) = (0.0_f64, 2.0 * LEAST_BEND);
        for i in (1..self.nodes.len()).rev() {
            while let Some((_, point, push)) = next.next_if(|(node, ..)| *node >= i) {
                let moment = cross(point - base, *push);
                largest = largest.max(CANCELLING * moment.abs());
                turning -= moment;
                force += push;
            }
            let bend = self.bend(i);
            let (from, to) = (&self.nodes[i - 1], &self.nodes[i]);
            let middle = 0.5 * (from.position + to.position);
            let outwards = -(from.disk + to.disk).normalize();
            let centroid = middle + arc * bulge(bend) * outwards;
            let about = turning + cross(centroid - base, force);
            largest = largest.max(2.0 * bend.abs());
            worst = greatest(worst, (about - 2.0 * bend).abs());
        }
        worst / largest
    }

    /// The greatest length by which a cable under pull is too long or, where it is
    /// tense, too short, in metres.
    fn lengths<N: Nodes + ?Sized>(&self, problem: &Problem, found: &Found<'_, N>) -> f64 {
        let bay = problem.robot().segments_per_bay;
        let mut worst = 0.0;
        let driven = problem.drive().cables.iter().zip(found.cables);
        for (index, (driven, state)) in driven.enumerate() {
            let Input::Pull(pull) = driven.input else {
                continue;
            };
            let cable = &driven.cable;
            let straight = problem.robot().segment_length() * (cable.last_disk * bay) as f64;
            let hole = |k: usize| self.nodes[k * bay].at(cable.offset);
            let length: f64 = (1..=cable.last_disk)
                .map(|k| (hole(k) - hole(k - 1)).norm())
                .sum();
            let strand = found.strands.get(index);
            let tensions = (1..=cable.last_disk).map(|k| friction::tension(state, strand, k));
            let stretch = friction::yielding(problem, index) * tensions.sum::<f64>();
            let spare = straight - pull + stretch - length;
            // Whatever it is told to be: what carries no tension may be longer than it need.
            let left = if state.tension == 0.0 {
                greatest(-spare, 0.0)
            } else {
                spare.abs()
            };
            worst = greatest(worst, left);
        }
        worst
    }
}

/// Whether a shape with sliding cables would rest, too, were the tension of every
/// cable held, as a weight holds it, and not its length: whether it is a minimum then.
pub fn rests_under_load(problem: &Problem, found: Found<'_, [PlanarNode]>) -> bool {
    let mut problem = problem.clone();
    let mut drive = problem.drive().clone();
    // Where nothing is given in newtons, any stiffness does.
    drive.stiffness.get_or_insert(1.0);
    problem.set_drive(&drive);
    let unit = Certifier::per_bend(&problem);
    for (driven, state) in drive.cables.iter_mut().zip(found.cables) {
        driven.input = Input::Load(unit * state.load);
    }
    problem.set_drive(&drive);
    let certificate = Certifier::default().certify(&Sliding::<2>::of(problem), found);
    certificate.get(Condition::Minimum) == Some(1.0)
}

/// The greatest tension below zero, relative to the greatest of all.
fn pushing(cables: &[CableState]) -> f64 {
    let sizes = cables.iter().map(|cable| cable.tension.abs());
    let most = sizes.fold(f64::MIN_POSITIVE, f64::max);
    cables
        .iter()
        .map(|cable| -cable.tension / most)
        .fold(0.0, greatest)
}

/// How far the centroid of an arc of unit length is from the middle of its chord, away
/// from the side it bends to: (sinc(b/2) − cos(b/2))/b.
fn bulge(bend: f64) -> f64 {
    let half = 0.5 * bend;
    if half.abs() < 0.05 {
        // The next term of the series is 1e-13 of the first there.
        let x = half * half;
        return 0.5 * half * (1.0 / 3.0 - x * (1.0 / 30.0 - x * (1.0 / 840.0 - x / 45_360.0)));
    }
    (libm::sin(half) / half - libm::cos(half)) / bend
}
