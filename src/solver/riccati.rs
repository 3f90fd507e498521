//! H⁻¹ by a Riccati recursion, where H is a chain's Hessian in its controls.
//!
//! H d = b is the optimality condition of a linear-quadratic control problem:
//! minimise ½ Σ (dz, du)ᵀ M_k (dz, du) + ½ Σ dz_kᵀ W_k dz_k − bᵀ(du, dz) along
//! dz_k = A_k dz_{k−1} + B_k du_k, dz_0 = 0. Backward from the tip, with the
//! value function's Hessian P_k:
//!
//! ```text
//! Q_uu = M_uu + Bᵀ P B     Q_uz = M_uz + Bᵀ P A     Q_zz = M_zz + Aᵀ P A
//! K    = Q_uu⁻¹ Q_uz       P_{k−1} = W_{k−1} + Q_zz − Q_uzᵀ K
//! ```
//!
//! H is positive definite exactly where every Q_uu is (Wright 1993; it is the
//! block LDLᵀ of H in the tip-to-base order). Factoring and solving cost O(n).
//!
//! Where H is not, H + ρ c cᵀ with the gradient c of a row summed over the stages may
//! be: a minimum with the row's value held need not be one with its multiplier held.
//! The sum has no blocks; its inverse follows from H⁻¹ (Sherman, Morrison, Woodbury),
//! whose pivots then may be negative. With as many changes of sign of 1 + ρ cᵀH⁻¹c as H
//! has negative eigenvalues the sum is positive.

use super::chain::{Chain, Control, Stage, State};
use super::hessian::Hessian;
use super::point::Point;
use nalgebra::{Cholesky, Const, SMatrix, SVector};

/// H is not positive definite: the pivot of this stage is not.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct NotPositive {
    /// The stage nearest the tip at which the recursion stopped, from 1.
    pub stage: usize,
}

/// A right-hand side, as a gradient in controls and states.
#[derive(Clone, Copy, Debug)]
pub enum Source<'a> {
    /// Σ w ∇g, with one weight a row of the point, summed ones last.
    Rows(&'a [f64]),
    /// Σ λ ∇g less the gradient of the cost: the Newton step's.
    Step(&'a [f64]),
}

/// One stage of the factor.
#[derive(Clone, Copy, Debug)]
struct Factor<const NX: usize, const NU: usize> {
    /// Q_uu⁻¹.
    inverse: SMatrix<f64, NU, NU>,
    /// K = Q_uu⁻¹ Q_uz.
    gain: SMatrix<f64, NU, NX>,
}

/// What a stiffened sum adds to the inverse: −κ w wᵀ with w = H⁻¹c.
#[derive(Clone, Debug)]
pub(super) struct Update<const NX: usize, const NU: usize> {
    /// The sum's place among the sums.
    pub sum: usize,
    /// ρ.
    pub stiffness: f64,
    /// κ = ρ/(1 + ρ cᵀw).
    pub weight: f64,
    /// c.
    gradient: Vec<Control<NU>>,
    /// w …
    pub du: Vec<Control<NU>>,
    /// … and the states' part of it.
    pub dz: Vec<State<NX>>,
}

/// The factor of a Hessian, tip to base.
#[derive(Clone, Debug)]
pub struct Riccati<const NX: usize, const NU: usize> {
    factors: Vec<Factor<NX, NU>>,
    /// The sums that stiffen it.
    updates: Vec<Update<NX, NU>>,
    /// Scratch of a solve: Q_uu⁻¹ (b_u + Bᵀ s), one a stage.
    feedforward: Vec<Control<NU>>,
    /// The eigenvector of the least eigenvalue of the pivot that stopped the
    /// last factorisation.
    worst: Control<NU>,
}

impl<const NX: usize, const NU: usize> Default for Riccati<NX, NU> {
    fn default() -> Self {
        Self {
            factors: Vec::new(),
            updates: Vec::new(),
            feedforward: Vec::new(),
            worst: SVector::zeros(),
        }
    }
}

/// A⁻¹ for a positive definite A whose pivots exceed `least`.
fn positive_inverse<const NU: usize>(
    matrix: SMatrix<f64, NU, NU>,
    least: f64,
) -> Option<SMatrix<f64, NU, NU>> {
    if NU == 1 {
        let pivot = matrix[(0, 0)];
        return (pivot > least).then(|| SMatrix::from_element(1.0 / pivot));
    }
    let factor: Cholesky<f64, Const<NU>> = Cholesky::new(matrix)?;
    let positive = (0..NU).all(|i| factor.l_dirty()[(i, i)] * factor.l_dirty()[(i, i)] > least);
    positive.then(|| factor.inverse())
}

/// A⁻¹ for a symmetric A none of whose eigenvalues is smaller than `least`, and how
/// many of them are negative.
fn signed_inverse<const NU: usize>(
    matrix: SMatrix<f64, NU, NU>,
    least: f64,
) -> Option<(SMatrix<f64, NU, NU>, usize)> {
    if let Some(inverse) = positive_inverse(matrix, least) {
        return Some((inverse, 0));
    }
    // By Gauss and Jordan along the diagonal, largest pivot first: congruence keeps
    // the signs.
    let mut left = matrix;
    let mut inverse = SMatrix::<f64, NU, NU>::identity();
    let (mut negative, mut done) = (0, [false; NU]);
    for _ in 0..NU {
        let open = (0..NU).filter(|i| !done[*i]);
        let largest = open.max_by(|a, b| left[(*a, *a)].abs().total_cmp(&left[(*b, *b)].abs()))?;
        let pivot = left[(largest, largest)];
        if pivot.abs() <= least {
            return None;
        }
        negative += usize::from(pivot < 0.0);
        done[largest] = true;
        let (row, own) = (left.row(largest) / pivot, inverse.row(largest) / pivot);
        for i in (0..NU).filter(|i| *i != largest) {
            let factor = left[(i, largest)];
            let (cut, also) = (left.row(i) - factor * row, inverse.row(i) - factor * own);
            left.set_row(i, &cut);
            inverse.set_row(i, &also);
        }
        left.set_row(largest, &row);
        inverse.set_row(largest, &own);
    }
    Some((inverse, negative))
}

/// The eigenvector of the least eigenvalue, by shifted power iteration: 40
/// rounds give a direction good enough to leave a saddle along.
fn least_direction<const NU: usize>(matrix: SMatrix<f64, NU, NU>) -> Control<NU> {
    let shifted = SMatrix::<f64, NU, NU>::identity() * matrix.norm() - matrix;
    let mut direction = Control::<NU>::from_fn(|i, _| 1.0 + 0.1 * i as f64).normalize();
    for _ in 0..40 {
        let next = shifted * direction;
        let norm = next.norm();
        if norm <= 0.0 {
            break;
        }
        direction = next / norm;
    }
    direction
}

impl<const NX: usize, const NU: usize> Riccati<NX, NU> {
    /// Factors H + `shift` · I. Pivots must exceed `least_pivot`.
    pub fn factor(
        &mut self,
        stages: &[Stage<NX, NU>],
        hessian: &Hessian<NX, NU>,
        shift: f64,
        least_pivot: f64,
    ) -> Result<(), NotPositive> {
        self.factor_signed(stages, hessian, (shift, least_pivot), 0)
            .map(|_| ())
    }

    /// The same, where H may have up to `most` negative eigenvalues; returns how many
    /// it has.
    fn factor_signed(
        &mut self,
        stages: &[Stage<NX, NU>],
        hessian: &Hessian<NX, NU>,
        (shift, least_pivot): (f64, f64),
        most: usize,
    ) -> Result<usize, NotPositive> {
        self.updates.clear();
        let mut negative = 0;
        let n = stages.len();
        let empty = Factor {
            inverse: SMatrix::zeros(),
            gain: SMatrix::zeros(),
        };
        self.factors.resize(n, empty);
        self.feedforward.resize(n, SVector::zeros());
        let mut value = hessian.nodes[n];
        for k in (1..=n).rev() {
            let stage = &stages[k - 1];
            let block = &hessian.stages[k - 1];
            let value_by_state = value * stage.by_state;
            let mut uu = block.by_control + stage.by_control.tr_mul(&(value * stage.by_control));
            for i in 0..NU {
                uu[(i, i)] += shift;
            }
            let uz = block.mixed.transpose() + stage.by_control.tr_mul(&value_by_state);
            let zz = block.by_state + stage.by_state.tr_mul(&value_by_state);
            let found = if most == 0 {
                positive_inverse(uu, least_pivot).map(|inverse| (inverse, 0))
            } else {
                signed_inverse(uu, least_pivot).filter(|(_, count)| negative + count <= most)
            };
            let Some((inverse, count)) = found else {
                self.worst = least_direction(uu);
                return Err(NotPositive { stage: k });
            };
            negative += count;
            let gain = inverse * uz;
            value = hessian.nodes[k - 1] + zz - uz.tr_mul(&gain);
            self.factors[k - 1] = Factor { inverse, gain };
        }
        Ok(negative)
    }

    /// Factors H + `shift` · I stiffened by the sums of a point that `holds` names, by
    /// their places: by each only where it would be negative without, and no more than
    /// that takes.
    pub(super) fn factor_stiffened<C: Chain<NX, NU>>(
        &mut self,
        point: &Point<C, NX, NU>,
        hessian: &Hessian<NX, NU>,
        (shift, least_pivot): (f64, f64),
        holds: impl Fn(usize) -> bool,
    ) -> Result<(), NotPositive> {
        let held = (0..point.sums.len()).filter(|sum| holds(*sum)).count();
        let mut negative =
            self.factor_signed(&point.stages, hessian, (shift, least_pivot), held)?;
        for (sum, row) in point.sums.iter().enumerate() {
            if negative == 0 {
                break;
            }
            if !holds(sum) {
                continue;
            }
            let mut weights = vec![0.0; point.row_count()];
            weights[point.rows.len() + sum] = 1.0;
            let (mut du, mut dz) = (Vec::new(), Vec::new());
            self.solve(point, Source::Rows(&weights), &mut du, &mut dz);
            let curvature = row.change(&du);
            if curvature < 0.0 {
                // Turns cᵀH⁻¹c into its opposite.
                let stiffness = -2.0 / curvature;
                negative -= 1;
                self.updates.push(Update {
                    sum,
                    stiffness,
                    weight: -stiffness,
                    gradient: row.gradient.clone(),
                    du,
                    dz,
                });
            }
        }
        if negative == 0 {
            Ok(())
        } else {
            self.updates.clear();
            Err(NotPositive { stage: 1 })
        }
    }

    /// The sums that stiffen the factor.
    pub(super) fn updates(&self) -> &[Update<NX, NU>] {
        &self.updates
    }

    /// Q_uu⁻¹ and the gain K of a stage, from 1.
    pub(super) fn feedback(&self, k: usize) -> (SMatrix<f64, NU, NU>, SMatrix<f64, NU, NX>) {
        (self.factors[k - 1].inverse, self.factors[k - 1].gain)
    }

    /// du = H⁻¹ b with the states' perturbation dz that follows from it
    /// (`du`: n, `dz`: n + 1, both overwritten). Needs a factor of the same
    /// stages.
    pub fn solve<C: Chain<NX, NU>>(
        &mut self,
        point: &Point<C, NX, NU>,
        source: Source<'_>,
        du: &mut Vec<Control<NU>>,
        dz: &mut Vec<State<NX>>,
    ) {
        let stages = &point.stages;
        let n = stages.len();
        // The right-hand side, in controls and states.
        du.clear();
        dz.clear();
        dz.resize(n + 1, SVector::zeros());
        let weights = match source {
            Source::Rows(weights) => {
                du.resize(n, SVector::zeros());
                weights
            }
            Source::Step(weights) => {
                du.extend(stages.iter().map(|stage| -stage.cost_gradient));
                if C::COST_OF_STATE {
                    for (dz, stage) in dz.iter_mut().zip(stages) {
                        *dz -= stage.cost_by_state;
                    }
                }
                weights
            }
        };
        if C::SUM_ROWS {
            let weighed = point.sums.iter().zip(&weights[point.rows.len()..]);
            for (sum, &weight) in weighed.filter(|(_, weight)| **weight != 0.0) {
                for (du, term) in du.iter_mut().zip(&sum.gradient) {
                    *du += weight * term;
                }
            }
        }
        for (row, &weight) in point.rows.iter().zip(weights) {
            if weight != 0.0 {
                dz[row.stage] += weight * row.after;
                du[row.stage - 1] += weight * row.control;
                if let Some(before) = row.before {
                    dz[row.stage - 1] += weight * before;
                }
            }
        }
        let mut sum: State<NX> = dz[n];
        for k in (1..=n).rev() {
            let stage = &stages[k - 1];
            let factor = &self.factors[k - 1];
            let by_control = du[k - 1] + stage.by_control.tr_mul(&sum);
            self.feedforward[k - 1] = factor.inverse * by_control;
            sum = dz[k - 1] + stage.by_state.tr_mul(&sum) - factor.gain.tr_mul(&by_control);
        }
        self.forward(stages, n, du, dz);
        for update in &self.updates {
            let along: f64 = update
                .gradient
                .iter()
                .zip(&*du)
                .map(|(c, d)| c.dot(d))
                .sum();
            let share = update.weight * along;
            for (d, w) in du.iter_mut().zip(&update.du) {
                *d -= share * w;
            }
            for (d, w) in dz.iter_mut().zip(&update.dz) {
                *d -= share * w;
            }
        }
    }

    /// After [`Riccati::factor`] stopped at `stage`: a direction of negative
    /// curvature, the eigenvector of that stage's least pivot followed by the
    /// feedback of the stages beyond it.
    pub fn descend<C: Chain<NX, NU>>(
        &mut self,
        point: &Point<C, NX, NU>,
        stage: usize,
        du: &mut Vec<Control<NU>>,
        dz: &mut Vec<State<NX>>,
    ) {
        for k in 1..=stage {
            self.feedforward[k - 1] = SVector::zeros();
            self.factors[k - 1].gain = SMatrix::zeros();
        }
        self.feedforward[stage - 1] = self.worst;
        self.forward(&point.stages, stage, du, dz);
    }

    /// Rolls the perturbation out, with a feedforward up to stage `last`.
    fn forward(
        &self,
        stages: &[Stage<NX, NU>],
        last: usize,
        du: &mut Vec<Control<NU>>,
        dz: &mut Vec<State<NX>>,
    ) {
        du.clear();
        dz.clear();
        du.reserve(stages.len());
        dz.reserve(stages.len() + 1);
        let mut state: State<NX> = SVector::zeros();
        dz.push(state);
        for (k, (stage, factor)) in stages.iter().zip(&self.factors).enumerate() {
            let mut control = -(factor.gain * state);
            if k < last {
                control += self.feedforward[k];
            }
            state = stage.by_state * state + stage.by_control * control;
            du.push(control);
            dz.push(state);
        }
    }
}
