//! What a certificate asks of the contacts, whatever bends the robot: by the exact
//! distance of every part, whatever rows a solver chose.

use super::certificate::Certificate;
use super::condition::Condition;
use super::problem::Problem;
use crate::contact::Contact;
use crate::geometry::Vector;
use crate::math::greatest;
use crate::robot::{Candidate, Element};

/// Sets the conditions of the obstacles: nothing is inside of them, what presses
/// touches, and presses only away from them. `ends` gives a candidate's two ends, the
/// same for a point.
pub(super) fn certify_contacts(
    problem: &Problem,
    contacts: &[Contact],
    ends: impl Fn(&Candidate) -> (Vector, Vector),
    certificate: &mut Certificate,
) {
    let length = problem.length();
    let sizes = contacts.iter().map(|contact| contact.multiplier.abs());
    let most = sizes.fold(0.0, f64::max);
    let (mut complementarity, mut dual) = (0.0, 0.0);
    for contact in contacts {
        let share = contact.multiplier / most.max(f64::MIN_POSITIVE);
        dual = greatest(dual, -share);
        let candidate = &problem.candidates()[contact.candidate];
        let gap = share.abs() * gap(problem, contact, ends(candidate)) / length;
        complementarity = greatest(complementarity, gap);
    }
    certificate.set(Condition::Penetration, penetration(problem, &ends) / length);
    certificate.set(Condition::Complementarity, complementarity);
    certificate.set(Condition::Dual, dual);
}

/// How far a contact is from touching where its force acts, in metres: along its
/// normal from the obstacle to the whole candidate, which no other direction exceeds,
/// or at the point of the candidate that is pressed.
fn gap(problem: &Problem, contact: &Contact, (start, end): (Vector, Vector)) -> f64 {
    let candidate = &problem.candidates()[contact.candidate];
    let obstacle = &problem.obstacles()[contact.obstacle];
    let normal = contact.normal;
    // A wall reaches as far as it likes but along its normal.
    let surface = obstacle.support(normal).unwrap_or(f64::INFINITY) + candidate.radius;
    let along_normal = normal.dot(&start).min(normal.dot(&end)) - surface;
    let pressed = start + contact.along * (end - start);
    let there = obstacle.clearance(pressed).distance - candidate.radius;
    greatest(along_normal.abs(), there.abs())
}

/// The greatest depth of a candidate inside an obstacle, in metres, at least 0.
fn penetration(problem: &Problem, ends: impl Fn(&Candidate) -> (Vector, Vector)) -> f64 {
    let mut deepest = 0.0_f64;
    for candidate in problem.candidates() {
        let (start, end) = ends(candidate);
        for obstacle in problem.obstacles() {
            let near = candidate.radius + (end - start).norm();
            if obstacle.is_beyond(start, near) {
                continue;
            }
            let distance = match candidate.element {
                Element::Point { .. } | Element::OnLink { .. } => {
                    obstacle.clearance(start).distance
                }
                Element::Link { .. } | Element::Across { .. } => obstacle.edge_distance(start, end),
            };
            // The base cannot move, and is no candidate: a scene that covers it is
            // refused. Of the links that start there, what is deeper counts.
            let at_base = match candidate.element {
                Element::Link { .. } if candidate.node == candidate.span => {
                    let start = obstacle.clearance(start).distance;
                    (candidate.radius - start).max(0.0)
                }
                _ => 0.0,
            };
            deepest = greatest(deepest, candidate.radius - distance - at_base);
        }
    }
    deepest
}
