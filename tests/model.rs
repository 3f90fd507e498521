//! What a scene becomes: the size of every shape, what may not stand over the
//! base, which problems are alike, and how near the parts of a robot are.

use sinew::equilibrium::{Settings, Start, solve};
use sinew::geometry::{Core, Obstacle, Vector};
use sinew::mechanics::{Equal, Mechanics, Problem};
use sinew::robot::Line;
use sinew::scene::{Candidates, Listed, Scene, Shape};
use sinew::solver::Chain;

fn scene(shapes: &[Shape]) -> Scene {
    let mut scene = Scene::default();
    scene.set_pull_mm(0.0);
    scene.obstacles = shapes.iter().cloned().map(Into::into).collect();
    scene
}

fn body(shapes: &[Shape]) -> Scene {
    let mut scene = scene(shapes);
    scene.contact.candidates = Candidates::Body;
    scene.robot.disk_radius_mm = Some(12.0);
    scene.robot.disk_thickness_mm = 2.0;
    scene.robot.cable_diameter_mm = 1.0;
    scene
}

fn disc(x: f64, y: f64, radius_mm: f64) -> Shape {
    Shape::Disc {
        center_mm: [x, y],
        radius_mm,
    }
}

/// How far the obstacle of a shape around (100, 200) mm reaches towards a
/// direction, in mm.
fn reach(shape: &Shape, degrees: f64) -> f64 {
    let problem = Problem::new(&scene(std::slice::from_ref(shape))).unwrap();
    let (sine, cosine) = degrees.to_radians().sin_cos();
    let direction = Vector::new(cosine, sine);
    let support = problem.obstacles()[0].support(direction).unwrap();
    1e3 * (support - direction.dot(&Vector::new(0.1, 0.2)))
}

fn check_reach(shape: &Shape, expected: &[(f64, f64)]) {
    for (degrees, expected) in expected {
        let found = reach(shape, *degrees);
        assert!(
            (found - expected).abs() < 1e-9,
            "{shape:?} {degrees}: {found}"
        );
    }
}

#[test]
fn shapes_reach_as_far_as_they_are_described() {
    let center_mm = [100.0, 200.0];
    check_reach(&disc(100.0, 200.0, 7.0), &[(0.0, 7.0), (33.0, 7.0)]);
    let half = std::f64::consts::FRAC_1_SQRT_2;
    let block = |size_mm, corner_radius_mm, rotation_deg| Shape::Box {
        center_mm,
        size_mm,
        rotation_deg,
        corner_radius_mm,
    };
    check_reach(
        &block([20.0, 10.0], 0.0, 0.0),
        &[(0.0, 10.0), (90.0, 5.0), (45.0, 15.0 * half)],
    );
    let rounded = 11.0 * half + 2.0;
    for (turn, along) in [(0.0, 0.0), (90.0, 90.0), (30.0, 30.0)] {
        let shape = block([20.0, 10.0], 2.0, turn);
        let expected = [(along, 10.0), (along + 90.0, 5.0), (along + 45.0, rounded)];
        check_reach(&shape, &expected);
    }
    // Corners that take the whole width, the whole height, or both.
    check_reach(
        &block([20.0, 10.0], 5.0, 0.0),
        &[(0.0, 10.0), (90.0, 5.0), (45.0, 5.0 * half + 5.0)],
    );
    check_reach(
        &block([10.0, 20.0], 5.0, 0.0),
        &[(0.0, 5.0), (90.0, 10.0), (45.0, 5.0 * half + 5.0)],
    );
    check_reach(
        &block([10.0, 10.0], 5.0, 0.0),
        &[(0.0, 5.0), (45.0, 5.0), (90.0, 5.0)],
    );
    let capsule = Shape::Capsule {
        center_mm,
        length_mm: 20.0,
        radius_mm: 3.0,
        rotation_deg: 90.0,
    };
    check_reach(
        &capsule,
        &[(90.0, 13.0), (0.0, 3.0), (45.0, 10.0 * half + 3.0)],
    );
    let triangle = Shape::Polygon {
        points_mm: vec![[90.0, 190.0], [120.0, 200.0], [100.0, 230.0]],
        rotation_deg: 0.0,
        corner_radius_mm: 1.5,
    };
    check_reach(
        &triangle,
        &[(0.0, 21.5), (90.0, 31.5), (180.0, 11.5), (270.0, 11.5)],
    );
    let wall = Shape::Wall {
        point_mm: center_mm,
        rotation_deg: 200.0,
        corner_radius_mm: 2.5,
    };
    check_reach(&wall, &[(200.0, 2.5)]);
}

/// Just clear of the first disk is fine, and just over it is not.
#[test]
fn nothing_may_stand_over_the_base() {
    let check = |make: &dyn Fn(f64) -> Scene| {
        assert_eq!(Problem::faults(&make(1e-6)), []);
        let faults = Problem::faults(&make(-1e-6));
        assert_eq!(faults.len(), 1);
        assert!(faults[0].to_string().contains("covers the robot's base"));
        assert!(Problem::new(&make(-1e-6)).is_err());
    };
    // The two points of the first disk.
    check(&|gap| scene(&[disc(8.0, -10.0 - gap, 10.0)]));
    check(&|gap| scene(&[disc(-10.0 - gap, 0.0, 10.0)]));
    // Its rims, a thickness of half of 2 mm around them, and its face.
    check(&|gap| body(&[disc(18.0 + gap, 0.0, 5.0)]));
    check(&|gap| body(&[disc(-18.0 - gap, 0.0, 5.0)]));
    check(&|gap| body(&[disc(4.0, -3.0 - gap, 2.0)]));
    // A bar that ends just beside the disk, seen from its end.
    let bar = |gap: f64| Shape::Box {
        center_mm: [23.0 + gap, 0.0],
        size_mm: [20.0, 1.0],
        rotation_deg: 0.0,
        corner_radius_mm: 0.0,
    };
    check(&|gap| body(&[bar(gap)]));
    // Right across it.
    let across = Shape::Box {
        center_mm: [4.0, 0.0],
        size_mm: [1.0, 40.0],
        rotation_deg: 0.0,
        corner_radius_mm: 0.0,
    };
    assert_eq!(
        Problem::faults(&body(std::slice::from_ref(&across))).len(),
        1
    );
    assert_eq!(Problem::faults(&scene(std::slice::from_ref(&across))), []);
    let mut listed = scene(&[disc(8.0, 0.0, 10.0)]);
    listed.contact.candidates = Candidates::Listed;
    listed.contact.listed = vec![Listed {
        line: sinew::scene::Line::Backbone,
        cable: 0,
        node: 9,
    }];
    let problem = Problem::new(&listed).unwrap();
    assert_eq!(problem.candidates().len(), 1);
    let candidate = problem.candidates()[0];
    assert_eq!((candidate.line, candidate.node), (Line::Backbone, 9));
    assert_eq!(candidate.lever(), 0.0);
}

#[test]
fn problems_are_alike_or_not() {
    let here = Problem::new(&scene(&[disc(40.0, 100.0, 10.0)])).unwrap();
    let check = |other: &Problem, resembles: bool, in_pull: bool| {
        assert_eq!(here.resembles(other), resembles);
        assert_eq!(other.resembles(&here), resembles);
        assert_eq!(here.same_but_for_pull(other), in_pull);
        assert_eq!(other.same_but_for_pull(&here), in_pull);
    };
    let of = |scene: &Scene| Problem::new(scene).unwrap();
    check(&here, true, true);
    let mut pulled = here.clone();
    pulled.set_pull(1e-3);
    check(&pulled, true, true);
    check(&of(&scene(&[disc(41.0, 100.0, 10.0)])), true, false);
    check(&of(&scene(&[disc(40.0, 100.0, 11.0)])), true, false);
    check(&of(&scene(&[])), false, false);
    check(
        &of(&scene(&[disc(40.0, 100.0, 10.0), disc(90.0, 100.0, 10.0)])),
        false,
        false,
    );
    let wall = Shape::Wall {
        point_mm: [60.0, 100.0],
        rotation_deg: 180.0,
        corner_radius_mm: 0.0,
    };
    check(&of(&scene(std::slice::from_ref(&wall))), false, false);
    let mut longer = scene(&[disc(40.0, 100.0, 10.0)]);
    longer.robot.length_mm += 1.0;
    check(&of(&longer), false, false);
    let mut listed = scene(&[disc(40.0, 100.0, 10.0)]);
    listed.contact.candidates = Candidates::Body;
    check(&of(&listed), false, false);
}

/// A wall that turns changes by what a metre of it sweeps.
#[test]
fn a_wall_changes_with_its_angle() {
    let wall = |angle| Obstacle::new(Core::HalfPlane, 0.0, Vector::zeros(), angle);
    assert!((wall(0.1).change(&wall(0.4)) - 0.3).abs() < 1e-15);
    assert_eq!(wall(0.1).change(&wall(0.1)), 0.0);
}

/// By the straight robot, where distances are told by hand, in mm.
#[test]
fn clearances_of_points_links_and_what_crosses_them() {
    let check = |shape: Shape, line: Line, node: usize, expected: Option<f64>| {
        let problem = Equal::new(Problem::new(&body(&[shape])).unwrap());
        let mut nodes = vec![problem.base()];
        for k in 1..=problem.stages() {
            let straight = problem.free_controls()[0];
            nodes.push(problem.stage(k, &nodes[k - 1], &straight).0);
        }
        let candidates = problem.candidates().iter();
        let mut found = candidates.filter(|c| c.line == line && c.node == node);
        let mut least: Option<f64> = None;
        let obstacle = &problem.obstacles()[0];
        found
            .next()
            .unwrap()
            .clearances(&nodes, obstacle, |_, clearance| {
                least = Some(least.map_or(clearance, |least| least.min(clearance)));
            });
        match (least, expected) {
            (Some(found), Some(expected)) => {
                assert!((1e3 * found - expected).abs() < 1e-9, "{line:?}: {found}");
            }
            (found, expected) => assert_eq!(found, expected, "{line:?}"),
        }
    };
    let beside = || disc(30.0, 95.0, 5.0);
    check(
        beside(),
        Line::Cable,
        10,
        Some((22.0_f64 * 22.0 + 25.0).sqrt() - 5.5),
    );
    check(beside(), Line::CableLink, 10, Some(16.5));
    check(beside(), Line::BackboneLink, 10, Some(25.0));
    check(beside(), Line::CableLink, 11, None);
    check(
        beside(),
        Line::RimCableSide,
        10,
        Some((18.0_f64 * 18.0 + 25.0).sqrt() - 6.0),
    );
    check(disc(4.0, 105.0, 1.0), Line::DiskFace, 10, Some(3.0));
    // A bar across the link reaches 26 mm beyond it, and the link is half a
    // millimetre thick on each side.
    let bar = Shape::Box {
        center_mm: [4.0, 95.0],
        size_mm: [60.0, 2.0],
        rotation_deg: 0.0,
        corner_radius_mm: 0.0,
    };
    check(bar, Line::CableLink, 10, Some(-26.5));
}

/// A disk that turns on the spot sweeps its rims over a needle.
#[test]
fn a_rim_that_turns_into_a_needle_does_not_pass_it() {
    let problem = Equal::new(Problem::new(&body(&[disc(12.0, 178.0, 0.01)])).unwrap());
    let mut nodes = vec![problem.base()];
    for k in 1..=problem.stages() {
        let straight = problem.free_controls()[0];
        nodes.push(problem.stage(k, &nodes[k - 1], &straight).0);
    }
    let mut turned = nodes.clone();
    let tip = turned.last_mut().unwrap();
    tip.angle = -0.4;
    tip.disk = Vector::new(tip.angle.cos(), tip.angle.sin());
    assert!(
        problem
            .around()
            .motion_passes(problem.around(), &nodes, &turned)
    );
    assert!(problem.passes_through(&nodes, &turned));
    assert!(!problem.passes_through(&turned, &turned));
    assert!(
        !problem
            .around()
            .motion_passes(problem.around(), &nodes, &nodes)
    );
    let away = Problem::new(&body(&[disc(12.0, 150.5, 0.01)])).unwrap();
    assert!(!away.around().motion_passes(away.around(), &nodes, &turned));
}

/// Every pair of a candidate and an obstacle once, with the force between them.
#[test]
fn clearances_carry_the_multipliers_of_their_own_contacts() {
    let text = include_str!("../assets/scenes/two-discs.toml");
    let problem = Problem::new(&Scene::from_toml(text).unwrap()).unwrap();
    let solution = solve(&problem, Start::Straight, Settings::default());
    assert_eq!(solution.contacts.len(), 2);
    let all = solution.clearances();
    assert_eq!(all.len(), problem.candidates().len() * 2);
    for (index, clearance) in all.iter().enumerate() {
        let pair = (clearance.candidate, clearance.obstacle);
        assert_eq!(pair, (index / 2, index % 2));
        let mut contacts = solution.contacts.iter();
        let contact = contacts.find(|c| (c.candidate, c.obstacle) == pair);
        assert_eq!(clearance.multiplier, contact.map_or(0.0, |c| c.multiplier));
        assert_eq!(clearance.clearance.abs() < 1e-9, contact.is_some());
    }
}
