//! The robot of four-bar linkages as a chain for the solver: the state is
//! (x, y, φ) of a node, the one control of a stage its segment's turn τ.

use crate::contact::RowKind;
use crate::geometry::{Vector, perpendicular};
use crate::mechanics::Problem;
use crate::robot::PlanarNode;
use crate::solver::{Chain, Control, DynamicsCurvature, Row, RowCurvature, Stage, State};
use nalgebra::{SMatrix, matrix, vector};

/// The longest step in a turn, in radians: a third of the way to the limit of
/// the linkage, over which a row that was linearised still means something.
const LONGEST_STEP: f64 = 0.5;

/// What a segment keeps for the second derivative of its step, in the world.
#[derive(Clone, Copy, Debug)]
pub struct Bend {
    step: Vector,
    rate: Vector,
    acceleration: Vector,
    bend_acceleration: f64,
}

/// A problem with the paper's mechanics: every segment of the cable shortens alike.
#[derive(Debug)]
pub struct Equal(pub(super) Problem);

impl Clone for Equal {
    fn clone(&self) -> Self {
        Self(self.0.clone())
    }

    fn clone_from(&mut self, source: &Self) {
        self.0.clone_from(&source.0);
    }
}

impl Chain<3, 1> for Equal {
    type Node = PlanarNode;
    type Kept = Bend;

    fn stages(&self) -> usize {
        self.robot().segments
    }

    fn base(&self) -> PlanarNode {
        self.robot().base
    }

    fn row_scale(&self) -> f64 {
        self.robot().length
    }

    fn longest_step(&self) -> f64 {
        LONGEST_STEP
    }

    fn stage(
        &self,
        _k: usize,
        from: &PlanarNode,
        control: &Control<1>,
    ) -> (PlanarNode, Stage<3, 1>, Bend) {
        let shape = self.segment().at(control[0]);
        let world = |v: Vector| v.x * from.disk + v.y * from.normal();
        let [step, rate, acceleration] = shape.step.map(world);
        let (cosine, sine) = (shape.rotation.x, shape.rotation.y);
        let disk = Vector::new(
            cosine * from.disk.x + sine * from.disk.y,
            cosine * from.disk.y - sine * from.disk.x,
        );
        let node = PlanarNode {
            position: from.position + step,
            // One Newton step towards unit length, so that rounding does not
            // add up along the chain.
            disk: disk * (1.5 - 0.5 * disk.norm_squared()),
            angle: from.angle - shape.bend[0],
        };
        let swing = perpendicular(step);
        let stage = Stage {
            by_state: matrix![1.0, 0.0, swing.x; 0.0, 1.0, swing.y; 0.0, 0.0, 1.0],
            by_control: matrix![rate.x; rate.y; -shape.bend[1]],
            cost: shape.cost[0],
            cost_by_state: State::zeros(),
            cost_gradient: vector![shape.cost[1]],
            cost_curvature: matrix![shape.cost[2]],
        };
        let bend = Bend {
            step,
            rate,
            acceleration,
            bend_acceleration: shape.bend[2],
        };
        (node, stage, bend)
    }

    fn dynamics_curvature(&self, bend: &Bend, adjoint: &State<3>) -> DynamicsCurvature<3, 1> {
        let force = Vector::new(adjoint[0], adjoint[1]);
        let mut by_state = SMatrix::zeros();
        by_state[(2, 2)] = -force.dot(&bend.step);
        let turned = force.dot(&perpendicular(bend.rate));
        let turn = force.dot(&bend.acceleration) - adjoint[2] * bend.bend_acceleration;
        DynamicsCurvature {
            by_state,
            mixed: matrix![0.0; 0.0; turned],
            by_control: matrix![turn],
        }
    }

    fn rows(&self, nodes: &[PlanarNode], controls: &[Control<1>], rows: &mut Vec<Row<3, 1>>) {
        rows.clear();
        self.around().add_rows(nodes, rows);
        add_limits(self, controls, rows);
    }

    fn row_curvature(&self, row: &Row<3, 1>, nodes: &[PlanarNode]) -> RowCurvature<3, 1> {
        self.around().row_curvature(row, nodes)
    }

    fn passes_through(&self, from: &[PlanarNode], to: &[PlanarNode]) -> bool {
        self.around().motion_passes(self.around(), from, to)
    }
}

/// Adds the rows of |τ| ≤ bound for the segments within reach of it.
fn add_limits(problem: &Problem, controls: &[Control<1>], rows: &mut Vec<Row<3, 1>>) {
    let most_turn = problem.segment().most_turn();
    for (index, control) in controls.iter().enumerate() {
        let turn = control[0];
        if turn.abs() + LONGEST_STEP > most_turn {
            let sign = if turn > 0.0 { 1 } else { -1 };
            let segment = index + 1;
            let kind = RowKind::TurnLimit { segment, sign };
            rows.push(Row {
                id: kind.id(problem.obstacles().len()),
                stage: segment,
                // In the unit of the other rows, and of their size.
                value: (most_turn - turn.abs()) * problem.length(),
                before: None,
                after: State::zeros(),
                control: vector![-f64::from(sign) * problem.length()],
            });
        }
    }
}
