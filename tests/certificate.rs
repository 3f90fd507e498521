//! For every condition of the certificate a shape made wrong by hand in just
//! that respect: that condition fails and no other.

mod one_segment;

use one_segment::{BACKBONE, CABLE, OFFSET, OneSegment, Points};
use sinew::contact::Contact;
use sinew::equilibrium::{Settings, Solved, Start, Status, solve};
use sinew::geometry::{Core, Obstacle, Vector, perpendicular};
use sinew::mechanics::{Certificate, Certifier, Condition, ConditionKind};
use sinew::mechanics::{Equal, Mechanics, Problem};
use sinew::robot::PlanarNode;
use sinew::scene::{Candidates, Scene, Shape};
use sinew::solver::{Chain, Control};

fn scene(text: &str, pull_mm: f64) -> Scene {
    let mut scene = Scene::from_toml(text).unwrap();
    scene.set_pull_mm(pull_mm);
    scene
}

const FREE: &str = include_str!("../assets/scenes/free.toml");
const ONE_DISC: &str = include_str!("../assets/scenes/one-disc.toml");
const TWO_DISCS: &str = include_str!("../assets/scenes/two-discs.toml");
const LOAD_CELL: &str = include_str!("../assets/scenes/load-cell.toml");
const BODY: &str = include_str!("../assets/scenes/body-contact.toml");

/// A problem with its equilibrium, which is certified.
fn solved(scene: &Scene) -> (Problem, Solved) {
    let problem = Problem::new(scene).unwrap();
    let solution = solve(&problem, Start::Straight, Settings::default());
    assert_eq!(solution.status, Status::Converged);
    let points = points(&solution.nodes, problem.robot().offset);
    assert_eq!(failed(&problem, &points, &solution.contacts), [""; 0]);
    let free = problem.obstacles().is_empty();
    assert_eq!(solution.contacts.is_empty(), free);
    (problem, solution)
}

fn points(nodes: &[PlanarNode], offset: f64) -> Points {
    let points = nodes.iter().map(|node| (node.position, node.at(offset)));
    points.collect()
}

fn certify(problem: &Problem, points: &Points, contacts: &[Contact]) -> Certificate {
    Certifier::default().certify(problem, points.iter().copied(), contacts)
}

/// The conditions that fail, by name.
fn failed(problem: &Problem, points: &Points, contacts: &[Contact]) -> Vec<&'static str> {
    let certificate = certify(problem, points, contacts);
    let residuals: Vec<f64> = [
        Condition::Stationarity,
        Condition::Links,
        Condition::Penetration,
        Condition::Complementarity,
        Condition::Dual,
    ]
    .map(|residual| certificate.get(residual).unwrap())
    .to_vec();
    let greatest = residuals.into_iter().fold(0.0, f64::max);
    assert_eq!(certificate.residual(), greatest);
    assert_eq!(certificate.conditions().count(), 7);
    let failed: Vec<_> = certificate
        .conditions()
        .filter(|(condition, value)| match condition.kind() {
            ConditionKind::Residual => *value > Condition::BOUND,
            ConditionKind::YesOrNo(_) => *value == 0.0,
        })
        .map(|(condition, _)| condition.key())
        .collect();
    assert_eq!(certificate.holds(), failed.is_empty(), "{certificate:?}");
    failed
}

#[track_caller]
fn value(of: Condition, certificate: Certificate) -> f64 {
    certificate.get(of).unwrap()
}

fn is_minimum(problem: &Problem, points: &Points, contacts: &[Contact]) -> bool {
    value(Condition::Minimum, certify(problem, points, contacts)) == 1.0
}

#[track_caller]
fn close(found: f64, expected: f64, relative: f64) {
    assert!(
        (found - expected).abs() <= relative * expected.abs(),
        "{found:e} is not {expected:e}"
    );
}

/// A wrong multiplier, a contact that is not told, a segment turned by hand:
/// forces that do not balance, on points, links and disks.
#[test]
fn forces_that_do_not_balance_are_not_stationary() {
    for scene in [
        scene(ONE_DISC, 6.0),
        scene(TWO_DISCS, 5.0),
        scene(LOAD_CELL, 5.0),
        scene(BODY, 4.9),
        on_a_link(),
        on_a_disk(),
    ] {
        let (problem, solution) = solved(&scene);
        let points = points(&solution.nodes, problem.robot().offset);
        for index in 0..solution.contacts.len() {
            let mut contacts = solution.contacts.clone();
            contacts[index].multiplier *= 1.001;
            assert_eq!(failed(&problem, &points, &contacts), ["stationarity"]);
            contacts.remove(index);
            assert_eq!(failed(&problem, &points, &contacts), ["stationarity"]);
        }
    }
    let problem = Problem::new(&scene(FREE, 5.0)).unwrap();
    for turned in 0..problem.robot().segments {
        let mut controls = Equal::new(problem.clone()).free_controls();
        controls[turned][0] = 1e-6;
        let points = points(&rolled_out(&problem, &controls), 0.008);
        assert_eq!(failed(&problem, &points, &[]), ["stationarity"]);
    }
}

fn rolled_out(problem: &Problem, controls: &[Control<1>]) -> Vec<PlanarNode> {
    let problem = Equal::new(problem.clone());
    let mut nodes = vec![problem.base()];
    for (k, control) in controls.iter().enumerate() {
        nodes.push(problem.stage(k + 1, &nodes[k], control).0);
    }
    nodes
}

/// The robot's body on a post between two nodes.
fn on_a_link() -> Scene {
    let mut scene = scene(BODY, 4.0);
    scene.robot.disk_radius_mm = None;
    scene.robot.segments_per_bay = 18;
    scene.obstacles.truncate(1);
    scene.obstacles[0].shape = Shape::Disc {
        center_mm: [25.0, 95.0],
        radius_mm: 8.0,
    };
    scene
}

/// The flat face of a wide disk on a pin.
fn on_a_disk() -> Scene {
    let mut scene = scene(BODY, 8.0);
    scene.robot.disk_radius_mm = Some(40.0);
    scene.robot.segments_per_bay = 18;
    scene.obstacles.truncate(1);
    scene.obstacles[0].shape = Shape::Disc {
        center_mm: [93.9, 127.9],
        radius_mm: 3.0,
    };
    scene
}

/// The arc of another robot keeps the balance of forces and the signs: only
/// the lengths are wrong, and the certificate tells by how much.
#[test]
fn links_and_disks_of_another_length_are_seen() {
    let mine = Problem::new(&scene(FREE, 5.0)).unwrap();
    let check = |edit: &dyn Fn(&mut Scene), error_mm: f64| {
        let mut other = scene(FREE, 5.0);
        edit(&mut other);
        let other = Problem::new(&other).unwrap();
        let nodes = rolled_out(&other, &Equal::new(other.clone()).free_controls());
        let points = points(&nodes, other.robot().offset);
        assert_eq!(failed(&mine, &points, &[]), ["links"]);
        close(
            value(Condition::Links, certify(&mine, &points, &[])),
            error_mm / 180.0,
            1e-6,
        );
    };
    let each = 1e-3 / 18.0;
    for sign in [1.0, -1.0] {
        let backbone = |scene: &mut Scene| {
            scene.robot.length_mm += sign * 1e-3;
            scene.set_pull_mm(scene.pull_mm() + sign * 1e-3);
        };
        check(&backbone, each);
        check(
            &|scene| scene.set_pull_mm(scene.pull_mm() + sign * 1e-3),
            each,
        );
        check(
            &|scene| scene.set_offset_mm(scene.offset_mm() + sign * 1e-3),
            1e-3,
        );
    }
}

/// Obstacles over the straight robot, which has no energy and needs no
/// contact: each part of the body in one by a known depth.
#[test]
fn every_part_inside_an_obstacle_is_seen() {
    let check = |shape: Shape, edit: &dyn Fn(&mut Scene), depth_mm: f64| {
        let mut scene = scene(FREE, 0.0);
        scene.robot.backbone_diameter_mm = 0.0;
        scene.robot.cable_diameter_mm = 0.0;
        scene.robot.disk_thickness_mm = 0.0;
        edit(&mut scene);
        scene.obstacles.push(shape.into());
        let problem = Problem::new(&scene).unwrap();
        let points = points(
            &rolled_out(&problem, &Equal::new(problem.clone()).free_controls()),
            0.008,
        );
        let depth = value(Condition::Penetration, certify(&problem, &points, &[]));
        close(depth, depth_mm / 180.0, 1e-9);
        assert_eq!(failed(&problem, &points, &[]), ["penetration"]);
    };
    let disc = |x, y, radius_mm| Shape::Disc {
        center_mm: [x, y],
        radius_mm,
    };
    let nodes = |_: &mut Scene| {};
    check(disc(20.0, 100.0, 13.0), &nodes, 1.0);
    check(disc(-20.0, 100.0, 21.0), &nodes, 1.0);
    let wall = Shape::Wall {
        point_mm: [7.0, 90.0],
        rotation_deg: 180.0,
        corner_radius_mm: 0.0,
    };
    let listed = |scene: &mut Scene| {
        scene.contact.candidates = Candidates::Listed;
        scene.contact.listed = scene_listed();
    };
    check(wall, &listed, 1.0);
    let body = |scene: &mut Scene| {
        scene.contact.candidates = Candidates::Body;
        scene.robot.disk_radius_mm = Some(12.0);
    };
    let thick = |scene: &mut Scene| {
        body(scene);
        scene.robot.cable_diameter_mm = 1.0;
        scene.robot.disk_thickness_mm = 2.0;
    };
    // The cable's link: its nodes are farther away.
    let links = |scene: &mut Scene| {
        thick(scene);
        scene.robot.segments_per_bay = 18;
    };
    check(disc(20.0, 95.0, 11.9), &links, 0.4);
    check(disc(-20.0, 95.0, 20.3), &links, 0.3);
    // A disk's rims, then its face from above.
    check(disc(20.0, 100.0, 8.3), &body, 0.3);
    check(disc(-20.0, 100.0, 8.3), &body, 0.3);
    check(disc(4.0, 100.3, 0.5), &body, 0.2);
    check(disc(-4.0, 101.3, 0.5), &thick, 0.2);
    // A bar right across both links: half a link along them is the shortest way
    // out.
    let bar = Shape::Box {
        center_mm: [4.0, 96.0],
        size_mm: [60.0, 2.0],
        rotation_deg: 0.0,
        corner_radius_mm: 0.0,
    };
    check(bar, &body, 5.0);
}

/// The base is not among what may touch: a scene whose obstacles cover it is
/// refused, and one that is dragged over it on the way to a clear place is not the
/// shape's fault.
#[test]
fn an_obstacle_over_the_base_alone_is_not_the_shapes() {
    let mut scene = scene(BODY, 0.0);
    let base_mm = scene.robot.base_mm;
    scene.obstacles.truncate(1);
    let mut problem = Problem::new(&scene).unwrap();
    let at = Vector::from(base_mm.map(|mm| 1e-3 * mm));
    let points = points(
        &rolled_out(&problem, &Equal::new(problem.clone()).free_controls()),
        0.008,
    );
    let disc = |height: f64| {
        let middle = at + Vector::new(0.0, height);
        Obstacle::new(Core::Point, 3e-3, middle, 0.0)
    };
    // Below the base, and reaching over its backbone point by 1 mm.
    problem.set_obstacle(0, disc(-2e-3));
    assert_eq!(failed(&problem, &points, &[]), [""; 0]);
    problem.set_obstacle(0, disc(4e-3));
    assert_eq!(failed(&problem, &points, &[]), ["penetration"]);
}

fn scene_listed() -> Vec<sinew::scene::Listed> {
    Scene::from_toml(LOAD_CELL).unwrap().contact.listed
}

/// An obstacle that has been taken away still presses: by how much the force
/// acts through the gap is the residual.
#[test]
fn a_force_across_a_gap_is_seen() {
    let gap = 1e-5;
    for text in [ONE_DISC, TWO_DISCS, LOAD_CELL, BODY] {
        let (problem, solution) = solved(&scene(text, 6.0));
        let points = points(&solution.nodes, problem.robot().offset);
        let most = solution.contacts.iter().map(|c| c.multiplier);
        let most = most.fold(0.0, f64::max);
        for (index, contact) in solution.contacts.iter().enumerate() {
            let mut moved = problem.clone();
            let obstacle = &problem.obstacles()[contact.obstacle];
            moved.set_obstacle(contact.obstacle, obstacle.moved(-gap * contact.normal));
            let mut contacts = solution.contacts.clone();
            contacts[index].clearance = gap;
            assert_eq!(failed(&moved, &points, &contacts), ["complementarity"]);
            let residual = value(
                Condition::Complementarity,
                certify(&moved, &points, &contacts),
            );
            close(residual, contact.multiplier / most * gap / 0.18, 1e-6);
        }
    }
}

/// The certificate does not take anybody's word for it: an obstacle that has
/// been taken away, a force along no normal of the obstacle, one beside where a
/// link touches. What else there is balances in each.
#[test]
fn a_force_where_nothing_touches_is_seen() {
    for text in [ONE_DISC, LOAD_CELL, BODY] {
        let (mut problem, solution) = solved(&scene(text, 6.0));
        let points = points(&solution.nodes, problem.robot().offset);
        let contact = solution.contacts[0];
        let away = problem.obstacles()[contact.obstacle].moved(-1e-5 * contact.normal);
        problem.set_obstacle(contact.obstacle, away);
        assert_eq!(
            failed(&problem, &points, &solution.contacts),
            ["complementarity"]
        );
    }
    let mut on_post = OneSegment::new(1.3e-3, [1.0, 1.0]);
    let right = on_post.hold();
    let (sine, cosine) = 0.1_f64.sin_cos();
    let normal = cosine * right.normal + sine * perpendicular(right.normal);
    let slanted = Contact {
        normal,
        multiplier: on_post.energy_rate / on_post.cable_rate.dot(&normal),
        ..right
    };
    let failed_now = failed(&on_post.problem, &on_post.points, &[slanted]);
    assert_eq!(failed_now, ["complementarity"]);

    let mut on_post = OneSegment::new(1.3e-3, [1.0, 1.0]);
    let right = on_post.hold_link();
    assert_eq!(failed(&on_post.problem, &on_post.points, &[right]), [""; 0]);
    let beside = Contact {
        along: 0.8,
        multiplier: right.multiplier * right.along / 0.8,
        ..right
    };
    let failed_now = failed(&on_post.problem, &on_post.points, &[beside]);
    assert_eq!(failed_now, ["complementarity"]);
}

/// A wall on the other side of the one node that it may touch would have to
/// pull: everything but the sign is right.
#[test]
fn a_contact_that_pulls_is_seen() {
    let (problem, solution) = solved(&scene(LOAD_CELL, 5.0));
    let points = points(&solution.nodes, problem.robot().offset);
    let [contact] = solution.contacts[..] else {
        panic!("{:?}", solution.contacts)
    };
    let behind = contact.normal;
    let angle = (-behind.y).atan2(-behind.x);
    let wall = Obstacle::new(Core::HalfPlane, 0.0, contact.point, angle);
    let mut pulled = problem.clone();
    pulled.set_obstacle(0, wall);
    let pulls = Contact {
        normal: -behind,
        multiplier: -contact.multiplier,
        ..contact
    };
    assert_eq!(failed(&pulled, &points, &[pulls]), ["dual"]);
    close(
        value(Condition::Dual, certify(&pulled, &points, &[pulls])),
        1.0,
        1e-12,
    );
}

#[test]
fn a_flipped_or_crossed_segment_is_seen() {
    for along in [1.3e-3, -2.5e-3] {
        let mut right = OneSegment::new(along, [1.0, 1.0]);
        let contact = right.hold();
        assert_eq!(failed(&right.problem, &right.points, &[contact]), [""; 0]);
        for left in [[-1.0, -1.0], [1.0, -1.0], [-1.0, 1.0]] {
            let mut wrong = OneSegment::new(along, left);
            let contact = wrong.hold();
            assert_eq!(
                failed(&wrong.problem, &wrong.points, &[contact]),
                ["orientation"]
            );
        }
    }
    // The whole robot upside down: its free arc, mirrored in the first disk.
    let (problem, solution) = solved(&scene(FREE, 5.0));
    let down = |v: Vector| Vector::new(v.x, -v.y);
    let points: Points = points(&solution.nodes, 0.008);
    let points = points.iter().map(|(b, c)| (down(*b), down(*c))).collect();
    assert_eq!(failed(&problem, &points, &[]), ["orientation"]);
}

/// What does not balance, relative to the force of the free bend.
#[test]
fn the_residual_of_a_segment_without_contact_is_known() {
    let one = OneSegment::new(1.3e-3, [1.0, 1.0]);
    let certificate = certify(&one.problem, &one.points, &[]);
    let free_bend = 2.0 * ((BACKBONE - CABLE) / (2.0 * OFFSET)).asin();
    let bending = 2.0 * (free_bend + 1e-5) / OFFSET;
    let rate = one.backbone_rate.norm_squared() + one.cable_rate.norm_squared();
    let expected = one.energy_rate.abs() / rate.sqrt() / bending;
    close(value(Condition::Stationarity, certificate), expected, 1e-9);
}

/// A post as thin as a needle at the same place, with the same normal: the
/// forces balance as before, but the robot would slip off.
#[test]
fn a_robot_on_the_point_of_a_needle_is_no_minimum() {
    for text in [ONE_DISC, TWO_DISCS] {
        let (problem, solution) = solved(&scene(text, 6.0));
        let points = points(&solution.nodes, problem.robot().offset);
        for contact in &solution.contacts {
            let on = |radius: f64| {
                let mut problem = problem.clone();
                let center = contact.point - radius * contact.normal;
                let post = Obstacle::new(Core::Point, radius, center, 0.0);
                problem.set_obstacle(contact.obstacle, post);
                failed(&problem, &points, &solution.contacts)
            };
            assert_eq!(on(1e-6), ["minimum"]);
            assert_eq!(on(0.01), [""; 0]);
        }
    }
}

/// Without pull a robot that is not straight has energy for nothing.
#[test]
fn a_bend_without_pull_is_no_minimum() {
    let straight = Problem::new(&scene(FREE, 0.0)).unwrap();
    let straight_points = points(
        &rolled_out(&straight, &Equal::new(straight.clone()).free_controls()),
        0.008,
    );
    assert!(is_minimum(&straight, &straight_points, &[]));
    let bent = Problem::new(&scene(FREE, 1e-2)).unwrap();
    let bent = points(
        &rolled_out(&bent, &Equal::new(bent.clone()).free_controls()),
        0.008,
    );
    assert!(!is_minimum(&straight, &bent, &[]));
}

/// A number that could not be computed is no small one.
#[test]
fn what_is_not_a_number_does_not_hold() {
    let (problem, solution) = solved(&scene(ONE_DISC, 6.0));
    let right = points(&solution.nodes, problem.robot().offset);
    for node in [1, 9, 18] {
        let mut points = right.clone();
        points[node].1.x = f64::NAN;
        assert!(!certify(&problem, &points, &solution.contacts).holds());
    }
    let mut contacts = solution.contacts.clone();
    contacts[0].multiplier = f64::NAN;
    assert!(!certify(&problem, &right, &contacts).holds());
}
