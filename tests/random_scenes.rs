//! Thousands of random scenes: whatever is claimed is certified, whatever is
//! not has a status with its reason, and nothing depends on chance.

mod random_scene;

use proptest::prelude::*;
use random_scene::{config, scaled_scene, scene, sliding_scene};
use sinew::equilibrium::{Occurrence, Run, Settings, Solved, Start, Status, solve};
use sinew::mechanics::{Input, Problem};
use sinew::scene::{Candidates, Scene};

fn straight(problem: &Problem) -> Solved {
    solve(problem, Start::Straight, Settings::default())
}

/// The problem of a solution with its pull for a load, or its load for a pull.
fn switched(solved: &Solved) -> Problem {
    let mut problem = solved.problem().clone();
    let mut drive = problem.drive().clone();
    let state = solved.cables[0];
    let per_bend = drive.stiffness.unwrap() / (2.0 * problem.robot().segment_length());
    drive.cables[0].input = match drive.cables[0].input {
        Input::Pull(_) => Input::Load(per_bend * state.tension),
        Input::Load(_) => Input::Pull(state.pull),
    };
    problem.set_drive(&drive);
    problem
}

/// What holds of every run, whatever came of it.
fn check(scene: &Scene) -> Result<(), TestCaseError> {
    let Ok(problem) = Problem::new(scene) else {
        // Base covered or pull out of range: a fault, told as one.
        prop_assert!(!Problem::faults(scene).is_empty());
        return Ok(());
    };
    let solution = straight(&problem);
    prop_assert!(solution.status != Status::Unfinished);
    prop_assert!(solution.status != Status::NumericalFailure, "{solution:?}");
    prop_assert!(!solution.status.reason().is_empty());
    prop_assert!(
        solution
            .nodes
            .iter()
            .all(|n| n.position.iter().all(|x| x.is_finite()))
    );
    prop_assert!(solution.energy.is_finite());
    // The last good state of a run that ended early is an equilibrium too.
    prop_assert!(
        solution.certificate.holds(),
        "{:?} {:?}",
        solution.status,
        solution.certificate
    );
    if solution.status == Status::Converged {
        prop_assert!(&solution.drive == problem.drive());
    } else if matches!(solution.status, Status::BranchEnded { .. }) {
        let ended = |event: &sinew::equilibrium::Event| {
            matches!(event.what, Occurrence::BranchEnded { .. })
        };
        prop_assert!(solution.events.iter().any(ended));
    }
    let direct = solve(&problem, Start::Direct, Settings::default());
    if direct.status == Status::Converged {
        prop_assert!(
            direct.certificate.holds(),
            "direct {:?}",
            direct.certificate
        );
    }
    Ok(())
}

proptest! {
    #![proptest_config(config(2000))]

    #[test]
    fn nodes_among_anything(scene in scene(Candidates::Nodes)) {
        check(&scene)?;
    }
}

proptest! {
    #![proptest_config(config(600))]

    #[test]
    fn bodies_among_anything(scene in scene(Candidates::Body)) {
        check(&scene)?;
    }
}

proptest! {
    #![proptest_config(config(1000))]

    #[test]
    fn nodes_of_sliding_cables_among_anything(scene in sliding_scene(Candidates::Nodes)) {
        check(&scene)?;
    }
}

proptest! {
    #![proptest_config(config(600))]

    #[test]
    fn bodies_with_sliding_cables_among_anything(scene in sliding_scene(Candidates::Body)) {
        check(&scene)?;
    }
}

proptest! {
    #![proptest_config(config(200))]

    /// Another input of the same value changes nothing: a load that is the tension of a
    /// pull holds the same shape, where it is stable under it.
    #[test]
    fn a_load_of_the_tension_holds_the_shape_of_a_pull(scene in sliding_scene(Candidates::Nodes)) {
        if let Ok(problem) = Problem::new(&scene) {
            let mut run = Run::new(&problem, Start::Straight, Settings::default());
            run.finish();
            let before = run.solved();
            let switched = switched(&before);
            run.retarget(&switched);
            run.finish();
            let after = run.solved();
            prop_assert!(after.certificate.holds());
            if after.events.is_empty() && after.status == Status::Converged {
                for (a, b) in before.bends.iter().zip(&after.bends) {
                    prop_assert!((a - b).abs() < 1e-7, "{a} {b}");
                }
            }
        }
    }

    /// A scene twice as large has a shape twice as large.
    #[test]
    fn scaling_changes_nothing(scene in scene(Candidates::Nodes)) {
        let large = scaled_scene(&scene, 2.0);
        if let (Ok(one), Ok(two)) = (Problem::new(&scene), Problem::new(&large)) {
            let (one, two) = (straight(&one), straight(&two));
            prop_assert_eq!(one.status.word(), two.status.word());
            if one.status == Status::Converged {
                for (a, b) in one.turns.iter().zip(&two.turns) {
                    prop_assert!((a - b).abs() < 1e-9);
                }
            }
        }
    }

    /// Starting from any other robot's shape costs time, not the answer.
    #[test]
    fn a_wrong_start_is_refused_or_leads_to_a_certified_shape(
        scene in scene(Candidates::Nodes),
        turns in prop::collection::vec(-1.4..1.4f64, 36),
    ) {
        if let Ok(problem) = Problem::new(&scene) {
            let right = straight(&problem);
            let mut wrong = right.solution().clone();
            for (turn, random) in wrong.turns.iter_mut().zip(&turns) {
                *turn = *random;
            }
            let wrong = Solved::pair(problem.clone(), wrong).unwrap();
            let again = solve(&problem, Start::From(&wrong), Settings::default());
            prop_assert!(again.certificate.holds());
            prop_assert_eq!(again.status.word(), right.status.word());
            for (a, b) in right.turns.iter().zip(&again.turns) {
                prop_assert!((a - b).abs() < 1e-9);
            }
            let mut shorter = wrong.into_solution();
            shorter.turns.pop();
            prop_assert!(Solved::pair(problem, shorter).is_none());
        }
    }

    /// A run in slices of one iteration ends where a run at one go does.
    #[test]
    fn slices_end_where_the_whole_does(scene in scene(Candidates::Nodes)) {
        if let Ok(problem) = Problem::new(&scene) {
            let whole = straight(&problem);
            let mut run = Run::new(&problem, Start::Straight, Settings::default());
            while run.advance(1) == sinew::equilibrium::Progress::Running {}
            prop_assert_eq!(&run.solution().turns, &whole.turns);
            prop_assert_eq!(&run.solution().status, &whole.status);
        }
    }

    /// Dragging an obstacle away while the solve runs, again and again: every
    /// state shown is certified, and the nodes never end up inside.
    #[test]
    fn retargeting_in_mid_run_keeps_to_equilibria(
        scene in scene(Candidates::Body),
        drags in prop::collection::vec((-10.0..10.0f64, -10.0..10.0f64, 1..30usize), 8),
    ) {
        if let Ok(mut problem) = Problem::new(&scene) {
            let mut run = Run::new(&problem, Start::Straight, Settings::default());
            for (x, y, iterations) in drags {
                let by = sinew::geometry::Vector::new(1e-3 * x, 1e-3 * y);
                let moved = problem.obstacles()[0].moved(by);
                problem.set_obstacle(0, moved);
                run.retarget(&problem);
                run.advance(iterations);
            }
            let solution = run.finish();
            prop_assert!(solution.certificate.holds(), "{:?}", solution.certificate);
            prop_assert!(solution.status != Status::NumericalFailure);
        }
    }
}
