//! How long the planar solves take.
//!
//! `cargo bench` prints every figure; `cargo bench -- warm` those whose name
//! contains "warm". Compare ratios within one run: machines differ and are
//! noisy. Goals, and what was measured on two cores of a 2026 Xeon (medians):
//!
//! | bench | goal | measured |
//! |---|---|---|
//! | `two_discs::cold` | ≤ 40 µs | MEASURED_COLD |
//! | `two_discs::warm_pull` | ≤ 12 µs | MEASURED_WARM |
//! | `two_discs::warm_drag` | ≤ 12 µs | MEASURED_DRAG |
//! | `two_discs::path_to_12_mm` | ≤ 0.4 ms | MEASURED_PATH |
//! | `per_segment` 10⁴ over 10² | ≤ 1.5 | MEASURED_RATIO |
//!
//! A warm solve is a whole answer: iterations, contacts and certificate. Where
//! its time goes at n = 18 with two contacts: MEASURED_SPLIT.

use divan::counter::ItemsCount;
use divan::{Bencher, black_box};
use sinew::equilibrium::{Run, Settings, Solution, Start, solve};
use sinew::geometry::Vector;
use sinew::model::Problem;
use sinew::scene::Scene;

fn main() {
    divan::main();
}

const SCENE: &str = include_str!("../assets/scenes/two-discs.toml");

fn problem(segments: u32, pull_mm: f64) -> Problem {
    let scene = Scene::from_toml(SCENE).and_then(|mut scene| {
        scene.robot.segments = segments;
        scene.actuation.pull_mm = pull_mm;
        Problem::new(&scene)
    });
    match scene {
        Ok(problem) => problem,
        Err(error) => panic!("the scene of this bench: {error}"),
    }
}

fn direct(problem: &Problem) -> Solution {
    solve(problem, Start::Direct, Settings::default())
}

/// Solves two problems in turn, each from the other's solution.
fn alternate(bencher: Bencher, near: &Problem, far: &Problem) {
    let mut run = Run::new(near, Start::Straight, Settings::default());
    run.finish();
    let mut there = false;
    bencher.bench_local(|| {
        there = !there;
        run.retarget(if there { far } else { near });
        black_box(run.finish().energy)
    });
}

/// The paper's experiment of Fig. 4b.
mod two_discs {
    use super::*;

    /// From the straight shape, directly, with nothing kept.
    #[divan::bench]
    fn cold(bencher: Bencher) {
        let problem = problem(18, 5.0);
        bencher.bench_local(|| direct(black_box(&problem)));
    }

    /// The pull moved by 0.05 mm and back.
    #[divan::bench]
    fn warm_pull(bencher: Bencher) {
        alternate(bencher, &problem(18, 5.0), &problem(18, 5.05));
    }

    /// A disc dragged by 0.5 mm and back.
    #[divan::bench]
    fn warm_drag(bencher: Bencher) {
        let near = problem(18, 5.0);
        let mut far = near.clone();
        let moved = near.obstacles()[0].moved(Vector::new(-5e-4, 0.0));
        far.set_obstacle(0, moved);
        alternate(bencher, &near, &far);
    }

    /// The whole way from straight.
    #[divan::bench]
    fn path_to_12_mm(bencher: Bencher) {
        let problem = problem(18, 12.0);
        bencher.bench_local(|| solve(black_box(&problem), Start::Straight, Settings::default()));
    }
}

/// Time grows with the number of segments: the items a second should stay.
#[divan::bench(args = [100, 1_000, 10_000])]
fn per_segment(bencher: Bencher, segments: u32) {
    let problem = problem(segments, 5.0);
    bencher
        .counter(ItemsCount::new(segments))
        .bench_local(|| direct(black_box(&problem)));
}

/// A drag frame of a fine robot.
#[divan::bench(args = [18, 200, 1_000])]
fn warm_pull(bencher: Bencher, segments: u32) {
    alternate(bencher, &problem(segments, 5.0), &problem(segments, 5.05));
}
