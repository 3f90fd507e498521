//! The obstacle rows of eq. 5: clearance of every candidate from every
//! obstacle, with exact derivatives in the nodes' states.
//!
//! A clearance is a signed distance less the candidate's radius, in metres,
//! with a gradient of unit length in space. Differs from the paper, whose
//! example is a squared distance: that would scale the multipliers by twice
//! the radius.

use super::disk_point::DiskPoint;
use super::kinematics::{Inside, Kinematics};
use super::surroundings::Surroundings;
use crate::geometry::{EdgeClearance, PointClearance, Vector, perpendicular};
use crate::robot::{Candidate, Element};
use crate::solver::{Control, DynamicsCurvature, Row, RowCurvature, RowId, State};
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
    /// The length of a cable, or of a part of it that sticks in a hole, which is summed
    /// over its stretches.
    Cable {
        /// The cable, from 0.
        cable: usize,
        /// The first of the stretches, from 1.
        stretch: usize,
    },
}

/// Ids of bounds come after those of all contacts.
const FIRST_LIMIT: u64 = 1 << 62;
/// And those of cables after these.
const FIRST_CABLE: u64 = 1 << 63;
/// Stretches a cable may have.
const STRETCHES: u64 = 1 << 32;
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
            RowKind::Cable { cable, stretch } => {
                FIRST_CABLE + cable as u64 * STRETCHES + stretch as u64
            }
        })
    }

    /// What an id of the same problem stands for.
    pub fn of(id: RowId, obstacles: usize) -> Self {
        if id.0 >= FIRST_CABLE {
            let rest = id.0 - FIRST_CABLE;
            return RowKind::Cable {
                cable: (rest / STRETCHES) as usize,
                stretch: (rest % STRETCHES) as usize,
            };
        }
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
    pub fn add_rows<N: Kinematics<NU> + ?Sized, const NU: usize>(
        &self,
        nodes: &N,
        rows: &mut Vec<Row<3, NU>>,
    ) {
        for candidate in 0..self.candidates.len() {
            add_rows_of(self, candidate, nodes, rows);
        }
    }

    /// The second derivative of a row that [`Surroundings::add_rows`] gave for
    /// the same nodes; none for a limit's.
    pub fn row_curvature<N: Kinematics<NU> + ?Sized, const NU: usize>(
        &self,
        row: &Row<3, NU>,
        nodes: &N,
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
        let ends = Ends::of(candidate, nodes);
        if candidate.is_point() {
            let Some(clearance) = candidate.point_clearance(nodes, obstacle) else {
                return none;
            };
            return point_curvature(candidate, &ends, &clearance);
        }
        let edge = candidate.edge(nodes);
        let Some(clearance) = vertex.and_then(|v| obstacle.edge_clearance(&edge, v)) else {
            return none;
        };
        // The distance's quadratic form in the two ends.
        let form = |a: (Vector, Vector)| {
            clearance.second_derivative(edge.end - edge.start, obstacle.radius(), a.0, a.1)
        };
        let weights = (
            (1.0 - clearance.along) * clearance.normal,
            clearance.along * clearance.normal,
        );
        match &ends {
            Ends::Disks(first, last) => {
                let full = disks_curvature(first, last, form, weights);
                split(&full, row.before.is_some())
            }
            Ends::Inside(first, last) => {
                RowCurvature::Inside(inside_curvature(first, last, form, weights))
            }
        }
    }
}

/// The two ends of a candidate as functions of what moves them.
enum Ends<'a, const NU: usize> {
    /// Of the states of their nodes.
    Disks(DiskPoint<'a>, DiskPoint<'a>),
    /// Of the state before their stage and of its controls.
    Inside(Inside<NU>, Inside<NU>),
}

impl<'a, const NU: usize> Ends<'a, NU> {
    fn of<N: Kinematics<NU> + ?Sized>(candidate: &Candidate, nodes: &'a N) -> Self {
        let node = candidate.node;
        let (below, above, levers) = match candidate.element {
            Element::Point { lever } => (node, node, (lever, lever)),
            Element::Link { lever } => (node - candidate.span, node, (lever, lever)),
            Element::OnLink { lever, above } => {
                let upper = node + above;
                (upper - candidate.span, upper, (lever, lever))
            }
            Element::Across { lever } => (node, node, (-lever, lever)),
        };
        if nodes.is_inside(below) || nodes.is_inside(above) {
            let stage = nodes.stage(above);
            let first = nodes.inside(stage, below, levers.0);
            let last = nodes.inside(stage, above, levers.1);
            if let (Some(first), Some(last)) = (first, last) {
                return Ends::Inside(first, last);
            }
        }
        let point = |node, lever| DiskPoint {
            node: nodes.node(node),
            lever,
        };
        Ends::Disks(point(below, levers.0), point(above, levers.1))
    }

    /// The row that these ends have where the distance changes by `weights` · their
    /// displacements. `one_node`: whether both are points of the same disk.
    fn row(
        &self,
        id: RowId,
        stage: usize,
        value: f64,
        weights: (Vector, Vector),
        one_node: bool,
    ) -> Row<3, NU> {
        let mut row = Row {
            id,
            stage,
            value,
            before: None,
            after: State::zeros(),
            control: Control::zeros(),
        };
        match self {
            Ends::Disks(first, last) => {
                let (first, last) = (first.gradient(weights.0), last.gradient(weights.1));
                if one_node {
                    row.after = first + last;
                } else {
                    row.before = Some(first);
                    row.after = last;
                }
            }
            Ends::Inside(first, last) => {
                row.before = Some(first.by_state(weights.0) + last.by_state(weights.1));
                row.control = first.by_control(weights.0) + last.by_control(weights.1);
            }
        }
        row
    }
}

/// The second derivative of a point's clearance.
fn point_curvature<const NU: usize>(
    candidate: &Candidate,
    ends: &Ends<'_, NU>,
    clearance: &PointClearance,
) -> RowCurvature<3, NU> {
    let tangent = perpendicular(clearance.normal);
    match ends {
        Ends::Disks(first, last) => {
            if let Element::OnLink { .. } = candidate.element {
                let share = candidate.share();
                let weights = ((1.0 - share) * clearance.normal, share * clearance.normal);
                let form = |(start, end): (Vector, Vector)| {
                    let along = tangent.dot(&((1.0 - share) * start + share * end));
                    clearance.curvature * along * along
                };
                return split(&disks_curvature(first, last, form, weights), true);
            }
            let along: State<3> = last.gradient(tangent);
            let mut after = clearance.curvature * along * along.transpose();
            after[(2, 2)] += last.curvature(clearance.normal);
            RowCurvature::States {
                after,
                before: None,
            }
        }
        Ends::Inside(_, point) => {
            let (state, control) = (point.by_state(tangent), point.by_control(tangent));
            let mut inside = point.curvature(clearance.normal);
            inside.by_state += clearance.curvature * state * state.transpose();
            inside.mixed += clearance.curvature * state * control.transpose();
            inside.by_control += clearance.curvature * control * control.transpose();
            RowCurvature::Inside(inside)
        }
    }
}

/// The second derivative of an edge's distance in the states of its two nodes: its
/// quadratic form in the ends, polarised on the displacements that unit changes of the
/// six state components cause, and how these curve.
fn disks_curvature(
    first: &DiskPoint<'_>,
    last: &DiskPoint<'_>,
    form: impl Fn((Vector, Vector)) -> f64,
    weights: (Vector, Vector),
) -> SMatrix<f64, 6, 6> {
    let still = Vector::zeros();
    let ends = |i: usize| {
        if i < 3 {
            (first.displacement(i), still)
        } else {
            (still, last.displacement(i - 3))
        }
    };
    let mut full = polarised(form, ends);
    full[(2, 2)] += first.curvature(weights.0);
    full[(5, 5)] += last.curvature(weights.1);
    full
}

/// The same of an edge inside a stage.
fn inside_curvature<const NU: usize>(
    first: &Inside<NU>,
    last: &Inside<NU>,
    form: impl Fn((Vector, Vector)) -> f64,
    weights: (Vector, Vector),
) -> DynamicsCurvature<3, NU> {
    let ends = |i: usize| match i {
        0 => (Vector::x(), Vector::x()),
        1 => (Vector::y(), Vector::y()),
        2 => (first.by_turn, last.by_turn),
        _ => (first.by_control[i - 3], last.by_control[i - 3]),
    };
    let of = |i: usize, j: usize| {
        let (a, b) = (ends(i), ends(j));
        if i == j {
            return form(a);
        }
        0.5 * (form((a.0 + b.0, a.1 + b.1)) - form(a) - form(b))
    };
    let (lower, upper) = (first.curvature(weights.0), last.curvature(weights.1));
    DynamicsCurvature {
        by_state: SMatrix::from_fn(of) + lower.by_state + upper.by_state,
        mixed: SMatrix::from_fn(|i, j| of(i, j + 3)) + lower.mixed + upper.mixed,
        by_control: SMatrix::from_fn(|i, j| of(i + 3, j + 3)) + lower.by_control + upper.by_control,
    }
}

/// The matrix of a quadratic form in displacements of two ends.
fn polarised(
    form: impl Fn((Vector, Vector)) -> f64,
    ends: impl Fn(usize) -> (Vector, Vector),
) -> SMatrix<f64, 6, 6> {
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
    full
}

/// The second derivative in the states of two nodes or, where both are one, of that.
fn split<const NU: usize>(full: &SMatrix<f64, 6, 6>, two_nodes: bool) -> RowCurvature<3, NU> {
    let lower = full.fixed_view::<3, 3>(0, 0).into_owned();
    let upper = full.fixed_view::<3, 3>(3, 3).into_owned();
    let across = full.fixed_view::<3, 3>(0, 3).into_owned();
    if two_nodes {
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

/// Adds the rows of one candidate.
fn add_rows_of<N: Kinematics<NU> + ?Sized, const NU: usize>(
    around: &Surroundings,
    index: usize,
    nodes: &N,
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
        if candidate.is_point() {
            if obstacle.is_beyond(start, near) {
                continue;
            }
            let Some(clearance) = candidate.point_clearance(nodes, obstacle) else {
                continue;
            };
            if clearance.distance > near {
                continue;
            }
            rows.push(point_row(candidate, id(None), nodes, &clearance));
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

/// The row of a point.
#[inline]
fn point_row<N: Kinematics<NU> + ?Sized, const NU: usize>(
    candidate: &Candidate,
    id: RowId,
    nodes: &N,
    clearance: &PointClearance,
) -> Row<3, NU> {
    let value = clearance.distance - candidate.radius;
    let normal = clearance.normal;
    let node = candidate.node;
    if let Element::Point { lever } = candidate.element
        && !nodes.is_inside(node)
    {
        let point = DiskPoint {
            node: nodes.node(node),
            lever,
        };
        return Row {
            id,
            stage: nodes.stage(node),
            value,
            before: None,
            after: point.gradient(normal),
            control: Control::zeros(),
        };
    }
    let share = candidate.share();
    let weights = ((1.0 - share) * normal, share * normal);
    Ends::of(candidate, nodes).row(id, nodes.stage(node), value, weights, false)
}

/// The row of an edge's inside on a vertex.
fn edge_row<N: Kinematics<NU> + ?Sized, const NU: usize>(
    candidate: &Candidate,
    id: RowId,
    nodes: &N,
    clearance: EdgeClearance,
) -> Row<3, NU> {
    let weights = (
        (1.0 - clearance.along) * clearance.normal,
        clearance.along * clearance.normal,
    );
    let one_node = matches!(candidate.element, Element::Across { .. });
    let value = clearance.distance - candidate.radius;
    let stage = nodes.stage(candidate.node);
    Ends::of(candidate, nodes).row(id, stage, value, weights, one_node)
}
