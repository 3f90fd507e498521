//! A chain with one of its derivatives wrong.

use sinew::solver::{Chain, Control, DynamicsCurvature, Row, RowCurvature, Stage, State};

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
}

impl Flaw {
    pub const ALL: [Self; 13] = [
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

    fn row_curvature(&self, row: &Row<NX, NU>, nodes: &[C::Node]) -> RowCurvature<NX> {
        let mut curvature = self.chain.row_curvature(row, nodes);
        if let Some((own, across)) = &mut curvature.before {
            match self.flaw {
                Flaw::CurvatureBefore => *own *= WRONG,
                Flaw::CurvatureAcross => *across *= WRONG,
                _ => {}
            }
        }
        if self.flaw == Flaw::CurvatureAfter {
            curvature.after *= WRONG;
        }
        curvature
    }

    fn passes_through(&self, from: &[C::Node], to: &[C::Node]) -> bool {
        self.chain.passes_through(from, to)
    }
}
