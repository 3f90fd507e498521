//! The quadratic subproblem of one Newton step, by a dual active set.
//!
//! ```text
//! minimise ½ dᵀH d + ∇fᵀd + ν Σ s_r   subject to   g_r + ∇g_rᵀ d + s_r ≥ 0,  s ⪰ 0
//! ```
//!
//! The slacks s make it solvable whatever the rows; in the dual they are the
//! bounds 0 ≤ λ_r ≤ ν. The step is d = H⁻¹(Σ λ ∇g − ∇f), so the linearised
//! rows are y = y_0 + S λ with S = G H⁻¹ Gᵀ, and the search for λ happens in
//! the rows alone: H is only met in products with S, each O(n). As in Goldfarb
//! and Idnani (1983), rows enter one at a time, the most violated first, and
//! the dual objective rises with each; the factor of S among the rows in the
//! set is updated, not rebuilt.

use super::chain::{Chain, Control, State};
use super::covariance::Covariance;
use super::point::Point;
use super::riccati::{Riccati, Source};
use super::sqp::held;
use crate::math::PackedCholesky;

#[cfg(test)]
mod tests;

/// A row depends on those in the set where its pivot falls below this share
/// of its diagonal: 1e-11 is well above the rounding of S (condition · 1e-16)
/// and well below that of any two rows whose difference matters.
const DEPENDENT: f64 = 1e-11;

/// Where a row stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Standing {
    /// λ = 0.
    Idle,
    /// 0 < λ < ν, the row met as an equality.
    Active,
    /// λ = ν, the row cannot be met.
    Saturated,
}

/// How one row's entering move ended.
enum Limit {
    /// The row is met.
    Met,
    /// Its own multiplier ran into 0 or ν.
    Own(Standing),
    /// The multiplier of this member of the set ran into 0 or ν.
    Member(usize, Standing),
}

/// What the subproblem is solved for.
#[derive(Clone, Copy, Debug)]
pub(super) struct Terms {
    /// ν, the bound of the multipliers.
    pub penalty: f64,
    /// How far below zero a linearised row may end, in the rows' unit.
    pub tolerance: f64,
    /// ρ of the rows that [`super::Hessian::stiffen`] was called for: those
    /// that the guess has [`held`].
    pub stiffness: f64,
}

/// The subproblem's data and solution; its storage is kept between steps.
#[derive(Clone, Debug)]
pub(super) struct WorkingSet<const NX: usize, const NU: usize> {
    /// The step in the controls (n) …
    pub du: Vec<Control<NU>>,
    /// … and in the states (n + 1).
    pub dz: Vec<State<NX>>,
    /// λ, one a row of the point, as the next five.
    pub multipliers: Vec<f64>,
    /// y, the rows after the step to first order.
    values: Vec<f64>,
    standings: Vec<Standing>,
    /// −ρ g of the stiffened rows: the linear part of ½ρ(g + ∇gᵀd)², which
    /// acts like a multiplier.
    offsets: Vec<f64>,
    /// Changes of λ not yet in the values, and their effect.
    changes: Vec<f64>,
    effects: Vec<f64>,
    covariance: Covariance<NX, NU>,
    /// The active rows, in the order of the factor.
    members: Vec<usize>,
    factor: PackedCholesky,
    /// Scratch, one entry a member: a column of S, and S⁻¹ of it.
    column: Vec<f64>,
    rates: Vec<f64>,
}

impl<const NX: usize, const NU: usize> Default for WorkingSet<NX, NU> {
    fn default() -> Self {
        Self {
            du: Vec::new(),
            dz: Vec::new(),
            multipliers: Vec::new(),
            values: Vec::new(),
            standings: Vec::new(),
            offsets: Vec::new(),
            changes: Vec::new(),
            effects: Vec::new(),
            covariance: Covariance::default(),
            members: Vec::new(),
            factor: PackedCholesky::default(),
            column: Vec::new(),
            rates: Vec::new(),
        }
    }
}

impl<const NX: usize, const NU: usize> WorkingSet<NX, NU> {
    /// Solves the subproblem at `point`, starting from the rows with a
    /// positive entry in `guess` (one a row).
    pub fn solve<C: Chain<NX, NU>>(
        &mut self,
        riccati: &mut Riccati<NX, NU>,
        point: &Point<C, NX, NU>,
        guess: &[f64],
        terms: Terms,
    ) {
        self.reset(point, guess, terms);
        if C::SUM_ROWS {
            for update in riccati.updates() {
                let value = point.sums[update.sum].value;
                self.offsets[point.rows.len() + update.sum] = -update.stiffness * value;
            }
        }
        riccati.solve(
            point,
            Source::Step(&self.offsets),
            &mut self.du,
            &mut self.dz,
        );
        let (du, dz) = (&self.du, &self.dz);
        let values = (0..point.row_count()).map(|row| point.value_after(row, du, dz));
        self.values.extend(values);
        let idle = self.most_violated(terms.tolerance).is_none();
        if idle && guess.iter().all(|guess| *guess <= 0.0) {
            return;
        }
        self.covariance.refresh(point, riccati);
        for (row, _) in guess.iter().enumerate().filter(|(_, guess)| **guess > 0.0) {
            self.join(row);
        }
        self.repair_start(terms.penalty);
        // Each full step raises the dual objective, so no set comes twice in
        // exact arithmetic; the bound only guards against rounding.
        for _ in 0..50 + 10 * point.row_count() {
            let Some(row) = self.most_violated(terms.tolerance) else {
                break;
            };
            self.enter(row, terms.penalty);
        }
        self.update_step(riccati, point);
    }

    /// Moves the step so that the active rows, whose values became `values`
    /// (of a row and its multiplier) after it, are met to second order:
    /// d + H⁻¹ Σ μ ∇g with S μ = −values.
    pub fn correct<C: Chain<NX, NU>>(
        &mut self,
        riccati: &mut Riccati<NX, NU>,
        point: &Point<C, NX, NU>,
        values: impl Fn(usize, f64) -> f64,
    ) {
        self.rates.clear();
        let multipliers = &self.multipliers;
        let right = self
            .members
            .iter()
            .map(|&row| -values(row, multipliers[row]));
        self.rates.extend(right);
        self.factor.solve(&mut self.rates);
        self.changes.iter_mut().for_each(|change| *change = 0.0);
        for (&row, &rate) in self.members.iter().zip(&self.rates) {
            self.changes[row] = rate;
        }
        self.update_step(riccati, point);
    }

    /// Takes the last [`WorkingSet::correct`] back.
    pub fn uncorrect<C: Chain<NX, NU>>(
        &mut self,
        riccati: &mut Riccati<NX, NU>,
        point: &Point<C, NX, NU>,
    ) {
        self.changes.iter_mut().for_each(|change| *change = 0.0);
        self.update_step(riccati, point);
    }

    fn reset<C: Chain<NX, NU>>(&mut self, point: &Point<C, NX, NU>, guess: &[f64], terms: Terms) {
        let rows = point.row_count();
        for entries in [
            &mut self.multipliers,
            &mut self.offsets,
            &mut self.changes,
            &mut self.effects,
        ] {
            entries.clear();
            entries.resize(rows, 0.0);
        }
        self.values.clear();
        self.standings.clear();
        self.standings.resize(rows, Standing::Idle);
        self.members.clear();
        self.factor.clear();
        if terms.stiffness > 0.0 {
            for (row, (at, guess)) in point.rows.iter().zip(guess).enumerate() {
                if held(*guess, terms.penalty) {
                    self.offsets[row] = -terms.stiffness * at.value;
                }
            }
        }
    }

    /// d from the multipliers, the offsets and the changes not yet in them.
    fn update_step<C: Chain<NX, NU>>(
        &mut self,
        riccati: &mut Riccati<NX, NU>,
        point: &Point<C, NX, NU>,
    ) {
        let parts = self.multipliers.iter().zip(&self.offsets);
        for (change, (multiplier, offset)) in self.changes.iter_mut().zip(parts) {
            *change += multiplier + offset;
        }
        riccati.solve(
            point,
            Source::Step(&self.changes),
            &mut self.du,
            &mut self.dz,
        );
    }

    /// Solves for the members' multipliers and drops or saturates those out
    /// of bounds until the rest is consistent.
    fn repair_start(&mut self, penalty: f64) {
        loop {
            self.rates.clear();
            let right = self.members.iter().map(|&row| -self.values[row]);
            self.rates.extend(right);
            self.factor.solve(&mut self.rates);
            let mut worst = (0.0, None);
            for (position, &multiplier) in self.rates.iter().enumerate() {
                let excess = (-multiplier).max(multiplier - penalty);
                if excess > worst.0 {
                    worst = (excess, Some(position));
                }
            }
            let Some(position) = worst.1 else { break };
            if self.rates[position] < 0.0 {
                self.leave(position, Standing::Idle, penalty);
            } else {
                self.leave(position, Standing::Saturated, penalty);
                self.apply_changes();
            }
        }
        for (&row, &multiplier) in self.members.iter().zip(&self.rates) {
            self.multipliers[row] = multiplier;
            self.changes[row] += multiplier;
        }
        self.apply_changes();
    }

    /// Brings the changes into the values.
    fn apply_changes(&mut self) {
        self.covariance.multiply(&self.changes, &mut self.effects);
        for (value, effect) in self.values.iter_mut().zip(&self.effects) {
            *value += effect;
        }
        self.changes.iter_mut().for_each(|change| *change = 0.0);
    }

    /// Adds a row to the set, unless it depends on the members.
    fn join(&mut self, row: usize) {
        self.covariance.column(row, &self.members, &mut self.column);
        let diagonal = self.covariance.diagonal(row);
        let least = DEPENDENT * diagonal;
        if diagonal > 0.0 && self.factor.append(&self.column, diagonal, least).is_ok() {
            self.members.push(row);
            self.standings[row] = Standing::Active;
        }
    }

    /// Takes a member out of the set, with its multiplier at its bound.
    fn leave(&mut self, position: usize, standing: Standing, penalty: f64) {
        let row = self.members.remove(position);
        self.factor.remove(position);
        self.settle(row, standing, penalty);
    }

    /// Sets a row's multiplier to the bound it stands at.
    fn settle(&mut self, row: usize, standing: Standing, penalty: f64) {
        self.standings[row] = standing;
        let bound = match standing {
            Standing::Saturated => penalty,
            _ => 0.0,
        };
        self.changes[row] += bound - self.multipliers[row];
        self.multipliers[row] = bound;
    }

    /// The row whose optimality fails most: an idle one below zero, or a
    /// saturated one above.
    fn most_violated(&self, tolerance: f64) -> Option<usize> {
        let mut worst = (tolerance, None);
        for (row, (standing, value)) in self.standings.iter().zip(&self.values).enumerate() {
            let failure = match standing {
                Standing::Active => continue,
                Standing::Idle => -value,
                Standing::Saturated => *value,
            };
            if failure > worst.0 {
                worst = (failure, Some(row));
            }
        }
        worst.1
    }

    /// Moves one row's multiplier, and the members' with it, until the row is
    /// met or cannot be.
    fn enter(&mut self, row: usize, penalty: f64) {
        // A saturated row that is met too well gives its multiplier back.
        let sign = match self.standings[row] {
            Standing::Saturated => -1.0,
            _ => 1.0,
        };
        let mut value = self.values[row];
        let diagonal = self.covariance.diagonal(row);
        loop {
            self.covariance.column(row, &self.members, &mut self.column);
            self.rates.clone_from(&self.column);
            self.factor.solve(&mut self.rates);
            let known: f64 = self
                .column
                .iter()
                .zip(&self.rates)
                .map(|(a, b)| a * b)
                .sum();
            let pivot = diagonal - known;
            let reach = if pivot > DEPENDENT * diagonal {
                -sign * value / pivot
            } else {
                f64::INFINITY
            };
            let (reach, limit) = self.nearest_limit(row, sign, reach, penalty);
            for (&member, &rate) in self.members.iter().zip(&self.rates) {
                self.multipliers[member] -= sign * reach * rate;
                self.changes[member] -= sign * reach * rate;
            }
            self.multipliers[row] += sign * reach;
            self.changes[row] += sign * reach;
            value += sign * reach * pivot;
            match limit {
                Limit::Met => {
                    self.join(row);
                    break;
                }
                Limit::Own(standing) => {
                    self.settle(row, standing, penalty);
                    break;
                }
                Limit::Member(position, standing) => self.leave(position, standing, penalty),
            }
        }
        self.apply_changes();
    }

    /// How far a row's multiplier can move towards `reach`, where the row is
    /// met, before it or a member's runs into a bound; and what stops it.
    fn nearest_limit(&self, row: usize, sign: f64, reach: f64, penalty: f64) -> (f64, Limit) {
        let (mut reach, mut limit) = (reach, Limit::Met);
        let own = if sign > 0.0 {
            (penalty - self.multipliers[row], Standing::Saturated)
        } else {
            (self.multipliers[row], Standing::Idle)
        };
        if own.0 < reach {
            (reach, limit) = (own.0, Limit::Own(own.1));
        }
        for (position, (&member, &rate)) in self.members.iter().zip(&self.rates).enumerate() {
            let rate = -sign * rate;
            let multiplier = self.multipliers[member];
            let (room, standing) = if rate < 0.0 {
                (multiplier / -rate, Standing::Idle)
            } else {
                ((penalty - multiplier) / rate, Standing::Saturated)
            };
            if rate != 0.0 && room < reach {
                (reach, limit) = (room, Limit::Member(position, standing));
            }
        }
        (reach.max(0.0), limit)
    }
}
