//! Sharp corners: a sharp box or wedge behaves as one whose corners are hardly
//! rounded. A robot's point passes round a corner, a corner slides along the
//! robot from link to link, and neither goes through the other.
//!
//! Of a great many scenes: `SINEW_SCENES=2000 cargo test --release --test corners
//! -- --nocapture` tells how many end alike and what becomes of the others: of
//! 2000, 1985 (99.25 %) do. In six of the others an end of the robot, its last
//! disk's rim, stands on a corner, vertex on vertex, over a whole range of pulls,
//! and the sharp one slips at another of them; the rest are jams that end, and
//! jumps that lead, to either side of something narrow.

mod seeded;

use seeded::{Random, scenes};
use sinew::equilibrium::{Settings, Solution, Solved, Start, Status, solve};
use sinew::geometry::Vector;
use sinew::mechanics::Problem;
use sinew::robot::Line;
use sinew::scene::{Candidates, Scene, Shape};
use std::collections::BTreeMap;

/// The radius, mm, of the corners that sharp ones are compared with.
const ROUNDED_MM: f64 = 0.02;
/// How far apart, mm, two tips may be that count as the same.
const SAME_MM: f64 = 0.3;

fn robot(pull_mm: f64, candidates: Candidates, shape: Shape) -> Scene {
    let mut scene = Scene::default();
    scene.robot.length_mm = 180.0;
    scene.robot.segments = 18;
    scene.robot.cable_offset_mm = Some(8.0);
    scene.set_pull_mm(pull_mm);
    scene.contact.candidates = candidates;
    scene.obstacles = vec![shape.into()];
    scene
}

fn solved(scene: &Scene) -> Solved {
    let problem = Problem::new(scene).unwrap();
    solve(&problem, Start::Straight, Settings::default())
}

fn tip_mm(solution: &Solution) -> [f64; 2] {
    let tip = solution.tip().position;
    [1e3 * tip.x, 1e3 * tip.y]
}

fn apart_mm(a: &Solution, b: &Solution) -> f64 {
    let ([x, y], [u, v]) = (tip_mm(a), tip_mm(b));
    (x - u).hypot(y - v)
}

/// What presses: line, node and multiplier in rad²/mm.
type Pressing = (Line, usize, f64);

/// Checks where a scene leads, to the digits that are given.
fn check(scene: &Scene, tip: [f64; 2], energy: f64, pressing: &[Pressing]) {
    let solution = solved(scene);
    assert_eq!(solution.status, Status::Converged, "{:?}", solution.events);
    let found = tip_mm(&solution);
    let off = (found[0] - tip[0]).hypot(found[1] - tip[1]);
    assert!(off < 1e-3, "tip {found:?}");
    let off = (solution.energy - energy).abs();
    assert!(off < 1e-6, "energy {}", solution.energy);
    let contacts = solution.contacts.iter().filter(|c| c.multiplier > 0.0);
    let contacts: Vec<Pressing> = contacts
        .map(|c| (c.line, c.node, 1e-3 * c.multiplier))
        .collect();
    assert_eq!(contacts.len(), pressing.len(), "{contacts:?}");
    for (found, right) in contacts.iter().zip(pressing) {
        assert_eq!((found.0, found.1), (right.0, right.1), "{contacts:?}");
        let off = (found.2 / right.2 - 1.0).abs();
        assert!(off < 2e-3, "{contacts:?}");
    }
}

fn turned_box(center_mm: [f64; 2], rotation_deg: f64) -> Shape {
    Shape::Box {
        center_mm,
        size_mm: [20.0, 20.0],
        rotation_deg,
        corner_radius_mm: 0.0,
    }
}

/// Values of an independent solver with the same sharp box.
#[test]
fn a_node_goes_round_a_sharp_corner() {
    let scene = robot(10.0, Candidates::Nodes, turned_box([26.0, 90.0], 10.0));
    let pressing = [(Line::Cable, 10, 3.345e-4), (Line::Cable, 11, 4.765e-5)];
    check(&scene, [75.590, 140.548], 0.090590, &pressing);
}

/// Values of the same scene with a corner radius of 0.01 mm, in the limit.
#[test]
fn a_sharp_corner_slides_from_link_to_link() {
    let scene = robot(12.0, Candidates::Body, turned_box([44.142, 90.0], 45.0));
    let pressing = [
        (Line::CableLink, 11, 1.324e-4),
        (Line::CableLink, 13, 2.756e-4),
    ];
    check(&scene, [93.912, 127.582], 0.128052, &pressing);
}

/// The corner rests in the notch between two links and presses on both. The
/// tip is that with a corner radius of 0.001 mm.
#[test]
fn an_acute_corner_does_not_pierce_a_link() {
    let wedge = Shape::Polygon {
        points_mm: vec![[18.0, 140.0], [33.0, 134.5], [33.0, 145.5]],
        rotation_deg: 0.0,
        corner_radius_mm: 0.0,
    };
    let scene = robot(8.0, Candidates::Body, wedge);
    let pressing = [
        (Line::CableLink, 15, 3.043e-4),
        (Line::CableLink, 16, 7.088e-5),
    ];
    check(&scene, [37.7985, 163.0272], 0.062378, &pressing);
}

/// The node that comes down on top of the box is led back up, and not to the
/// side that happens to be nearer.
#[test]
fn a_node_that_slips_over_a_box_lands_on_top() {
    let shape = Shape::Box {
        center_mm: [50.0, 140.0],
        size_mm: [10.0, 30.0],
        rotation_deg: 0.0,
        corner_radius_mm: 0.5,
    };
    let scene = robot(10.0, Candidates::Nodes, shape);
    let pressing = [(Line::Cable, 17, 5.314e-4), (Line::Cable, 18, 4.697e-4)];
    check(&scene, [50.987, 162.798], 0.100679, &pressing);
}

/// A corner has slid past the rim of the last disk, which may not take the
/// wedge into its side. The values are those with a corner radius of 1e-4 mm.
#[test]
fn a_corner_beyond_the_end_of_a_disk_does_not_pierce_it() {
    let wedge = triangle(
        [[25.336, 170.91], [30.942, 168.923], [29.863, 167.052]],
        0.0,
    );
    let pressing = [(Line::DiskFace, 18, 8.008e-3)];
    let scene = robot(10.6, Candidates::Body, wedge);
    check(&scene, [24.2634, 166.3080], 0.183523, &pressing);
}

/// Near its tip the needle is thinner than the least step of the pull moves the
/// node on it. The robot slips off it and is free, an arc.
#[test]
fn a_node_slips_off_the_tip_of_a_needle() {
    let needle = triangle([[8.88, 169.34], [8.506, 178.754], [9.722, 178.723]], 0.0);
    let scene = robot(10.0, Candidates::Nodes, needle);
    check(&scene, [98.6279, 136.6652], 0.086840, &[]);
}

/// A triangle with corners of a radius, in the place of one with sharp corners.
/// A polygon's radius goes around it; a box's is inside.
fn triangle(corners_mm: [[f64; 2]; 3], corner_radius_mm: f64) -> Shape {
    let corners = corners_mm.map(Vector::from);
    let sides = [1, 2, 0].map(|i| (corners[(i + 1) % 3] - corners[i]).norm());
    let around: f64 = sides.iter().sum();
    let [a, b, c] = corners;
    let doubled = (b - a).perp(&(c - a)).abs();
    // Moving its sides in scales a triangle about the middle of its incircle.
    let middle = (sides[0] * a + sides[1] * b + sides[2] * c) / around;
    let scale = 1.0 - corner_radius_mm * around / doubled;
    let points = corners.map(|corner| middle + scale * (corner - middle));
    Shape::Polygon {
        points_mm: points.map(|point| [point.x, point.y]).to_vec(),
        rotation_deg: 0.0,
        corner_radius_mm,
    }
}

/// A robot, thin or thick, beside a box, a triangle or a wedge with corners of
/// a radius.
fn random_scene(seed: u64, corner_radius_mm: f64) -> Scene {
    let mut random = Random::of(seed);
    let candidates = [Candidates::Nodes, Candidates::Body][random.one_of(2) as usize];
    let thick = random.one_of(2) == 0;
    let sizes = [(0.5, 2.0), (0.5, 3.0), (0.3, 1.0)].map(|(a, b)| random.between(a, b));
    let pull_mm = random.between(2.0, 14.0);
    let center_mm = [random.between(-10.0, 80.0), random.between(40.0, 175.0)];
    let turn = random.between(0.0, 360.0);
    let (width, height) = (random.between(5.0, 40.0), random.between(5.0, 40.0));
    let half =
        |random: &mut Random, least: f64, most: f64| random.between(least, most).to_radians();
    let shape = match random.one_of(3) {
        0 => Shape::Box {
            center_mm,
            size_mm: [width, height],
            rotation_deg: turn,
            corner_radius_mm,
        },
        kind => {
            let half = match kind {
                1 => half(&mut random, 20.0, 70.0),
                _ => half(&mut random, 3.0, 20.0),
            };
            let end = |side: f64| {
                let angle = turn.to_radians() + side * half;
                let x = center_mm[0] + width * libm::cos(angle);
                [x, center_mm[1] + width * libm::sin(angle)]
            };
            triangle([center_mm, end(1.0), end(-1.0)], corner_radius_mm)
        }
    };
    let mut scene = robot(pull_mm, candidates, shape);
    if thick {
        scene.robot.disk_thickness_mm = sizes[0];
        scene.robot.backbone_diameter_mm = sizes[1];
        scene.robot.cable_diameter_mm = sizes[2];
    }
    scene
}

#[test]
fn sharp_corners_lead_where_rounded_ones_do() {
    let (mut alike, mut compared) = (0, 0);
    let mut others: BTreeMap<String, u32> = BTreeMap::new();
    for seed in 0..scenes(300) {
        let [sharp, rounded] = [0.0, ROUNDED_MM].map(|radius| {
            let problem = Problem::new(&random_scene(seed, radius)).ok()?;
            Some(solve(&problem, Start::Straight, Settings::default()))
        });
        let (Some(sharp), Some(rounded)) = (sharp, rounded) else {
            continue;
        };
        for solution in [&sharp, &rounded] {
            assert!(
                solution.certificate.holds(),
                "{seed}: {:?}",
                solution.status
            );
        }
        compared += 1;
        let ends = [&sharp, &rounded].map(|solution| solution.status == Status::Converged);
        if ends[0] == ends[1] && apart_mm(&sharp, &rounded) < SAME_MM {
            alike += 1;
        } else {
            let words = [&sharp, &rounded].map(|solution| solution.status.reason());
            *others.entry(words.join(" | ")).or_default() += 1;
        }
    }
    let share = f64::from(alike) / f64::from(compared);
    println!("{alike} of {compared} end alike: {:.2} %", 100.0 * share);
    for (words, count) in others {
        println!("{count:4}  {words}");
    }
    assert!(share >= 0.99, "{share}");
}
