//! A point of the solver's path: controls, the chain rolled out from them,
//! and the rows there. It takes no decisions.

use super::chain::{Chain, Control, Row, RowId, Stage, State, SumRow};
use crate::math::greatest;

/// A row summed over stages, at a point.
#[derive(Clone, Debug)]
pub struct Sum<const NU: usize> {
    /// The row.
    pub row: SumRow,
    /// b + Σ c_k, in the rows' unit.
    pub value: f64,
    /// ∂c_k/∂u_k, one a stage.
    pub gradient: Vec<Control<NU>>,
}

impl<const NU: usize> Sum<NU> {
    /// The value's first-order change under perturbed controls.
    pub fn change(&self, du: &[Control<NU>]) -> f64 {
        self.gradient.iter().zip(du).map(|(g, d)| g.dot(d)).sum()
    }

    /// What is missing to g ≥ 0 with a multiplier, in the rows' unit; negative where
    /// nothing is.
    pub fn violation(&self, multiplier: f64) -> f64 {
        -(self.value + self.row.compliance * multiplier)
    }
}

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
    /// The rows summed over stages, by id. Wherever there is one number a row, theirs
    /// come after those of `rows`.
    pub sums: Vec<Sum<NU>>,
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
            sums: Vec::new(),
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
        if C::SUM_ROWS {
            self.evaluate_sums(chain);
        }
    }

    fn evaluate_sums(&mut self, chain: &C) {
        let count = chain.sum_count();
        self.sums.truncate(count);
        for index in 0..count {
            let row = chain.sum_row(index);
            if index == self.sums.len() {
                self.sums.push(Sum {
                    row,
                    value: 0.0,
                    gradient: Vec::new(),
                });
            }
            let sum = &mut self.sums[index];
            sum.row = row;
            sum.value = row.bound;
            sum.gradient.clear();
            for (before, kept) in self.kept.iter().enumerate() {
                let (value, gradient) = chain.sum_term(index, before + 1, kept);
                sum.value += value;
                sum.gradient.push(gradient);
            }
        }
    }

    /// The number of all rows.
    pub fn row_count(&self) -> usize {
        self.rows.len() + self.sums.len()
    }

    /// The name of a row, by its place among all.
    pub fn row_id(&self, row: usize) -> RowId {
        match self.rows.get(row) {
            Some(row) => row.id,
            None => self.sums[row - self.rows.len()].row.id,
        }
    }

    /// A row's value after a step, to first order but for its compliance, by its place
    /// among all.
    pub fn value_after(&self, row: usize, du: &[Control<NU>], dz: &[State<NX>]) -> f64 {
        match self.rows.get(row) {
            Some(row) => row.value + row.change(du, dz),
            None => {
                let sum = &self.sums[row - self.rows.len()];
                sum.value + sum.change(du)
            }
        }
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

    /// Σ max(0, −g) over the rows that do not give way, in their unit.
    pub fn total_violation(&self) -> f64 {
        let mut total = self.rows.iter().map(|row| (-row.value).max(0.0)).sum();
        if C::SUM_ROWS {
            let stiff = self.sums.iter().filter(|sum| sum.row.compliance == 0.0);
            total += stiff.map(|sum| (-sum.value).max(0.0)).sum::<f64>();
        }
        total
    }

    /// The greatest of max(0, −g) over all rows, in their unit, with their
    /// multipliers.
    pub fn worst_violation(&self, multipliers: &[f64]) -> f64 {
        let worst = self.rows.iter().map(|row| -row.value).fold(0.0, greatest);
        if !C::SUM_ROWS {
            return worst;
        }
        let summed = self.sums.iter().zip(&multipliers[self.rows.len()..]);
        summed
            .map(|(sum, multiplier)| sum.violation(*multiplier))
            .fold(worst, greatest)
    }
}
