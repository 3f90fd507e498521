//! A chain that states its derivatives in other charts of its nodes: the same
//! nodes, values and rows, and other perturbations of the states.

use nalgebra::SMatrix;
use sinew::solver::{Chain, Control, DynamicsCurvature, Row, RowCurvature, Stage, State, SumRow};

/// In which charts a row's second derivative is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RowsIn {
    /// Those of all the rest.
    TheSame,
    /// Others that touch them: the first derivatives are the same there.
    Tangent,
}

/// The chain in other charts.
#[derive(Debug)]
pub struct Recharted<'a, C> {
    pub chain: &'a C,
    pub rows_in: RowsIn,
}

/// The old perturbation δ = `turn` ε + ½ (`along`·ε)² `to` of a new one ε.
struct Chart<const NX: usize> {
    turn: SMatrix<f64, NX, NX>,
    along: State<NX>,
    to: State<NX>,
}

impl<const NX: usize> Chart<NX> {
    /// The chart at node k.
    fn at(k: usize) -> Self {
        let some = |i: usize, j: usize| (2.3 * k as f64 + 1.7 * i as f64 + 0.9 * j as f64).sin();
        Self {
            turn: SMatrix::from_fn(|i, j| f64::from(u8::from(i == j)) + 0.2 * some(i, j)),
            along: State::from_fn(|i, _| some(i, 5)),
            to: State::from_fn(|i, _| some(i, 9)),
        }
    }

    fn back(&self) -> SMatrix<f64, NX, NX> {
        self.turn.try_inverse().unwrap()
    }

    /// A second derivative in this chart, from that in the old one and the
    /// first.
    fn curvature(&self, old: SMatrix<f64, NX, NX>, gradient: &State<NX>) -> SMatrix<f64, NX, NX> {
        self.turn.tr_mul(&old) * self.turn
            + gradient.dot(&self.to) * self.along * self.along.transpose()
    }
}

/// What a stage keeps.
#[derive(Clone, Debug)]
pub struct Kept<B, const NX: usize, const NU: usize> {
    k: usize,
    bend: B,
    by_state: SMatrix<f64, NX, NX>,
    by_control: SMatrix<f64, NX, NU>,
    cost_by_state: State<NX>,
}

impl<C: Chain<NX, NU>, const NX: usize, const NU: usize> Chain<NX, NU> for Recharted<'_, C> {
    const COST_OF_STATE: bool = C::COST_OF_STATE;
    const SUM_ROWS: bool = C::SUM_ROWS;

    type Node = C::Node;
    type Kept = Kept<C::Kept, NX, NU>;

    fn stages(&self) -> usize {
        self.chain.stages()
    }

    fn base(&self) -> C::Node {
        self.chain.base()
    }

    fn row_scale(&self) -> f64 {
        self.chain.row_scale()
    }

    fn longest_step(&self) -> f64 {
        self.chain.longest_step()
    }

    fn stage(
        &self,
        k: usize,
        from: &C::Node,
        control: &Control<NU>,
    ) -> (C::Node, Stage<NX, NU>, Self::Kept) {
        let (node, mut stage, bend) = self.chain.stage(k, from, control);
        let kept = Kept {
            k,
            bend,
            by_state: stage.by_state,
            by_control: stage.by_control,
            cost_by_state: stage.cost_by_state,
        };
        let (before, back) = (Chart::at(k - 1), Chart::at(k).back());
        stage.by_state = back * stage.by_state * before.turn;
        stage.by_control = back * stage.by_control;
        stage.cost_by_state = before.turn.tr_mul(&stage.cost_by_state);
        (node, stage, kept)
    }

    fn dynamics_curvature(
        &self,
        kept: &Self::Kept,
        adjoint: &State<NX>,
    ) -> DynamicsCurvature<NX, NU> {
        let (before, after) = (Chart::<NX>::at(kept.k - 1), Chart::<NX>::at(kept.k));
        let back = after.back();
        let adjoint = back.tr_mul(adjoint);
        let old = self.chain.dynamics_curvature(&kept.bend, &adjoint);
        // The way back from δ to ε is curved as well: −½ (along·ε)² to.
        let size = adjoint.dot(&after.to);
        let by_state = (back * kept.by_state * before.turn).tr_mul(&after.along);
        let by_control = (back * kept.by_control).tr_mul(&after.along);
        // The cost's slope in the state too curves with the chart.
        let mut gradient = kept.by_state.tr_mul(&adjoint);
        if C::COST_OF_STATE {
            gradient += kept.cost_by_state;
        }
        DynamicsCurvature {
            by_state: before.curvature(old.by_state, &gradient)
                - size * by_state * by_state.transpose(),
            mixed: before.turn.tr_mul(&old.mixed) - size * by_state * by_control.transpose(),
            by_control: old.by_control - size * by_control * by_control.transpose(),
        }
    }

    fn rows(&self, nodes: &[C::Node], controls: &[Control<NU>], rows: &mut Vec<Row<NX, NU>>) {
        self.chain.rows(nodes, controls, rows);
        for row in rows {
            row.after = Chart::<NX>::at(row.stage).turn.tr_mul(&row.after);
            let before = Chart::<NX>::at(row.stage - 1);
            row.before = row.before.map(|old| before.turn.tr_mul(&old));
        }
    }

    fn row_curvature(&self, row: &Row<NX, NU>, nodes: &[C::Node]) -> RowCurvature<NX, NU> {
        let (mut before, mut after) = (Chart::<NX>::at(row.stage - 1), Chart::<NX>::at(row.stage));
        let mut old = *row;
        old.after = after.back().tr_mul(&row.after);
        old.before = row.before.map(|new| before.back().tr_mul(&new));
        if self.rows_in == RowsIn::Tangent {
            before.to = State::zeros();
            after.to = State::zeros();
        }
        match self.chain.row_curvature(&old, nodes) {
            RowCurvature::States {
                after: own,
                before: parts,
            } => RowCurvature::States {
                after: after.curvature(own, &old.after),
                before: old.before.zip(parts).map(|(gradient, (own, across))| {
                    let across = before.turn.tr_mul(&across) * after.turn;
                    (before.curvature(own, &gradient), across)
                }),
            },
            RowCurvature::Inside(inside) => RowCurvature::Inside(DynamicsCurvature {
                by_state: before.curvature(inside.by_state, &old.before.unwrap()),
                mixed: before.turn.tr_mul(&inside.mixed),
                by_control: inside.by_control,
            }),
        }
    }

    fn sum_count(&self) -> usize {
        self.chain.sum_count()
    }

    fn sum_row(&self, sum: usize) -> SumRow {
        self.chain.sum_row(sum)
    }

    fn sum_term(&self, sum: usize, k: usize, kept: &Self::Kept) -> (f64, Control<NU>) {
        self.chain.sum_term(sum, k, &kept.bend)
    }

    fn sum_curvature(&self, sum: usize, k: usize, kept: &Self::Kept) -> SMatrix<f64, NU, NU> {
        self.chain.sum_curvature(sum, k, &kept.bend)
    }

    fn passes_through(&self, from: &[C::Node], to: &[C::Node]) -> bool {
        self.chain.passes_through(from, to)
    }
}
