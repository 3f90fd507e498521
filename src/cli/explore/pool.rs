//! Samples on several threads, in chunks: of each chunk all threads take samples until it
//! is whole, and only then the next begins, so that whoever is stopped loses one chunk.

use std::ops::Range;
use std::time::{Duration, Instant};

use rayon::prelude::*;

use super::super::Failure;
use crate::study::{Row, Study, log};

/// A chunk that takes less is followed by a larger one, one that takes more by a smaller:
/// at the end of a chunk threads wait for the slowest, and more is lost with a longer one.
const SHORTEST: Duration = Duration::from_millis(100);
const LONGEST: Duration = Duration::from_millis(400);
/// Samples that a thread takes at once, at most.
const AT_ONCE: usize = 4;

/// How far the computing has got.
#[derive(Clone, Copy, Debug)]
pub(super) struct SoFar {
    /// Samples done.
    pub done: u64,
    /// Samples asked for.
    pub all: u64,
    /// Seconds since the first began.
    pub seconds: f64,
}

impl SoFar {
    /// In words, with the rate and the time that is left.
    pub fn pace(&self) -> String {
        let rate = self.done as f64 / self.seconds.max(1e-9);
        let left = (self.all - self.done) as f64 / rate.max(1e-9);
        format!("{} a second, {} left", rounded(rate), duration(left))
    }
}

/// A number with three figures or all before its point.
pub(super) fn rounded(value: f64) -> String {
    match value {
        100.0.. => format!("{value:.0}"),
        10.0.. => format!("{value:.1}"),
        _ => format!("{value:.2}"),
    }
}

/// A time in the unit that people would use.
pub(super) fn duration(seconds: f64) -> String {
    match seconds {
        172_800.0.. => format!("{:.1} days", seconds / 86_400.0),
        7_200.0.. => format!("{:.1} h", seconds / 3600.0),
        120.0.. => format!("{:.1} min", seconds / 60.0),
        1.0.. => format!("{seconds:.1} s"),
        1e-3.. => format!("{:.0} ms", 1e3 * seconds),
        _ => format!("{:.0} µs", 1e6 * seconds),
    }
}

/// Computes ranges of samples and hands over every chunk of their rows, in order, with
/// the index of its first. Returns the seconds that it took.
///
/// # Errors
/// The first of `each`, which ends it.
pub(super) fn compute(
    study: &Study,
    todo: &[Range<u64>],
    threads: usize,
    mut each: impl FnMut(u64, &[Row], SoFar) -> Result<(), Failure>,
) -> Result<f64, Failure> {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build();
    let pool = pool.map_err(|error| Failure::Making(error.into()))?;
    let all = todo.iter().map(|range| range.end - range.start).sum();
    let started = Instant::now();
    let mut done = 0;
    let mut size = 16 * threads.min(log::MOST_ROWS / 16);
    for range in todo {
        let mut first = range.start;
        while first < range.end {
            let end = range.end.min(first + size as u64);
            let began = Instant::now();
            let rows = pool.install(|| chunk(study, first..end));
            let took = began.elapsed();
            done += end - first;
            let seconds = started.elapsed().as_secs_f64();
            each(first, &rows, SoFar { done, all, seconds })?;
            first = end;
            size = next_size(size, took, threads);
        }
    }
    Ok(started.elapsed().as_secs_f64())
}

/// The rows of some samples, in their order, on the threads of the pool that it runs in.
fn chunk(study: &Study, samples: Range<u64>) -> Vec<Row> {
    // An index is fit for a length: no more than a chunk's.
    let count = (samples.end - samples.start) as usize;
    let rows = (0..count).into_par_iter().with_max_len(AT_ONCE);
    rows.map(|place| study.compute(samples.start + place as u64))
        .collect()
}

/// How many samples the next chunk has.
fn next_size(size: usize, took: Duration, threads: usize) -> usize {
    let size = match took {
        took if took < SHORTEST => 2 * size,
        took if took > LONGEST => size / 2,
        _ => size,
    };
    size.clamp(threads.min(log::MOST_ROWS), log::MOST_ROWS)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn chunks_grow_and_shrink_to_a_quarter_of_a_second() {
        let milliseconds = Duration::from_millis;
        assert_eq!(next_size(32, milliseconds(5), 2), 64);
        assert_eq!(next_size(32, milliseconds(200), 2), 32);
        assert_eq!(next_size(32, milliseconds(900), 2), 16);
        assert_eq!(next_size(2, milliseconds(900), 2), 2);
        assert_eq!(next_size(1, milliseconds(900), 1), 1);
        let most = log::MOST_ROWS;
        assert_eq!(next_size(most, milliseconds(5), 2), most);
    }

    #[test]
    fn the_pace_tells_rate_and_time_left() {
        let pace = |done, all, seconds| SoFar { done, all, seconds }.pace();
        assert_eq!(pace(3000, 9000, 0.25), "12000 a second, 500 ms left");
        assert_eq!(pace(10, 10_000, 5.0), "2.00 a second, 83.2 min left");
        assert_eq!(pace(50, 50, 2.0), "25.0 a second, 0 µs left");
    }
}
