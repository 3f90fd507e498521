//! The smallest robot, in any assembly of its one linkage, held by a post with
//! a force that balances by hand.

use sinew::contact::{Class, Contact};
use sinew::geometry::{Core, Obstacle, Vector, perpendicular};
use sinew::mechanics::Problem;
use sinew::robot::{Candidate, Element, Joins, Line, PlanarNode, Robot, Sizes};

/// A backbone and a cable point a node.
pub type Points = Vec<(Vector, Vector)>;

/// A robot of one segment whose one node of the cable presses on a post, in
/// any of the four assemblies of its linkage; with the balance of forces by
/// hand: the segment's one motion turns its links alone.
pub struct OneSegment {
    pub problem: Problem,
    pub points: Points,
    /// How the two points move …
    pub backbone_rate: Vector,
    pub cable_rate: Vector,
    /// … and the energy with them.
    pub energy_rate: f64,
}

/// The backbone's link, in metres.
pub const BACKBONE: f64 = 7e-3;
/// The cable's link.
pub const CABLE: f64 = 6.8e-3;
/// The cable offset.
pub const OFFSET: f64 = 8e-3;

impl OneSegment {
    /// Both links reach `along` towards the mean disk direction; `left` are
    /// the sides of it that the backbone's and the cable's link point to.
    pub fn new(along: f64, left: [f64; 2]) -> Self {
        let up = |length: f64| (length * length - along * along).sqrt();
        let up = [left[0] * up(BACKBONE), left[1] * up(CABLE)];
        // The links' difference across the mean direction turns the disk.
        let half = ((up[0] - up[1]) / (2.0 * OFFSET)).asin();
        let mean = Vector::new(half.cos(), -half.sin());
        let across = perpendicular(mean);
        let base = (Vector::zeros(), Vector::new(OFFSET, 0.0));
        let top = (
            along * mean + up[0] * across,
            base.1 + along * mean + up[1] * across,
        );
        let disk = top.1 - top.0;
        let (b, k) = (
            perpendicular(top.0).normalize(),
            perpendicular(top.1 - base.1).normalize(),
        );
        let (backbone_rate, cable_rate) = (disk.dot(&k) * b, disk.dot(&b) * k);
        let turn = perpendicular(disk).dot(&(cable_rate - backbone_rate));
        let robot = Robot {
            length: BACKBONE,
            segments: 1,
            segments_per_bay: 1,
            offset: OFFSET,
            sizes: Sizes {
                rim: OFFSET,
                disk: 0.0,
                backbone: 0.0,
                cable: 0.0,
            },
            base: PlanarNode {
                position: base.0,
                disk: Vector::x(),
                angle: 0.0,
            },
        };
        let candidates = vec![Candidate {
            line: Line::Cable,
            node: 1,
            element: Element::Point { lever: OFFSET },
            radius: 0.0,
            joins: Joins::Nothing,
            span: 1,
            cable: 0,
        }];
        let post = Obstacle::new(Core::Point, 1e-3, Vector::zeros(), 0.0);
        Self {
            problem: Problem::from_parts(robot, BACKBONE - CABLE, candidates, vec![post]),
            points: vec![base, top],
            backbone_rate,
            cable_rate,
            energy_rate: 2.0 * (2.0 * half) * -turn / disk.norm_squared(),
        }
    }

    /// The contact of the node with a post that holds it; sets the post there.
    pub fn hold(&mut self) -> Contact {
        let to_the_side = Vector::new(0.6, 0.8);
        let towards = self.energy_rate * self.cable_rate.dot(&to_the_side);
        let normal = towards.signum() * to_the_side;
        let point = self.points[1].1;
        let post = Obstacle::new(Core::Point, 1e-3, point - 1e-3 * normal, 0.0);
        self.problem.set_obstacle(0, post);
        Contact {
            candidate: 0,
            line: Line::Cable,
            cable: 0,
            node: 1,
            obstacle: 0,
            vertex: None,
            along: 1.0,
            point,
            normal,
            clearance: 0.0,
            multiplier: self.energy_rate / self.cable_rate.dot(&normal),
            friction: 0.0,
            slid: 0.0,
            class: Class::Pressing,
        }
    }

    /// The same with a post beside the inside of the cable's link.
    pub fn hold_link(&mut self) -> Contact {
        let along = 0.6;
        let (start, end) = (self.points[0].1, self.points[1].1);
        let link = end - start;
        let across = perpendicular(link).normalize();
        let normal = (self.energy_rate * self.cable_rate.dot(&across)).signum() * across;
        let point = start + along * link;
        let element = Element::Link { lever: OFFSET };
        let candidates = vec![Candidate {
            element,
            line: Line::CableLink,
            ..self.problem.candidates()[0]
        }];
        let post = Obstacle::new(Core::Point, 1e-3, point - 1e-3 * normal, 0.0);
        let (robot, pull) = (*self.problem.robot(), self.problem.pull());
        self.problem = Problem::from_parts(robot, pull, candidates, vec![post]);
        Contact {
            candidate: 0,
            line: Line::CableLink,
            cable: 0,
            node: 1,
            obstacle: 0,
            vertex: Some(0),
            along,
            point,
            normal,
            clearance: 0.0,
            multiplier: self.energy_rate / (along * self.cable_rate.dot(&normal)),
            friction: 0.0,
            slid: 0.0,
            class: Class::Pressing,
        }
    }
}
