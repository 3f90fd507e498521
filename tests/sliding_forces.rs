//! Forces of robots whose cables slide: their balance, as free bodies that know no
//! solver, and what happens to it where something is told wrongly.

use sinew::contact::Class;
use sinew::equilibrium::{Caution, Settings, Solution, Solved, Start, Status, solve};
use sinew::forces::{
    LoadSteps, Rates, Statics, Stiffness, Sweep, VirtualWork, Window, share_of_tension,
};
use sinew::geometry::{Vector, cross};
use sinew::mechanics::Problem;
use sinew::robot::Line;
use sinew::scene::Scene;

const ROBOT: &str = "version = 2
[robot]
length_mm = 180
segments = 18
bending_stiffness_nmm2 = 8000
";
const ONE_CABLE: &str = "[[cable]]\noffset_mm = 8\n";
/// Both of Fig. 4b's posts, pressed at pulls of 5.35 to 5.75 mm.
const POSTS: &str = "
[[obstacle]]
shape = \"disc\"
center_mm = [37, 92]
radius_mm = 15
[[obstacle]]
shape = \"disc\"
center_mm = [40, 158]
radius_mm = 12.5
";
const LOADS: &str = "
[loads]
tip_force_n = [0.05, -0.15]
tip_moment_nmm = 3.0
gravity_m_s2 = [1.0, -9.80665]
";
const MASSES: &str = "disk_mass_g = 1.2\nbackbone_mass_g = 4\n";

fn problem(text: &str) -> Problem {
    Problem::new(&Scene::from_toml(text).unwrap()).unwrap()
}

fn stiffness() -> Stiffness {
    Stiffness::new(8e-3).unwrap()
}

#[track_caller]
fn solved(text: &str) -> (Solved, Statics) {
    let solved = solve(&problem(text), Start::Straight, Settings::default());
    assert_eq!(solved.status, Status::Converged, "{:?}", solved.certificate);
    let statics = Statics::of(&solved, stiffness());
    assert!(
        statics.balances(),
        "{:e} {:e}",
        statics.unbalanced_force,
        statics.unbalanced_moment
    );
    (solved, statics)
}

#[track_caller]
fn close(found: f64, expected: f64, relative: f64) {
    assert!(
        (found - expected).abs() <= relative * expected.abs(),
        "{found:e} is not {expected:e}"
    );
}

fn pressing(solution: &Solution) -> usize {
    let contacts = solution.contacts.iter();
    contacts.filter(|c| c.class == Class::Pressing).count()
}

/// One cable by pull, by load, with dead loads; antagonists; a cable to a disk half way;
/// contacts at nodes, on a stretch of cable between disks, and on the body.
fn scenes() -> Vec<(&'static str, String)> {
    let bent = format!("{ROBOT}{ONE_CABLE}pull_mm = 5.5\n");
    let antagonists = "[[cable]]\noffset_mm = 8\npull_mm = 6\n[[cable]]\noffset_mm = -7\nload_g = 60\nto_disk = 5\n";
    vec![
        ("pulled", bent.clone()),
        ("posts", format!("{bent}{POSTS}")),
        (
            "body",
            format!("{bent}{POSTS}[contact]\ncandidates = \"body\"\n"),
        ),
        (
            "three arcs a bay",
            format!("{ROBOT}segments_per_bay = 3\n{ONE_CABLE}load_g = 350\n{POSTS}"),
        ),
        (
            "loaded",
            format!("{ROBOT}{MASSES}{ONE_CABLE}load_g = 350\n{LOADS}{POSTS}"),
        ),
        (
            "hanging",
            format!(
                "{ROBOT}{MASSES}base_mm = [50, 20]\nbase_angle_deg = 80\n{ONE_CABLE}pull_mm = 2\n{LOADS}"
            ),
        ),
        (
            "antagonists",
            format!("{ROBOT}{MASSES}{antagonists}{LOADS}"),
        ),
        (
            "antagonists at posts",
            format!("{ROBOT}{antagonists}{POSTS}"),
        ),
    ]
}

#[test]
fn forces_and_moments_of_the_whole_robot_balance() {
    let mut lines = Vec::new();
    for (name, text) in scenes() {
        let (solved, statics) = solved(&text);
        lines.extend(solved.contacts.iter().map(|contact| contact.line));
        // One tension all along each cable.
        for (cable, all) in statics.tensions.iter().enumerate() {
            let driven = &solved.drive.cables[cable].cable;
            assert_eq!(all.len(), driven.last_disk, "{name}");
            assert!(all.iter().all(|tension| tension == &all[0]));
            close(all[0], per_bend() * solved.cables[cable].tension, 1e-14);
        }
        close(statics.tension, statics.tensions[0][0], 1e-14);
        // At the tip there is only what acts there.
        let loads = &solved.drive.loads;
        let last = statics.sections.last().unwrap();
        assert!(last.couple.is_finite() && statics.sections.len() == 18);
        if !loads.any() && pressing(&solved) == 0 {
            close(last.backbone.hypot(last.shear), last.cable, 1e-12);
        }
    }
    assert!(lines.contains(&Line::Cable) && lines.contains(&Line::CableLink));
}

fn per_bend() -> f64 {
    8e-3 / (2.0 * 0.01)
}

/// The base holds what acts on the robot, by the sums of statics and no section.
#[test]
fn the_base_holds_weights_and_what_presses() {
    let (solved, statics) = solved(&format!(
        "{ROBOT}{MASSES}{ONE_CABLE}load_g = 0\n[loads]\ngravity_m_s2 = [0.0, -9.80665]\ntip_force_n = [0.1, 0.0]\n"
    ));
    // Nine disks of 1.2 g and a backbone of 4 g.
    let weight = 14.8e-3 * 9.80665;
    close(statics.loads.force.y, -weight, 1e-12);
    close(statics.clamp.force.y, weight, 1e-12);
    close(statics.clamp.force.x, -0.1, 1e-12);
    // The moment at the base: the tip's force over its height, and all weights.
    let nodes = &solved.nodes;
    let disks = (1..=9).map(|k| 1.2e-3 * nodes[2 * k].position.x);
    let ends = nodes.windows(2);
    let arcs = ends.map(|pair| 4e-3 / 18.0 * 0.5 * (pair[0].position.x + pair[1].position.x));
    let turning =
        9.80665 * (disks.sum::<f64>() + arcs.sum::<f64>()) + 0.1 * solved.tip().position.y;
    close(statics.clamp.moment, turning, 1e-9);
    assert_eq!(statics.cable.force, Vector::zeros());
    // Of a cable's pull, the base feels the backbone's thrust alone.
    let (solved, statics) = self::solved(&format!("{ROBOT}{ONE_CABLE}load_g = 250\n"));
    let load = 0.25 * 9.80665;
    close(statics.cable.force.norm(), load, 1e-12);
    close(
        (statics.clamp.force + statics.cable.force).norm() + load,
        load,
        1e-12,
    );
    let first = solved.nodes[2].at(8e-3) - solved.nodes[0].at(8e-3);
    let arm = solved.nodes[0].at(8e-3) - solved.nodes[0].position;
    close(
        statics.clamp.moment,
        cross(arm, load * first.normalize()),
        1e-9,
    );
}

/// What is told wrongly is noticed: a tension, a force, where it acts, what weighs.
#[test]
fn a_wrong_force_leaves_the_robot_unbalanced() {
    let text = format!("{ROBOT}{MASSES}{ONE_CABLE}load_g = 350\n{LOADS}{POSTS}");
    let (right, _) = solved(&text);
    let spoilt = |spoil: &dyn Fn(&mut Solution)| {
        let mut solution = right.solution().clone();
        spoil(&mut solution);
        let pair = Solved::pair(right.problem().clone(), solution).unwrap();
        Statics::of(&pair, stiffness())
    };
    assert!(spoilt(&|_| ()).balances());
    let off = |statics: Statics| {
        assert!(statics.unbalanced_moment > Statics::BOUND);
        assert!(!statics.balances());
    };
    off(spoilt(&|solution| solution.cables[0].tension *= 1.0 + 1e-6));
    off(spoilt(&|solution| {
        solution.contacts[0].multiplier *= 1.0 + 1e-4
    }));
    off(spoilt(&|solution| {
        solution.contacts[0].point += 1e-6 * Vector::new(0.0, 1.0);
    }));
    off(spoilt(&|solution| solution.bends[9] += 1e-7));
    off(spoilt(&|solution| {
        solution.drive.loads.tip_force.x += 1e-6;
    }));
    off(spoilt(&|solution| {
        solution.drive.loads.tip_moment += 1e-8;
    }));
    off(spoilt(&|solution| {
        solution.drive.loads.disk.y *= 1.0 + 1e-4
    }));
    off(spoilt(&|solution| {
        solution.drive.loads.backbone.x *= 1.0 + 1e-2;
    }));
}

/// Under a load the sweep's pull finds the weight's own shape: the same tension, pull
/// and force as a solve with that load.
#[test]
fn a_load_reached_by_pulling_is_the_load_solved_for() {
    let text = |drive: &str| format!("{ROBOT}{ONE_CABLE}{drive}\n{POSTS}");
    let problem = problem(&text("pull_mm = 3"));
    let steps = LoadSteps::of(&problem, stiffness(), &[1.0, 0.5]).unwrap();
    assert!(steps.contact.is_some_and(|pull| pull > 2e-3));
    assert!(steps.end.is_none());
    for state in &steps.states {
        let load = steps.datum + state.load;
        let (weighed, statics) = solved(&text(&format!("load_g = {}", load / 9.80665e-3)));
        close(state.statics.tension, load, 1e-6);
        close(weighed.pull, state.pull, 1e-7);
        let force = |statics: &Statics| -> f64 {
            statics
                .contacts
                .iter()
                .map(|contact| contact.normal_force)
                .sum()
        };
        close(force(&state.statics), force(&statics), 1e-5);
    }
    let (touching, _) = solved(&text("pull_mm = 5.5"));
    let found = Stiffness::calibrated(&touching, per_bend() * touching.energy_slope());
    close(found.unwrap().value(), 8e-3, 1e-12);
    let share = share_of_tension(&touching, &touching.contacts[0]).unwrap();
    close(
        share,
        touching.contacts[0].multiplier / touching.cables[0].tension,
        1e-15,
    );
}

/// Without obstacles the two arcs of every bay bend alike: the cable's stretches are
/// chords of 2(l/β − a) sin β.
#[test]
fn the_free_tip_is_where_chords_put_it() {
    let text = format!("{ROBOT}{ONE_CABLE}pull_mm = 3\n{POSTS}");
    let pulls = Sweep::pulls(0.0, 8e-3, 5);
    let sweep = Sweep::free(&problem(&text), &pulls);
    for point in &sweep.points[1..] {
        let bend = -point.angle / 18.0;
        let chord = 2.0 * (0.01 / bend - 8e-3) * bend.sin();
        close(9.0 * (0.02 - chord), point.pull, 1e-9);
        let radius = 0.01 / bend;
        close(point.x, radius * (1.0 - (18.0 * bend).cos()), 1e-9);
        close(point.y, radius * (18.0 * bend).sin(), 1e-9);
        // dJ/dpull of J = 18 β².
        let slope = 9.0
            * (2.0 * 0.01 * bend.sin() / (bend * bend) - 2.0 * (0.01 / bend - 8e-3) * bend.cos());
        close(point.energy_slope, 36.0 * bend / slope, 1e-8);
    }
    let window = Window {
        first: 0.0,
        last: 8e-3,
    };
    let rates = Rates::fit(&sweep, window).unwrap();
    assert!(VirtualWork::new(8e-3, rates, 0.0).is_ok());
}

/// A shape that only its cable's length holds is told from one that a weight holds.
#[test]
fn what_is_stable_under_pull_alone_is_told() {
    let (free, _) = solved(&format!("{ROBOT}[[cable]]\noffset_mm = -8\npull_mm = 5\n"));
    assert_eq!(free.rests_under_load(), Some(true));
    assert_eq!(Caution::all(&free), []);
    // Of a shape that is stable under its pull, a weight holds it just where the tension
    // rises with the pull; over the tip of this robot it passes its greatest.
    let mut slipping = Scene::from_toml(include_str!("../assets/scenes/slip-off.toml")).unwrap();
    slipping.model.mechanics = sinew::scene::Mechanics::Sliding;
    let mut found = Vec::new();
    for pull_mm in [3.8, 4.0, 4.2, 4.28, 4.36, 4.4, 4.48] {
        let at = |by: f64| {
            slipping.set_pull_mm(pull_mm + by);
            let problem = Problem::new(&slipping).unwrap();
            solve(&problem, Start::Straight, Settings::default())
        };
        let [before, here, after] = [-1e-3, 0.0, 1e-3].map(at);
        let rises = after.energy_slope() > before.energy_slope();
        assert_eq!(here.rests_under_load(), Some(rises), "{pull_mm}");
        found.push(rises);
    }
    assert_eq!(found, [true, true, true, true, false, false, false]);
    let mut equal = Scene::from_toml(&format!("{ROBOT}{ONE_CABLE}pull_mm = 5\n")).unwrap();
    equal.model.mechanics = sinew::scene::Mechanics::Equal;
    let equal = solve(
        &Problem::new(&equal).unwrap(),
        Start::Straight,
        Settings::default(),
    );
    assert_eq!(equal.rests_under_load(), None);
}
