//! Forces against closed forms, finite differences of the energy and the
//! balance of the whole robot; the virtual-work estimator against its equations.

use sinew::contact::Class;
use sinew::equilibrium::{Settings, Solved, Start, Status, solve};
use sinew::forces::{
    Caveat, FitError, LineFit, LoadSteps, Loaded, Profile, Rates, Sections, Statics, Stiffness,
    Sweep, SweepError, VirtualWork, VirtualWorkError, Window, share_of_tension,
};
use sinew::geometry::Vector;
use sinew::mechanics::Problem;
use sinew::scene::{Candidates, Scene, Shape};
use sinew::units::{grams, metres, newtons};

fn scene(name: &str) -> Scene {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/assets/scenes");
    let text = std::fs::read_to_string(format!("{folder}/{name}.toml")).unwrap();
    Scene::from_toml(&text).unwrap()
}

fn problem(name: &str) -> Problem {
    Problem::new(&scene(name)).unwrap()
}

fn at(problem: &Problem, pull_mm: f64) -> Problem {
    let mut moved = problem.clone();
    moved.set_pull(metres(pull_mm));
    moved
}

#[track_caller]
fn solved(problem: &Problem) -> Solved {
    let solution = solve(problem, Start::Straight, Settings::default());
    assert_eq!(solution.status, Status::Converged);
    assert!(solution.certificate.holds());
    solution
}

/// ABS of 2.2 GPa, a rod of 3 mm: of the prototype's order.
fn stiffness() -> Stiffness {
    Stiffness::of_section(2.2e9, Profile::Rod { diameter: 3e-3 }).unwrap()
}

#[track_caller]
fn close(found: f64, expected: f64, relative: f64) {
    let error = (found - expected).abs();
    assert!(
        error <= relative * expected.abs(),
        "{found:e} is not {expected:e}: off by {:e}",
        error / expected.abs()
    );
}

const SCENES: [&str; 6] = [
    "free",
    "one-disc",
    "two-discs",
    "load-cell",
    "body-contact",
    "shapes",
];

#[test]
fn the_free_robots_tension_is_that_of_the_arc() {
    let free = problem("free");
    for pull_mm in [0.01, 1.0, 5.0, 10.0, 30.0] {
        let problem = at(&free, pull_mm);
        let solution = solved(&problem);
        let statics = Statics::of(&solution, stiffness());
        // J = n β*², β* = 2 asin(l/2an), so dJ/dl = 2β*/(a cos(β*/2)).
        let (a, n) = (0.008, 18.0);
        let bend: f64 = 2.0 * (metres(pull_mm) / (2.0 * a * n)).asin();
        let slope = 2.0 * bend / (a * (0.5 * bend).cos());
        close(statics.tension, stiffness().value() / 0.02 * slope, 1e-9);
        // With nothing touching, every link carries all of it.
        for section in &statics.sections {
            close(section.cable, statics.tension, 1e-9);
            close(section.backbone, statics.tension, 1e-9);
        }
    }
}

#[test]
fn forces_and_moments_of_the_whole_robot_balance() {
    for name in SCENES {
        for pull_mm in [0.3, 3.0, 4.9, 6.0, 8.0] {
            let problem = at(&problem(name), pull_mm);
            let solution = solved(&problem);
            let statics = Statics::of(&solution, stiffness());
            assert!(
                statics.balances(),
                "{name} at {pull_mm}: {:e}, {:e}",
                statics.unbalanced_force,
                statics.unbalanced_moment
            );
        }
    }
}

#[test]
fn sections_find_the_tension_that_the_certificate_finds() {
    for name in SCENES {
        let problem = at(&problem(name), 6.0);
        let solution = solved(&problem);
        let sections = Sections::of(&solution, 1.0);
        close(
            sections.mean_tension(),
            solution.certificate.energy_slope,
            1e-9,
        );
    }
}

#[test]
fn a_shape_that_is_no_equilibrium_does_not_balance() {
    let problem = problem("one-disc");
    let mut solution = solved(&problem).into_solution();
    solution.contacts[0].multiplier *= 1.01;
    let solution = Solved::pair(problem, solution).unwrap();
    let statics = Statics::of(&solution, stiffness());
    assert!(!statics.balances());
}

/// U of a problem, in J.
fn strain_energy(problem: &Problem) -> f64 {
    stiffness().per_bend(problem) * solved(problem).energy
}

#[test]
fn tension_is_the_energys_slope_in_the_pull() {
    for (name, pull_mm) in [("free", 5.0), ("one-disc", 6.0), ("load-cell", 5.0)] {
        let problem = problem(name);
        // Central differences of third order error: 1e-2 mm over 5 mm leaves 1e-6.
        let step = 0.01;
        let energy = |pull_mm| strain_energy(&at(&problem, pull_mm));
        let slope = (energy(pull_mm + step) - energy(pull_mm - step)) / metres(2.0 * step);
        let there = at(&problem, pull_mm);
        let statics = Statics::of(&solved(&there), stiffness());
        close(statics.tension, slope, 1e-5);
    }
}

#[test]
fn a_contact_force_is_the_energys_slope_in_the_obstacles_advance() {
    let there = problem("one-disc");
    let solution = solved(&there);
    let [contact] = solution.contacts[..] else {
        panic!("{:?}", solution.contacts)
    };
    let step = 1e-5;
    let energy = |advance: f64| {
        let mut moved = there.clone();
        moved.set_obstacle(0, there.obstacles()[0].moved(advance * contact.normal));
        strain_energy(&moved)
    };
    let slope = (energy(step) - energy(-step)) / (2.0 * step);
    let statics = Statics::of(&solution, stiffness());
    // The first-order change is the advance along the normal; a round post
    // that slides has curvature in the second order only.
    close(statics.contacts[0].normal_force, slope, 1e-4);
    assert_eq!(statics.contacts[0].contact.class, Class::Pressing);
}

#[test]
fn a_turned_robot_has_turned_forces() {
    let straight = scene("load-cell");
    let mut turned = straight.clone();
    turned.robot.base_angle_deg = 90.0;
    turned.obstacles[0].shape = Shape::Wall {
        point_mm: [-127.0, 26.0],
        rotation_deg: 270.0,
        corner_radius_mm: 0.0,
    };
    let of = |scene: &Scene| {
        let problem = Problem::new(scene).unwrap();
        Statics::of(&solved(&problem), stiffness())
    };
    let (here, there) = (of(&straight), of(&turned));
    close(there.tension, here.tension, 1e-9);
    close(there.clamp.moment, here.clamp.moment, 1e-7);
    let quarter = Vector::new(-here.clamp.force.y, here.clamp.force.x);
    assert!((there.clamp.force - quarter).norm() <= 1e-7 * here.clamp.force.norm());
    // The load cell pushes the robot back, away from the cable's side.
    assert!(here.contacts[0].on_robot.x < 0.0);
    assert!(here.contacts[0].on_robot.y.abs() < 1e-12);
}

#[test]
fn the_ratio_of_force_to_tension_needs_no_stiffness() {
    let problem = problem("two-discs");
    let solution = solved(&problem);
    for value in [1e-3, 1.0] {
        let statics = Statics::of(&solution, Stiffness::new(value).unwrap());
        for force in &statics.contacts {
            let ratio = share_of_tension(&solution, &force.contact).unwrap();
            close(force.normal_force / statics.tension, ratio, 1e-12);
        }
    }
}

#[test]
fn a_stiffness_comes_from_a_number_a_section_or_a_weighed_pull() {
    let close_to =
        |profile: Profile, expected: f64| close(profile.second_moment(), expected, 1e-12);
    let pi = std::f64::consts::PI;
    close_to(Profile::Rod { diameter: 2.0 }, pi / 4.0);
    close_to(
        Profile::Tube {
            outer: 2.0,
            inner: 1.0,
        },
        pi / 4.0 * 15.0 / 16.0,
    );
    close_to(
        Profile::Strip {
            width: 3.0,
            thickness: 2.0,
        },
        2.0,
    );
    let there = problem("free");
    let solution = solved(&there);
    let load = newtons(350.0);
    let calibrated = Stiffness::calibrated(&solution, load).unwrap();
    let tension = Statics::of(&solution, calibrated).tension;
    close(grams(tension), 350.0, 1e-12);
    for wrong in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(Stiffness::new(wrong).is_err());
        assert!(Stiffness::calibrated(&solution, wrong).is_err());
    }
    let straight = at(&there, 0.0);
    let still = solved(&straight);
    assert!(Stiffness::calibrated(&still, load).is_err());
}

#[test]
fn lines_are_those_of_least_squares() {
    let line = LineFit::through(&[(0.0, 1.0), (1.0, 3.0), (2.0, 5.0)]).unwrap();
    assert_eq!(
        (line.slope, line.intercept, line.r_squared),
        (2.0, 1.0, 1.0)
    );
    // By hand: Σdx² = 5, Σdxdy = 4.5, Σdy² = 4.75, means 1.5 and 1.25.
    let line = LineFit::through(&[(0.0, 0.0), (1.0, 1.0), (2.0, 1.0), (3.0, 3.0)]).unwrap();
    close(line.slope, 0.9, 1e-12);
    close(line.intercept, -0.1, 1e-12);
    close(line.r_squared, 0.81 * 5.0 / 4.75, 1e-12);
    close(line.max_residual, 0.7, 1e-12);
    let check = |points: &[(f64, f64)], expected| {
        assert_eq!(LineFit::through(points), Err(expected));
    };
    check(&[(0.0, 0.0), (1.0, 1.0)], FitError::TooFew(2));
    check(&[(1.0, 0.0), (1.0, 1.0), (1.0, 2.0)], FitError::NoSpread(3));
    check(
        &[(1.0, 0.0), (f64::NAN, 1.0), (2.0, 2.0)],
        FitError::NotFinite(1),
    );
    let level = LineFit::through(&[(0.0, 2.0), (1.0, 2.0), (2.0, 2.0)]).unwrap();
    assert_eq!((level.slope, level.r_squared), (0.0, 1.0));
}

/// The free robot's tip rates on a window that starts at no pull.
fn rates(to_mm: f64) -> Rates {
    let pulls = Sweep::pulls(0.0, metres(to_mm), 41);
    let sweep = Sweep::of(&problem("free"), 18, &pulls).unwrap();
    let window = Window {
        first: 0.0,
        last: metres(to_mm),
    };
    Rates::fit(&sweep, window).unwrap()
}

#[test]
fn small_motions_have_the_rates_of_a_beam() {
    // The arc through small pulls: x = Lθ/2, θ = l/a, y falls as l².
    let rates = rates(0.01);
    close(rates.x.slope, 0.18 / 0.016, 1e-4);
    close(rates.angle.slope, -1.0 / 0.008, 1e-6);
    assert!(rates.y.slope.abs() < 0.01);
}

#[test]
fn virtual_work_sums_to_zero() {
    let (offset, load) = (0.008, newtons(250.0));
    let rates = rates(10.0);
    let estimator = VirtualWork::new(offset, rates, -0.3).unwrap();
    let force = estimator.force(load).unwrap();
    let work =
        force.x * rates.x.slope + force.y * rates.y.slope + offset * load * rates.angle.slope;
    assert!(work.abs() < 1e-12 * force.x * rates.x.slope, "{work:e}");
    close(force.y, -0.3 * force.x, 1e-15);
    // Drawn in, the robot presses towards its cable.
    assert!(force.x > 0.0);
}

#[test]
fn a_measured_point_fixes_mu_and_every_other_force() {
    let (load, force) = (newtons(250.0), newtons(17.8));
    for to_mm in [8.0, 14.0, 20.0] {
        let estimator = VirtualWork::calibrated(0.008, rates(to_mm), load, force).unwrap();
        close(estimator.force(load).unwrap().x, force, 1e-12);
        let half = estimator.force(0.5 * load).unwrap().x;
        close(half, 0.5 * force, 1e-12);
        // Friction as large as the force itself, whatever the window.
        assert!(
            (-1.05..-0.85).contains(&estimator.friction()),
            "{}",
            estimator.friction()
        );
        let caveats = estimator.caveats(18);
        assert!(caveats.iter().any(|c| matches!(c, Caveat::Friction(_))));
    }
}

#[test]
fn what_cannot_be_estimated_is_told() {
    let rates = rates(10.0);
    let load = newtons(100.0);
    for wrong in [0.0, -1.0, f64::NAN] {
        let estimator = VirtualWork::new(0.008, rates, 0.0).unwrap();
        assert!(matches!(
            estimator.force(wrong),
            Err(VirtualWorkError::NoLoad(_))
        ));
        assert!(VirtualWork::calibrated(0.008, rates, wrong, load).is_err());
        assert!(VirtualWork::calibrated(0.008, rates, load, wrong).is_err());
    }
    let across = -rates.x.slope / rates.y.slope;
    assert!(matches!(
        VirtualWork::new(0.008, rates, across),
        Err(VirtualWorkError::NoWork { .. })
    ));
    let free = problem("free");
    let sweep = Sweep::of(&free, 18, &Sweep::pulls(0.0, 0.01, 3)).unwrap();
    let narrow = Window {
        first: 0.0,
        last: 0.006,
    };
    assert!(matches!(
        Rates::fit(&sweep, narrow),
        Err(VirtualWorkError::Window {
            fit: FitError::TooFew(2),
            ..
        })
    ));
    assert!(matches!(
        Sweep::of(&free, 19, &[0.0]),
        Err(SweepError::NoSuchNode { node: 19, last: 18 })
    ));
    assert!(matches!(
        Sweep::of(&free, 18, &[0.0, 1.0]),
        Err(SweepError::OutOfRange { .. })
    ));
}

#[test]
fn an_estimate_says_where_it_leaves_its_assumptions() {
    let cell = problem("load-cell");
    let pulls = Sweep::pulls(0.0, 0.006, 25);
    let sweep = Sweep::of(&cell, 14, &pulls).unwrap();
    let window = |first, last| Window { first, last };
    let caveats = |window| {
        let rates = Rates::fit(&sweep, window).unwrap();
        VirtualWork::new(0.008, rates, 0.0).unwrap().caveats(18)
    };
    let at_node = Caveat::NotAtTip { node: 14, tip: 18 };
    // Contact begins at 2.70 mm.
    assert_eq!(caveats(window(0.0, 0.001)).first(), Some(&at_node));
    assert!(caveats(window(0.0, 0.006)).contains(&Caveat::MeetsContact));
    assert!(caveats(window(0.003, 0.006)).contains(&Caveat::SiteDependent));
    let wide = rates(20.0);
    let estimator = VirtualWork::new(0.008, wide, 0.0).unwrap();
    let curved = |c: &Caveat| {
        matches!(
            c,
            Caveat::Curved {
                coordinate: "y",
                ..
            }
        )
    };
    assert!(estimator.caveats(18).iter().any(curved));
    let narrow = VirtualWork::new(0.008, rates(0.01), 0.0).unwrap();
    assert!(
        !narrow
            .caveats(18)
            .iter()
            .any(|c| matches!(c, Caveat::NotAtTip { .. }))
    );
}

#[test]
fn the_whole_body_balances_wherever_it_touches() {
    let mut scene = scene("shapes");
    scene.contact.candidates = Candidates::Body;
    scene.robot.disk_radius_mm = Some(10.0);
    for pull_mm in [2.0, 6.0, 9.0] {
        scene.set_pull_mm(pull_mm);
        let problem = Problem::new(&scene).unwrap();
        let solution = solved(&problem);
        let statics = Statics::of(&solution, stiffness());
        assert!(statics.balances(), "{statics:?}");
    }
}

#[test]
fn loads_count_from_contact_and_are_met() {
    let cell = problem("load-cell");
    let loads = [350.0, 50.0, 100.0].map(newtons);
    let loading = LoadSteps::of(&cell, stiffness(), &loads).unwrap();
    let begins = at(&cell, 1e3 * loading.contact.unwrap());
    let solution = solved(&begins);
    close(
        loading.datum,
        Statics::of(&solution, stiffness()).tension,
        1e-9,
    );
    // Contact only just begins there, at the pull known from the scene file.
    assert!((1e3 * loading.contact.unwrap() - 2.70).abs() < 0.005);
    for (state, load) in loading.states.iter().zip(loads) {
        assert_eq!(state.load, load);
        close(state.statics.tension, loading.datum + load, 1e-6);
        assert!(state.statics.balances());
    }
    let force = |k: usize| state_force(&loading.states[k]);
    assert!(force(0) > force(2) && force(2) > force(1));
    // A free robot's loads are its whole tension.
    let free = LoadSteps::of(&problem("free"), stiffness(), &[newtons(100.0)]).unwrap();
    assert_eq!((free.contact, free.datum), (None, 0.0));
    close(grams(free.states[0].statics.tension), 100.0, 1e-6);
    assert_eq!(free.end, None);
    // More than the linkage can carry, with a load that it can.
    let loads = [1e6, newtons(100.0)];
    let heavy = LoadSteps::of(&problem("free"), stiffness(), &loads).unwrap();
    assert_eq!(heavy.states.len(), 1);
    assert_eq!(heavy.states[0].pull, free.states[0].pull);
    assert!(matches!(heavy.end, Some(SweepError::NotReached { pull, .. }) if pull > 0.176));
}

fn state_force(state: &Loaded) -> f64 {
    let contacts = state.statics.contacts.iter();
    contacts.map(|contact| contact.normal_force).sum()
}
