//! The line search: how far to go along the subproblem's step.

use super::{
    FIRST_SHIFT, OVERWEIGHT, Outcome, Progress, RELAXATIONS, ROUNDING, SHORT, SHORT_STEPS,
    SUFFICIENT, Sqp, Tunnelling, longest,
};
use crate::solver::chain::Chain;
use crate::solver::point::Point;

impl<C: Chain<NX, NU>, const NX: usize, const NU: usize> Sqp<C, NX, NU> {
    pub(super) fn place_trial(&mut self, amount: f64) {
        self.trial.controls.clear();
        let moved = self.point.controls.iter().zip(&self.set.du);
        self.trial
            .controls
            .extend(moved.map(|(u, d)| u + amount * d));
    }

    /// Σ L + μ Σ max(0, −g) at a point after a part of the step. A row that gives way
    /// has ½ε λ² for its cost and violates by what ελ leaves of it; its multiplier
    /// moves along with the step.
    pub(super) fn merit(&self, point: &Point<C, NX, NU>, amount: f64) -> f64 {
        let mut merit = point.cost + self.merit_penalty * point.total_violation();
        if C::SUM_ROWS {
            for (index, sum) in point.sums.iter().enumerate() {
                if sum.row.compliance > 0.0 {
                    let multiplier = self.multiplier_after(index, amount);
                    merit += 0.5 * sum.row.compliance * multiplier * multiplier;
                    merit += self.merit_penalty * sum.violation(multiplier).max(0.0);
                }
            }
        }
        merit
    }

    /// The multiplier of a summed row after a part of the step.
    fn multiplier_after(&self, sum: usize, amount: f64) -> f64 {
        let row = self.point.rows.len() + sum;
        let (before, after) = (self.multipliers[row], self.set.multipliers[row]);
        before + amount * (after - before)
    }

    /// Looks for an acceptable point along the subproblem's step.
    pub(super) fn search(&mut self, chain: &C) -> Progress {
        let most = self.set.multipliers.iter().fold(0.0_f64, |a, b| a.max(*b));
        // Never above ν: the subproblem gives way to a saturated row at that
        // price, and its step would not lower a merit that asks for more.
        let bound = self.penalty(chain);
        if self.merit_penalty > OVERWEIGHT * most && self.relaxations < RELAXATIONS {
            // The rows have given way: a weight far above the multipliers
            // would only make every step hug the rows' curvature.
            self.relaxations += 1;
            self.merit_penalty = 0.0;
        }
        self.merit_penalty = self.merit_penalty.max(1.5 * most).min(bound);
        let slope = self.slope();
        let start = self.merit(&self.point, 0.0);
        let size = self.point.cost.abs() + self.point.stages.len() as f64;
        let slack = ROUNDING * (size + self.merit_penalty * chain.row_scale());
        let longest = longest(&self.set.du);
        let mut amount = (chain.longest_step() / longest).min(1.0);
        let mut corrected = amount < 1.0;
        self.has_correction = false;
        let mut blocked = false;
        while amount * longest > 1e-14 || amount == 1.0 {
            self.place_trial(amount);
            self.trial.evaluate(chain);
            let merit = self.merit(&self.trial, amount);
            let enough = start + SUFFICIENT * amount * slope + slack;
            if merit.is_finite() && merit <= enough {
                if self.clear(chain) {
                    return self.take(amount, longest);
                }
                blocked = true;
            } else if !corrected && self.trial.cost.is_finite() {
                corrected = true;
                if self.correct(chain, enough) {
                    return self.take(amount, longest);
                }
            } else if self.has_correction {
                self.follow_arc(chain, amount);
                let merit = self.merit(&self.trial, amount);
                if merit.is_finite() && merit <= enough {
                    if self.clear(chain) {
                        return self.take(amount, longest);
                    }
                    blocked = true;
                }
            }
            amount *= 0.5;
        }
        self.retry_or_stall(blocked)
    }

    /// The merit's slope along the full step, negative unless stationary.
    pub(super) fn slope(&self) -> f64 {
        let gradient = self.point.stages.iter().zip(&self.set.du);
        let cost: f64 = gradient.map(|(s, d)| s.cost_gradient.dot(d)).sum();
        let mut violation = 0.0;
        for row in &self.point.rows {
            let after = row.value + row.change(&self.set.du, &self.set.dz);
            violation += (-after).max(0.0) - (-row.value).max(0.0);
        }
        let mut slope = cost + self.merit_penalty * violation;
        if C::COST_OF_STATE {
            let stages = self.point.stages.iter().zip(&self.set.dz);
            slope += stages.map(|(s, d)| s.cost_by_state.dot(d)).sum::<f64>();
        }
        if C::SUM_ROWS {
            for (index, sum) in self.point.sums.iter().enumerate() {
                let [before, after] = [0.0, 1.0].map(|at| self.multiplier_after(index, at));
                let compliance = sum.row.compliance;
                slope += compliance * before * (after - before);
                let left = sum.violation(after) - sum.change(&self.set.du);
                let change = left.max(0.0) - sum.violation(before).max(0.0);
                slope += self.merit_penalty * change;
            }
        }
        slope.min(0.0)
    }

    pub(super) fn clear(&self, chain: &C) -> bool {
        self.settings.tunnelling == Tunnelling::Allowed
            || !chain.passes_through(&self.point.nodes, &self.trial.nodes)
    }

    /// Tries the full step with its second-order correction, from the rows'
    /// values after the full step; leaves the uncorrected step otherwise, and
    /// keeps the correction for shorter ones.
    pub(super) fn correct(&mut self, chain: &C, enough: f64) -> bool {
        self.correction.clear();
        self.correction.extend_from_slice(&self.set.du);
        let after = &self.trial.rows;
        let before = &self.point.rows;
        let sums = &self.trial.sums;
        self.set
            .correct(&mut self.riccati, &self.point, |row, multiplier| {
                let Some(id) = before.get(row).map(|row| row.id) else {
                    let sum = &sums[row - before.len()];
                    return -sum.violation(multiplier);
                };
                after
                    .binary_search_by_key(&id, |row| row.id)
                    .map_or(0.0, |found| after[found].value)
            });
        self.place_trial(1.0);
        self.trial.evaluate(chain);
        let merit = self.merit(&self.trial, 1.0);
        if merit.is_finite() && merit <= enough && self.clear(chain) {
            return true;
        }
        for (by, corrected) in self.correction.iter_mut().zip(&self.set.du) {
            *by = corrected - *by;
        }
        self.has_correction = true;
        self.set.uncorrect(&mut self.riccati, &self.point);
        false
    }

    /// Bends the trial, a part of the straight step, along an arc: the
    /// correction belongs to the full step and grows with the square of the part
    /// (Mayne and Polak, 1982). Along the straight step a slide along a strongly
    /// curved row would be let go only as far as the row is flat.
    fn follow_arc(&mut self, chain: &C, amount: f64) {
        let square = amount * amount;
        for (moved, by) in self.trial.controls.iter_mut().zip(&self.correction) {
            *moved += square * by;
        }
        self.trial.evaluate(chain);
    }

    /// Makes the trial, a part of the subproblem's step, the point. Where only
    /// small parts are accepted again and again the step runs into a row that
    /// comes and goes, and each would be half of the one before; a shifted
    /// Hessian turns it aside.
    pub(super) fn take(&mut self, amount: f64, longest: f64) -> Progress {
        if let Some(last) = self.trace.last_mut() {
            last.step = amount * longest;
            self.short = if amount < SHORT { self.short + 1 } else { 0 };
            if self.short == SHORT_STEPS {
                self.short = 0;
                self.shift = self.shift.max(FIRST_SHIFT);
            }
        }
        if C::SUM_ROWS {
            for index in 0..self.point.sums.len() {
                if self.point.sums[index].row.compliance > 0.0 {
                    let row = self.point.rows.len() + index;
                    self.set.multipliers[row] = self.multiplier_after(index, amount);
                }
            }
        }
        std::mem::swap(&mut self.multipliers, &mut self.set.multipliers);
        self.name_multipliers();
        self.accept();
        Progress::Running
    }

    pub(super) fn accept(&mut self) {
        std::mem::swap(&mut self.point, &mut self.trial);
        self.recall_multipliers();
    }

    /// No step was acceptable: a shifted Hessian gets one more chance.
    pub(super) fn retry_or_stall(&mut self, blocked: bool) -> Progress {
        if let Some(last) = self.trace.last()
            && last.shift < 1e6
        {
            self.shift = (100.0 * last.shift).max(FIRST_SHIFT);
            return Progress::Running;
        }
        self.end(if blocked {
            Outcome::Blocked
        } else {
            Outcome::Stalled
        })
    }
}
