//! The quadratic subproblem of one Newton step, by a dual active set.
//!
//! ```text
//! minimise ½ dᵀH d + ∇fᵀd + ν Σ s_r   subject to   g_r + ∇g_rᵀ d + s_r ≥ 0,  s ⪰ 0
//! ```
//!
//! The slacks s make it solvable whatever the rows; in the dual they are the
//! bounds 0 ≤ λ_r ≤ ν. With the columns V_r = H⁻¹ ∇g_r the step is
//! d = −H⁻¹∇f + Σ λ_r V_r, and the rows meet only in the small dense
//! S = Gᵀ V. As in Goldfarb and Idnani (1983), rows enter one at a time, the
//! most violated first, and the dual objective rises with each; S's factor is
//! updated, not rebuilt. Each row that takes part costs one O(n) solve.

use super::chain::{Chain, Control, State};
use super::point::Point;
use super::riccati::{Riccati, Source};
use super::sqp::held;
use crate::math::PackedCholesky;

/// A row depends on those in the set where its pivot falls below this share
/// of its diagonal: 1e-11 is well above the rounding of S (condition · 1e-16)
/// and well below any geometric angle between rows that matters.
const DEPENDENT: f64 = 1e-11;

/// Where a row that takes part stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Standing {
    /// λ = 0.
    Idle,
    /// 0 < λ < ν, the row met as an equality.
    Active,
    /// λ = ν, the row cannot be met.
    Saturated,
}

/// A row that takes part, with V = H⁻¹ ∇g.
#[derive(Clone, Debug)]
struct Column<const NX: usize, const NU: usize> {
    row: usize,
    du: Vec<Control<NU>>,
    dz: Vec<State<NX>>,
    standing: Standing,
    multiplier: f64,
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

/// The subproblem's data and solution; its storage is kept between steps.
#[derive(Clone, Debug)]
pub(super) struct WorkingSet<const NX: usize, const NU: usize> {
    /// The step in the controls (n) …
    pub du: Vec<Control<NU>>,
    /// … and in the states (n + 1).
    pub dz: Vec<State<NX>>,
    /// λ, one a row of the point.
    pub multipliers: Vec<f64>,
    base_du: Vec<Control<NU>>,
    base_dz: Vec<State<NX>>,
    columns: Vec<Column<NX, NU>>,
    used: usize,
    column_of_row: Vec<Option<usize>>,
    /// Columns whose rows are active, in the order of the factor.
    members: Vec<usize>,
    factor: PackedCholesky,
    scratch: Vec<f64>,
}

impl<const NX: usize, const NU: usize> Default for WorkingSet<NX, NU> {
    fn default() -> Self {
        Self {
            du: Vec::new(),
            dz: Vec::new(),
            multipliers: Vec::new(),
            base_du: Vec::new(),
            base_dz: Vec::new(),
            columns: Vec::new(),
            used: 0,
            column_of_row: Vec::new(),
            members: Vec::new(),
            factor: PackedCholesky::default(),
            scratch: Vec::new(),
        }
    }
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
        self.used = 0;
        self.members.clear();
        self.factor.clear();
        self.column_of_row.clear();
        self.column_of_row.resize(point.rows.len(), None);
        riccati.solve(point, Source::Cost, &mut self.base_du, &mut self.base_dz);
        self.negate_base();
        self.start_from(riccati, point, guess, terms);
        self.repair_start(point, terms.penalty);
        self.combine();
        // Each full step raises the dual objective, so no set comes twice in
        // exact arithmetic; the bound only guards against rounding.
        for _ in 0..50 + 10 * point.rows.len() {
            let Some(row) = self.most_violated(point, terms.tolerance) else {
                break;
            };
            self.enter(riccati, point, row, terms.penalty);
            self.combine();
        }
        self.multipliers.clear();
        self.multipliers.resize(point.rows.len(), 0.0);
        for column in &self.columns[..self.used] {
            self.multipliers[column.row] = column.multiplier;
        }
    }

    /// Takes the last [`WorkingSet::correct`] back.
    pub fn uncorrect(&mut self) {
        self.combine();
    }

    /// Moves the step so that the active rows, whose values became `values`
    /// (one a row) after it, are met to second order: d + Σ V_r μ_r with
    /// S μ = −values.
    pub fn correct(&mut self, values: impl Fn(usize) -> f64) {
        self.scratch.clear();
        for &member in &self.members {
            self.scratch.push(-values(self.columns[member].row));
        }
        self.factor.solve(&mut self.scratch);
        for (&member, &amount) in self.members.iter().zip(&self.scratch) {
            let column = &self.columns[member];
            for (d, v) in self.du.iter_mut().zip(&column.du) {
                *d += amount * v;
            }
        }
    }

    fn negate_base(&mut self) {
        self.base_du.iter_mut().for_each(|d| *d = -*d);
        self.base_dz.iter_mut().for_each(|d| *d = -*d);
    }

    /// Makes every guessed row a member, unless it depends on those before.
    fn start_from<C: Chain<NX, NU>>(
        &mut self,
        riccati: &mut Riccati<NX, NU>,
        point: &Point<C, NX, NU>,
        guess: &[f64],
        terms: Terms,
    ) {
        for (row, _) in guess.iter().enumerate().filter(|(_, guess)| **guess > 0.0) {
            let index = self.column(riccati, point, row);
            if terms.stiffness > 0.0 && held(guess[row], terms.penalty) {
                // ½ρ(g + ∇gᵀd)² also has a linear part.
                let amount = terms.stiffness * point.rows[row].value;
                let column = &self.columns[index];
                for (d, v) in self.base_du.iter_mut().zip(&column.du) {
                    *d -= amount * v;
                }
                for (d, v) in self.base_dz.iter_mut().zip(&column.dz) {
                    *d -= amount * v;
                }
            }
            self.join(point, index);
        }
    }

    /// Solves for the members' multipliers and drops or saturates those out
    /// of bounds until the rest is consistent.
    fn repair_start<C: Chain<NX, NU>>(&mut self, point: &Point<C, NX, NU>, penalty: f64) {
        loop {
            self.scratch.clear();
            for &member in &self.members {
                let row = &point.rows[self.columns[member].row];
                let mut right = -row.value - row.change(&self.base_du, &self.base_dz);
                for other in &self.columns[..self.used] {
                    if other.standing == Standing::Saturated {
                        right -= penalty * row.change(&other.du, &other.dz);
                    }
                }
                self.scratch.push(right);
            }
            self.factor.solve(&mut self.scratch);
            let mut worst = (0.0, None);
            for (position, &multiplier) in self.scratch.iter().enumerate() {
                let excess = (-multiplier).max(multiplier - penalty);
                if excess > worst.0 {
                    worst = (excess, Some(position));
                }
            }
            let Some(position) = worst.1 else { break };
            let standing = if self.scratch[position] < 0.0 {
                Standing::Idle
            } else {
                Standing::Saturated
            };
            self.leave(position, standing, penalty);
        }
        for (&member, &multiplier) in self.members.iter().zip(&self.scratch) {
            self.columns[member].multiplier = multiplier;
        }
    }

    /// The index of a row's column, computed when it is first needed.
    fn column<C: Chain<NX, NU>>(
        &mut self,
        riccati: &mut Riccati<NX, NU>,
        point: &Point<C, NX, NU>,
        row: usize,
    ) -> usize {
        if let Some(index) = self.column_of_row[row] {
            return index;
        }
        let index = self.used;
        if index == self.columns.len() {
            self.columns.push(Column {
                row,
                du: Vec::new(),
                dz: Vec::new(),
                standing: Standing::Idle,
                multiplier: 0.0,
            });
        }
        self.used += 1;
        self.column_of_row[row] = Some(index);
        let column = &mut self.columns[index];
        column.row = row;
        column.standing = Standing::Idle;
        column.multiplier = 0.0;
        riccati.solve(
            point,
            Source::Row(&point.rows[row]),
            &mut column.du,
            &mut column.dz,
        );
        index
    }

    /// Adds a column to the set. False where its row depends on the members.
    fn join<C: Chain<NX, NU>>(&mut self, point: &Point<C, NX, NU>, index: usize) -> bool {
        let column = &self.columns[index];
        self.scratch.clear();
        for &member in &self.members {
            let row = &point.rows[self.columns[member].row];
            self.scratch.push(row.change(&column.du, &column.dz));
        }
        let diagonal = point.rows[column.row].change(&column.du, &column.dz);
        let joined = diagonal > 0.0
            && self
                .factor
                .append(&self.scratch, diagonal, DEPENDENT * diagonal)
                .is_ok();
        if joined {
            self.members.push(index);
            self.columns[index].standing = Standing::Active;
        }
        joined
    }

    fn leave(&mut self, position: usize, standing: Standing, penalty: f64) {
        let index = self.members.remove(position);
        self.factor.remove(position);
        self.columns[index].standing = standing;
        self.columns[index].multiplier = match standing {
            Standing::Saturated => penalty,
            _ => 0.0,
        };
    }

    /// d = d_0 + Σ λ V.
    fn combine(&mut self) {
        self.du.clone_from(&self.base_du);
        self.dz.clone_from(&self.base_dz);
        for column in &self.columns[..self.used] {
            let multiplier = column.multiplier;
            if multiplier != 0.0 {
                for (d, v) in self.du.iter_mut().zip(&column.du) {
                    *d += multiplier * v;
                }
                for (d, v) in self.dz.iter_mut().zip(&column.dz) {
                    *d += multiplier * v;
                }
            }
        }
    }

    /// The row whose optimality fails most: an idle one below zero, or a
    /// saturated one above.
    fn most_violated<C: Chain<NX, NU>>(
        &self,
        point: &Point<C, NX, NU>,
        tolerance: f64,
    ) -> Option<usize> {
        let mut worst = (tolerance, None);
        for (index, row) in point.rows.iter().enumerate() {
            let standing =
                self.column_of_row[index].map_or(Standing::Idle, |c| self.columns[c].standing);
            if standing == Standing::Active {
                continue;
            }
            let value = row.value + row.change(&self.du, &self.dz);
            let failure = if standing == Standing::Idle {
                -value
            } else {
                value
            };
            if failure > worst.0 {
                worst = (failure, Some(index));
            }
        }
        worst.1
    }

    /// Moves one row's multiplier, and the members' with it, until the row is
    /// met or cannot be.
    fn enter<C: Chain<NX, NU>>(
        &mut self,
        riccati: &mut Riccati<NX, NU>,
        point: &Point<C, NX, NU>,
        row: usize,
        penalty: f64,
    ) {
        let index = self.column(riccati, point, row);
        // A saturated row that is met too well gives its multiplier back.
        let sign = match self.columns[index].standing {
            Standing::Saturated => -1.0,
            _ => 1.0,
        };
        let mut value = point.rows[row].value + point.rows[row].change(&self.du, &self.dz);
        let diagonal = {
            let column = &self.columns[index];
            point.rows[row].change(&column.du, &column.dz)
        };
        loop {
            self.scratch.clear();
            for &member in &self.members {
                let other = &point.rows[self.columns[member].row];
                let column = &self.columns[index];
                self.scratch.push(other.change(&column.du, &column.dz));
            }
            let mut pivot = diagonal;
            let start = self.scratch.len();
            self.scratch.extend_from_within(..);
            self.factor.solve(&mut self.scratch[..start]);
            for i in 0..start {
                pivot -= self.scratch[i] * self.scratch[start + i];
            }
            let (mut reach, mut limit) = if pivot > DEPENDENT * diagonal {
                (-sign * value / pivot, Limit::Met)
            } else {
                (f64::INFINITY, Limit::Met)
            };
            let multiplier = self.columns[index].multiplier;
            let own = if sign > 0.0 {
                (penalty - multiplier, Standing::Saturated)
            } else {
                (multiplier, Standing::Idle)
            };
            if own.0 < reach {
                (reach, limit) = (own.0, Limit::Own(own.1));
            }
            for (position, &member) in self.members.iter().enumerate() {
                let rate = -sign * self.scratch[position];
                let multiplier = self.columns[member].multiplier;
                let (room, standing) = if rate < 0.0 {
                    (multiplier / -rate, Standing::Idle)
                } else {
                    ((penalty - multiplier) / rate, Standing::Saturated)
                };
                if rate != 0.0 && room < reach {
                    (reach, limit) = (room, Limit::Member(position, standing));
                }
            }
            let reach = reach.max(0.0);
            for (position, &member) in self.members.iter().enumerate() {
                self.columns[member].multiplier -= sign * reach * self.scratch[position];
            }
            self.columns[index].multiplier += sign * reach;
            value += sign * reach * pivot;
            match limit {
                Limit::Met => {
                    self.join(point, index);
                    return;
                }
                Limit::Own(standing) => {
                    self.columns[index].standing = standing;
                    self.columns[index].multiplier = match standing {
                        Standing::Saturated => penalty,
                        _ => 0.0,
                    };
                    return;
                }
                Limit::Member(position, standing) => self.leave(position, standing, penalty),
            }
        }
    }
}
