//! A chain for tests: affine stages with numbers that look like no others, so
//! that no two terms can be taken for each other, and a Hessian of every part.
//! Everything that the solver computes on it has a dense counterpart.

use super::{
    Chain, Control, DynamicsCurvature, Hessian, Point, Row, RowCurvature, RowId, Stage, State,
};
use nalgebra::{DMatrix, DVector, SMatrix, SVector};

/// The chain's stages.
pub const STAGES: usize = 17;
/// All its controls.
pub const CONTROLS: usize = 2 * STAGES;

/// A chain of states of three and controls of two numbers.
#[derive(Clone, Debug)]
pub struct Linear {
    /// How much all second derivatives count, but those of the costs.
    pub bent: f64,
}

/// A number between −0.5 and 0.5 that looks like no other.
pub fn some(a: usize, b: usize, c: usize) -> f64 {
    0.5 * libm::sin(17.3 * a as f64 + 5.9 * b as f64 + 3.1 * c as f64)
}

fn symmetric<const N: usize>(of: impl Fn(usize, usize) -> f64) -> SMatrix<f64, N, N> {
    SMatrix::from_fn(|i, j| of(i.min(j), i.max(j)))
}

impl Chain<3, 2> for Linear {
    type Node = ();
    type Kept = usize;

    fn stages(&self) -> usize {
        STAGES
    }

    fn base(&self) {}

    fn row_scale(&self) -> f64 {
        1.0
    }

    fn longest_step(&self) -> f64 {
        1.0
    }

    fn stage(&self, k: usize, (): &(), _: &Control<2>) -> ((), Stage<3, 2>, usize) {
        let stage = Stage {
            by_state: SMatrix::identity() + SMatrix::from_fn(|i, j| some(k, i, j)),
            by_control: SMatrix::from_fn(|i, j| some(k, i + 3, j)),
            cost: 0.0,
            cost_by_state: SVector::zeros(),
            cost_gradient: SVector::from_fn(|i, _| some(k, i, 7)),
            cost_curvature: SMatrix::identity() + symmetric(|i, j| 0.5 * some(k, i, j + 20)),
        };
        ((), stage, k)
    }

    fn dynamics_curvature(&self, k: &usize, adjoint: &State<3>) -> DynamicsCurvature<3, 2> {
        let size = self.bent * adjoint.sum();
        DynamicsCurvature {
            by_state: size * symmetric(|i, j| some(*k, i, j + 30)),
            mixed: size * SMatrix::from_fn(|i, j| some(*k, i, j + 40)),
            by_control: size * symmetric(|i, j| some(*k, i, j + 50)),
        }
    }

    /// Two rows at every third stage: one across its two nodes, one on its
    /// node and its control.
    fn rows(&self, _: &[()], _: &[Control<2>], rows: &mut Vec<Row<3, 2>>) {
        for (id, stage) in (1..=STAGES).step_by(3).flat_map(|k| [k, k]).enumerate() {
            let across = id % 2 == 0;
            rows.push(Row {
                id: RowId(id as u64),
                stage,
                value: some(id, 1, 14),
                before: across.then(|| SVector::from_fn(|i, _| some(stage, i, 11))),
                after: SVector::from_fn(|i, _| some(id, i, 12)),
                control: SVector::from_fn(|i, _| some(id, i, 13)),
            });
        }
    }

    fn row_curvature(&self, row: &Row<3, 2>, _: &[()]) -> RowCurvature<3, 2> {
        let k = row.id.0 as usize;
        let block = |c: usize| self.bent * symmetric(|i, j| some(k, i, j + c));
        let across = self.bent * SMatrix::from_fn(|i, j| some(k, i, j + 80));
        RowCurvature::States {
            after: block(60),
            before: row.before.map(|_| (block(70), across)),
        }
    }

    fn passes_through(&self, _: &[()], _: &[()]) -> bool {
        false
    }
}

/// The chain's point; it is the same wherever it is evaluated.
pub fn point() -> Point<Linear, 3, 2> {
    let mut point: Point<Linear, 3, 2> = Point {
        controls: vec![Control::zeros(); STAGES],
        ..Point::default()
    };
    point.evaluate(&Linear { bent: 0.0 });
    point
}

/// ∂z_k/∂u, dense.
pub fn sensitivity(point: &Point<Linear, 3, 2>, k: usize) -> DMatrix<f64> {
    let mut all = DMatrix::zeros(3, CONTROLS);
    for (index, stage) in point.stages.iter().take(k).enumerate() {
        all = DMatrix::from_fn(3, 3, |i, j| stage.by_state[(i, j)]) * all;
        for i in 0..3 {
            for j in 0..2 {
                all[(i, 2 * index + j)] += stage.by_control[(i, j)];
            }
        }
    }
    all
}

/// A row's gradient in all controls, dense.
pub fn gradient(point: &Point<Linear, 3, 2>, row: &Row<3, 2>) -> DVector<f64> {
    let vector = |v: &State<3>| DVector::from_column_slice(v.as_slice());
    let mut all = sensitivity(point, row.stage).transpose() * vector(&row.after);
    if let Some(before) = &row.before {
        all += sensitivity(point, row.stage - 1).transpose() * vector(before);
    }
    for i in 0..2 {
        all[2 * (row.stage - 1) + i] += row.control[i];
    }
    all
}

/// The costs' gradient in all controls.
pub fn cost_gradient(point: &Point<Linear, 3, 2>) -> DVector<f64> {
    DVector::from_iterator(
        CONTROLS,
        point
            .stages
            .iter()
            .flat_map(|stage| stage.cost_gradient.iter().copied()),
    )
}

/// The dense Hessian of the costs less Σ λ g, from its parts' definitions.
pub fn hessian(chain: &Linear, point: &Point<Linear, 3, 2>, multipliers: &[f64]) -> DMatrix<f64> {
    let mut all = DMatrix::zeros(CONTROLS, CONTROLS);
    let dense3 = |m: &SMatrix<f64, 3, 3>| DMatrix::from_fn(3, 3, |i, j| m[(i, j)]);
    let own = |k: usize| {
        DMatrix::from_fn(2, CONTROLS, |i, j| {
            f64::from(u8::from(j == 2 * (k - 1) + i))
        })
    };
    for (index, stage) in point.stages.iter().enumerate() {
        let k = index + 1;
        // The adjoint of node k: what the rows weigh there and beyond.
        let mut adjoint = State::<3>::zeros();
        for later in (k..=STAGES).rev() {
            if later < STAGES {
                adjoint = point.stages[later].by_state.transpose() * adjoint;
            }
            for (row, multiplier) in point.rows.iter().zip(multipliers) {
                if row.stage == later {
                    adjoint -= *multiplier * row.after;
                }
                if let (true, Some(before)) = (row.stage == later + 1, row.before) {
                    adjoint -= *multiplier * before;
                }
            }
        }
        let bend = chain.dynamics_curvature(&k, &adjoint);
        let (z, u) = (sensitivity(point, k - 1), own(k));
        let mixed = DMatrix::from_fn(3, 2, |i, j| bend.mixed[(i, j)]);
        let control = bend.by_control + stage.cost_curvature;
        let control = DMatrix::from_fn(2, 2, |i, j| control[(i, j)]);
        let cross = z.transpose() * mixed * &u;
        all += z.transpose() * dense3(&bend.by_state) * &z + u.transpose() * control * &u;
        all += &cross + cross.transpose();
    }
    for (row, multiplier) in point.rows.iter().zip(multipliers) {
        let RowCurvature::States {
            after: own_after,
            before,
        } = chain.row_curvature(row, &[])
        else {
            continue;
        };
        let after = sensitivity(point, row.stage);
        let mut part = after.transpose() * dense3(&own_after) * &after;
        if let Some((own, across)) = &before {
            let before = sensitivity(point, row.stage - 1);
            let cross = before.transpose() * dense3(across) * &after;
            part += before.transpose() * dense3(own) * &before + &cross + cross.transpose();
        }
        all -= *multiplier * part;
    }
    all
}

/// What the solver makes of the same.
pub fn blocks(chain: &Linear, point: &Point<Linear, 3, 2>, multipliers: &[f64]) -> Hessian<3, 2> {
    let mut hessian = Hessian::default();
    hessian.gradient(point, multipliers);
    hessian.assemble(chain, point, multipliers);
    hessian
}
