//! Hardly a slip is overlooked: at the default steps a run jumps where one of
//! much finer steps does, and ends in the same shape.

use proptest::prelude::*;
use proptest::strategy::ValueTree;
use proptest::test_runner::{RngSeed, TestRunner};
use sinew::equilibrium::{Occurrence, Settings, Solution, Solved, Start, Status, solve};
use sinew::mechanics::Problem;
use sinew::scene::{Candidates, Mechanics, Scene, Shape};

const FREE: &str = include_str!("../assets/scenes/free.toml");

/// A scene of the paper's robot with a disc.
fn with_disc(pull_mm: f64, center_mm: [f64; 2], radius_mm: f64) -> Scene {
    let mut scene = Scene::from_toml(FREE).unwrap();
    scene.set_pull_mm(pull_mm);
    let disc = Shape::Disc {
        center_mm,
        radius_mm,
    };
    scene.obstacles.push(disc.into());
    scene
}

/// Solves with steps so many times finer than the default ones.
fn run(problem: &Problem, finer: f64) -> Solved {
    let settings = Settings::default();
    let settings = Settings {
        iterations: 500_000,
        pull_step: settings.pull_step / finer,
        obstacle_step: settings.obstacle_step / finer,
    };
    solve(problem, Start::Straight, settings)
}

/// Pull and distance of every jump, in millimetres.
fn jumps(solution: &Solution) -> Vec<(f64, f64)> {
    let jump = |what| match what {
        Occurrence::Jump { distance, .. } => Some(1e3 * distance),
        _ => None,
    };
    let events = solution.events.iter();
    events
        .filter_map(|event| Some((1e3 * event.pull, jump(event.what)?)))
        .collect()
}

/// The disc holds the cable back at node 16 until the equilibrium folds at a
/// pull of 5.285 mm: from there on the motion grows as the square root of what
/// is left to the fold. The backbone of the same node catches on the disc and
/// slips off it at 7.112 mm. (From runs with steps of 0.005 mm.) Both other
/// branches exist long before: at 5.125 mm a step of the default size could
/// already end on the one behind the disc.
#[test]
fn a_disc_smaller_than_a_step_holds_the_robot_until_it_slips() {
    let scene = with_disc(10.0, [44.0, 150.0], 2.0);
    let problem = Problem::new(&scene).unwrap();
    for finer in [1.0, 2.0, 4.0, 20.0] {
        let found = jumps(&run(&problem, finer));
        let expected = [(5.285, 7.42), (7.112, 18.80)];
        assert_eq!(found.len(), expected.len(), "{finer}: {found:?}");
        for (found, expected) in found.iter().zip(expected) {
            assert!((found.0 - expected.0).abs() < 0.01, "{finer}: {found:?}");
            assert!((found.1 - expected.1).abs() < 0.1, "{finer}: {found:?}");
        }
    }
}

/// The straight line between two free shapes only grazes the disc, by 0.1 mm,
/// and leaves it on the same half of its outline; but the disc holds node 10
/// from there on, up to a pull of 6.74 mm.
#[test]
fn a_disc_grazed_within_a_step_is_met() {
    let scene = with_disc(6.0, [18.3068, 95.8493], 1.7671);
    let problem = Problem::new(&scene).unwrap();
    let solution = run(&problem, 1.0);
    assert_eq!(solution.status, Status::Converged);
    assert_eq!(solution.contacts.len(), 1);
    assert_eq!(solution.contacts[0].node, 10);
}

/// Small discs on the way of the free robot.
fn small_disc(candidates: Candidates) -> impl Strategy<Value = Scene> {
    let place = (0.15..1.0f64, 0.25..1.0f64, -2.0..14.0f64);
    (6.0..12.0f64, place, 1.0..5.0f64).prop_map(
        move |(pull_mm, (pulled, share, beside_mm), radius_mm)| {
            // On the arc of the free robot at some smaller pull.
            let (length_mm, offset_mm) = (180.0, 8.0);
            let curvature = pulled * pull_mm / offset_mm / length_mm;
            let angle = share * length_mm * curvature;
            let center_mm = [
                (1.0 - angle.cos()) / curvature + beside_mm * angle.cos(),
                angle.sin() / curvature - beside_mm * angle.sin(),
            ];
            let mut scene = with_disc(pull_mm, center_mm, radius_mm);
            scene.contact.candidates = candidates;
            scene
        },
    )
}

/// How many of the jumps of finer runs the default steps miss, how many there
/// are, and how many runs end in another shape.
fn count(cases: u32, candidates: Candidates, mechanics: Mechanics) -> (usize, usize, usize) {
    let (mut missed, mut all, mut elsewhere) = (0, 0, 0);
    let mut runner = TestRunner::new(ProptestConfig {
        rng_seed: RngSeed::Fixed(1),
        ..ProptestConfig::default()
    });
    for _ in 0..cases {
        let tree = small_disc(candidates).new_tree(&mut runner);
        let mut scene = tree.unwrap().current();
        scene.model.mechanics = mechanics;
        let Ok(problem) = Problem::new(&scene) else {
            continue;
        };
        let fine = run(&problem, 20.0);
        if fine.status != Status::Converged {
            continue;
        }
        let coarse = run(&problem, 1.0);
        let found = jumps(&coarse);
        // Below half a millimetre a slip hardly differs from a quick slide.
        let expected: Vec<_> = jumps(&fine)
            .into_iter()
            .filter(|jump| jump.1 > 0.5)
            .collect();
        let near = |pull: f64| found.iter().any(|jump| (jump.0 - pull).abs() < 0.05);
        all += expected.len();
        missed += expected.iter().filter(|jump| !near(jump.0)).count();
        let pairs = coarse.nodes.iter().zip(&fine.nodes);
        let apart = pairs.map(|(a, b)| (a.position - b.position).norm());
        elsewhere += usize::from(apart.fold(0.0, f64::max) > 1e-4);
    }
    (missed, all, elsewhere)
}

#[test]
fn default_steps_find_the_slips_of_finer_ones() {
    hardly_any_is_missed(Mechanics::Equal, 0);
}

#[test]
fn default_steps_find_the_slips_of_finer_ones_where_the_cable_slides() {
    // One run ends on the front of a disc that finer ones have slid past by 0.7 mm.
    hardly_any_is_missed(Mechanics::Sliding, 1);
}

/// Of 300 runs at most so many may end in another shape.
fn hardly_any_is_missed(mechanics: Mechanics, elsewhere: usize) {
    let nodes = count(150, Candidates::Nodes, mechanics);
    let body = count(150, Candidates::Body, mechanics);
    let (missed, all) = (nodes.0 + body.0, nodes.1 + body.1);
    assert!(all > 60, "{all}");
    // A few small slips are still missed.
    assert!(30 * missed <= all, "{missed} of {all}");
    assert!(nodes.2 + body.2 <= elsewhere, "{} {}", nodes.2, body.2);
}
