//! The recursion where the Hessian is not positive, against dense matrices of
//! every part of it. Where it is, tests/derivatives.rs compares it with
//! differences.

use super::linear::{CONTROLS, Linear, STAGES, blocks, gradient, hessian, point};
use super::{Control, Point, Riccati};
use nalgebra::{DVector, SymmetricEigen};

const LINEAR: Linear = Linear { bent: 0.3 };

/// A multiplier for every row but some.
fn multipliers(point: &Point<Linear, 3, 2>) -> Vec<f64> {
    let rows = 0..point.rows.len();
    rows.map(|row| {
        if row % 5 == 3 {
            0.0
        } else {
            0.2 + 0.1 * row as f64
        }
    })
    .collect()
}

fn dense(controls: &[Control<2>]) -> DVector<f64> {
    DVector::from_iterator(CONTROLS, controls.iter().flat_map(|u| u.iter().copied()))
}

/// The shift at which the factor succeeds is that at which the least
/// eigenvalue is positive; just before, the way off leads down.
#[test]
fn a_hessian_that_is_not_positive_has_a_way_down() {
    let point = point();
    let multipliers = multipliers(&point);
    let all = hessian(&LINEAR, &point, &multipliers);
    let least = SymmetricEigen::new(all.clone()).eigenvalues.min();
    assert!(least < 0.0, "{least}");
    let blocks = blocks(&LINEAR, &point, &multipliers);
    let mut riccati = Riccati::default();
    let factor =
        |riccati: &mut Riccati<3, 2>, shift| riccati.factor(&point.stages, &blocks, shift, 1e-12);
    assert!(factor(&mut riccati, 1e-6 - least).is_ok());
    for share in [0.0, 0.5, 0.9, 0.999] {
        let shift = -share * least;
        let failed = factor(&mut riccati, shift).unwrap_err();
        assert!((1..=STAGES).contains(&failed.stage));
        let (mut du, mut dz) = (Vec::new(), Vec::new());
        riccati.descend(&point, failed.stage, &mut du, &mut dz);
        let d = dense(&du);
        let curvature = d.dot(&(&all * &d)) + shift * d.norm_squared();
        assert!(curvature < 0.0, "{share}: {curvature}");
        for row in &point.rows {
            let change = gradient(&point, row).dot(&d);
            assert!((row.change(&du, &dz) - change).abs() < 1e-11);
        }
        assert!(du[..failed.stage - 1].iter().all(|u| u.norm() == 0.0));
        assert!((du[failed.stage - 1].norm() - 1.0).abs() < 1e-12);
    }
}

/// Pivots smaller than asked for do not count as positive.
#[test]
fn pivots_have_to_exceed_the_least() {
    let point = point();
    let none = vec![0.0; point.rows.len()];
    let blocks = blocks(&Linear { bent: 0.0 }, &point, &none);
    let least = point.stages.iter().map(|stage| {
        let factor = nalgebra::Cholesky::new(stage.cost_curvature).unwrap();
        let pivot = factor.l()[(0, 0)].min(factor.l()[(1, 1)]);
        pivot * pivot
    });
    let least = least.fold(f64::INFINITY, f64::min);
    let mut riccati = Riccati::default();
    let mut factor = |bound| riccati.factor(&point.stages, &blocks, 0.0, bound);
    assert!(factor(0.999 * least).is_ok());
    assert!(factor(1.001 * least).is_err());
}
