//! A positive definite Hessian for the subproblem, and the way off a saddle.

use super::{LEAST_PIVOT, LEAST_SHIFT, MORE_SHIFT, NUDGE, STIFFNESSES, Sqp, held, longest};
use crate::solver::chain::Chain;
use crate::solver::riccati::NotPositive;

impl<C: Chain<NX, NU>, const NX: usize, const NU: usize> Sqp<C, NX, NU> {
    /// Factors the Hessian, stiffened by the active rows if that is what it
    /// takes; returns the stiffness, and whether that was enough.
    pub(super) fn factor_exact(&mut self, chain: &C) -> (f64, Result<(), NotPositive>) {
        let mut outcome = self.try_held(0.0);
        let mut before = 0.0;
        let bound = self.penalty(chain);
        // The curvature to outweigh is that of λ ∇²g.
        let most = self.multipliers.iter().fold(0.0_f64, |a, b| a.max(*b));
        let weight = (most * chain.row_scale()).max(1.0);
        let rows = self.point.rows.iter().zip(&self.multipliers);
        if outcome.is_err() && rows.into_iter().any(|(_, m)| held(*m, bound)) {
            for stiffness in STIFFNESSES {
                if outcome.is_ok() {
                    break;
                }
                let stiffness = stiffness * weight / (chain.row_scale() * chain.row_scale());
                for (row, &multiplier) in self.point.rows.iter().zip(&self.multipliers) {
                    if held(multiplier, bound) {
                        self.hessian.stiffen(&self.point, row, stiffness - before);
                    }
                }
                before = stiffness;
                outcome = self.try_held(0.0);
            }
        }
        (before, outcome)
    }

    /// Factors the Hessian with a shift or, where that is not positive, stiffened by the
    /// summed rows in the set too.
    fn try_held(&mut self, shift: f64) -> Result<(), NotPositive> {
        let outcome = self.try_factor(shift);
        if !C::SUM_ROWS || outcome.is_ok() {
            return outcome;
        }
        let summed = &self.multipliers[self.point.rows.len()..];
        let is_held = |sum: usize| summed[sum] > 0.0;
        if !summed.iter().any(|multiplier| *multiplier > 0.0) {
            return outcome;
        }
        let (point, hessian) = (&self.point, &self.hessian);
        let held = self
            .riccati
            .factor_stiffened(point, hessian, (shift, LEAST_PIVOT), is_held);
        if held.is_err() {
            // Where it stopped is where the way down is.
            return self.try_factor(shift);
        }
        held
    }

    pub(super) fn try_factor(&mut self, shift: f64) -> Result<(), NotPositive> {
        self.riccati
            .factor(&self.point.stages, &self.hessian, shift, LEAST_PIVOT)
    }

    /// Factors the Hessian, made positive by whatever it takes; returns the
    /// stiffness in it.
    pub(super) fn factor(&mut self, chain: &C) -> f64 {
        self.hessian.assemble(chain, &self.point, &self.multipliers);
        let (stiffness, outcome) = self.factor_exact(chain);
        // After a stall the shift stays for one iteration.
        self.exact = outcome.is_ok() && self.shift == 0.0;
        if self.exact {
            return stiffness;
        }
        // The stiffness stays: without it the shift would have to outweigh
        // the curvature across the held rows too, and slow down the slide along
        // them that leads away from a fold.
        let mut shift = self.shift.max(LEAST_SHIFT);
        while self.try_held(shift).is_err() && shift < 1e15 {
            shift *= MORE_SHIFT;
        }
        if let Some(last) = self.trace.last_mut() {
            last.shift = shift;
        }
        self.shift = 0.0;
        stiffness
    }

    /// Leaves a saddle along the direction of negative curvature that the
    /// stage's pivot shows, to the side with the lower merit.
    pub(super) fn nudge(&mut self, chain: &C, stage: usize) {
        self.riccati
            .descend(&self.point, stage, &mut self.set.du, &mut self.set.dz);
        let longest = longest(&self.set.du);
        let mut best: Option<(f64, f64)> = None;
        for amount in [NUDGE / longest, -NUDGE / longest] {
            self.place_trial(amount);
            self.trial.evaluate(chain);
            let merit = self.trial.cost + self.penalty(chain) * self.trial.total_violation();
            if merit.is_finite() && best.is_none_or(|(lowest, _)| merit < lowest) {
                best = Some((merit, amount));
            }
        }
        if let Some((_, amount)) = best {
            self.place_trial(amount);
            self.trial.evaluate(chain);
            self.name_multipliers();
            self.accept();
        }
        self.merit_penalty = 0.0;
    }
}
