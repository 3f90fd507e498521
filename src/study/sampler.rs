//! Where in the ranges of its parameters a study takes its samples: each found by its
//! index alone, in any order, on any machine.

use super::hash::{mix, seed, unit};
use super::sobol;

/// A way to take samples.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sampler {
    /// Every step of every axis with every one of the others.
    Grid,
    /// A Latin hypercube: so many slices of every axis, a sample in each, paired at
    /// random (M. D. McKay, R. J. Beckman and W. J. Conover, 1979).
    Latin,
    /// Sobol's sequence, scrambled by Owen's method: even in every axis and in pairs of
    /// them, for any number of samples, best for powers of 2.
    Sobol,
}

/// Where on an axis a sample lies.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Position {
    /// At a step, counted from 0.
    Step(u64),
    /// At a share of the axis in [0, 1).
    Share(f64),
}

impl Sampler {
    /// Every sampler, with its name in files.
    pub(super) const NAMES: [&'static str; 3] = ["grid", "latin", "sobol"];

    /// The sampler's name in files.
    pub fn name(self) -> &'static str {
        Self::NAMES[self as usize]
    }

    /// The sampler of a name.
    pub(super) fn of_name(name: &str) -> Option<Self> {
        let all = [Self::Grid, Self::Latin, Self::Sobol];
        all.into_iter().find(|sampler| sampler.name() == name)
    }

    /// Where the sample of an index, less than `samples`, lies on an axis. `steps` are
    /// those of all axes; the last one changes fastest.
    pub(super) fn position(
        self,
        index: u64,
        axis: usize,
        steps: &[u64],
        samples: u64,
        study_seed: u64,
    ) -> Position {
        let own = seed(study_seed, axis as u64);
        match self {
            Sampler::Grid => {
                let faster: u64 = steps[axis + 1..].iter().product();
                Position::Step(index / faster % steps[axis])
            }
            Sampler::Latin => {
                let slice = permuted(index, samples, own);
                let within = unit(mix(own ^ mix(index)));
                // Rounding may not lead into the next slice.
                let share = (slice as f64 + within) / samples as f64;
                let end = (slice + 1) as f64 / samples as f64;
                Position::Share(share.min(end.next_down()))
            }
            Sampler::Sobol => {
                // More samples than fit an index are refused with the study.
                let point = sobol::point(index as u32, axis);
                let point = sobol::scramble(point, (own >> 32) as u32);
                // In the middle of what the digits leave open.
                Position::Share((f64::from(point) + 0.5) / 4_294_967_296.0)
            }
        }
    }
}

/// The place of `index` in a permutation of the numbers below `count`: a Feistel network
/// over the least even number of binary digits, gone through again where it leads to
/// `count` or beyond.
fn permuted(index: u64, count: u64, key: u64) -> u64 {
    let digits = u64::BITS - (count - 1).leading_zeros();
    let half = digits.div_ceil(2).max(1);
    let mask = (1_u64 << half) - 1;
    let mut place = index;
    loop {
        let (mut left, mut right) = (place >> half, place & mask);
        for round in 0..6 {
            let turned = mix(seed(key, round) ^ right) & mask;
            (left, right) = (right, left ^ turned);
        }
        place = (left << half) | right;
        if place < count {
            return place;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn share(sampler: Sampler, index: u64, axis: usize, samples: u64, seed: u64) -> f64 {
        match sampler.position(index, axis, &[], samples, seed) {
            Position::Share(share) => share,
            Position::Step(step) => panic!("step {step}"),
        }
    }

    #[test]
    fn a_permutation_has_every_number_once() {
        for count in [1, 2, 3, 7, 64, 1000, 4097] {
            let mut all: Vec<u64> = (0..count).map(|i| permuted(i, count, 9)).collect();
            assert!(count < 7 || !all.is_sorted(), "{count}");
            all.sort_unstable();
            assert!(all.into_iter().eq(0..count), "{count}");
        }
    }

    #[test]
    fn a_latin_hypercube_has_one_sample_in_every_slice_of_every_axis() {
        for samples in [1, 5, 97, 1024] {
            for axis in 0..4 {
                let at = |index| share(Sampler::Latin, index, axis, samples, 3);
                let slices = (0..samples).map(|index| (at(index) * samples as f64) as u64);
                let mut slices: Vec<u64> = slices.collect();
                slices.sort_unstable();
                assert!(slices.into_iter().eq(0..samples), "{samples} {axis}");
            }
        }
    }

    #[test]
    fn the_axes_of_a_hypercube_have_nothing_in_common() {
        for sampler in [Sampler::Latin, Sampler::Sobol] {
            let count = 4096;
            let at = |index, axis| share(sampler, index, axis, count, 11) - 0.5;
            let product: f64 = (0..count).map(|i| at(i, 0) * at(i, 1)).sum();
            let square: f64 = (0..count).map(|i| at(i, 0) * at(i, 0)).sum();
            // Three times the deviation of independent numbers.
            assert!((product / square).abs() < 3.0 / 64.0, "{sampler:?}");
        }
    }

    /// The mean of a product over five axes: (1/2)^5. Plain chance errs by 0.9 / √n of
    /// it, 0.014 for n = 4096; even samples by much less.
    #[test]
    fn sobol_integrates_better_than_chance() {
        let count = 4096;
        let error = |seed| {
            let product = |i| -> f64 {
                let factors = (0..5).map(|axis| share(Sampler::Sobol, i, axis, count, seed));
                factors.product()
            };
            let sum: f64 = (0..count).map(product).sum();
            (sum / count as f64 * 32.0 - 1.0).abs()
        };
        for seed in 0..8 {
            assert!(error(seed) < 0.002, "{seed}: {}", error(seed));
        }
    }

    #[test]
    fn a_grid_has_every_step_with_every_other_the_last_fastest() {
        let steps = [2, 3];
        let at = |index| {
            [0, 1].map(
                |axis| match Sampler::Grid.position(index, axis, &steps, 6, 0) {
                    Position::Step(step) => step,
                    Position::Share(share) => panic!("{share}"),
                },
            )
        };
        let all: Vec<[u64; 2]> = (0..6).map(at).collect();
        assert_eq!(all, [[0, 0], [0, 1], [0, 2], [1, 0], [1, 1], [1, 2]]);
    }

    #[test]
    fn seeds_give_other_samples() {
        for sampler in [Sampler::Latin, Sampler::Sobol] {
            let with = |seed| (0..32).map(move |index| share(sampler, index, 0, 32, seed));
            assert!(with(1).ne(with(2)), "{sampler:?}");
            assert!(with(1).eq(with(1)), "{sampler:?}");
        }
    }
}
