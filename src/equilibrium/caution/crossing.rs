//! Obstacles that the robot's body crosses where its candidates do not see
//! them. What candidates do see is the certificate's business.

use super::Caution;
use crate::geometry::{Core, Obstacle, Vector, cross};
use crate::mechanics::Problem;
use crate::robot::{Candidate, Line, PlanarNode};

/// Depths below this share of the backbone's length are not told, unless the
/// obstacle is thin: where a chain of nodes bends round an obstacle, the link
/// beside a touching node always cuts it a little.
const UNTOLD: f64 = 1e-3;
/// Share of its own half width that a thin obstacle may be cut.
const UNTOLD_WIDTH: f64 = 0.5;

/// A caution for each obstacle that the body crosses unseen, by its index.
pub(super) fn find(problem: &Problem, nodes: &[PlanarNode]) -> Vec<Caution> {
    let unseen = unseen(problem);
    if unseen.is_empty() {
        return Vec::new();
    }
    let obstacles = problem.obstacles().iter().enumerate();
    let found = obstacles.filter_map(|(index, obstacle)| {
        deepest(problem, nodes, &unseen, (index, obstacle))
            .or_else(|| enclosing(problem, nodes, &unseen, (index, obstacle)))
    });
    found.collect()
}

/// The parts of the body that are not candidates as they are, by node.
fn unseen(problem: &Problem) -> Vec<Candidate> {
    let key = |part: &Candidate| (part.node, part.line);
    let mut seen: Vec<&Candidate> = problem.candidates().iter().collect();
    seen.sort_by_key(|part| key(part));
    let robot = problem.robot();
    let parts = (0..=robot.segments).flat_map(|node| robot.parts(node));
    parts
        .filter(|part| {
            let found = seen.binary_search_by_key(&key(part), |other| key(other));
            found.map_or(part.node > 0 || !sees_base(problem), |place| {
                *seen[place] != *part
            })
        })
        .collect()
}

/// Whether the whole first disk was kept clear when the problem was made: it
/// cannot move, and so it is no candidate.
fn sees_base(problem: &Problem) -> bool {
    let mut candidates = problem.candidates().iter();
    candidates.any(|part| part.line == Line::DiskFace)
}

/// The part that is deepest inside an obstacle.
fn deepest(
    problem: &Problem,
    nodes: &[PlanarNode],
    unseen: &[Candidate],
    (index, obstacle): (usize, &Obstacle),
) -> Option<Caution> {
    let untold = (UNTOLD * problem.length()).min(UNTOLD_WIDTH * obstacle.half_width());
    let mut deepest: Option<(f64, &Candidate)> = None;
    for part in unseen {
        let (start, end) = part.ends(nodes);
        if obstacle.is_beyond(start, (end - start).norm() + part.radius) {
            continue;
        }
        let least = deepest.map_or(untold, |(depth, _)| depth);
        let mut depth = least;
        part.clearances(nodes, obstacle, |_, clearance| {
            depth = depth.max(-clearance)
        });
        if depth > least {
            deepest = Some((depth, part));
        }
    }
    deepest.map(|(depth, part)| Caution::Crosses {
        line: part.line,
        node: part.node,
        obstacle: index,
        depth,
    })
}

/// The segment between whose links an obstacle stands that nothing crosses.
fn enclosing(
    problem: &Problem,
    nodes: &[PlanarNode],
    unseen: &[Candidate],
    (index, obstacle): (usize, &Obstacle),
) -> Option<Caution> {
    if matches!(obstacle.core(), Core::HalfPlane) {
        return None;
    }
    let offset = problem.robot().offset;
    let middle = obstacle.position();
    let within = |node: usize| {
        let (below, above) = (&nodes[node - 1], &nodes[node]);
        let round = [
            below.position,
            below.at(offset),
            above.at(offset),
            above.position,
        ];
        holds(&round, middle)
    };
    let node = (1..nodes.len()).find(|node| within(*node))?;
    let mut links = unseen.iter().filter(|part| !part.line.is_point());
    links
        .any(|part| part.node == node)
        .then_some(Caution::Encloses {
            node,
            obstacle: index,
        })
}

/// Whether a convex polygon, counterclockwise, holds a point.
fn holds(round: &[Vector; 4], point: Vector) -> bool {
    (0..4).all(|i| cross(round[(i + 1) % 4] - round[i], point - round[i]) >= 0.0)
}
