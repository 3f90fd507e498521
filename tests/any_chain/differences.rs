//! Central differences in the controls of a chain, of its values and of its
//! exact gradients.

use crate::rolled_out::at;
use nalgebra::{DMatrix, DVector};
use sinew::solver::{Chain, Control, Hessian, Point, RowId};

/// The step of all differences, in controls, which are of order 1. Central
/// ones err by a sixth of 1e-12 of the third derivative, and by rounding of
/// 1e-16 of the value over the step.
const STEP: f64 = 1e-6;

/// A point, and the points to both sides of it in each control.
pub struct Around<C: Chain<NX, NU>, const NX: usize, const NU: usize> {
    pub here: Point<C, NX, NU>,
    /// A step further and a step back, one pair a number of the controls.
    pub sides: Vec<[Point<C, NX, NU>; 2]>,
}

/// The numbers of all controls, one below the other.
pub fn flat<const NU: usize>(controls: &[Control<NU>]) -> DVector<f64> {
    let numbers = controls.iter().flat_map(|u| u.iter().copied());
    DVector::from_iterator(NU * controls.len(), numbers)
}

/// The controls with one of their numbers changed.
pub fn nudged<const NU: usize>(
    controls: &[Control<NU>],
    index: usize,
    by: f64,
) -> Vec<Control<NU>> {
    let mut moved = controls.to_vec();
    moved[index / NU][index % NU] += by;
    moved
}

impl<C: Chain<NX, NU>, const NX: usize, const NU: usize> Around<C, NX, NU> {
    /// Evaluates the chain at all of them, which have to be inside its domain.
    pub fn new(chain: &C, controls: &[Control<NU>]) -> Result<Self, String> {
        let side = |index, by| at(chain, &nudged(controls, index, by));
        let around = Self {
            here: at(chain, controls),
            sides: (0..NU * controls.len())
                .map(|index| [side(index, STEP), side(index, -STEP)])
                .collect(),
        };
        let finite = |point: &Point<C, NX, NU>| point.cost.is_finite();
        if finite(&around.here) && around.sides.iter().flatten().all(finite) {
            Ok(around)
        } else {
            Err("the controls are at the border of the chain's domain".to_owned())
        }
    }

    /// The cost's slope in one number of the controls.
    pub fn cost_slope(&self, index: usize) -> f64 {
        let [after, before] = &self.sides[index];
        (after.cost - before.cost) / (2.0 * STEP)
    }

    /// A row's slope; `None` where it comes or goes within the step.
    pub fn row_slope(&self, index: usize, id: RowId) -> Option<f64> {
        let [after, before] = &self.sides[index];
        let (here, there) = (named(after, id)?, named(before, id)?);
        Some((value(after, here) - value(before, there)) / (2.0 * STEP))
    }

    /// A row's gradient; `None` where it comes or goes within a step.
    pub fn row_gradient(&self, id: RowId) -> Option<DVector<f64>> {
        let slopes: Option<Vec<_>> = (0..self.sides.len())
            .map(|index| self.row_slope(index, id))
            .collect();
        slopes.map(DVector::from_vec)
    }

    /// The rows on all sides, so that differences see only smooth changes.
    pub fn steady(&self) -> Vec<RowId> {
        let rows = 0..self.here.row_count();
        let mut kept: Vec<RowId> = rows.map(|row| self.here.row_id(row)).collect();
        kept.retain(|id| self.row_gradient(*id).is_some());
        kept
    }

    /// The Hessian of Σ L − Σ λ g by differences of its exact gradient, with
    /// one λ a row by its id.
    pub fn hessian(&self, multiplier: impl Fn(RowId) -> f64) -> DMatrix<f64> {
        let gradient = |point: &Point<C, NX, NU>| {
            let multipliers: Vec<f64> = (0..point.row_count())
                .map(|row| multiplier(point.row_id(row)))
                .collect();
            flat(Hessian::default().gradient(point, &multipliers))
        };
        let columns: Vec<_> = self
            .sides
            .iter()
            .map(|[after, before]| (gradient(after) - gradient(before)) / (2.0 * STEP))
            .collect();
        DMatrix::from_columns(&columns)
    }
}

/// The place among all of the row of this id, where it is there.
pub fn named<C: Chain<NX, NU>, const NX: usize, const NU: usize>(
    point: &Point<C, NX, NU>,
    id: RowId,
) -> Option<usize> {
    (0..point.row_count()).find(|row| point.row_id(*row) == id)
}

/// A row's value, by its place among all.
pub fn value<C: Chain<NX, NU>, const NX: usize, const NU: usize>(
    point: &Point<C, NX, NU>,
    row: usize,
) -> f64 {
    match point.rows.get(row) {
        Some(row) => row.value,
        None => point.sums[row - point.rows.len()].value,
    }
}
