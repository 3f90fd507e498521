//! A chain of any dimensions that stands for nothing: every stage has numbers
//! of its own that look like no others, so that no two terms can be taken for
//! each other, and every derivative that the solver may ask for is there.

use nalgebra::{SMatrix, SVector};
use sinew::solver::{
    Chain, Control, DynamicsCurvature, Row, RowCurvature, RowId, Stage, State, SumRow,
};

/// The chain.
#[derive(Clone, Debug)]
pub struct MadeUp<const NX: usize, const NU: usize> {
    /// n.
    pub stages: usize,
}

/// Rows farther than this from their bound are left out.
const REACH: f64 = 1.5;

/// A number between −0.5 and 0.5 that looks like no other.
fn some(a: usize, b: usize, c: usize) -> f64 {
    0.5 * (17.3 * a as f64 + 5.9 * b as f64 + 3.1 * c as f64).sin()
}

fn vector<const N: usize>(a: usize, b: usize) -> SVector<f64, N> {
    SVector::from_fn(|i, _| some(a, b, i))
}

fn matrix<const N: usize, const M: usize>(a: usize, b: usize) -> SMatrix<f64, N, M> {
    SMatrix::from_fn(|i, j| some(a, b + i, 7 * j))
}

/// A direction in a stage's state and control, along which it waves, and where
/// to: F has a term `to` · sin(`state`·z + `control`·u + 0.3).
struct Wave<const NX: usize, const NU: usize> {
    state: State<NX>,
    control: Control<NU>,
    to: State<NX>,
}

impl<const NX: usize, const NU: usize> Wave<NX, NU> {
    fn phase(&self, state: &State<NX>, control: &Control<NU>) -> f64 {
        self.state.dot(state) + self.control.dot(control) + 0.3
    }
}

/// What a stage keeps: the stage, the sines of its waves and of its weight, and the
/// control for the summed rows.
#[derive(Clone, Debug)]
pub struct Kept<const NU: usize> {
    k: usize,
    sines: [f64; 2],
    weight: f64,
    control: Control<NU>,
}

/// A row: `free` + `before`·z_{k−1} + `after`·z_k + `control`·u_k
/// + 0.6 sin(2 `before`·z_{k−1} + 3 `after`·z_k), one of one node without `before`.
struct Bound<const NX: usize, const NU: usize> {
    stage: usize,
    free: f64,
    before: Option<State<NX>>,
    after: State<NX>,
    control: Control<NU>,
}

impl<const NX: usize, const NU: usize> MadeUp<NX, NU> {
    /// What rows inside a stage have to spare: so little that some press, where there
    /// are states enough to meet them all.
    const ROOM: f64 = if NX > 2 { -0.2 } else { 0.4 };

    /// Controls that lead nowhere in particular.
    pub fn controls(&self) -> Vec<Control<NU>> {
        (1..=self.stages).map(|k| 0.6 * vector(k, 90)).collect()
    }

    fn waves(k: usize) -> [Wave<NX, NU>; 2] {
        [10, 20].map(|j| Wave {
            state: vector(k, j),
            control: vector(k, j + 3),
            to: vector(k, j + 6),
        })
    }

    /// The part of a stage's cost that depends on the state: a sine along this.
    fn weight(k: usize) -> Wave<NX, NU> {
        Wave {
            state: 0.5 * vector(k, 12),
            control: 0.5 * vector(k, 15),
            to: State::zeros(),
        }
    }

    /// The row inside a stage: a sine along this, and [`Self::ROOM`].
    fn inside(k: usize) -> Wave<NX, NU> {
        Wave {
            state: vector(k, 22),
            control: vector(k, 25),
            to: State::zeros(),
        }
    }

    /// A summed row's term: `0`·u + 0.2 sin(`1`·u).
    fn term(sum: usize, k: usize) -> (Control<NU>, Control<NU>) {
        (vector(k, 53 + 9 * sum), vector(k, 57 + 9 * sum))
    }

    /// The row of an id: ten times its stage, and 1 more for the one inside it, 3
    /// for one across two nodes, 8 for one of one node.
    fn bound(id: RowId) -> Bound<NX, NU> {
        let stage = (id.0 / 10) as usize;
        let place = id.0 as usize;
        Bound {
            stage,
            free: 0.2 + some(place, 1, 14),
            before: (id.0 % 10 == 3).then(|| 2.0 * vector(place, 30)),
            after: vector(place, 40),
            control: vector(place, 50),
        }
    }

    /// The argument of a row's sine.
    fn argument(bound: &Bound<NX, NU>, nodes: &[State<NX>]) -> f64 {
        let before = bound.before.map_or(0.0, |a| a.dot(&nodes[bound.stage - 1]));
        2.0 * before + 3.0 * bound.after.dot(&nodes[bound.stage])
    }
}

impl<const NX: usize, const NU: usize> Chain<NX, NU> for MadeUp<NX, NU> {
    const COST_OF_STATE: bool = true;
    const SUM_ROWS: bool = true;

    type Node = State<NX>;
    type Kept = Kept<NU>;

    fn stages(&self) -> usize {
        self.stages
    }

    fn base(&self) -> State<NX> {
        vector(0, 0)
    }

    fn row_scale(&self) -> f64 {
        0.7
    }

    fn longest_step(&self) -> f64 {
        0.5
    }

    fn stage(
        &self,
        k: usize,
        from: &State<NX>,
        control: &Control<NU>,
    ) -> (State<NX>, Stage<NX, NU>, Kept<NU>) {
        let mut by_state = SMatrix::identity() + 0.3 * matrix::<NX, NX>(k, 60);
        let mut by_control = matrix::<NX, NU>(k, 70);
        let mut node = by_state * from + by_control * control;
        let mut sines = [0.0; 2];
        for (wave, sine) in Self::waves(k).iter().zip(&mut sines) {
            let phase = wave.phase(from, control);
            *sine = phase.sin();
            node += *sine * wave.to;
            by_state += phase.cos() * wave.to * wave.state.transpose();
            by_control += phase.cos() * wave.to * wave.control.transpose();
        }
        let half = matrix::<NU, NU>(k, 80);
        let quadratic = SMatrix::identity() + half * half.transpose();
        let linear = vector::<NU>(k, 85);
        let across = vector::<NU>(k, 88);
        let along = across.dot(control);
        let weighed = Self::weight(k);
        let weight = weighed.phase(from, control);
        let stage = Stage {
            by_state,
            by_control,
            cost: 0.5 * control.dot(&(quadratic * control))
                + linear.dot(control)
                + along.cosh()
                + weight.sin(),
            cost_by_state: weight.cos() * weighed.state,
            cost_gradient: quadratic * control
                + linear
                + along.sinh() * across
                + weight.cos() * weighed.control,
            cost_curvature: quadratic + along.cosh() * across * across.transpose()
                - weight.sin() * weighed.control * weighed.control.transpose(),
        };
        let kept = Kept {
            k,
            sines,
            weight: weight.sin(),
            control: *control,
        };
        (node, stage, kept)
    }

    fn dynamics_curvature(
        &self,
        kept: &Kept<NU>,
        adjoint: &State<NX>,
    ) -> DynamicsCurvature<NX, NU> {
        let mut curvature = DynamicsCurvature {
            by_state: SMatrix::zeros(),
            mixed: SMatrix::zeros(),
            by_control: SMatrix::zeros(),
        };
        let weighed = Self::weight(kept.k);
        curvature.by_state -= kept.weight * weighed.state * weighed.state.transpose();
        curvature.mixed -= kept.weight * weighed.state * weighed.control.transpose();
        for (wave, sine) in Self::waves(kept.k).iter().zip(&kept.sines) {
            let size = -sine * adjoint.dot(&wave.to);
            curvature.by_state += size * wave.state * wave.state.transpose();
            curvature.mixed += size * wave.state * wave.control.transpose();
            curvature.by_control += size * wave.control * wave.control.transpose();
        }
        curvature
    }

    fn rows(&self, nodes: &[State<NX>], controls: &[Control<NU>], rows: &mut Vec<Row<NX, NU>>) {
        rows.clear();
        // Stages with none are between those with two.
        for stage in (1..=self.stages).step_by(2) {
            let inside = Self::inside(stage);
            let phase = inside.phase(&nodes[stage - 1], &controls[stage - 1]);
            rows.push(Row {
                id: RowId(10 * stage as u64 + 1),
                stage,
                value: phase.sin() + Self::ROOM,
                before: Some(phase.cos() * inside.state),
                after: State::zeros(),
                control: phase.cos() * inside.control,
            });
            for id in [10 * stage + 3, 10 * stage + 8].map(|id| RowId(id as u64)) {
                let bound = Self::bound(id);
                let argument = Self::argument(&bound, nodes);
                let before = bound.before.map_or(0.0, |a| a.dot(&nodes[stage - 1]));
                let linear = before
                    + bound.after.dot(&nodes[stage])
                    + bound.control.dot(&controls[stage - 1]);
                let value = bound.free + linear + 0.6 * argument.sin();
                if value < REACH {
                    rows.push(Row {
                        id,
                        stage,
                        value,
                        before: bound.before.map(|a| (1.0 + 1.2 * argument.cos()) * a),
                        after: (1.0 + 1.8 * argument.cos()) * bound.after,
                        control: bound.control,
                    });
                }
            }
        }
    }

    fn row_curvature(&self, row: &Row<NX, NU>, nodes: &[State<NX>]) -> RowCurvature<NX, NU> {
        if row.id.0 % 10 == 1 {
            let inside = Self::inside(row.stage);
            let size = Self::ROOM - row.value;
            return RowCurvature::Inside(DynamicsCurvature {
                by_state: size * inside.state * inside.state.transpose(),
                mixed: size * inside.state * inside.control.transpose(),
                by_control: size * inside.control * inside.control.transpose(),
            });
        }
        let bound = Self::bound(row.id);
        let size = -Self::argument(&bound, nodes).sin() * 0.6;
        let after = bound.after;
        RowCurvature::States {
            after: 9.0 * size * after * after.transpose(),
            before: bound.before.map(|before| {
                let own = 4.0 * size * before * before.transpose();
                (own, 6.0 * size * before * after.transpose())
            }),
        }
    }

    fn sum_count(&self) -> usize {
        2
    }

    fn sum_row(&self, sum: usize) -> SumRow {
        SumRow {
            id: RowId(1_000_000 + sum as u64),
            bound: some(sum, 3, 2) - 0.4,
            compliance: 0.3 * sum as f64,
        }
    }

    fn sum_term(&self, sum: usize, k: usize, kept: &Kept<NU>) -> (f64, Control<NU>) {
        let (linear, along) = Self::term(sum, k);
        let phase = along.dot(&kept.control);
        let value = linear.dot(&kept.control) + 0.2 * phase.sin();
        (value, linear + 0.2 * phase.cos() * along)
    }

    fn sum_curvature(&self, sum: usize, k: usize, kept: &Kept<NU>) -> SMatrix<f64, NU, NU> {
        let (_, along) = Self::term(sum, k);
        -0.2 * along.dot(&kept.control).sin() * along * along.transpose()
    }

    fn passes_through(&self, _: &[State<NX>], _: &[State<NX>]) -> bool {
        false
    }
}
