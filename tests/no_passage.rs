//! Nothing passes through anything, whatever bends the robot: posts that the robot sweeps towards stay
//! on their side of it, and no point of a link is inside an obstacle, sampled
//! from outside the library's own tests for contact.

use sinew::equilibrium::{Occurrence, Settings, Solution, Solved, Start, Status, solve};
use sinew::geometry::{Vector, cross};
use sinew::mechanics::Problem;
use sinew::scene::{Candidates, Friction, Mechanics, Scene, Shape};

#[derive(Clone, Copy, Debug)]
enum Kind {
    Equal,
    Sliding,
    Rubbing,
}

fn body(kind: Kind, pull_mm: f64, shape: Shape) -> Option<(Problem, Solved)> {
    let mut scene = Scene::default();
    scene.model.mechanics = match kind {
        Kind::Equal => Mechanics::Equal,
        Kind::Sliding | Kind::Rubbing => Mechanics::Sliding,
    };
    if matches!(kind, Kind::Rubbing) {
        scene.friction = Friction {
            holes: 0.2,
            contacts: 0.3,
            base_loss: 0.1,
        };
    }
    scene.contact.candidates = Candidates::Body;
    scene.set_pull_mm(pull_mm);
    scene.obstacles.push(shape.into());
    let problem = Problem::new(&scene).ok()?;
    let solution = solve(&problem, Start::Straight, Settings::default());
    Some((problem, solution))
}

/// How deep any of 40 points a link lies inside the obstacle, in metres.
fn sampled_depth(problem: &Problem, solution: &Solution) -> f64 {
    let mut deepest = 0.0_f64;
    for pair in solution.nodes.windows(2) {
        for i in 0..=40 {
            let share = f64::from(i) / 40.0;
            let point = (1.0 - share) * pair[0].position + share * pair[1].position;
            let distance = problem.obstacles()[0].clearance(point).distance;
            deepest = deepest.max(-distance);
        }
    }
    deepest
}

/// Whether a point is to the right of the backbone: on the side it bends to.
fn is_right(solution: &Solution, point: Vector) -> bool {
    let nearest = solution.nodes.windows(2).min_by(|a, b| {
        let distance = |pair: &[sinew::robot::PlanarNode]| {
            (0.5 * (pair[0].position + pair[1].position) - point).norm()
        };
        distance(a).total_cmp(&distance(b))
    });
    let pair = nearest.unwrap();
    cross(
        pair[1].position - pair[0].position,
        point - pair[0].position,
    ) < 0.0
}

#[test]
fn thin_posts_stay_on_their_side() {
    posts_stay_on_their_side(Kind::Equal);
}

#[test]
fn thin_posts_stay_on_their_side_of_a_robot_whose_cable_slides() {
    posts_stay_on_their_side(Kind::Sliding);
}

#[test]
fn thin_posts_stay_on_their_side_of_a_robot_that_rubs() {
    posts_stay_on_their_side(Kind::Rubbing);
}

fn posts_stay_on_their_side(kind: Kind) {
    let mut pressed = 0;
    for i in 0..120 {
        // On the arc that the free robot sweeps, a little before its end.
        let share = 0.3 + 0.55 * f64::from(i % 40) / 40.0;
        let radius_mm = [0.001, 0.5, 2.0][i as usize / 40];
        let bend = 0.9 * share;
        let place = [
            10.0 + 180.0 * share * (0.55 * bend).sin(),
            180.0 * share * (0.5 * bend).cos(),
        ];
        let shape = Shape::Disc {
            center_mm: place,
            radius_mm,
        };
        let Some((problem, solution)) = body(kind, 8.0, shape) else {
            continue;
        };
        assert!(solution.certificate.holds(), "{place:?} {radius_mm}");
        assert!(
            sampled_depth(&problem, &solution) < 1e-9,
            "{place:?} {radius_mm}"
        );
        let jumped = solution
            .events
            .iter()
            .any(|event| matches!(event.what, Occurrence::Jump { .. }));
        if !jumped {
            let center = Vector::new(1e-3 * place[0], 1e-3 * place[1]);
            assert!(
                is_right(&solution, center),
                "{place:?} {radius_mm} {:?}",
                solution.status
            );
        }
        pressed += usize::from(!solution.contacts.is_empty());
    }
    assert!(pressed > 60, "{pressed}");
}

#[test]
fn bars_are_never_crossed() {
    for kind in [Kind::Equal, Kind::Sliding, Kind::Rubbing] {
        bars_are_not_crossed(kind);
    }
}

fn bars_are_not_crossed(kind: Kind) {
    for i in 0..60 {
        let turn = 6.0 * f64::from(i);
        let place = [-40.0 + 3.0 * f64::from(i), 60.0 + 1.5 * f64::from(i)];
        let shape = Shape::Capsule {
            center_mm: place,
            length_mm: 50.0,
            radius_mm: 1.0,
            rotation_deg: turn,
        };
        if let Some((problem, solution)) = body(kind, 8.0, shape) {
            assert!(
                solution.certificate.holds(),
                "{place:?} {:?}",
                solution.status
            );
            let depth = sampled_depth(&problem, &solution);
            let placed = solution.status == Status::Converged;
            assert!(depth < 1e-9 || !placed, "{place:?} {turn}: {depth}");
        }
    }
}

/// A bar right across the straight robot pushes it aside or is told to be
/// impossible; it is not overlooked.
#[test]
fn a_bar_across_the_straight_robot_is_seen() {
    for kind in [Kind::Equal, Kind::Sliding, Kind::Rubbing] {
        bar_across_is_seen(kind);
    }
}

fn bar_across_is_seen(kind: Kind) {
    let bar = Shape::Box {
        center_mm: [0.0, 125.0],
        size_mm: [60.0, 4.0],
        rotation_deg: 0.0,
        corner_radius_mm: 0.0,
    };
    let (problem, solution) = body(kind, 1.0, bar).unwrap();
    let pushed =
        |event: &sinew::equilibrium::Event| matches!(event.what, Occurrence::PushedAside { .. });
    assert!(solution.events.iter().any(pushed));
    if solution.status == Status::Converged {
        assert!(sampled_depth(&problem, &solution) < 1e-9);
    }
}
