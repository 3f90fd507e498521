//! The contacts' part of the certificate: −Σ λ g, its gradient and its
//! curvature in the paper's coordinates.

use super::{Block, Certifier, Gradient, Pair, pair};
use crate::contact::Contact;
use crate::geometry::{Edge, Vector, perpendicular};
use crate::mechanics::Problem;
use crate::robot::Element;

impl Certifier {
    /// Subtracts Σ λ g.
    pub(super) fn add_contacts(&mut self, problem: &Problem, contacts: &[Contact]) {
        self.pressing.clear();
        let offset = problem.robot().offset;
        for contact in contacts {
            let candidate = &problem.candidates()[contact.candidate];
            let i = contact.node;
            // A point at lever o of a disk is x_0 + (o/a)(x_a − x_0).
            let at = |force: Vector, lever: f64| {
                let share = lever / offset;
                pair((1.0 - share) * force, share * force)
            };
            let normal = contact.normal;
            let along = contact.along;
            let (gradient, ends) = match candidate.element {
                Element::Point { lever } | Element::OnLink { lever, .. } => (
                    Gradient {
                        after: at(normal, lever),
                        before: Pair::zeros(),
                    },
                    None,
                ),
                Element::Link { lever } => (
                    Gradient {
                        after: at(along * normal, lever),
                        before: at((1.0 - along) * normal, lever),
                    },
                    Some(((i - 1, lever), (i, lever))),
                ),
                Element::Across { lever } => (
                    Gradient {
                        after: at(along * normal, lever) + at((1.0 - along) * normal, -lever),
                        before: Pair::zeros(),
                    },
                    Some(((i, -lever), (i, lever))),
                ),
            };
            self.balance[i] -= contact.multiplier * gradient.after;
            self.balance[i - 1] -= contact.multiplier * gradient.before;
            if contact.multiplier > 0.0 {
                self.pressing.push((i, gradient));
                match ends {
                    None => self.bend_of_point(problem, contact, offset),
                    Some(ends) => self.bend_of_edge(problem, contact, ends, offset),
                }
            }
        }
    }

    /// Subtracts λ∇²g of a point: the obstacle's curvature along its surface.
    pub(super) fn bend_of_point(&mut self, problem: &Problem, contact: &Contact, offset: f64) {
        let candidate = &problem.candidates()[contact.candidate];
        let Element::Point { lever } = candidate.element else {
            return;
        };
        let i = contact.node;
        let share = lever / offset;
        let point = (1.0 - share) * self.backbone[i] + share * self.cable[i];
        let clearance = problem.obstacles()[contact.obstacle].clearance(point);
        let tangent = perpendicular(clearance.normal);
        let along = pair((1.0 - share) * tangent, share * tangent);
        self.diagonal[i] -= contact.multiplier * clearance.curvature * along * along.transpose();
    }

    /// Subtracts λ∇²g of an edge on a vertex, by polarising its quadratic form
    /// in the eight coordinates of the two ends' nodes.
    pub(super) fn bend_of_edge(
        &mut self,
        problem: &Problem,
        contact: &Contact,
        ((first, first_lever), (last, last_lever)): ((usize, f64), (usize, f64)),
        offset: f64,
    ) {
        let point = |i: usize, lever: f64| self.backbone[i] + lever / offset * self.disk(i);
        let (start, end) = (point(first, first_lever), point(last, last_lever));
        let obstacle = &problem.obstacles()[contact.obstacle];
        let edge = Edge::alone(start, end);
        let vertex = contact.vertex;
        let Some(clearance) = vertex.and_then(|v| obstacle.edge_clearance(&edge, v)) else {
            return;
        };
        let moved = |lever: f64, d: Pair| {
            let share = lever / offset;
            (1.0 - share) * Vector::new(d[0], d[1]) + share * Vector::new(d[2], d[3])
        };
        // Displacement of (start, end) by unit coordinate j: the first four of
        // the start's node, the last four of the end's.
        let ends = |j: usize| {
            let unit = |k: usize| Pair::from_fn(|row, _| f64::from(u8::from(row == k)));
            if j < 4 {
                let start = moved(first_lever, unit(j));
                let end = if first == last {
                    moved(last_lever, unit(j))
                } else {
                    Vector::zeros()
                };
                (start, end)
            } else {
                (Vector::zeros(), moved(last_lever, unit(j - 4)))
            }
        };
        let form = |a: (Vector, Vector)| {
            clearance.second_derivative(end - start, obstacle.radius(), a.0, a.1)
        };
        let mixed = |i: usize, j: usize| {
            let (a, b) = (ends(i), ends(j));
            0.5 * (form((a.0 + b.0, a.1 + b.1)) - form(a) - form(b))
        };
        let multiplier = contact.multiplier;
        self.diagonal[first] -= multiplier * Block::from_fn(mixed);
        if first != last {
            self.diagonal[last] -= multiplier * Block::from_fn(|i, j| mixed(i + 4, j + 4));
            self.across[last] -= multiplier * Block::from_fn(|i, j| mixed(i, j + 4));
        }
    }
}
