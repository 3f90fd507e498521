//! Where obstacles start when they appear on top of the robot: shrunk to
//! almost nothing on one side of it, from where growing pushes it aside.
//!
//! A convex outline shrunk towards one of its own extreme points stays inside
//! itself while it grows back, so nothing that is clear of the whole obstacle,
//! the base above all, is touched on the way.

use crate::geometry::{Core, Obstacle, Vector};
use crate::model::{PlanarNode, Problem};

/// Scale an obstacle starts from. Not zero, so that a half-plane's surface and
/// a polygon's edges keep their directions.
const SEED: f64 = 1e-3;

/// An obstacle's start, where it differs from its place.
pub(super) struct Seed {
    /// What to start from.
    pub obstacle: Obstacle,
    /// The unit direction in which growing it pushes the robot.
    pub direction: Vector,
}

/// The seed of an obstacle that overlaps the robot's nodes; `None` where it is
/// clear of them.
pub(super) fn seed(problem: &Problem, obstacle: &Obstacle, nodes: &[PlanarNode]) -> Option<Seed> {
    // One that only touches is clear: which of the two it is, rounding must
    // not decide.
    let touching = -problem.robot().touching();
    let mut deepest = (touching, None);
    let mut points = Vec::new();
    for candidate in problem.candidates() {
        let mut least = f64::INFINITY;
        candidate.clearances(nodes, obstacle, |_, clearance| least = least.min(clearance));
        if least < touching {
            let (start, end) = candidate.ends(nodes);
            points.push((start, candidate.radius));
            points.push((end, candidate.radius));
        }
        if least < deepest.0 {
            deepest = (least, Some(candidate.node));
        }
    }
    let node = &nodes[deepest.1?];
    if matches!(obstacle.core(), Core::HalfPlane) {
        return Some(behind_wall(obstacle, nodes));
    }
    // To either side along the deepest disk: how far the overlapping parts
    // would have to go. The cable's side first, for a tie.
    let push = |direction: Vector| {
        let extent = obstacle.support(direction).unwrap_or(0.0);
        points
            .iter()
            .map(|(point, radius)| extent + radius - direction.dot(point))
            .fold(0.0, f64::max)
    };
    let towards_cable = push(node.disk);
    let away = push(-node.disk);
    let direction = if towards_cable <= away {
        node.disk
    } else {
        -node.disk
    };
    Some(Seed {
        obstacle: obstacle.shrunk(foot(obstacle, problem, nodes, direction), SEED),
        direction,
    })
}

/// The obstacle's extreme point against `direction`, moved on until it is
/// beside the whole robot.
fn foot(obstacle: &Obstacle, problem: &Problem, nodes: &[PlanarNode], direction: Vector) -> Vector {
    let extent = obstacle.support(-direction).unwrap_or(0.0);
    let lowest = problem
        .candidates()
        .iter()
        .filter_map(|candidate| {
            let (start, end) = candidate.ends(nodes);
            let near = !obstacle.is_beyond(start, (end - start).norm() + candidate.radius);
            let height = direction.dot(&start).min(direction.dot(&end));
            near.then_some(height - candidate.radius)
        })
        .fold(-extent, f64::min);
    let place = obstacle.position();
    let beside = lowest - 1e-3 * problem.length();
    place + (beside.min(-extent) - direction.dot(&place)) * direction
}

/// A wall starts beyond all nodes.
fn behind_wall(wall: &Obstacle, nodes: &[PlanarNode]) -> Seed {
    let depth = nodes
        .iter()
        .map(|node| -wall.clearance(node.position).distance)
        .fold(0.0, f64::max);
    let normal = wall.clearance(nodes[0].position).normal;
    // The candidates reach beyond the nodes by less than the robot is long.
    let span = (nodes[nodes.len() - 1].position - nodes[0].position).norm();
    Seed {
        obstacle: wall.moved(-(depth + span) * normal),
        direction: normal,
    }
}
