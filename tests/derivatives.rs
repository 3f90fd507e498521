//! Every derivative the solver uses, against finite differences and against a
//! dense factorisation, on the robot's body among all shapes.

mod crowded;
mod turned;

use crowded::{controls, crowded};
use nalgebra::{DMatrix, DVector};
use sinew::contact::RowKind;
use sinew::mechanics::Problem;
use sinew::scene::Scene;
use sinew::solver::{
    Chain, Control, Hessian, Outcome, Riccati, RowId, Settings as SqpSettings, Source, Sqp,
};
use turned::{Planar, at};

fn nudged(controls: &[Control<1>], index: usize, by: f64) -> Vec<Control<1>> {
    let mut moved = controls.to_vec();
    moved[index][0] += by;
    moved
}

/// Multipliers for the rows of points at the same place: one a row by id.
fn multiplier(id: RowId) -> f64 {
    1.0 + ((id.0 % 97) as f64) / 97.0
}

/// Central differences of step 1e-6 err by 1e-12 of the third derivative, of
/// order 1e3 near sharp corners, and by rounding of 1e-17/1e-6 in metres.
#[test]
fn rows_and_cost_have_exact_gradients() {
    let problem = crowded();
    let controls = controls(&problem);
    let here = at(&problem, &controls);
    let h = 1e-6;
    let mut kinds = [0; 3];
    for row in &here.rows {
        match RowKind::of(row.id, problem.obstacles().len()) {
            RowKind::Contact { vertex: None, .. } => kinds[0] += 1,
            RowKind::Contact { .. } => kinds[1] += 1,
            RowKind::TurnLimit { .. } => kinds[2] += 1,
        }
        let gradient = here.row_gradient(row);
        for (index, exact) in gradient.iter().enumerate() {
            let value = |by: f64| {
                let moved = at(&problem, &nudged(&controls, index, by));
                moved.rows.iter().find(|r| r.id == row.id).map(|r| r.value)
            };
            let (Some(after), Some(before)) = (value(h), value(-h)) else {
                continue;
            };
            let slope = (after - before) / (2.0 * h);
            let exact = exact[0];
            assert!(
                (slope - exact).abs() < 1e-8,
                "{row:?} {index}: {slope} {exact}"
            );
        }
    }
    assert!(kinds.iter().all(|count| *count >= 2), "{kinds:?}");
    for index in 0..controls.len() {
        let cost = |by: f64| at(&problem, &nudged(&controls, index, by)).cost;
        let slope = (cost(h) - cost(-h)) / (2.0 * h);
        let exact = here.stages[index].cost_gradient[0];
        assert!((slope - exact).abs() < 1e-8 * (1.0 + exact.abs()));
    }
}

/// The multipliers of a point's rows: those kept have one, all others none.
fn multipliers(point: &Planar, kept: &[RowId]) -> Vec<f64> {
    let of = |id| {
        if kept.contains(&id) {
            multiplier(id)
        } else {
            0.0
        }
    };
    point.rows.iter().map(|row| of(row.id)).collect()
}

/// The Hessian of the Lagrangian by differencing its exact gradient, with the
/// multipliers and the set of rows held fixed.
fn dense_hessian(problem: &Problem, controls: &[Control<1>], kept: &[RowId]) -> DMatrix<f64> {
    let n = controls.len();
    let h = 1e-6;
    let gradient = |controls: &[Control<1>]| {
        let point = at(problem, controls);
        let multipliers = multipliers(&point, kept);
        let mut hessian = Hessian::default();
        let gradient = hessian.gradient(&point, &multipliers);
        DVector::from_iterator(n, gradient.iter().map(|g| g[0]))
    };
    DMatrix::from_columns(
        &(0..n)
            .map(|index| {
                let after = gradient(&nudged(controls, index, h));
                let before = gradient(&nudged(controls, index, -h));
                (after - before) / (2.0 * h)
            })
            .collect::<Vec<_>>(),
    )
}

/// The weights that pick one row.
fn only(index: usize, count: usize) -> Vec<f64> {
    (0..count)
        .map(|i| f64::from(u8::from(i == index)))
        .collect()
}

/// Rows that are there on both sides of a small change, so that differences
/// see only smooth changes.
fn steady_rows(problem: &Problem, controls: &[Control<1>]) -> Vec<RowId> {
    let mut kept: Vec<RowId> = at(problem, controls).rows.iter().map(|r| r.id).collect();
    for index in 0..controls.len() {
        for by in [1e-6, -1e-6] {
            let moved = at(problem, &nudged(controls, index, by));
            kept.retain(|id| moved.rows.iter().any(|row| row.id == *id));
        }
    }
    kept
}

#[test]
fn the_riccati_recursion_inverts_the_hessian() {
    let problem = crowded();
    let controls = controls(&problem);
    let kept = steady_rows(&problem, &controls);
    let point = at(&problem, &controls);
    let multipliers = multipliers(&point, &kept);
    let mut hessian = Hessian::default();
    hessian.gradient(&point, &multipliers);
    hessian.assemble(&problem, &point, &multipliers);
    let dense = dense_hessian(&problem, &controls, &kept);
    // The shift makes any Hessian positive, so the two can be compared whole.
    let shift = 10.0;
    let shifted = &dense + shift * DMatrix::identity(18, 18);
    let mut riccati = Riccati::default();
    riccati
        .factor(&point.stages, &hessian, shift, 1e-9)
        .unwrap();
    let (mut du, mut dz) = (Vec::new(), Vec::new());
    for (index, row) in point.rows.iter().enumerate() {
        let weights = only(index, point.rows.len());
        riccati.solve(&point, Source::Rows(&weights), &mut du, &mut dz);
        let found = DVector::from_iterator(18, du.iter().map(|d| d[0]));
        let gradient = point.row_gradient(row);
        let right = DVector::from_iterator(18, gradient.iter().map(|g| g[0]));
        let residual = (&shifted * &found - &right).amax();
        // Differencing leaves 1e-7 of the Hessian.
        assert!(residual < 1e-6 * (1.0 + right.amax()), "{residual}");
        // The states' perturbation belongs to the controls'.
        assert!((row.change(&du, &dz) - right.dot(&found)).abs() < 1e-12);
    }
    let none = vec![0.0; point.rows.len()];
    riccati.solve(&point, Source::Step(&none), &mut du, &mut dz);
    let found = DVector::from_iterator(18, du.iter().map(|d| d[0]));
    let right = DVector::from_iterator(18, point.stages.iter().map(|s| -s.cost_gradient[0]));
    assert!((&shifted * &found - &right).amax() < 1e-6 * right.amax());
}

#[test]
fn stiffening_adds_the_outer_product_of_the_gradient() {
    let problem = crowded();
    let controls = controls(&problem);
    let point = at(&problem, &controls);
    let none = vec![0.0; point.rows.len()];
    for (index, row) in point.rows.iter().enumerate() {
        let mut hessian = Hessian::default();
        hessian.gradient(&point, &none);
        hessian.assemble(&problem, &point, &none);
        hessian.stiffen(&point, row, 1e4);
        let mut riccati = Riccati::default();
        riccati.factor(&point.stages, &hessian, 0.0, 1e-12).unwrap();
        let gradient = point.row_gradient(row);
        let g = DVector::from_iterator(18, gradient.iter().map(|g| g[0]));
        let mut dense = 1e4 * &g * g.transpose();
        for i in 0..18 {
            dense[(i, i)] += point.stages[i].cost_curvature[(0, 0)];
        }
        let (mut du, mut dz) = (Vec::new(), Vec::new());
        let weights = only(index, point.rows.len());
        riccati.solve(&point, Source::Rows(&weights), &mut du, &mut dz);
        let found = DVector::from_iterator(18, du.iter().map(|d| d[0]));
        assert!((dense * found - &g).amax() < 1e-11, "{row:?}");
    }
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

/// One iteration from near an equilibrium is the Newton step of the dense KKT
/// system [H −Gᵀ; G 0] [d; λ] = [−∇f; −g] of its pressing rows.
#[test]
fn an_iteration_solves_the_dense_kkt_system() {
    let scene = Scene::from_toml(include_str!("../assets/scenes/two-discs.toml")).unwrap();
    let problem = Problem::new(&scene).unwrap();
    let mut sqp: Sqp<Problem, 3, 1> = Sqp::default();
    let settings = SqpSettings::default();
    sqp.start(&problem, &problem.free_controls(), &[], settings);
    assert_eq!(sqp.run(&problem), Outcome::Converged);
    let rows = sqp.point().rows.iter().zip(sqp.multipliers());
    let active: Vec<(RowId, f64)> = rows
        .filter(|(_, multiplier)| **multiplier > 0.0)
        .map(|(row, multiplier)| (row.id, *multiplier))
        .collect();
    assert_eq!(active.len(), 2);

    let near = nudged(&nudged(&sqp.point().controls, 2, 2e-4), 11, -3e-4);
    let point = at(&problem, &near);
    let gradient_at = |controls: &[Control<1>]| {
        let point = at(&problem, controls);
        let multipliers: Vec<f64> = point
            .rows
            .iter()
            .map(|row| {
                active
                    .iter()
                    .find(|(id, _)| *id == row.id)
                    .map_or(0.0, |a| a.1)
            })
            .collect();
        let mut hessian = Hessian::default();
        let gradient = hessian.gradient(&point, &multipliers);
        DVector::from_iterator(18, gradient.iter().map(|g| g[0]))
    };
    let mut kkt = DMatrix::zeros(20, 20);
    let mut right = DVector::zeros(20);
    for index in 0..18 {
        let after = gradient_at(&nudged(&near, index, 1e-6));
        let before = gradient_at(&nudged(&near, index, -1e-6));
        kkt.view_mut((0, index), (18, 1))
            .copy_from(&((after - before) / 2e-6));
        right[index] = -point.stages[index].cost_gradient[0];
    }
    for (column, (id, _)) in active.iter().enumerate() {
        let row = point.rows.iter().find(|row| row.id == *id).unwrap();
        for (index, gradient) in point.row_gradient(row).iter().enumerate() {
            kkt[(index, 18 + column)] = -gradient[0];
            kkt[(18 + column, index)] = gradient[0];
        }
        right[18 + column] = -row.value;
    }
    let dense = kkt.lu().solve(&right).unwrap();

    sqp.start(&problem, &near, &active, settings);
    sqp.step(&problem);
    for index in 0..18 {
        let step = sqp.point().controls[index][0] - near[index][0];
        assert!(
            (step - dense[index]).abs() < 1e-9,
            "{index}: {step} {}",
            dense[index]
        );
    }
    for (column, (id, _)) in active.iter().enumerate() {
        let rows = sqp.point().rows.iter().zip(sqp.multipliers());
        let found = rows
            .filter(|(row, _)| row.id == *id)
            .map(|(_, m)| *m)
            .sum::<f64>();
        assert!((found - dense[18 + column]).abs() < 1e-6 * found);
    }
}
