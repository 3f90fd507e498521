//! Numbers as text, with no sign where they are or round to zero. The only
//! place that turns a number into so many decimals; how many of them mean
//! something is not its business.

/// The number itself, but for −0, which would print its sign.
pub fn unsigned_zero(value: f64) -> f64 {
    value + 0.0
}

/// A value with so many decimals and a hyphen for minus: `-4.90`, and `0.00`
/// for what rounds to zero from either side.
pub fn decimals(value: f64, count: usize) -> String {
    let text = format!("{value:.count$}");
    match text.strip_prefix('-') {
        Some(rest) if rest.bytes().all(|byte| matches!(byte, b'0' | b'.')) => rest.to_owned(),
        _ => text,
    }
}

/// Digits with a minus sign, U+2212, for the hyphen before them: for what is
/// read as text and never parsed.
pub fn with_minus(digits: &str) -> String {
    match digits.strip_prefix('-') {
        Some(rest) => format!("\u{2212}{rest}"),
        None => digits.to_owned(),
    }
}

/// A value with so many decimals and a minus sign: `−4.90`.
pub fn typeset(value: f64, count: usize) -> String {
    with_minus(&decimals(value, count))
}

/// The shortest text that reads back as the same number: `-4.9`, `1e-7`, and
/// `0.0` for −0.
pub fn shortest(value: f64) -> String {
    format!("{:?}", unsigned_zero(value))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn zero_has_no_sign() {
        assert_eq!(decimals(-0.0, 2), "0.00");
        assert_eq!(decimals(-0.004, 2), "0.00");
        assert_eq!(decimals(-0.4, 0), "0");
        assert_eq!(decimals(-0.006, 2), "-0.01");
        assert_eq!(decimals(-10.0, 1), "-10.0");
        assert_eq!(decimals(f64::NAN, 1), "NaN");
        assert_eq!(shortest(-0.0), "0.0");
        assert_eq!(shortest(-1e-7), "-1e-7");
    }

    #[test]
    fn text_has_a_minus_sign_and_no_negative_zero() {
        assert_eq!(typeset(-0.001, 2), "0.00");
        assert_eq!(typeset(-1.5, 1), "−1.5");
        assert_eq!(typeset(1.25, 0), "1");
        assert_eq!(with_minus("-1e-7"), "−1e-7");
    }
}
