//! Whether a shape is to be believed, in words: the same in every picture and
//! every part of the window.

use super::drawing::Standing;
use super::quantity::Quantity;
use crate::equilibrium::{Solution, Status};
use crate::mechanics::Certificate;

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

/// Why a certificate does not hold.
fn refused(certificate: &Certificate) -> String {
    if certificate.residual() > Certificate::BOUND {
        let residual = Quantity::significant(certificate.residual(), "");
        let bound = Quantity::significant(Certificate::BOUND, "");
        format!(
            "the optimality residual is {}, over {}",
            residual.digits, bound.digits
        )
    } else if !certificate.orientation {
        "a segment is assembled the wrong way round".to_owned()
    } else {
        "the shape is balanced but not a minimum of the energy".to_owned()
    }
}
