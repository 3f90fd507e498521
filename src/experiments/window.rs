//! The range of pulls over which something holds, with its ends by bisection.

use super::ExperimentError;
use super::scenes::solved_at;
use crate::equilibrium::Solution;
use crate::mechanics::Problem;
use crate::units::millimetres;

/// A range of pulls, in metres, at both ends of which something holds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PullWindow {
    /// The least pull, in metres.
    pub first: f64,
    /// The greatest pull, in metres.
    pub last: f64,
}

/// Ends are found to this, in millimetres: a tenth of what the reports show.
const GRAIN_MM: f64 = 1e-5;

/// The first unbroken range of pulls, among those from 0 to `most_mm`, for which
/// the solved robot is as asked; `None` where no pull of a grid of `step_mm` is.
///
/// Each pull is solved from the straight robot, so that the answer is that of a
/// robot that is drawn in once.
///
/// # Errors
/// If a pull cannot be solved for.
pub fn pull_window(
    problem: &Problem,
    most_mm: f64,
    step_mm: f64,
    holds: impl Fn(&Solution) -> bool,
) -> Result<Option<PullWindow>, ExperimentError> {
    let at = |pull_mm: f64| -> Result<bool, ExperimentError> {
        let solved = solved_at(problem, pull_mm)?;
        Ok(holds(&solved))
    };
    // From where it is one way to where it is the other.
    let edge = |mut one: f64, mut other: f64, wanted: bool| -> Result<f64, ExperimentError> {
        while (other - one).abs() > GRAIN_MM {
            let middle = 0.5 * (one + other);
            if at(middle)? == wanted {
                one = middle;
            } else {
                other = middle;
            }
        }
        Ok(one)
    };
    let steps = (most_mm / step_mm).round() as usize;
    let grid = |k: usize| most_mm * k as f64 / steps as f64;
    let mut first = None;
    let mut last = 0.0;
    for k in 0..=steps {
        match (at(grid(k))?, first) {
            (true, None) => {
                first = Some(if k == 0 {
                    0.0
                } else {
                    edge(grid(k), grid(k - 1), true)?
                });
                last = grid(k);
            }
            (true, Some(_)) => last = grid(k),
            (false, None) => {}
            (false, Some(_)) => {
                last = edge(last, grid(k), true)?;
                break;
            }
        }
    }
    let metres = crate::units::metres;
    Ok(first.map(|first| PullWindow {
        first: metres(first),
        last: metres(last),
    }))
}

impl PullWindow {
    /// The ends in millimetres.
    pub fn ends_mm(&self) -> (f64, f64) {
        (millimetres(self.first), millimetres(self.last))
    }
}
