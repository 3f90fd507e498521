//! A number kept between two others, without words about it.

/// The number of a range from `least` to `most` that is nearest to a value; NaN
/// for NaN. The same as `f64::clamp`, bit for bit, which says in a panic what
/// the range was if it is none: that takes the code that writes numbers, and
/// the page's solver writes no other.
pub fn within(value: f64, least: f64, most: f64) -> f64 {
    debug_assert!(least <= most);
    if value < least {
        least
    } else if value > most {
        most
    } else {
        value
    }
}

#[cfg(test)]
mod tests {
    use super::within;

    #[test]
    fn it_is_the_same_as_std_s_to_the_bit() {
        let values = [
            -2.0,
            -1.0,
            -0.0,
            0.0,
            0.5,
            1.0,
            3.0,
            f64::INFINITY,
            f64::NAN,
        ];
        for value in values {
            for (least, most) in [(-1.0, 1.0), (0.0, 1.0), (-0.0, 0.0), (1.0, 1.0)] {
                let expect = value.clamp(least, most).to_bits();
                assert_eq!(within(value, least, most).to_bits(), expect, "{value}");
            }
        }
    }
}
