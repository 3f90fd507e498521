//! The subproblem's optimality, checked as it is defined, whatever rows it
//! starts from and whichever can be met.

use super::*;
use crate::solver::linear::{CONTROLS, Linear, blocks, cost_gradient, gradient, hessian, point};
use nalgebra::{DMatrix, DVector};

type Chained = Point<Linear, 3, 2>;

const TOLERANCE: f64 = 1e-9;

fn dense(controls: &[Control<2>]) -> DVector<f64> {
    DVector::from_iterator(CONTROLS, controls.iter().flat_map(|u| u.iter().copied()))
}

/// A set that is solved, with the factor it was solved with.
struct Solved {
    set: WorkingSet<3, 2>,
    riccati: Riccati<3, 2>,
    hessian: DMatrix<f64>,
}

fn solved(point: &Chained, guess: &[f64], penalty: f64, stiffness: f64) -> Solved {
    let none = vec![0.0; point.rows.len()];
    let chain = Linear { bent: 0.0 };
    let mut parts = blocks(&chain, point, &none);
    let mut all = hessian(&chain, point, &none);
    for (row, guess) in point.rows.iter().zip(guess) {
        if stiffness > 0.0 && held(*guess, penalty) {
            parts.stiffen(point, row, stiffness);
            let g = gradient(point, row);
            all += stiffness * &g * g.transpose();
        }
    }
    let mut riccati = Riccati::default();
    riccati.factor(&point.stages, &parts, 0.0, 1e-9).unwrap();
    let mut set = WorkingSet::default();
    let terms = Terms {
        penalty,
        tolerance: TOLERANCE,
        stiffness,
    };
    set.solve(&mut riccati, point, guess, terms);
    Solved {
        set,
        riccati,
        hessian: all,
    }
}

/// Whether d and λ solve min ½dᵀHd + ∇fᵀd + ν Σ s under the rows.
fn check(point: &Chained, guess: &[f64], penalty: f64, stiffness: f64) -> (usize, usize) {
    let Solved { set, hessian, .. } = solved(point, guess, penalty, stiffness);
    let step = dense(&set.du);
    let mut left = &hessian * &step + cost_gradient(point);
    let (mut active, mut saturated) = (0, 0);
    for (index, row) in point.rows.iter().enumerate() {
        let multiplier = set.multipliers[index];
        let g = gradient(point, row);
        left -= multiplier * &g;
        if stiffness > 0.0 && held(guess[index], penalty) {
            left += stiffness * row.value * &g;
        }
        let value = row.value + g.dot(&step);
        let slack = 1e-7;
        assert!((0.0..=penalty).contains(&multiplier), "{multiplier}");
        if multiplier == 0.0 {
            assert!(value >= -slack, "{index} idle at {value}");
        } else if multiplier == penalty {
            saturated += 1;
            assert!(value <= slack, "{index} gives way at {value}");
        } else {
            active += 1;
            assert!(value.abs() <= slack, "{index} is met at {value}");
        }
        assert!((row.change(&set.du, &set.dz) - g.dot(&step)).abs() < 1e-9);
    }
    assert!(left.amax() < 1e-7, "{}", left.amax());
    (active, saturated)
}

/// Rows as they are, deeper, and met from the start; guesses of none, all and
/// every other; multipliers bounded so low that rows give way, and not at all.
#[test]
fn the_step_and_its_multipliers_are_optimal() {
    let (mut active, mut saturated) = (0, 0);
    for shift in [0.0, -0.6, -1.5, 0.3] {
        let mut point = point();
        for row in &mut point.rows {
            row.value += shift;
        }
        let count = point.rows.len();
        for penalty in [1e6, 3.0, 0.7, 0.1] {
            for every in [usize::MAX, 1, 2, 3] {
                for size in [0.05, 0.5, 5.0, 1e6] {
                    let guess: Vec<f64> = (0..count)
                        .map(|row| if row % every == every - 1 { size } else { 0.0 })
                        .collect();
                    let guess: Vec<f64> = guess.iter().map(|g| g.min(penalty)).collect();
                    let plain = check(&point, &guess, penalty, 0.0);
                    assert_eq!(plain, check(&point, &vec![0.0; count], penalty, 0.0));
                    check(&point, &guess, penalty, 2.0);
                    active += plain.0;
                    saturated += plain.1;
                }
            }
        }
    }
    assert!(active > 300 && saturated > 300, "{active} {saturated}");
}

/// A correction changes every active row by what it is told is missing, and no
/// more of the step than that takes; taken back, the step is what it was.
#[test]
fn a_correction_moves_the_active_rows_to_where_they_should_be() {
    let point = point();
    let none = vec![0.0; point.rows.len()];
    let Solved {
        mut set,
        mut riccati,
        hessian,
    } = solved(&point, &none, 1e6, 0.0);
    let before = dense(&set.du);
    let missing = |row: usize| 0.01 * (1.0 + row as f64);
    set.correct(&mut riccati, &point, |row, _| missing(row));
    let after = dense(&set.du);
    let members = set.members.clone();
    assert!(members.len() > 2);
    let mut rows = DMatrix::zeros(CONTROLS, members.len());
    for (column, &member) in members.iter().enumerate() {
        let g = gradient(&point, &point.rows[member]);
        let moved = g.dot(&(&after - &before));
        assert!((moved + missing(member)).abs() < 1e-9, "{member}: {moved}");
        rows.set_column(column, &g);
    }
    // The least change in the Hessian's measure lies in H⁻¹ times the rows.
    let force = &hessian * (&after - &before);
    let normal = rows.transpose() * &rows;
    let share = normal.lu().solve(&(rows.transpose() * &force)).unwrap();
    assert!((&rows * share - force).amax() < 1e-9);
    set.uncorrect(&mut riccati, &point);
    assert!((dense(&set.du) - before).amax() < 1e-11);
}
