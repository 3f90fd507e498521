//! What a run says of itself: a case for every status, every reason that a
//! branch ends for and every occurrence; the order of what it tells, how far it
//! has got, and how finely it went.

use sinew::equilibrium::{
    EndReason, Event, Occurrence, Progress, Run, Settings, Solution, Solved, Start, Status, solve,
};
use sinew::geometry::{Core, Obstacle, Vector};
use sinew::mechanics::Problem;
use sinew::robot::Line;
use sinew::scene::{Candidates, Scene, Shape};

fn scene(pull_mm: f64, shapes: &[Shape]) -> Scene {
    let mut scene = Scene::default();
    scene.set_pull_mm(pull_mm);
    scene.obstacles = shapes.iter().cloned().map(Into::into).collect();
    scene
}

fn problem(pull_mm: f64, shapes: &[Shape]) -> Problem {
    Problem::new(&scene(pull_mm, shapes)).unwrap()
}

fn disc(x: f64, y: f64, radius_mm: f64) -> Shape {
    Shape::Disc {
        center_mm: [x, y],
        radius_mm,
    }
}

fn block(x: f64, y: f64, width: f64, height: f64) -> Shape {
    Shape::Box {
        center_mm: [x, y],
        size_mm: [width, height],
        rotation_deg: 0.0,
        corner_radius_mm: 1.0,
    }
}

fn straight(problem: &Problem) -> Solved {
    solve(problem, Start::Straight, Settings::default())
}

fn words(events: &[Event]) -> Vec<&'static str> {
    events.iter().map(|event| event.what.word()).collect()
}

#[test]
fn a_free_robot_converges_without_events() {
    let solution = straight(&problem(5.0, &[]));
    assert_eq!(solution.status, Status::Converged);
    assert_eq!(solution.status.word(), "converged");
    let reason = "the shape is a certified equilibrium";
    assert_eq!(solution.status.reason(), reason);
    assert!(solution.events.is_empty());
}

#[test]
fn a_run_that_is_not_over_says_so() {
    let goal = problem(5.0, &[]);
    let mut run = Run::new(&goal, Start::Straight, Settings::default());
    assert_eq!(run.solution().status, Status::Unfinished);
    assert_eq!(run.solution().status.word(), "unfinished");
    let reason = "the solve was stopped before its end";
    assert_eq!(run.solution().status.reason(), reason);
    assert_eq!(run.advance(3), Progress::Running);
    assert_eq!(run.solution().status, Status::Unfinished);
    run.finish();
    assert_eq!(run.advance(3), Progress::Done);
}

/// A slot narrower than the robot.
#[test]
fn what_does_not_fit_is_infeasible_and_names_what_is_in_conflict() {
    let slot = [
        block(-17.0, 90.0, 40.0, 30.0),
        block(25.0, 90.0, 40.0, 30.0),
    ];
    let solution = straight(&problem(2.0, &slot));
    let Status::Infeasible { conflicts } = &solution.status else {
        panic!("{:?}", solution.status)
    };
    for obstacle in [0, 1] {
        assert!(conflicts.iter().any(|c| c.obstacle == obstacle));
    }
    for conflict in conflicts {
        assert!((7..=11).contains(&conflict.node), "{conflict:?}");
        // The backbone is in the way of the left block, the cable of the right.
        let expected = [Line::Backbone, Line::Cable][conflict.obstacle];
        assert_eq!(conflict.line, expected);
    }
    let mut once = conflicts.clone();
    once.dedup();
    assert_eq!(&once, conflicts);
    assert_eq!(solution.status.word(), "infeasible");
    let reason = solution.status.reason();
    assert!(reason.starts_with("no shape near the last good one keeps clear"));
    assert!(reason.contains("cable node 9 on obstacle 1"), "{reason}");
    // The straight robot is the last good shape.
    assert!(solution.certificate.holds());
    assert_eq!(solution.pull, 0.0);
    let direct = solve(&problem(2.0, &slot), Start::Direct, Settings::default());
    assert!(matches!(direct.status, Status::Infeasible { .. }));
    let none = Status::Infeasible { conflicts: vec![] };
    assert!(none.reason().contains("the robot's own parts allow"));
}

fn check_end(solution: &Solution, reason: EndReason, words: [&str; 2]) {
    let Status::BranchEnded { reason: found, .. } = solution.status else {
        panic!("{:?}", solution.status)
    };
    assert_eq!(found, reason);
    assert_eq!(solution.status.word(), "branch_ended");
    assert_eq!(reason.word(), words[0]);
    assert!(solution.status.reason().contains(words[1]));
    assert!(solution.certificate.holds());
}

/// A body drawn far around a post shears until a segment locks.
#[test]
fn a_branch_that_ends_at_a_locked_segment_names_it() {
    let mut scene = scene(40.0, &[disc(30.0, 90.0, 8.0)]);
    scene.contact.candidates = Candidates::Body;
    let problem = Problem::new(&scene).unwrap();
    let solution = straight(&problem);
    let texts = ["linkage_limit", "at the limit of its assembly"];
    check_end(&solution, EndReason::LinkageLimit, texts);
    let Status::BranchEnded { reason, segment } = solution.status else {
        unreachable!()
    };
    let turned = solution.turns[segment - 1].abs();
    assert!((problem.segment().most_turn() - turned).abs() < 0.05);
    let last = solution.events.last().unwrap();
    assert_eq!(last.what, Occurrence::BranchEnded { reason, segment });
    assert_eq!(last.what.word(), "branch_ended");
    assert!(solution.pull > 0.015 && solution.pull < problem.pull());
}

/// Straight under a lid a robot is in balance, but buckles.
#[test]
fn a_shape_that_is_no_minimum_ends_at_a_fold() {
    let lid = problem(0.0, &[block(0.0, 170.0, 400.0, 40.0)]);
    let solution = solve(&lid, Start::Direct, Settings::default());
    let texts = ["fold", "folds back and the robot slips away"];
    check_end(&solution, EndReason::Fold, texts);
    let Status::BranchEnded { segment, .. } = solution.status else {
        unreachable!()
    };
    // The one that turned most.
    let most = solution.turns[segment - 1].abs();
    assert!(segment > 1 && most > 0.0);
    assert!(solution.turns.iter().all(|turn| turn.abs() <= most));
}

/// Two cables on both sides that do not stretch: no bend draws in both. What lengthens one
/// by as much as the other is drawn in is no conflict, nor are cables that stretch.
#[test]
fn cables_that_are_drawn_in_against_each_other_are_told() {
    let antagonists = |far_mm: f64, rest: &str| {
        let scene = Scene::from_toml(&format!(
            "version = 2\n[robot]\nlength_mm = 180\nsegments = 18\nsegments_per_bay = 2\n\
             bending_stiffness_nmm2 = 8000\n[[cable]]\noffset_mm = 8\npull_mm = 4\n{rest}\
             [[cable]]\noffset_mm = -8\npull_mm = {far_mm}\n{rest}"
        ));
        straight(&Problem::new(&scene.unwrap()).unwrap())
    };
    let texts = ["cables_oppose", "against each other"];
    check_end(&antagonists(1.0, ""), EndReason::CablesOppose, texts);
    let stretching = "axial_stiffness_n = 5000\n";
    for solved in [antagonists(-4.2, ""), antagonists(1.0, stretching)] {
        assert_eq!(solved.status, Status::Converged);
        assert!(solved.certificate.holds());
    }
}

#[test]
fn every_reason_has_its_word() {
    let reason = EndReason::Blocked;
    assert_eq!(reason.word(), "blocked");
    let ended = Status::BranchEnded { reason, segment: 3 };
    let text = "the branch ends at segment 3: every way on leads through an obstacle";
    assert_eq!(ended.reason(), text);
}

#[test]
fn a_run_of_too_few_iterations_says_so() {
    let settings = Settings {
        iterations: 8,
        ..Settings::default()
    };
    let solution = solve(&problem(10.0, &[]), Start::Straight, settings);
    assert_eq!(solution.status, Status::IterationLimit);
    assert_eq!(solution.status.word(), "iteration_limit");
    assert!(solution.status.reason().contains("iterations were used up"));
    // Two a step, of a sixteenth of the offset each.
    assert_eq!(solution.iterations, 8);
    assert!((solution.pull - 4.0 * 0.5e-3).abs() < 1e-12);
    assert!(solution.certificate.holds());
}

/// On a disc of a million kilometres a micrometre is lost to rounding: the
/// solver finds the clearance zero, and the certificate the gap.
#[test]
fn what_rounding_spoils_is_not_called_converged() {
    let free = problem(6.0, &[]);
    let planet = Obstacle::new(Core::Point, 1e9, Vector::new(1e9 + 0.03, 0.12), 0.0);
    let (robot, candidates) = (*free.robot(), free.candidates().to_vec());
    let beside = Problem::from_parts(robot, free.pull(), candidates, vec![planet]);
    let solution = solve(&beside, Start::Direct, Settings::default());
    assert!(!solution.certificate.holds());
    assert_eq!(solution.status, Status::NumericalFailure);
    assert_eq!(solution.status.word(), "numerical_failure");
    assert!(solution.status.reason().contains("rounding"));
}

#[test]
fn a_shape_of_another_robot_is_refused_as_a_start() {
    let goal = problem(5.0, &[disc(44.0, 104.0, 15.0)]);
    let mut wrong = straight(&goal).into_solution();
    wrong.turns[3] += 0.1;
    let wrong = Solved::pair(goal.clone(), wrong).unwrap();
    let solution = solve(&goal, Start::From(&wrong), Settings::default());
    assert_eq!(solution.status, Status::Converged);
    let first = &solution.events[0];
    assert_eq!((first.what, first.pull), (Occurrence::StartRefused, 5e-3));
    assert_eq!(first.what.word(), "start_refused");
}

/// Two jumps, from runs with steps of 0.005 mm; what touched before does not
/// any more.
#[test]
fn contacts_come_and_go_and_jumps_are_told() {
    let solution = straight(&problem(10.0, &[disc(44.0, 150.0, 2.0)]));
    assert_eq!(
        words(&solution.events),
        [
            "contact_made",
            "jump",
            "contact_made",
            "contact_lost",
            "jump",
            "contact_lost"
        ]
    );
    let jumps = solution.events.iter().filter_map(|event| match event.what {
        Occurrence::Jump { node, distance } => Some((node, (1e4 * distance).round())),
        _ => None,
    });
    // Tenths of a millimetre.
    assert_eq!(jumps.collect::<Vec<_>>(), [(16, 74.0), (16, 188.0)]);
    let lines = solution.events.iter().filter_map(|event| match event.what {
        Occurrence::ContactMade {
            line,
            node,
            obstacle,
        } => Some((true, line, node, obstacle)),
        Occurrence::ContactLost {
            line,
            node,
            obstacle,
        } => Some((false, line, node, obstacle)),
        _ => None,
    });
    assert_eq!(
        lines.collect::<Vec<_>>(),
        [
            (true, Line::Cable, 16, 0),
            (true, Line::Backbone, 16, 0),
            (false, Line::Cable, 16, 0),
            (false, Line::Backbone, 16, 0)
        ]
    );
}

/// A fine robot rolls over a disc: several nodes touch and leave within one
/// step, each at its own pull.
#[test]
fn events_come_in_the_order_of_the_motion() {
    let at = |pull_mm: f64| {
        let mut scene = scene(pull_mm, &[disc(85.0, 104.0, 56.0)]);
        scene.robot.segments = 180;
        scene.robot.segments_per_bay = 10;
        Problem::new(&scene).unwrap()
    };
    let mut run = Run::new(&at(9.0), Start::Straight, Settings::default());
    let step = Settings::default().pull_step * 8e-3;
    let check = |events: &[Event], sign: f64| {
        let pulls: Vec<f64> = events.iter().map(|event| sign * event.pull).collect();
        assert!(pulls.is_sorted(), "{pulls:?}");
        let step_of = |pull: f64| (pull / step).floor();
        let within = |pair: &&[f64]| pair[0] < pair[1] && step_of(pair[0]) == step_of(pair[1]);
        assert!(pulls.windows(2).filter(within).count() > 2, "{pulls:?}");
    };
    check(&run.finish().events, 1.0);
    run.retarget(&at(5.0));
    check(&run.finish().events, -1.0);
}

/// One iteration to begin a step and one to solve it, as many steps as the
/// settings ask for: of the pull and of an obstacle that moves.
#[test]
fn steps_are_as_fine_as_asked_for() {
    let settings = |pull_step, obstacle_step| Settings {
        pull_step,
        obstacle_step,
        ..Settings::default()
    };
    for (pull_step, steps) in [(1.0 / 16.0, 20), (1.0 / 64.0, 80), (1.0, 2)] {
        let solution = solve(
            &problem(10.0, &[]),
            Start::Straight,
            settings(pull_step, 1.0),
        );
        let expected = (10.0 / 8.0 / pull_step).ceil() as usize;
        assert_eq!(expected, steps);
        assert_eq!(solution.iterations, 2 * steps, "{pull_step}");
    }
    let away = |x: f64| problem(2.0, &[disc(x, 100.0, 10.0)]);
    for obstacle_step in [1.0 / 40.0, 1.0 / 10.0] {
        let mut run = Run::new(&away(90.0), Start::Straight, settings(1.0, obstacle_step));
        run.finish();
        run.retarget(&away(126.0));
        let steps = (36.0 / 180.0 / obstacle_step).round() as usize;
        assert_eq!(run.finish().iterations, 2 * steps);
    }
}

/// Growing an obstacle over the robot is the first half of a run.
#[test]
fn a_run_tells_how_far_it_has_got() {
    let goal = problem(4.0, &[]);
    let mut run = Run::new(&goal, Start::Straight, Settings::default());
    assert_eq!(run.share(), 0.0);
    assert!(run.obstacles_are_placed());
    // Eight steps of two iterations.
    run.advance(8);
    assert!((run.share() - 0.5).abs() < 1e-12);
    run.finish();
    assert_eq!(run.share(), 1.0);

    let goal = problem(4.0, &[disc(-8.0, 120.0, 12.0)]);
    let mut run = Run::new(&goal, Start::Straight, Settings::default());
    let mut shares = vec![run.share()];
    let mut placed = vec![run.obstacles_are_placed()];
    while run.advance(1) == Progress::Running {
        shares.push(run.share());
        placed.push(run.obstacles_are_placed());
    }
    shares.push(run.share());
    assert!(shares.is_sorted() && shares[0] == 0.0 && shares[shares.len() - 1] == 1.0);
    // The obstacle has its size from half of the run on.
    for (share, placed) in shares.iter().zip(&placed) {
        assert_eq!(*placed, *share >= 0.5, "{share}");
    }
    assert!(shares.iter().any(|share| *share > 0.0 && *share < 0.5));
    assert!(shares.iter().any(|share| *share > 0.5 && *share < 1.0));
    assert_eq!(run.solution().events[0].what.word(), "pushed_aside");
}

/// Where the free arc's cable meets a disc, and where a contact's force comes
/// to an end, by bisection.
#[test]
fn contacts_are_told_at_the_pull_where_they_begin_and_end() {
    let post = [disc(44.0, 104.0, 15.0)];
    let at = |pull: f64| straight(&problem(1e3 * pull, &post));
    let edge = |mut low: f64, mut high: f64, holds: &dyn Fn(f64) -> bool| {
        assert!(!holds(low) && holds(high));
        while high - low > 1e-8 {
            let middle = 0.5 * (low + high);
            if holds(middle) {
                high = middle;
            } else {
                low = middle;
            }
        }
        high
    };
    let solution = at(11e-3);
    assert_eq!(solution.events.len(), 3, "{:?}", solution.events);
    let both = |event: &Event| (event.pull - 2e-4, event.pull + 2e-4);
    for event in &solution.events {
        let (low, high) = both(event);
        let presses = |pull: f64, which: usize| {
            let there = at(pull);
            there
                .contacts
                .iter()
                .any(|c| c.multiplier > 0.0 && c.node == which)
        };
        let exact = match event.what {
            Occurrence::ContactMade { node, .. } => edge(low, high, &|pull| presses(pull, node)),
            Occurrence::ContactLost { node, .. } => edge(low, high, &|pull| !presses(pull, node)),
            what => panic!("{what:?}"),
        };
        assert!((event.pull - exact).abs() < 2e-5, "{event:?}: {exact}");
    }
    // And on the way back the other way round.
    let mut run = Run::new(&problem(11.6, &post), Start::Straight, Settings::default());
    run.finish();
    run.retarget(&problem(4.0, &post));
    let back = run.finish().events.clone();
    assert_eq!(back.len(), solution.events.len());
    for (event, before) in back.iter().zip(solution.events.iter().rev()) {
        assert!(
            (event.pull - before.pull).abs() < 4e-5,
            "{event:?} {before:?}"
        );
        let opposite = match before.what {
            Occurrence::ContactMade {
                line,
                node,
                obstacle,
            } => Occurrence::ContactLost {
                line,
                node,
                obstacle,
            },
            Occurrence::ContactLost {
                line,
                node,
                obstacle,
            } => Occurrence::ContactMade {
                line,
                node,
                obstacle,
            },
            what => what,
        };
        assert_eq!(event.what, opposite);
    }
}

/// Few contacts and more than are compared with each other one by one.
#[test]
fn a_force_that_two_obstacles_share_is_not_called_unique() {
    for (segments, most) in [(60, 16), (800, 200)] {
        let mut scene = scene(14.0, &[disc(44.0, 104.0, 15.0)]);
        scene.robot.segments = segments;
        scene.robot.segments_per_bay = 1;
        let one = straight(&Problem::new(&scene).unwrap());
        assert!(one.unique_split && one.contacts.len() < most);
        scene.obstacles.push(scene.obstacles[0].clone());
        let two = straight(&Problem::new(&scene).unwrap());
        assert_eq!(two.contacts.len(), 2 * one.contacts.len());
        assert!(!two.unique_split);
    }
}

/// A post set beside a robot so that it touches and does not press: no force,
/// and no doubt about the others.
#[test]
fn what_only_touches_grazes_and_shares_nothing() {
    let before = problem(6.0, &[disc(44.0, 104.0, 15.0)]);
    let held = straight(&before);
    let node = held.nodes[16];
    let post = Obstacle::new(Core::Point, 5e-3, node.at(-5e-3 - 1e-12), 0.0);
    let mut obstacles = before.obstacles().to_vec();
    obstacles.push(post);
    let (robot, candidates) = (*before.robot(), before.candidates().to_vec());
    let beside = Problem::from_parts(robot, before.pull(), candidates, obstacles);
    let solution = solve(&beside, Start::From(&held), Settings::default());
    assert_eq!(solution.status, Status::Converged);
    let found: Vec<_> = solution
        .contacts
        .iter()
        .map(|c| (c.line, c.node, c.class.word()))
        .collect();
    assert_eq!(
        found,
        [
            (Line::Cable, 12, "pressing"),
            (Line::Backbone, 16, "grazing")
        ]
    );
    assert_eq!(solution.contacts[1].multiplier, 0.0);
    assert!(solution.unique_split && solution.certificate.holds());
    // It appeared where it is, and nothing had to move.
    assert!(!words(&solution.events).contains(&"pushed_aside"));
    for (turn, before) in solution.turns.iter().zip(&held.turns) {
        assert!((turn - before).abs() < 1e-12);
    }
}

/// An obstacle that comes or goes and touches nothing is no event: what presses
/// on others goes on pressing, whatever their places in the list.
#[test]
fn contacts_outlast_a_change_of_the_list() {
    let posts = [disc(33.0, 89.0, 12.5), disc(59.0, 140.0, 15.0)];
    let both = problem(4.9, &posts);
    let mut run = Run::new(&both, Start::Straight, Settings::default());
    let before = run.finish().clone();
    assert_eq!(before.contacts.len(), 2);
    let [lower, upper] = posts;
    let away = disc(-100.0, 50.0, 5.0);
    for shapes in [
        vec![away.clone(), upper.clone(), lower.clone()],
        vec![lower.clone(), upper.clone()],
        vec![upper, away, lower],
    ] {
        run.retarget(&problem(4.9, &shapes));
        let after = run.finish();
        assert_eq!(after.events, []);
        assert_eq!(after.contacts.len(), 2);
        for (contact, was) in after.contacts.iter().zip(&before.contacts) {
            assert!((contact.multiplier / was.multiplier - 1.0).abs() < 1e-6);
        }
    }
}

/// Obstacles that stay are known by where they are, wherever in the list: one
/// that is new over the robot pushes it aside, and no other moves.
#[test]
fn a_new_obstacle_in_the_list_moves_no_other() {
    let (lower, upper) = (disc(33.0, 89.0, 12.5), disc(59.0, 140.0, 15.0));
    let both = problem(4.9, &[lower.clone(), upper.clone()]);
    let mut run = Run::new(&both, Start::Straight, Settings::default());
    let [x, y] = (1e3 * run.finish().nodes[18].position).into();
    let over = disc(x - 2.0, y, 5.0);
    for shapes in [
        [over.clone(), lower.clone(), upper.clone()],
        [lower, over.clone(), upper],
    ] {
        let index = shapes.iter().position(|s| *s == over);
        let mut with = run.clone();
        with.retarget(&problem(4.9, &shapes));
        let solution = with.finish();
        assert_eq!(solution.status, Status::Converged);
        let pushed = solution.events.iter().filter_map(|event| match event.what {
            Occurrence::PushedAside { obstacle, .. } => Some(obstacle),
            _ => None,
        });
        assert_eq!(pushed.collect::<Vec<_>>(), [index.unwrap()]);
        assert!(solution.certificate.holds());
    }
}
