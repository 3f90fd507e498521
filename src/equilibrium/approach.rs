//! Where obstacles start when they appear on top of the robot: shrunk to
//! almost nothing on one side of it, from where growing pushes it aside.
//!
//! A convex outline shrunk towards one of its own extreme points stays inside
//! itself while it grows back, so nothing that is clear of the whole obstacle,
//! the base above all, is touched on the way.

use crate::geometry::{Core, Obstacle, Vector};
use crate::mechanics::Problem;
use crate::robot::Nodes;

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
pub(super) fn seed<N: Nodes + ?Sized>(
    problem: &Problem,
    obstacle: &Obstacle,
    nodes: &N,
) -> Option<Seed> {
    // One that only touches is clear: which of the two it is, rounding must
    // not decide.
    let touching = -problem.robot().touching();
    let mut deepest = (touching, None);
    let mut points = Vec::new();
    for candidate in problem.candidates() {
        let least = candidate.least_clearance(nodes, obstacle);
        if least < touching {
            let (start, end) = candidate.ends(nodes);
            points.push((start, candidate.radius));
            points.push((end, candidate.radius));
        }
        if least < deepest.0 {
            deepest = (least, Some(candidate.node));
        }
    }
    let node = nodes.node(deepest.1?);
    if matches!(obstacle.core(), Core::HalfPlane) {
        return Some(behind_wall(problem, obstacle, nodes));
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
fn foot<N: Nodes + ?Sized>(
    obstacle: &Obstacle,
    problem: &Problem,
    nodes: &N,
    direction: Vector,
) -> Vector {
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

/// A wall starts beyond all parts that may touch.
fn behind_wall<N: Nodes + ?Sized>(problem: &Problem, wall: &Obstacle, nodes: &N) -> Seed {
    let depth = nodes
        .each()
        .map(|node| -wall.clearance(node.position).distance)
        .fold(0.0, f64::max);
    let normal = wall.clearance(nodes.node(0).position).normal;
    let candidates = problem.candidates().iter();
    let reach = candidates.map(|candidate| candidate.lever() + candidate.radius);
    let beyond = reach.fold(0.0, f64::max) + 1e-3 * problem.length();
    Seed {
        obstacle: wall.moved(-(depth + beyond) * normal),
        direction: normal,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mechanics::{Equal, Mechanics};
    use crate::robot::PlanarNode;
    use crate::scene::{Candidates, Scene, Shape};
    use crate::solver::Chain;

    /// The straight robot's problem and nodes, with an obstacle over it.
    fn straight(shape: Shape, candidates: Candidates, place: ([f64; 2], f64)) -> Problem {
        let mut scene = Scene::default();
        scene.robot.base_mm = place.0;
        scene.robot.base_angle_deg = place.1;
        scene.set_pull_mm(0.0);
        scene.contact.candidates = candidates;
        scene.robot.disk_thickness_mm = 2.0;
        scene.obstacles = vec![shape.into()];
        Problem::new(&scene).unwrap()
    }

    fn nodes(problem: &Problem) -> Vec<PlanarNode> {
        let problem = Equal::new(problem.clone());
        let mut nodes = vec![problem.base()];
        for k in 1..=problem.stages() {
            let free = problem.free_controls()[k - 1];
            nodes.push(problem.stage(k, &nodes[k - 1], &free).0);
        }
        nodes
    }

    /// What a seed has to be: clear of the robot, with nothing but the way it
    /// pushes between the robot and it; part of the obstacle it grows into, or
    /// beside the robot; and on the side with the shorter way out.
    fn check(shape: &Shape, candidates: Candidates, side: f64) {
        for place in [([0.0, 0.0], 0.0), ([300.0, -200.0], 0.0)] {
            let mut shape = shape.clone();
            let [x, y] = place.0;
            match &mut shape {
                Shape::Disc { center_mm, .. }
                | Shape::Box { center_mm, .. }
                | Shape::Capsule { center_mm, .. } => {
                    center_mm[0] += x;
                    center_mm[1] += y;
                }
                Shape::Wall { point_mm, .. } => {
                    point_mm[0] += x;
                    point_mm[1] += y;
                }
                Shape::Polygon { .. } => unreachable!(),
            }
            let problem = straight(shape.clone(), candidates, place);
            let nodes = nodes(&problem);
            let obstacle = &problem.obstacles()[0];
            let seed = seed(&problem, obstacle, &nodes).unwrap();
            let expected = Vector::new(side, 0.0);
            assert!(
                (seed.direction - expected).norm() < 1e-12,
                "{shape:?} {:?}",
                seed.direction
            );
            for candidate in problem.candidates() {
                candidate.clearances(&nodes, &seed.obstacle, |_, clearance| {
                    assert!(clearance > 0.0, "{shape:?}: {clearance}");
                });
                let (start, end) = candidate.ends(&nodes);
                if let Some(extent) = seed.obstacle.support(seed.direction) {
                    let least = seed.direction.dot(&start).min(seed.direction.dot(&end));
                    assert!(extent < least - candidate.radius, "{shape:?}");
                }
            }
            if matches!(obstacle.core(), Core::HalfPlane) {
                // As far behind the robot as the wall's depth over it, twice at
                // most, and not without end.
                let back = obstacle.change(&seed.obstacle);
                assert!(back > 0.0 && back < 2.0 * problem.length());
                continue;
            }
            // A thousandth of the size, at its outermost part or beyond it.
            assert!(seed.obstacle.change(obstacle) > 0.0);
            for degrees in 0..36 {
                let (sine, cosine) = (f64::from(degrees) * 10.0).to_radians().sin_cos();
                let direction = Vector::new(cosine, sine);
                let width =
                    |o: &Obstacle| o.support(direction).unwrap() + o.support(-direction).unwrap();
                let ratio = width(&seed.obstacle) / width(obstacle);
                assert!((ratio - SEED).abs() < 1e-9, "{shape:?}: {ratio}");
            }
            let back = obstacle.support(-seed.direction).unwrap();
            let start = seed.obstacle.support(-seed.direction).unwrap();
            assert!(start >= back - 1e-12, "{shape:?}");
        }
    }

    #[test]
    fn seeds_are_clear_of_the_robot_on_the_nearer_side() {
        let disc = |x: f64, radius_mm: f64| Shape::Disc {
            center_mm: [x, 110.0],
            radius_mm,
        };
        let bar = |x: f64| Shape::Box {
            center_mm: [x, 115.0],
            size_mm: [60.0, 4.0],
            rotation_deg: 20.0,
            corner_radius_mm: 1.0,
        };
        let wall = |x: f64, rotation_deg: f64| Shape::Wall {
            point_mm: [x, 170.0],
            rotation_deg,
            corner_radius_mm: 0.0,
        };
        for candidates in [Candidates::Nodes, Candidates::Body] {
            check(&disc(-6.0, 12.0), candidates, 1.0);
            check(&disc(14.0, 12.0), candidates, -1.0);
            check(&bar(-15.0), candidates, 1.0);
            check(&bar(25.0), candidates, -1.0);
        }
        // Reaching over the whole robot: its middle decides, of the nodes or of
        // the disks.
        check(&disc(1.0, 30.0), Candidates::Nodes, 1.0);
        check(&disc(7.0, 30.0), Candidates::Nodes, -1.0);
        check(&disc(-1.0, 30.0), Candidates::Body, 1.0);
        check(&disc(1.0, 30.0), Candidates::Body, -1.0);
        let problem = straight(wall(7.0, 190.0), Candidates::Nodes, ([0.0, 0.0], 0.0));
        let nodes = nodes(&problem);
        let seed = seed(&problem, &problem.obstacles()[0], &nodes).unwrap();
        for node in &nodes {
            assert!(seed.obstacle.clearance(node.at(0.008)).distance > 0.0);
        }
        let normal = Vector::new(190f64.to_radians().cos(), 190f64.to_radians().sin());
        assert!((seed.direction - normal).norm() < 1e-12);
    }

    /// A post between the backbone and the cable starts beyond the cable; what
    /// is far from the post does not push its start away.
    #[test]
    fn a_seed_starts_beside_what_is_near() {
        let inside = Shape::Disc {
            center_mm: [1.0, 115.0],
            radius_mm: 2.0,
        };
        check(&inside, Candidates::Body, -1.0);
        let mut problem = straight(inside, Candidates::Nodes, ([0.0, 0.0], 0.0));
        problem.set_pull(0.012);
        let bent = nodes(&problem);
        for k in [6, 12, 18] {
            let over = bent[k].position - 2e-3 * bent[k].disk;
            let post = Obstacle::new(Core::Point, 5e-3, over, 0.0);
            let seed = seed(&problem, &post, &bent).unwrap();
            let apart = (seed.obstacle.position() - over).norm();
            assert!((4e-3..16e-3).contains(&apart), "{k}: {apart}");
        }
    }

    #[test]
    fn what_is_clear_of_the_robot_needs_no_seed() {
        let disc = Shape::Disc {
            center_mm: [21.0, 110.0],
            radius_mm: 12.0,
        };
        let problem = straight(disc, Candidates::Nodes, ([0.0, 0.0], 0.0));
        assert!(seed(&problem, &problem.obstacles()[0], &nodes(&problem)).is_none());
    }
}
