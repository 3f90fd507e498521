//! Known answers: the free robot is a circular arc; the figures of the paper's
//! robot; the limits of no pull and of a cable let out.

use sinew::equilibrium::{Settings, Solved, Start, Status, solve};
use sinew::mechanics::Problem;
use sinew::scene::Scene;

fn free(length_mm: f64, segments: u32, offset_mm: f64, pull_mm: f64) -> Solved {
    let mut scene = Scene::default();
    scene.robot.length_mm = length_mm;
    scene.robot.segments = segments;
    scene.robot.segments_per_bay = 1;
    scene.robot.cable_offset_mm = Some(offset_mm);
    scene.set_pull_mm(pull_mm);
    solve(
        &Problem::new(&scene).unwrap(),
        Start::Straight,
        Settings::default(),
    )
}

/// Node i of an arc of bends β and chords l_0 is at angle i β.
fn check_arc(length_mm: f64, segments: u32, offset_mm: f64, pull_mm: f64) {
    let solution = free(length_mm, segments, offset_mm, pull_mm);
    assert_eq!(solution.status, Status::Converged);
    assert!(solution.certificate.holds());
    assert!(solution.contacts.is_empty());
    let n = f64::from(segments);
    let bend = 2.0 * (pull_mm / (2.0 * n * offset_mm)).asin();
    let chord = length_mm * 1e-3 / n;
    for (i, point) in solution.backbone().enumerate() {
        let half = 0.5 * bend * i as f64;
        // The chord from the base to node i, at half the angle turned.
        let share = if bend == 0.0 {
            i as f64
        } else {
            half.sin() / (0.5 * bend).sin()
        };
        let expected = [chord * share * half.sin(), chord * share * half.cos()];
        for axis in 0..2 {
            let error = (point[axis] - expected[axis]).abs() / (length_mm * 1e-3);
            assert!(error < 1e-12, "node {i}: {error}");
        }
    }
    let energy = n * bend * bend;
    assert!((solution.energy - energy).abs() <= 1e-12 * energy);
}

#[test]
fn the_free_robot_is_a_circular_arc() {
    for (length, segments, offset, pull) in [
        (180.0, 18, 8.0, 5.0),
        (180.0, 18, 8.0, 0.0),
        (180.0, 18, 8.0, 1e-6),
        (180.0, 18, 8.0, -7.0),
        (180.0, 18, 8.0, 60.0),
        (50.0, 1, 10.0, 12.0),
        (2500.0, 200, 30.0, 80.0),
        (1.0, 3, 0.01, 0.01),
    ] {
        check_arc(length, segments, offset, pull);
    }
}

#[test]
fn the_papers_robot_ends_where_it_should() {
    for (pull, x, y, degrees) in [
        (5.0, 54.448, 168.515, 35.812),
        (10.0, 98.628, 136.665, 71.634),
    ] {
        let tip = free(180.0, 18, 8.0, pull).tip();
        assert!((tip.position.x * 1e3 - x).abs() < 5e-4);
        assert!((tip.position.y * 1e3 - y).abs() < 5e-4);
        assert!((-tip.angle.to_degrees() - degrees).abs() < 5e-4);
    }
}

/// Small pulls: the shape stays an arc and the certificate holds, where the
/// unscaled problem's Hessian vanishes.
#[test]
fn every_small_pull_is_certified() {
    for exponent in -12..=0 {
        for sign in [1.0, -1.0] {
            check_arc(180.0, 18, 8.0, sign * 10f64.powi(exponent));
        }
    }
}
