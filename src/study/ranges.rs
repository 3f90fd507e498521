//! Which samples there are already: a set of indices as ranges.

use std::ops::Range;

/// A set of indices.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Ranges {
    /// Neither empty nor touching each other, in order.
    ranges: Vec<Range<u64>>,
}

impl Ranges {
    /// Adds a range, which may be empty and overlap what there is.
    pub fn add(&mut self, range: Range<u64>) {
        if range.is_empty() {
            return;
        }
        let from = self.ranges.partition_point(|one| one.end < range.start);
        let to = self.ranges.partition_point(|one| one.start <= range.end);
        let mut whole = range;
        if let [first, .., last] | [first @ last] = &self.ranges[from..to] {
            whole = whole.start.min(first.start)..whole.end.max(last.end);
        }
        self.ranges.splice(from..to, [whole]);
    }

    /// The parts of a range that are not in the set, in order.
    pub fn missing(&self, range: Range<u64>) -> Vec<Range<u64>> {
        let mut missing = Vec::new();
        let mut at = range.start;
        for one in &self.ranges {
            let end = one.start.min(range.end);
            if at < end {
                missing.push(at..end);
            }
            at = at.max(one.end);
        }
        if at < range.end {
            missing.push(at..range.end);
        }
        missing
    }
}

/// The samples of a part of a study: `part` counts from 1 to `parts`. All parts together
/// have every sample once, and as many each as they can.
///
/// # Panics
/// If there is no such part.
pub fn shard(samples: u64, part: u64, parts: u64) -> Range<u64> {
    assert!((1..=parts).contains(&part), "part {part} of {parts}");
    let before = |part: u64| {
        let before = u128::from(samples) * u128::from(part) / u128::from(parts);
        // At most as many as there are.
        u64::try_from(before).unwrap_or(samples)
    };
    before(part - 1)..before(part)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ranges_are_those_of_a_plain_list() {
        let mut bits = 1_u64;
        for _ in 0..200 {
            let mut ranges = Ranges::default();
            let mut list = [false; 40];
            for _ in 0..8 {
                bits = super::super::hash::mix(bits);
                let from = bits % 36;
                let to = from + (bits >> 32) % 5;
                ranges.add(from..to);
                list[from as usize..to as usize].fill(true);
                let missing = ranges.missing(3..38);
                assert!(missing.iter().all(|one| one.start < one.end), "{missing:?}");
                let each = missing.iter().cloned().flatten();
                let expected = (3..38).filter(|i| !list[*i as usize]);
                assert!(each.eq(expected), "{ranges:?}");
                // In as few ranges as can be.
                let touch = ranges
                    .ranges
                    .windows(2)
                    .any(|two| two[0].end >= two[1].start);
                assert!(!touch, "{ranges:?}");
            }
        }
    }

    #[test]
    fn shards_have_every_sample_once() {
        for (samples, parts) in [(10, 3), (2, 5), (1_000_000_000, 7), (1, 1)] {
            let mut next = 0;
            for part in 1..=parts {
                let range = shard(samples, part, parts);
                assert_eq!(range.start, next);
                assert!((range.end - range.start).abs_diff(samples / parts) <= 1);
                next = range.end;
            }
            assert_eq!(next, samples);
        }
    }
}
