//! How long a solve takes, from nothing, along the path and from nearby. Only
//! the solving is timed: no reading, no printing, no start of the program.

use std::hint::black_box;
use std::time::{Duration, Instant};

use super::progress::Progress;
use crate::equilibrium::{Run, Settings, Solution, Start, Status, solve};
use crate::mechanics::{Input, Problem};
use crate::record::{Sample, Timing};
use crate::units::metres;

/// How far the pull moves between two warm solves, mm.
const NUDGE_MM: f64 = 0.05;
/// The load of one of two warm solves, over that of the other: of the paper's robot
/// as far as that.
const NUDGED: f64 = 1.01;

/// Solves a problem so many times in each of the three ways.
pub(super) fn measure(problem: &Problem, count: u32) -> Timing {
    let settings = Settings::default();
    let mut progress = Progress::new("timing", 3 * count);
    let mut done = 0;
    let mut next = || {
        done += 1;
        progress.at(done);
    };

    let mut cold = Samples::default();
    let mut path = Samples::default();
    for (start, samples) in [(Start::Direct, &mut cold), (Start::Straight, &mut path)] {
        for _ in 0..count {
            let begin = Instant::now();
            let solution = solve(black_box(problem), start, settings);
            samples.add(begin.elapsed(), &solution);
            next();
        }
    }

    let mut warm = Samples::default();
    let mut run = Run::new(problem, Start::Straight, settings);
    run.finish();
    let nearby = nearby(problem);
    for index in 0..count {
        let target = if index % 2 == 0 { &nearby } else { problem };
        let begin = Instant::now();
        run.retarget(black_box(target));
        let solution = run.finish();
        let elapsed = begin.elapsed();
        warm.add(elapsed, solution);
        next();
    }

    Timing {
        cold: cold.sum_up(),
        path: path.sum_up(),
        warm: warm.sum_up(),
    }
}

/// The problem at a pull a little further on or, where its range does not allow
/// that, a little back; at a load a little greater.
fn nearby(problem: &Problem) -> Problem {
    let (_, most) = problem.pull_range();
    if let Some(load) = problem.drive().load() {
        let mut drive = problem.drive().clone();
        drive.cables[0].input = Input::Load(NUDGED * load);
        let mut nearby = problem.clone();
        nearby.set_drive(&drive);
        return nearby;
    }
    let further = problem.pull() + metres(NUDGE_MM);
    let mut nearby = problem.clone();
    nearby.set_pull(if further <= most {
        further
    } else {
        problem.pull() - metres(NUDGE_MM)
    });
    nearby
}

#[derive(Default)]
struct Samples {
    times: Vec<Duration>,
    converged: u32,
}

impl Samples {
    fn add(&mut self, time: Duration, solution: &Solution) {
        self.times.push(time);
        self.converged += u32::from(solution.status == Status::Converged);
    }

    fn sum_up(mut self) -> Sample {
        self.times.sort_unstable();
        Sample {
            median: self.quantile(0.5),
            p99: self.quantile(0.99),
            converged: self.converged,
        }
    }

    /// The least time that a share of all times is not above, of sorted times.
    fn quantile(&self, share: f64) -> f64 {
        let rank = (share * self.times.len() as f64).ceil() as usize;
        let time = self.times.get(rank.saturating_sub(1));
        time.map_or(0.0, |time| time.as_secs_f64() * 1e6)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_quantile_is_one_of_the_times() {
        let samples = Samples {
            times: (1..=200).map(Duration::from_micros).collect(),
            converged: 200,
        };
        let sample = samples.sum_up();
        assert!((sample.median - 100.0).abs() < 1e-9);
        assert!((sample.p99 - 198.0).abs() < 1e-9);
    }
}
