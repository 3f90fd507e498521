//! The obstacle rows of eq. 5: clearance of every candidate from every
//! obstacle, with exact derivatives in the nodes' states.
//!
//! A clearance is a signed distance less the candidate's radius, in metres,
//! with a gradient of unit length in space. Differs from the paper, whose
//! example is a squared distance: that would scale the multipliers by twice
//! the radius.

use super::disk_point::DiskPoint;
use super::surroundings::Surroundings;
use crate::geometry::{EdgeClearance, Vector};
use crate::robot::{Candidate, Element, PlanarNode};
use crate::solver::{Control, Row, RowCurvature, RowId, State};
use nalgebra::SMatrix;

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
    /// A bound of a segment's turn, which the mechanics sets.
    TurnLimit {
        /// The segment, from 1.
        segment: usize,
        /// +1 or −1: the sign of the turn at the bound.
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

/// How near a candidate has a row, over the backbone's length. One farther away
/// is met after any one iteration that the line search accepts, or is seen in the
/// next.
const MARGIN: f64 = 0.05;

impl Surroundings {
    /// Adds the rows of all candidates that are near an obstacle, by their ids.
    pub fn add_rows<const NU: usize>(&self, nodes: &[PlanarNode], rows: &mut Vec<Row<3, NU>>) {
        for candidate in 0..self.candidates.len() {
            add_rows_of(self, candidate, nodes, rows);
        }
    }

    /// The second derivative of a row that [`Surroundings::add_rows`] gave for
    /// the same nodes; none for a limit's.
    pub fn row_curvature<const NU: usize>(
        &self,
        row: &Row<3, NU>,
        nodes: &[PlanarNode],
    ) -> RowCurvature<3, NU> {
        let none = RowCurvature::States {
            after: SMatrix::zeros(),
            before: None,
        };
        let RowKind::Contact {
            candidate,
            obstacle,
            vertex,
        } = RowKind::of(row.id, self.obstacles.len())
        else {
            return none;
        };
        let candidate = &self.candidates[candidate];
        let obstacle = &self.obstacles[obstacle];
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
            return RowCurvature::States {
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
            RowCurvature::States {
                after: upper,
                before: Some((lower, across)),
            }
        } else {
            RowCurvature::States {
                after: lower + upper + across + across.transpose(),
                before: None,
            }
        }
    }
}

/// Adds the rows of one candidate.
fn add_rows_of<const NU: usize>(
    around: &Surroundings,
    index: usize,
    nodes: &[PlanarNode],
    rows: &mut Vec<Row<3, NU>>,
) {
    let margin = MARGIN * around.length;
    let candidate = &around.candidates[index];
    let near = margin + candidate.radius;
    let (start, end) = candidate.ends(nodes);
    let mut edge = None;
    let count = around.obstacles.len();
    for (obstacle_index, obstacle) in around.obstacles.iter().enumerate() {
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
fn edge_row<const NU: usize>(
    candidate: &Candidate,
    id: RowId,
    nodes: &[PlanarNode],
    clearance: EdgeClearance,
) -> Row<3, NU> {
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
