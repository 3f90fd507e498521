//! Every derivative the solver uses, against finite differences and against a
//! dense factorisation: on the robot's body among all shapes, and by the same
//! checks on chains of other dimensions whose stages differ.

mod any_chain;
mod crowded;
mod rolled_out;

use any_chain::doctored::{Doctored, Flaw};
use any_chain::made_up::MadeUp;
use any_chain::recharted::{Recharted, RowsIn};
use any_chain::{
    Tolerances, check_gradients, check_hessian, check_kkt, check_stiffening, minimum, nudged,
};
use crowded::{bends, controls, crowded, strung};
use rolled_out::at;
use sinew::contact::RowKind;
use sinew::mechanics::{Equal, Mechanics, Problem, Sliding};
use sinew::scene::Scene;
use sinew::solver::{Chain, Control, Hessian, Riccati, RowId};

/// For values of order 1 or less, in chains of some ten stages.
const ALLOWED: Tolerances = Tolerances {
    // Third derivatives are of order 1e3 near sharp corners, rounding leaves
    // 1e-17/1e-6 in metres.
    slope: 1e-8,
    // Differencing leaves 1e-7 of the Hessian.
    curvature: 1e-6,
    // Some ten units in the last place at each stage.
    rounding: 1e-12,
    // The same, and the condition that a stiffness of 1e4 makes.
    stiffened: 1e-11,
    // What differencing leaves of the Hessian, times steps of some 1e-4, with
    // the condition of H to spare.
    step: 1e-9,
    multiplier: 1e-6,
};

/// The stiffness added: so large that the gradient by which it is added counts.
const STIFFNESS: f64 = 1e4;

/// Rows of points, of edges, and of limits.
fn kinds(problem: &Equal, rows: &[RowId]) -> [usize; 3] {
    let mut kinds = [0; 3];
    for id in rows {
        match RowKind::of(*id, problem.obstacles().len()) {
            RowKind::Contact { vertex: None, .. } => kinds[0] += 1,
            RowKind::Contact { .. } => kinds[1] += 1,
            RowKind::TurnLimit { .. } | RowKind::Cable { .. } => kinds[2] += 1,
        }
    }
    kinds
}

#[test]
fn the_robots_rows_and_cost_have_exact_gradients() {
    let problem = crowded();
    let compared = check_gradients(&problem, &controls(&problem), ALLOWED).unwrap();
    let kinds = kinds(&problem, &compared);
    assert!(kinds.iter().all(|count| *count >= 2), "{kinds:?}");
}

#[test]
fn the_recursion_inverts_the_robots_hessian() {
    let problem = crowded();
    let compared = check_hessian(&problem, &controls(&problem), ALLOWED).unwrap();
    let kinds = kinds(&problem, &compared);
    assert!(kinds.iter().all(|count| *count >= 2), "{kinds:?}");
}

#[test]
fn stiffening_adds_the_outer_product_of_the_robots_gradients() {
    let problem = crowded();
    let compared = check_stiffening(&problem, &controls(&problem), STIFFNESS, ALLOWED).unwrap();
    let kinds = kinds(&problem, &compared);
    assert!(kinds.iter().all(|count| *count >= 2), "{kinds:?}");
}

/// One arc a bay, two, and fewer than there is room for.
#[test]
fn sliding_cables_have_exact_derivatives() {
    check_strung::<1>(1);
    check_strung::<2>(2);
    check_strung::<4>(3);
}

fn check_strung<const NU: usize>(segments_per_bay: u32) {
    let sliding: Sliding<NU> = strung(segments_per_bay);
    let controls = bends(&sliding);
    let count = sliding.obstacles().len();
    let all = [
        check_gradients(&sliding, &controls, ALLOWED),
        check_hessian(&sliding, &controls, ALLOWED),
        check_stiffening(&sliding, &controls, STIFFNESS, ALLOWED),
    ];
    for (check, compared) in all.into_iter().enumerate() {
        let compared = compared.unwrap();
        let is = |of: fn(RowKind) -> bool| {
            let kinds = compared.iter().map(|id| RowKind::of(*id, count));
            kinds.filter(|kind| of(*kind)).count()
        };
        let points = is(|kind| matches!(kind, RowKind::Contact { vertex: None, .. }));
        let edges = is(|kind| {
            matches!(
                kind,
                RowKind::Contact {
                    vertex: Some(_),
                    ..
                }
            )
        });
        let cables = is(|kind| matches!(kind, RowKind::Cable { .. }));
        assert!(points >= 2 && edges >= 2, "{points} {edges}");
        // A cable's length stiffens by other means.
        assert!(cables == 2 || check == 2, "{cables}");
    }
    let point = at(&sliding, &controls);
    let inside = point.rows.iter().filter(|row| row.control.amax() > 0.0);
    assert!(NU == 1 || inside.count() >= 2);
}

/// Near where the robot rests on two discs.
#[test]
fn an_iteration_solves_the_robots_dense_kkt_system() {
    let scene = Scene::from_toml(include_str!("../assets/scenes/two-discs.toml")).unwrap();
    let problem = Equal::new(Problem::new(&scene).unwrap());
    let (least, pressing) = minimum(&problem, &problem.free_controls());
    assert_eq!(pressing.len(), 2);
    let near = nudged(&nudged(&least, 2, 2e-4), 11, -3e-4);
    let step = check_kkt(&problem, &near, &pressing, ALLOWED).unwrap();
    assert!(step > 1e-4, "{step}");
}

#[test]
fn a_pivot_that_is_not_positive_is_found_where_it_is() {
    let problem = crowded();
    let point = at(&problem, &controls(&problem));
    let none = vec![0.0; point.rows.len()];
    let mut hessian = Hessian::default();
    hessian.gradient(&point, &none);
    hessian.assemble(&problem, &point, &none);
    // Without rows the Hessian is the diagonal of the costs' curvatures.
    hessian.stages[4].by_control[(0, 0)] = -1.0;
    let mut riccati: Riccati<3, 1> = Riccati::default();
    let found = riccati.factor(&point.stages, &hessian, 0.0, 1e-9);
    assert_eq!(found.unwrap_err().stage, 5);
    let (mut du, mut dz) = (Vec::new(), Vec::new());
    riccati.descend(&point, 5, &mut du, &mut dz);
    assert!(du[4][0] != 0.0);
    assert_eq!(problem.stages(), du.len());
}

/// Where a chain is checked: anywhere, and near a minimum with rows that press.
struct Places<const NU: usize> {
    anywhere: Vec<Control<NU>>,
    near: Vec<Control<NU>>,
    pressing: Vec<(RowId, f64)>,
}

fn places<const NX: usize, const NU: usize>(chain: &MadeUp<NX, NU>) -> Places<NU> {
    let anywhere = chain.controls();
    let (least, pressing) = minimum(chain, &anywhere);
    let near = least.iter().zip(&anywhere).map(|(u, d)| u + 1e-3 * d);
    Places {
        near: near.collect(),
        anywhere,
        pressing,
    }
}

/// The four checks' outcomes, with how many rows each compared.
fn outcomes<C: Chain<NX, NU>, const NX: usize, const NU: usize>(
    chain: &C,
    places: &Places<NU>,
) -> [Result<usize, String>; 4] {
    let Places {
        anywhere,
        near,
        pressing,
    } = places;
    let count = |rows: Vec<RowId>| rows.len();
    [
        check_gradients(chain, anywhere, ALLOWED).map(count),
        check_hessian(chain, anywhere, ALLOWED).map(count),
        check_stiffening(chain, anywhere, STIFFNESS, ALLOWED).map(count),
        check_kkt(chain, near, pressing, ALLOWED).map(|_| pressing.len()),
    ]
}

fn check_made_up<const NX: usize, const NU: usize>() {
    let chain: MadeUp<NX, NU> = MadeUp { stages: 7 };
    let places = places(&chain);
    for outcome in outcomes(&chain, &places) {
        let compared = outcome.unwrap();
        assert!(compared >= 2, "{NX} {NU}: {compared}");
    }
}

/// More states than controls, fewer, and one of each.
#[test]
fn chains_of_other_dimensions_pass_the_same_checks() {
    check_made_up::<4, 2>();
    check_made_up::<2, 3>();
    check_made_up::<1, 1>();
}

/// A flaw in a first derivative shows in the gradients, and in every comparison
/// with what the gradients' differences or the values say; what stiffens
/// are rows of single stages, and the costs' own slopes in the state do not change it.
#[test]
fn a_derivative_that_is_off_by_a_hundredth_is_found() {
    let chain: MadeUp<4, 2> = MadeUp { stages: 7 };
    let places = places(&chain);
    for flaw in Flaw::ALL {
        let expected = match flaw {
            Flaw::ByState
            | Flaw::ByControl
            | Flaw::CostGradient
            | Flaw::RowBefore
            | Flaw::RowAfter => [true; 4],
            Flaw::RowControl => [true; 4],
            Flaw::CostByState | Flaw::SumGradient => [true, true, false, true],
            Flaw::CostCurvature => [false, true, true, true],
            Flaw::DynamicsByState
            | Flaw::DynamicsMixed
            | Flaw::DynamicsByControl
            | Flaw::CurvatureBefore
            | Flaw::CurvatureAcross
            | Flaw::CurvatureAfter
            | Flaw::InsideByState
            | Flaw::InsideMixed
            | Flaw::InsideByControl
            | Flaw::SumCurvature => [false, true, false, true],
        };
        let doctored = Doctored {
            chain: &chain,
            flaw,
        };
        let found = outcomes(&doctored, &places).map(|outcome| outcome.is_err());
        assert_eq!(found, expected, "{flaw:?}");
    }
}

#[test]
fn a_derivative_of_the_robot_that_is_off_by_a_hundredth_is_found() {
    let problem = crowded();
    let controls = controls(&problem);
    for flaw in Flaw::OF_STATES {
        let doctored = Doctored {
            chain: &problem,
            flaw,
        };
        let gradients = check_gradients(&doctored, &controls, ALLOWED);
        let hessian = check_hessian(&doctored, &controls, ALLOWED);
        assert!(gradients.is_err() || hessian.is_err(), "{flaw:?}");
    }
}

/// The derivatives of what is a function of the controls are the same whatever
/// a node's perturbations are taken to be.
#[test]
fn charts_of_the_nodes_do_not_matter() {
    let chain: MadeUp<4, 2> = MadeUp { stages: 7 };
    let places = places(&chain);
    let recharted = Recharted {
        chain: &chain,
        rows_in: RowsIn::TheSame,
    };
    for outcome in outcomes(&recharted, &places) {
        assert!(outcome.unwrap() >= 2);
    }
    let (here, there) = (
        at(&chain, &places.anywhere),
        at(&recharted, &places.anywhere),
    );
    for (row, other) in here.rows.iter().zip(&there.rows) {
        let moved = row.after - other.after;
        assert!(row.after.amax() == 0.0 || moved.amax() > 1e-2);
        let (gradient, same) = (here.row_gradient(row), there.row_gradient(other));
        for (gradient, same) in gradient.iter().zip(&same) {
            assert!((gradient - same).amax() < ALLOWED.rounding);
        }
    }
    let problem = crowded();
    let recharted = Recharted {
        chain: &problem,
        rows_in: RowsIn::TheSame,
    };
    check_hessian(&recharted, &controls(&problem), ALLOWED).unwrap();
}

/// Two charts with the same tangents give the same gradients, and no Hessian.
#[test]
fn rows_in_another_chart_than_the_dynamics_are_found() {
    let chain: MadeUp<4, 2> = MadeUp { stages: 7 };
    let places = places(&chain);
    let recharted = Recharted {
        chain: &chain,
        rows_in: RowsIn::Tangent,
    };
    let found = outcomes(&recharted, &places).map(|outcome| outcome.is_err());
    assert_eq!(found, [false, true, false, true]);
}
