//! What is certified of a shape, whatever mechanics it belongs to and whoever
//! recomputed it: conditions by name, each with its value.

mod wire;

use super::condition::{Condition, ConditionKind};
use crate::math::greatest;

/// How many conditions a certificate has room for.
const CAPACITY: usize = 12;

/// How well a shape satisfies the conditions of an equilibrium: for the
/// four-bar robot those of eq. 5's optimality. Without conditions, as where
/// nothing has been certified yet, it does not hold.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Certificate {
    /// Those that are certified first; the others are filled alike, so that
    /// equal certificates compare equal.
    values: [(Condition, f64); CAPACITY],
    count: usize,
    /// dJ*/dl, in rad²/m, from the cable links' multipliers: how the least
    /// energy changes with the pull (envelope theorem).
    pub energy_slope: f64,
}

impl Default for Certificate {
    fn default() -> Self {
        Self {
            values: [(Condition::Stationarity, 0.0); CAPACITY],
            count: 0,
            energy_slope: 0.0,
        }
    }
}

impl Certificate {
    /// Sets the value of a condition, which comes last where it has none yet:
    /// a number for a residual, a `bool` for what is met or not.
    ///
    /// # Panics
    /// Where there are more conditions than a certificate has room for, or the
    /// value of what is met or not is neither 1 nor 0.
    pub fn set(&mut self, condition: Condition, value: impl Into<f64>) {
        let value = value.into();
        let taken = self.try_set(condition, value);
        assert!(taken, "{condition:?} cannot be {value}, or is too many");
    }

    /// The same; whether the value can be one of the condition and has room.
    fn try_set(&mut self, condition: Condition, value: f64) -> bool {
        let is_answer = value == 1.0 || value == 0.0;
        let is_known = |(it, _): (Condition, f64)| it == condition;
        let place = self.conditions().position(is_known).unwrap_or(self.count);
        let fits = place < CAPACITY && (condition.kind() == ConditionKind::Residual || is_answer);
        if fits {
            self.values[place] = (condition, value);
            self.count = self.count.max(place + 1);
        }
        fits
    }

    /// The conditions with their values, in the order in which they are shown
    /// and written.
    pub fn conditions(&self) -> impl DoubleEndedIterator<Item = (Condition, f64)> + '_ {
        self.values[..self.count].iter().copied()
    }

    /// The value of a condition, where it was certified.
    pub fn get(&self, condition: Condition) -> Option<f64> {
        let mut all = self.conditions();
        all.find_map(|(it, value)| (it == condition).then_some(value))
    }

    /// The greatest of the residuals; NaN where one is.
    pub fn residual(&self) -> f64 {
        let residuals = self
            .conditions()
            .filter(|(condition, _)| condition.kind() == ConditionKind::Residual);
        let values = residuals.map(|(_, value)| value);
        values.reduce(greatest).unwrap_or(0.0)
    }

    /// Whether the shape is an equilibrium that a robot can rest in.
    pub fn holds(&self) -> bool {
        self.count > 0
            && self
                .conditions()
                .all(|(condition, value)| condition.is_met(value))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_certificate_without_conditions_does_not_hold() {
        let mut certificate = Certificate::default();
        assert!(!certificate.holds());
        certificate.set(Condition::Links, 1e-10);
        assert!(certificate.holds());
        certificate.set(Condition::Minimum, true);
        assert!(certificate.holds());
    }

    #[test]
    fn each_condition_counts_and_a_later_value_replaces_an_earlier_one() {
        let mut certificate = Certificate::default();
        certificate.set(Condition::Links, 1e-10);
        certificate.set(Condition::Dual, 1e-12);
        certificate.set(Condition::Minimum, true);
        for (condition, wrong) in [
            (Condition::Links, 1.1e-9),
            (Condition::Dual, f64::NAN),
            (Condition::Minimum, 0.0),
        ] {
            let mut broken = certificate;
            broken.set(condition, wrong);
            assert!(!broken.holds());
            let told = broken.get(condition).unwrap();
            assert!(told == wrong || told.is_nan());
            broken.set(condition, certificate.get(condition).unwrap());
            assert_eq!(broken, certificate);
        }
        assert_eq!(certificate.residual(), 1e-10);
        assert_eq!(certificate.get(Condition::Orientation), None);
        assert!(!certificate.try_set(Condition::Minimum, 0.5));
    }
}
