//! The rows of obstacles and limits, each by itself: its name, whether it is
//! there, and its derivatives in the states of its nodes against differences.

mod crowded;

use crowded::{controls, crowded};
use sinew::contact::RowKind;
use sinew::geometry::Vector;
use sinew::mechanics::{Equal, Mechanics};
use sinew::robot::{Element, PlanarNode};
use sinew::solver::{Chain, Control, Row, RowCurvature, RowId};

fn nodes(problem: &Equal, controls: &[Control<1>]) -> Vec<PlanarNode> {
    let mut nodes = vec![problem.base()];
    for (k, control) in controls.iter().enumerate() {
        nodes.push(problem.stage(k + 1, &nodes[k], control).0);
    }
    nodes
}

/// Small turns, so that the robot stands among the obstacles.
fn standing(problem: &Equal) -> Vec<PlanarNode> {
    let turns = (0..problem.stages()).map(|i| 0.1 * (1.7 * i as f64).sin());
    let controls: Vec<_> = turns.map(Control::from_element).collect();
    nodes(problem, &controls)
}

fn rows(problem: &Equal, nodes: &[PlanarNode]) -> Vec<Row<3, 1>> {
    let mut rows = Vec::new();
    problem.rows(nodes, &problem.free_controls(), &mut rows);
    rows
}

#[test]
fn ids_name_one_row_each_in_order() {
    let obstacles = 3;
    let mut kinds = Vec::new();
    for candidate in 0..4 {
        for obstacle in 0..obstacles {
            for vertex in [None, Some(0), Some(1), Some(253)] {
                kinds.push(RowKind::Contact {
                    candidate,
                    obstacle,
                    vertex,
                });
            }
        }
    }
    for segment in 1..4 {
        for sign in [-1, 1] {
            kinds.push(RowKind::TurnLimit { segment, sign });
        }
    }
    let ids: Vec<RowId> = kinds.iter().map(|kind| kind.id(obstacles)).collect();
    assert!(ids.windows(2).all(|pair| pair[0] < pair[1]), "{ids:?}");
    for (kind, id) in kinds.iter().zip(&ids) {
        assert_eq!(RowKind::of(*id, obstacles), *kind);
    }
}

/// Rows are there exactly for what is nearer than a twentieth of the length,
/// with the clearance as their value, in the order of their ids.
#[test]
fn what_is_near_has_a_row_and_what_is_far_has_none() {
    let problem = crowded();
    let nodes = standing(&problem);
    let margin = 0.05 * problem.length();
    let count = problem.obstacles().len();
    let mut expected = Vec::new();
    let mut far = 0;
    for (index, candidate) in problem.candidates().iter().enumerate() {
        for (obstacle, shape) in problem.obstacles().iter().enumerate() {
            let mut add = |vertex, distance: f64| {
                let value = distance - candidate.radius;
                let kind = RowKind::Contact {
                    candidate: index,
                    obstacle,
                    vertex,
                };
                if value <= margin {
                    expected.push((kind.id(count), value));
                } else {
                    far += 1;
                }
            };
            if let Element::Point { .. } = candidate.element {
                if let Some(clearance) = candidate.point_clearance(&nodes, shape) {
                    add(None, clearance.distance);
                }
            } else {
                let edge = candidate.edge(&nodes);
                shape.edge_clearances(&edge, |c| add(Some(c.vertex), c.distance));
            }
        }
    }
    assert!(expected.len() > 15 && far > 100, "{} {far}", expected.len());
    let rows = rows(&problem, &nodes);
    let found: Vec<_> = rows.iter().map(|row| (row.id, row.value)).collect();
    assert_eq!(found, expected);
}

/// A node with one of its state's components changed.
fn nudged(node: &PlanarNode, axis: usize, by: f64) -> PlanarNode {
    let mut node = *node;
    if axis < 2 {
        node.position[axis] += by;
    } else {
        node.angle += by;
        node.disk = Vector::new(node.angle.cos(), node.angle.sin());
    }
    node
}

/// Steps of 1e-7 m and rad leave 1e-17/1e-7 of rounding in a gradient, in SI,
/// and 1e-14 over the square of the least distance to a vertex.
#[test]
fn derivatives_in_the_nodes_states_against_differences() {
    let problem = crowded();
    let nodes = standing(&problem);
    let h = 1e-7;
    let mut seen = [0; 3];
    for row in rows(&problem, &nodes) {
        let RowKind::Contact { candidate, .. } = RowKind::of(row.id, problem.obstacles().len())
        else {
            continue;
        };
        let around = |node: usize, axis: usize, by: f64| {
            let mut moved = nodes.clone();
            moved[node] = nudged(&nodes[node], axis, by);
            let found = rows(&problem, &moved);
            found.into_iter().find(|other| other.id == row.id)
        };
        let RowCurvature::States {
            after: own,
            before: parts,
        } = problem.row_curvature(&row, &nodes)
        else {
            panic!("a row of the paper's robot is inside no stage");
        };
        let mut all = true;
        for node in 0..nodes.len() {
            for axis in 0..3 {
                let (Some(after), Some(before)) = (around(node, axis, h), around(node, axis, -h))
                else {
                    all = false;
                    continue;
                };
                let slope = (after.value - before.value) / (2.0 * h);
                let exact = if node == row.stage {
                    row.after[axis]
                } else if node + 1 == row.stage {
                    row.before.map_or(0.0, |before| before[axis])
                } else {
                    0.0
                };
                assert!(
                    (slope - exact).abs() < 1e-8,
                    "{row:?} {node} {axis}: {slope}"
                );
                if node != row.stage && node + 1 != row.stage {
                    continue;
                }
                for other in 0..3 {
                    let bend = (after.after[other] - before.after[other]) / (2.0 * h);
                    let exact = match (node == row.stage, &parts) {
                        (true, _) => own[(other, axis)],
                        (false, Some((_, across))) => across[(axis, other)],
                        (false, None) => 0.0,
                    };
                    assert!(
                        (bend - exact).abs() < 1e-4,
                        "{row:?} {node} {axis}: {bend} {exact}"
                    );
                    if let (false, Some(below), Some(a), Some(b)) =
                        (node == row.stage, parts, after.before, before.before)
                    {
                        let bend = (a[other] - b[other]) / (2.0 * h);
                        let exact = below.0[(other, axis)];
                        assert!((bend - exact).abs() < 1e-4, "{row:?}: {bend} {exact}");
                    }
                }
            }
        }
        seen[match problem.candidates()[candidate].element {
            Element::Point { .. } | Element::OnLink { .. } => 0,
            Element::Link { .. } => 1,
            Element::Across { .. } => 2,
        }] += usize::from(all);
    }
    assert!(seen.iter().all(|count| *count > 2), "{seen:?}");
}

/// Segments within half a radian of the limit, the step a row is trusted for.
#[test]
fn turns_near_their_limit_have_rows_that_fall_towards_it() {
    let problem = crowded();
    let controls = controls(&problem);
    let nodes = nodes(&problem, &controls);
    let at = |controls: &[Control<1>]| {
        let mut rows = Vec::new();
        problem.rows(&nodes, controls, &mut rows);
        let count = problem.obstacles().len();
        let limits = rows
            .into_iter()
            .filter_map(move |row| match RowKind::of(row.id, count) {
                RowKind::TurnLimit { segment, sign } => Some((segment, sign, row)),
                RowKind::Contact { .. } | RowKind::Cable { .. } => None,
            });
        limits.collect::<Vec<_>>()
    };
    let found = at(&controls);
    let which: Vec<_> = found
        .iter()
        .map(|(segment, sign, _)| (*segment, *sign))
        .collect();
    assert_eq!(which, [(4, 1), (8, -1), (13, 1), (17, -1)]);
    let most = problem.segment().most_turn();
    for (index, (segment, _, row)) in found.iter().enumerate() {
        let turn = controls[segment - 1][0];
        assert!((row.value - (most - turn.abs()) * problem.length()).abs() < 1e-15);
        assert_eq!(
            (row.stage, row.before, row.after),
            (*segment, None, nalgebra::zero())
        );
        let mut moved = controls.clone();
        moved[segment - 1][0] += 1e-6;
        let slope = (at(&moved)[index].2.value - row.value) / 1e-6;
        assert!((slope - row.control[0]).abs() < 1e-9);
    }
}
