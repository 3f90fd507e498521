//! The solver on problems of two controls, whose every number can be told by
//! hand: how each run ends, what its trace says, and that curved rows, rows
//! that cannot be met and saddles are dealt with as they should.

use nalgebra::{SMatrix, Vector2, vector};
use sinew::solver::{
    Chain, Control, DynamicsCurvature, Iteration, Outcome, Progress, Row, RowCurvature, RowId,
    Settings, Sqp, Stage, State, Tunnelling,
};

/// Value, gradient and second derivative of one row at (x, y).
type Curved = (f64, Vector2<f64>, SMatrix<f64, 2, 2>);

/// Minimise `costs`[0](x) + `costs`[1](y) under rows of both.
struct Plane {
    /// Value and two derivatives.
    costs: [fn(f64) -> [f64; 3]; 2],
    rows: Vec<fn(Vector2<f64>) -> Curved>,
    /// Motions longer than this lead through something.
    longest_motion: f64,
    scale: f64,
}

impl Plane {
    fn new(costs: [fn(f64) -> [f64; 3]; 2], rows: Vec<fn(Vector2<f64>) -> Curved>) -> Self {
        Self {
            costs,
            rows,
            longest_motion: f64::INFINITY,
            scale: 1.0,
        }
    }
}

impl Chain<2, 1> for Plane {
    type Node = Vector2<f64>;
    type Kept = ();

    fn stages(&self) -> usize {
        2
    }

    fn base(&self) -> Vector2<f64> {
        Vector2::zeros()
    }

    fn row_scale(&self) -> f64 {
        self.scale
    }

    fn longest_step(&self) -> f64 {
        2.0
    }

    fn stage(
        &self,
        k: usize,
        from: &Vector2<f64>,
        control: &Control<1>,
    ) -> (Vector2<f64>, Stage<2, 1>, ()) {
        let axis = Vector2::ith(k - 1, 1.0);
        let [cost, slope, curvature] = self.costs[k - 1](control[0]);
        let stage = Stage {
            by_state: SMatrix::identity(),
            by_control: axis,
            cost,
            cost_by_state: State::zeros(),
            cost_gradient: vector![slope],
            cost_curvature: SMatrix::from_element(curvature),
        };
        (from + control[0] * axis, stage, ())
    }

    fn dynamics_curvature(&self, (): &(), _: &State<2>) -> DynamicsCurvature<2, 1> {
        DynamicsCurvature {
            by_state: SMatrix::zeros(),
            mixed: SMatrix::zeros(),
            by_control: SMatrix::zeros(),
        }
    }

    fn rows(&self, nodes: &[Vector2<f64>], _: &[Control<1>], rows: &mut Vec<Row<2, 1>>) {
        rows.clear();
        for (index, row) in self.rows.iter().enumerate() {
            let (value, gradient, _) = row(nodes[2]);
            rows.push(Row {
                id: RowId(index as u64),
                stage: 2,
                value: self.scale * value,
                before: None,
                after: self.scale * gradient,
                control: Control::zeros(),
            });
        }
    }

    fn row_curvature(&self, row: &Row<2, 1>, nodes: &[Vector2<f64>]) -> RowCurvature<2, 1> {
        RowCurvature::States {
            after: self.scale * self.rows[row.id.0 as usize](nodes[2]).2,
            before: None,
        }
    }

    fn passes_through(&self, from: &[Vector2<f64>], to: &[Vector2<f64>]) -> bool {
        (to[2] - from[2]).norm() > self.longest_motion
    }
}

fn bowl(x: f64) -> [f64; 3] {
    [x * x, 2.0 * x, 2.0]
}

/// Least at 1.
fn off_centre(x: f64) -> [f64; 3] {
    bowl(x - 1.0)
}

/// Stationary at 0 and ±1.
fn two_wells(x: f64) -> [f64; 3] {
    [
        (x * x - 1.0).powi(2),
        4.0 * x * (x * x - 1.0),
        12.0 * x * x - 4.0,
    ]
}

/// A bowl that says it is a hill: of a slope that makes the step right once it
/// is shifted, by 1e-7 times a power of four.
fn feigned(x: f64) -> [f64; 3] {
    [x * x, 2.0 * x, 2.0 - 1e-7 * 4f64.powi(13)]
}

/// x + y ≤ 1.
fn below(at: Vector2<f64>) -> Curved {
    (1.0 - at.x - at.y, vector![-1.0, -1.0], SMatrix::zeros())
}

/// x + y ≥ 2.
fn above(at: Vector2<f64>) -> Curved {
    (at.x + at.y - 2.0, vector![1.0, 1.0], SMatrix::zeros())
}

/// Outside the circle of radius 1.
fn outside(at: Vector2<f64>) -> Curved {
    (at.norm_squared() - 1.0, 2.0 * at, 2.0 * SMatrix::identity())
}

fn started(
    chain: &Plane,
    from: [f64; 2],
    multipliers: &[(RowId, f64)],
    settings: Settings,
) -> Sqp<Plane, 2, 1> {
    let mut sqp = Sqp::default();
    let controls = from.map(Control::<1>::from_element);
    sqp.start(chain, &controls, multipliers, settings);
    sqp
}

fn run(chain: &Plane, from: [f64; 2]) -> (Sqp<Plane, 2, 1>, Outcome) {
    let mut sqp = started(chain, from, &[], Settings::default());
    let outcome = sqp.run(chain);
    assert_eq!(sqp.step(chain), Progress::Done(outcome));
    (sqp, outcome)
}

fn check_at(sqp: &Sqp<Plane, 2, 1>, expected: [f64; 2]) {
    for (control, expected) in sqp.point().controls.iter().zip(expected) {
        assert!(
            (control[0] - expected).abs() < 1e-9,
            "{:?}",
            sqp.point().controls
        );
    }
}

#[test]
fn a_quadratic_takes_one_step_of_its_length() {
    let chain = Plane::new([off_centre, bowl], vec![]);
    let (sqp, outcome) = run(&chain, [0.5, -0.25]);
    assert_eq!(outcome, Outcome::Converged);
    check_at(&sqp, [1.0, 0.0]);
    let [first, last] = sqp.trace() else {
        panic!("{:?}", sqp.trace())
    };
    assert_eq!((first.cost, first.stationarity), (0.3125, 1.0));
    assert_eq!((first.step, first.shift, first.active), (0.5, 0.0, 0));
    assert_eq!((last.cost, last.stationarity, last.step), (0.0, 0.0, 0.0));
}

#[test]
fn no_step_is_longer_than_the_chain_allows() {
    let chain = Plane::new([off_centre, bowl], vec![]);
    let (sqp, outcome) = run(&chain, [6.0, 0.0]);
    assert_eq!(outcome, Outcome::Converged);
    let steps: Vec<f64> = sqp.trace().iter().map(|i| i.step).collect();
    assert_eq!(steps, [2.0, 2.0, 1.0, 0.0]);
}

/// Σ(u − 1)² with x + y ≤ 1: both at ½, λ = 1, whatever the rows' unit.
#[test]
fn a_row_that_presses_has_its_multiplier() {
    for scale in [1.0, 1e-3, 1e3] {
        let mut chain = Plane::new([off_centre, off_centre], vec![below]);
        chain.scale = scale;
        let (sqp, outcome) = run(&chain, [0.0, 0.2]);
        assert_eq!(outcome, Outcome::Converged);
        check_at(&sqp, [0.5, 0.5]);
        assert!((sqp.multipliers()[0] * scale - 1.0).abs() < 1e-9);
        let last = sqp.trace().last().unwrap();
        assert_eq!(
            (last.active, sqp.trace().len()),
            (1, 2),
            "{:?}",
            sqp.trace()
        );
        // It is its own start.
        let named = [(RowId(0), sqp.multipliers()[0])];
        let mut again = started(&chain, [0.5, 0.5], &named, Settings::default());
        assert_eq!(again.run(&chain), Outcome::Converged);
        assert_eq!(again.trace().len(), 1);
        // A row that is met and could press, but does not.
        let (sqp, _) = run(&Plane::new([bowl, bowl], vec![below]), [0.5, 0.5]);
        assert_eq!(sqp.multipliers(), [0.0]);
        check_at(&sqp, [0.0, 0.0]);
    }
}

/// Maratos's example: min 2(x² + y²) − x outside the unit circle. On it every
/// full Newton step raises the cost; corrected to second order it is taken.
#[test]
fn a_curved_row_does_not_shorten_the_steps() {
    fn along(x: f64) -> [f64; 3] {
        [2.0 * x * x - x, 4.0 * x - 1.0, 4.0]
    }
    fn across(y: f64) -> [f64; 3] {
        [2.0 * y * y, 4.0 * y, 4.0]
    }
    let chain = Plane::new([along, across], vec![outside]);
    for angle in [0.3_f64, -0.6, 0.9] {
        let (sine, cosine) = angle.sin_cos();
        let named = [(RowId(0), 1.5)];
        let mut sqp = started(&chain, [cosine, sine], &named, Settings::default());
        assert_eq!(sqp.run(&chain), Outcome::Converged);
        check_at(&sqp, [1.0, 0.0]);
        assert!((sqp.multipliers()[0] - 1.5).abs() < 1e-9);
        // The Newton step is (sin², −sin cos).
        let first = sine.abs() * sine.abs().max(cosine.abs());
        let step = sqp.trace()[0].step;
        assert!((step - first).abs() < 1e-9, "{angle}: {step} of {first}");
        assert!(sqp.trace().len() <= 7, "{:?}", sqp.trace());
    }
}

/// Between x + y ≤ 1 and ≥ 2 the violation is the same everywhere: the cost
/// decides, and both multipliers are at the greatest penalty.
#[test]
fn rows_that_cannot_be_met_together_give_way_alike() {
    let (sqp, outcome) = run(&Plane::new([bowl, bowl], vec![below, above]), [0.0, 0.0]);
    assert_eq!(outcome, Outcome::Infeasible);
    let sum = sqp.point().controls[0][0] + sqp.point().controls[1][0];
    assert!((1.0 - 1e-9..=2.0 + 1e-9).contains(&sum), "{sum}");
    let most = sqp.multipliers().iter().fold(0.0_f64, |a, b| a.max(*b));
    assert!((most - 1e6).abs() < 1.0, "{:?}", sqp.multipliers());
    assert!((sqp.point().total_violation() - 1.0).abs() < 1e-9);
    let last = sqp.trace().last().unwrap();
    assert!((last.violation - sqp.point().worst_violation(sqp.multipliers())).abs() < 1e-15);
}

/// A multiplier above the first penalty and below the second.
#[test]
fn a_row_may_press_harder_than_the_first_penalty() {
    fn steep(x: f64) -> [f64; 3] {
        [1e5 * (x - 1.0).powi(2), 2e5 * (x - 1.0), 2e5]
    }
    let (sqp, outcome) = run(&Plane::new([steep, steep], vec![below]), [0.0, 0.0]);
    assert_eq!(outcome, Outcome::Converged);
    check_at(&sqp, [0.5, 0.5]);
    assert!((sqp.multipliers()[0] - 1e5).abs() < 1e-3);
}

#[test]
fn a_run_out_of_iterations_says_so() {
    let chain = Plane::new([two_wells, bowl], vec![]);
    for iterations in [0, 1, 3] {
        let settings = Settings {
            iterations,
            ..Settings::default()
        };
        let mut sqp = started(&chain, [9.0, 9.0], &[], settings);
        assert_eq!(sqp.run(&chain), Outcome::IterationLimit);
        assert_eq!(sqp.trace().len(), iterations + 1);
    }
}

#[test]
fn a_start_outside_the_domain_is_told() {
    fn root(x: f64) -> [f64; 3] {
        [x.sqrt(), 0.5 / x.sqrt(), 1.0]
    }
    let (sqp, outcome) = run(&Plane::new([root, bowl], vec![]), [-1.0, 0.0]);
    assert_eq!(outcome, Outcome::OutsideDomain);
    assert!(sqp.trace().is_empty());
}

/// From the top between two wells into one of them; where
/// there is no way down it is called a saddle.
#[test]
fn saddles_are_left_or_told() {
    let (sqp, outcome) = run(&Plane::new([two_wells, bowl], vec![]), [0.0, 0.0]);
    assert_eq!(outcome, Outcome::Converged);
    let x = sqp.point().controls[0][0];
    assert!((x.abs() - 1.0).abs() < 1e-9);
    // On the side that slopes down a little more.
    fn tilted(x: f64) -> [f64; 3] {
        let [cost, slope, curvature] = two_wells(x);
        [
            cost - 0.01 * x.powi(3),
            slope - 0.03 * x * x,
            curvature - 0.06 * x,
        ]
    }
    let (sqp, outcome) = run(&Plane::new([tilted, bowl], vec![]), [0.0, 0.0]);
    assert_eq!(outcome, Outcome::Converged);
    assert!(sqp.point().controls[0][0] > 0.9);
    let first = &sqp.trace()[1];
    assert!((first.cost - tilted(0.02)[0]).abs() < 1e-12, "{first:?}");
    let (sqp, outcome) = run(&Plane::new([feigned, bowl], vec![]), [0.0, 0.0]);
    assert_eq!(outcome, Outcome::Saddle);
    // It was left four times.
    let left = |i: &&Iteration| i.stationarity == 0.04;
    assert_eq!(sqp.trace().iter().filter(left).count(), 4);
}

/// Where the cost curves down it is shifted until it does not; with a row that
/// holds it, it is not.
#[test]
fn only_what_no_row_holds_is_shifted() {
    let (sqp, outcome) = run(&Plane::new([two_wells, bowl], vec![]), [0.4, 0.0]);
    assert_eq!(outcome, Outcome::Converged);
    let first = &sqp.trace()[0];
    // Twelve x² − 4 is −2.08; the shift rises by fours.
    assert!(first.shift > 2.08 && first.shift < 4.0 * 2.08, "{first:?}");
    assert_eq!(sqp.trace().last().unwrap().shift, 0.0);
    fn hill(x: f64) -> [f64; 3] {
        [-x * x, -2.0 * x, -2.0]
    }
    fn left(at: Vector2<f64>) -> Curved {
        (1.0 - at.x, vector![-1.0, 0.0], SMatrix::zeros())
    }
    let chain = Plane::new([hill, off_centre], vec![left]);
    let named = [(RowId(0), 1.0)];
    let mut sqp = started(&chain, [0.7, 0.0], &named, Settings::default());
    assert_eq!(sqp.run(&chain), Outcome::Converged);
    check_at(&sqp, [1.0, 1.0]);
    assert!((sqp.multipliers()[0] - 2.0).abs() < 1e-9);
    assert!(
        sqp.trace().iter().all(|i| i.shift == 0.0),
        "{:?}",
        sqp.trace()
    );
    assert_eq!(sqp.trace().len(), 2);
}

#[test]
fn what_leads_through_something_is_blocked_unless_allowed() {
    let mut chain = Plane::new([off_centre, bowl], vec![]);
    chain.longest_motion = 0.0;
    let (sqp, outcome) = run(&chain, [0.0, 0.0]);
    assert_eq!(outcome, Outcome::Blocked);
    check_at(&sqp, [0.0, 0.0]);
    let settings = Settings {
        tunnelling: Tunnelling::Allowed,
        ..Settings::default()
    };
    let mut sqp = started(&chain, [0.0, 0.0], &[], settings);
    assert_eq!(sqp.run(&chain), Outcome::Converged);
}

/// Steps are halved until they lead through nothing, and until the cost falls.
#[test]
fn steps_are_halved_until_they_may_be_taken() {
    let mut chain = Plane::new([off_centre, bowl], vec![]);
    chain.longest_motion = 0.3;
    let (sqp, outcome) = run(&chain, [0.0, 0.0]);
    assert_eq!(outcome, Outcome::Converged);
    let steps: Vec<f64> = sqp.trace().iter().map(|i| i.step).collect();
    assert_eq!(steps[0], 0.25);
    check_at(&sqp, [1.0, 0.0]);
    // From 0.6 to 2.6 and 1.6 the cost of two wells rises, to 1.1 it falls.
    let wells = Plane::new([two_wells, bowl], vec![]);
    let (sqp, _) = run(&wells, [0.6, 0.0]);
    assert!(
        (sqp.trace()[0].step - 0.5).abs() < 1e-12,
        "{:?}",
        sqp.trace()
    );
    // The Newton step from 0.75 is too long by as much again.
    let (sqp, _) = run(&wells, [0.75, 0.0]);
    let [_, slope, curvature] = two_wells(0.75);
    let half = -0.5 * slope / curvature;
    assert!(
        (sqp.trace()[0].step - half).abs() < 1e-12,
        "{:?}",
        sqp.trace()
    );
    check_at(&sqp, [1.0, 0.0]);
}

/// Forces that balance do not make an equilibrium where a row presses from
/// afar.
#[test]
fn a_row_that_is_not_met_does_not_press() {
    fn open(at: Vector2<f64>) -> Curved {
        (at.x + at.y + 0.1, vector![1.0, 1.0], SMatrix::zeros())
    }
    for scale in [1.0, 1e-3] {
        let mut chain = Plane::new([bowl, bowl], vec![open]);
        chain.scale = scale;
        let named = [(RowId(0), 0.5 / scale)];
        let mut sqp = started(&chain, [0.25, 0.25], &named, Settings::default());
        assert_eq!(sqp.run(&chain), Outcome::Converged);
        assert_eq!(sqp.trace()[0].stationarity, 0.0);
        check_at(&sqp, [0.0, 0.0]);
        assert_eq!(sqp.multipliers(), [0.0]);
    }
}

/// A gradient that lies leads nowhere.
#[test]
fn a_cost_that_no_step_lowers_stalls() {
    fn lying(x: f64) -> [f64; 3] {
        [1e6 * x * x, -2e6 * x, 2e6]
    }
    let (_, outcome) = run(&Plane::new([lying, bowl], vec![]), [0.1, 0.0]);
    assert_eq!(outcome, Outcome::Stalled);
}
