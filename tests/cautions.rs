//! Cautions: each fires where its cause is there, with the right place and
//! size, and not where it is not. None changes a status or a shape.

use sinew::equilibrium::{Caution, Settings, Solved, Start, Status, solve};
use sinew::geometry::Vector;
use sinew::mechanics::Problem;
use sinew::robot::Line;
use sinew::scene::{Candidates, Line as NodeLine, Listed, Scene, Shape};

fn disc(center_mm: [f64; 2], radius_mm: f64) -> Shape {
    Shape::Disc {
        center_mm,
        radius_mm,
    }
}

fn scene(pull_mm: f64, shapes: &[Shape]) -> Scene {
    let mut scene = Scene::default();
    scene.set_pull_mm(pull_mm);
    scene.obstacles = shapes.iter().cloned().map(Into::into).collect();
    scene
}

/// The certified shape and its cautions.
#[track_caller]
fn found(scene: &Scene) -> (Problem, Solved, Vec<Caution>) {
    let problem = Problem::new(scene).unwrap();
    let solution = solve(&problem, Start::Straight, Settings::default());
    assert_eq!(solution.status, Status::Converged);
    let cautions = Caution::all(&solution);
    (problem, solution, cautions)
}

#[track_caller]
fn check(scene: &Scene, expect: &[Caution]) {
    assert_eq!(found(scene).2, expect);
}

fn with(scene: &Scene, candidates: Candidates) -> Scene {
    let mut scene = scene.clone();
    scene.contact.candidates = candidates;
    scene
}

#[test]
fn a_pin_that_slips_in_between_the_nodes_is_told() {
    let pin = scene(6.3, &[disc([30.0, 105.0], 0.5)]);
    let (_, solution, cautions) = found(&pin);
    assert!(solution.contacts.is_empty());
    let expect = Caution::Encloses {
        node: 12,
        obstacle: 0,
    };
    assert_eq!(cautions, [expect]);
    // It is nearer to the backbone link than to anything else, on its cable's
    // side, and past the cable link.
    let side = |lever: f64| {
        let (a, b) = (solution.nodes[11].at(lever), solution.nodes[12].at(lever));
        let along = (b - a).normalize();
        let away = Vector::new(0.030, 0.105) - a;
        along.x * away.y - along.y * away.x
    };
    assert!(side(0.0) < -0.5e-3 && side(0.008) > 0.5e-3);
    // The whole body stops at it.
    check(&with(&pin, Candidates::Body), &[]);
}

/// The depth of the deepest point of a segment in a disc, by its distance.
fn depth(a: Vector, b: Vector, center: Vector, radius: f64) -> f64 {
    let share = ((center - a).dot(&(b - a)) / (b - a).norm_squared()).clamp(0.0, 1.0);
    radius - (center - a - share * (b - a)).norm()
}

#[test]
fn a_link_that_cuts_an_obstacle_is_told_with_its_depth() {
    let post = scene(6.0, &[disc([30.0, 105.0], 12.0)]);
    let (_, solution, cautions) = found(&post);
    let [
        Caution::Crosses {
            line: Line::CableLink,
            node: 12,
            obstacle: 0,
            depth: told,
        },
    ] = cautions[..]
    else {
        panic!("{cautions:?}");
    };
    let (a, b) = (solution.nodes[11].at(0.008), solution.nodes[12].at(0.008));
    let right = depth(a, b, Vector::new(0.030, 0.105), 0.012);
    assert!((told - right).abs() < 1e-12, "{told} {right}");
    // Both ends of the chord rest on the disc: it is as deep as its sagitta.
    let half = 0.5 * (b - a).norm();
    let sagitta = 0.012 - (0.012f64.powi(2) - half * half).sqrt();
    assert!((told - sagitta).abs() < 1e-9, "{told} {sagitta}");
    check(&with(&post, Candidates::Body), &[]);
    // A disc so large that the chord hardly leaves it.
    check(&scene(4.0, &[disc([130.0, 105.0], 110.0)]), &[]);
}

#[test]
fn disks_rims_and_nodes_that_no_candidate_sees_are_told() {
    // On the far side, where only the disks' rims reach; node 8 has one.
    let rim = scene(0.5, &[disc([-7.0, 80.0], 4.0)]);
    let told = found(&rim).2;
    assert!(
        matches!(
            told[..],
            [Caution::Crosses {
                line: Line::RimFarSide | Line::DiskFace,
                node: 8,
                obstacle: 0,
                ..
            }]
        ),
        "{told:?}"
    );
    // Of the listed nodes' robot everything else passes through.
    let mut listed = with(
        &scene(8.0, &[disc([40.0, 100.0], 12.0)]),
        Candidates::Listed,
    );
    listed.contact.listed = vec![Listed {
        line: NodeLine::Backbone,
        cable: 0,
        node: 2,
    }];
    assert!(matches!(
        found(&listed).2[..],
        [Caution::Crosses { obstacle: 0, .. }]
    ));
    // A bar through the first disk, which cannot move.
    let bar = Shape::Capsule {
        center_mm: [-4.0, 0.0],
        length_mm: 10.0,
        radius_mm: 0.5,
        rotation_deg: 90.0,
    };
    let told = found(&scene(5.0, &[bar])).2;
    assert!(
        matches!(
            told[..],
            [Caution::Crosses {
                line: Line::DiskFace,
                node: 0,
                ..
            }]
        ),
        "{told:?}"
    );
}

#[test]
fn a_cable_that_would_have_to_push_is_told() {
    check(&scene(5.0, &[]), &[]);
    check(&scene(1e-6, &[]), &[]);
    check(&scene(0.0, &[]), &[]);
    check(&scene(-1e-3, &[]), &[Caution::CablePushes]);
    check(&scene(-5.0, &[]), &[Caution::CablePushes]);
}

#[test]
fn a_robot_that_coils_through_itself_is_told() {
    let coils = |pull: f64| {
        let told = found(&scene(pull, &[])).2;
        assert!(told.iter().all(|one| matches!(one, Caution::Coils { .. })));
        !told.is_empty()
    };
    // β = 2 asin(l/2na): 18 β is a whole turn at l = 288 sin 10°, where the
    // tip's disk lies on the first.
    let whole = 288.0 * 10f64.to_radians().sin();
    assert!(!coils(whole - 0.05));
    assert!(coils(whole));
    assert!(coils(whole + 0.05));
    // Two turns, one exactly on the other.
    assert!(coils(288.0 * 20f64.to_radians().sin()));
    assert!(coils(120.0));
    // Wide rims meet on the inside of a bend at which the cable still clears.
    let mut wide = scene(40.0, &[]);
    assert!(found(&wide).2.is_empty());
    wide.robot.disk_radius_mm = Some(40.0);
    assert!(!found(&wide).2.is_empty());
}

#[test]
fn a_long_robot_is_looked_at_in_no_time() {
    // Two turns of 20 000 segments: 10⁹ pairs, if every pair were looked at.
    let mut long = scene(0.0, &[]);
    long.robot.length_mm = 2000.0;
    long.robot.segments = 20_000;
    long.set_pull_mm(40.0);
    let problem = Problem::new(&long).unwrap();
    let solution = solve(&problem, Start::Direct, Settings::default());
    let slope = solution.nodes[0].angle - solution.tip().angle;
    assert!((4.9..5.1).contains(&slope), "{slope}");
    assert!(Caution::all(&solution).is_empty());
}

#[test]
fn a_caution_says_what_and_where_and_what_helps() {
    let name = |index: usize| format!("obstacle {index}");
    let crossing = Caution::Crosses {
        line: Line::CableLink,
        node: 12,
        obstacle: 3,
        depth: 0.000_42,
    };
    assert_eq!(
        crossing.sentence(name),
        "the cable between nodes 11 and 12 is 0.42 mm inside obstacle 3, where the contact \
         candidates do not see it"
    );
    assert_eq!(crossing.remedy(), Some("contact.candidates = \"body\""));
    assert_eq!(Caution::CablePushes.remedy(), None);
}
