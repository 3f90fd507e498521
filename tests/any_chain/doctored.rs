//! A chain with one of its derivatives wrong.

use nalgebra::SMatrix;
use sinew::solver::{Chain, Control, DynamicsCurvature, Row, RowCurvature, Stage, State, SumRow};

/// What is wrong.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Flaw {
    ByState,
    ByControl,
    CostGradient,
    CostCurvature,
    RowBefore,
    RowAfter,
    RowControl,
    DynamicsByState,
    DynamicsMixed,
    DynamicsByControl,
    CurvatureBefore,
    CurvatureAcross,
    CurvatureAfter,
    CostByState,
    InsideByState,
    InsideMixed,
    InsideByControl,
    SumGradient,
    SumCurvature,
}

impl Flaw {
    /// Those of a chain without summed rows, rows inside a stage and costs of the
    /// state.
    pub const OF_STATES: [Self; 13] = {
        let [a, b, c, d, e, f, g, h, i, j, k, l, m, ..] = Self::ALL;
        [a, b, c, d, e, f, g, h, i, j, k, l, m]
    };
    pub const ALL: [Self; 19] = [
        Self::ByState,
        Self::ByControl,
        Self::CostGradient,
        Self::CostCurvature,
        Self::RowBefore,
        Self::RowAfter,
        Self::RowControl,
        Self::DynamicsByState,
        Self::DynamicsMixed,
        Self::DynamicsByControl,
        Self::CurvatureBefore,
        Self::CurvatureAcross,
        Self::CurvatureAfter,
        Self::CostByState,
        Self::InsideByState,
        Self::InsideMixed,
        Self::InsideByControl,
        Self::SumGradient,
        Self::SumCurvature,
    ];
}

/// By how much it is wrong: a hundredth.
const WRONG: f64 = 1.01;

/// The chain with its flaw.
#[derive(Debug)]
pub struct Doctored<'a, C> {
    pub chain: &'a C,
    pub flaw: Flaw,
}

impl<C: Chain<NX, NU>, const NX: usize, const NU: usize> Chain<NX, NU> for Doctored<'_, C> {
    const COST_OF_STATE: bool = C::COST_OF_STATE;
    const SUM_ROWS: bool = C::SUM_ROWS;

    type Node = C::Node;
    type Kept = C::Kept;

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
    ) -> (C::Node, Stage<NX, NU>, C::Kept) {
        let (node, mut stage, bend) = self.chain.stage(k, from, control);
        match self.flaw {
            Flaw::ByState => stage.by_state *= WRONG,
            Flaw::ByControl => stage.by_control *= WRONG,
            Flaw::CostGradient => stage.cost_gradient *= WRONG,
            Flaw::CostByState => stage.cost_by_state *= WRONG,
            Flaw::CostCurvature => stage.cost_curvature *= WRONG,
            _ => {}
        }
        (node, stage, bend)
    }

    fn dynamics_curvature(&self, bend: &C::Kept, adjoint: &State<NX>) -> DynamicsCurvature<NX, NU> {
        let mut curvature = self.chain.dynamics_curvature(bend, adjoint);
        match self.flaw {
            Flaw::DynamicsByState => curvature.by_state *= WRONG,
            Flaw::DynamicsMixed => curvature.mixed *= WRONG,
            Flaw::DynamicsByControl => curvature.by_control *= WRONG,
            _ => {}
        }
        curvature
    }

    fn rows(&self, nodes: &[C::Node], controls: &[Control<NU>], rows: &mut Vec<Row<NX, NU>>) {
        self.chain.rows(nodes, controls, rows);
        for row in rows {
            match self.flaw {
                Flaw::RowBefore => row.before = row.before.map(|before| WRONG * before),
                Flaw::RowAfter => row.after *= WRONG,
                Flaw::RowControl => row.control *= WRONG,
                _ => {}
            }
        }
    }

    fn row_curvature(&self, row: &Row<NX, NU>, nodes: &[C::Node]) -> RowCurvature<NX, NU> {
        let mut curvature = self.chain.row_curvature(row, nodes);
        match &mut curvature {
            RowCurvature::States { after, before } => {
                if let Some((own, across)) = before {
                    match self.flaw {
                        Flaw::CurvatureBefore => *own *= WRONG,
                        Flaw::CurvatureAcross => *across *= WRONG,
                        _ => {}
                    }
                }
                if self.flaw == Flaw::CurvatureAfter {
                    *after *= WRONG;
                }
            }
            RowCurvature::Inside(inside) => match self.flaw {
                Flaw::InsideByState => inside.by_state *= WRONG,
                Flaw::InsideMixed => inside.mixed *= WRONG,
                Flaw::InsideByControl => inside.by_control *= WRONG,
                _ => {}
            },
        }
        curvature
    }

    fn sum_count(&self) -> usize {
        self.chain.sum_count()
    }

    fn sum_row(&self, sum: usize) -> SumRow {
        self.chain.sum_row(sum)
    }

    fn sum_term(&self, sum: usize, k: usize, kept: &C::Kept) -> (f64, Control<NU>) {
        let (value, gradient) = self.chain.sum_term(sum, k, kept);
        match self.flaw {
            Flaw::SumGradient => (value, WRONG * gradient),
            _ => (value, gradient),
        }
    }

    fn sum_curvature(&self, sum: usize, k: usize, kept: &C::Kept) -> SMatrix<f64, NU, NU> {
        let curvature = self.chain.sum_curvature(sum, k, kept);
        match self.flaw {
            Flaw::SumCurvature => WRONG * curvature,
            _ => curvature,
        }
    }

    fn passes_through(&self, from: &[C::Node], to: &[C::Node]) -> bool {
        self.chain.passes_through(from, to)
    }
}
