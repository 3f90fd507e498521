//! Properties that hold between two solves: images of a scene, added and
//! doubled obstacles, warm and cold, and the envelope theorem.

use sinew::contact::Class;
use sinew::equilibrium::{Occurrence, Run, Settings, Solution, Solved, Start, Status, solve};
use sinew::geometry::Vector;
use sinew::mechanics::Problem;
use sinew::robot::Line;
use sinew::scene::{Candidates, Listed, Scene, Shape};

const TWO_DISCS: &str = include_str!("../assets/scenes/two-discs.toml");

fn two_discs(pull_mm: f64) -> Scene {
    let mut scene = Scene::from_toml(TWO_DISCS).unwrap();
    scene.set_pull_mm(pull_mm);
    scene
}

fn straight(scene: &Scene) -> Solved {
    let problem = Problem::new(scene).unwrap();
    let solution = solve(&problem, Start::Straight, Settings::default());
    assert_eq!(solution.status, Status::Converged, "{:?}", solution.events);
    solution
}

fn check_close(a: &Solution, b: &Solution, tolerance: f64) {
    for (i, (a, b)) in a.nodes.iter().zip(&b.nodes).enumerate() {
        let distance = (a.position - b.position).norm();
        assert!(distance < tolerance, "node {i}: {distance}");
    }
}

#[test]
fn both_discs_press_at_the_papers_nodes() {
    for i in 0..=10 {
        let solution = straight(&two_discs(4.85 + 0.01 * f64::from(i)));
        let found: Vec<_> = solution
            .contacts
            .iter()
            .map(|c| (c.line, c.node, c.obstacle, c.class))
            .collect();
        let pressing = Class::Pressing;
        assert_eq!(
            found,
            [
                (Line::Cable, 10, 0, pressing),
                (Line::Cable, 16, 1, pressing)
            ]
        );
    }
}

/// The robot with backbone and cable exchanged is its own mirror image: its
/// "backbone" is shorter by the pull, its "cable" let out by it.
#[test]
fn the_mirror_image_with_the_lines_exchanged_is_the_same() {
    let scene = two_discs(5.0);
    let mut image = scene.clone();
    image.robot.length_mm = 175.0;
    image.set_pull_mm(-5.0);
    for obstacle in &mut image.obstacles {
        if let Shape::Disc { center_mm, .. } = &mut obstacle.shape {
            center_mm[0] = 8.0 - center_mm[0];
        }
    }
    let (solution, image) = (straight(&scene), straight(&image));
    for (node, mirrored) in solution.nodes.iter().zip(&image.nodes) {
        let cable = node.at(0.008);
        let expected = Vector::new(0.008 - cable.x, cable.y);
        assert!((mirrored.position - expected).norm() < 1e-12);
    }
    assert!((solution.energy - image.energy).abs() < 1e-13);
    for (a, b) in solution.contacts.iter().zip(&image.contacts) {
        assert_eq!(
            (a.node, a.obstacle, b.line),
            (b.node, b.obstacle, Line::Backbone)
        );
        assert!((a.multiplier - b.multiplier).abs() < 1e-9 * a.multiplier);
    }
}

#[test]
fn a_rotated_and_shifted_scene_has_the_rotated_shape() {
    let scene = two_discs(6.5);
    let mut turned = scene.clone();
    let (angle, shift) = (0.7_f64, [31.0, -12.0]);
    let (sine, cosine) = angle.sin_cos();
    turned.robot.base_mm = shift;
    turned.robot.base_angle_deg = angle.to_degrees();
    for obstacle in &mut turned.obstacles {
        if let Shape::Disc { center_mm, .. } = &mut obstacle.shape {
            let [x, y] = *center_mm;
            *center_mm = [
                shift[0] + cosine * x - sine * y,
                shift[1] + sine * x + cosine * y,
            ];
        }
    }
    let (solution, turned) = (straight(&scene), straight(&turned));
    for (a, b) in solution.turns.iter().zip(&turned.turns) {
        assert!((a - b).abs() < 1e-11);
    }
    let tip = solution.tip().position;
    let expected = Vector::new(
        1e-3 * shift[0] + cosine * tip.x - sine * tip.y,
        1e-3 * shift[1] + sine * tip.x + cosine * tip.y,
    );
    assert!((turned.tip().position - expected).norm() < 1e-12);
}

#[test]
fn a_doubled_obstacle_shares_its_force_and_says_so() {
    let scene = two_discs(6.0);
    let one = straight(&scene);
    assert!(one.unique_split);
    let mut doubled = scene.clone();
    doubled.obstacles.push(scene.obstacles[1].clone());
    let two = straight(&doubled);
    check_close(&one, &two, 1e-12);
    assert!(!two.unique_split);
    let sum: f64 = two.contacts.iter().map(|c| c.multiplier).sum();
    let single: f64 = one.contacts.iter().map(|c| c.multiplier).sum();
    assert!((sum - single).abs() < 1e-9 * single);
}

#[test]
fn a_far_obstacle_changes_nothing() {
    let scene = two_discs(6.0);
    let mut more = scene.clone();
    let far = Shape::Disc {
        center_mm: [-400.0, 100.0],
        radius_mm: 50.0,
    };
    more.obstacles.push(far.into());
    check_close(&straight(&scene), &straight(&more), 1e-13);
}

#[test]
fn warm_and_cold_agree_on_the_same_branch() {
    let mut run: Option<Run> = None;
    for i in 0..=40 {
        let pull = 0.3 * f64::from(i);
        let problem = Problem::new(&two_discs(pull)).unwrap();
        let warm = match &mut run {
            Some(run) => {
                run.retarget(&problem);
                run.finish()
            }
            None => run
                .insert(Run::new(&problem, Start::Straight, Settings::default()))
                .finish(),
        };
        assert_eq!(warm.status, Status::Converged);
        check_close(&straight(&two_discs(pull)), warm, 1e-11);
    }
}

/// dJ*/dl from the links' multipliers against a central difference: 1e-4 mm
/// apart, so that its error of the third derivative is about 1e-7 of it.
#[test]
fn the_energys_slope_is_the_cables_multiplier() {
    for pull in [1.0, 4.9, 6.2, 9.6, 11.3] {
        let here = straight(&two_discs(pull));
        let step = 1e-3;
        let after = straight(&two_discs(pull + step)).energy;
        let before = straight(&two_discs(pull - step)).energy;
        let slope = (after - before) / (2e-3 * step);
        let exact = here.certificate.energy_slope;
        assert!(
            (slope - exact).abs() < 1e-6 * exact.abs(),
            "{pull}: {slope} {exact}"
        );
    }
}

/// A contact's multiplier is how the least energy changes as its obstacle
/// moves along the normal.
#[test]
fn the_energys_slope_along_an_obstacles_motion_is_its_multiplier() {
    let scene = two_discs(6.0);
    let here = straight(&scene);
    let contact = here.contacts[0];
    let moved = |by: f64| {
        let mut scene = scene.clone();
        if let Shape::Disc { center_mm, .. } = &mut scene.obstacles[contact.obstacle].shape {
            center_mm[0] += by * contact.normal.x;
            center_mm[1] += by * contact.normal.y;
        }
        straight(&scene).energy
    };
    let slope = (moved(1e-3) - moved(-1e-3)) / 2e-6;
    assert!((slope - contact.multiplier).abs() < 1e-5 * contact.multiplier);
}

/// Only the listed node is tested: eq. 12. The rest passes through the wall.
#[test]
fn a_single_node_meets_the_load_cell() {
    let scene = Scene::from_toml(include_str!("../assets/scenes/load-cell.toml")).unwrap();
    assert_eq!(scene.contact.candidates, Candidates::Listed);
    assert_eq!(
        scene.contact.listed,
        [Listed {
            line: sinew::scene::Line::Cable,
            cable: 0,
            node: 14
        }]
    );
    let solution = straight(&scene);
    assert_eq!(solution.contacts.len(), 1);
    assert!((solution.contacts[0].point.x - 0.026).abs() < 1e-15);
    assert!(solution.tip().at(0.008).x > 0.027);
}

/// An obstacle over the straight robot pushes it to the nearer side.
#[test]
fn an_obstacle_over_the_straight_robot_pushes_it_aside() {
    for (x, side) in [(-6.0, 1.0), (14.0, -1.0)] {
        let mut scene = Scene::default();
        let disc = Shape::Disc {
            center_mm: [x, 120.0],
            radius_mm: 12.0,
        };
        scene.obstacles.push(disc.into());
        scene.set_pull_mm(0.0);
        let solution = straight(&scene);
        let pushed = solution.events.iter().find_map(|event| match event.what {
            Occurrence::PushedAside { direction, .. } => Some(direction),
            _ => None,
        });
        assert!((pushed.unwrap() - Vector::new(side, 0.0)).norm() < 1e-12);
        assert!(
            solution.tip().position.x * side > 0.0,
            "{:?}",
            solution.tip()
        );
        assert!(!solution.contacts.is_empty());
    }
}

/// A disc swept right through the robot: it is pushed along, then slips off
/// with an event or ends the branch; no state ever has it on the other side
/// without one.
#[test]
fn an_obstacle_dragged_through_never_passes_silently() {
    for candidates in [Candidates::Nodes, Candidates::Body] {
        let at = |x: f64| {
            let mut scene = Scene::default();
            scene.contact.candidates = candidates;
            scene.set_pull_mm(2.0);
            let disc = Shape::Disc {
                center_mm: [x, 110.0],
                radius_mm: 10.0,
            };
            scene.obstacles.push(disc.into());
            Problem::new(&scene).unwrap()
        };
        let mut run = Run::new(&at(60.0), Start::Straight, Settings::default());
        run.finish();
        let mut jumps = 0;
        for x in [45.0, 20.0, 0.0, -20.0, -60.0, -120.0] {
            run.retarget(&at(x));
            let solution = run.finish();
            assert!(
                solution.certificate.holds(),
                "{x}: {:?}",
                solution.certificate
            );
            let jump =
                |event: &&sinew::equilibrium::Event| matches!(event.what, Occurrence::Jump { .. });
            jumps += solution.events.iter().filter(jump).count();
            if solution.status != Status::Converged {
                break;
            }
            // The disc came from the cable's side: the robot is on its far
            // side until it has slipped off.
            let disc = Vector::new(1e-3 * x, 0.110);
            let beside = solution
                .nodes
                .iter()
                .filter(|n| (n.position.y - disc.y).abs() < 0.006);
            for node in beside {
                assert!(node.position.x < disc.x || jumps > 0, "{x}: {node:?}");
            }
        }
    }
}

/// Deleting or reordering obstacles leaves those that stay where they are.
#[test]
fn obstacles_that_stay_are_known_by_their_place() {
    let disc = |x: f64, y: f64| Shape::Disc {
        center_mm: [x, y],
        radius_mm: 12.5,
    };
    let with = |shapes: &[Shape]| {
        let mut scene = Scene::default();
        scene.set_pull_mm(6.0);
        scene.obstacles = shapes.iter().cloned().map(Into::into).collect();
        Problem::new(&scene).unwrap()
    };
    let (a, b) = (disc(-33.0, 120.0), disc(43.0, 107.0));
    let both = with(&[a.clone(), b.clone()]);
    for goal in [
        with(std::slice::from_ref(&b)),
        with(&[b.clone(), a.clone()]),
    ] {
        let mut run = Run::new(&both, Start::Straight, Settings::default());
        run.finish();
        run.retarget(&goal);
        let kept = run.finish();
        assert_eq!(kept.status, Status::Converged);
        let fresh = solve(&goal, Start::Straight, Settings::default());
        check_close(kept, &fresh, 1e-10);
    }
}
