//! Where the world's origin is and how its axes turn decides nothing: the same
//! robot far away has the same shape, and one that only touches a wall is told
//! so wherever it stands.

use sinew::equilibrium::{Occurrence, Settings, Solution, Solved, Start, Status, solve};
use sinew::geometry::Vector;
use sinew::mechanics::Problem;
use sinew::scene::{Candidates, Scene, Shape};

fn moved(scene: &Scene, by: [f64; 2]) -> Scene {
    let mut scene = scene.clone();
    let add = |[x, y]: [f64; 2]| [x + by[0], y + by[1]];
    scene.robot.base_mm = add(scene.robot.base_mm);
    for obstacle in &mut scene.obstacles {
        let anchor = obstacle.shape.anchor_mm();
        obstacle.shape.move_to_mm(add(anchor));
    }
    scene
}

fn solved(scene: &Scene) -> Solved {
    let problem = Problem::new(scene).unwrap();
    solve(&problem, Start::Straight, Settings::default())
}

fn events(solution: &Solution) -> Vec<(&'static str, f64)> {
    let events = solution.events.iter();
    let all = events.map(|event| (event.what.word(), event.pull));
    all.collect()
}

/// The shape relative to its base is the same to `tolerance`, in metres, and
/// so is all that is told of it.
#[track_caller]
fn check_same(near: &Solution, far: &Solution, tolerance: f64) {
    assert_eq!(near.status, far.status);
    let base = |solution: &Solution| solution.nodes[0].position;
    for (a, b) in near.nodes.iter().zip(&far.nodes) {
        let apart = (a.position - base(near)) - (b.position - base(far));
        assert!(apart.norm() < tolerance, "{}", apart.norm());
    }
    let (a, b) = (events(near), events(far));
    assert_eq!(a.len(), b.len(), "{a:?} {b:?}");
    for (a, b) in a.iter().zip(&b) {
        assert_eq!(a.0, b.0);
        assert!(
            (a.1 - b.1).abs() < 1e-3 * tolerance.max(1e-9),
            "{a:?} {b:?}"
        );
    }
    assert_eq!(near.contacts.len(), far.contacts.len());
    for (a, b) in near.contacts.iter().zip(&far.contacts) {
        assert_eq!(
            (a.line, a.node, a.obstacle, a.class),
            (b.line, b.node, b.obstacle, b.class)
        );
        assert!((a.multiplier - b.multiplier).abs() <= 1e-6 * a.multiplier);
        let apart = (a.point - base(near)) - (b.point - base(far));
        assert!(apart.norm() < tolerance);
    }
    assert_eq!(near.certificate.holds(), far.certificate.holds());
}

#[test]
fn a_robot_far_from_the_origin_has_the_same_shape() {
    let names = [
        "two-discs",
        "one-disc",
        "shapes",
        "wedge",
        "body-contact",
        "slip-off",
    ];
    for name in names {
        let path = format!("{}/assets/scenes/{name}.toml", env!("CARGO_MANIFEST_DIR"));
        let scene = Scene::from_toml(&std::fs::read_to_string(path).unwrap()).unwrap();
        let near = solved(&scene);
        for by in [
            [999_000.0, -999_000.0],
            [-999_000.0, 999_000.0],
            [123.4, 56.7],
        ] {
            // Coordinates of 1e6 mm are rounded to 1e-10 mm.
            check_same(&near, &solved(&moved(&scene, by)), 1e-10);
        }
    }
}

/// A robot of 1 mm, whose links at 999 m are no longer than 5e8 roundings of
/// their coordinates.
#[test]
fn so_does_one_that_is_small() {
    let mut scene = Scene::default();
    scene.robot.length_mm = 1.0;
    scene.robot.cable_offset_mm = Some(0.05);
    scene.set_pull_mm(0.05);
    let shape = Shape::Disc {
        center_mm: [0.25, 0.5],
        radius_mm: 0.07,
    };
    scene.obstacles.push(shape.into());
    let near = solved(&scene);
    assert_eq!(near.status, Status::Converged);
    assert!(!near.contacts.is_empty());
    let far = solved(&moved(&scene, [999_000.0, -999_000.0]));
    check_same(&near, &far, 1e-11);
}

#[test]
fn a_run_that_goes_on_far_away_tells_its_problem_in_the_world() {
    use sinew::equilibrium::Run;
    let scene = moved(
        &Scene::from_toml(include_str!("../assets/scenes/two-discs.toml")).unwrap(),
        [-999_000.0, 500_000.0],
    );
    let goal = Problem::new(&scene).unwrap();
    let mut start = goal.clone();
    start.set_pull(0.004);
    let mut run = Run::new(&start, Start::Straight, Settings::default());
    run.finish();
    run.retarget(&goal);
    run.finish();
    let (from, to) = (run.problem().obstacles(), goal.obstacles());
    for (a, b) in from.iter().zip(to) {
        assert!((a.position() - b.position()).norm() < 1e-12);
    }
    assert_eq!(run.problem().robot().base, goal.robot().base);
    check_same(&solved(&scene), run.solution(), 1e300);
    // From an earlier solution, and after the base was moved.
    let again = solve(&goal, Start::From(&run.solved()), Settings::default());
    assert_eq!(again.status, Status::Converged);
    let refused = |event: &sinew::equilibrium::Event| event.what == Occurrence::StartRefused;
    assert!(!again.events.iter().any(refused));
    let shifted = Problem::new(&moved(&scene, [3.0, 4.0])).unwrap();
    run.retarget(&shifted);
    run.finish();
    let tip = run.solution().tip().position - again.tip().position;
    assert!((tip - Vector::new(0.003, 0.004)).norm() < 1e-9);
}

/// A scene turned about the world's origin and then moved.
fn turned(scene: &Scene, degrees: f64, by: [f64; 2]) -> Scene {
    let (sine, cosine) = degrees.to_radians().sin_cos();
    let turn = |[x, y]: [f64; 2]| [cosine * x - sine * y, sine * x + cosine * y];
    let mut turned = scene.clone();
    turned.robot.base_mm = turn(scene.robot.base_mm);
    turned.robot.base_angle_deg += degrees;
    for obstacle in &mut turned.obstacles {
        let anchor = turn(obstacle.shape.anchor_mm());
        obstacle.shape.move_to_mm(anchor);
        if let Shape::Wall { rotation_deg, .. } = &mut obstacle.shape {
            *rotation_deg += degrees;
        }
    }
    moved(&turned, by)
}

#[test]
fn a_base_that_only_touches_a_wall_is_clear_of_it_wherever_it_stands() {
    let wall = |x: f64, angle: f64| Shape::Wall {
        point_mm: [x, 90.0],
        rotation_deg: angle,
        corner_radius_mm: 0.0,
    };
    // Beside the cable, beside the backbone, and of a body beside its far rim;
    // then a micrometre too near.
    for (candidates, touching, angle, inwards) in [
        (Candidates::Nodes, 8.0, 180.0, -1e-3),
        (Candidates::Nodes, 0.0, 0.0, 1e-3),
        (Candidates::Body, 8.0, 180.0, -1e-3),
        (Candidates::Body, -8.0, 0.0, 1e-3),
    ] {
        let mut scene = Scene::default();
        scene.contact.candidates = candidates;
        scene.set_pull_mm(3.0);
        scene.obstacles = vec![wall(touching, angle).into()];
        let here = solved(&scene);
        let mut near = scene.clone();
        near.obstacles = vec![wall(touching + inwards, angle).into()];
        for i in 0..24 {
            let degrees = 15.0 * f64::from(i) + 0.1;
            for by in [[0.0, 0.0], [37.3, -81.9], [-999_000.0, 700_000.0]] {
                let there = solved(&turned(&scene, degrees, by));
                assert_eq!(there.status, here.status, "{degrees} {by:?}");
                assert_eq!(events(&there).len(), events(&here).len());
                assert!(Problem::new(&turned(&near, degrees, by)).is_err());
            }
        }
    }
}
