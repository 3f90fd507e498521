//! How large forces are drawn: what arrows, glow and colours measure by, in round
//! numbers of the unit that they are written in, so that one picture can be compared
//! with the next.

use super::quantity::{Quantity, one_two_five};
use crate::contact::Contact;
use crate::forces::Stiffness;
use crate::mechanics::Problem;
use crate::units::{RAD2_PER_MM, grams, per_millimetre};

/// Length of the arrow at the end of the scale, over the backbone's length.
const ARROW: f64 = 0.22;
/// The end of the finest scale, over EI/L²: a tenth of a gram on a robot of 180 mm
/// with an EI of 8000 N mm². What is far less is next to nothing.
const FINEST: f64 = 0.0039;

/// What multipliers are written as.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Written {
    /// λ, per millimetre.
    Multiplier,
    /// Forces in grams, of so many newtons for a multiplier of 1 rad²/m.
    Force(f64),
}

/// A scale of forces.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ForceScale {
    written: Written,
    /// Its end, in the unit that is written.
    end: f64,
    /// Length of an arrow at its end, in metres.
    arrow: f64,
}

/// An arrow of the legend.
#[derive(Clone, Debug, PartialEq)]
pub struct Key {
    /// Its length, in metres.
    pub length: f64,
    /// Its share of the scale.
    pub share: f64,
    /// The force that it stands for.
    pub value: Quantity,
}

impl ForceScale {
    /// The finest scale in round numbers that shows a multiplier, in rad²/m, of a
    /// robot of a stiffness, if that is known.
    pub fn above(problem: &Problem, stiffness: Option<Stiffness>, most: f64) -> Self {
        let scale = Self::ending(problem, stiffness, 1.0);
        // EI/L² as a multiplier is free of EI.
        let length = problem.length();
        let finest = FINEST * 2.0 * problem.robot().segment_length() / (length * length);
        let most = scale.per_multiplier() * most.max(finest);
        let below = one_two_five(most);
        let end = if below >= most * (1.0 - 1e-9) {
            below
        } else {
            // The next step is at most two and a half times as far.
            one_two_five(2.5 * below)
        };
        Self { end, ..scale }
    }

    /// A scale that ends at a value in the unit that is written, over zero.
    pub fn ending(problem: &Problem, stiffness: Option<Stiffness>, end: f64) -> Self {
        let force = stiffness.map(|it| Written::Force(it.per_bend(problem)));
        Self {
            written: force.unwrap_or(Written::Multiplier),
            end,
            arrow: ARROW * problem.length(),
        }
    }

    /// What a multiplier of 1 rad²/m is in the unit that is written.
    fn per_multiplier(&self) -> f64 {
        match self.written {
            Written::Multiplier => per_millimetre(1.0),
            Written::Force(per_bend) => grams(per_bend),
        }
    }

    fn unit(&self) -> &'static str {
        match self.written {
            Written::Multiplier => RAD2_PER_MM,
            Written::Force(_) => "g",
        }
    }

    /// What the scale is of, such as `contact force`.
    pub fn what(&self) -> &'static str {
        match self.written {
            Written::Multiplier => "contact multiplier",
            Written::Force(_) => "contact force",
        }
    }

    /// The end, in the unit that is written: g or, where the stiffness is not known,
    /// rad²/mm.
    pub fn end(&self) -> f64 {
        self.end
    }

    /// The end as it is written.
    pub fn end_written(&self) -> Quantity {
        Quantity::round(self.end, self.unit())
    }

    /// A multiplier, in rad²/m, as it is written.
    pub fn written(&self, multiplier: f64) -> Quantity {
        Quantity::significant(self.per_multiplier() * multiplier, self.unit())
    }

    /// A multiplier's share of the scale, from 0 to 1; 1 beyond its end.
    pub fn share(&self, multiplier: f64) -> f64 {
        (self.per_multiplier() * multiplier / self.end).clamp(0.0, 1.0)
    }

    /// Whether a multiplier, in rad²/m, is not beyond the end.
    pub fn holds(&self, multiplier: f64) -> bool {
        self.per_multiplier() * multiplier <= self.end * (1.0 + 1e-9)
    }

    /// The share of a contact.
    pub fn of(&self, contact: &Contact) -> f64 {
        self.share(contact.multiplier)
    }

    /// Length of the arrow of a share, in metres.
    pub fn arrow(&self, share: f64) -> f64 {
        self.arrow * share
    }

    /// Length of the arrow of a multiplier, in rad²/m, in metres: beyond the end, too.
    pub fn length(&self, multiplier: f64) -> f64 {
        self.arrow * self.per_multiplier() * multiplier / self.end
    }

    /// The longest arrow of a round force that is no longer than a limit, in metres.
    pub fn key(&self, limit: f64) -> Key {
        let value = one_two_five((limit / self.arrow).min(1.0) * self.end);
        let share = value / self.end;
        Key {
            length: self.arrow(share),
            share,
            value: Quantity::round(value, self.unit()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::Scene;
    use crate::units::newtons;

    fn robot() -> (Problem, Option<Stiffness>) {
        let text = include_str!("../../assets/scenes/two-posts.toml");
        let scene = Scene::from_toml(text).unwrap();
        let stiffness = Stiffness::of_scene(&scene).unwrap();
        (Problem::new(&scene).unwrap(), stiffness)
    }

    #[test]
    fn a_scale_ends_at_the_next_round_number() {
        let (problem, stiffness) = robot();
        let per_bend = stiffness.unwrap().per_bend(&problem);
        for (grams, end) in [
            (0.0, 0.1),
            (0.11, 0.2),
            (9.9, 10.0),
            (10.0, 10.0),
            (10.1, 20.0),
            (21.0, 50.0),
            (51.0, 100.0),
            (12_000.0, 20_000.0),
        ] {
            let scale = ForceScale::above(&problem, stiffness, newtons(grams) / per_bend);
            assert!((scale.end() - end).abs() < 1e-9 * end, "{grams}: {scale:?}");
            let share = scale.share(newtons(grams) / per_bend);
            assert!((share - grams / end).abs() < 1e-9, "{share}");
        }
        // 5e-5 g next to 12 kg, and by itself: nothing.
        let tiny = newtons(5e-5) / per_bend;
        assert!(ForceScale::above(&problem, stiffness, tiny).share(tiny) < 1e-3);
    }

    #[test]
    fn the_legends_arrow_is_true_to_scale() {
        let (problem, stiffness) = robot();
        let scale = ForceScale::ending(&problem, stiffness, 500.0);
        let key = scale.key(0.025);
        assert_eq!(key.value.text(), "200 g");
        assert!(key.length <= 0.025);
        assert!((key.length - scale.arrow(0.4)).abs() < 1e-12);
        assert_eq!(scale.key(1.0).value.text(), "500 g");
    }
}
