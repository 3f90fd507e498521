//! Whether friction is what it can be: in the holes from the shape, the tensions and how
//! much cable was beyond each before the last step, at contacts from their forces and
//! how far they slid in it.

use super::Certifier;
use crate::geometry::{Vector, cross};
use crate::math::greatest;
use crate::mechanics::{CableState, Found, Input, Problem, Slip, Strand};
use crate::robot::Nodes;

/// The tension of a stretch, from 1, in rad²/m.
pub(super) fn tension(state: &CableState, strand: Option<&Strand>, stretch: usize) -> f64 {
    let own = strand.and_then(|strand| strand.tensions.get(stretch - 1));
    own.copied().unwrap_or(state.tension)
}

/// By how much a stretch of a cable yields to a tension of 1 rad²/m, in metres.
pub(super) fn yielding(problem: &Problem, cable: usize) -> f64 {
    let cable = &problem.drive().cables[cable].cable;
    Certifier::per_bend(problem) * cable.compliance / cable.last_disk as f64
}

impl Certifier {
    /// The greatest tension outside what friction allows, relative to the greatest of
    /// its cable. A hole that hardly any cable went through has a cone,
    ///
    /// ```text
    /// η e^{−μ|θ|} ⪯ T/T′ ⪯ e^{μ|θ|}/η
    /// ```
    ///
    /// with η at the base only; any other is at the edge that resists the motion.
    pub(super) fn outside_cones<N: Nodes + ?Sized>(
        &self,
        problem: &Problem,
        found: &Found<'_, N>,
    ) -> f64 {
        if found.strands.len() != problem.drive().cables.len() {
            return f64::NAN;
        }
        let mut worst = 0.0;
        for (index, strand) in found.strands.iter().enumerate() {
            let cable = &problem.drive().cables[index].cable;
            let sizes = [&strand.tensions, &strand.before].map(Vec::len);
            if sizes != [cable.last_disk; 2] || strand.slips.len() != cable.last_disk {
                return f64::NAN;
            }
            worst = greatest(worst, self.outside_cones_of(problem, index, strand));
        }
        worst
    }

    fn outside_cones_of(&self, problem: &Problem, index: usize, strand: &Strand) -> f64 {
        let bay = problem.robot().segments_per_bay;
        let friction = &problem.drive().friction;
        let driven = &problem.drive().cables[index];
        let hole = |k: usize| self.nodes[k * bay].at(driven.cable.offset);
        let straight = problem.robot().segment_length() * bay as f64;
        let yielding = yielding(problem, index);
        let given = strand.load.max(f64::MIN_POSITIVE);
        let most = strand.tensions.iter().fold(given, |a, b| a.max(*b));
        let (mut worst, mut drawn) = (0.0, 0.0);
        for k in (0..strand.tensions.len()).rev() {
            let along = hole(k + 1) - hole(k);
            let beyond = strand.tensions[k];
            drawn += straight - along.norm() + yielding * beyond;
            let (from, below, kept) = match k {
                0 => (
                    self.nodes[0].normal(),
                    strand.load,
                    1.0 - friction.base_loss,
                ),
                _ => (hole(k) - hole(k - 1), strand.tensions[k - 1], 1.0),
            };
            let ratio = kept * libm::exp(-friction.holes * turned(from, along));
            // Products, so that no quotient of nothing by nothing is met.
            let (least, greatest_there) = (ratio * below - beyond, ratio * beyond - below);
            let slip = Slip::of(drawn - strand.before[k]);
            let is_loose = beyond == 0.0 && below == 0.0;
            let off = match slip {
                Slip::Sticks => greatest(least, greatest_there),
                Slip::In => least.abs(),
                Slip::Out => greatest_there.abs(),
            };
            let told_otherwise = slip != strand.slips[k];
            let missed = if is_loose {
                0.0
            } else if told_otherwise {
                1.0
            } else {
                greatest(off, 0.0) / most
            };
            worst = greatest(worst, missed);
        }
        // A load that is given is the one that the base's hole sees.
        if let Input::Load(load) = driven.input {
            let given = load / Self::per_bend(problem);
            worst = greatest(worst, (strand.load - given).abs() / greatest(most, given));
        }
        worst
    }
}

/// The greatest friction of a contact beyond what its normal force allows or, where the
/// robot slides, off what resists it, relative to the greatest of all forces.
pub(super) fn outside_contact_cones<N: ?Sized>(problem: &Problem, found: &Found<'_, N>) -> f64 {
    let contacts = found.contacts;
    let coefficient = problem.drive().friction.contacts;
    let normal = contacts.iter().map(|contact| contact.multiplier);
    let along = found.cables.iter().map(|cable| cable.tension);
    let most = normal.chain(along).fold(f64::MIN_POSITIVE, f64::max);
    let mut worst = 0.0;
    for contact in contacts {
        let limit = coefficient * contact.multiplier;
        let off = match Slip::of(contact.slid) {
            Slip::Sticks => contact.friction.abs() - limit,
            Slip::In => (contact.friction + limit).abs(),
            Slip::Out => (contact.friction - limit).abs(),
        };
        worst = greatest(worst, greatest(off, 0.0) / most);
    }
    worst
}

/// The angle between two directions, in radians, at least 0.
fn turned(a: Vector, b: Vector) -> f64 {
    libm::atan2(cross(a, b).abs(), a.dot(&b))
}
