//! Whether a shape is to be believed, in words: the same in every picture and
//! every part of the window.

use super::drawing::Standing;
use super::quantity::Quantity;
use crate::equilibrium::{Solution, Status};
use crate::mechanics::{Certificate, Condition, ConditionKind};

/// What became of a solve, in a word or two, such as `Branch ended`.
pub fn outcome(solution: &Solution) -> &'static str {
    match &solution.status {
        Status::Converged if is_certified(solution) => "Converged",
        Status::Converged => "Not certified",
        Status::Unfinished => "Unfinished",
        Status::Infeasible { .. } => "Infeasible",
        Status::BranchEnded { .. } => "Branch ended",
        Status::IterationLimit => "Iteration limit",
        Status::NumericalFailure => "Numerical failure",
    }
}

fn is_certified(solution: &Solution) -> bool {
    let Solution {
        status,
        certificate,
        nodes,
        ..
    } = solution;
    *status == Status::Converged && certificate.holds() && !nodes.is_empty()
}

/// One sentence on it, without its full stop; names nodes and obstacles by
/// index.
pub fn reason(solution: &Solution) -> String {
    match &solution.status {
        Status::Converged if !is_certified(solution) => {
            format!("not certified: {}", refused(&solution.certificate))
        }
        status => status.reason(),
    }
}

/// Whether a solution's shape is to be believed.
pub(super) fn standing(solution: &Solution) -> Standing {
    if is_certified(solution) {
        return Standing::Certified;
    }
    Standing::Greyed {
        what: outcome(solution),
        reason: reason(solution),
    }
}

/// Why a certificate does not hold: what is left, or else the first condition
/// that is not met.
fn refused(certificate: &Certificate) -> String {
    let wrong = certificate
        .conditions()
        .find_map(|(condition, value)| match condition.kind() {
            ConditionKind::YesOrNo(answers) if !condition.is_met(value) => Some(answers.wrong),
            _ => None,
        });
    let residual = certificate.residual();
    match wrong {
        Some(wrong) if residual.is_nan() || residual <= Condition::BOUND => wrong.to_owned(),
        _ => format!(
            "the optimality residual is {}, over {}",
            Quantity::significant(residual, "").digits,
            Quantity::significant(Condition::BOUND, "").digits
        ),
    }
}
