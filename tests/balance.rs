//! The balance of forces where it is easily got wrong: contacts at the very
//! first link, a base that is not at the origin; what of it may fail by itself;
//! and what is said where there are no forces to tell.

use sinew::contact::Class;
use sinew::equilibrium::{Settings, Solution, Solved, Start, Status, solve};
use sinew::forces::{
    Caveat, FitError, LineFit, LoadSteps, Profile, Rates, Resultant, Sections, Statics, Stiffness,
    StiffnessError, Sweep, SweepError, Touch, VirtualWork, VirtualWorkError, Window,
};
use sinew::geometry::{Vector, cross};
use sinew::mechanics::Problem;
use sinew::robot::Line;
use sinew::scene::{Candidates, Scene, Shape};

fn stiffness() -> Stiffness {
    Stiffness::new(8e-3).unwrap()
}

fn disc(x: f64, y: f64, radius_mm: f64) -> Shape {
    Shape::Disc {
        center_mm: [x, y],
        radius_mm,
    }
}

fn body(pull_mm: f64, shapes: &[Shape]) -> Scene {
    let mut scene = Scene::default();
    scene.set_pull_mm(pull_mm);
    scene.contact.candidates = Candidates::Body;
    scene.robot.segments_per_bay = 18;
    scene.robot.cable_diameter_mm = 0.5;
    scene.obstacles = shapes.iter().cloned().map(Into::into).collect();
    scene
}

#[track_caller]
fn solved(scene: &Scene) -> (Problem, Solved, Statics) {
    let problem = Problem::new(scene).unwrap();
    let solution = solve(&problem, Start::Straight, Settings::default());
    assert_eq!(solution.status, Status::Converged);
    let statics = Statics::of(&solution, stiffness());
    assert!(statics.balances(), "{statics:?}");
    (problem, solution, statics)
}

#[track_caller]
fn close(found: f64, expected: f64, relative: f64) {
    assert!(
        (found - expected).abs() <= relative * expected.abs(),
        "{found:e} is not {expected:e}"
    );
}

/// A post that pushes a link of the first segment to the side.
fn at_the_first_link() -> Scene {
    body(3.0, &[disc(12.2, 5.0, 4.0)])
}

/// The same on the backbone's side, and one on the middle of a link above.
fn at_two_links() -> Scene {
    body(6.0, &[disc(-4.4, 6.0, 4.5), disc(25.0, 95.0, 8.0)])
}

/// The flat face of a wide disk on a pin.
fn at_a_face() -> Scene {
    let mut scene = body(8.0, &[disc(93.9, 127.9, 3.0)]);
    scene.robot.disk_radius_mm = Some(40.0);
    scene
}

#[test]
fn what_touches_the_first_link_is_held_by_the_first_disk() {
    let (_, solution, statics) = solved(&at_the_first_link());
    let [contact] = solution.contacts[..] else {
        panic!("{:?}", solution.contacts)
    };
    assert_eq!((contact.line, contact.node), (Line::CableLink, 1));
    assert!(contact.along > 0.2 && contact.along < 0.8, "{contact:?}");
    // The clamp by itself: it holds what the contact and the cable exert.
    let force = statics.contacts[0].on_robot;
    let moment = cross(contact.point, force);
    close(statics.pressed.moment, moment, 1e-12);
    let held = statics.clamp.moment + statics.cable.moment;
    close(held, -moment, 1e-9);
    solved(&at_two_links());
    solved(&at_a_face());
}

/// A quarter turn and a shift: forces turn, moments about the base stay.
#[test]
fn a_base_elsewhere_changes_no_force() {
    for here in [at_the_first_link(), at_two_links(), at_a_face()] {
        let mut there = here.clone();
        there.robot.base_mm = [310.0, -120.0];
        there.robot.base_angle_deg = 90.0;
        for obstacle in &mut there.obstacles {
            if let Shape::Disc { center_mm, .. } = &mut obstacle.shape {
                *center_mm = [310.0 - center_mm[1], -120.0 + center_mm[0]];
            }
        }
        let (_, solution, here) = solved(&here);
        let (.., there) = solved(&there);
        close(there.tension, here.tension, 1e-9);
        let alike = |a: Resultant, b: Resultant| {
            let turned = Vector::new(-a.force.y, a.force.x);
            let size = here.cable.force.norm();
            assert!((b.force - turned).norm() <= 1e-8 * size, "{a:?} {b:?}");
            assert!((b.moment - a.moment).abs() <= 1e-9 * size, "{a:?} {b:?}");
        };
        alike(here.pressed, there.pressed);
        alike(here.clamp, there.clamp);
        alike(here.cable, there.cable);
        for (a, b) in here.sections.iter().zip(&there.sections) {
            close(b.cable, a.cable, 1e-7);
            close(b.backbone, a.backbone, 1e-7);
            close(b.couple, a.couple, 1e-7);
        }
        let mean = Sections::of(&solution, 1.0).mean_tension();
        close(mean, solution.certificate.energy_slope, 1e-9);
    }
}

/// A force told beside where it acts leaves the forces in balance.
#[test]
fn moments_and_forces_fail_by_themselves() {
    let (problem, solution, _) = solved(&at_the_first_link());
    let mut beside = solution.solution().clone();
    beside.contacts[0].point += 1e-6 * Vector::new(0.0, 1.0);
    let beside = Solved::pair(problem.clone(), beside).unwrap();
    let statics = Statics::of(&beside, stiffness());
    assert!(statics.unbalanced_moment > Statics::BOUND);
    assert!(statics.unbalanced_force <= Statics::BOUND);
    assert!(!statics.balances());
    let mut stronger = solution.into_solution();
    stronger.contacts[0].multiplier *= 1.01;
    let stronger = Solved::pair(problem, stronger).unwrap();
    let statics = Statics::of(&stronger, stiffness());
    assert!(statics.unbalanced_force > Statics::BOUND);
    assert!(!statics.balances());
}

/// A post inside the coil, met after a full turn: the cable's loads count from
/// the straight shape.
#[test]
fn a_robot_that_meets_nothing_within_a_turn_is_loaded_from_no_pull_on() {
    let scene = Scene {
        obstacles: vec![disc(30.0, 0.0, 18.0).into()],
        ..Scene::default()
    };
    let problem = Problem::new(&scene).unwrap();
    let loading = LoadSteps::of(&problem, stiffness(), &[1.0]).unwrap();
    assert_eq!((loading.contact, loading.datum), (None, 0.0));
    close(loading.states[0].statics.tension, 1.0, 1e-6);
    // It is met a little beyond.
    let mut coiled = problem.clone();
    coiled.set_pull(53e-3);
    let solution = solve(&coiled, Start::Straight, Settings::default());
    let pressing = |s: &Solution| s.contacts.iter().any(|c| c.class == Class::Pressing);
    assert!(pressing(&solution));
    coiled.set_pull(50e-3);
    assert!(!pressing(&solve(
        &coiled,
        Start::Straight,
        Settings::default()
    )));
}

#[test]
fn what_is_no_stiffness_is_told_with_its_number() {
    let check = |found: Result<Stiffness, StiffnessError>, expected: &str| {
        assert_eq!(found.unwrap_err().to_string(), expected);
    };
    check(
        Stiffness::new(-2e-6),
        "a bending stiffness of -2 N mm² is not positive and finite; give one that is",
    );
    check(
        Stiffness::of_section(0.0, Profile::Rod { diameter: 1.0 }),
        "a bending stiffness of 0 N mm² is not positive and finite; give one that is",
    );
    let mut scene = Scene::default();
    scene.set_pull_mm(0.0);
    let (_, still, _) = solved(&scene);
    let no_pull = "at a pull of 0 mm the robot is not bent by its cable, so that no load calibrates \
                   its stiffness; give a load measured at a positive pull";
    check(Stiffness::calibrated(&still, 1.0), no_pull);
    scene.set_pull_mm(5.0);
    let (_, solution, _) = solved(&scene);
    for load in [-1.0, 0.0, f64::INFINITY] {
        let found = Stiffness::calibrated(&solution, load).unwrap_err();
        assert!(matches!(found, StiffnessError::NoLoad(_)), "{found:?}");
    }
    let text = "a load of -125 g cannot calibrate the stiffness; give a positive one";
    check(Stiffness::calibrated(&solution, -0.125 * 9.80665), text);
    scene.robot.bending_stiffness_nmm2 = Some(8000.0);
    close(
        Stiffness::of_scene(&scene).unwrap().unwrap().value(),
        8e-3,
        1e-12,
    );
}

#[test]
fn a_fitted_line_tells_what_it_misses() {
    // By hand: slope 0.9, intercept −0.1, residuals 0.1, 0.2, −0.7, 0.4.
    let line = LineFit::through(&[(0.0, 0.0), (1.0, 1.0), (2.0, 1.0), (3.0, 3.0)]).unwrap();
    close(line.rms_residual, (0.7_f64 / 4.0).sqrt(), 1e-12);
    close(line.at(2.0), 1.7, 1e-12);
    assert_eq!(line.points, 4);
    let far = LineFit::through(&[(1e6, 0.0), (1e6 + 1.0, 1.0), (1e6 + 2.0, 2.0)]).unwrap();
    close(far.slope, 1.0, 1e-9);
    let narrow = [(1e6, 0.0), (1e6 + 1e-8, 1.0), (1e6, 2.0)];
    assert_eq!(LineFit::through(&narrow), Err(FitError::NoSpread(3)));
    let zeros = [(0.0, 0.0), (0.0, 1.0), (0.0, 2.0)];
    assert_eq!(LineFit::through(&zeros), Err(FitError::NoSpread(3)));
    let texts = [
        (
            FitError::TooFew(2),
            "a fit needs at least 3 points and has 2",
        ),
        (
            FitError::NoSpread(4),
            "all 4 points of the fit have the same abscissa",
        ),
        (
            FitError::NotFinite(1),
            "point 1 of the fit, from 0, is not finite",
        ),
    ];
    for (error, text) in texts {
        assert_eq!(error.to_string(), text);
    }
}

/// A free tip goes as an arc's does, without solving.
#[test]
fn the_free_tip_is_the_solved_one() {
    let mut scene = Scene::default();
    scene.robot.base_mm = [5.0, 7.0];
    let problem = Problem::new(&scene).unwrap();
    let pulls = Sweep::pulls(1e-3, 9e-3, 5);
    assert_eq!(pulls.len(), 5);
    close(pulls[1], 3e-3, 1e-12);
    assert_eq!(pulls[0], 1e-3);
    close(pulls[4], 9e-3, 1e-15);
    assert_eq!(Sweep::pulls(0.0, 1.0, 1), [0.0, 1.0]);
    let free = Sweep::free(&problem, &pulls);
    let swept = Sweep::of(&problem, 18, &pulls).unwrap();
    assert_eq!(free.node, swept.node);
    for (a, b) in free.points.iter().zip(&swept.points) {
        assert_eq!((a.pull, a.pressing), (b.pull, b.pressing));
        close(a.x, b.x, 1e-9);
        close(a.y, b.y, 1e-9);
        close(a.angle, b.angle, 1e-9);
        close(a.energy_slope, b.energy_slope, 1e-9);
    }
    let errors = [
        (
            Sweep::of(&problem, 0, &pulls),
            "node 0 does not move or is not there; the robot's nodes that move are 1 to 18",
        ),
        (
            Sweep::of(&problem, 18, &[-0.3]),
            "a pull of -300.000 mm is outside what the segments allow, -286.90 to 176.40 mm",
        ),
    ];
    for (found, text) in errors {
        assert_eq!(found.unwrap_err().to_string(), text);
    }
    let ended = SweepError::NotReached {
        pull: 4e-3,
        status: Status::IterationLimit,
    };
    assert!(
        ended
            .to_string()
            .starts_with("the sweep stops at a pull of 4.000 mm: the allowed")
    );
}

/// Rates of the tip of a free robot that goes straight along a line.
fn rates(slopes: [f64; 3], bend: f64, touch: Touch) -> Rates {
    let line = |slope: f64| {
        let points: Vec<_> = (0..5)
            .map(|k| {
                let pull = 1e-3 * f64::from(k);
                (pull, slope * pull + bend * (pull - 2e-3).powi(2))
            })
            .collect();
        LineFit::through(&points).unwrap()
    };
    Rates {
        x: line(slopes[0]),
        y: line(slopes[1]),
        angle: line(slopes[2]),
        window: Window {
            first: 0.0,
            last: 4e-3,
        },
        node: 18,
        touch,
    }
}

#[test]
fn caveats_come_where_their_bounds_are_passed() {
    let caveats = |rates: Rates, friction: f64, tip: usize| {
        VirtualWork::new(8e-3, rates, friction)
            .unwrap()
            .caveats(tip)
    };
    let straight = |touch| rates([11.0, -3.0, -125.0], 0.0, touch);
    assert_eq!(caveats(straight(Touch::Never), 0.6, 18), []);
    assert_eq!(caveats(straight(Touch::Never), -0.6, 18), []);
    assert_eq!(
        caveats(straight(Touch::Never), -0.61, 18),
        [Caveat::Friction(-0.61)]
    );
    assert_eq!(
        caveats(straight(Touch::Sometimes), 0.0, 18),
        [Caveat::MeetsContact]
    );
    assert_eq!(
        caveats(straight(Touch::Always), 0.0, 18),
        [Caveat::SiteDependent]
    );
    let elsewhere = Caveat::NotAtTip { node: 18, tip: 20 };
    assert_eq!(caveats(straight(Touch::Never), 0.0, 20), [elsewhere]);
    // The parabola misses its line by 2 mm² at the middle, of what y spans, 12 mm.
    let share = 0.05;
    let bend = |share: f64| share * 12e-3 / 2e-6;
    let curved = |share: f64| rates([1e3, -3.0, -1e5], bend(share), Touch::Never);
    assert_eq!(caveats(curved(0.99 * share), 0.0, 18), []);
    let [
        Caveat::Curved {
            coordinate: "y",
            share: found,
            r_squared,
        },
    ] = caveats(curved(1.01 * share), 0.0, 18)[..]
    else {
        panic!("{:?}", caveats(curved(1.01 * share), 0.0, 18))
    };
    close(found, 1.01 * share, 1e-9);
    assert!(r_squared > 0.9 && r_squared < 1.0);
    let texts = [
        (
            elsewhere,
            "Eq. 8 to 11 were derived for contact at the tip (node 20), not at node 18",
        ),
        (
            Caveat::Curved {
                coordinate: "y",
                r_squared: 0.98765,
                share: 0.12,
            },
            "y is not linear on this window: R² is 0.9877, and the line misses by up to 12 % of \
             what it spans",
        ),
        (
            Caveat::MeetsContact,
            "Contact begins or ends inside the window, so that the lines mix two motions",
        ),
        (
            Caveat::Friction(-0.9876),
            "|μ| = 0.988 is a calibration factor: dry plastics slide with 0.1 to 0.6",
        ),
        (
            Caveat::SiteDependent,
            "The slopes are those of a robot that touches, and hold for this obstacle only",
        ),
    ];
    for (caveat, text) in texts {
        assert_eq!(caveat.to_string(), text);
    }
}

/// Eq. 11 and eq. 10 with numbers.
#[test]
fn the_estimate_is_that_of_the_equation() {
    let estimator = VirtualWork::new(8e-3, rates([11.0, -3.0, -125.0], 0.0, Touch::Never), 0.5);
    let estimator = estimator.unwrap();
    close(estimator.work(), 9.5, 1e-9);
    close(estimator.force_per_load(), 1.0 / 9.5, 1e-9);
    let force = estimator.force(2.0).unwrap();
    close(force.x, 2.0 / 9.5, 1e-9);
    close(force.y, 1.0 / 9.5, 1e-9);
    let rates_of = || rates([11.0, -3.0, -125.0], 0.0, Touch::Never);
    let calibrated = VirtualWork::calibrated(8e-3, rates_of(), 2.0, 0.2).unwrap();
    close(calibrated.friction(), (10.0 - 11.0) / -3.0, 1e-8);
    assert_eq!(*calibrated.rates(), rates_of());
    let level = rates([11.0, 0.0, -125.0], 0.0, Touch::Never);
    assert_eq!(
        VirtualWork::calibrated(8e-3, level, 2.0, 0.2),
        Err(VirtualWorkError::NoSlide)
    );
    for (load, force) in [
        (-1.0, 1.0),
        (1.0, -1.0),
        (f64::INFINITY, 1.0),
        (1.0, f64::INFINITY),
    ] {
        let found = VirtualWork::calibrated(8e-3, rates_of(), load, force).unwrap_err();
        assert!(
            matches!(found, VirtualWorkError::NotMeasured { .. }),
            "{found:?}"
        );
    }
    for load in [-1.0, 0.0, f64::INFINITY] {
        let found = estimator.force(load).unwrap_err();
        assert!(matches!(found, VirtualWorkError::NoLoad(_)), "{found:?}");
    }
    let error = VirtualWorkError::NotMeasured {
        load: 0.0,
        force: 9.80665e-3,
    };
    let text = "a load of 0 g with a force of 1 g cannot calibrate mu; both have to be positive";
    assert_eq!(error.to_string(), text);
}

/// Ends of a window count in, also where rounding put them.
#[test]
fn a_window_holds_its_ends() {
    let problem = Problem::new(&Scene::default()).unwrap();
    let sweep = Sweep::free(&problem, &Sweep::pulls(0.0, 6e-3, 7));
    let count = |first: f64, last: f64| {
        let rates = Rates::fit(&sweep, Window { first, last }).unwrap();
        assert_eq!((rates.node, rates.touch), (18, Touch::Never));
        rates.x.points
    };
    assert_eq!(count(1e-3, 5e-3), 5);
    assert_eq!(count(1e-3 + 1e-13, 5e-3 - 1e-13), 5);
    assert_eq!(count(1e-3 + 1e-10, 5e-3 - 1e-10), 3);
    assert_eq!(count(0.5e-3, 5.5e-3), 5);
}
