//! The obstacle rows of eq. 5: clearance of every candidate from every
//! obstacle, with exact derivatives in the nodes' states.
//!
//! A clearance is a signed distance less the candidate's radius, in metres,
//! with a gradient of unit length in space. Differs from the paper, whose
//! example is a squared distance: that would scale the multipliers by twice
//! the radius.

use super::candidate::{Candidate, DiskPoint, Element};
use super::node::PlanarNode;
use super::problem::Problem;
use crate::geometry::{EdgeClearance, Vector};
use crate::solver::{Control, Row, RowCurvature, RowId, State};
use nalgebra::{SMatrix, vector};

/// What a row is about; the meaning of its id.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RowKind {
    /// A candidate and an obstacle, by their indices.
    Contact {
        /// Index of the candidate.
        candidate: usize,
        /// Index of the obstacle.
        obstacle: usize,
        /// The obstacle's vertex on an edge's inside; `None` for a point.
        vertex: Option<usize>,
    },
    /// The bound |τ| ≤ [`super::FourBar::most_turn`] of a segment.
    TurnLimit {
        /// The segment, from 1.
        segment: usize,
        /// +1 or −1: the sign of τ at the bound.
        sign: i8,
    },
}

/// Ids of bounds come after those of all contacts.
const FIRST_LIMIT: u64 = 1 << 62;
/// Vertices an obstacle may have, less one for "none".
const VERTICES: u64 = 1 << 8;

impl RowKind {
    /// The row's id. Ids rise with the candidate, then with the obstacle.
    pub fn id(self, obstacles: usize) -> RowId {
        RowId(match self {
            RowKind::Contact {
                candidate,
                obstacle,
                vertex,
            } => {
                let pair = candidate as u64 * obstacles as u64 + obstacle as u64;
                pair * VERTICES + vertex.map_or(0, |vertex| vertex as u64 + 1)
            }
            RowKind::TurnLimit { segment, sign } => {
                FIRST_LIMIT + 2 * segment as u64 + u64::from(sign > 0)
            }
        })
    }

    /// What an id of the same problem stands for.
    pub fn of(id: RowId, obstacles: usize) -> Self {
        if id.0 >= FIRST_LIMIT {
            let rest = id.0 - FIRST_LIMIT;
            return RowKind::TurnLimit {
                segment: (rest / 2) as usize,
                sign: if rest % 2 == 1 { 1 } else { -1 },
            };
        }
        let pair = id.0 / VERTICES;
        RowKind::Contact {
            candidate: (pair / obstacles as u64) as usize,
            obstacle: (pair % obstacles as u64) as usize,
            vertex: (id.0 % VERTICES).checked_sub(1).map(|v| v as usize),
        }
    }
}

/// Adds the rows of one candidate that are nearer than `margin`.
pub(super) fn contact_rows(
    problem: &Problem,
    index: usize,
    nodes: &[PlanarNode],
    margin: f64,
    rows: &mut Vec<Row<3, 1>>,
) {
    let candidate = &problem.candidates()[index];
    let near = margin + candidate.radius;
    let (start, end) = candidate.ends(nodes);
    let mut edge = None;
    let count = problem.obstacles().len();
    for (obstacle_index, obstacle) in problem.obstacles().iter().enumerate() {
        let id = |vertex| {
            let kind = RowKind::Contact {
                candidate: index,
                obstacle: obstacle_index,
                vertex,
            };
            kind.id(count)
        };
        if let Element::Point { lever } = candidate.element {
            if obstacle.is_beyond(start, near) {
                continue;
            }
            let Some(clearance) = candidate.point_clearance(nodes, obstacle) else {
                continue;
            };
            if clearance.distance > near {
                continue;
            }
            let node = &nodes[candidate.node];
            rows.push(Row {
                id: id(None),
                stage: candidate.node,
                value: clearance.distance - candidate.radius,
                before: None,
                after: DiskPoint { node, lever }.gradient(clearance.normal),
                control: Control::zeros(),
            });
            continue;
        }
        if obstacle.is_beyond(start, near + (end - start).norm()) {
            continue;
        }
        let edge = edge.get_or_insert_with(|| candidate.edge(nodes));
        obstacle.edge_clearances(edge, |clearance| {
            if clearance.distance <= near {
                rows.push(edge_row(
                    candidate,
                    id(Some(clearance.vertex)),
                    nodes,
                    clearance,
                ));
            }
        });
    }
}

/// The row of an edge's inside on a vertex.
fn edge_row(
    candidate: &Candidate,
    id: RowId,
    nodes: &[PlanarNode],
    clearance: EdgeClearance,
) -> Row<3, 1> {
    let [first, last] = edge_points(candidate, nodes);
    let first = first.gradient((1.0 - clearance.along) * clearance.normal);
    let last = last.gradient(clearance.along * clearance.normal);
    let one_node = matches!(candidate.element, Element::Across { .. });
    Row {
        id,
        stage: candidate.node,
        value: clearance.distance - candidate.radius,
        before: (!one_node).then_some(first),
        after: if one_node { first + last } else { last },
        control: Control::zeros(),
    }
}

/// The two ends of an edge as functions of their nodes' states.
fn edge_points<'a>(candidate: &Candidate, nodes: &'a [PlanarNode]) -> [DiskPoint<'a>; 2] {
    let node = &nodes[candidate.node];
    match candidate.element {
        Element::Point { lever } => [DiskPoint { node, lever }, DiskPoint { node, lever }],
        Element::Link { lever } => {
            let below = &nodes[candidate.node - 1];
            [DiskPoint { node: below, lever }, DiskPoint { node, lever }]
        }
        Element::Across { lever } => [
            DiskPoint {
                node,
                lever: -lever,
            },
            DiskPoint { node, lever },
        ],
    }
}

/// The second derivative of a contact row.
pub(super) fn contact_curvature(
    problem: &Problem,
    row: &Row<3, 1>,
    nodes: &[PlanarNode],
) -> RowCurvature<3> {
    let none = RowCurvature {
        after: SMatrix::zeros(),
        before: None,
    };
    let RowKind::Contact {
        candidate,
        obstacle,
        vertex,
    } = RowKind::of(row.id, problem.obstacles().len())
    else {
        return none;
    };
    let candidate = &problem.candidates()[candidate];
    let obstacle = &problem.obstacles()[obstacle];
    if let Element::Point { lever } = candidate.element {
        let point = DiskPoint {
            node: &nodes[candidate.node],
            lever,
        };
        let Some(clearance) = candidate.point_clearance(nodes, obstacle) else {
            return none;
        };
        let tangent = crate::geometry::perpendicular(clearance.normal);
        let along: State<3> = point.gradient(tangent);
        let mut after = clearance.curvature * along * along.transpose();
        after[(2, 2)] += point.curvature(clearance.normal);
        return RowCurvature {
            after,
            before: None,
        };
    }
    let [first, last] = edge_points(candidate, nodes);
    let edge = candidate.edge(nodes);
    let Some(clearance) = vertex.and_then(|v| obstacle.edge_clearance(&edge, v)) else {
        return none;
    };
    // The distance's quadratic form in the two ends, polarised on the
    // displacements that unit changes of the six state components cause.
    let still = Vector::zeros();
    let ends = |i: usize| {
        if i < 3 {
            (first.displacement(i), still)
        } else {
            (still, last.displacement(i - 3))
        }
    };
    let form = |a: (Vector, Vector)| {
        clearance.second_derivative(edge.end - edge.start, obstacle.radius(), a.0, a.1)
    };
    let mut full = SMatrix::<f64, 6, 6>::zeros();
    for i in 0..6 {
        full[(i, i)] = form(ends(i));
    }
    for i in 0..6 {
        for j in 0..i {
            let (a, b) = (ends(i), ends(j));
            let mixed = 0.5 * (form((a.0 + b.0, a.1 + b.1)) - full[(i, i)] - full[(j, j)]);
            full[(i, j)] = mixed;
            full[(j, i)] = mixed;
        }
    }
    full[(2, 2)] += first.curvature((1.0 - clearance.along) * clearance.normal);
    full[(5, 5)] += last.curvature(clearance.along * clearance.normal);
    let lower = full.fixed_view::<3, 3>(0, 0).into_owned();
    let upper = full.fixed_view::<3, 3>(3, 3).into_owned();
    let across = full.fixed_view::<3, 3>(0, 3).into_owned();
    if row.before.is_some() {
        RowCurvature {
            after: upper,
            before: Some((lower, across)),
        }
    } else {
        RowCurvature {
            after: lower + upper + across + across.transpose(),
            before: None,
        }
    }
}

/// Adds the rows of |τ| ≤ bound for the segments within reach of it.
pub(super) fn limit_rows(
    problem: &Problem,
    controls: &[Control<1>],
    reach: f64,
    rows: &mut Vec<Row<3, 1>>,
) {
    let most_turn = problem.segment().most_turn();
    for (index, control) in controls.iter().enumerate() {
        let turn = control[0];
        if turn.abs() + reach > most_turn {
            let sign = if turn > 0.0 { 1 } else { -1 };
            let segment = index + 1;
            let kind = RowKind::TurnLimit { segment, sign };
            rows.push(Row {
                id: kind.id(problem.obstacles().len()),
                stage: segment,
                // In the unit of the other rows, and of their size.
                value: (most_turn - turn.abs()) * problem.length(),
                before: None,
                after: State::zeros(),
                control: vector![-f64::from(sign) * problem.length()],
            });
        }
    }
}
