//! Measured shapes against ones whose pull is known, and those that are refused.

use sinew::equilibrium::{Settings, Solved, Start, Status, solve};
use sinew::experiments::{Measured, MeasuredFault, MeasuredPoint, PaperScene, best_pull, compare};
use sinew::geometry::Vector;
use sinew::mechanics::Problem;
use sinew::scene::{Measurements, Scene};
use sinew::units::{metres, millimetres};

fn near(found: f64, expected: f64, tolerance: f64) {
    assert!(
        (found - expected).abs() <= tolerance,
        "{found} is not {expected}"
    );
}

fn free() -> Problem {
    Problem::new(&PaperScene::Free.scene().unwrap()).unwrap()
}

/// Points of the free robot at a pull, moved aside.
fn points_at(pull_mm: f64, aside_mm: f64, by_node: bool) -> Vec<MeasuredPoint> {
    let mut points = points_of(&free(), pull_mm, by_node);
    for point in &mut points {
        point.position += Vector::new(metres(aside_mm), 0.0);
    }
    points
}

/// The nodes of a robot at a pull.
fn points_of(problem: &Problem, pull_mm: f64, by_node: bool) -> Vec<MeasuredPoint> {
    let solution = solved(problem, pull_mm);
    let nodes = solution.backbone().enumerate();
    nodes
        .map(|(i, position)| MeasuredPoint {
            row: i + 2,
            node: by_node.then_some(i),
            position,
        })
        .collect()
}

fn solved(problem: &Problem, pull_mm: f64) -> Solved {
    let mut problem = problem.clone();
    problem.set_pull(metres(pull_mm));
    let solution = solve(&problem, Start::Straight, Settings::default());
    assert_eq!(solution.status, Status::Converged);
    solution
}

/// A scan of the free robot at a pull: points so far apart along it, each off by
/// normal errors of a size, in mm.
fn scan(pull_mm: f64, apart_mm: f64, noise_mm: f64) -> Vec<MeasuredPoint> {
    let solution = solved(&free(), pull_mm);
    let nodes: Vec<Vector> = solution.backbone().collect();
    let mut seed = 1_u64;
    // Twelve uniform numbers, centred, are as good as normal.
    let mut normal = || {
        let uniform = (0..12).map(|_| {
            seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
            (seed >> 33) as f64 / f64::from(1_u32 << 31)
        });
        uniform.sum::<f64>() - 6.0
    };
    let count = (180.0 / apart_mm) as usize;
    let points = (0..=count).map(|k| {
        let along = (k as f64 * apart_mm / 10.0).min(17.999_999);
        let (link, share) = (along as usize, along.fract());
        let place = (1.0 - share) * nodes[link] + share * nodes[link + 1];
        let error = Vector::new(normal(), normal());
        MeasuredPoint {
            row: k + 2,
            node: None,
            position: place + metres(noise_mm) * error,
        }
    });
    points.collect()
}

#[test]
fn the_pull_of_a_shape_is_found_from_its_points() {
    for pull_mm in [0.0, 0.4, 7.3, 23.0, 49.0, 55.3, 120.0, -5.0, -60.1] {
        for by_node in [true, false] {
            let measured = Measured::new(points_at(pull_mm, 0.0, by_node), &free()).unwrap();
            let (solution, fit) = best_pull(&free(), &measured, |_| {}).unwrap();
            near(millimetres(solution.pull), pull_mm, 1e-5);
            assert!(fit.rms < 1e-8, "{pull_mm}: {}", fit.rms);
        }
    }
}

/// Data of known pulls in a wedge, where contacts come and go and the distance
/// has several minima along the pull.
#[test]
fn the_best_pull_is_the_best_of_the_whole_branch() {
    let text = include_str!("../assets/scenes/wedge.toml");
    let wedge = Problem::new(&Scene::from_toml(text).unwrap()).unwrap();
    // The branch ends at 10.15 mm, between two steps of the search.
    for pull_mm in [1.3, 4.7, 8.2, 9.2, 9.7, 9.9, 10.14] {
        for by_node in [true, false] {
            let points = points_of(&wedge, pull_mm, by_node);
            let measured = Measured::new(points, &wedge).unwrap();
            let (_, fit) = best_pull(&wedge, &measured, |_| {}).unwrap();
            near(millimetres(fit.pull), pull_mm, 1e-4);
            assert!(fit.rms < 1e-8, "{pull_mm}: {}", fit.rms);
        }
    }
}

#[test]
fn a_search_tells_how_far_it_is() {
    let measured = Measured::new(points_at(7.3, 0.0, true), &free()).unwrap();
    let mut shares = vec![0.0];
    best_pull(&free(), &measured, |share| shares.push(share)).unwrap();
    assert!(
        shares
            .windows(2)
            .all(|two| two[0] <= two[1] && two[1] <= two[0] + 0.1)
    );
    assert_eq!(shares.last(), Some(&1.0));
}

/// Noise of 0.2 mm every millimetre, and finer still.
#[test]
fn noise_is_no_disorder() {
    for (apart_mm, noise_mm) in [(1.0, 0.2), (0.2, 0.2), (0.05, 0.5), (5.0, 1.0)] {
        for pull_mm in [7.3, 30.0] {
            let measured = Measured::new(scan(pull_mm, apart_mm, noise_mm), &free()).unwrap();
            assert!((measured.length() / 0.18 - 1.0).abs() < 0.15);
            let (_, fit) = best_pull(&free(), &measured, |_| {}).unwrap();
            near(millimetres(fit.pull), pull_mm, 0.1 * noise_mm);
            // Half of a point's error is along the backbone.
            assert!(
                (millimetres(fit.rms) / noise_mm - 1.0).abs() < 0.2,
                "{}",
                fit.rms
            );
        }
    }
    // Disorder is, also under noise.
    let mut points = scan(7.3, 1.0, 0.2);
    points[60..120].reverse();
    for (index, point) in points.iter_mut().enumerate() {
        point.row = index + 2;
    }
    let fault = Measured::new(points, &free()).unwrap_err();
    let MeasuredFault::Unsorted { row } = fault else {
        panic!("{fault}");
    };
    // Where a stride has gone back from row 62.
    assert!((63..72).contains(&row), "{row}");
}

/// The order of nodes that are named is not judged by where they are.
#[test]
fn few_nodes_of_a_strongly_bent_robot_are_taken() {
    // 240°, and a whole turn, on which the tip is where the base is.
    for pull_mm in [33.5, 50.3] {
        let points = points_of(&free(), pull_mm, true);
        let few: Vec<_> = points.iter().step_by(9).copied().collect();
        assert_eq!(few.len(), 3);
        let measured = Measured::new(few, &free()).unwrap();
        let (_, fit) = best_pull(&free(), &measured, |_| {}).unwrap();
        near(millimetres(fit.pull), pull_mm, 1e-4);
    }
}

#[test]
fn points_in_another_unit_are_refused() {
    for pull_mm in [0.0, 20.0, 70.0] {
        for by_node in [true, false] {
            for (unit, word) in [
                (0.1, "centimetres"),
                (1.0 / 25.4, "inches"),
                (0.001, "metres"),
            ] {
                let mut points = points_of(&free(), pull_mm, by_node);
                points.iter_mut().for_each(|point| point.position *= unit);
                let fault = Measured::new(points, &free()).unwrap_err();
                assert!(matches!(fault, MeasuredFault::Length { .. }), "{fault}");
                assert!(fault.to_string().contains(word), "{fault}");
            }
        }
    }
    // Noise makes neighbours that are named no strangers to each other.
    let (text, segments) = (
        "version = 2\nmodel = { mechanics = \"equal\" }\nactuation = { pull_mm = 6 }\n",
        2000,
    );
    let robot =
        format!("robot = {{ length_mm = 180, segments = {segments}, cable_offset_mm = 8 }}");
    let fine = Problem::new(&Scene::from_toml(&format!("{text}{robot}")).unwrap()).unwrap();
    let mut points = points_of(&fine, 7.0, true);
    for (index, point) in points.iter_mut().enumerate() {
        point.position.x += metres(0.5) * (index % 3) as f64;
    }
    assert!(Measured::new(points, &fine).is_ok());
    // Curled up, no point of a backbone in too small a unit is out of reach.
    let mut points = points_of(&free(), 140.0, false);
    points.iter_mut().for_each(|point| point.position *= 5.0);
    let fault = Measured::new(points, &free()).unwrap_err();
    assert!(matches!(fault, MeasuredFault::Length { .. }), "{fault}");
    // A third of the robot is a part of it.
    let part = points_of(&free(), 20.0, false)[..7].to_vec();
    assert!(Measured::new(part, &free()).is_ok());
}

#[test]
fn distances_are_those_of_the_points() {
    let measured = Measured::new(points_at(5.0, 0.25, true), &free()).unwrap();
    let mut problem = free();
    problem.set_pull(metres(5.0));
    let solution = solve(&problem, Start::Straight, Settings::default());
    let fit = compare(&solution, &measured);
    near(millimetres(fit.rms), 0.25, 1e-9);
    near(millimetres(fit.max), 0.25, 1e-9);
}

#[test]
fn measured_points_that_make_no_sense_name_their_row() {
    let check = |edit: &dyn Fn(&mut Vec<MeasuredPoint>), by_node, expected: MeasuredFault| {
        let mut points = points_at(5.0, 0.0, by_node);
        edit(&mut points);
        assert_eq!(Measured::new(points, &free()), Err(expected));
    };
    check(&|p| p.clear(), false, MeasuredFault::Empty);
    check(&|p| p.truncate(1), false, MeasuredFault::TooFew(1));
    check(
        &|p| p[3].position.x = f64::NAN,
        false,
        MeasuredFault::NotFinite { row: 5 },
    );
    check(
        &|p| p[4].position = p[2].position,
        false,
        MeasuredFault::Duplicate { row: 6, earlier: 4 },
    );
    check(&|p| p.swap(5, 9), false, MeasuredFault::Unsorted { row: 8 });
    check(&|p| p.reverse(), false, MeasuredFault::Unsorted { row: 2 });
    check(
        &|p| p.swap(5, 6),
        true,
        MeasuredFault::NodesUnsorted { row: 7, node: 5 },
    );
    check(
        &|p| p[6].node = None,
        true,
        MeasuredFault::NodeMissing { row: 8 },
    );
    check(
        &|p| p[18].node = Some(19),
        true,
        MeasuredFault::NoSuchNode {
            row: 20,
            node: 19,
            last: 18,
        },
    );
    check(
        &|p| p[9].node = Some(8),
        true,
        MeasuredFault::NodesUnsorted { row: 11, node: 8 },
    );
    let far = Vector::new(0.0, 1.0);
    let mut points = points_at(5.0, 0.0, false);
    points[7].position = far;
    let fault = Measured::new(points, &free()).unwrap_err();
    assert!(
        matches!(fault, MeasuredFault::FarOff { row: 9, .. }),
        "{fault}"
    );
}

/// As many points as the scene's check asks for are enough.
#[test]
fn two_points_of_a_scene_are_compared() {
    for nodes in [vec![9, 18], Vec::new()] {
        let mut scene = Scene::default();
        let points = points_at(7.3, 0.0, true);
        let held = [9, 18].map(|node| points[node].position.map(millimetres).into());
        scene.measured = Some(Measurements {
            points_mm: held.to_vec(),
            nodes,
            ..Measurements::default()
        });
        let problem = Problem::new(&scene).unwrap();
        let held = scene.measured.as_ref().unwrap();
        let measured = Measured::of_scene(held, &problem).unwrap();
        let (solution, fit) = best_pull(&problem, &measured, |_| {}).unwrap();
        near(millimetres(solution.pull), 7.3, 1e-5);
        assert!(fit.rms < 1e-8, "{}", fit.rms);
    }
}
