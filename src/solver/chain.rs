//! What the solver asks of a problem: stages with derivatives, rows with
//! derivatives. It holds no algorithm.
//!
//! # Perturbations of a state
//!
//! A node may be anything that `NX` numbers can perturb. The solver sees it
//! through a chart: a smooth δ ↦ z(δ) from `NX` numbers to the nodes around it,
//! one to one, with the node itself at δ = 0. Every derivative in a state is
//! one in δ at 0. Which chart a node has is the chain's choice, for each node
//! of each point anew; but all that refers to one node is in one chart:
//!
//! - A_k takes a δ of node k−1 to one of node k, B_k a change of u_k to one of
//!   node k: the stage is δ′(F_k(z(δ), u)), with node k−1's chart z on the one
//!   side and the inverse δ′ of node k's on the other;
//! - the second derivative of pᵀF_k is that of this same function, so how either
//!   chart curves is part of it, and p is a gradient in node k's chart;
//! - a row's gradients and second derivatives are those of g(z(δ), z′(δ′), u).
//!
//! Second derivatives are plain ones, and symmetric. Charts that touch to first
//! order only will not do: with rows in one and the dynamics in another, all
//! gradients are right and the Hessian is not.
//!
//! No node is ever moved by a perturbation. The controls are, the chain is
//! rolled out anew, and a row's change along a step is the only other use of
//! δ, so whatever the solver decides rests on derivatives in the controls,
//! which are the same in all charts. A state without global coordinates, such
//! as a rotation, needs none.
//!
//! # Sizes
//!
//! The solver's constants are made for controls of order 1, for costs of order
//! 1 a stage with curvatures of order 1 in them, and for rows as
//! [`Chain::row_scale`] says. A chain measures its controls accordingly.
//!
//! # Proof
//!
//! The functions in tests/any_chain compare the derivatives of any chain with
//! differences of its values, and an iteration with a dense system.

use nalgebra::{SMatrix, SVector};

/// A perturbation of, or a gradient with respect to, a stage's state.
pub type State<const NX: usize> = SVector<f64, NX>;

/// A stage's control, a perturbation of it, or a gradient with respect to it.
pub type Control<const NU: usize> = SVector<f64, NU>;

/// One stage's values and first derivatives at a point, in the charts of its two
/// nodes.
#[derive(Clone, Copy, Debug)]
pub struct Stage<const NX: usize, const NU: usize> {
    /// A = ∂F/∂z.
    pub by_state: SMatrix<f64, NX, NX>,
    /// B = ∂F/∂u.
    pub by_control: SMatrix<f64, NX, NU>,
    /// L(z, u). Not finite where the control is outside the stage's domain.
    pub cost: f64,
    /// ∂L/∂z, which is looked at only where [`Chain::COST_OF_STATE`] says so.
    pub cost_by_state: State<NX>,
    /// ∂L/∂u.
    pub cost_gradient: Control<NU>,
    /// ∂²L/∂u².
    pub cost_curvature: SMatrix<f64, NU, NU>,
}

/// The second derivative of a function of (z, u) at one stage, in the charts of
/// its nodes.
#[derive(Clone, Copy, Debug)]
pub struct DynamicsCurvature<const NX: usize, const NU: usize> {
    /// ∂²/∂z², symmetric.
    pub by_state: SMatrix<f64, NX, NX>,
    /// ∂²/∂z∂u.
    pub mixed: SMatrix<f64, NX, NU>,
    /// ∂²/∂u², symmetric.
    pub by_control: SMatrix<f64, NU, NU>,
}

/// Names a row for as long as a problem lives: at every point the same id means
/// the same smooth function g at the same stage, so that multipliers can be
/// carried from one point to the next and its values be compared. No two rows
/// of a point share one.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct RowId(pub u64);

/// One inequality g(z_{k−1}, z_k, u_k) ≥ 0 with its gradient. It is affine in its
/// control, g = h(z_{k−1}, z_k) + cᵀu_k with a constant c, or curved in it and then
/// independent of z_k: g = h(z_{k−1}, u_k).
#[derive(Clone, Copy, Debug)]
pub struct Row<const NX: usize, const NU: usize> {
    /// Its name.
    pub id: RowId,
    /// k, from 1 to n.
    pub stage: usize,
    /// g, in the unit of [`Chain::row_scale`].
    pub value: f64,
    /// ∂g/∂z_{k−1}; `None` for a row of one node.
    pub before: Option<State<NX>>,
    /// ∂g/∂z_k.
    pub after: State<NX>,
    /// ∂g/∂u_k, what the states change aside.
    pub control: Control<NU>,
}

impl<const NX: usize, const NU: usize> Row<NX, NU> {
    /// g's first-order change under perturbed controls `du` (entry k − 1 is
    /// stage k) and states `dz` (entry k is node k).
    pub fn change(&self, du: &[Control<NU>], dz: &[State<NX>]) -> f64 {
        let before = self
            .before
            .map_or(0.0, |gradient| gradient.dot(&dz[self.stage - 1]));
        before + self.after.dot(&dz[self.stage]) + self.control.dot(&du[self.stage - 1])
    }
}

/// The second derivative of a row, see [`Row`].
#[derive(Clone, Copy, Debug)]
pub enum RowCurvature<const NX: usize, const NU: usize> {
    /// Of a row that is affine in its control.
    States {
        /// ∂²g/∂z_k², symmetric.
        after: SMatrix<f64, NX, NX>,
        /// (∂²g/∂z_{k−1}², ∂²g/∂z_{k−1}∂z_k); `None` for a row of one node, as in
        /// [`Row::before`].
        before: Option<(SMatrix<f64, NX, NX>, SMatrix<f64, NX, NX>)>,
    },
    /// Of one that does not depend on z_k.
    Inside(DynamicsCurvature<NX, NU>),
}

/// A row summed over stages, g = b + Σ_k c_k(u_k) + ε λ ≥ 0, where λ ≥ 0 is its own
/// multiplier: with ε = 0 an inequality like any other, with ε > 0 one that gives
/// way as it is pressed.
#[derive(Clone, Copy, Debug)]
pub struct SumRow {
    /// Its name, above those of all [`Row`]s.
    pub id: RowId,
    /// b, in the unit of [`Chain::row_scale`].
    pub bound: f64,
    /// ε ≥ 0.
    pub compliance: f64,
}

/// A chain of stages with inequality rows.
///
/// Every derivative is exact: the solver's convergence rests on it, and the
/// tests compare each with finite differences. All in one node's charts, as the
/// module says.
///
/// Stages may differ: cost, dynamics, domain and rows may depend on k, only the
/// dimensions may not. Every method is a function of its arguments: the same
/// ones give the same answer, bit for bit. None panics for a control outside the
/// domain.
pub trait Chain<const NX: usize, const NU: usize> {
    /// Whether a stage's cost depends on the state it starts from.
    const COST_OF_STATE: bool = false;
    /// Whether there may be rows summed over stages.
    const SUM_ROWS: bool = false;

    /// A state z with whatever is derived from it once for all users.
    type Node: Clone + std::fmt::Debug;
    /// What a stage keeps from its evaluation for its second derivative; k too,
    /// where stages differ.
    type Kept: Clone + std::fmt::Debug;

    /// n, at least 1.
    fn stages(&self) -> usize;

    /// The node before the first stage, z_0. It stays where it is, and rows of
    /// stage 1 may depend on it.
    fn base(&self) -> Self::Node;

    /// The size a row's value is compared with: a row counts as met above
    /// −tolerance · `row_scale`. Positive, the same for all rows and at all
    /// points. A multiplier times this is expected below ten thousand;
    /// above a million its row gives way.
    fn row_scale(&self) -> f64;

    /// The longest step in any one number of the controls for which a linearised
    /// row can be trusted: a longer one is cut to it. Positive. Rows not yet within
    /// reach of it may be left out of [`rows`].
    ///
    /// [`rows`]: Chain::rows
    fn longest_step(&self) -> f64;

    /// F_k with first derivatives, from node k − 1, for k from 1 to n.
    ///
    /// Outside the domain the cost is not finite, and of the answer nothing else
    /// is looked at. Inside all of it is finite, and so are the rows at the nodes.
    fn stage(
        &self,
        k: usize,
        from: &Self::Node,
        control: &Control<NU>,
    ) -> (Self::Node, Stage<NX, NU>, Self::Kept);

    /// How much larger than for costs of order 1 multipliers may be expected. At
    /// least 1.
    fn multiplier_scale(&self) -> f64 {
        1.0
    }

    /// The size of the costs' gradient below which stationarity is not relative to it:
    /// 1 for costs of order 1 at all points, less for those that may be smaller.
    fn least_gradient(&self) -> f64 {
        1.0
    }

    /// The second derivative of `adjoint`ᵀF_k where [`Chain::stage`] left `kept`,
    /// with that of the cost but for [`Stage::cost_curvature`]; `adjoint` is a
    /// gradient in the chart of the node that the stage led to.
    fn dynamics_curvature(
        &self,
        kept: &Self::Kept,
        adjoint: &State<NX>,
    ) -> DynamicsCurvature<NX, NU>;

    /// Puts into `rows` (emptied before) every row near or beyond its bound,
    /// in the order of their ids, which increase. `nodes` are n + 1, `controls`
    /// n.
    ///
    /// A row at or below zero is never left out: one that is not there counts as
    /// met and has no multiplier. One above zero may come and go, and is then
    /// seen too late by the step that crosses it, which costs iterations.
    fn rows(&self, nodes: &[Self::Node], controls: &[Control<NU>], rows: &mut Vec<Row<NX, NU>>);

    /// The second derivative of a row that [`Chain::rows`] gave for the same
    /// nodes, in the same charts.
    fn row_curvature(&self, row: &Row<NX, NU>, nodes: &[Self::Node]) -> RowCurvature<NX, NU>;

    /// The number of rows summed over stages.
    fn sum_count(&self) -> usize {
        0
    }

    /// A row summed over stages, by its place in the order of their ids.
    fn sum_row(&self, sum: usize) -> SumRow {
        SumRow {
            id: RowId(u64::MAX - sum as u64),
            bound: 0.0,
            compliance: 0.0,
        }
    }

    /// c_k of a summed row, by its place among them, and its gradient, where
    /// [`Chain::stage`] left `kept`.
    fn sum_term(&self, _sum: usize, _k: usize, _kept: &Self::Kept) -> (f64, Control<NU>) {
        (0.0, Control::zeros())
    }

    /// The second derivative of c_k.
    fn sum_curvature(&self, _sum: usize, _k: usize, _kept: &Self::Kept) -> SMatrix<f64, NU, NU> {
        SMatrix::zeros()
    }

    /// Whether the straight motion from one set of nodes to another leads
    /// through something that only its ends avoid. Both are n + 1, inside the
    /// domain, and their controls apart by no more than an iteration's step.
    fn passes_through(&self, from: &[Self::Node], to: &[Self::Node]) -> bool;
}
