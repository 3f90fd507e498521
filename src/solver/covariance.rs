//! How rows answer each other's multipliers: products with S = G H⁻¹ Gᵀ.
//!
//! H⁻¹ is the covariance of the controls under the density exp(−½ uᵀH u), and
//! the factored recursion samples it: du_k = −K dz_{k−1} + w_k with independent
//! w_k of covariance Q_uu⁻¹. So S is the covariance of the rows' linearised
//! values along a Gauss–Markov chain, and a product S x takes one sweep up the
//! chain and one down, whatever the number of rows:
//!
//! ```text
//! Ā_k = A_k − B_k K_k              closed-loop transition
//! Σ_k = Ā_k Σ_{k−1} Ā_kᵀ + B_k Q_uu⁻¹ B_kᵀ,   Σ_0 = 0
//! row at stage k = a·dz_{k−1} + b·w_k          a = before + Ā_kᵀ after − K_kᵀ control,
//!                                              b = B_kᵀ after + control
//! cov(dz_k, row) = h = Ā_k Σ_{k−1} a + B_k Q_uu⁻¹ b
//! ```
//!
//! Nothing of size rows × n is ever stored, so hundreds of active rows still
//! cost O(n) time and memory. The rows summed over stages, of which there are
//! few, are a border to that: each costs a solve, whose changes of all rows are
//! its row of S.

use super::chain::{Chain, Control, Row, State};
use super::point::Point;
use super::riccati::{Riccati, Source};
use nalgebra::{SMatrix, SVector};

/// A row in terms of the chain's noise.
#[derive(Clone, Copy, Debug)]
struct Response<const NX: usize, const NU: usize> {
    row: usize,
    stage: usize,
    /// a.
    by_state: State<NX>,
    /// b, and Q_uu⁻¹ b.
    by_noise: Control<NU>,
    noise: Control<NU>,
    /// Σ_{k−1} a.
    spread: State<NX>,
    /// h = cov(dz_k, row).
    after: State<NX>,
}

impl<const NX: usize, const NU: usize> Response<NX, NU> {
    /// The entry of S for another row of the same stage.
    fn within(&self, other: &Self) -> f64 {
        other.by_state.dot(&self.spread) + other.by_noise.dot(&self.noise)
    }
}

/// A row summed over stages, with all others.
#[derive(Clone, Debug, Default)]
struct Border {
    /// Its row of S, its own compliance on the diagonal; one entry a row.
    with: Vec<f64>,
}

/// The rows of a point, ready for products with S.
#[derive(Clone, Debug)]
pub(super) struct Covariance<const NX: usize, const NU: usize> {
    /// Ā_1 … Ā_n.
    transitions: Vec<SMatrix<f64, NX, NX>>,
    /// By stage.
    responses: Vec<Response<NX, NU>>,
    /// Where each row of the point stands in `responses`.
    places: Vec<usize>,
    /// Scratch of [`Covariance::column`]: places and their order.
    order: Vec<(usize, usize)>,
    /// The rows summed over stages.
    borders: Vec<Border>,
    /// Of each sum that stiffens the Hessian its weight, and how it changes the rows
    /// that are not summed.
    corrections: Vec<(f64, Vec<f64>)>,
    /// Scratch of their solves.
    weights: Vec<f64>,
    du: Vec<Control<NU>>,
    dz: Vec<State<NX>>,
}

impl<const NX: usize, const NU: usize> Default for Covariance<NX, NU> {
    fn default() -> Self {
        Self {
            transitions: Vec::new(),
            responses: Vec::new(),
            places: Vec::new(),
            order: Vec::new(),
            borders: Vec::new(),
            corrections: Vec::new(),
            weights: Vec::new(),
            du: Vec::new(),
            dz: Vec::new(),
        }
    }
}

impl<const NX: usize, const NU: usize> Covariance<NX, NU> {
    /// Prepares for the rows of `point` and the Hessian in `riccati`.
    pub fn refresh<C: Chain<NX, NU>>(
        &mut self,
        point: &Point<C, NX, NU>,
        riccati: &mut Riccati<NX, NU>,
    ) {
        if C::SUM_ROWS {
            self.refresh_borders(point, riccati);
        }
        let empty = |(row, at): (usize, &Row<NX, NU>)| Response {
            row,
            stage: at.stage,
            by_state: SVector::zeros(),
            by_noise: SVector::zeros(),
            noise: SVector::zeros(),
            spread: SVector::zeros(),
            after: SVector::zeros(),
        };
        self.responses.clear();
        self.responses
            .extend(point.rows.iter().enumerate().map(empty));
        self.responses
            .sort_unstable_by_key(|response| (response.stage, response.row));
        self.places.clear();
        self.places.resize(self.responses.len(), 0);
        for (place, response) in self.responses.iter().enumerate() {
            self.places[response.row] = place;
        }
        self.transitions.clear();
        let last = self.responses.last().map_or(0, |response| response.stage);
        let mut spread: SMatrix<f64, NX, NX> = SMatrix::zeros();
        let mut responses = self.responses.iter_mut().peekable();
        for k in 1..=last {
            let stage = &point.stages[k - 1];
            let (inverse, gain) = riccati.feedback(k);
            let transition = stage.by_state - stage.by_control * gain;
            while let Some(response) = responses.next_if(|response| response.stage == k) {
                let row = &point.rows[response.row];
                response.by_state = transition.tr_mul(&row.after) - gain.tr_mul(&row.control);
                // The control's noise also acts on the row through the node.
                if let Some(before) = row.before {
                    response.by_state += before;
                }
                response.by_noise = stage.by_control.tr_mul(&row.after) + row.control;
                response.noise = inverse * response.by_noise;
                response.spread = spread * response.by_state;
                response.after = transition * response.spread + stage.by_control * response.noise;
            }
            spread = transition * spread * transition.transpose()
                + stage.by_control * inverse * stage.by_control.transpose();
            self.transitions.push(transition);
        }
    }

    fn refresh_borders<C: Chain<NX, NU>>(
        &mut self,
        point: &Point<C, NX, NU>,
        riccati: &mut Riccati<NX, NU>,
    ) {
        let count = point.row_count();
        self.borders.resize(point.sums.len(), Border::default());
        for (index, border) in self.borders.iter_mut().enumerate() {
            self.weights.clear();
            self.weights.resize(count, 0.0);
            self.weights[point.rows.len() + index] = 1.0;
            let weights = Source::Rows(&self.weights);
            riccati.solve(point, weights, &mut self.du, &mut self.dz);
            border.with.clear();
            let (du, dz) = (&self.du, &self.dz);
            border
                .with
                .extend(point.rows.iter().map(|row| row.change(du, dz)));
            border
                .with
                .extend(point.sums.iter().map(|sum| sum.change(du)));
            border.with[point.rows.len() + index] += point.sums[index].row.compliance;
        }
        self.corrections.clear();
        self.corrections
            .extend(riccati.updates().iter().map(|update| {
                let rows = point.rows.iter();
                let changes = rows.map(|row| row.change(&update.du, &update.dz));
                (update.weight, changes.collect())
            }));
    }

    /// The summed row in this place among all rows, if it is one.
    fn border(&self, row: usize) -> Option<&Border> {
        self.borders.get(row.checked_sub(self.responses.len())?)
    }

    /// The entry of S on its diagonal.
    pub fn diagonal(&self, row: usize) -> f64 {
        if let Some(border) = self.border(row) {
            return border.with[row];
        }
        let response = &self.responses[self.places[row]];
        let corrections = self.corrections.iter();
        let taken = corrections.map(|(weight, changes)| weight * changes[row] * changes[row]);
        response.within(response) - taken.sum::<f64>()
    }

    /// The entries of S of one row against some others, in their order. Costs
    /// the stages between the outermost of them.
    pub fn column(&mut self, row: usize, others: &[usize], column: &mut Vec<f64>) {
        column.clear();
        if let Some(border) = self.border(row) {
            column.extend(others.iter().map(|other| border.with[*other]));
            return;
        }
        let place = self.places[row];
        let here = &self.responses[place];
        column.resize(others.len(), 0.0);
        self.order.clear();
        for (slot, other) in others.iter().enumerate() {
            match self.places.get(*other) {
                Some(place) => self.order.push((*place, slot)),
                None => {
                    let border = &self.borders[*other - self.responses.len()];
                    column[slot] = border.with[row];
                }
            }
        }
        self.order.sort_unstable();
        let split = self.order.partition_point(|(other, _)| *other < place);
        let mut stage = here.stage;
        let mut state = here.after;
        for (other, slot) in &self.order[split..] {
            let other = &self.responses[*other];
            if other.stage == here.stage {
                column[*slot] = here.within(other);
                continue;
            }
            while stage < other.stage - 1 {
                stage += 1;
                state = self.transitions[stage - 1] * state;
            }
            column[*slot] = other.by_state.dot(&state);
        }
        let mut stage = here.stage - 1;
        let mut pull = here.by_state;
        for (other, slot) in self.order[..split].iter().rev() {
            let other = &self.responses[*other];
            if other.stage == here.stage {
                column[*slot] = here.within(other);
                continue;
            }
            while stage > other.stage {
                pull = self.transitions[stage - 1].tr_mul(&pull);
                stage -= 1;
            }
            column[*slot] = other.after.dot(&pull);
        }
        for (weight, changes) in &self.corrections {
            for (entry, other) in column.iter_mut().zip(others) {
                if let Some(change) = changes.get(*other) {
                    *entry -= weight * changes[row] * change;
                }
            }
        }
    }

    /// `product` = S `weights`, both one entry a row of the point.
    pub fn multiply(&self, weights: &[f64], product: &mut [f64]) {
        product.iter_mut().for_each(|entry| *entry = 0.0);
        self.multiply_stages(weights, product);
        for (weight, changes) in &self.corrections {
            let along: f64 = changes.iter().zip(weights).map(|(c, w)| c * w).sum();
            for (entry, change) in product.iter_mut().zip(changes) {
                *entry -= weight * along * change;
            }
        }
        let own = self.responses.len();
        for (index, border) in self.borders.iter().enumerate() {
            let weight = weights[own + index];
            for (entry, with) in product.iter_mut().zip(&border.with) {
                *entry += weight * with;
            }
            let others = weights[..own].iter().zip(&border.with);
            product[own + index] += others.map(|(weight, with)| weight * with).sum::<f64>();
        }
    }

    /// Adds the products among the rows that are not summed.
    fn multiply_stages(&self, weights: &[f64], product: &mut [f64]) {
        let used = |response: &&Response<NX, NU>| weights[response.row] != 0.0;
        let Some(first) = self.responses.iter().position(|r| used(&r)) else {
            return;
        };
        let last = self
            .responses
            .iter()
            .rposition(|r| used(&r))
            .unwrap_or(first);
        // Up the chain: what rows at lower stages do to those above.
        let mut state: State<NX> = SVector::zeros();
        let mut stage = self.responses[first].stage;
        let mut at = self.responses.partition_point(|r| r.stage < stage);
        while at < self.responses.len() {
            // `state` is cov(dz_{stage−1}, Σ weights · rows below).
            let mut added: State<NX> = SVector::zeros();
            let group = at;
            while at < self.responses.len() && self.responses[at].stage == stage {
                let response = &self.responses[at];
                product[response.row] += response.by_state.dot(&state);
                let weight = weights[response.row];
                if weight != 0.0 {
                    added += weight * response.after;
                    for other in &self.responses[group..] {
                        if other.stage != stage {
                            break;
                        }
                        product[other.row] += weight * response.within(other);
                    }
                }
                at += 1;
            }
            state = self.transitions[stage - 1] * state + added;
            stage += 1;
        }
        // Down the chain: what rows at higher stages do to those below.
        let mut pull: State<NX> = SVector::zeros();
        let mut at = last + 1;
        let mut stage = self.responses[last].stage;
        while at > 0 {
            // `pull` is the weighted rows' gradient in dz_stage.
            let mut added: State<NX> = SVector::zeros();
            while at > 0 && self.responses[at - 1].stage == stage {
                let response = &self.responses[at - 1];
                product[response.row] += response.after.dot(&pull);
                added += weights[response.row] * response.by_state;
                at -= 1;
            }
            pull = self.transitions[stage - 1].tr_mul(&pull) + added;
            stage -= 1;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::solver::Source;
    use crate::solver::linear::{Linear, blocks, point};

    /// S from columns, from products and from one solve a row agree.
    #[test]
    fn columns_products_and_solves_agree() {
        let point = point();
        let rows = point.rows.len();
        let none = vec![0.0; rows];
        let mut hessian = blocks(&Linear { bent: 0.0 }, &point, &none);
        hessian.stiffen(&point, &point.rows[4], 3.0);
        let mut riccati = Riccati::default();
        riccati.factor(&point.stages, &hessian, 0.5, 1e-9).unwrap();
        let mut covariance = Covariance::default();
        covariance.refresh(&point, &mut riccati);

        let all: Vec<usize> = (0..rows).rev().collect();
        let (mut du, mut dz, mut column) = (Vec::new(), Vec::new(), Vec::new());
        let mut product = vec![0.0; rows];
        let close = |a: f64, b: f64| (a - b).abs() < 1e-11 * (1.0 + b.abs());
        for row in 0..rows {
            let mut weights = none.clone();
            weights[row] = 1.0;
            riccati.solve(&point, Source::Rows(&weights), &mut du, &mut dz);
            covariance.column(row, &all, &mut column);
            covariance.multiply(&weights, &mut product);
            for other in 0..rows {
                let solved = point.rows[other].change(&du, &dz);
                assert!(close(column[rows - 1 - other], solved), "{row} {other}");
                assert!(close(product[other], solved), "{row} {other}");
            }
            let diagonal = point.rows[row].change(&du, &dz);
            assert!(close(covariance.diagonal(row), diagonal) && diagonal > 0.0);
        }
        let weights: Vec<f64> = (0..rows).map(|row| libm::sin(row as f64)).collect();
        riccati.solve(&point, Source::Rows(&weights), &mut du, &mut dz);
        covariance.multiply(&weights, &mut product);
        for (row, product) in point.rows.iter().zip(&product) {
            assert!(close(*product, row.change(&du, &dz)));
        }
    }
}
