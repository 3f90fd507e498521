//! A value of a scene that a study varies: its key, its values, its scale.

use super::sampler::Position;
use crate::scene::is_count;

/// A parameter.
#[derive(Clone, Debug, PartialEq)]
pub struct Parameter {
    /// The key of the scene, as messages print it.
    pub key: String,
    /// What it takes.
    pub values: Values,
    /// Parameters of one name go together; others with each other.
    pub name: Option<String>,
}

/// The values that a parameter takes, in the unit of its key.
#[derive(Clone, Debug, PartialEq)]
pub enum Values {
    /// These, in this order.
    List(Vec<f64>),
    /// A range.
    Range {
        /// One end.
        from: f64,
        /// The other.
        to: f64,
        /// Values of it, both ends among them, where samples are taken on a grid.
        steps: Option<u64>,
        /// How they lie in it.
        scale: Scale,
    },
}

/// How values lie in a range.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scale {
    /// At equal differences.
    Linear,
    /// At equal ratios; both ends are above zero.
    Log,
}

impl Values {
    /// How many there are on a grid; `None` of a range without steps.
    pub(super) fn count(&self) -> Option<u64> {
        match self {
            Values::List(values) => Some(values.len() as u64),
            Values::Range { steps, .. } => *steps,
        }
    }

    /// The least and the greatest of them.
    pub fn ends(&self) -> (f64, f64) {
        match self {
            Values::List(values) => values
                .iter()
                .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| {
                    (low.min(*value), high.max(*value))
                }),
            Values::Range { from, to, .. } => (*from, *to),
        }
    }

    fn at(&self, position: Position) -> f64 {
        match (self, position) {
            (Values::List(values), Position::Step(step)) => values[step as usize],
            (Values::List(values), Position::Share(share)) => {
                let place = (share * values.len() as f64) as usize;
                values[place.min(values.len() - 1)]
            }
            (
                Values::Range {
                    from,
                    to,
                    steps,
                    scale,
                },
                position,
            ) => {
                let share = match position {
                    Position::Share(share) => share,
                    Position::Step(step) => {
                        step as f64 / (steps.unwrap_or(1).saturating_sub(1)).max(1) as f64
                    }
                };
                scale.between(*from, *to, share)
            }
        }
    }
}

impl Scale {
    /// The value a share of the way from one end to the other, which are met exactly.
    fn between(self, from: f64, to: f64, share: f64) -> f64 {
        let mix = |from: f64, to: f64| (1.0 - share) * from + share * to;
        let value = match self {
            _ if share <= 0.0 => from,
            _ if share >= 1.0 => to,
            Scale::Linear => mix(from, to),
            Scale::Log => libm::exp(mix(libm::log(from), libm::log(to))),
        };
        value.clamp(from.min(to), from.max(to))
    }
}

impl Parameter {
    /// Its value at a place of its axis. Where its key counts something that is the
    /// nearest whole number; other values are taken to twelve digits, so that files and
    /// people write them as 7.6 and not as 7.6000000000000005.
    pub(super) fn value(&self, position: Position) -> f64 {
        let value = self.values.at(position);
        if is_count(&self.key) {
            return libm::round(value);
        }
        match self.values {
            Values::List(_) => value,
            Values::Range { .. } => format!("{value:.11e}").parse().unwrap_or(value),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn parameter(key: &str, from: f64, to: f64, steps: u64, scale: Scale) -> Parameter {
        Parameter {
            key: key.to_owned(),
            values: Values::Range {
                from,
                to,
                steps: Some(steps),
                scale,
            },
            name: None,
        }
    }

    fn check(parameter: &Parameter, expected: &[f64]) {
        let steps = parameter.values.count().unwrap();
        let found: Vec<f64> = (0..steps)
            .map(|i| parameter.value(Position::Step(i)))
            .collect();
        assert_eq!(found, expected);
    }

    #[test]
    fn steps_lie_at_equal_differences_or_ratios_and_meet_the_ends() {
        let key = "actuation.pull_mm";
        let linear = parameter(key, 0.0, 1.0, 6, Scale::Linear);
        check(&linear, &[0.0, 0.2, 0.4, 0.6, 0.8, 1.0]);
        check(
            &parameter(key, 1.0, 1000.0, 4, Scale::Log),
            &[1.0, 10.0, 100.0, 1000.0],
        );
        check(&parameter(key, 4.0, 4.0, 1, Scale::Linear), &[4.0]);
    }

    #[test]
    fn what_counts_is_whole() {
        check(
            &parameter("robot.disks", 4.0, 6.0, 5, Scale::Linear),
            &[4.0, 5.0, 5.0, 6.0, 6.0],
        );
    }

    #[test]
    fn a_share_of_a_list_is_one_of_it() {
        let values = Values::List(vec![1.0, 5.0, 9.0]);
        let at = |share| values.at(Position::Share(share));
        assert_eq!(
            [0.0, 0.33, 0.34, 0.67, 0.999_999].map(at),
            [1.0, 1.0, 5.0, 9.0, 9.0]
        );
    }
}
