//! A point of the solver's path: controls, the chain rolled out from them,
//! and the rows there. It takes no decisions.

use super::chain::{Chain, Control, Row, Stage};
use crate::math::greatest;

/// A chain evaluated at given controls.
#[derive(Clone, Debug)]
pub struct Point<C: Chain<NX, NU>, const NX: usize, const NU: usize> {
    /// u_1 … u_n.
    pub controls: Vec<Control<NU>>,
    /// z_0 … z_n.
    pub nodes: Vec<C::Node>,
    /// Stages 1 … n.
    pub stages: Vec<Stage<NX, NU>>,
    /// What each stage keeps for its second derivative.
    pub kept: Vec<C::Kept>,
    /// The rows near or beyond their bounds, by id.
    pub rows: Vec<Row<NX, NU>>,
    /// Σ L. Not finite outside the chain's domain.
    pub cost: f64,
}

impl<C: Chain<NX, NU>, const NX: usize, const NU: usize> Default for Point<C, NX, NU> {
    fn default() -> Self {
        Self {
            controls: Vec::new(),
            nodes: Vec::new(),
            stages: Vec::new(),
            kept: Vec::new(),
            rows: Vec::new(),
            cost: f64::NAN,
        }
    }
}

impl<C: Chain<NX, NU>, const NX: usize, const NU: usize> Point<C, NX, NU> {
    /// Rolls the chain out from the controls as they stand and collects the
    /// rows. Stops at the first stage outside its domain and leaves a cost
    /// that is not finite.
    pub fn evaluate(&mut self, chain: &C) {
        let n = chain.stages();
        assert_eq!(self.controls.len(), n, "one control a stage");
        self.nodes.clear();
        self.stages.clear();
        self.kept.clear();
        self.rows.clear();
        self.nodes.reserve(n + 1);
        self.stages.reserve(n);
        self.kept.reserve(n);
        self.cost = 0.0;
        self.nodes.push(chain.base());
        for k in 1..=n {
            let (node, stage, kept) = chain.stage(k, &self.nodes[k - 1], &self.controls[k - 1]);
            self.cost += stage.cost;
            if !self.cost.is_finite() {
                return;
            }
            self.nodes.push(node);
            self.stages.push(stage);
            self.kept.push(kept);
        }
        chain.rows(&self.nodes, &self.controls, &mut self.rows);
    }

    /// The gradient of a row in the controls, n.
    pub fn row_gradient(&self, row: &Row<NX, NU>) -> Vec<Control<NU>> {
        let mut gradient = vec![Control::zeros(); self.stages.len()];
        gradient[row.stage - 1] = row.control;
        let mut adjoint = row.after;
        for k in (1..=row.stage).rev() {
            let stage = &self.stages[k - 1];
            gradient[k - 1] += stage.by_control.tr_mul(&adjoint);
            adjoint = stage.by_state.tr_mul(&adjoint);
            if k == row.stage
                && let Some(before) = row.before
            {
                adjoint += before;
            }
        }
        gradient
    }

    /// Σ max(0, −g), in the rows' unit.
    pub fn total_violation(&self) -> f64 {
        self.rows.iter().map(|row| (-row.value).max(0.0)).sum()
    }

    /// max(0, −g) over the rows, in their unit.
    pub fn worst_violation(&self) -> f64 {
        self.rows.iter().map(|row| -row.value).fold(0.0, greatest)
    }
}
