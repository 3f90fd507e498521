//! A solved robot: a solution with the problem that it is one of.

use super::solution::Solution;
use crate::contact::Clearance;
use crate::geometry::Vector;
use crate::mechanics::{Found, Model, Problem, rests_under_load};
use std::ops::Deref;

/// A solution that holds the problem it belongs to, so that nobody reads it
/// with another's sizes or obstacles. It reads as its [`Solution`].
#[derive(Clone, Debug)]
pub struct Solved {
    problem: Problem,
    solution: Solution,
}

impl Solved {
    /// A problem whose shape is not known: its solution has no nodes.
    pub fn unsolved(problem: Problem) -> Self {
        Self {
            problem,
            solution: Solution::default(),
        }
    }

    /// A solution that comes from elsewhere with the problem that was asked
    /// for, whose pull becomes the solution's; a [run](super::Run) and
    /// [`solve`](super::solve) pair their own. `None` where the solution cannot
    /// be one of this problem: another number of segments, another base, or
    /// contacts of parts or with obstacles that are not there.
    pub fn pair(mut problem: Problem, solution: Solution) -> Option<Self> {
        let Some(base) = solution.nodes.first() else {
            return Some(Self { problem, solution });
        };
        let segments = problem.robot().segments;
        let lengths = [solution.nodes.len() - 1, solution.turns.len()];
        let (candidates, obstacles) = (problem.candidates(), problem.obstacles());
        let fits = lengths == [segments; 2]
            && base.position == problem.robot().base.position
            && solution.contacts.iter().all(|contact| {
                let candidate = candidates.get(contact.candidate);
                contact.obstacle < obstacles.len()
                    && candidate.is_some_and(|candidate| candidate.node == contact.node)
            });
        let (least, most) = problem.pull_range();
        let in_range = (least..=most).contains(&solution.drive.pull());
        if !fits || !in_range || !problem.drive().resembles(&solution.drive) {
            return None;
        }
        problem.set_drive(&solution.drive);
        Some(Self { problem, solution })
    }

    /// A pair that is known to be one.
    pub(super) fn own(problem: Problem, solution: Solution) -> Self {
        Self { problem, solution }
    }

    /// The problem. Its pull is the solution's, and its obstacles are where
    /// the shape meets them.
    pub fn problem(&self) -> &Problem {
        &self.problem
    }

    /// The solution.
    pub fn solution(&self) -> &Solution {
        &self.solution
    }

    /// The clearance and multiplier of every candidate from every obstacle, by
    /// candidate; an edge whose inside faces no vertex has none.
    pub fn clearances(&self) -> Vec<Clearance> {
        let around = self.problem.around();
        around.clearances(&self.solution.nodes, &self.solution.contacts)
    }

    /// Whether a robot with sliding cables would rest in this shape, too, if weights
    /// held its cables' tensions and nothing their lengths: a shape that is stable
    /// under pulls may snap away under loads. `None` of the paper's model, and
    /// without a shape.
    pub fn rests_under_load(&self) -> Option<bool> {
        if self.problem.model() != Model::Sliding || self.nodes.is_empty() {
            return None;
        }
        let found = Found {
            nodes: &self.nodes[..],
            contacts: &self.contacts,
            cables: &self.cables,
            strands: &self.strands,
        };
        Some(rests_under_load(&self.problem, found))
    }

    /// The points of the first cable at the nodes, in metres, base first; n + 1, or as
    /// far as it goes.
    pub fn cable(&self) -> impl ExactSizeIterator<Item = Vector> + '_ {
        self.cable_points(0).into_iter()
    }

    /// The points of a cable at the nodes, in metres, base first, as far as it goes:
    /// in the paper's model at its offset beside every node, and of one that slides
    /// its holes and, between disks, points of its straight stretches.
    ///
    /// # Panics
    /// If there is no cable of this index.
    pub fn cable_points(&self, index: usize) -> Vec<Vector> {
        let cable = &self.problem.drive().cables[index].cable;
        let bay = self.problem.robot().segments_per_bay;
        let nodes = self.nodes.iter();
        if self.problem.model() == Model::Equal {
            return nodes.map(|node| node.at(cable.offset)).collect();
        }
        let beside = nodes.take(cable.last_disk * bay + 1).enumerate();
        let beside = beside.map(|(i, node)| {
            let (lower, part) = (i - i % bay, i % bay);
            if part == 0 {
                return node.at(cable.offset);
            }
            let hole = |node: usize| self.nodes[node].at(cable.offset);
            let share = part as f64 / bay as f64;
            (1.0 - share) * hole(lower) + share * hole(lower + bay)
        });
        beside.collect()
    }

    /// A cable's holes in the disks, in metres, base first.
    ///
    /// # Panics
    /// If there is no cable of this index.
    pub fn holes(&self, index: usize) -> Vec<Vector> {
        let cable = &self.problem.drive().cables[index].cable;
        let disks = self
            .nodes
            .iter()
            .step_by(self.problem.robot().segments_per_bay);
        let holes = disks.take(cable.last_disk + 1);
        holes.map(|node| node.at(cable.offset)).collect()
    }

    /// The solution, without a copy.
    pub fn into_solution(self) -> Solution {
        self.solution
    }
}

impl Deref for Solved {
    type Target = Solution;

    fn deref(&self) -> &Solution {
        &self.solution
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::equilibrium::{Settings, Start, solve};
    use crate::scene::Scene;

    fn problem(edit: impl FnOnce(&mut Scene)) -> Problem {
        let text = include_str!("../../assets/scenes/one-disc.toml");
        let mut scene = Scene::from_toml(text).unwrap();
        edit(&mut scene);
        Problem::new(&scene).unwrap()
    }

    #[test]
    fn a_solution_is_paired_with_its_own_problem_only() {
        let own = problem(|_| ());
        let solved = solve(&own, Start::Straight, Settings::default());
        assert!(!solved.contacts.is_empty());
        let pairs = |with: Problem| Solved::pair(with, solved.solution().clone()).is_some();
        assert!(pairs(own));
        assert!(!pairs(problem(
            |scene| scene.robot.segments += scene.robot.segments_per_bay
        )));
        assert!(!pairs(problem(|scene| scene.robot.base_mm[0] += 1e-9)));
        assert!(!pairs(problem(|scene| scene.obstacles.clear())));
    }

    #[test]
    fn the_pull_is_that_of_the_solution() {
        let solved = solve(&problem(|_| ()), Start::Straight, Settings::default());
        let mut farther = problem(|_| ());
        farther.set_pull(solved.pull + 1e-3);
        let paired = Solved::pair(farther, solved.into_solution()).unwrap();
        assert_eq!(paired.problem().pull(), paired.pull);
    }
}
