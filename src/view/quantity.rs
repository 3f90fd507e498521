//! Numbers as people read them: rounded to what means something, with real
//! minus signs, apart from their unit. It converts no units.

use crate::math::{self, with_minus};

/// A number and its unit, as text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Quantity {
    /// The digits, such as `−4.90`.
    pub digits: String,
    /// The unit, such as `mm`; empty for a bare number.
    pub unit: &'static str,
}

impl Quantity {
    /// A value with so many decimals.
    pub fn fixed(value: f64, decimals: usize, unit: &'static str) -> Self {
        Self {
            digits: math::typeset(value, decimals),
            unit,
        }
    }

    /// A value with three significant digits; as a power of ten below 10⁻³
    /// and from 10⁶.
    pub fn significant(value: f64, unit: &'static str) -> Self {
        Self {
            digits: significant(value),
            unit,
        }
    }

    /// A round number with no more digits than it has; as a power of ten below 10⁻³.
    pub fn round(value: f64, unit: &'static str) -> Self {
        let power = libm::log10(value).floor();
        if value.is_nan() || power < -3.0 {
            return Self::order(value, unit);
        }
        Self::fixed(value, (-power).max(0.0) as usize, unit)
    }

    /// A value with one significant digit times a power of ten: how large it
    /// is, where more would mean nothing.
    pub fn order(value: f64, unit: &'static str) -> Self {
        Self {
            digits: order(value),
            unit,
        }
    }

    /// Digits and unit in one line.
    pub fn text(&self) -> String {
        match self.unit {
            "" | "°" => format!("{}{}", self.digits, self.unit),
            unit => format!("{} {unit}", self.digits),
        }
    }
}

fn significant(value: f64) -> String {
    if value == 0.0 || !value.is_finite() {
        return with_minus(&math::unsigned_zero(value).to_string());
    }
    // Rounds first, so that 9.999 is 10.0.
    let rounded = format!("{value:.2e}");
    let (mantissa, exponent) = rounded.split_once('e').unwrap_or((&rounded, "0"));
    let exponent: i32 = exponent.parse().unwrap_or(0);
    if (-3..6).contains(&exponent) {
        let decimals = (2 - exponent).max(0) as usize;
        return math::typeset(value, decimals);
    }
    format!("{}×10{}", with_minus(mantissa), superscript(exponent))
}

fn order(value: f64) -> String {
    if value == 0.0 || !value.is_finite() {
        return with_minus(&math::unsigned_zero(value).to_string());
    }
    let rounded = format!("{value:.0e}");
    let (digit, exponent) = rounded.split_once('e').unwrap_or((&rounded, "0"));
    format!(
        "{}×10{}",
        with_minus(digit),
        superscript(exponent.parse().unwrap_or(0))
    )
}

/// An exponent in raised digits.
pub fn superscript(exponent: i32) -> String {
    let raised = |c| match c {
        '-' => '⁻',
        '1' => '¹',
        '2' => '²',
        '3' => '³',
        '4' => '⁴',
        '5' => '⁵',
        '6' => '⁶',
        '7' => '⁷',
        '8' => '⁸',
        '9' => '⁹',
        _ => '⁰',
    };
    exponent.to_string().chars().map(raised).collect()
}

/// The greatest of 1, 2 and 5 times a power of ten that is at most `limit`,
/// which must be over zero.
pub fn one_two_five(limit: f64) -> f64 {
    // A hair more, so that rounding does not turn 10 into 5.
    let limit = limit * (1.0 + 1e-9);
    let power = libm::log10(limit).floor() as i32;
    let scaled = |factor: f64| match power {
        // Exact for the powers that are.
        0.. => factor * libm::exp10(f64::from(power)),
        _ => factor / libm::exp10(f64::from(-power)),
    };
    [5.0, 2.0]
        .map(scaled)
        .into_iter()
        .find(|value| *value <= limit)
        .unwrap_or(scaled(1.0))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn digits_are_those_that_mean_something() {
        let check = |value, expect: &str| assert_eq!(significant(value), expect);
        check(0.0, "0");
        check(-0.0, "0");
        check(0.0012345, "0.00123");
        check(-12.0, "−12.0");
        check(9.999, "10.0");
        check(123456.0, "123456");
        check(4.2e-7, "4.20×10⁻⁷");
        check(-3e12, "−3.00×10¹²");
        assert_eq!(Quantity::fixed(-0.001, 2, "mm").text(), "0.00 mm");
        assert_eq!(Quantity::fixed(-4.9, 1, "°").text(), "−4.9°");
        assert_eq!(Quantity::fixed(-4.9, 2, "mm").text(), "−4.90 mm");
    }

    #[test]
    fn orders_of_magnitude_have_one_digit() {
        let check = |value, expect: &str| assert_eq!(order(value), expect);
        check(0.0, "0");
        check(3.4e-14, "3×10⁻¹⁴");
        check(9.9e-10, "1×10⁻⁹");
        check(-0.3, "−3×10⁻¹");
        check(f64::NAN, "NaN");
    }

    #[test]
    fn lengths_of_scale_bars() {
        let check = |limit, expect| assert_eq!(one_two_five(limit), expect);
        check(1.0, 1.0);
        check(0.049, 0.02);
        check(0.05, 0.05);
        check(9.9, 5.0);
        check(0.1, 0.1);
        check(4321.0, 2000.0);
    }
}
