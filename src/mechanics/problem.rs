//! A planar problem: a robot, a pull, candidates and obstacles, checked once.

use super::four_bar::FourBar;
use crate::contact::Surroundings;
use crate::geometry::{Obstacle, Vector};
use crate::math::within;
use crate::robot::{Candidate, Robot};
use serde::de::Error;
use serde::{Deserialize, Deserializer, Serialize, Serializer};
use std::borrow::Cow;

/// A robot among obstacles at a pull. Every value of it can be solved for or
/// shown not to be solvable; none is malformed.
///
/// Clone with `clone_from` where one exists already: it reuses the storage.
#[derive(Debug)]
pub struct Problem {
    robot: Robot,
    pull: f64,
    segment: FourBar,
    around: Surroundings,
}

impl Clone for Problem {
    fn clone(&self) -> Self {
        Self {
            robot: self.robot,
            pull: self.pull,
            segment: self.segment,
            around: self.around.clone(),
        }
    }

    fn clone_from(&mut self, source: &Self) {
        self.robot = source.robot;
        self.pull = source.pull;
        self.segment = source.segment;
        self.around.clone_from(&source.around);
    }
}

/// What a problem is made of.
#[derive(Serialize, Deserialize)]
struct Parts<'a> {
    robot: Robot,
    pull: f64,
    candidates: Cow<'a, [Candidate]>,
    obstacles: Cow<'a, [Obstacle]>,
}

impl Serialize for Problem {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let parts = Parts {
            robot: self.robot,
            pull: self.pull,
            candidates: Cow::Borrowed(self.candidates()),
            obstacles: Cow::Borrowed(self.obstacles()),
        };
        parts.serialize(serializer)
    }
}

/// Reads what was written of a problem: a pull out of the robot's range is
/// refused, other parts are taken as they are.
impl<'de> Deserialize<'de> for Problem {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let parts = Parts::deserialize(deserializer)?;
        let (least, most) = parts.robot.pull_range();
        if !(least..=most).contains(&parts.pull) {
            return Err(D::Error::custom("a pull out of the robot's range"));
        }
        let (candidates, obstacles) = (parts.candidates, parts.obstacles);
        Ok(Self::from_parts(
            parts.robot,
            parts.pull,
            candidates.into_owned(),
            obstacles.into_owned(),
        ))
    }
}

impl Problem {
    /// A problem from parts that were checked: see [`Problem::new`] for the
    /// way from a scene.
    ///
    /// # Panics
    /// If the pull is outside the robot's range: a bug of the caller.
    pub fn from_parts(
        robot: Robot,
        pull: f64,
        candidates: Vec<Candidate>,
        obstacles: Vec<Obstacle>,
    ) -> Self {
        let (least, most) = robot.pull_range();
        assert!((least..=most).contains(&pull), "a pull out of range");
        Self {
            robot,
            pull,
            segment: segment(&robot, pull),
            around: Surroundings::new(&robot, candidates, obstacles),
        }
    }

    /// The robot's dimensions.
    pub fn robot(&self) -> &Robot {
        &self.robot
    }

    /// The backbone's length, in metres.
    pub fn length(&self) -> f64 {
        self.robot.length
    }

    /// The length of cable drawn in, in metres.
    pub fn pull(&self) -> f64 {
        self.pull
    }

    /// A segment at the present pull.
    pub fn segment(&self) -> &FourBar {
        &self.segment
    }

    /// The parts of the robot that may touch.
    pub fn candidates(&self) -> &[Candidate] {
        self.around.candidates()
    }

    /// The obstacles, in the order of the scene.
    pub fn obstacles(&self) -> &[Obstacle] {
        self.around.obstacles()
    }

    /// What may touch, and what it may touch.
    pub fn around(&self) -> &Surroundings {
        &self.around
    }

    /// Sets the pull, clamped to the robot's range.
    ///
    /// # Panics
    /// If the pull is not a number: a bug of the caller.
    pub fn set_pull(&mut self, pull: f64) {
        assert!(!pull.is_nan(), "a pull that is not a number");
        let (least, most) = self.robot.pull_range();
        self.pull = within(pull, least, most);
        self.segment = segment(&self.robot, self.pull);
    }

    /// Replaces one obstacle.
    ///
    /// # Panics
    /// If there is no obstacle of that index.
    pub fn set_obstacle(&mut self, index: usize, obstacle: Obstacle) {
        self.around.set_obstacle(index, obstacle);
    }

    /// The problem moved as a whole by a vector.
    pub fn moved(&self, by: Vector) -> Self {
        let mut moved = self.clone();
        moved.robot.base.position += by;
        moved.around.move_by(by);
        moved
    }

    /// Whether the same robot meets obstacles of the same kinds in both, so
    /// that one can be moved into the other.
    pub fn resembles(&self, other: &Self) -> bool {
        self.robot.moves_like(&other.robot) && self.around.resembles(&other.around)
    }

    /// Whether another problem is this one, but perhaps for the pull and for sizes
    /// that touch nothing.
    pub fn same_but_for_pull(&self, other: &Self) -> bool {
        self.robot.moves_like(&other.robot) && self.around.same(&other.around)
    }

    /// Whether the same parts of the robot may touch in both.
    pub fn same_candidates(&self, other: &Self) -> bool {
        self.around.same_candidates(&other.around)
    }

    /// Becomes the problem a share `t` in \[0, 1\] of the way from `a` to `b`,
    /// which resemble each other and this one. Allocates nothing.
    pub fn set_between(&mut self, a: &Self, b: &Self, t: f64) {
        self.set_pull((1.0 - t) * a.pull + t * b.pull);
        self.around.set_between(&a.around, &b.around, t);
    }
}

fn segment(robot: &Robot, pull: f64) -> FourBar {
    let n = robot.segments as f64;
    FourBar::new(robot.length / n, pull / n, robot.offset)
}
