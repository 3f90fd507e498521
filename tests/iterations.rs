//! How much work the solves take, counted and not timed: a lost warm start or
//! a Hessian that is no longer exact shows here. And what a warm solve
//! allocates: nothing.

use sinew::equilibrium::{Run, Settings, Start, Status, solve};
use sinew::geometry::Vector;
use sinew::mechanics::Problem;
use sinew::scene::{Mechanics, Scene};

fn problem(scene: &str, pull_mm: f64) -> Problem {
    strung(scene, pull_mm, Mechanics::Equal)
}

fn strung(scene: &str, pull_mm: f64, mechanics: Mechanics) -> Problem {
    let mut scene = Scene::from_toml(scene).unwrap();
    scene.model.mechanics = mechanics;
    scene.set_pull_mm(pull_mm);
    Problem::new(&scene).unwrap()
}

const TWO_DISCS: &str = include_str!("../assets/scenes/two-discs.toml");
const ONE_DISC: &str = include_str!("../assets/scenes/one-disc.toml");
const SHAPES: &str = include_str!("../assets/scenes/shapes.toml");
const BODY: &str = include_str!("../assets/scenes/body-contact.toml");

/// Iterations of a direct solve, of the way from straight, and of a small
/// change of the pull.
fn check(scene: &str, pull_mm: f64, expect: [usize; 3]) {
    check_strung(scene, pull_mm, Mechanics::Equal, expect);
}

fn check_strung(scene: &str, pull_mm: f64, mechanics: Mechanics, expect: [usize; 3]) {
    let goal = strung(scene, pull_mm, mechanics);
    let direct = solve(&goal, Start::Direct, Settings::default());
    let mut run = Run::new(&goal, Start::Straight, Settings::default());
    let path = run.finish().iterations;
    run.retarget(&strung(scene, pull_mm + 0.05, mechanics));
    let warm = run.finish();
    assert_eq!(warm.status, Status::Converged);
    let found = [direct.iterations, path, warm.iterations];
    for (found, expect) in found.iter().zip(expect) {
        assert!(*found <= expect, "{found:?} of at most {expect:?}");
    }
}

#[test]
fn known_scenes_take_known_iterations() {
    check(TWO_DISCS, 5.0, [4, 28, 5]);
    check(TWO_DISCS, 12.0, [8, 168, 5]);
    check(ONE_DISC, 6.0, [6, 32, 5]);
    check(SHAPES, 6.0, [6, 32, 5]);
    check(BODY, 4.9, [6, 36, 5]);
}

/// Of cables that slide.
#[test]
fn sliding_cables_take_known_iterations() {
    let check = |scene, pull_mm, expect| check_strung(scene, pull_mm, Mechanics::Sliding, expect);
    check(TWO_DISCS, 5.0, [4, 53, 4]);
    check(TWO_DISCS, 12.0, [6, 272, 5]);
    check(ONE_DISC, 6.0, [4, 62, 4]);
    check(SHAPES, 6.0, [4, 62, 4]);
    check(BODY, 5.55, [5, 62, 4]);
}

/// Its own solution is where a problem's run ends at once: the multipliers come
/// back as they were.
#[test]
fn a_solution_is_its_own_start() {
    let goal = problem(TWO_DISCS, 5.0);
    let known = solve(&goal, Start::Straight, Settings::default());
    let again = solve(&goal, Start::From(&known), Settings::default());
    assert_eq!(again.turns, known.turns);
    assert!(
        again.events.is_empty() && again.iterations <= 2,
        "{}",
        again.iterations
    );
    assert_eq!(again.trace.len(), 1);
}

#[test]
fn a_warm_solve_allocates_nothing() {
    check_allocations(Mechanics::Equal);
    check_allocations(Mechanics::Sliding);
}

fn check_allocations(mechanics: Mechanics) {
    let near = strung(TWO_DISCS, 5.0, mechanics);
    let far = strung(TWO_DISCS, 5.05, mechanics);
    let mut moved = near.clone();
    let disc = near.obstacles()[0].moved(Vector::new(-5e-4, 0.0));
    moved.set_obstacle(0, disc);
    let mut run = Run::new(&near, Start::Straight, Settings::default());
    for goal in [&near, &far, &near, &moved, &near] {
        run.retarget(goal);
        run.finish();
    }
    let counted = allocation_counter::measure(|| {
        for goal in [&far, &near, &moved, &near] {
            run.retarget(goal);
            run.finish();
        }
    });
    assert_eq!(run.solution().status, Status::Converged);
    assert_eq!(counted.count_total, 0);
}
