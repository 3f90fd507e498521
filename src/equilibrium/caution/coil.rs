//! Whether the robot passes through itself. Its links and disks are taken as
//! lines; a shape that only just touches itself counts as one that does not
//! fit.

use super::{Caution, Extent};
use crate::geometry::{Vector, cross};
use crate::mechanics::Problem;
use crate::robot::PlanarNode;

/// The first place, from the base, at which the robot passes through itself.
pub(super) fn find(problem: &Problem, nodes: &[PlanarNode]) -> Option<Caution> {
    let tree = Tree::new(problem, nodes);
    let (lower, upper) = tree.first_crossing(1, 1)?;
    Some(Caution::Coils { lower, upper })
}

/// A line of the robot that a node closes.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Part {
    Backbone,
    Cable,
    Disk,
}

/// Boxes around ever longer stretches of the robot, the whole of it first, so
/// that only those which overlap are compared.
struct Tree<'a> {
    problem: &'a Problem,
    nodes: &'a [PlanarNode],
    /// Of a complete binary tree, from 1; the leaves are the nodes.
    boxes: Vec<Extent>,
    /// Lines nearer than this meet: where a robot lies over itself turn for
    /// turn, rounding would decide.
    tolerance: f64,
}

impl<'a> Tree<'a> {
    fn new(problem: &'a Problem, nodes: &'a [PlanarNode]) -> Self {
        let leaves = nodes.len().next_power_of_two();
        let mut tree = Self {
            problem,
            nodes,
            boxes: vec![Extent::EMPTY; 2 * leaves],
            tolerance: problem.robot().touching(),
        };
        let grown = Vector::new(tree.tolerance, tree.tolerance);
        for node in 0..nodes.len() {
            let ends = tree.parts(node).flat_map(|(_, (a, b))| [a, b]);
            let round = ends.fold(Extent::EMPTY, |round, end| {
                round.with(end - grown).with(end + grown)
            });
            tree.boxes[leaves + node] = round;
        }
        for place in (1..leaves).rev() {
            tree.boxes[place] = tree.boxes[2 * place].joined(tree.boxes[2 * place + 1]);
        }
        tree
    }

    /// The links below a node and the disk on it, with their ends.
    fn parts(&self, node: usize) -> impl Iterator<Item = (Part, (Vector, Vector))> {
        let robot = self.problem.robot();
        let here = self.nodes[node];
        let link = |lever: f64| {
            let below = self.nodes[node.checked_sub(1)?];
            Some((below.at(lever), here.at(lever)))
        };
        let rim = robot.sizes.rim;
        let disk = robot.has_disk(node).then(|| (here.at(-rim), here.at(rim)));
        [
            link(0.0).map(|ends| (Part::Backbone, ends)),
            link(robot.offset).map(|ends| (Part::Cable, ends)),
            disk.map(|ends| (Part::Disk, ends)),
        ]
        .into_iter()
        .flatten()
    }

    /// The first crossing of two stretches of the same length, by the lower
    /// one's node.
    fn first_crossing(&self, a: usize, b: usize) -> Option<(usize, usize)> {
        if !self.boxes[a].meets(&self.boxes[b]) {
            return None;
        }
        let leaves = self.boxes.len() / 2;
        if a >= leaves {
            let (lower, upper) = (a - leaves, b - leaves);
            return self.cross(lower, upper).then_some((lower, upper));
        }
        let ([a0, a1], [b0, b1]) = ([2 * a, 2 * a + 1], [2 * b, 2 * b + 1]);
        let pairs: &[(usize, usize)] = if a == b {
            &[(a0, a0), (a0, a1), (a1, a1)]
        } else {
            &[(a0, b0), (a0, b1), (a1, b0), (a1, b1)]
        };
        pairs.iter().find_map(|(a, b)| self.first_crossing(*a, *b))
    }

    /// Whether parts of two nodes cross that are not joined to each other.
    fn cross(&self, lower: usize, upper: usize) -> bool {
        self.parts(lower).any(|(kind, a)| {
            let mut others = self.parts(upper);
            others.any(|(other, b)| {
                !joined((kind, lower), (other, upper)) && crosses(a, b, self.tolerance)
            })
        })
    }
}

/// Whether two parts share a point of the robot, or are the same.
fn joined((a, lower): (Part, usize), (b, upper): (Part, usize)) -> bool {
    match (a, b) {
        (Part::Disk, Part::Disk) => lower == upper,
        (Part::Disk, _) => upper == lower || upper == lower + 1,
        (_, Part::Disk) => upper == lower || lower == upper + 1,
        _ => a == b && upper <= lower + 1,
    }
}

/// Whether two lines meet, to within `tolerance`.
fn crosses(a: (Vector, Vector), b: (Vector, Vector), tolerance: f64) -> bool {
    // Apart along either line, or across it.
    let apart = |(start, end): (Vector, Vector), other: (Vector, Vector)| {
        let along = end - start;
        let length = along.norm();
        let ends = [other.0 - start, other.1 - start];
        let heights = ends.map(|end| cross(along, end) / length);
        let places = ends.map(|end| along.dot(&end) / length);
        heights[0].min(heights[1]) > tolerance
            || heights[0].max(heights[1]) < -tolerance
            || places[0].min(places[1]) > length + tolerance
            || places[0].max(places[1]) < -tolerance
    };
    !apart(a, b) && !apart(b, a)
}
