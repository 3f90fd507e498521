//! Sobol's sequence with Joe and Kuo's direction numbers, scrambled: every number of
//! samples 2^m has one in each of the 2^m slices of every parameter, and few clump in
//! any two of them. Any sample is found by its index alone.
//!
//! Sources: S. Joe and F. Y. Kuo, *Constructing Sobol sequences with better
//! two-dimensional projections*, SIAM J. Sci. Comput. 30 (2008), file
//! new-joe-kuo-6.21201; B. Burley, *Practical hash-based Owen scrambling*, JCGT 9
//! (2020), with N. Vegdahl's constants.

/// The most dimensions.
pub const MOST_DIMENSIONS: usize = 21;

/// Binary digits of a sample, and of the number of samples.
const DIGITS: u32 = 32;

/// Of each dimension after the first: the primitive polynomial's degree, its inner
/// coefficients and as many first direction numbers.
const DIRECTIONS: [(u32, u32, &[u32]); MOST_DIMENSIONS - 1] = [
    (1, 0, &[1]),
    (2, 1, &[1, 3]),
    (3, 1, &[1, 3, 1]),
    (3, 2, &[1, 1, 1]),
    (4, 1, &[1, 1, 3, 3]),
    (4, 4, &[1, 3, 5, 13]),
    (5, 2, &[1, 1, 5, 5, 17]),
    (5, 4, &[1, 1, 5, 5, 5]),
    (5, 7, &[1, 1, 7, 11, 19]),
    (5, 11, &[1, 1, 5, 1, 1]),
    (5, 13, &[1, 1, 1, 3, 11]),
    (5, 14, &[1, 3, 5, 5, 31]),
    (6, 1, &[1, 3, 3, 9, 7, 49]),
    (6, 13, &[1, 1, 1, 15, 21, 21]),
    (6, 16, &[1, 3, 1, 13, 27, 49]),
    (6, 19, &[1, 1, 1, 15, 7, 5]),
    (6, 22, &[1, 3, 1, 15, 13, 25]),
    (6, 25, &[1, 1, 5, 5, 19, 61]),
    (7, 1, &[1, 3, 7, 11, 23, 15, 103]),
    (7, 4, &[1, 3, 7, 13, 13, 15, 69]),
];

/// The sequence's point of an index in a dimension, in the order of Gray's code as in
/// Joe and Kuo's own program, in units of 2⁻³².
pub(super) fn point(index: u32, dimension: usize) -> u32 {
    let mut gray = index ^ (index >> 1);
    let mut directions = [0_u32; DIGITS as usize];
    fill(dimension, &mut directions);
    let mut point = 0;
    while gray != 0 {
        point ^= directions[gray.trailing_zeros() as usize];
        gray &= gray - 1;
    }
    point
}

/// The direction numbers of a dimension, their binary point before the first digit.
fn fill(dimension: usize, directions: &mut [u32; DIGITS as usize]) {
    let Some(before) = dimension.checked_sub(1) else {
        // The first dimension is van der Corput's sequence.
        for (digit, direction) in directions.iter_mut().enumerate() {
            *direction = 1 << (DIGITS - 1 - digit as u32);
        }
        return;
    };
    let (degree, coefficients, first) = DIRECTIONS[before];
    let s = degree as usize;
    for digit in 0..DIGITS as usize {
        directions[digit] = if digit < s {
            first[digit] << (DIGITS - 1 - digit as u32)
        } else {
            let mut direction = directions[digit - s] ^ (directions[digit - s] >> degree);
            for k in 1..s {
                let coefficient = (coefficients >> (s - 1 - k)) & 1;
                direction ^= coefficient * directions[digit - k];
            }
            direction
        };
    }
}

/// Owen's scramble by a hash: digit by digit from the first, each turned over or not
/// by all those before it. A bijection that keeps the sequence's evenness.
pub(super) fn scramble(point: u32, seed: u32) -> u32 {
    let mut x = point.reverse_bits();
    x ^= x.wrapping_mul(0x3d20_adea);
    x = x.wrapping_add(seed);
    x = x.wrapping_mul((seed >> 16) | 1);
    x ^= x.wrapping_mul(0x0552_6c56);
    x ^= x.wrapping_mul(0x53a2_2864);
    x.reverse_bits()
}

#[cfg(test)]
mod tests {
    use super::*;

    const ONE: f64 = 4_294_967_296.0;

    #[test]
    fn the_first_points_are_those_that_joe_and_kuo_print() {
        // `sobol 10 3 new-joe-kuo-6.21201` on the page of their program.
        let printed = [
            [0.0, 0.0, 0.0],
            [0.5, 0.5, 0.5],
            [0.75, 0.25, 0.25],
            [0.25, 0.75, 0.75],
            [0.375, 0.375, 0.625],
            [0.875, 0.875, 0.125],
            [0.625, 0.125, 0.875],
            [0.125, 0.625, 0.375],
            [0.1875, 0.3125, 0.9375],
            [0.6875, 0.8125, 0.4375],
        ];
        for (index, expected) in printed.iter().enumerate() {
            let found = [0, 1, 2].map(|d| f64::from(point(index as u32, d)) / ONE);
            assert_eq!(found, *expected, "{index}");
        }
    }

    #[test]
    fn every_dimension_has_its_published_directions() {
        // Points as SciPy 1.17's `qmc.Sobol(21, scramble=False, bits=32)` has them, whose
        // table is of Joe and Kuo's file, too. Gray's code of the second is all ones: a
        // single wrong direction of the 32, given or by the polynomial, would move it.
        let known: [(u32, [u32; MOST_DIMENSIONS]); 2] = [
            (
                1000,
                [
                    943718400, 415236096, 2227175424, 2906652672, 1203765248, 3896508416,
                    197132288, 3862953984, 2151677952, 297795584, 364904448, 1094713344, 692060160,
                    1648361472, 616562688, 1589641216, 3091202048, 1480589312, 4257218560,
                    3116367872, 2243952640,
                ],
            ),
            (
                0xaaaa_aaaa,
                [
                    4294967295, 1, 1325465599, 806158221, 1342505107, 3222343953, 1081134301,
                    2230321791, 2280850895, 2167068583, 2271385155, 2231269075, 2215448145,
                    3977049005, 721596651, 1347371487, 869025213, 3574878551, 3642577017,
                    3501682385, 3472963703,
                ],
            ),
        ];
        for (index, expected) in known {
            for (dimension, expected) in expected.into_iter().enumerate() {
                assert_eq!(point(index, dimension), expected, "{index} {dimension}");
            }
        }
    }

    /// Whether 2^m points have one in each slice of 2^-m, as in every dimension they do.
    fn is_stratified(points: impl Iterator<Item = u32>, m: u32) -> bool {
        let mut slices: Vec<u32> = points.map(|point| point >> (DIGITS - m)).collect();
        slices.sort_unstable();
        slices.into_iter().eq(0..1 << m)
    }

    #[test]
    fn every_dimension_is_even_scrambled_or_not() {
        for dimension in 0..MOST_DIMENSIONS {
            for m in [1, 4, 10] {
                // Any aligned stretch of the sequence, too.
                for from in [0, 1 << m, 37 << m] {
                    let points = (from..from + (1 << m)).map(|index| point(index, dimension));
                    assert!(is_stratified(points.clone(), m), "{dimension} {m}");
                    let scrambled = points.map(|point| scramble(point, 0x1234_5678));
                    assert!(is_stratified(scrambled, m), "{dimension} {m}");
                }
            }
        }
        // It can fail: pseudorandom points are not even.
        let random = (0..1024_u64).map(|i| (crate::study::hash::mix(i) >> 32) as u32);
        assert!(!is_stratified(random, 10));
    }

    #[test]
    fn the_first_two_dimensions_have_one_point_in_every_elementary_box() {
        let m = 8;
        for wide in 0..=m {
            let boxes = (0..1_u32 << m).map(|index| {
                let at = |dimension, seed| scramble(point(index, dimension), seed);
                let x = u64::from(at(0, 77)) >> (DIGITS - wide);
                let y = u64::from(at(1, 991)) >> (DIGITS - (m - wide));
                (x << (m - wide)) | y
            });
            let mut boxes: Vec<u64> = boxes.collect();
            boxes.sort_unstable();
            assert!(boxes.into_iter().eq(0..1 << m), "{wide}");
        }
    }

    #[test]
    fn seeds_scramble_differently() {
        let with = |seed| (0..64).map(move |index| scramble(point(index, 0), seed));
        assert!(with(1).ne(with(2)));
    }
}
