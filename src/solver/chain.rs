//! What the solver asks of a problem: stages with derivatives, rows with
//! derivatives. It holds no algorithm.

use nalgebra::{SMatrix, SVector};

/// A perturbation of, or a gradient with respect to, a stage's state.
pub type State<const NX: usize> = SVector<f64, NX>;

/// A stage's control, a perturbation of it, or a gradient with respect to it.
pub type Control<const NU: usize> = SVector<f64, NU>;

/// One stage's values and first derivatives at a point.
#[derive(Clone, Copy, Debug)]
pub struct Stage<const NX: usize, const NU: usize> {
    /// A = ∂F/∂z.
    pub by_state: SMatrix<f64, NX, NX>,
    /// B = ∂F/∂u.
    pub by_control: SMatrix<f64, NX, NU>,
    /// L(u). Not finite where the control is outside the stage's domain.
    pub cost: f64,
    /// ∂L/∂u.
    pub cost_gradient: Control<NU>,
    /// ∂²L/∂u².
    pub cost_curvature: SMatrix<f64, NU, NU>,
}

/// The second derivative of pᵀF(z, u) at one stage.
#[derive(Clone, Copy, Debug)]
pub struct DynamicsCurvature<const NX: usize, const NU: usize> {
    /// ∂²/∂z².
    pub by_state: SMatrix<f64, NX, NX>,
    /// ∂²/∂z∂u.
    pub mixed: SMatrix<f64, NX, NU>,
    /// ∂²/∂u².
    pub by_control: SMatrix<f64, NU, NU>,
}

/// Names a row for as long as a problem lives, so that multipliers can be
/// carried from one point to the next. Rows come in increasing order.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct RowId(pub u64);

/// One inequality g(z_{k−1}, z_k, u_k) ≥ 0 with its gradient.
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
    /// ∂g/∂u_k.
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

/// The second derivative of a row in its two states.
#[derive(Clone, Copy, Debug)]
pub struct RowCurvature<const NX: usize> {
    /// ∂²g/∂z_k².
    pub after: SMatrix<f64, NX, NX>,
    /// (∂²g/∂z_{k−1}², ∂²g/∂z_{k−1}∂z_k); `None` for a row of one node.
    pub before: Option<(SMatrix<f64, NX, NX>, SMatrix<f64, NX, NX>)>,
}

/// A chain of stages with inequality rows.
///
/// Every derivative is exact: the solver's convergence rests on it, and the
/// tests compare each with finite differences.
pub trait Chain<const NX: usize, const NU: usize> {
    /// A state z with whatever is derived from it once for all users.
    type Node: Clone + std::fmt::Debug;
    /// What a stage keeps from its evaluation for its second derivative.
    type Bend: Clone + std::fmt::Debug;

    /// n, at least 1.
    fn stages(&self) -> usize;

    /// The node before the first stage, z_0.
    fn base(&self) -> Self::Node;

    /// The size a row's value is compared with: a row counts as met above
    /// −tolerance · `row_scale`. Positive.
    fn row_scale(&self) -> f64;

    /// The longest step in any one control for which a linearised row can be
    /// trusted. Rows not yet within reach of it may be left out of [`rows`].
    ///
    /// [`rows`]: Chain::rows
    fn longest_step(&self) -> f64;

    /// F_k with first derivatives, from node k − 1, for k from 1 to n.
    fn stage(
        &self,
        k: usize,
        from: &Self::Node,
        control: &Control<NU>,
    ) -> (Self::Node, Stage<NX, NU>, Self::Bend);

    /// The second derivative of `adjoint`ᵀF_k where `stage` left `bend`.
    fn dynamics_curvature(
        &self,
        bend: &Self::Bend,
        adjoint: &State<NX>,
    ) -> DynamicsCurvature<NX, NU>;

    /// Puts into `rows` (emptied before) every row near or beyond its bound,
    /// in the order of their ids. `nodes` are n + 1, `controls` n.
    fn rows(&self, nodes: &[Self::Node], controls: &[Control<NU>], rows: &mut Vec<Row<NX, NU>>);

    /// The second derivative of a row that [`Chain::rows`] gave for the same
    /// nodes.
    fn row_curvature(&self, row: &Row<NX, NU>, nodes: &[Self::Node]) -> RowCurvature<NX>;

    /// Whether the straight motion from one set of nodes to another leads
    /// through something that only its ends avoid.
    fn passes_through(&self, from: &[Self::Node], to: &[Self::Node]) -> bool;
}
