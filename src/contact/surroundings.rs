//! What of the robot may touch, and what it may touch: the part of a problem
//! that is the same whatever bends the robot.

use crate::geometry::{Obstacle, Vector};
use crate::robot::{Candidate, Robot};
use std::sync::Arc;

/// A robot's candidates and the obstacles around it.
///
/// Clone with `clone_from` where one exists already: it reuses the storage.
#[derive(Debug)]
pub struct Surroundings {
    /// The backbone's length, in metres: the size that others are compared with.
    pub(super) length: f64,
    /// Shared by all clones: a fine robot has many.
    pub(super) candidates: Arc<[Candidate]>,
    /// The greatest lever of a candidate, in metres.
    pub(super) reach: f64,
    pub(super) obstacles: Vec<Obstacle>,
}

impl Clone for Surroundings {
    fn clone(&self) -> Self {
        Self {
            length: self.length,
            candidates: Arc::clone(&self.candidates),
            reach: self.reach,
            obstacles: self.obstacles.clone(),
        }
    }

    fn clone_from(&mut self, source: &Self) {
        self.length = source.length;
        self.candidates = Arc::clone(&source.candidates);
        self.reach = source.reach;
        self.obstacles.clone_from(&source.obstacles);
    }
}

impl Surroundings {
    /// The candidates of a robot and its obstacles, in the order of the scene.
    pub fn new(robot: &Robot, candidates: Vec<Candidate>, obstacles: Vec<Obstacle>) -> Self {
        Self {
            length: robot.length,
            reach: candidates.iter().map(Candidate::lever).fold(0.0, f64::max),
            candidates: candidates.into(),
            obstacles,
        }
    }

    /// The parts of the robot that may touch.
    pub fn candidates(&self) -> &[Candidate] {
        &self.candidates
    }

    /// The obstacles, in the order of the scene.
    pub fn obstacles(&self) -> &[Obstacle] {
        &self.obstacles
    }

    /// Replaces one obstacle.
    ///
    /// # Panics
    /// If there is no obstacle of that index.
    pub fn set_obstacle(&mut self, index: usize, obstacle: Obstacle) {
        self.obstacles[index] = obstacle;
    }

    /// Moves all obstacles by a vector.
    pub fn move_by(&mut self, by: Vector) {
        for obstacle in &mut self.obstacles {
            *obstacle = obstacle.moved(by);
        }
    }

    /// Whether the same parts may touch obstacles of the same kinds in both, so
    /// that one can be moved into the other.
    pub fn resembles(&self, other: &Self) -> bool {
        self.same_candidates(other)
            && self.obstacles.len() == other.obstacles.len()
            && self
                .obstacles
                .iter()
                .zip(&other.obstacles)
                .all(|(a, b)| a.resembles(b))
    }

    /// Whether the same parts may touch the same obstacles at the same places.
    pub fn same(&self, other: &Self) -> bool {
        let mut pairs = self.obstacles.iter().zip(&other.obstacles);
        self.resembles(other) && pairs.all(|(a, b)| a.change(b) == 0.0)
    }

    /// Whether the same parts of the robot may touch in both.
    pub fn same_candidates(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.candidates, &other.candidates) || self.candidates == other.candidates
    }

    /// Moves the obstacles to where they are a share `t` in \[0, 1\] of the way
    /// from `a` to `b`, which resemble each other and this one. Allocates
    /// nothing.
    pub fn set_between(&mut self, a: &Self, b: &Self, t: f64) {
        for ((to, a), b) in self
            .obstacles
            .iter_mut()
            .zip(&a.obstacles)
            .zip(&b.obstacles)
        {
            to.set_between(a, b, t);
        }
    }
}
