//! The record of a certificate: its conditions under their own keys.

use serde::ser::{Serialize, SerializeMap, Serializer};

use crate::mechanics::{self, Condition, ConditionKind};

/// The conditions of an equilibrium; see [`crate::mechanics::Certificate`]. In
/// JSON what is left of each, without unit, then the greatest of that, and what
/// is met or not.
pub struct Certificate {
    /// Each with its value.
    pub conditions: Vec<(Condition, f64)>,
    /// The greatest of the residuals.
    pub residual: f64,
    /// Whether all of it holds.
    pub holds: bool,
}

impl Certificate {
    pub(super) fn of(certificate: &mechanics::Certificate) -> Self {
        Self {
            conditions: certificate.conditions().collect(),
            residual: certificate.residual(),
            holds: certificate.holds(),
        }
    }

    /// All its numbers.
    pub(super) fn numbers(&self) -> impl Iterator<Item = f64> + '_ {
        let values = self.conditions.iter().map(|(_, value)| *value);
        values.chain([self.residual])
    }
}

impl Serialize for Certificate {
    fn serialize<S: Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
        let mut map = to.serialize_map(None)?;
        for (condition, value) in &self.conditions {
            if condition.kind() == ConditionKind::Residual {
                map.serialize_entry(condition.key(), value)?;
            }
        }
        map.serialize_entry("residual", &self.residual)?;
        for (condition, value) in &self.conditions {
            if let ConditionKind::YesOrNo(_) = condition.kind() {
                map.serialize_entry(condition.key(), &condition.is_met(*value))?;
            }
        }
        map.serialize_entry("holds", &self.holds)?;
        map.end()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::equilibrium::{Settings, Start, solve};
    use crate::mechanics::Problem;
    use crate::scene::Scene;

    #[test]
    fn keys_keep_their_order_and_answers_are_yes_or_no() {
        let text = include_str!("../../assets/scenes/one-disc.toml");
        let problem = Problem::new(&Scene::from_toml(text).unwrap()).unwrap();
        let solution = solve(&problem, Start::Straight, Settings::default());
        let record = Certificate::of(&solution.certificate);
        let json = serde_json::to_string(&record).unwrap();
        let places: Vec<usize> = [
            "{\"stationarity\":",
            ",\"links\":",
            ",\"penetration\":",
            ",\"complementarity\":",
            ",\"dual\":",
            ",\"residual\":",
            ",\"orientation\":true,\"minimum\":true,\"holds\":true}",
        ]
        .into_iter()
        .map(|key| json.find(key).unwrap())
        .collect();
        assert!(places.is_sorted(), "{json}");
        assert_eq!(json.matches(':').count(), 9, "{json}");
    }
}
