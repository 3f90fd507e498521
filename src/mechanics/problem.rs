//! A planar problem: a robot, what drives it, candidates and obstacles, checked once.

use super::drive::{Drive, Input};
use super::four_bar::FourBar;
use crate::contact::Surroundings;
use crate::geometry::{Obstacle, Vector};
use crate::math::within;
use crate::robot::{Candidate, Robot};
use serde::de::Error;
use serde::{Deserialize, Deserializer, Serialize, Serializer};
use std::borrow::Cow;

/// How the cables lie along the robot.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Model {
    /// The paper's: the one cable's segments are links, which all shorten alike.
    Equal,
    /// Cables slide through the disks and are straight from one to the next.
    Sliding,
}

impl Model {
    /// The model in one word, as in files.
    pub fn word(self) -> &'static str {
        match self {
            Model::Equal => "equal",
            Model::Sliding => "sliding",
        }
    }
}

/// A robot among obstacles and what drives it. Every value of it can be solved for
/// or shown not to be solvable; none is malformed.
///
/// Clone with `clone_from` where one exists already: it reuses the storage.
#[derive(Debug)]
pub struct Problem {
    robot: Robot,
    model: Model,
    drive: Drive,
    /// A segment of the paper's model at the present pull.
    segment: FourBar,
    around: Surroundings,
}

impl Clone for Problem {
    fn clone(&self) -> Self {
        Self {
            robot: self.robot,
            model: self.model,
            drive: self.drive.clone(),
            segment: self.segment,
            around: self.around.clone(),
        }
    }

    fn clone_from(&mut self, source: &Self) {
        self.robot = source.robot;
        self.model = source.model;
        self.drive.clone_from(&source.drive);
        self.segment = source.segment;
        self.around.clone_from(&source.around);
    }
}

/// What a problem is made of.
#[derive(Serialize, Deserialize)]
struct Parts<'a> {
    robot: Robot,
    model: Model,
    drive: Cow<'a, Drive>,
    candidates: Cow<'a, [Candidate]>,
    obstacles: Cow<'a, [Obstacle]>,
}

impl Serialize for Problem {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let parts = Parts {
            robot: self.robot,
            model: self.model,
            drive: Cow::Borrowed(&self.drive),
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
        let drive = parts.drive.into_owned();
        if drive.cables.is_empty() || !is_in_range(&parts.robot, parts.model, &drive) {
            return Err(D::Error::custom("a pull out of the robot's range"));
        }
        let (candidates, obstacles) = (parts.candidates, parts.obstacles);
        let around = Surroundings::new(
            &parts.robot,
            candidates.into_owned(),
            obstacles.into_owned(),
        );
        Ok(Self::of(parts.robot, parts.model, drive, around))
    }
}

impl Problem {
    /// A problem of the paper's model from parts that were checked: see
    /// [`Problem::new`] for the way from a scene.
    ///
    /// # Panics
    /// If the pull is outside the robot's range: a bug of the caller.
    pub fn from_parts(
        robot: Robot,
        pull: f64,
        candidates: Vec<Candidate>,
        obstacles: Vec<Obstacle>,
    ) -> Self {
        let around = Surroundings::new(&robot, candidates, obstacles);
        Self::of(robot, Model::Equal, Drive::of_pull(&robot, pull), around)
    }

    /// A problem of sliding cables from parts that were checked.
    ///
    /// # Panics
    /// If there is no cable: a bug of the caller.
    pub fn sliding(
        robot: Robot,
        drive: Drive,
        candidates: Vec<Candidate>,
        obstacles: Vec<Obstacle>,
    ) -> Self {
        let around = Surroundings::new(&robot, candidates, obstacles);
        Self::of(robot, Model::Sliding, drive, around)
    }

    fn of(robot: Robot, model: Model, drive: Drive, around: Surroundings) -> Self {
        assert!(!drive.cables.is_empty(), "a robot without a cable");
        assert!(is_in_range(&robot, model, &drive), "a pull out of range");
        Self {
            segment: segment(&robot, model, &drive),
            robot,
            model,
            drive,
            around,
        }
    }

    /// How its cables lie along it.
    pub fn model(&self) -> Model {
        self.model
    }

    /// What drives it.
    pub fn drive(&self) -> &Drive {
        &self.drive
    }

    /// The robot's dimensions.
    pub fn robot(&self) -> &Robot {
        &self.robot
    }

    /// The backbone's length, in metres.
    pub fn length(&self) -> f64 {
        self.robot.length
    }

    /// The length of the first cable drawn in, in metres; 0 where its load is given.
    pub fn pull(&self) -> f64 {
        self.drive.pull()
    }

    /// The pulls that can be asked for, in metres, ends included: in the paper's model
    /// those for which its linkages exist.
    pub fn pull_range(&self) -> (f64, f64) {
        Self::pulls(&self.robot, self.model)
    }

    /// The same of a robot in a model.
    pub fn pulls(robot: &Robot, model: Model) -> (f64, f64) {
        match model {
            Model::Equal => robot.pull_range(),
            Model::Sliding => (-robot.length, robot.length),
        }
    }

    /// A segment of the paper's model at the present pull.
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

    /// Sets the pull of the first cable, clamped to the robot's range.
    ///
    /// # Panics
    /// If the pull is not a number: a bug of the caller.
    pub fn set_pull(&mut self, pull: f64) {
        assert!(!pull.is_nan(), "a pull that is not a number");
        let (least, most) = self.pull_range();
        self.drive.cables[0].input = Input::Pull(within(pull, least, most));
        self.segment = segment(&self.robot, self.model, &self.drive);
    }

    /// Sets all that drives the robot; pulls are clamped to the robot's range.
    pub fn set_drive(&mut self, drive: &Drive) {
        self.drive.clone_from(drive);
        if let Input::Pull(pull) = self.drive.cables[0].input {
            self.set_pull(pull);
        }
    }

    /// Replaces one obstacle.
    ///
    /// # Panics
    /// If there is no obstacle of that index.
    pub fn set_obstacle(&mut self, index: usize, obstacle: Obstacle) {
        self.around.set_obstacle(index, obstacle);
    }

    /// The same robot with another bending stiffness, in N m².
    pub fn with_stiffness(&self, stiffness: f64) -> Self {
        let mut stiff = self.clone();
        stiff.drive.stiffness = Some(stiffness);
        stiff
    }

    /// The same robot with nothing around it.
    pub fn without_obstacles(&self) -> Self {
        let candidates = self.candidates().to_vec();
        let around = Surroundings::new(&self.robot, candidates, Vec::new());
        Self::of(self.robot, self.model, self.drive.clone(), around)
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
        self.robot.moves_like(&other.robot)
            && self.model == other.model
            && self.drive.resembles(&other.drive)
            && self.around.resembles(&other.around)
    }

    /// Whether another problem is this one, but perhaps for the pull and for sizes
    /// that touch nothing.
    pub fn same_but_for_pull(&self, other: &Self) -> bool {
        self.robot.moves_like(&other.robot)
            && self.model == other.model
            && self.drive.resembles(&other.drive)
            && self.drive.loads == other.drive.loads
            && self.drive.friction == other.drive.friction
            && self.around.same(&other.around)
    }

    /// Whether the same parts of the robot may touch in both.
    pub fn same_candidates(&self, other: &Self) -> bool {
        self.around.same_candidates(&other.around)
    }

    /// Becomes the problem a share `t` in \[0, 1\] of the way from `a` to `b`,
    /// which resemble each other and this one. Allocates nothing.
    pub fn set_between(&mut self, a: &Self, b: &Self, t: f64) {
        self.drive.set_between(&a.drive, &b.drive, t);
        if let Input::Pull(pull) = self.drive.cables[0].input {
            self.set_pull(pull);
        }
        self.around.set_between(&a.around, &b.around, t);
    }
}

fn is_in_range(robot: &Robot, model: Model, drive: &Drive) -> bool {
    let (least, most) = Problem::pulls(robot, model);
    (least..=most).contains(&drive.pull())
}

fn segment(robot: &Robot, model: Model, drive: &Drive) -> FourBar {
    let n = robot.segments as f64;
    let pull = match model {
        Model::Equal => drive.pull(),
        Model::Sliding => 0.0,
    };
    FourBar::new(robot.length / n, pull / n, robot.offset)
}
