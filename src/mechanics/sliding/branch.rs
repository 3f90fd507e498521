//! What a run asks of the robot with sliding cables beyond the chain.

use super::bay::Bay;
use super::certifier::Certifier;
use super::chain::Sliding;
use crate::contact::RowKind;
use crate::geometry::Obstacle;
use crate::mechanics::{
    CableState, Certificate, Found, Input, Mechanics, Problem, Rubbing, Settling,
};
use crate::solver::{Control, Point, RowId};
use std::ops::Deref;

impl<const NU: usize> Deref for Sliding<NU> {
    type Target = Problem;

    fn deref(&self) -> &Problem {
        self.problem()
    }
}

impl<const NU: usize> Mechanics<NU> for Sliding<NU> {
    type Shape = [Bay<NU>];
    type Certifier = Certifier;

    fn new(problem: Problem) -> Self {
        Self::of(problem)
    }

    fn change(&mut self, change: impl FnOnce(&mut Problem)) {
        self.change_problem(change);
    }

    fn shape(nodes: &[Bay<NU>]) -> &[Bay<NU>] {
        nodes
    }

    /// An arc that shortens the first cable by its pull, or that its load bends a
    /// slender robot to.
    fn free_controls(&self) -> Vec<Control<NU>> {
        let robot = self.robot();
        let driven = &self.drive().cables[0];
        let offset = driven.cable.offset;
        let turn = match driven.input {
            Input::Pull(pull) => pull.max(0.0) / offset,
            Input::Load(load) => {
                let stiffness = self.drive().stiffness.unwrap_or(f64::INFINITY);
                load * offset * robot.length / stiffness
            }
        };
        let arcs = robot.segments_per_bay;
        let control = Control::from_fn(|i, _| if i < arcs { turn } else { 0.0 });
        vec![control; robot.segments / arcs]
    }

    /// Bends that turn the tip by 1 rad.
    fn control_scale(&self) -> f64 {
        1.0
    }

    /// The cost is ½ Σ (n b)².
    fn cost_unit(&self) -> f64 {
        2.0 * self.bend() * self.bend()
    }

    /// The one that bends most.
    fn most_strained(&self, controls: &[Control<NU>]) -> usize {
        let arcs = self.robot().segments_per_bay;
        let bends = controls.iter().flat_map(|u| u.iter().take(arcs));
        let most = bends.enumerate().fold((0, 0.0), |most, (index, bend)| {
            if bend.abs() > most.1 {
                (index, bend.abs())
            } else {
                most
            }
        });
        most.0 + 1
    }

    fn limited_segment(&self, row: RowId) -> Option<usize> {
        match RowKind::of(row, self.obstacles().len()) {
            RowKind::TurnLimit { segment, .. } => Some(segment),
            RowKind::Contact { .. } | RowKind::Cable { .. } => None,
        }
    }

    fn read_controls(&self, written: &[f64]) -> Option<Vec<Control<NU>>> {
        let robot = self.robot();
        let fits = written.len() == robot.segments && written.iter().all(|u| u.is_finite());
        let arcs = robot.segments_per_bay;
        let bay = |bends: &[f64]| {
            Control::from_fn(|i, _| bends.get(i).map_or(0.0, |bend| bend / self.bend()))
        };
        fits.then(|| written.chunks(arcs).map(bay).collect())
    }

    /// The bends, in radians.
    fn write_controls(&self, controls: &[Control<NU>], written: &mut Vec<f64>) {
        let arcs = self.robot().segments_per_bay;
        let bends = controls.iter().flat_map(|u| u.iter().take(arcs));
        written.clear();
        written.extend(bends.map(|u| self.bend() * u));
    }

    /// Disks stand square on the backbone: none.
    fn write_shears(&self, _controls: &[Control<NU>], shears: &mut Vec<f64>) {
        shears.clear();
        shears.resize(self.robot().segments, 0.0);
    }

    fn write_cables(
        &self,
        point: &Point<Self, 3, NU>,
        multipliers: &[f64],
        cables: &mut Vec<CableState>,
    ) {
        cables.clear();
        if self.has_friction() {
            self.write_rubbing_cables(point, multipliers, cables);
            return;
        }
        let unit = self.cost_unit();
        let mut sums = multipliers[point.rows.len()..].iter();
        for (index, driven) in self.drive().cables.iter().enumerate() {
            cables.push(match driven.input {
                Input::Pull(pull) => {
                    let tension = sums.next().map_or(0.0, |multiplier| multiplier * unit);
                    CableState {
                        pull,
                        tension,
                        load: tension,
                        is_slack: tension == 0.0,
                    }
                }
                Input::Load(load) => {
                    let stretched = load * driven.cable.compliance;
                    let tension = self.tension_of(load) * unit;
                    CableState {
                        pull: self.shortening(index, &point.nodes) + stretched,
                        tension,
                        load: tension,
                        is_slack: load == 0.0,
                    }
                }
            });
        }
    }

    fn rubs(&self) -> bool {
        self.has_friction()
    }

    fn freeze(&mut self, obstacles: &[Obstacle], nodes: &[Bay<NU>], rubbing: &Rubbing) {
        self.freeze_friction(obstacles, nodes, rubbing);
    }

    fn freeze_like(&mut self, other: &Self) {
        self.freeze_friction_like(other);
    }

    fn add_tensions(&self, multipliers: &mut Vec<(RowId, f64)>) {
        self.add_frozen_tensions(multipliers);
    }

    fn settle(&mut self, point: &Point<Self, 3, NU>, multipliers: &[f64]) -> Settling {
        self.settle_friction(point, multipliers)
    }

    fn let_go(&mut self) -> bool {
        self.let_go_of_contacts()
    }

    fn has_let_go(&self) -> bool {
        self.has_let_go_of_contacts()
    }

    fn write_rubbing(
        &self,
        point: &Point<Self, 3, NU>,
        multipliers: &[f64],
        rubbing: &mut Rubbing,
    ) {
        self.write_friction(point, multipliers, rubbing);
    }

    fn certify(&self, certifier: &mut Certifier, found: Found<'_, [Bay<NU>]>) -> Certificate {
        certifier.certify(self, found)
    }
}
