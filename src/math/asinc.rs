//! The cardinal inverse sine, asin(x)/x, smooth through zero.

/// Returns asin(x)/x, with the value 1 at x = 0.
///
/// `x` in \[−1, 1\]; NaN outside. Relative error a few units in the last
/// place: below |x| = 1e-4 the series 1 + x²/6 + 3x⁴/40 leaves out less than
/// 5e-26.
pub fn asinc(x: f64) -> f64 {
    if x.abs() < 1e-4 {
        let square = x * x;
        1.0 + square * (1.0 / 6.0 + square * 0.075)
    } else {
        libm::asin(x) / x
    }
}

#[cfg(test)]
mod tests {
    use super::asinc;

    #[test]
    fn known_values_and_the_seam_of_the_series() {
        assert_eq!(asinc(0.0), 1.0);
        assert!((asinc(1.0) - std::f64::consts::FRAC_PI_2).abs() < 1e-15);
        for x in [9.999e-5_f64, 1.0001e-4, -3e-5] {
            assert!((asinc(x) - libm::asin(x) / x).abs() < 4e-16, "{x}");
        }
        assert!(asinc(1.1).is_nan());
    }
}
