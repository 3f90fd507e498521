//! Whether a chain's derivatives are those of its values, one question a
//! function, for chains of any states, controls, nodes and stages.
//!
//! All that is compared is a function of the controls alone, so it does not
//! matter in which chart of its nodes a chain states its derivatives, but all
//! of them have to be in the same.
//!
//! Each function fails with a sentence that says which derivative is off, and
//! otherwise tells what it compared, so that its caller can see that it was
//! something.

mod differences;
pub mod doctored;
pub mod made_up;
pub mod recharted;

pub use differences::nudged;

use crate::rolled_out::at;
use differences::{Around, flat, named, value};
use nalgebra::{DMatrix, DVector, SymmetricEigen};
use sinew::solver::{
    Chain, Control, Hessian, Outcome, Point, Riccati, Row, RowId, Settings, Source, Sqp, State,
};

/// What may be missing between two sides that should be equal; the reasons are
/// the caller's.
#[derive(Clone, Copy, Debug)]
pub struct Tolerances {
    /// Of a row's slope by differences, in the rows' unit, and of the cost's
    /// over 1 and the slope.
    pub slope: f64,
    /// Of H H⁻¹ b and b, H by differences, over 1 and b's greatest entry.
    pub curvature: f64,
    /// Of two ways to compute the same that differ in rounding alone.
    pub rounding: f64,
    /// Of a stiffened Hessian H H⁻¹ g and g, in rounding alone.
    pub stiffened: f64,
    /// Of an iteration's step and that of the dense system, in each control.
    pub step: f64,
    /// Of their multipliers, relative.
    pub multiplier: f64,
}

/// Fails with what is said of two numbers that differ by more than allowed, or
/// are not finite.
fn close(found: f64, expected: f64, allowed: f64, said: impl Fn() -> String) -> Result<(), String> {
    let miss = (found - expected).abs();
    if miss < allowed {
        return Ok(());
    }
    let said = said();
    Err(format!(
        "{said}: {found} is not {expected}, by {miss:e} where {allowed:e} is allowed"
    ))
}

/// The same for the entries that differ most.
fn all_close(
    found: &DVector<f64>,
    expected: &DVector<f64>,
    allowed: f64,
    said: impl Fn() -> String,
) -> Result<(), String> {
    let miss = |at: usize| (found[at] - expected[at]).abs();
    // What is no number comes last in this order.
    let Some(at) = (0..found.len()).max_by(|a, b| miss(*a).total_cmp(&miss(*b))) else {
        return Ok(());
    };
    close(found[at], expected[at], allowed, || {
        format!("{} in control {at}", said())
    })
}

/// The costs' gradient.
fn cost_gradient<C: Chain<NX, NU>, const NX: usize, const NU: usize>(
    point: &Point<C, NX, NU>,
) -> DVector<f64> {
    let none = vec![0.0; point.row_count()];
    flat(Hessian::default().gradient(point, &none))
}

/// The gradient of a row, by its place among all.
fn gradient_of<C: Chain<NX, NU>, const NX: usize, const NU: usize>(
    point: &Point<C, NX, NU>,
    row: usize,
) -> DVector<f64> {
    match point.rows.get(row) {
        Some(row) => flat(&point.row_gradient(row)),
        None => flat(&point.sums[row - point.rows.len()].gradient),
    }
}

/// What a step changes a row by, by its place among all.
fn change_of<C: Chain<NX, NU>, const NX: usize, const NU: usize>(
    point: &Point<C, NX, NU>,
    row: usize,
    (du, dz): (&[Control<NU>], &[State<NX>]),
) -> f64 {
    point.value_after(row, du, dz) - value(point, row)
}

/// The Hessian as the solver assembles it.
fn assembled<C: Chain<NX, NU>, const NX: usize, const NU: usize>(
    chain: &C,
    point: &Point<C, NX, NU>,
    multipliers: &[f64],
) -> Hessian<NX, NU> {
    let mut hessian = Hessian::default();
    hessian.gradient(point, multipliers);
    hessian.assemble(chain, point, multipliers);
    hessian
}

/// The factor of a Hessian and `shift` on its diagonal.
fn factored<C: Chain<NX, NU>, const NX: usize, const NU: usize>(
    point: &Point<C, NX, NU>,
    hessian: &Hessian<NX, NU>,
    shift: f64,
) -> Result<Riccati<NX, NU>, String> {
    let mut riccati = Riccati::default();
    match riccati.factor(&point.stages, hessian, shift, 1e-12) {
        Ok(()) => Ok(riccati),
        Err(at) => Err(format!("the assembled Hessian is not positive: {at:?}")),
    }
}

/// A shift that makes a Hessian positive, so that two can be compared whole.
fn shift_of(hessian: &DMatrix<f64>) -> f64 {
    let symmetric = 0.5 * (hessian + hessian.transpose());
    (1.0 - SymmetricEigen::new(symmetric).eigenvalues.min()).max(0.0)
}

/// H⁻¹ b for a right-hand side b, with the states' perturbation.
fn solved<C: Chain<NX, NU>, const NX: usize, const NU: usize>(
    riccati: &mut Riccati<NX, NU>,
    point: &Point<C, NX, NU>,
    source: Source<'_>,
) -> (Vec<Control<NU>>, Vec<State<NX>>) {
    let (mut du, mut dz) = (Vec::new(), Vec::new());
    riccati.solve(point, source, &mut du, &mut dz);
    (du, dz)
}

/// The weights that pick one row.
fn only(index: usize, count: usize) -> Vec<f64> {
    let weight = |i: usize| f64::from(u8::from(i == index));
    (0..count).map(weight).collect()
}

/// A row for every number of the controls that is this number, in the place
/// of the point's own rows: as right-hand sides they are the unit vectors.
fn with_unit_rows<C: Chain<NX, NU>, const NX: usize, const NU: usize>(
    mut point: Point<C, NX, NU>,
) -> Point<C, NX, NU> {
    let row = |index: usize| Row {
        id: RowId(index as u64),
        stage: index / NU + 1,
        value: 0.0,
        before: None,
        after: State::zeros(),
        control: Control::from_fn(|i, _| f64::from(u8::from(i == index % NU))),
    };
    point.rows = (0..NU * point.stages.len()).map(row).collect();
    point.sums.clear();
    point
}

/// Whether the cost and every row change with the controls as their gradients
/// say. Returns the rows of which every slope was compared; of a row that
/// comes or goes within a step only the others are.
pub fn check_gradients<C: Chain<NX, NU>, const NX: usize, const NU: usize>(
    chain: &C,
    controls: &[Control<NU>],
    allowed: Tolerances,
) -> Result<Vec<RowId>, String> {
    let around = Around::new(chain, controls)?;
    for row in 0..around.here.row_count() {
        let id = around.here.row_id(row);
        for (index, exact) in gradient_of(&around.here, row).iter().enumerate() {
            if let Some(slope) = around.row_slope(index, id) {
                close(*exact, slope, allowed.slope, || {
                    format!("the gradient of {id:?} in control {index}")
                })?;
            }
        }
    }
    for (index, exact) in cost_gradient(&around.here).iter().enumerate() {
        let slope = around.cost_slope(index);
        close(*exact, slope, allowed.slope * (1.0 + exact.abs()), || {
            format!("the gradient of the cost in control {index}")
        })?;
    }
    Ok(around.steady())
}

/// Whether the recursion along the chain inverts the Hessian that the exact
/// gradient's differences show, with a multiplier for every row that is there
/// on all sides. Returns these rows.
pub fn check_hessian<C: Chain<NX, NU>, const NX: usize, const NU: usize>(
    chain: &C,
    controls: &[Control<NU>],
    allowed: Tolerances,
) -> Result<Vec<RowId>, String> {
    let around = Around::new(chain, controls)?;
    let point = &around.here;
    let kept = around.steady();
    // From 1 to 2, and not the same for neighbouring rows.
    let multiplier = |id: RowId| {
        let size = 1.0 + ((id.0 % 97) as f64) / 97.0;
        if kept.contains(&id) { size } else { 0.0 }
    };
    let mut dense = around.hessian(multiplier);
    if !dense.iter().all(|entry| entry.is_finite()) {
        return Err("the Lagrangian's gradient is not finite".to_owned());
    }
    let shift = shift_of(&dense);
    for i in 0..dense.nrows() {
        dense[(i, i)] += shift;
    }
    let multipliers: Vec<f64> = (0..point.row_count())
        .map(|row| multiplier(point.row_id(row)))
        .collect();
    let hessian = assembled(chain, point, &multipliers);
    let mut riccati = factored(point, &hessian, shift)?;

    let units = with_unit_rows(at(chain, controls));
    for index in 0..units.rows.len() {
        let weights = only(index, units.rows.len());
        let (du, _) = solved(&mut riccati, &units, Source::Rows(&weights));
        let right = DVector::from_vec(weights);
        let size = allowed.curvature * (1.0 + right.amax());
        all_close(&(&dense * flat(&du)), &right, size, || {
            format!("H H⁻¹ of unit vector {index}")
        })?;
    }
    for row in 0..point.row_count() {
        let id = point.row_id(row);
        let weights = only(row, point.row_count());
        let (du, dz) = solved(&mut riccati, point, Source::Rows(&weights));
        let right = gradient_of(point, row);
        let size = allowed.curvature * (1.0 + right.amax());
        all_close(&(&dense * flat(&du)), &right, size, || {
            format!("H H⁻¹ of the gradient of {id:?}")
        })?;
        // The states' perturbation belongs to the controls'.
        let change = right.dot(&flat(&du));
        let found = change_of(point, row, (&du, &dz));
        close(found, change, allowed.rounding, || {
            format!("the change of {id:?}")
        })?;
    }
    let none = vec![0.0; point.row_count()];
    let (du, _) = solved(&mut riccati, point, Source::Step(&none));
    let right = -cost_gradient(point);
    let size = allowed.curvature * right.amax();
    all_close(&(&dense * flat(&du)), &right, size, || {
        "H H⁻¹ of the cost's gradient".to_owned()
    })?;
    Ok(kept)
}

/// Whether stiffening by a row adds ρ ∇g ∇gᵀ to the costs' Hessian: with the
/// gradient that the solver has, and, for rows that are there on all sides,
/// with that by differences. Returns these rows.
pub fn check_stiffening<C: Chain<NX, NU>, const NX: usize, const NU: usize>(
    chain: &C,
    controls: &[Control<NU>],
    stiffness: f64,
    allowed: Tolerances,
) -> Result<Vec<RowId>, String> {
    let around = Around::new(chain, controls)?;
    let point = &around.here;
    let none = vec![0.0; point.row_count()];
    let mut differences = around.hessian(|_| 0.0);
    let shift = shift_of(&differences);
    for i in 0..differences.nrows() {
        differences[(i, i)] += shift;
    }
    let units = with_unit_rows(at(chain, controls));
    let mut plain = factored(point, &assembled(chain, point, &none), shift)?;
    let columns: Vec<_> = (0..units.rows.len())
        .map(|index| {
            let weights = only(index, units.rows.len());
            flat(&solved(&mut plain, &units, Source::Rows(&weights)).0)
        })
        .collect();
    let Some(costs) = DMatrix::from_columns(&columns).try_inverse() else {
        return Err("the costs' Hessian is singular".to_owned());
    };
    let mut compared = Vec::new();
    for (index, row) in point.rows.iter().enumerate() {
        let mut hessian = assembled(chain, point, &none);
        hessian.stiffen(point, row, stiffness);
        let mut riccati = factored(point, &hessian, shift)?;
        let weights = only(index, point.row_count());
        let du = flat(&solved(&mut riccati, point, Source::Rows(&weights)).0);
        let stiffened =
            |costs: &DMatrix<f64>, g: &DVector<f64>| costs * &du + stiffness * g.dot(&du) * g;
        let g = flat(&point.row_gradient(row));
        all_close(&stiffened(&costs, &g), &g, allowed.stiffened, || {
            format!("H H⁻¹ of the gradient that stiffens, of {row:?}")
        })?;
        if let Some(g) = around.row_gradient(row.id) {
            let size = allowed.curvature * (1.0 + g.amax());
            all_close(&stiffened(&differences, &g), &g, size, || {
                format!("H H⁻¹ of the slopes that stiffen, of {row:?}")
            })?;
            compared.push(row.id);
        }
    }
    Ok(compared)
}

/// The controls of a minimum and the multipliers of the rows that press there,
/// by a run from `controls`.
pub fn minimum<C: Chain<NX, NU>, const NX: usize, const NU: usize>(
    chain: &C,
    controls: &[Control<NU>],
) -> (Vec<Control<NU>>, Vec<(RowId, f64)>) {
    let mut sqp: Sqp<C, NX, NU> = Sqp::default();
    sqp.start(chain, controls, &[], Settings::default());
    assert_eq!(sqp.run(chain), Outcome::Converged);
    let multipliers = sqp.multipliers().iter().enumerate();
    let pressing = multipliers
        .filter(|(_, multiplier)| **multiplier > 0.0)
        .map(|(row, multiplier)| (sqp.point().row_id(row), *multiplier));
    (sqp.point().controls.clone(), pressing.collect())
}

/// Whether one iteration from near a minimum, with the multipliers of the rows
/// that press there, is the Newton step of their dense KKT system
/// [H −Gᵀ; G 0] [d; λ] = [−∇f; −g]. Returns the step's greatest entry.
pub fn check_kkt<C: Chain<NX, NU>, const NX: usize, const NU: usize>(
    chain: &C,
    near: &[Control<NU>],
    pressing: &[(RowId, f64)],
    allowed: Tolerances,
) -> Result<f64, String> {
    let around = Around::new(chain, near)?;
    let point = &around.here;
    let n = around.sides.len();
    let of = |rows: &[(RowId, f64)], id: RowId| {
        let found = rows.iter().find(|(other, _)| *other == id);
        found.map_or(0.0, |(_, multiplier)| *multiplier)
    };
    let size = n + pressing.len();
    let mut kkt = DMatrix::zeros(size, size);
    let mut right = DVector::zeros(size);
    kkt.view_mut((0, 0), (n, n))
        .copy_from(&around.hessian(|id| of(pressing, id)));
    right.rows_mut(0, n).copy_from(&-cost_gradient(point));
    for (place, (id, _)) in (n..).zip(pressing) {
        let Some(row) = named(point, *id) else {
            return Err(format!("{id:?} presses and is not there"));
        };
        let g = gradient_of(point, row);
        kkt.view_mut((0, place), (n, 1)).copy_from(&-&g);
        kkt.view_mut((place, 0), (1, n)).tr_copy_from(&g);
        right[place] = -value(point, row);
        if let Some(sum) = row.checked_sub(point.rows.len()) {
            kkt[(place, place)] = point.sums[sum].row.compliance;
        }
    }
    let Some(dense) = kkt.lu().solve(&right) else {
        return Err("the dense KKT system is singular".to_owned());
    };

    let mut sqp: Sqp<C, NX, NU> = Sqp::default();
    sqp.start(chain, near, pressing, Settings::default());
    sqp.step(chain);
    let step = flat(&sqp.point().controls) - flat(near);
    let expected = dense.rows(0, n).into_owned();
    all_close(&step, &expected, allowed.step, || {
        "an iteration's step".to_owned()
    })?;
    let multipliers = sqp.multipliers().iter().enumerate();
    let after: Vec<_> = multipliers
        .map(|(row, m)| (sqp.point().row_id(row), *m))
        .collect();
    for (place, (id, _)) in (n..).zip(pressing) {
        let found = of(&after, *id);
        close(found, dense[place], allowed.multiplier * found, || {
            format!("the multiplier of {id:?} after an iteration")
        })?;
    }
    Ok(expected.amax())
}
