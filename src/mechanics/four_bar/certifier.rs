//! The certificate of the four-bar robot: eq. 5's optimality recomputed in the
//! paper's coordinates.
//!
//! Everything is recomputed from node positions and the contacts' forces alone
//! (where each acts, its multiplier and its direction), in the 4n coordinates
//! (x_0^i, x_a^i) of the paper, by code that shares nothing with the solver but
//! the obstacles' outlines: what is inside of them by the exact distance of every
//! part, whatever rows the solver chose, the energy from the angles between disks, the
//! links' multipliers by a recursion of forces from tip to base, whether a force
//! acts where the robot touches and along a normal there, the second-order
//! condition on the links' null space.
//!
//! With J = Σ β_i² and the constraints h = 0 (links) and g ⪰ 0 (obstacles),
//!
//! ```text
//! ∇J − Σ λ_r ∇g_r − Σ μ_j ∇h_j = 0    g_r ≥ 0    λ_r ≥ 0    λ_r g_r = 0
//! dᵀ ∇²(J − λg − μh) d > 0   for every d ≠ 0 along the links and pressing contacts
//! ```
//!
//! At each node the balance has four components and three unknown link
//! multipliers: backbone, cable and disk. What the three cannot balance lies
//! along the node's one free direction N and is the stationarity residual.

mod contacts;
#[cfg(test)]
mod tests;

use crate::contact::Contact;
use crate::geometry::{Vector, cross, perpendicular};
use crate::math::greatest;
use crate::mechanics::touching::certify_contacts;
use crate::mechanics::{Certificate, Condition, Problem};
use crate::robot::{Candidate, Element};
use nalgebra::{SMatrix, SVector};

/// Coordinates of a node: the backbone point's and the cable point's.
type Pair = SVector<f64, 4>;
type Block = SMatrix<f64, 4, 4>;

/// Bends below this, in radians, drown in the rounding of coordinates: the
/// residual is relative to a force of bending of at least this much.
const LEAST_BEND: f64 = 1e-5;
/// Stiffnesses that hold pressing contacts in the second-order test, relative
/// to the curvature of the energy: for a reduced Hessian that is positive one
/// of them suffices; above 1e8 rounding would decide.
const STIFFNESSES: [f64; 4] = [1.0, 1e2, 1e5, 1e8];

/// Storage and intermediate results of one certificate, kept between calls.
#[derive(Clone, Debug, Default)]
pub struct Certifier {
    backbone: Vec<Vector>,
    cable: Vec<Vector>,
    /// ∇(J − λg), then what the links above leave of it.
    balance: Vec<Pair>,
    /// Diagonal blocks of the Lagrangian's Hessian, and those between a node
    /// and the one before.
    diagonal: Vec<Block>,
    across: Vec<Block>,
    /// Each node's free direction.
    free: Vec<Pair>,
    /// Motion of each node when the one before moves and its own linkage
    /// stays rigid.
    carried: Vec<Block>,
    pressing: Vec<(usize, Gradient)>,
}

/// ∇g of a contact in its own node's and the previous node's coordinates.
#[derive(Clone, Copy, Debug)]
struct Gradient {
    after: Pair,
    before: Pair,
}

impl Certifier {
    /// The certificate of the shape with the given backbone and cable points
    /// (each n + 1, base first) and contacts.
    pub fn certify(
        &mut self,
        problem: &Problem,
        points: impl Iterator<Item = (Vector, Vector)>,
        contacts: &[Contact],
    ) -> Certificate {
        self.backbone.clear();
        self.cable.clear();
        for (backbone, cable) in points {
            self.backbone.push(backbone);
            self.cable.push(cable);
        }
        let length = problem.length();
        let sizes = contacts.iter().map(|contact| contact.multiplier.abs());
        let most = sizes.fold(0.0, f64::max);
        self.add_energy();
        self.add_contacts(problem, contacts);
        let n = problem.robot().segments;
        let free_bend = problem.segment().free_bend().abs();
        let bending = 2.0 * (free_bend + LEAST_BEND) / problem.robot().offset;
        let (residual, cable_sum) = self.balance_links();
        let mut certificate = Certificate::default();
        certificate.set(Condition::Stationarity, residual / bending.max(most));
        certificate.set(Condition::Links, self.link_error(problem) / length);
        let ends = |candidate: &Candidate| self.ends(problem, candidate);
        certify_contacts(problem, contacts, ends, &mut certificate);
        certificate.set(Condition::Orientation, self.orientation());
        certificate.set(Condition::Minimum, self.is_minimum(problem));
        // ∂l_a/∂l = −1/n for every cable link.
        certificate.energy_slope = -cable_sum / n as f64;
        certificate
    }

    fn link_error(&self, problem: &Problem) -> f64 {
        let segment = problem.segment();
        let mut worst = 0.0_f64;
        for i in 1..self.backbone.len() {
            let backbone = (self.backbone[i] - self.backbone[i - 1]).norm();
            let cable = (self.cable[i] - self.cable[i - 1]).norm();
            let disk = (self.cable[i] - self.backbone[i]).norm();
            let errors = [
                backbone - segment.backbone(),
                cable - segment.cable(),
                disk - segment.offset(),
            ];
            worst = errors.iter().map(|error| error.abs()).fold(worst, greatest);
        }
        worst
    }

    /// Whether both links of every segment point along the robot, to the left
    /// of the mean disk direction.
    fn orientation(&self) -> bool {
        (1..self.backbone.len()).all(|i| {
            let mean = self.disk(i) + self.disk(i - 1);
            cross(mean, self.backbone[i] - self.backbone[i - 1]) > 0.0
                && cross(mean, self.cable[i] - self.cable[i - 1]) > 0.0
        })
    }

    /// The two ends of a candidate; the same for a point.
    fn ends(&self, problem: &Problem, candidate: &Candidate) -> (Vector, Vector) {
        let offset = problem.robot().offset;
        let point = |i: usize, lever: f64| self.backbone[i] + lever / offset * self.disk(i);
        let i = candidate.node;
        match candidate.element {
            Element::Point { lever } | Element::OnLink { lever, .. } => {
                (point(i, lever), point(i, lever))
            }
            Element::Link { lever } => (point(i - 1, lever), point(i, lever)),
            Element::Across { lever } => (point(i, -lever), point(i, lever)),
        }
    }

    fn disk(&self, i: usize) -> Vector {
        self.cable[i] - self.backbone[i]
    }

    /// β_i, clockwise from disk i − 1 to disk i.
    fn bend(&self, i: usize) -> f64 {
        let (below, above) = (self.disk(i - 1), self.disk(i));
        libm::atan2(cross(above, below), above.dot(&below))
    }

    fn largest_bend(&self) -> f64 {
        let bends = (1..self.backbone.len()).map(|i| self.bend(i).abs());
        bends.fold(0.0, f64::max)
    }

    /// Adds Σ β² to the balance and to the Hessian's blocks.
    fn add_energy(&mut self) {
        let nodes = self.backbone.len();
        for blocks in [&mut self.diagonal, &mut self.across] {
            blocks.clear();
            blocks.resize(nodes, Block::zeros());
        }
        self.balance.clear();
        self.balance.resize(nodes, Pair::zeros());
        for i in 1..nodes {
            let bend = self.bend(i);
            // The angle of w turns by perp(w)/|w|²; β_i is the angle of disk
            // i − 1 less that of disk i.
            let (below, above) = (self.disk(i - 1), self.disk(i));
            let turn = |w: Vector| perpendicular(w) / w.norm_squared();
            let turn_curvature = |w: Vector| {
                let p = perpendicular(w);
                -(p * w.transpose() + w * p.transpose()) / (w.norm_squared() * w.norm_squared())
            };
            let before = on_disk(turn(below));
            let after = on_disk(-turn(above));
            self.balance[i - 1] += 2.0 * bend * before;
            self.balance[i] += 2.0 * bend * after;
            self.diagonal[i - 1] += 2.0 * before * before.transpose()
                + 2.0 * bend * between_disk(turn_curvature(below));
            self.diagonal[i] +=
                2.0 * after * after.transpose() - 2.0 * bend * between_disk(turn_curvature(above));
            self.across[i] += 2.0 * before * after.transpose();
        }
    }

    /// Finds the links' multipliers from tip to base, subtracts their
    /// curvature from the Hessian, and returns the greatest force left along a
    /// free direction and the sum of the cable links' multipliers.
    fn balance_links(&mut self) -> (f64, f64) {
        let nodes = self.backbone.len();
        self.free.clear();
        self.free.resize(nodes, Pair::zeros());
        self.carried.clear();
        self.carried.resize(nodes, Block::zeros());
        let (mut worst, mut cable_sum) = (0.0_f64, 0.0);
        for i in (1..nodes).rev() {
            let unit = |v: Vector| (v.normalize(), v.norm());
            let (b, b_length) = unit(self.backbone[i] - self.backbone[i - 1]);
            let (k, k_length) = unit(self.cable[i] - self.cable[i - 1]);
            let (w, w_length) = unit(self.disk(i));
            let (across_b, across_k) = (perpendicular(b), perpendicular(k));
            // N moves both ends across their links and keeps the disk's length.
            let (alpha, gamma) = (w.dot(&across_k), w.dot(&across_b));
            let size = (alpha * alpha + gamma * gamma).sqrt();
            let free = pair(alpha / size * across_b, gamma / size * across_k);
            worst = greatest(worst, self.balance[i].dot(&free).abs());
            let left = self.balance[i];
            let on_backbone = Vector::new(left[0], left[1]);
            let on_cable = Vector::new(left[2], left[3]);
            let disk = (on_cable.dot(&across_k) * alpha - on_backbone.dot(&across_b) * gamma)
                / (size * size);
            let backbone = b.dot(&(on_backbone + disk * w));
            let cable = k.dot(&(on_cable - disk * w));
            // ∂|x^i − x^{i−1}|/∂x^{i−1} = −b: what the links pass on.
            self.balance[i - 1] += pair(backbone * b, cable * k);
            cable_sum += cable;
            self.free[i] = free;
            self.carried[i] = self.rigid(i);
            let beside = |unit: Vector, length: f64| {
                (SMatrix::<f64, 2, 2>::identity() - unit * unit.transpose()) / length
            };
            let links = split(backbone * beside(b, b_length), cable * beside(k, k_length));
            self.diagonal[i] -= links + between_disk(disk * beside(w, w_length));
            self.diagonal[i - 1] -= links;
            self.across[i] += links;
        }
        (worst, cable_sum)
    }

    /// How node i moves when disk i − 1 moves and carries it rigidly.
    fn rigid(&self, i: usize) -> Block {
        let below = self.disk(i - 1);
        // The disk turns by perp(w)·(δx_a − δx_0)/|w|².
        let turn = on_disk(perpendicular(below) / below.norm_squared());
        let mut motion = Block::zeros();
        for (row, point) in [(0, self.backbone[i]), (2, self.cable[i])] {
            let swing = perpendicular(point - self.backbone[i - 1]);
            for axis in 0..2 {
                motion[(row + axis, axis)] = 1.0;
                for column in 0..4 {
                    motion[(row + axis, column)] += swing[axis] * turn[column];
                }
            }
        }
        motion
    }

    /// Whether the Hessian is positive definite along the links and pressing
    /// contacts.
    fn is_minimum(&mut self, problem: &Problem) -> bool {
        // Without pull every shape of the linkage has no energy: each is a
        // minimum, though not a strict one. So it is, to rounding, where the
        // squared bends drown in 1e-16.
        if problem.segment().free_bend().abs() < 1e-7 {
            return self.largest_bend() < 1e-6;
        }
        let offset = problem.robot().offset;
        let curvature = 2.0 / (offset * offset);
        let mut stiffness = 0.0;
        if self.pivots_positive() {
            return true;
        }
        if self.pressing.is_empty() {
            return false;
        }
        for relative in STIFFNESSES {
            let more = relative * curvature - stiffness;
            stiffness += more;
            for (i, gradient) in &self.pressing {
                self.diagonal[*i] += more * gradient.after * gradient.after.transpose();
                self.diagonal[i - 1] += more * gradient.before * gradient.before.transpose();
                self.across[*i] += more * gradient.before * gradient.after.transpose();
            }
            if self.pivots_positive() {
                return true;
            }
        }
        false
    }

    /// The block LDLᵀ of the Hessian in the free coordinates ξ, where node i
    /// moves by `carried`·(motion of node i − 1) + `free` ξ_i, tip to base.
    fn pivots_positive(&self) -> bool {
        let nodes = self.backbone.len();
        let mut value = self.diagonal[nodes - 1];
        for i in (1..nodes).rev() {
            let (carried, free) = (&self.carried[i], &self.free[i]);
            let across = self.across[i];
            let pushed = value * free;
            let pivot = free.dot(&pushed);
            let least = 1e-16 * value.trace().abs();
            if pivot.is_nan() || pivot <= least {
                return false;
            }
            let coupling = carried.tr_mul(&pushed) + across * free;
            let linked = across * carried;
            value = self.diagonal[i - 1]
                + carried.tr_mul(&(value * carried))
                + linked
                + linked.transpose()
                - coupling * coupling.transpose() / pivot;
        }
        true
    }
}

/// Coordinates of a node from those of its two points.
fn pair(backbone: Vector, cable: Vector) -> Pair {
    Pair::new(backbone.x, backbone.y, cable.x, cable.y)
}

/// A gradient with respect to w = x_a − x_0 in the node's coordinates.
fn on_disk(gradient: Vector) -> Pair {
    pair(-gradient, gradient)
}

/// A second derivative with respect to w in the node's coordinates.
fn between_disk(curvature: SMatrix<f64, 2, 2>) -> Block {
    let mut block = split(curvature, curvature);
    for row in 0..2 {
        for column in 0..2 {
            block[(row, column + 2)] = -curvature[(row, column)];
            block[(row + 2, column)] = -curvature[(row, column)];
        }
    }
    block
}

/// Separate second derivatives of the backbone and the cable point.
fn split(backbone: SMatrix<f64, 2, 2>, cable: SMatrix<f64, 2, 2>) -> Block {
    let mut block = Block::zeros();
    for row in 0..2 {
        for column in 0..2 {
            block[(row, column)] = backbone[(row, column)];
            block[(row + 2, column + 2)] = cable[(row, column)];
        }
    }
    block
}
