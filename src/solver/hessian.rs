//! The exact Hessian of the Lagrangian, in the blocks the Riccati recursion
//! takes. It factors nothing.

use super::chain::{Chain, Control, DynamicsCurvature, Row, RowCurvature, State};
use super::point::Point;
use nalgebra::{SMatrix, SVector};

/// The blocks M_k of each stage in (z_{k−1}, u_k) and W_k of each node, with
/// the Lagrangian's gradient from the same sweep.
#[derive(Clone, Debug)]
pub struct Hessian<const NX: usize, const NU: usize> {
    /// M_1 … M_n.
    pub stages: Vec<DynamicsCurvature<NX, NU>>,
    /// W_0 … W_n.
    pub nodes: Vec<SMatrix<f64, NX, NX>>,
    /// p_0 … p_n, the adjoints of Σ L − Σ λ g.
    adjoints: Vec<State<NX>>,
    /// ∂(Σ L − Σ λ g)/∂u_k.
    gradient: Vec<Control<NU>>,
}

impl<const NX: usize, const NU: usize> Default for Hessian<NX, NU> {
    fn default() -> Self {
        Self {
            stages: Vec::new(),
            nodes: Vec::new(),
            adjoints: Vec::new(),
            gradient: Vec::new(),
        }
    }
}

impl<const NX: usize, const NU: usize> Hessian<NX, NU> {
    /// Sweeps the adjoints from tip to base and returns the reduced gradient
    /// of the Lagrangian, one control a stage. `multipliers`: one a row.
    pub fn gradient<C: Chain<NX, NU>>(
        &mut self,
        point: &Point<C, NX, NU>,
        multipliers: &[f64],
    ) -> &[Control<NU>] {
        let n = point.stages.len();
        self.adjoints.clear();
        self.adjoints.resize(n + 1, SVector::zeros());
        self.gradient.clear();
        self.gradient
            .extend(point.stages.iter().map(|stage| stage.cost_gradient));
        for (row, &multiplier) in point.rows.iter().zip(multipliers) {
            if multiplier != 0.0 {
                self.adjoints[row.stage] -= multiplier * row.after;
                self.gradient[row.stage - 1] -= multiplier * row.control;
                if let Some(before) = row.before {
                    self.adjoints[row.stage - 1] -= multiplier * before;
                }
            }
        }
        if C::SUM_ROWS {
            let weighed = point.sums.iter().zip(&multipliers[point.rows.len()..]);
            for (sum, &multiplier) in weighed.filter(|(_, multiplier)| **multiplier != 0.0) {
                for (gradient, term) in self.gradient.iter_mut().zip(&sum.gradient) {
                    *gradient -= multiplier * term;
                }
            }
        }
        for k in (1..=n).rev() {
            let stage = &point.stages[k - 1];
            let adjoint = self.adjoints[k];
            self.gradient[k - 1] += stage.by_control.tr_mul(&adjoint);
            self.adjoints[k - 1] += stage.by_state.tr_mul(&adjoint);
            if C::COST_OF_STATE {
                self.adjoints[k - 1] += stage.cost_by_state;
            }
        }
        &self.gradient
    }

    /// Fills the blocks with the Lagrangian's second derivative, from the
    /// adjoints of the last [`Hessian::gradient`] at the same point.
    pub fn assemble<C: Chain<NX, NU>>(
        &mut self,
        chain: &C,
        point: &Point<C, NX, NU>,
        multipliers: &[f64],
    ) {
        let n = point.stages.len();
        self.stages.clear();
        self.stages.reserve(n);
        for k in 1..=n {
            let mut block = chain.dynamics_curvature(&point.kept[k - 1], &self.adjoints[k]);
            block.by_control += point.stages[k - 1].cost_curvature;
            self.stages.push(block);
        }
        self.nodes.clear();
        self.nodes.resize(n + 1, SMatrix::zeros());
        for (row, &multiplier) in point.rows.iter().zip(multipliers) {
            if multiplier != 0.0 {
                match chain.row_curvature(row, &point.nodes) {
                    RowCurvature::States { after, before } => {
                        self.nodes[row.stage] -= multiplier * after;
                        if let Some((before, across)) = before {
                            self.nodes[row.stage - 1] -= multiplier * before;
                            self.add_across(point, row.stage, &(-multiplier * across));
                        }
                    }
                    RowCurvature::Inside(inside) => {
                        let block = &mut self.stages[row.stage - 1];
                        block.by_state -= multiplier * inside.by_state;
                        block.mixed -= multiplier * inside.mixed;
                        block.by_control -= multiplier * inside.by_control;
                    }
                }
            }
        }
        if C::SUM_ROWS {
            for (sum, &multiplier) in multipliers[point.rows.len()..].iter().enumerate() {
                if multiplier != 0.0 {
                    for (k, block) in (1..).zip(&mut self.stages) {
                        let curvature = chain.sum_curvature(sum, k, &point.kept[k - 1]);
                        block.by_control -= multiplier * curvature;
                    }
                }
            }
        }
    }

    /// Adds ρ ∇g ∇gᵀ of one row. On the row's null space nothing changes, so
    /// a Newton step that meets the row exactly stays the same; off it the
    /// Hessian becomes positive.
    pub fn stiffen<C: Chain<NX, NU>>(
        &mut self,
        point: &Point<C, NX, NU>,
        row: &Row<NX, NU>,
        stiffness: f64,
    ) {
        let k = row.stage;
        self.nodes[k] += stiffness * row.after * row.after.transpose();
        self.stages[k - 1].by_control += stiffness * row.control * row.control.transpose();
        // The control moves the node after it: ∇g is (after·A, after·B + control).
        let stage = &point.stages[k - 1];
        let across = stiffness * row.after * row.control.transpose();
        self.stages[k - 1].mixed += stage.by_state.tr_mul(&across);
        let twice = stage.by_control.tr_mul(&across);
        self.stages[k - 1].by_control += twice + twice.transpose();
        if let Some(before) = row.before {
            self.nodes[k - 1] += stiffness * before * before.transpose();
            self.add_across(point, k, &(stiffness * before * row.after.transpose()));
            self.stages[k - 1].mixed += stiffness * before * row.control.transpose();
        }
    }

    /// Adds a term dz_{k−1}ᵀ C dz_k (and its transpose) to stage k, where
    /// dz_k = A dz_{k−1} + B du_k.
    fn add_across<C: Chain<NX, NU>>(
        &mut self,
        point: &Point<C, NX, NU>,
        k: usize,
        across: &SMatrix<f64, NX, NX>,
    ) {
        let stage = &point.stages[k - 1];
        let by_state = across * stage.by_state;
        self.stages[k - 1].by_state += by_state + by_state.transpose();
        self.stages[k - 1].mixed += across * stage.by_control;
    }
}
