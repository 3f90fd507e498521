//! A maximum that does not lose NaN.

/// The greater of two numbers, or NaN where either is: `f64::max` would drop
/// it, and a residual that could not be computed would pass for a small one.
pub fn greatest(a: f64, b: f64) -> f64 {
    if a.is_nan() || a > b { a } else { b }
}

#[cfg(test)]
mod tests {
    use super::greatest;

    #[test]
    fn numbers_compare_and_nan_stays() {
        assert_eq!(greatest(1.0, 2.0), 2.0);
        assert_eq!(greatest(2.0, 1.0), 2.0);
        assert!(greatest(f64::NAN, 1.0).is_nan());
        assert!(greatest(1.0, f64::NAN).is_nan());
    }
}
