//! A planar problem: a robot, a pull, candidates and obstacles, checked once.

use super::candidate::{Candidate, DiskPoint, Element};
use super::four_bar::FourBar;
use super::node::PlanarNode;
use super::robot::Robot;
use super::rows;
use crate::geometry::{Obstacle, Vector, perpendicular};
use crate::solver::{Chain, Control, DynamicsCurvature, Row, RowCurvature, Stage, State};
use nalgebra::{SMatrix, matrix, vector};
use serde::de::Error;
use serde::{Deserialize, Deserializer, Serialize, Serializer};
use std::borrow::Cow;
use std::sync::Arc;

/// A robot among obstacles at a pull. Every value of it can be solved for or
/// shown not to be solvable; none is malformed.
///
/// Clone with `clone_from` where one exists already: it reuses the storage.
#[derive(Debug)]
pub struct Problem {
    robot: Robot,
    pull: f64,
    segment: FourBar,
    /// Shared by all clones: a fine robot has many.
    candidates: Arc<[Candidate]>,
    /// The greatest lever of a candidate.
    reach: f64,
    obstacles: Vec<Obstacle>,
}

impl Clone for Problem {
    fn clone(&self) -> Self {
        Self {
            robot: self.robot,
            pull: self.pull,
            segment: self.segment,
            candidates: Arc::clone(&self.candidates),
            reach: self.reach,
            obstacles: self.obstacles.clone(),
        }
    }

    fn clone_from(&mut self, source: &Self) {
        self.robot = source.robot;
        self.pull = source.pull;
        self.segment = source.segment;
        self.candidates = Arc::clone(&source.candidates);
        self.reach = source.reach;
        self.obstacles.clone_from(&source.obstacles);
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
            candidates: Cow::Borrowed(&self.candidates),
            obstacles: Cow::Borrowed(&self.obstacles),
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
        assert!((least..=most).contains(&pull), "a pull of {pull} m");
        Self {
            robot,
            pull,
            segment: segment(&robot, pull),
            reach: candidates.iter().map(Candidate::lever).fold(0.0, f64::max),
            candidates: candidates.into(),
            obstacles,
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
        &self.candidates
    }

    /// The obstacles, in the order of the scene.
    pub fn obstacles(&self) -> &[Obstacle] {
        &self.obstacles
    }

    /// Sets the pull, clamped to the robot's range.
    ///
    /// # Panics
    /// If the pull is not a number: a bug of the caller.
    pub fn set_pull(&mut self, pull: f64) {
        assert!(!pull.is_nan(), "a pull that is not a number");
        let (least, most) = self.robot.pull_range();
        self.pull = pull.clamp(least, most);
        self.segment = segment(&self.robot, self.pull);
    }

    /// Replaces one obstacle.
    ///
    /// # Panics
    /// If there is no obstacle of that index.
    pub fn set_obstacle(&mut self, index: usize, obstacle: Obstacle) {
        self.obstacles[index] = obstacle;
    }

    /// The problem moved as a whole by a vector.
    pub fn moved(&self, by: Vector) -> Self {
        let mut moved = self.clone();
        moved.robot.base.position += by;
        for obstacle in &mut moved.obstacles {
            *obstacle = obstacle.moved(by);
        }
        moved
    }

    /// Whether the same robot meets obstacles of the same kinds in both, so
    /// that one can be moved into the other.
    pub fn resembles(&self, other: &Self) -> bool {
        self.robot.moves_like(&other.robot)
            && self.same_candidates(other)
            && self.obstacles.len() == other.obstacles.len()
            && self
                .obstacles
                .iter()
                .zip(&other.obstacles)
                .all(|(a, b)| a.resembles(b))
    }

    /// Whether another problem is this one but for the pull and for sizes that
    /// touch nothing.
    pub fn differs_in_pull_only(&self, other: &Self) -> bool {
        let mut pairs = self.obstacles.iter().zip(&other.obstacles);
        self.robot.moves_like(&other.robot)
            && self.same_candidates(other)
            && self.obstacles.len() == other.obstacles.len()
            && pairs.all(|(a, b)| a.resembles(b) && a.change(b) == 0.0)
    }

    /// Whether the same parts of the robot may touch in both.
    pub fn same_candidates(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.candidates, &other.candidates) || self.candidates == other.candidates
    }

    /// Becomes the problem a share `t` in \[0, 1\] of the way from `a` to `b`,
    /// which resemble each other and this one. Allocates nothing.
    pub fn set_between(&mut self, a: &Self, b: &Self, t: f64) {
        self.set_pull((1.0 - t) * a.pull + t * b.pull);
        for ((to, a), b) in self
            .obstacles
            .iter_mut()
            .zip(&a.obstacles)
            .zip(&b.obstacles)
        {
            to.set_between(a, b, t);
        }
    }

    /// The controls of the free robot, straight or an arc: no turn anywhere.
    pub fn free_controls(&self) -> Vec<Control<1>> {
        vec![Control::zeros(); self.robot.segments]
    }

    /// Whether a point of the robot dips into an obstacle on the straight way
    /// between two shapes, and the obstacle's normal there turns by more than
    /// an angle with the cosine `most_turn(candidate, obstacle)`. The
    /// obstacles move meanwhile from where they are here to where they are in
    /// `later`. Points that move less than a thousandth of the robot's length
    /// are not looked at: at a sharp corner every motion would count.
    pub fn motion_dips(
        &self,
        later: &Self,
        from: &[PlanarNode],
        to: &[PlanarNode],
        most_turn: impl Fn(usize, usize) -> f64,
    ) -> bool {
        let least = 1e-3 * self.robot.length;
        let moved = self.greatest_motion(from, to);
        let mut pairs = self.obstacles.iter().zip(&later.obstacles).enumerate();
        pairs.any(|(index, (now, then))| {
            let moved = moved + now.change(then);
            let mut candidates = self.candidates.iter().enumerate();
            moved > least
                && candidates.any(|(number, candidate)| {
                    let Element::Point { .. } = candidate.element else {
                        return false;
                    };
                    let way = (candidate.ends(from).0, candidate.ends(to).0);
                    now.point_dips(then, way, candidate.radius, (least, moved))
                        .is_some_and(|turned| turned < most_turn(number, index))
                })
        })
    }

    /// Whether a candidate would pass through an obstacle that moves from
    /// where it is here to where it is in `later`, while the robot's nodes
    /// move straight.
    pub fn motion_passes(&self, later: &Self, from: &[PlanarNode], to: &[PlanarNode]) -> bool {
        // Rounding of the nodes' places.
        let tolerance = 1e-12 * self.robot.length;
        let moved = self.greatest_motion(from, to);
        let mut pairs = self.obstacles.iter().zip(&later.obstacles);
        pairs.any(|(now, then)| {
            let moved = moved + now.change(then);
            self.candidates.iter().any(|candidate| {
                let before = candidate.ends(from);
                let after = || candidate.ends(to);
                match candidate.element {
                    Element::Point { .. } => {
                        !now.is_beyond(before.0, candidate.radius + moved)
                            && now.point_passes(
                                then,
                                (before.0, after().0),
                                candidate.radius,
                                moved,
                            )
                    }
                    _ => {
                        let after = after();
                        let ends = ((before.0, after.0), (before.1, after.1));
                        now.edge_passes(then, ends, tolerance, moved)
                    }
                }
            })
        })
    }

    /// What no point of a disk that may touch moves farther than between two
    /// shapes, in metres: at most twice what some point does.
    pub fn greatest_motion(&self, from: &[PlanarNode], to: &[PlanarNode]) -> f64 {
        2.0 * self.greatest_shift(from, to)
    }

    /// Half of what no point of a disk moves farther than: its node's motion,
    /// or its lever times the change of the disk's direction if that is more.
    fn greatest_shift(&self, from: &[PlanarNode], to: &[PlanarNode]) -> f64 {
        let shift = |(a, b): (&PlanarNode, &PlanarNode)| {
            let moved = (b.position - a.position).norm_squared();
            moved.max(self.reach * self.reach * (b.disk - a.disk).norm_squared())
        };
        from.iter().zip(to).map(shift).fold(0.0, f64::max).sqrt()
    }
}

fn segment(robot: &Robot, pull: f64) -> FourBar {
    let n = robot.segments as f64;
    FourBar::new(robot.length / n, pull / n, robot.offset)
}

/// What a segment keeps for the second derivative of its step, in the world.
#[derive(Clone, Copy, Debug)]
pub struct Bend {
    step: Vector,
    rate: Vector,
    acceleration: Vector,
    bend_acceleration: f64,
}

impl Chain<3, 1> for Problem {
    type Node = PlanarNode;
    type Bend = Bend;

    fn stages(&self) -> usize {
        self.robot.segments
    }

    fn base(&self) -> PlanarNode {
        self.robot.base
    }

    fn row_scale(&self) -> f64 {
        self.robot.length
    }

    fn longest_step(&self) -> f64 {
        0.5
    }

    fn stage(
        &self,
        _k: usize,
        from: &PlanarNode,
        control: &Control<1>,
    ) -> (PlanarNode, Stage<3, 1>, Bend) {
        let shape = self.segment.at(control[0]);
        let world = |v: Vector| v.x * from.disk + v.y * from.normal();
        let [step, rate, acceleration] = shape.step.map(world);
        let (cosine, sine) = (shape.rotation.x, shape.rotation.y);
        let disk = Vector::new(
            cosine * from.disk.x + sine * from.disk.y,
            cosine * from.disk.y - sine * from.disk.x,
        );
        let node = PlanarNode {
            position: from.position + step,
            // One Newton step towards unit length, so that rounding does not
            // add up along the chain.
            disk: disk * (1.5 - 0.5 * disk.norm_squared()),
            angle: from.angle - shape.bend[0],
        };
        let swing = perpendicular(step);
        let stage = Stage {
            by_state: matrix![1.0, 0.0, swing.x; 0.0, 1.0, swing.y; 0.0, 0.0, 1.0],
            by_control: matrix![rate.x; rate.y; -shape.bend[1]],
            cost: shape.cost[0],
            cost_gradient: vector![shape.cost[1]],
            cost_curvature: matrix![shape.cost[2]],
        };
        let bend = Bend {
            step,
            rate,
            acceleration,
            bend_acceleration: shape.bend[2],
        };
        (node, stage, bend)
    }

    fn dynamics_curvature(&self, bend: &Bend, adjoint: &State<3>) -> DynamicsCurvature<3, 1> {
        let force = Vector::new(adjoint[0], adjoint[1]);
        let mut by_state = SMatrix::zeros();
        by_state[(2, 2)] = -force.dot(&bend.step);
        let turned = force.dot(&perpendicular(bend.rate));
        let turn = force.dot(&bend.acceleration) - adjoint[2] * bend.bend_acceleration;
        DynamicsCurvature {
            by_state,
            mixed: matrix![0.0; 0.0; turned],
            by_control: matrix![turn],
        }
    }

    fn rows(&self, nodes: &[PlanarNode], controls: &[Control<1>], rows: &mut Vec<Row<3, 1>>) {
        rows.clear();
        // A row farther away is met after any one iteration that the line
        // search accepts, or is seen in the next.
        let margin = 0.05 * self.robot.length;
        for candidate in 0..self.candidates.len() {
            rows::contact_rows(self, candidate, nodes, margin, rows);
        }
        rows::limit_rows(self, controls, self.longest_step(), rows);
    }

    fn row_curvature(&self, row: &Row<3, 1>, nodes: &[PlanarNode]) -> RowCurvature<3> {
        rows::contact_curvature(self, row, nodes)
    }

    fn passes_through(&self, from: &[PlanarNode], to: &[PlanarNode]) -> bool {
        self.motion_passes(self, from, to)
    }
}

/// Where a candidate is nearest to an obstacle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Place {
    /// The candidate's point or the point of its edge, in metres.
    pub point: Vector,
    /// The unit normal from the obstacle.
    pub normal: Vector,
    /// Where on its edge, from 0 to 1, and beyond by a little in the notch between
    /// two links; 1 for a point.
    pub along: f64,
}

impl Candidate {
    /// Where the candidate is nearest to an obstacle, for an edge to one of
    /// its vertices.
    pub fn place(&self, nodes: &[PlanarNode], obstacle: &Obstacle, vertex: Option<usize>) -> Place {
        let (start, end) = self.ends(nodes);
        let clearance = self.point_clearance(nodes, obstacle);
        let mut place = Place {
            point: end,
            normal: clearance.unwrap_or_else(|| obstacle.clearance(end)).normal,
            along: 1.0,
        };
        let facing = vertex.and_then(|v| obstacle.edge_clearance(&self.edge(nodes), v));
        if let Some(clearance) = facing {
            place = Place {
                point: start + clearance.along * (end - start),
                normal: clearance.normal,
                along: clearance.along,
            };
        }
        place
    }

    /// The clearances of this candidate from an obstacle, each with its
    /// vertex: one for a point, any number for an edge, and one without a
    /// vertex for an edge that crosses the obstacle's core.
    pub fn clearances(
        &self,
        nodes: &[PlanarNode],
        obstacle: &Obstacle,
        mut each: impl FnMut(Option<usize>, f64),
    ) {
        let (start, end) = self.ends(nodes);
        match self.element {
            Element::Point { lever } => {
                let point = DiskPoint {
                    node: &nodes[self.node],
                    lever,
                };
                let clearance = obstacle.clearance(point.node.at(lever));
                each(None, clearance.distance - self.radius);
            }
            _ => {
                if let Some(depth) = obstacle.crossing_depth(start, end) {
                    each(None, -depth - self.radius);
                }
                obstacle.edge_clearances(&self.edge(nodes), |clearance| {
                    each(Some(clearance.vertex), clearance.distance - self.radius);
                });
            }
        }
    }
}
