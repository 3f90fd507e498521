//! How sure fitted constants are, and which of them the data cannot tell apart.
//!
//! ```text
//! J_ki = ∂r_k/∂x_i      s² = Σ r_k²/(m − p)      covariance = s² (JᵀJ)⁻¹
//! G = JᵀJ with columns of length 1,  G v = μ v:   x moves by s v_i/(|J_i| √μ) along v
//! ```
//!
//! Along an eigenvector of a small μ constants can be exchanged for one another with
//! hardly a change of what is computed. They are called inseparable where one standard
//! error along it is a large part of one of them, and where it is this direction that
//! makes their errors large (Belsley, Kuh and Welsch, Regression Diagnostics, 1980).

use super::model::Measurement;
use super::{CalibrationError, Constant, STEP};
use nalgebra::{DMatrix, SymmetricEigen};

/// One standard error along a direction, over a constant's size, from which on the
/// data leave the constant open: two of them make half of it.
const LARGE: f64 = 0.25;

/// How many times a direction has to raise the square of a constant's error, against
/// what it were if the others were known, for the constant to take part in it.
const RAISED: f64 = 5.0;

/// One standard error, were all else known, over a constant's size, from which on the
/// data leave it open by itself.
const OPEN: f64 = 0.5;

/// The size of a coefficient or share that is nearly nothing: a usual one.
const USUAL: f64 = 0.2;

/// How near a bound a constant is at it, in the fit's own scale.
const AT_BOUND: f64 = 1e-9;

/// How sure constants are, each list in their order.
#[derive(Clone, Debug, PartialEq)]
pub struct Uncertainty {
    /// Their standard errors, in the scene's units; `None` at a bound, and where the
    /// data do not depend on one.
    pub errors: Vec<Option<f64>>,
    /// The correlation of each with each; `None` where one has no error.
    pub correlation: Vec<Vec<Option<f64>>>,
    /// Which lie at the bound of their range.
    pub at_bound: Vec<bool>,
    /// Those that the data leave open even where the others are known.
    pub open: Vec<Constant>,
    /// Those that nothing that was read depends on.
    pub without_effect: Vec<Constant>,
    /// Groups that the data cannot tell apart.
    pub unseparated: Vec<Unseparated>,
}

/// Constants that the data cannot tell apart.
#[derive(Clone, Debug, PartialEq)]
pub struct Unseparated {
    /// Which.
    pub constants: Vec<Constant>,
    /// Those of them that the exchange which is least noticed takes, with how much it
    /// changes each, in the scene's unit: all at once, with these signs or all the
    /// others, by at most one standard error and no more than their size.
    pub exchange: Vec<(Constant, f64)>,
}

impl Uncertainty {
    pub(super) fn of(
        measurement: &Measurement,
        constants: &[Constant],
        at: &[f64],
    ) -> Result<Self, CalibrationError> {
        let count = constants.len();
        let slopes = slopes(measurement, constants, at);
        let residuals = measurement.deviations(constants, at);
        let at_bound: Vec<bool> = constants
            .iter()
            .zip(at)
            .map(|(constant, at)| {
                let (least, most) = bounds(*constant);
                at - least <= AT_BOUND || most - at <= AT_BOUND
            })
            .collect();
        let lengths: Vec<f64> = slopes.iter().map(|column| length(column)).collect();
        let free: Vec<usize> = (0..count)
            .filter(|i| !at_bound[*i] && lengths[*i] > 0.0)
            .collect();
        let freedom = (residuals.len() - free.len()) as f64;
        let spread = (residuals.iter().map(|r| r * r).sum::<f64>() / freedom).sqrt();
        let mut errors = vec![None; count];
        let mut correlation = vec![vec![None; count]; count];
        // In columns of length 1, whatever the constants' sizes.
        let inverse = gram(&slopes, &lengths, &free).try_inverse();
        if let Some(inverse) = inverse {
            for (a, i) in free.iter().enumerate() {
                let own = inverse[(a, a)].max(0.0).sqrt();
                let inside = spread * own / lengths[*i];
                errors[*i] = Some(inside * scale(constants[*i], at[*i]));
                for (b, j) in free.iter().enumerate() {
                    let both = own * inverse[(b, b)].max(0.0).sqrt();
                    correlation[*i][*j] = Some(inverse[(a, b)] / both);
                }
            }
        }
        // What the data leave open by itself is in nobody's way.
        let is_open = |i: &usize| spread >= OPEN * size(constants[*i], at[*i]) * lengths[*i];
        let seen = (0..count).filter(|i| lengths[*i] > 0.0);
        let (open, told): (Vec<usize>, Vec<usize>) = seen.partition(is_open);
        let unseparated = exchanges(constants, at, &slopes, &lengths, &told, spread);
        let without_effect = (0..count).filter(|i| lengths[*i] <= 0.0);
        Ok(Self {
            open: open.into_iter().map(|i| constants[i]).collect(),
            errors,
            correlation,
            at_bound,
            without_effect: without_effect.map(|i| constants[i]).collect(),
            unseparated,
        })
    }
}

fn bounds(constant: Constant) -> (f64, f64) {
    let limits = constant.limits();
    (constant.inside(limits.min), constant.inside(limits.max))
}

/// How fast a constant grows with what the fit has of it.
fn scale(constant: Constant, at: f64) -> f64 {
    match constant {
        Constant::Stiffness => constant.outside(at),
        _ => 1.0,
    }
}

/// The size of a constant in the fit's own scale.
fn size(constant: Constant, at: f64) -> f64 {
    match constant {
        // A logarithm: by its own size is by 1.
        Constant::Stiffness => 1.0,
        _ => at.abs().max(USUAL),
    }
}

fn length(column: &[f64]) -> f64 {
    column.iter().map(|x| x * x).sum::<f64>().sqrt()
}

/// ∂r/∂x by differences to both sides, or to the one within the bounds.
fn slopes(measurement: &Measurement, constants: &[Constant], at: &[f64]) -> Vec<Vec<f64>> {
    let column = |i: usize| {
        let (least, most) = bounds(constants[i]);
        let beside = |by: f64| {
            let mut moved = at.to_vec();
            moved[i] = (at[i] + by).clamp(least, most);
            let found = measurement.deviations(constants, &moved);
            (moved[i], found)
        };
        let ((a, before), (b, after)) = (beside(-STEP), beside(STEP));
        let pairs = before.iter().zip(&after);
        pairs.map(|(x, y)| (y - x) / (b - a)).collect()
    };
    (0..constants.len()).map(column).collect()
}

fn gram(slopes: &[Vec<f64>], lengths: &[f64], of: &[usize]) -> DMatrix<f64> {
    DMatrix::from_fn(of.len(), of.len(), |a, b| {
        let (i, j) = (of[a], of[b]);
        let product: f64 = slopes[i].iter().zip(&slopes[j]).map(|(x, y)| x * y).sum();
        product / (lengths[i] * lengths[j])
    })
}

/// The groups, those that share a constant as one, with the exchange that is least
/// noticed.
fn exchanges(
    constants: &[Constant],
    at: &[f64],
    slopes: &[Vec<f64>],
    lengths: &[f64],
    seen: &[usize],
    spread: f64,
) -> Vec<Unseparated> {
    let eigen = SymmetricEigen::new(gram(slopes, lengths, seen));
    let mut order: Vec<usize> = (0..seen.len()).collect();
    order.sort_by(|a, b| eigen.eigenvalues[*a].total_cmp(&eigen.eigenvalues[*b]));
    let mut groups: Vec<Unseparated> = Vec::new();
    for k in order {
        // Rounding may put an eigenvalue that is 0 below it.
        let value = eigen.eigenvalues[k].max(f64::EPSILON);
        let part = |a: usize| eigen.eigenvectors[(a, k)];
        let moved = |a: usize| spread * part(a) / (lengths[seen[a]] * value.sqrt());
        let large = |a: &usize| {
            let i = seen[*a];
            moved(*a).abs() >= LARGE * size(constants[i], at[i])
        };
        let members: Vec<usize> = (0..seen.len())
            .filter(|a| part(*a) * part(*a) / value >= RAISED)
            .collect();
        if members.len() < 2 || !members.iter().any(large) {
            continue;
        }
        // As far as one standard error, and no constant by more than its size, beyond
        // which nothing is straight.
        let within = members.iter().map(|a| {
            let i = seen[*a];
            size(constants[i], at[i]) / moved(*a).abs()
        });
        let share = within.fold(1.0, f64::min);
        let share = share.copysign(moved(members[0]));
        let exchange = members.iter().map(|a| {
            let i = seen[*a];
            (constants[i], share * moved(*a) * scale(constants[i], at[i]))
        });
        let group = Unseparated {
            constants: members.iter().map(|a| constants[seen[*a]]).collect(),
            exchange: exchange.collect(),
        };
        let overlaps = |known: &&mut Unseparated| {
            let mut of = group.constants.iter();
            of.any(|constant| known.constants.contains(constant))
        };
        match groups.iter_mut().find(overlaps) {
            Some(known) => known.constants.extend(&group.constants),
            None => groups.push(group),
        }
    }
    for group in &mut groups {
        group.constants.sort();
        group.constants.dedup();
    }
    groups
}
