//! What has to hold of every robot whose cables slide, whoever computes it: the work of
//! a pull, mirror images, other places and sizes, limits that beams have, and refinement.

use sinew::contact::Class;
use sinew::equilibrium::{Settings, Solved, Start, Status, solve};
use sinew::geometry::Vector;
use sinew::mechanics::{Input, Problem};
use sinew::scene::{Scene, Shape};

/// Two posts that a robot bent by its first cable lies against, and a second cable that
/// a weight keeps tense.
const SCENE: &str = "version = 2
[robot]
length_mm = 180
segments = 18
bending_stiffness_nmm2 = 8000
[[cable]]
offset_mm = 8
pull_mm = 6
[[cable]]
offset_mm = -6
load_g = 50
to_disk = 6
[[obstacle]]
shape = \"disc\"
center_mm = [33, 92]
radius_mm = 14
[[obstacle]]
shape = \"disc\"
center_mm = [62, 149]
radius_mm = 12.5
[loads]
tip_force_n = [0.02, -0.03]
tip_moment_nmm = 1.5
";

fn scene() -> Scene {
    Scene::from_toml(SCENE).unwrap()
}

#[track_caller]
fn solved(problem: &Problem) -> Solved {
    let solved = solve(problem, Start::Straight, Settings::default());
    assert_eq!(solved.status, Status::Converged, "{:?}", solved.certificate);
    solved
}

#[track_caller]
fn solved_scene(scene: &Scene) -> Solved {
    solved(&Problem::new(scene).unwrap())
}

fn pressing(solved: &Solved) -> usize {
    let contacts = solved.contacts.iter();
    contacts.filter(|c| c.class == Class::Pressing).count()
}

#[track_caller]
fn close(found: f64, expected: f64, relative: f64) {
    assert!(
        (found - expected).abs() <= relative * expected.abs(),
        "{found:e} is not {expected:e}"
    );
}

/// T = dU/dpull, by a difference whose error is h²/6 of the third derivative: 1e-6 with
/// a step of 1 µm of pull of some millimetres.
#[test]
fn the_tension_is_the_work_of_a_pull() {
    let mut scene = scene();
    scene.loads = Default::default();
    // Where a weight keeps the second cable tense; then both are held by their pulls.
    let weighed = solved_scene(&scene);
    let at = |cable: usize, by: f64| {
        let mut drive = weighed.drive.clone();
        for (index, driven) in drive.cables.iter_mut().enumerate() {
            let more = if index == cable { by } else { 0.0 };
            driven.input = Input::Pull(weighed.cables[index].pull + more);
        }
        let mut problem = weighed.problem().clone();
        problem.set_drive(&drive);
        let there = solve(&problem, Start::From(&weighed), Settings::default());
        assert_eq!(there.status, Status::Converged, "{:?}", there.certificate);
        there
    };
    let here = at(0, 0.0);
    assert!(pressing(&here) >= 2, "{:?}", here.contacts);
    for (a, b) in weighed.cables.iter().zip(&here.cables) {
        assert!(!b.is_slack);
        close(b.tension, a.tension, 1e-6);
    }
    for (cable, state) in here.cables.iter().enumerate() {
        let step = 1e-6;
        let slope = (at(cable, step).energy - at(cable, -step).energy) / (2.0 * step);
        let miss = (slope - state.tension).abs();
        assert!(
            miss <= 1e-5 * here.cables[0].tension,
            "{cable}: {slope} {state:?}"
        );
    }
}

/// At given pulls the shape and F/T do not depend on the stiffness, known or not.
#[test]
fn forces_over_the_tension_are_free_of_the_stiffness() {
    let mut scene = scene();
    scene.cables.truncate(1);
    scene.loads = Default::default();
    let shares = |stiffness: Option<f64>| {
        let mut scene = scene.clone();
        scene.robot.bending_stiffness_nmm2 = stiffness;
        let solved = solved_scene(&scene);
        let contacts = solved.contacts.iter();
        let tension = solved.cables[0].tension;
        contacts
            .map(|contact| contact.multiplier / tension)
            .collect::<Vec<_>>()
    };
    let known = shares(Some(8000.0));
    assert!(!known.is_empty() && known[0] > 0.01);
    for other in [shares(Some(20.0)), shares(None)] {
        assert_eq!(known.len(), other.len());
        known
            .iter()
            .zip(&other)
            .for_each(|(a, b)| close(*a, *b, 1e-9));
    }
}

/// A straight beam that an end moment a T presses on a prop at s: F = 3 a T/2 s. The
/// wall is 1 nm off, loads are small enough for the beam to stay straight to 1e-5.
#[test]
fn a_small_prop_carries_what_beams_say() {
    let rate = |segments: u32| {
        let node = segments * 2 / 3;
        let text = format!(
            "version = 2
            robot = {{ length_mm = 180, segments = {segments}, segments_per_bay = 1, bending_stiffness_nmm2 = 8000 }}
            cable = [{{ offset_mm = 8, load_g = 2 }}]
            contact = {{ candidates = \"listed\", listed = [{{ line = \"backbone\", node = {node} }}] }}
            obstacle = [{{ shape = \"wall\", point_mm = [1e-6, 0], rotation_deg = 180 }}]
            "
        );
        let mut scene = Scene::from_toml(&text).unwrap();
        let force = |load_g: f64, scene: &mut Scene| {
            scene.cables[0].drive = sinew::scene::Drive::LoadG(load_g);
            let solved = solved_scene(scene);
            assert_eq!(pressing(&solved), 1);
            (solved.contacts[0].multiplier, solved.cables[0].tension)
        };
        let (low, high) = (force(2.0, &mut scene), force(4.0, &mut scene));
        (high.0 - low.0) / (high.1 - low.1)
    };
    let exact = 1.5 * 8.0 / 120.0;
    let [coarse, fine] = [18, 36].map(|segments| rate(segments) / exact - 1.0);
    assert!(fine.abs() < 1e-3, "{fine}");
    let order = (coarse / fine).log2();
    assert!((1.9..2.1).contains(&order), "{coarse} {fine} {order}");
}

/// A change of a scene, and where it takes a point of the shape.
#[track_caller]
fn check_moved(other: &Scene, to: impl Fn(Vector) -> Vector, tension: f64, bend: f64) {
    let (here, there) = (solved_scene(&scene()), solved_scene(other));
    assert!(pressing(&here) >= 2, "{:?}", here.contacts);
    let size = other.robot.length_mm * 1e-3;
    for (a, b) in here.backbone().zip(there.backbone()) {
        assert!((to(a) - b).norm() < 1e-8 * size, "{a} {b}");
    }
    for (a, b) in here.bends.iter().zip(&there.bends) {
        assert!((bend * a - b).abs() < 1e-8, "{a} {b}");
    }
    for (a, b) in here.cables.iter().zip(&there.cables) {
        close(b.tension, tension * a.tension, 1e-7);
        close(b.pull, size / 0.18 * a.pull, 1e-7);
    }
    assert_eq!(here.contacts.len(), there.contacts.len());
    let total = |solved: &Solved| -> f64 {
        solved
            .contacts
            .iter()
            .map(|contact| contact.multiplier)
            .sum()
    };
    close(total(&there), tension * total(&here), 1e-6);
}

fn each_disc(scene: &mut Scene, change: impl Fn(&mut [f64; 2], &mut f64)) {
    for obstacle in &mut scene.obstacles {
        if let Shape::Disc {
            center_mm,
            radius_mm,
        } = &mut obstacle.shape
        {
            change(center_mm, radius_mm);
        }
    }
}

#[test]
fn mirror_images_are_mirror_images() {
    let mut mirrored = scene();
    mirrored
        .cables
        .iter_mut()
        .for_each(|cable| cable.offset_mm *= -1.0);
    mirrored.loads.tip_force_n[0] *= -1.0;
    mirrored.loads.tip_moment_nmm *= -1.0;
    each_disc(&mut mirrored, |center, _| center[0] *= -1.0);
    check_moved(&mirrored, |p| Vector::new(-p.x, p.y), 1.0, -1.0);
}

#[test]
fn a_robot_elsewhere_is_the_same_robot() {
    let (sine, cosine) = 37_f64.to_radians().sin_cos();
    let turned = |[x, y]: [f64; 2]| [cosine * x - sine * y, sine * x + cosine * y];
    let mut there = scene();
    there.robot.base_mm = [310.0, -120.0];
    there.robot.base_angle_deg = 37.0;
    there.loads.tip_force_n = turned(there.loads.tip_force_n);
    each_disc(&mut there, |center, _| {
        let [x, y] = turned(*center);
        *center = [310.0 + x, -120.0 + y];
    });
    let to = |p: Vector| {
        let [x, y] = turned([p.x, p.y]);
        Vector::new(0.31 + x, -0.12 + y)
    };
    check_moved(&there, to, 1.0, 1.0);
}

/// Twice as large with four times the stiffness all forces stay, and moments double.
#[test]
fn a_robot_of_another_size_bends_alike() {
    let mut large = scene();
    large.robot.length_mm *= 2.0;
    large.robot.bending_stiffness_nmm2 = Some(4.0 * 8000.0);
    for cable in &mut large.cables {
        cable.offset_mm *= 2.0;
        if let sinew::scene::Drive::PullMm(pull) = &mut cable.drive {
            *pull *= 2.0;
        }
    }
    large.loads.tip_moment_nmm *= 2.0;
    each_disc(&mut large, |center, radius| {
        center.iter_mut().for_each(|coordinate| *coordinate *= 2.0);
        *radius *= 2.0;
    });
    // In rad²/m.
    check_moved(&large, |p| 2.0 * p, 0.5, 1.0);
}

/// Where the tip of a robot with so many bays and arcs is under a weight of 6 N, in mm.
fn tip(bays: u32, arcs: u32) -> Vector {
    let text = format!(
        "version = 2
        robot = {{ length_mm = 180, segments = {}, segments_per_bay = {arcs}, bending_stiffness_nmm2 = 8000 }}
        cable = [{{ offset_mm = 8, load_g = {} }}]
        ",
        bays * arcs,
        6.0 / 9.80665e-3
    );
    1e3 * solved_scene(&Scene::from_toml(&text).unwrap())
        .tip()
        .position
}

/// More bays come nearer to a cable in a continuous channel by the square of their
/// length: 89.77, 88.52 … 88.12 mm.
#[test]
fn finer_bays_converge_to_second_order() {
    let [a, b, c, d] = [9, 18, 36, 72].map(|bays| tip(bays, 2));
    assert!(
        (a.x - 89.77).abs() < 0.01 && (b.x - 88.52).abs() < 0.01,
        "{a} {b}"
    );
    let limit = d.x - (c.x - d.x) / 3.0;
    assert!((limit - 88.12).abs() < 0.01, "{limit}");
    for (coarse, fine) in [(a - b, b - c), (b - c, c - d)] {
        let order = (coarse.norm() / fine.norm()).log2();
        assert!((1.8..2.2).contains(&order), "{order}");
    }
}

/// Arcs within a bay: one is as good as two to 0.001 mm, and what more of them change
/// falls by their square, too.
#[test]
fn finer_arcs_converge_to_second_order() {
    let [a, b, c, d] = [1, 2, 4, 8].map(|arcs| tip(9, arcs));
    assert!((a - b).norm() < 1e-3, "{a} {b}");
    let order = ((b - c).norm() / (c - d).norm()).log2();
    assert!((1.5..2.5).contains(&order), "{order} {b} {c} {d}");
}
