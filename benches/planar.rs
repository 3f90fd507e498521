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
//! Cables that slide, over the paper's model in one run (medians, on busy cores on which
//! its cold solve took 20.9 µs and its path 0.61 ms): cold 1.33 (27.9 µs), pull moved
//! 1.38, drag of 0.1 mm 0.70 (11.0 µs), path 2.4 (1.49 ms, for a goal of 0.4: 260
//! iterations in 34 steps, 110 of them where the upper post changes from one disk to the
//! next), time a segment at 10⁴ over that at 10² 2.0 (2.0 for the paper's model, too, on
//! those cores). With friction a drag of 0.1 mm takes 1.46 (23.1 µs); a pull there and
//! back, at which every hole turns round, 263 µs.
//!
//! A warm solve is a whole answer: iterations, contacts and certificate. Where
//! the time of a 0.5 mm drag goes: roll-outs with their rows 37 %, Hessian,
//! factor and working set 30 %, certificate 22 %, motion checks 8 %.

use divan::counter::ItemsCount;
use divan::{Bencher, black_box};
use sinew::equilibrium::{Run, Settings, Solved, Start, solve};
use sinew::geometry::Vector;
use sinew::mechanics::Problem;
use sinew::scene::{Friction, Mechanics, Scene};

fn main() {
    divan::main();
}

const SCENE: &str = include_str!("../assets/scenes/two-discs.toml");

/// What bends the robot.
#[derive(Clone, Copy, Debug)]
enum Kind {
    /// The paper's model.
    Equal,
    /// A cable that slides freely.
    Sliding,
    /// One that rubs in its holes and at the base, on a robot that rubs on the posts.
    Rubbing,
}

impl Kind {
    fn scene(self, segments: u32, pull_mm: f64) -> Scene {
        let read = Scene::from_toml(SCENE);
        let mut scene = match read {
            Ok(scene) => scene,
            Err(error) => panic!("the scene of this bench: {error}"),
        };
        scene.robot.segments = segments;
        scene.set_pull_mm(pull_mm);
        if !matches!(self, Kind::Equal) {
            scene.model.mechanics = Mechanics::Sliding;
        }
        if matches!(self, Kind::Rubbing) {
            scene.friction = Friction {
                holes: 0.275,
                contacts: 0.275,
                base_loss: 0.165,
            };
        }
        scene
    }

    fn problem(self, segments: u32, pull_mm: f64) -> Problem {
        match Problem::new(&self.scene(segments, pull_mm)) {
            Ok(problem) => problem,
            Err(error) => panic!("the scene of this bench: {error}"),
        }
    }

    /// A pull in millimetres at which both posts press.
    fn pull_mm(self) -> f64 {
        match self {
            Kind::Equal => 5.0,
            Kind::Sliding | Kind::Rubbing => 5.55,
        }
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

/// The paper's experiment of Fig. 4b, with each mechanics.
mod two_discs {
    use super::*;

    /// From the straight shape, directly, with nothing kept.
    #[divan::bench(args = [Kind::Equal, Kind::Sliding])]
    fn cold(bencher: Bencher, kind: Kind) {
        let problem = kind.problem(18, kind.pull_mm());
        bencher.bench_local(|| direct(black_box(&problem)));
    }

    /// The pull moved by 0.05 mm and back.
    #[divan::bench(args = [Kind::Equal, Kind::Sliding, Kind::Rubbing])]
    fn warm_pull(bencher: Bencher, kind: Kind) {
        let pull_mm = kind.pull_mm();
        alternate(
            bencher,
            &kind.problem(18, pull_mm),
            &kind.problem(18, pull_mm + 0.05),
        );
    }

    /// A disc dragged by so many micrometres and back: at sixty frames a second
    /// 6 and 30 mm/s. The longer drag takes a third iteration.
    #[divan::bench(args = [Kind::Equal, Kind::Sliding, Kind::Rubbing], consts = [100, 500])]
    fn warm_drag<const MICROMETRES: i32>(bencher: Bencher, kind: Kind) {
        let near = kind.problem(18, kind.pull_mm());
        let mut far = near.clone();
        let by = Vector::new(-1e-6 * f64::from(MICROMETRES), 0.0);
        far.set_obstacle(0, near.obstacles()[0].moved(by));
        alternate(bencher, &near, &far);
    }

    /// The whole way from straight.
    #[divan::bench(args = [Kind::Equal, Kind::Sliding, Kind::Rubbing])]
    fn path_to_12_mm(bencher: Bencher, kind: Kind) {
        let problem = kind.problem(18, 12.0);
        bencher.bench_local(|| solve(black_box(&problem), Start::Straight, Settings::default()));
    }
}

/// A warm solve of ever finer robots: the time a segment should stay, so the
/// items a second too. (A cold solve of 10⁴ segments spends most of its time in
/// the system's page faults for the storage that a run keeps.)
#[divan::bench(args = [Kind::Equal, Kind::Sliding], consts = [100, 1_000, 10_000])]
fn per_segment<const SEGMENTS: u32>(bencher: Bencher, kind: Kind) {
    let bencher = bencher.counter(ItemsCount::new(SEGMENTS));
    let pull_mm = kind.pull_mm();
    alternate(
        bencher,
        &kind.problem(SEGMENTS, pull_mm),
        &kind.problem(SEGMENTS, pull_mm + 0.05),
    );
}
