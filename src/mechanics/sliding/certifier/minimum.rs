//! Whether a shape of the robot with sliding cables is a strict minimum: the
//! second-order condition, by eliminating the arcs from tip to base.
//!
//! The second variation of energy less work is a quadratic form in the displacements
//! of nodes, the changes b of bends, and a multiplier τ for each tense cable under
//! pull or, with friction, for each part of one between holes where it sticks; the
//! differences between the tensions of its stretches are given ones there. What is above a node is a form V in its displacement z, that of the disk below
//! it and τ; an arc makes it one in those of the node before it:
//!
//! ```text
//! V′(z′, w, τ) = min over b of  V(A z′ + B b, w, τ) + ½ (z′, b)ᵀ (g·∂²z) (z′, b) + b²
//! ```
//!
//! with the force g on all that is above. The Lagrangian's Hessian on the null space of
//! the cables' lengths is positive exactly if the pivots of all b and of τ, which is
//! left at the base, have as many negative signs as there are τ. Pressing contacts are
//! held by stiffnesses, as many of them as it takes.

use super::Certifier;
use super::friction::{tension, yielding};
use crate::contact::Contact;
use crate::geometry::{Edge, Vector, perpendicular};
use crate::mechanics::{CableState, Input, Problem, Slip, Strand};
use crate::robot::Element;
use nalgebra::{SMatrix, SVector};

/// A quadratic form in the displacements of two nodes.
type Pair = SMatrix<f64, 6, 6>;

/// Stiffnesses that hold pressing contacts, relative to that of an arc against its end;
/// above the last rounding would decide.
const STIFFNESSES: [f64; 4] = [0.0, 1e2, 1e5, 1e8];
/// Pivots of a bend below this, of 2 for an arc by itself, count as none.
const LEAST_PIVOT: f64 = 1e-9;
/// Nodes and weights of Gauss and Legendre's rule of five points on \[0, 1\], exact to
/// rounding for arcs of less than a radian.
const GAUSS: [(f64, f64); 5] = [
    (0.046_910_077_030_668, 0.118_463_442_528_094_54),
    (0.230_765_344_947_158_45, 0.239_314_335_249_683_23),
    (0.5, 0.284_444_444_444_444_44),
    (0.769_234_655_052_841_5, 0.239_314_335_249_683_23),
    (0.953_089_922_969_332, 0.118_463_442_528_094_54),
];

/// Storage of the elimination.
#[derive(Clone, Debug, Default)]
pub(super) struct Elimination {
    /// V, and the form with b as its last unknown; square, row by row.
    form: Vec<f64>,
    with_bend: Vec<f64>,
    /// What is held of tense cables: whole ones under pull and, where one sticks in
    /// holes, its parts between them.
    held: Vec<Held>,
}

/// Stretches of a cable whose length is held, ends included.
#[derive(Clone, Copy, Debug)]
struct Held {
    cable: usize,
    first: usize,
    last: usize,
}

/// Of what V is: 3 of the node, 3 of the disk below it, then τ.
const LOW: usize = 3;
const FREE: usize = 6;

impl Certifier {
    /// Whether the second-order condition holds.
    pub(super) fn is_minimum(
        &mut self,
        problem: &Problem,
        contacts: &[Contact],
        cables: (&[CableState], &[Strand]),
    ) -> bool {
        let mut elimination = std::mem::take(&mut self.elimination);
        elimination.held.clear();
        let driven = problem.drive().cables.iter().zip(cables.0).enumerate();
        for (cable, (driven, state)) in driven {
            let strand = cables.1.get(cable);
            let last = driven.cable.last_disk;
            let sticks = |hole: usize| {
                strand.is_some_and(|strand| strand.slips.get(hole) == Some(&Slip::Sticks))
            };
            let whole = matches!(driven.input, Input::Pull(_));
            let mut first = 1;
            for hole in 1..=last {
                if hole == last || sticks(hole) {
                    let is_held = first > 1 || whole || sticks(0);
                    if is_held && tension(state, strand, first) > 0.0 {
                        let last = hole;
                        elimination.held.push(Held { cable, first, last });
                    }
                    first = hole + 1;
                }
            }
        }
        let found = STIFFNESSES.iter().any(|stiffness| {
            let arc = problem.robot().segment_length();
            let stiffness = stiffness / (arc * arc);
            self.eliminate(problem, (contacts, cables), stiffness, &mut elimination)
        });
        self.elimination = elimination;
        found
    }

    fn eliminate(
        &self,
        problem: &Problem,
        (contacts, cables): (&[Contact], (&[CableState], &[Strand])),
        stiffness: f64,
        elimination: &mut Elimination,
    ) -> bool {
        let robot = problem.robot();
        let (bay, arc) = (robot.segments_per_bay, robot.segment_length());
        let Elimination {
            form,
            with_bend,
            held,
        } = elimination;
        let size = FREE + held.len();
        form.clear();
        form.resize(size * size, 0.0);
        let mut force = Vector::zeros();
        let mut next = self.forces.iter().peekable();
        let mut negative = 0;
        for i in (1..self.nodes.len()).rev() {
            if robot.has_disk(i) {
                self.add_stretches(problem, (i, i - bay), cables, held, form);
            }
            let mut on_link = Pair::zeros();
            for contact in contacts.iter().filter(|contact| contact.multiplier > 0.0) {
                let candidate = &problem.candidates()[contact.candidate];
                let (end, start) = match candidate.element {
                    Element::OnLink { above, .. } => {
                        let end = candidate.node + above;
                        (end, end - candidate.span)
                    }
                    Element::Link { .. } => (candidate.node, candidate.node - candidate.span),
                    Element::Point { .. } | Element::Across { .. } => {
                        (candidate.node, candidate.node)
                    }
                };
                if end != i {
                    continue;
                }
                let part = self.contact_form(problem, contact, (start, end), stiffness);
                if start == end || robot.has_disk(i) && start == i - bay {
                    add(form, size, &part);
                } else {
                    on_link += part;
                }
            }
            while let Some((_, _, push)) = next.next_if(|(node, ..)| *node >= i) {
                force += push;
            }
            let (from, to) = (&self.nodes[i - 1], &self.nodes[i]);
            let bend = from.angle - to.angle;
            let (mut rate, mut acceleration) = (Vector::zeros(), Vector::zeros());
            for (at, weight) in GAUSS {
                // The tangent a share of the way turns by that share of the bend.
                let (sine, cosine) = libm::sincos(from.angle - at * bend);
                rate += arc * weight * at * Vector::new(cosine, sine);
                acceleration -= arc * weight * at * at * Vector::new(-sine, cosine);
            }
            let swing = perpendicular(to.position - from.position);
            // z = A z′ + B b, with the unknowns (z′, b).
            let mut motion = SMatrix::<f64, 3, 4>::zeros();
            for axis in 0..3 {
                motion[(axis, axis)] = 1.0;
            }
            motion[(0, 2)] = swing.x;
            motion[(1, 2)] = swing.y;
            motion[(0, 3)] = rate.x;
            motion[(1, 3)] = rate.y;
            motion[(2, 3)] = -1.0;
            // g·∂²z: the potential's gradient is minus the force.
            let mut own = SMatrix::<f64, 4, 4>::zeros();
            own[(2, 2)] = force.dot(&(to.position - from.position));
            own[(2, 3)] = -force.dot(&perpendicular(rate));
            own[(3, 2)] = own[(2, 3)];
            own[(3, 3)] = 2.0 - force.dot(&acceleration);
            // A contact on the arc's chord moves with both its ends.
            let mut both = SMatrix::<f64, 6, 4>::zeros();
            both.fixed_view_mut::<3, 4>(0, 0).copy_from(&motion);
            for axis in 0..3 {
                both[(3 + axis, axis)] = 1.0;
            }
            own += both.tr_mul(&on_link) * both;
            let pivot = with_arc(form, size, &motion, &own, with_bend);
            if pivot.abs() <= LEAST_PIVOT {
                return false;
            }
            negative += usize::from(pivot < 0.0);
            take_bend(form, size, with_bend, pivot);
            if (i - 1).is_multiple_of(bay) {
                merge_low(form, size);
            }
        }
        negative + negative_of(form, size, held, problem) == held.len()
    }

    /// Adds the cables' stretches to the disk at node `up` from that at node `low`.
    fn add_stretches(
        &self,
        problem: &Problem,
        (up, low): (usize, usize),
        cables: (&[CableState], &[Strand]),
        held: &[Held],
        form: &mut [f64],
    ) {
        let size = FREE + held.len();
        let bay = problem.robot().segments_per_bay;
        let driven = problem.drive().cables.iter().zip(cables.0).enumerate();
        for (index, (driven, state)) in driven {
            if up > driven.cable.last_disk * bay {
                continue;
            }
            let lever = driven.cable.offset;
            let (below, above) = (&self.nodes[low], &self.nodes[up]);
            let along = above.at(lever) - below.at(lever);
            let length = along.norm();
            let direction = along / length;
            let arms = [lever * above.disk, lever * below.disk];
            let moves = |j: usize| match j {
                0 => Vector::x(),
                1 => Vector::y(),
                2 => perpendicular(arms[0]),
                3 => -Vector::x(),
                4 => -Vector::y(),
                _ => -perpendicular(arms[1]),
            };
            let gradient = SVector::<f64, 6>::from_fn(|j, _| direction.dot(&moves(j)));
            let mut part = Pair::from_fn(|i, j| {
                (moves(i).dot(&moves(j)) - gradient[i] * gradient[j]) / length
            });
            part[(2, 2)] -= direction.dot(&arms[0]);
            part[(5, 5)] += direction.dot(&arms[1]);
            let stretch = up / bay;
            add(
                form,
                size,
                &(tension(state, cables.1.get(index), stretch) * part),
            );
            let holds =
                |held: &Held| held.cable == index && (held.first..=held.last).contains(&stretch);
            if let Some(place) = held.iter().position(holds) {
                for j in 0..6 {
                    form[j * size + FREE + place] += gradient[j];
                    form[(FREE + place) * size + j] += gradient[j];
                }
            }
        }
    }

    /// −λ∇²g and `stiffness` ∇g∇gᵀ of a contact, in the displacements of the nodes of
    /// its end and its start; of its one node in the first three.
    fn contact_form(
        &self,
        problem: &Problem,
        contact: &Contact,
        (start, end): (usize, usize),
        stiffness: f64,
    ) -> Pair {
        let candidate = &problem.candidates()[contact.candidate];
        let obstacle = &problem.obstacles()[contact.obstacle];
        let lever = candidate.signed_lever();
        let levers = match candidate.element {
            Element::Across { .. } => (-lever, lever),
            _ => (lever, lever),
        };
        let arms = (
            levers.0 * self.nodes[start].disk,
            levers.1 * self.nodes[end].disk,
        );
        let still = Vector::zeros();
        // Displacements of (start, end) by the unknowns.
        let moves = |j: usize| {
            let at_end = [Vector::x(), Vector::y(), perpendicular(arms.1)];
            let at_start = [Vector::x(), Vector::y(), perpendicular(arms.0)];
            match (j, start == end) {
                (0..3, true) => (at_start[j], at_end[j]),
                (0..3, false) => (still, at_end[j]),
                (_, false) => (at_start[j - 3], still),
                (_, true) => (still, still),
            }
        };
        let normal = contact.normal;
        let share = match candidate.element {
            Element::OnLink { .. } => candidate.share(),
            _ => contact.along,
        };
        let point = |(start, end): (Vector, Vector)| start + share * (end - start);
        let gradient = SVector::<f64, 6>::from_fn(|j, _| normal.dot(&point(moves(j))));
        let (from, to) = candidate.ends(&self.nodes);
        let mut part = if candidate.is_point() {
            let curvature = obstacle.clearance(from).curvature;
            let tangent = perpendicular(normal);
            let along = SVector::<f64, 6>::from_fn(|j, _| tangent.dot(&point(moves(j))));
            curvature * along * along.transpose()
        } else {
            let edge = Edge::alone(from, to);
            let Some(clearance) = contact
                .vertex
                .and_then(|v| obstacle.edge_clearance(&edge, v))
            else {
                return Pair::zeros();
            };
            let value = |a: (Vector, Vector)| {
                clearance.second_derivative(to - from, obstacle.radius(), a.0, a.1)
            };
            Pair::from_fn(|i, j| {
                let (a, b) = (moves(i), moves(j));
                0.5 * (value((a.0 + b.0, a.1 + b.1)) - value(a) - value(b))
            })
        };
        // How the ends curve as their disks turn.
        let (first, last) = (
            (1.0 - share) * normal.dot(&arms.0),
            share * normal.dot(&arms.1),
        );
        part[(2, 2)] -= if start == end { first + last } else { last };
        if start != end {
            part[(5, 5)] -= first;
        }
        let mut form = stiffness * gradient * gradient.transpose() - contact.multiplier * part;
        if contact.friction != 0.0 {
            // A dead load on the surface, which the disks' turning moves on circles.
            let tangent = contact.tangent();
            let down = -candidate.radius * normal;
            let turned = |share: f64, arm: Vector| share * tangent.dot(&(arm + down));
            let (first, last) = (turned(1.0 - share, arms.0), turned(share, arms.1));
            form[(2, 2)] += contact.friction * if start == end { first + last } else { last };
            if start != end {
                form[(5, 5)] += contact.friction * first;
            }
            if Slip::of(contact.slid) == Slip::Sticks {
                let along = SVector::<f64, 6>::from_fn(|j, _| tangent.dot(&point(moves(j))));
                form += stiffness * along * along.transpose();
            }
        }
        form
    }
}

/// Adds a form in the node and in the disk below it.
fn add(form: &mut [f64], size: usize, part: &Pair) {
    for i in 0..6 {
        for j in 0..6 {
            form[i * size + j] += part[(i, j)];
        }
    }
}

/// Fills V(A z′ + B b, w, τ) + ½(z′, b)ᵀ own (z′, b) in (z′, w, τ, b), and returns the
/// pivot of b.
fn with_arc(
    form: &[f64],
    size: usize,
    motion: &SMatrix<f64, 3, 4>,
    own: &SMatrix<f64, 4, 4>,
    with_bend: &mut Vec<f64>,
) -> f64 {
    let wide = size + 1;
    with_bend.clear();
    with_bend.resize(wide * wide, 0.0);
    // Where (z′, b) stand among the unknowns.
    let place = [0, 1, 2, size];
    let node = SMatrix::<f64, 3, 3>::from_fn(|i, j| form[i * size + j]);
    let moved = motion.tr_mul(&node) * motion + own;
    for i in 0..4 {
        for j in 0..4 {
            with_bend[place[i] * wide + place[j]] = moved[(i, j)];
        }
        for j in LOW..size {
            let cross: f64 = (0..3).map(|k| motion[(k, i)] * form[k * size + j]).sum();
            with_bend[place[i] * wide + j] = cross;
            with_bend[j * wide + place[i]] = cross;
        }
    }
    for i in LOW..size {
        for j in LOW..size {
            with_bend[i * wide + j] = form[i * size + j];
        }
    }
    with_bend[size * wide + size]
}

/// Eliminates b.
fn take_bend(form: &mut [f64], size: usize, with_bend: &[f64], pivot: f64) {
    let wide = size + 1;
    let bend = |i: usize| with_bend[size * wide + i];
    for i in 0..size {
        for j in 0..size {
            form[i * size + j] = with_bend[i * wide + j] - bend(i) * bend(j) / pivot;
        }
    }
}

/// Makes the disk below the node itself, where it is.
fn merge_low(form: &mut [f64], size: usize) {
    for j in 0..size {
        for axis in 0..3 {
            form[axis * size + j] += form[(LOW + axis) * size + j];
            form[(LOW + axis) * size + j] = 0.0;
        }
    }
    for i in 0..size {
        for axis in 0..3 {
            form[i * size + axis] += form[i * size + LOW + axis];
            form[i * size + LOW + axis] = 0.0;
        }
    }
}

/// How many eigenvalues of the form in τ at the base, which does not move, are
/// negative.
fn negative_of(form: &mut [f64], size: usize, held: &[Held], problem: &Problem) -> usize {
    for (place, held) in held.iter().enumerate() {
        let at = FREE + place;
        let stretches = (held.last + 1 - held.first) as f64;
        form[at * size + at] -= stretches * yielding(problem, held.cable);
    }
    let mut negative = 0;
    for pivot in FREE..size {
        let diagonal = form[pivot * size + pivot];
        negative += usize::from(diagonal < 0.0);
        for i in pivot + 1..size {
            let factor = form[i * size + pivot] / diagonal;
            for j in pivot + 1..size {
                form[i * size + j] -= factor * form[pivot * size + j];
            }
        }
    }
    negative
}
