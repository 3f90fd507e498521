//! How long the planar solves take.
//!
//! `cargo bench` prints every figure; `cargo bench -- warm` those whose name
//! contains "warm". Compare ratios within one run: machines differ and are
//! noisy. Goals, and what was measured on two cores of a 2026 Xeon (medians):
//!
//! | bench | goal | measured |
//! |---|---|---|
//! | `two_discs::cold` | ≤ 40 µs | 13.4 µs |
//! | `two_discs::warm_pull` | ≤ 12 µs | 10.6 µs |
//! | `two_discs::warm_drag`, 0.1 mm | ≤ 12 µs | 10.5 µs |
//! | `two_discs::warm_drag`, 0.5 mm | ≤ 12 µs | 13.4 µs: a third iteration |
//! | `two_discs::path_to_12_mm` | ≤ 0.4 ms | 0.41 ms: 0.05 for looking back at steps |
//! | `per_segment`, 10⁴ over 10² | ≤ 1.5 | 1.36 |
//!
//! A warm solve is a whole answer: iterations, contacts and certificate. Where
//! the time of a 0.5 mm drag goes: roll-outs with their rows 37 %, Hessian,
//! factor and working set 30 %, certificate 22 %, motion checks 8 %.

use divan::counter::ItemsCount;
use divan::{Bencher, black_box};
use sinew::equilibrium::{Run, Settings, Solved, Start, solve};
use sinew::geometry::Vector;
use sinew::mechanics::Problem;
use sinew::scene::Scene;

fn main() {
    divan::main();
}

const SCENE: &str = include_str!("../assets/scenes/two-discs.toml");

fn problem(segments: u32, pull_mm: f64) -> Problem {
    let scene = Scene::from_toml(SCENE).and_then(|mut scene| {
        scene.robot.segments = segments;
        scene.set_pull_mm(pull_mm);
        Problem::new(&scene)
    });
    match scene {
        Ok(problem) => problem,
        Err(error) => panic!("the scene of this bench: {error}"),
    }
}

fn direct(problem: &Problem) -> Solved {
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

    /// A disc dragged by so many micrometres and back: at sixty frames a second
    /// 6 and 30 mm/s. The longer drag takes a third iteration.
    #[divan::bench(args = [100, 500])]
    fn warm_drag(bencher: Bencher, micrometres: u32) {
        let near = problem(18, 5.0);
        let mut far = near.clone();
        let by = Vector::new(-1e-6 * f64::from(micrometres), 0.0);
        far.set_obstacle(0, near.obstacles()[0].moved(by));
        alternate(bencher, &near, &far);
    }

    /// The whole way from straight.
    #[divan::bench]
    fn path_to_12_mm(bencher: Bencher) {
        let problem = problem(18, 12.0);
        bencher.bench_local(|| solve(black_box(&problem), Start::Straight, Settings::default()));
    }
}

/// A warm solve of ever finer robots: the time a segment should stay, so the
/// items a second too. (A cold solve of 10⁴ segments spends most of its time in
/// the system's page faults for the storage that a run keeps.)
#[divan::bench(args = [100, 1_000, 10_000])]
fn per_segment(bencher: Bencher, segments: u32) {
    let bencher = bencher.counter(ItemsCount::new(segments));
    alternate(bencher, &problem(segments, 5.0), &problem(segments, 5.05));
}
