//! Sequential quadratic programming on a chain, one iteration at a time.
//!
//! Each iteration reads like the textbook: residuals, Hessian, subproblem,
//! line search. Residuals and multipliers are exact, so the end result tells
//! a row that presses from one that only touches.
//!
//! The merit function is Σ L + μ Σ max(0, −g) with μ above every multiplier.
//! A full step that raises it is first corrected to second order (curved
//! rows would otherwise cut every step short), then halved, straight or
//! along the arc of that correction.
//!
//! Where the exact Hessian is not positive definite it is made so without
//! losing fast convergence: first by ρ ∇g ∇gᵀ of the rows in the set, which
//! leaves the Newton step on them unchanged, and only then by a shift. A
//! stationary point that stays indefinite is a saddle and is left along its
//! direction of negative curvature.

mod convex;
mod search;

use super::chain::{Chain, Control, RowId};
use super::hessian::Hessian;
use super::point::{Point, Sum};
use super::riccati::{NotPositive, Riccati};
use super::working_set::{Terms, WorkingSet};
use crate::math::greatest;
use serde::{Deserialize, Serialize};

/// Whether an iteration may step over what [`Chain::passes_through`] names.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Tunnelling {
    /// Every step is checked: for a motion that starts from a true state.
    Forbidden,
    /// No step is checked: for a search from anywhere.
    Allowed,
}

/// Tolerances and limits. All dimensionless.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Settings {
    /// Iterations before giving up.
    pub iterations: usize,
    /// Greatest entry of the Lagrangian's gradient, relative to the greatest
    /// of the cost's (at least [`Chain::least_gradient`]). A point this near is within 1e-10 of the
    /// minimum in every control, and one more step would leave 1e-15; rounding
    /// at n = 10⁴ leaves 1e-12.
    pub stationarity: f64,
    /// Greatest violation of a row, relative to [`Chain::row_scale`].
    pub feasibility: f64,
    /// Whether steps are checked for tunnelling.
    pub tunnelling: Tunnelling,
}

impl Default for Settings {
    fn default() -> Self {
        Self {
            iterations: 100,
            stationarity: 1e-10,
            feasibility: 1e-12,
            tunnelling: Tunnelling::Forbidden,
        }
    }
}

/// How a run ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Outcome {
    /// A minimum: first-order conditions met, reduced Hessian positive.
    Converged,
    /// First-order conditions met, but not a minimum, and no way down found.
    Saddle,
    /// The rows' violation is stationary and not zero.
    Infeasible,
    /// The allowed iterations are used up.
    IterationLimit,
    /// No step along the search direction improves the merit.
    Stalled,
    /// Every step ahead leads over what [`Chain::passes_through`] names.
    Blocked,
    /// The starting controls are outside the chain's domain.
    OutsideDomain,
}

/// What one call of [`Sqp::step`] led to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Progress {
    /// Not done: call again.
    Running,
    /// Done; further calls change nothing.
    Done(Outcome),
}

/// One line of the iteration trace: the point an iteration started from.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Iteration {
    /// Σ L.
    pub cost: f64,
    /// Greatest entry of the Lagrangian's gradient.
    pub stationarity: f64,
    /// Greatest violation of a row, in the rows' unit.
    pub violation: f64,
    /// Rows with a positive multiplier.
    pub active: usize,
    /// Greatest change of a control in the step taken from here.
    pub step: f64,
    /// The shift that made the Hessian positive; 0 where none was needed.
    pub shift: f64,
}

/// Penalties ν tried in turn, over the rows' scale. Costs are of order 1 a
/// stage; the multipliers of rows that press reach some hundreds, and where they
/// leave the chain hardly a way to move some ten thousand.
const PENALTIES: [f64; 2] = [1e4, 1e6];
/// Stiffnesses ρ tried in turn, times the greatest multiplier (at least 1 over
/// the rows' scale) over the rows' scale.
const STIFFNESSES: [f64; 3] = [1e2, 1e4, 1e6];
/// Pivots below this share of the cost's curvature (of order 1) count as not
/// positive.
const LEAST_PIVOT: f64 = 1e-9;
/// The least shift tried, in the cost's curvature (of order 1). Just past a
/// fold the curvature is hardly negative, and a shift much above it would make
/// the slide away from there crawl.
const LEAST_SHIFT: f64 = 1e-7;
/// The factor between shifts tried in turn.
const MORE_SHIFT: f64 = 4.0;
/// The shift that follows where no step, or only [`SHORT_STEPS`] short ones, could
/// be taken: of the size of the cost's curvature.
const FIRST_SHIFT: f64 = 1.0;
/// The part of a step below which it counts as short …
const SHORT: f64 = 1.0 / 64.0;
/// … and how many of them in a row are too many.
const SHORT_STEPS: usize = 3;
/// The merit's weight falls back where it exceeds the multipliers this often …
const OVERWEIGHT: f64 = 1e3;
/// … but not more often than this in a run, which keeps it monotone in the end.
const RELAXATIONS: usize = 4;
/// Armijo's constant.
const SUFFICIENT: f64 = 1e-4;
/// Changes of the merit below this share of its size are rounding.
const ROUNDING: f64 = 1e-14;
/// Rounding of the rows' part of the Lagrangian's gradient, relative to the
/// largest multiplier times the rows' scale: about 50 units in the last place.
const FORCE_ROUNDING: f64 = 1e-14;
/// Two Newton steps in a row that change no control by more than this are at the
/// minimum, whatever the rounding of large multipliers leaves of the gradient:
/// a tenth of the distance that [`Settings::stationarity`] stands for.
const SETTLED: f64 = 1e-11;
/// How many times the usual rounding that may be. Short steps that a line search
/// cut, far from the minimum, leave more.
const LEFT_SETTLED: f64 = 100.0;
/// How far a saddle is left, in controls.
const NUDGE: f64 = 0.02;
/// How often a run leaves saddles.
const NUDGES: usize = 4;

/// The state of a run: a point, its multipliers, and the storage of a step.
#[derive(Clone, Debug)]
pub struct Sqp<C: Chain<NX, NU>, const NX: usize, const NU: usize> {
    settings: Settings,
    point: Point<C, NX, NU>,
    trial: Point<C, NX, NU>,
    /// One a row of `point`, those of summed rows last.
    multipliers: Vec<f64>,
    /// The last multipliers by name, for rows that come back.
    named: Vec<(RowId, f64)>,
    hessian: Hessian<NX, NU>,
    riccati: Riccati<NX, NU>,
    set: WorkingSet<NX, NU>,
    trace: Vec<Iteration>,
    penalty: usize,
    merit_penalty: f64,
    shift: f64,
    /// The second-order correction of the present full step, where one was
    /// tried.
    correction: Vec<Control<NU>>,
    has_correction: bool,
    /// Whether the last factor was of the unshifted Hessian.
    exact: bool,
    /// Short steps in a row.
    short: usize,
    nudges: usize,
    relaxations: usize,
    done: Option<Outcome>,
}

impl<C: Chain<NX, NU>, const NX: usize, const NU: usize> Default for Sqp<C, NX, NU> {
    fn default() -> Self {
        Self {
            settings: Settings::default(),
            point: Point::default(),
            trial: Point::default(),
            multipliers: Vec::new(),
            named: Vec::new(),
            hessian: Hessian::default(),
            riccati: Riccati::default(),
            set: WorkingSet::default(),
            trace: Vec::new(),
            penalty: 0,
            merit_penalty: 0.0,
            shift: 0.0,
            correction: Vec::new(),
            has_correction: false,
            exact: false,
            short: 0,
            nudges: 0,
            relaxations: 0,
            done: None,
        }
    }
}

impl<C: Chain<NX, NU>, const NX: usize, const NU: usize> Sqp<C, NX, NU> {
    /// Begins a run from `controls`, with multipliers for the rows named in
    /// `multipliers` (in the order of their ids) and zero for all others.
    pub fn start(
        &mut self,
        chain: &C,
        controls: &[Control<NU>],
        multipliers: &[(RowId, f64)],
        settings: Settings,
    ) {
        self.settings = settings;
        self.point.controls.clear();
        self.point.controls.extend_from_slice(controls);
        self.named.clear();
        self.named.extend_from_slice(multipliers);
        self.trace.clear();
        self.penalty = 0;
        self.merit_penalty = 0.0;
        self.shift = 0.0;
        self.exact = false;
        self.short = 0;
        self.nudges = 0;
        self.relaxations = 0;
        self.done = None;
        self.point.evaluate(chain);
        if !self.point.cost.is_finite() {
            self.done = Some(Outcome::OutsideDomain);
        }
        self.recall_multipliers();
    }

    /// Steps until done.
    pub fn run(&mut self, chain: &C) -> Outcome {
        loop {
            if let Progress::Done(outcome) = self.step(chain) {
                return outcome;
            }
        }
    }

    /// One iteration.
    pub fn step(&mut self, chain: &C) -> Progress {
        if let Some(outcome) = self.done {
            return Progress::Done(outcome);
        }
        let scale = chain.row_scale();
        let cost_scale = self.cost_scale(chain);
        let stationarity = self.stationarity();
        let violation = self.point.worst_violation(&self.multipliers);
        let active = self.multipliers.iter().filter(|m| **m > 0.0).count();
        self.trace.push(Iteration {
            cost: self.point.cost,
            stationarity,
            violation,
            active,
            step: 0.0,
            shift: 0.0,
        });
        // λ ∇g summed along the chain is rounded like its largest terms.
        let largest = self.multipliers.iter().fold(0.0_f64, |a, b| a.max(*b)) * scale;
        let allowed = self.settings.stationarity * cost_scale + FORCE_ROUNDING * largest;
        let stationary =
            stationarity <= allowed || stationarity <= LEFT_SETTLED * allowed && self.has_settled();
        let feasible = violation <= self.settings.feasibility * scale;
        let complementary = self.complementary(scale);
        if stationary && complementary && (feasible || self.saturated(chain)) {
            return self.end_at_stationary(chain, feasible);
        }
        if self.trace.len() > self.settings.iterations {
            // Above the first penalty the run has been at a point where the
            // violation was stationary, and found no way out since.
            return self.end(if self.penalty > 0 && !feasible {
                Outcome::Infeasible
            } else {
                Outcome::IterationLimit
            });
        }
        let stiffness = self.factor(chain);
        let terms = Terms {
            penalty: self.penalty(chain),
            tolerance: 0.1 * self.settings.feasibility * scale,
            stiffness,
        };
        self.set
            .solve(&mut self.riccati, &self.point, &self.multipliers, terms);
        self.search(chain)
    }

    /// The tolerances and limits of the run.
    pub fn settings(&self) -> Settings {
        self.settings
    }

    /// The point reached.
    pub fn point(&self) -> &Point<C, NX, NU> {
        &self.point
    }

    /// λ, one a row of the point, ≥ 0; those of summed rows last.
    pub fn multipliers(&self) -> &[f64] {
        &self.multipliers
    }

    /// One entry an iteration, the last for the point reached.
    pub fn trace(&self) -> &[Iteration] {
        &self.trace
    }

    fn end(&mut self, outcome: Outcome) -> Progress {
        self.done = Some(outcome);
        Progress::Done(outcome)
    }

    fn penalty(&self, chain: &C) -> f64 {
        PENALTIES[self.penalty] * chain.multiplier_scale() / chain.row_scale()
    }

    /// The greatest entry of the cost's gradient, at least the chain's least.
    fn cost_scale(&self, chain: &C) -> f64 {
        let entries = self.point.stages.iter().map(|s| s.cost_gradient.amax());
        entries.fold(chain.least_gradient(), f64::max)
    }

    fn stationarity(&mut self) -> f64 {
        let gradient = self.hessian.gradient(&self.point, &self.multipliers);
        gradient.iter().map(|g| g.amax()).fold(0.0, greatest)
    }

    /// Whether the last two steps, both of the exact Hessian, led nowhere.
    fn has_settled(&self) -> bool {
        let [.., first, second, _] = self.trace[..] else {
            return false;
        };
        [first, second]
            .iter()
            .all(|it| it.shift == 0.0 && it.step <= SETTLED)
    }

    /// Whether every row with a multiplier is met as an equality. Rows that
    /// cannot be met (λ = ν) are below zero and judged as violations.
    fn complementary(&self, scale: f64) -> bool {
        let tolerance = self.settings.feasibility * scale;
        let pairs = self.point.rows.iter().zip(&self.multipliers);
        let met = pairs
            .filter(|(_, multiplier)| **multiplier > 0.0)
            .all(|(row, _)| row.value <= tolerance);
        if !C::SUM_ROWS {
            return met;
        }
        let summed = &self.multipliers[self.point.rows.len()..];
        let mut pressed = self.point.sums.iter().zip(summed);
        let slack = |(sum, multiplier): (&Sum<NU>, &f64)| {
            *multiplier > 0.0 && sum.violation(*multiplier) < -tolerance
        };
        met && !pressed.any(slack)
    }

    /// Whether some multiplier is at its bound, so that its row gives way.
    fn saturated(&self, chain: &C) -> bool {
        let bound = self.penalty(chain);
        self.multipliers
            .iter()
            .any(|m| *m > 0.0 && !held(*m, bound))
    }

    /// First-order conditions hold: decides what the point is.
    fn end_at_stationary(&mut self, chain: &C, feasible: bool) -> Progress {
        if !self.exact {
            self.hessian.assemble(chain, &self.point, &self.multipliers);
            if let (_, Err(NotPositive { stage })) = self.factor_exact(chain) {
                if self.nudges < NUDGES {
                    self.nudges += 1;
                    self.nudge(chain, stage);
                    return Progress::Running;
                }
                if feasible {
                    return self.end(Outcome::Saddle);
                }
            }
        }
        if feasible {
            return self.end(Outcome::Converged);
        }
        if self.penalty + 1 < PENALTIES.len() {
            self.penalty += 1;
            self.exact = false;
            return Progress::Running;
        }
        self.end(Outcome::Infeasible)
    }

    /// Notes the multipliers of the point's rows by name.
    fn name_multipliers(&mut self) {
        self.named.clear();
        let rows = self.multipliers.iter().enumerate();
        let point = &self.point;
        self.named.extend(
            rows.filter(|(_, multiplier)| **multiplier > 0.0)
                .map(|(row, &multiplier)| (point.row_id(row), multiplier)),
        );
    }

    /// Gives the point's rows the multipliers noted for their names.
    fn recall_multipliers(&mut self) {
        self.multipliers.clear();
        let mut named = self.named.iter().peekable();
        for row in 0..self.point.row_count() {
            let row = self.point.row_id(row);
            while named.next_if(|(id, _)| *id < row).is_some() {}
            let multiplier = named.next_if(|(id, _)| *id == row).map_or(0.0, |n| n.1);
            self.multipliers.push(multiplier);
        }
    }
}

/// Whether a row with this multiplier is met as an equality: it presses, and
/// does not give way at the penalty.
pub(super) fn held(multiplier: f64, penalty: f64) -> bool {
    multiplier > 0.0 && multiplier < penalty * (1.0 - 1e-9)
}

/// The greatest entry of a step.
fn longest<const NU: usize>(du: &[Control<NU>]) -> f64 {
    du.iter().map(|d| d.amax()).fold(0.0, f64::max)
}
