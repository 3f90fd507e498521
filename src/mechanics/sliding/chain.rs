//! The robot with sliding cables as a chain for the solver: a stage is a bay, its
//! state (x, y, φ) of the disk it ends at, its controls the bends of its arcs.
//!
//! ```text
//! minimise  ½ Σ u²  + Σ T̂ len  − Σ F̂·x     u = n b, all in units of EI/(L n)
//! subject to  Σ (l_bay − len) − pull + c T ⪰ 0   for every cable under pull
//! ```
//!
//! Friction splits the sums: see [`super::friction`].
//!
//! T of a cable under load is given: its potential is a cost. T of one under pull is
//! the multiplier of its row, and it is slack where that is 0. In the unit of the
//! controls a robot that bends by 1 rad has u = 1 everywhere, whatever its number of
//! segments.

use super::bay::Bay;
use super::friction::{Friction, Group, given_tension, yielding};
use super::stretch::Stretch;
use crate::contact::RowKind;
use crate::geometry::Vector;
use crate::mechanics::{Input, Problem};
use crate::solver::{
    Chain, Control, DynamicsCurvature, Row, RowCurvature, RowId, Stage, State, SumRow,
};
use nalgebra::{SMatrix, matrix};

/// The longest step in a control: all of them together turn the tip by 1 rad, which is
/// as far as a row that was linearised still means something.
const LONGEST_STEP: f64 = 1.0;
/// The least a stretch of cable on the inner side of a bend may be left of its bay's
/// length, before the disks there touch: the arcs' bends are bounded by that.
const LEAST_STRETCH: f64 = 0.05;
/// The most the arcs of a bay may bend together, in radians, whatever the disks' size:
/// at half a turn a stretch no longer leads towards the tip.
const MOST_BEND: f64 = 0.9 * std::f64::consts::PI;
/// The bend of an arc, in radians, that a stationary point need not resolve better than
/// [`crate::solver::Settings::stationarity`] of it: the certificate asks no more.
const LEAST_BEND: f64 = 1e-5;

/// The robot with sliding cables, with up to `NU` arcs a bay.
#[derive(Debug)]
pub struct Sliding<const NU: usize> {
    pub(super) problem: Problem,
    /// l, the length of an arc, in metres.
    arc: f64,
    /// The bend of a unit control, in radians: 1/n.
    bend: f64,
    /// The bound of an arc's bend, in radians.
    most_bend: f64,
    /// 1/(EI/(L n)), per newton metre; 0 where EI is not known, and nothing is asked in
    /// newtons.
    pub(super) per_energy: f64,
    /// Friction as it stands in this solve.
    pub(super) friction: Friction,
}

impl<const NU: usize> Clone for Sliding<NU> {
    fn clone(&self) -> Self {
        Self {
            problem: self.problem.clone(),
            friction: self.friction.clone(),
            ..*self
        }
    }

    fn clone_from(&mut self, source: &Self) {
        self.problem.clone_from(&source.problem);
        self.friction.clone_from(&source.friction);
        self.arc = source.arc;
        self.bend = source.bend;
        self.most_bend = source.most_bend;
        self.per_energy = source.per_energy;
    }
}

impl<const NU: usize> Sliding<NU> {
    /// The mechanics of a problem with at most `NU` segments a bay.
    pub(super) fn of(problem: Problem) -> Self {
        let mut sliding = Self {
            problem,
            arc: 0.0,
            bend: 0.0,
            most_bend: 0.0,
            per_energy: 0.0,
            friction: Friction::default(),
        };
        sliding.prepare();
        sliding
    }

    pub(super) fn change_problem(&mut self, change: impl FnOnce(&mut Problem)) {
        change(&mut self.problem);
        self.prepare();
    }

    /// What follows from the problem.
    fn prepare(&mut self) {
        let robot = *self.problem.robot();
        let drive = self.problem.drive();
        let count = robot.segments as f64;
        self.arc = robot.segment_length();
        self.bend = 1.0 / count;
        let offsets = drive.cables.iter().map(|driven| driven.cable.offset.abs());
        let reach = offsets.fold(0.0, f64::max);
        let arcs = robot.segments_per_bay as f64;
        let touching = (1.0 - LEAST_STRETCH) * self.arc / reach;
        self.most_bend = touching.min(MOST_BEND / arcs);
        self.per_energy = drive
            .stiffness
            .map_or(0.0, |stiffness| robot.length * count / stiffness);
        self.friction.group(self.problem.drive());
    }

    pub(super) fn problem(&self) -> &Problem {
        &self.problem
    }

    /// The bend of a unit control, in radians.
    pub(super) fn bend(&self) -> f64 {
        self.bend
    }

    /// A tension in newtons in the chain's unit, its energy a metre.
    pub(super) fn tension_of(&self, newtons: f64) -> f64 {
        self.per_energy * newtons
    }

    /// How much shorter a cable is than along the straight robot, in metres.
    pub(super) fn shortening(&self, cable: usize, nodes: &[Bay<NU>]) -> f64 {
        let bays = nodes.iter().enumerate().skip(1);
        bays.filter_map(|(k, bay)| {
            let offset = self.offset(cable, k)?;
            Some(self.bay_length() - Stretch::of(bay, offset).length)
        })
        .sum()
    }

    fn bays(&self) -> usize {
        let robot = self.problem.robot();
        robot.segments / robot.segments_per_bay
    }

    /// The offset of a cable in a bay, from 1, if it runs through it.
    fn offset(&self, cable: usize, bay: usize) -> Option<f64> {
        let cable = &self.problem.drive().cables[cable].cable;
        (bay <= cable.last_disk).then_some(cable.offset)
    }

    /// The name of a row that holds a cable.
    pub(super) fn group_id(&self, sum: usize) -> RowId {
        let Group { cable, first, .. } = self.friction.groups[sum];
        let stretch = first;
        RowKind::Cable { cable, stretch }.id(self.problem.obstacles().len())
    }

    /// The offset of the cable that a row holds, in a bay that it holds, from 1.
    fn held_offset(&self, sum: usize, bay: usize) -> Option<f64> {
        let Group { cable, first, last } = self.friction.groups[sum];
        let offset = self.problem.drive().cables[cable].cable.offset;
        (first..=last).contains(&bay).then_some(offset)
    }

    /// The length of a bay, in metres.
    pub(super) fn bay_length(&self) -> f64 {
        self.arc * self.problem.robot().segments_per_bay as f64
    }

    /// Calls with each node of bay k that a dead load acts on, from 1, and the force
    /// there, in the chain's unit of energy a metre.
    fn each_load(&self, k: usize, mut each: impl FnMut(usize, Vector)) {
        let robot = self.problem.robot();
        let loads = &self.problem.drive().loads;
        let arcs = robot.segments_per_bay;
        let share = loads.backbone / robot.segments as f64;
        for j in 1..=arcs {
            let mut force = share;
            if j == arcs {
                force += loads.disk;
                if k == self.bays() {
                    // An arc's weight is shared by its ends.
                    force += loads.tip_force - 0.5 * share;
                }
            }
            each(j, self.per_energy * force);
        }
    }

    fn is_loaded(&self) -> bool {
        self.problem.drive().loads.any()
    }

    /// Adds what hangs on cables and on the robot to a stage's cost.
    fn add_loads(&self, k: usize, bay: &Bay<NU>, stage: &mut Stage<3, NU>) {
        for (cable, driven) in self.problem.drive().cables.iter().enumerate() {
            let Some(offset) = self.offset(cable, k) else {
                continue;
            };
            // Of a cable that rubs, what its row does not hold.
            let tension = match self.friction.frozen.get(cable) {
                Some(frozen) => frozen.extra[k - 1],
                None => given_tension(driven, self.per_energy).unwrap_or(0.0),
            };
            if tension == 0.0 {
                continue;
            }
            let stretch = Stretch::of(bay, offset);
            stage.cost += tension * (stretch.length - self.bay_length());
            stage.cost_gradient += tension * stretch.gradient;
            stage.cost_curvature += tension * stretch.curvature(bay, offset);
        }
        if !self.is_loaded() {
            return;
        }
        self.each_load(k, |j, force| {
            let point = bay.point(j, 0.0);
            stage.cost -= force.dot(&(bay.at(j, 0.0) - self.problem.robot().base.position));
            stage.cost_by_state -= point.by_state(force);
            stage.cost_gradient -= point.by_control(force);
            stage.cost_curvature -= point.curvature(force).by_control;
        });
        if k == self.bays() {
            let moment = self.per_energy * self.problem.drive().loads.tip_moment;
            stage.cost += moment * (bay.end().angle - self.problem.robot().base.angle);
            stage.cost_by_state[2] += moment;
            for i in 0..bay.arcs() {
                stage.cost_gradient[i] -= moment * self.bend;
            }
        }
    }

    /// Adds the rows of |b| ≤ bound for the arcs within reach of it.
    fn add_limits(&self, controls: &[Control<NU>], rows: &mut Vec<Row<3, NU>>) {
        let arcs = self.problem.robot().segments_per_bay;
        let length = self.problem.length();
        for (index, control) in controls.iter().enumerate() {
            for arc in 0..arcs {
                let bend = self.bend * control[arc];
                if bend.abs() + self.bend * LONGEST_STEP > self.most_bend {
                    let sign = if bend > 0.0 { 1 } else { -1 };
                    let kind = RowKind::TurnLimit {
                        segment: index * arcs + arc + 1,
                        sign,
                    };
                    let mut gradient = Control::zeros();
                    gradient[arc] = -f64::from(sign) * self.bend * length;
                    rows.push(Row {
                        id: kind.id(self.problem.obstacles().len()),
                        stage: index + 1,
                        value: (self.most_bend - bend.abs()) * length,
                        before: None,
                        after: State::zeros(),
                        control: gradient,
                    });
                }
            }
        }
    }
}

impl<const NU: usize> Chain<3, NU> for Sliding<NU> {
    const COST_OF_STATE: bool = true;
    const SUM_ROWS: bool = true;

    type Node = Bay<NU>;
    type Kept = (usize, Bay<NU>);

    fn stages(&self) -> usize {
        self.bays()
    }

    fn base(&self) -> Bay<NU> {
        let robot = self.problem.robot();
        Bay::base(robot.base, robot.segments_per_bay)
    }

    fn row_scale(&self) -> f64 {
        self.problem.length()
    }

    fn multiplier_scale(&self) -> f64 {
        self.problem.robot().segments as f64
    }

    fn least_gradient(&self) -> f64 {
        LEAST_BEND / self.bend
    }

    fn longest_step(&self) -> f64 {
        LONGEST_STEP
    }

    fn stage(
        &self,
        k: usize,
        from: &Bay<NU>,
        control: &Control<NU>,
    ) -> (Bay<NU>, Stage<3, NU>, (usize, Bay<NU>)) {
        let bay = Bay::after(from, self.arc, self.bend, control);
        let end = bay.point(bay.arcs(), 0.0);
        let mut by_control = SMatrix::zeros();
        for i in 0..bay.arcs() {
            by_control[(0, i)] = end.by_control[i].x;
            by_control[(1, i)] = end.by_control[i].y;
            by_control[(2, i)] = -self.bend;
        }
        let swing = end.by_turn;
        // A control that is no arc's has a cost all the same, and stays at 0.
        let mut stage = Stage {
            by_state: matrix![1.0, 0.0, swing.x; 0.0, 1.0, swing.y; 0.0, 0.0, 1.0],
            by_control,
            cost: 0.5 * control.norm_squared(),
            cost_by_state: State::zeros(),
            cost_gradient: *control,
            cost_curvature: SMatrix::identity(),
        };
        let limit = self.most_bend + self.bend * LONGEST_STEP;
        if control.iter().any(|u| (self.bend * u).abs() > limit) {
            stage.cost = f64::INFINITY;
        }
        self.add_loads(k, &bay, &mut stage);
        self.add_held(k, &bay, &mut stage);
        (bay, stage, (k, bay))
    }

    fn dynamics_curvature(
        &self,
        (k, bay): &(usize, Bay<NU>),
        adjoint: &State<3>,
    ) -> DynamicsCurvature<3, NU> {
        let force = Vector::new(adjoint[0], adjoint[1]);
        let mut curvature = bay.point(bay.arcs(), 0.0).curvature(force);
        if self.is_loaded() {
            self.each_load(*k, |j, force| {
                let load = bay.point(j, 0.0).curvature(force);
                curvature.by_state -= load.by_state;
                curvature.mixed -= load.mixed;
            });
        }
        self.add_held_curvature(*k, bay, &mut curvature);
        curvature
    }

    fn rows(&self, nodes: &[Bay<NU>], controls: &[Control<NU>], rows: &mut Vec<Row<3, NU>>) {
        rows.clear();
        self.problem.around().add_rows(nodes, rows);
        self.add_limits(controls, rows);
    }

    fn row_curvature(&self, row: &Row<3, NU>, nodes: &[Bay<NU>]) -> RowCurvature<3, NU> {
        self.problem.around().row_curvature(row, nodes)
    }

    fn sum_count(&self) -> usize {
        self.friction.groups.len()
    }

    fn sum_row(&self, sum: usize) -> SumRow {
        let Group { cable, first, last } = self.friction.groups[sum];
        let driven = &self.problem.drive().cables[cable];
        // A multiplier λ is the tension T = λ EI/(L n).
        let (held, yielding) = match self.friction.frozen.get(cable) {
            Some(frozen) => {
                let yielding = yielding(driven, self.per_energy);
                let below = match driven.input {
                    Input::Pull(pull) if first == 1 => pull,
                    _ => frozen.drawn[first - 1],
                };
                let beyond = frozen.drawn.get(last).copied().unwrap_or(0.0);
                let extra: f64 = frozen.extra[first - 1..last].iter().sum();
                let count = (last + 1 - first) as f64;
                (below - beyond - yielding * extra, yielding * count)
            }
            None => {
                let per_energy = self.per_energy;
                let stretches = per_energy > 0.0;
                let compliance = if stretches {
                    driven.cable.compliance / per_energy
                } else {
                    0.0
                };
                (driven.input.pull(), compliance)
            }
        };
        SumRow {
            id: self.group_id(sum),
            bound: -held,
            compliance: yielding,
        }
    }

    fn sum_term(&self, sum: usize, k: usize, (_, bay): &(usize, Bay<NU>)) -> (f64, Control<NU>) {
        match self.held_offset(sum, k) {
            Some(offset) => {
                let stretch = Stretch::of(bay, offset);
                (self.bay_length() - stretch.length, -stretch.gradient)
            }
            None => (0.0, Control::zeros()),
        }
    }

    fn sum_curvature(
        &self,
        sum: usize,
        k: usize,
        (_, bay): &(usize, Bay<NU>),
    ) -> SMatrix<f64, NU, NU> {
        match self.held_offset(sum, k) {
            Some(offset) => -Stretch::of(bay, offset).curvature(bay, offset),
            None => SMatrix::zeros(),
        }
    }

    fn passes_through(&self, from: &[Bay<NU>], to: &[Bay<NU>]) -> bool {
        let around = self.problem.around();
        around.motion_passes(around, from, to)
    }
}
