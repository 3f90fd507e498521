//! The robot along its whole pull: closed forms, the other ways to the same
//! numbers, and what has to hold of jumps, ends and slices.

use sinew::equilibrium::{Occurrence, Progress, Run, Settings, Solved, Start, Status, solve};
use sinew::explore::{LoadCurve, Path, PathRun};
use sinew::forces::{LoadSteps, Stiffness, Sweep};
use sinew::geometry::Vector;
use sinew::mechanics::Problem;
use sinew::record::path::{COLUMNS, rows};
use sinew::scene::{Candidates, Line, Listed, Scene, Shape};

const FREE: &str = include_str!("../assets/scenes/free.toml");
const TWO_DISCS: &str = include_str!("../assets/scenes/two-discs.toml");
const LOAD_CELL: &str = include_str!("../assets/scenes/load-cell.toml");

fn problem(text: &str) -> Problem {
    Problem::new(&Scene::from_toml(text).unwrap()).unwrap()
}

/// The free robot with one post.
fn with_post(center_mm: [f64; 2], radius_mm: f64) -> Problem {
    let mut scene = Scene::from_toml(FREE).unwrap();
    let post = Shape::Disc {
        center_mm,
        radius_mm,
    };
    scene.obstacles.push(post.into());
    Problem::new(&scene).unwrap()
}

/// A post at the tip that the robot slips off in two jumps.
fn slippery() -> Problem {
    with_post([44.0, 170.0], 8.0)
}

fn solved(problem: &Problem, pull: f64) -> Solved {
    let mut there = problem.clone();
    there.set_pull(pull);
    solve(&there, Start::Straight, Settings::default())
}

fn jumps(path: &Path) -> Vec<f64> {
    let events = path.events.iter();
    let jumps = events.filter(|event| matches!(event.what, Occurrence::Jump { .. }));
    jumps.map(|event| event.pull).collect()
}

#[test]
fn the_free_robot_is_an_arc_at_every_pull() {
    let free = problem(FREE);
    let robot = *free.robot();
    let n = robot.segments as f64;
    let path = PathRun::over(&free, -0.010, 0.030, 81).finish();
    assert!(path.end.is_none() && path.start.is_none() && path.events.is_empty());
    assert_eq!(path.pieces().count(), 1);
    // 81 equal pulls hold both 0 and the scene's 10 mm, to rounding.
    assert!((81..=83).contains(&path.states.len()));
    assert!(path.states.windows(2).all(|w| w[0].pull < w[1].pull));
    assert!(path.states.iter().any(|state| state.pull == free.pull()));
    for state in &path.states {
        let bend = 2.0 * (state.pull / (2.0 * robot.offset * n)).asin();
        // Links point along the mean of their disks' normals.
        let links = (0..robot.segments).map(|i| (i as f64 + 0.5) * bend);
        let tip = links.fold(Vector::zeros(), |at, angle| {
            at + robot.length / n * Vector::new(angle.sin(), angle.cos())
        });
        assert!((state.tip.position - tip).norm() < 1e-12, "{state:?}");
        assert!((state.tip.angle + n * bend).abs() < 1e-11);
        // asin x is within x³/5 of x here.
        let arc = -state.pull / robot.offset;
        let cubed = (state.pull / (2.0 * robot.offset * n)).powi(3).abs();
        assert!((state.tip.angle - arc).abs() <= 0.4 * n * cubed + 1e-11);
        assert!((state.energy - n * bend * bend).abs() < 1e-11);
        let slope = 2.0 * bend / (robot.offset * (0.5 * bend).cos());
        assert!((state.energy_slope - slope).abs() < 1e-7 * (1.0 + slope.abs()));
        assert!(state.contacts.is_empty());
    }
}

#[test]
fn a_path_is_the_sweep_of_the_same_pulls() {
    let problem = problem(TWO_DISCS);
    let pulls = Sweep::pulls(0.0, 0.006, 41);
    let path = PathRun::new(&problem, pulls.clone()).finish();
    let sweep = Sweep::of(&problem, problem.robot().segments, &pulls).unwrap();
    // The path has the corners' two sides besides.
    assert!(path.states.len() > sweep.points.len());
    for point in &sweep.points {
        let state = path.states.iter().find(|s| s.pull == point.pull).unwrap();
        let (tip, length) = (state.tip, problem.length());
        let there = Vector::new(point.x, point.y);
        assert!((tip.position - there).norm() < 1e-9 * length, "{point:?}");
        assert!((tip.angle - point.angle).abs() < 1e-9);
        let slope = point.energy_slope;
        assert!((state.energy_slope - slope).abs() < 1e-6 * (1.0 + slope));
        assert_eq!(state.contacts.len(), point.pressing);
    }
    let made: Vec<usize> = path
        .events
        .iter()
        .filter_map(|event| match event.what {
            Occurrence::ContactMade { obstacle, .. } => Some(obstacle),
            _ => None,
        })
        .collect();
    assert!(made.contains(&0) && made.contains(&1), "{made:?}");
}

#[test]
fn the_free_tip_needs_no_solving() {
    let free = problem(FREE);
    let pulls = Sweep::pulls(-0.004, 0.020, 25);
    let path = PathRun::new(&free, pulls.clone()).finish();
    let solved = path.tip_sweep(free.robot().segments);
    // Obstacles do not matter to it.
    let known = Sweep::free(&problem(TWO_DISCS), &pulls);
    assert_eq!((known.node, known.points.len()), (solved.node, 25));
    for (a, b) in known.points.iter().zip(&solved.points) {
        assert_eq!(a.pull, b.pull);
        assert!((a.x - b.x).hypot(a.y - b.y) < 1e-12 && (a.angle - b.angle).abs() < 1e-11);
        assert!((a.energy_slope - b.energy_slope).abs() < 1e-7 * (1.0 + b.energy_slope.abs()));
    }
}

#[test]
fn slices_of_any_size_give_the_same_path() {
    for problem in [problem(TWO_DISCS), slippery()] {
        let whole = PathRun::over(&problem, -0.002, 0.008, 30).finish();
        assert!(whole.states.len() > 30);
        for slice in [1, 7, 100_000] {
            let mut run = PathRun::over(&problem, -0.002, 0.008, 30);
            let mut share = run.share();
            while run.advance(slice) == Progress::Running {
                assert!(run.share() >= share && run.share() < 1.0);
                share = run.share();
            }
            assert_eq!(run.path(), &whole);
            assert_eq!(run.share(), 1.0);
        }
    }
}

#[test]
fn both_sides_of_a_jump_are_met_and_known_as_two_branches() {
    let problem = slippery();
    let path = PathRun::over(&problem, 0.0, 0.010, 101).finish();
    let jumps = jumps(&path);
    assert_eq!(jumps.len(), 2, "{jumps:?}");
    let pieces: Vec<_> = path.pieces().collect();
    assert_eq!(pieces.len(), 3);
    let grain = 1e-5 * problem.length();
    for (pair, jump) in pieces.windows(2).zip(&jumps) {
        let (before, after) = (&pair[0][pair[0].len() - 1], &pair[1][0]);
        assert!(before.pull < *jump && *jump <= after.pull);
        assert!(after.pull - before.pull <= 3.0 * grain, "{before:?}");
        // It falls to a shape of less energy, and visibly elsewhere.
        assert!(after.energy < before.energy);
        assert!((after.tip.position - before.tip.position).norm() > 1e-3);
    }
    // What any other run finds is on the path, whatever its steps …
    for k in 0..40 {
        let pull = 0.010 * (f64::from(k) + 0.37) / 40.0;
        if jumps.iter().all(|jump| (jump - pull).abs() > 3.0 * grain) {
            assert!(!path.differs_from(&solved(&problem, pull)), "{pull}");
        }
    }
    // … but a robot that is let out again comes back against the post from
    // above and hangs on it.
    let mut run = Run::new(&problem, Start::Straight, Settings::default());
    let mut back = problem.clone();
    let differs: Vec<bool> = [0.004, 0.0065, 0.0050, 0.001]
        .iter()
        .map(|pull| {
            back.set_pull(*pull);
            run.retarget(&back);
            assert_eq!(run.finish().status, Status::Converged);
            path.differs_from(run.solution())
        })
        .collect();
    assert_eq!(differs, [false, false, true, true]);
}

#[test]
fn a_path_ends_where_the_robot_does() {
    let problem = with_post([44.0, 150.0], 8.0);
    let path = PathRun::over(&problem, 0.0, 0.016, 101).finish();
    let end = path.end.clone().unwrap();
    assert!(matches!(end.status, Status::BranchEnded { .. }));
    assert!((0.012..0.013).contains(&end.pull), "{end:?}");
    // The last state is the end itself, not the last pull of the list.
    assert_eq!(path.states.last().unwrap().pull, end.pull);
    assert_eq!(path.at(end.pull + 1e-4), None);
    let beyond = solve(&problem, Start::Direct, Settings::default());
    assert!(beyond.pull < end.pull);
    assert_eq!(path.range(), Some((0.0, end.pull)));
}

#[test]
fn pulls_below_zero_mirror_those_above() {
    // Posts beside the backbone's nodes, as far on either side.
    let scene = |x: f64| {
        let mut scene = Scene::from_toml(FREE).unwrap();
        scene.contact.candidates = Candidates::Listed;
        scene.contact.listed = (1..=18)
            .map(|node| Listed {
                line: Line::Backbone,
                cable: 0,
                node,
            })
            .collect();
        let post = Shape::Disc {
            center_mm: [x, 120.0],
            radius_mm: 8.0,
        };
        scene.obstacles.push(post.into());
        Problem::new(&scene).unwrap()
    };
    let right = PathRun::new(&scene(40.0), Sweep::pulls(0.0, 0.006, 31)).finish();
    let left = PathRun::new(&scene(-40.0), Sweep::pulls(-0.006, 0.0, 31)).finish();
    let made = |path: &Path| path.events.len();
    assert!(made(&right) > 0 && made(&right) == made(&left));
    assert_eq!(right.states.len(), left.states.len());
    for (a, b) in right.states.iter().zip(left.states.iter().rev()) {
        assert_eq!(a.contacts.len(), b.contacts.len());
        assert!((a.tip.position.y - b.tip.position.y).abs() < 1e-3, "{a:?}");
    }
}

#[test]
fn any_pull_between_states_is_on_the_path() {
    let problem = problem(TWO_DISCS);
    let path = PathRun::over(&problem, 0.0, 0.008, 81).finish();
    for k in 0..50 {
        let pull = 0.008 * (f64::from(k) + 0.31) / 50.0;
        let solution = solved(&problem, pull);
        assert!(!path.differs_from(&solution), "{pull}");
        let there = path.at(pull).unwrap();
        assert_eq!(there.pull, pull);
        // Steps of 0.1 mm: straight lines err by h²/8 times the curvature, which
        // is a few times 1/offset. Corners are states.
        let apart = (there.tip.position - solution.tip().position).norm();
        assert!(apart < 5e-6, "{pull} {apart}");
        assert!((there.energy - solution.energy).abs() < 3e-6 + 1e-3 * solution.energy);
        let pressure: f64 = solution.contacts.iter().map(|c| c.multiplier).sum();
        assert!((there.total_multiplier() - pressure).abs() < 0.02 * (1.0 + pressure));
    }
    // The problem's own pull was met exactly.
    let own = solve(&problem, Start::Straight, Settings::default());
    let state = path.states.iter().find(|s| s.pull == problem.pull());
    let apart = (state.unwrap().tip.position - own.tip().position).norm();
    assert!(apart < 1e-9 * problem.length(), "{apart}");
}

#[test]
fn the_tip_is_dragged_along_the_piece_it_is_on() {
    let free = problem(FREE);
    let offset = free.robot().offset;
    // Two full turns: the tip meets the base after each.
    let turn = std::f64::consts::TAU * offset;
    let path = PathRun::over(&free, 0.0, 2.1 * turn, 421).finish();
    let step = 2.1 * turn / 420.0;
    for state in path.states.iter().step_by(13) {
        let near = path.nearest_to_tip_from(state.tip.position, state.pull + 3.0 * step);
        assert!((near.unwrap() - state.pull).abs() < 1e-9, "{state:?}");
    }
    // n links at equal angles close at these pulls.
    let (base, n) = (Vector::zeros(), free.robot().segments as f64);
    for turns in [1.0, 2.0] {
        let closed = 2.0 * offset * n * (std::f64::consts::PI * turns / n).sin();
        let near = path.nearest_to_tip_from(base, closed - 0.1 * turn).unwrap();
        assert!((near - closed).abs() < 0.1 * step, "{near} {closed}");
    }
    // From above the straight robot, the straight robot.
    let above = Vector::new(0.0, 1.0);
    assert_eq!(path.nearest_to_tip(above), Some(0.0));
    assert_eq!(path.nearest_to_tip_from(above, 0.2 * turn), Some(0.0));
    assert_eq!(Path::default().nearest_to_tip(above), None);
    // A jump is crossed once its other side is nearer.
    let path = PathRun::over(&slippery(), 0.0, 0.010, 101).finish();
    let after = &path.pieces().nth(1).unwrap()[2];
    let pulled = path.nearest_to_tip_from(after.tip.position, after.pull - 2e-4);
    assert!((pulled.unwrap() - after.pull).abs() < 1e-9);
}

/// At a contact the tip's path turns back for a few millimetres before it goes on.
#[test]
fn a_dragged_tip_goes_past_where_its_path_turns_back() {
    let posts = problem(include_str!("../assets/scenes/two-posts.toml"));
    let path = PathRun::over(&posts, 0.0, 0.025, 201).finish();
    let tip_at = |pull: f64| path.at(pull).unwrap().tip.position;
    let first = 0.00555;
    // Straight towards where the tip is at a greater pull.
    for last in [0.008, 0.010, 0.012] {
        let (from, to) = (tip_at(first), tip_at(last));
        let mut pull = first;
        let mut pulls = vec![pull];
        for step in 1..=60 {
            let at = from + f64::from(step) / 60.0 * (to - from);
            pull = path.nearest_to_tip_from(at, pull).unwrap();
            pulls.push(pull);
        }
        // Where two places are as near, either will do.
        let off = (tip_at(pull) - to).norm();
        assert!(off < 0.01 * path.length, "{last}: {pulls:?}");
        assert!((pull - last).abs() < 1e-3, "{last}: {pulls:?}");
        // A hand that trembles does not make it hop to and fro.
        for at in pulls.iter().step_by(7) {
            let place = tip_at(*at);
            let mut pull = *at;
            for tremble in [2e-4, -2e-4, 2e-4, -2e-4] {
                let at = place + Vector::new(tremble, tremble);
                let next = path.nearest_to_tip_from(at, pull).unwrap();
                assert!((next - pull).abs() < 1e-3, "{pull} {next}");
                pull = next;
            }
        }
    }
}

#[test]
fn the_load_curve_goes_through_the_loaded_states() {
    let problem = problem(LOAD_CELL);
    // Steps a quarter as wide must err by a sixteenth.
    let stiffness = Stiffness::new(0.02).unwrap();
    let loads = [0.3, 0.7, 1.3, 2.0];
    let loading = LoadSteps::of(&problem, stiffness, &loads).unwrap();
    let error = |count: usize| {
        let path = PathRun::over(&problem, 0.0, 0.012, count).finish();
        let curve = LoadCurve::of(&path, &problem, stiffness);
        let onset = (curve.contact.unwrap() - loading.contact.unwrap()).abs();
        // The corner's grain, 2e-6 of the length, however long the steps are.
        assert!(onset < 4e-7, "{onset}");
        assert!((curve.datum - loading.datum).abs() < 2e-4 * loading.datum);
        assert_eq!(curve.obstacles, [0]);
        assert_eq!(curve.points[0].load, 0.0);
        let mut worst = 0.0_f64;
        for (load, state) in loads.iter().zip(&loading.states) {
            let force: f64 = state.statics.contacts.iter().map(|c| c.normal_force).sum();
            let point = curve.at(*load).unwrap();
            assert_eq!(point.total, point.by_obstacle[0]);
            worst = worst.max((point.total - force).abs() / force);
        }
        worst
    };
    let (coarse, fine) = (error(61), error(241));
    assert!(fine < 4e-3 && fine < 0.1 * coarse, "{coarse:e} {fine:e}");
    // Nothing to press on: loads count from the straight robot.
    let free = self::problem(FREE);
    let path = PathRun::over(&free, 0.0, 0.012, 41).finish();
    let curve = LoadCurve::of(&path, &free, stiffness);
    assert_eq!((curve.contact, curve.datum), (None, 0.0));
    assert!(curve.points.iter().all(|point| point.total == 0.0));
}

#[test]
fn rows_are_the_states_in_the_units_of_files() {
    let problem = problem(TWO_DISCS);
    let path = PathRun::over(&problem, 0.0, 0.0049, 8).finish();
    let rows: Vec<_> = rows(&path).collect();
    assert_eq!(rows.len(), path.states.len());
    let own = solve(&problem, Start::Straight, Settings::default());
    let last = rows.last().unwrap();
    let of = |name: &str| last[COLUMNS.iter().position(|c| *c == name).unwrap()];
    assert_eq!(of("contacts"), 2.0);
    let near = |name: &str, expected: f64| {
        assert!(
            (of(name) - expected).abs() < 1e-6 * expected.abs(),
            "{name}"
        );
    };
    near("pull_mm", 4.9);
    near("tip_x_mm", 1e3 * own.tip().position.x);
    near("tip_y_mm", 1e3 * own.tip().position.y);
    near("tip_slope_deg", own.tip().angle.to_degrees());
    near("energy_rad2", own.energy);
    near(
        "energy_slope_rad2_per_mm",
        1e-3 * own.certificate.energy_slope,
    );
    let sum: f64 = own.contacts.iter().map(|c| c.multiplier).sum();
    near("multipliers_rad2_per_mm", 1e-3 * sum);
}
