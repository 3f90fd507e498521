//! Numbers as people type them: with a decimal comma, with a unit, to be reckoned
//! out, or not a number at all. Knows no field and no range.

use std::fmt;

/// What a field asks for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// A length; without a unit, millimetres.
    Length,
    /// An angle; without a unit, degrees.
    Angle,
    /// A whole number.
    Count,
    /// A number whose unit is fixed.
    Plain,
}

/// Why a text is not what a field asks for.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Typo {
    /// There is nothing.
    Empty(Kind),
    /// There is no number, or more than one.
    NoNumber(Kind, String),
    /// There is a number, and then something that is no unit of it.
    NoUnit(Kind, String),
    /// There is a number that no arithmetic survives.
    TooLarge(String),
    /// There is a number that is not whole.
    NotWhole(String),
}

/// A unit: how it is written, and what turns a number of it into one of the
/// field's.
struct Unit {
    sign: &'static str,
    scale: Scale,
}

enum Scale {
    /// Times ten to a power, exact to the last digit.
    Power(i32),
    Radians,
}

const fn power(sign: &'static str, power: i32) -> Unit {
    Unit {
        sign,
        scale: Scale::Power(power),
    }
}

/// Longer signs first: a number of mm also ends in m.
const LENGTHS: &[Unit] = &[
    power("mm", 0),
    power("cm", 1),
    power("µm", -3),
    power("um", -3),
    power("m", 3),
];
const ANGLES: &[Unit] = &[
    power("°", 0),
    power("degrees", 0),
    power("deg", 0),
    Unit {
        sign: "rad",
        scale: Scale::Radians,
    },
];

impl Kind {
    fn units(self) -> &'static [Unit] {
        match self {
            Kind::Length => LENGTHS,
            Kind::Angle => ANGLES,
            Kind::Count | Kind::Plain => &[],
        }
    }

    /// The number that a text means: in mm, in degrees, or a count.
    ///
    /// # Errors
    /// When it means none that is finite.
    pub fn parse(self, text: &str) -> Result<f64, Typo> {
        let text = text.trim();
        if text.is_empty() {
            return Err(Typo::Empty(self));
        }
        let unit = self.units().iter().find(|unit| text.ends_with(unit.sign));
        let digits = unit.map_or(text, |unit| text[..text.len() - unit.sign.len()].trim_end());
        let worked_out = || {
            let value = reckoned(digits)?;
            Decimal::of(&value.to_string())
        };
        let Some(decimal) = Decimal::of(digits).or_else(worked_out) else {
            // A number with something behind it is another slip than no number.
            let end = digits.find(|c: char| c.is_alphabetic() && c != 'e' && c != 'E');
            let (number, rest) = digits.split_at(end.unwrap_or(digits.len()));
            return Err(match Decimal::of(number.trim_end()) {
                Some(_) if unit.is_none() => Typo::NoUnit(self, rest.trim().to_owned()),
                _ => Typo::NoNumber(self, text.to_owned()),
            });
        };
        let value = match unit.map(|unit| &unit.scale) {
            None => decimal.times_power(0),
            Some(Scale::Power(power)) => decimal.times_power(*power),
            Some(Scale::Radians) => crate::units::degrees(decimal.times_power(0)),
        };
        if !value.is_finite() {
            return Err(Typo::TooLarge(text.to_owned()));
        }
        if self == Kind::Count && value.fract() != 0.0 {
            return Err(Typo::NotWhole(text.to_owned()));
        }
        Ok(value)
    }
}

/// What a sum of products comes to, such as `180/9 + 2*6`; `None` where a text is none.
fn reckoned(text: &str) -> Option<f64> {
    let text = text.replace(['−', '–'], "-").replace(['×', '·'], "*");
    // A sign behind a number joins two terms.
    let mut terms = vec![(1.0, String::new())];
    for c in text.chars() {
        let before = terms
            .last()
            .and_then(|(_, term)| term.trim_end().chars().last());
        let joins = before.is_some_and(|c| c.is_ascii_digit() || c == '.' || c == ',');
        match (c, terms.last_mut()) {
            ('+', _) if joins => terms.push((1.0, String::new())),
            ('-', _) if joins => terms.push((-1.0, String::new())),
            (c, Some((_, term))) => term.push(c),
            (_, None) => {}
        }
    }
    let values = terms.iter().map(|(sign, term)| Some(sign * product(term)?));
    let value: f64 = values.sum::<Option<f64>>()?;
    value.is_finite().then_some(value)
}

/// What factors and divisors come to, from left to right.
fn product(term: &str) -> Option<f64> {
    let number = |text: &str| Some(Decimal::of(text.trim())?.times_power(0));
    let mut value = None;
    let mut rest = term;
    let mut divides = false;
    loop {
        let end = rest.find(['*', '/']);
        let factor = number(&rest[..end.unwrap_or(rest.len())])?;
        value = Some(match (value, divides) {
            (None, _) => factor,
            (Some(value), false) => value * factor,
            (Some(value), true) => value / factor,
        });
        let Some(end) = end else {
            return value;
        };
        divides = rest[end..].starts_with('/');
        rest = &rest[end + 1..];
    }
}

/// A decimal number as text, apart from its power of ten.
struct Decimal {
    mantissa: String,
    power: i32,
}

impl Decimal {
    fn of(text: &str) -> Option<Self> {
        let text = text.replace(['−', '–'], "-");
        let commas = text.matches(',').count();
        if commas > 1 || (commas == 1 && text.contains('.')) {
            // Which of them is the decimal one is anybody's guess.
            return None;
        }
        let text = text.replace(',', ".");
        // `inf` and `nan` are numbers to the standard parser.
        let ordinary = |c: char| c.is_ascii_digit() || "+-.eE".contains(c);
        if !text.chars().all(ordinary) || text.parse::<f64>().is_err() {
            return None;
        }
        let (mantissa, power) = text.split_once(['e', 'E']).unwrap_or((&text, "0"));
        // A power that does not even fit an i32 is as good as the greatest.
        let limit = if power.starts_with('-') { -9999 } else { 9999 };
        Some(Self {
            mantissa: mantissa.to_owned(),
            power: power.parse().unwrap_or(limit),
        })
    }

    /// The number times a power of ten, correctly rounded.
    fn times_power(&self, power: i32) -> f64 {
        let Self {
            mantissa,
            power: own,
        } = self;
        let text = format!("{mantissa}e{}", own.saturating_add(power));
        text.parse().unwrap_or(f64::NAN)
    }
}

impl fmt::Display for Typo {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let example = |kind: &Kind| match kind {
            Kind::Length => "such as 12.5 or 1.2 cm",
            Kind::Angle => "such as 30 or 0.5 rad",
            Kind::Count => "such as 18",
            Kind::Plain => "such as 12.5",
        };
        match self {
            Typo::Empty(kind) => write!(f, "Type a number, {}.", example(kind)),
            Typo::NoNumber(kind, text) => {
                write!(f, "“{text}” is no number; type one, {}.", example(kind))
            }
            Typo::NoUnit(kind, text) => {
                let units = match kind {
                    Kind::Length => "use mm, cm, m or µm",
                    Kind::Angle => "use ° or rad",
                    Kind::Count | Kind::Plain => "type the number alone",
                };
                write!(f, "“{text}” is no unit here; {units}.")
            }
            Typo::TooLarge(text) => write!(f, "{text} is too large to compute with."),
            Typo::NotWhole(text) => write!(f, "{text} is not a whole number."),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lengths_and_angles_come_with_and_without_units() {
        let check = |kind: Kind, text, expect| assert_eq!(kind.parse(text), Ok(expect), "{text}");
        check(Kind::Length, "12.5", 12.5);
        check(Kind::Length, " 12,5 ", 12.5);
        check(Kind::Length, "10 mm", 10.0);
        check(Kind::Length, "1.2 cm", 12.0);
        check(Kind::Length, "0.1m", 100.0);
        check(Kind::Length, "0.3 m", 300.0);
        check(Kind::Length, "250 µm", 0.25);
        check(Kind::Length, "−4.9", -4.9);
        check(Kind::Length, "+1e-2 m", 10.0);
        check(Kind::Length, ".5", 0.5);
        check(Kind::Angle, "30", 30.0);
        check(Kind::Angle, "-5°", -5.0);
        check(Kind::Angle, "90 deg", 90.0);
        check(Kind::Angle, "0.5 rad", 0.5_f64.to_degrees());
        check(Kind::Count, "18", 18.0);
        check(Kind::Count, "1e3", 1000.0);
    }

    #[test]
    fn sums_and_products_are_reckoned_out() {
        let check = |kind: Kind, text, expect| assert_eq!(kind.parse(text), Ok(expect), "{text}");
        check(Kind::Length, "2*6", 12.0);
        check(Kind::Length, "180 / 9", 20.0);
        check(Kind::Length, "1,5 × 2 cm", 30.0);
        check(Kind::Length, "10 + 2*6 − 3", 19.0);
        check(Kind::Length, "-4+1e-1*10", -3.0);
        check(Kind::Length, "2*-3", -6.0);
        check(Kind::Angle, "360/7*7", 360.0);
        check(Kind::Count, "9*2", 18.0);
        for text in ["2*", "/3", "1/0", "2**3", "1+", "2*x"] {
            assert!(Kind::Length.parse(text).is_err(), "{text}");
        }
        let expected = Err(Typo::NotWhole("9/2".to_owned()));
        assert_eq!(Kind::Count.parse("9/2"), expected);
    }

    #[test]
    fn nonsense_is_told_apart() {
        let check = |kind: Kind, text: &str, expect: Typo| {
            assert_eq!(kind.parse(text), Err(expect), "{text}");
        };
        let length = Kind::Length;
        check(length, "", Typo::Empty(length));
        check(length, "  ", Typo::Empty(length));
        for text in [
            "abc",
            "NaN",
            "nan",
            "inf",
            "-infinity",
            "1.2.3",
            "1,234.5",
            "1,2,3",
            "mm",
            "--1",
            "12 13",
            "1e",
            "e5",
            "½",
        ] {
            check(length, text, Typo::NoNumber(length, text.to_owned()));
        }
        check(length, "5 ft", Typo::NoUnit(length, "ft".to_owned()));
        check(length, "0x10", Typo::NoUnit(length, "x10".to_owned()));
        check(length, "5 rad", Typo::NoUnit(length, "rad".to_owned()));
        check(
            Kind::Angle,
            "5 mm",
            Typo::NoUnit(Kind::Angle, "mm".to_owned()),
        );
        check(
            Kind::Count,
            "5 mm",
            Typo::NoUnit(Kind::Count, "mm".to_owned()),
        );
        for text in ["1e999", "1e308 m", "-1e99999999999"] {
            check(length, text, Typo::TooLarge(text.to_owned()));
        }
        check(Kind::Count, "2.5", Typo::NotWhole("2.5".to_owned()));
    }

    #[test]
    fn a_vanishing_number_is_zero() {
        assert_eq!(Kind::Length.parse("1e-99999999999"), Ok(0.0));
    }
}
