//! The friction of a chain of bays: hands its shapes to [`Friction`], and adds to the
//! chain's cost what obstacles hold back.

use super::holes::Below;
use super::{Forces, Friction, Held, Look};
use crate::contact::Inside;
use crate::geometry::{Obstacle, Vector};
use crate::mechanics::sliding::bay::Bay;
use crate::mechanics::sliding::chain::Sliding;
use crate::mechanics::{CableState, Mechanics, Rubbing, Settling};
use crate::robot::{Nodes, PlanarNode};
use crate::solver::{DynamicsCurvature, Point, RowId, Stage};

/// The material that a contact holds, and how it moves with its bay.
fn material<const NU: usize>(held: &Held, bay: &Bay<NU>) -> (Vector, Inside<NU>) {
    let [lower, upper] = held.bearers.map(|bearer| {
        let place = bearer.place(held.bay, bay.arcs());
        let point = bearer.carried(bay.node(place));
        (bearer.share, point, bay.carried(place, point))
    });
    let mut inside = upper.2;
    let mix = |a: Vector, b: Vector| lower.0 * a + upper.0 * b;
    inside.by_turn = mix(lower.2.by_turn, upper.2.by_turn);
    for i in 0..NU {
        inside.by_control[i] = mix(lower.2.by_control[i], upper.2.by_control[i]);
        inside.own[i] = mix(lower.2.own[i], upper.2.own[i]);
    }
    (mix(lower.1, upper.1), inside)
}

impl<const NU: usize> Sliding<NU> {
    /// Calls with the chain's friction and how it looks at a shape.
    fn look_at<T>(
        &mut self,
        nodes: &[Bay<NU>],
        call: impl FnOnce(&mut Friction, Look<'_>) -> T,
    ) -> T {
        let mut all = std::mem::take(&mut self.friction.storage.nodes);
        all.clear();
        all.extend(nodes.each());
        let mut friction = std::mem::take(&mut self.friction);
        let result = call(&mut friction, self.look(&all));
        self.friction = friction;
        self.friction.storage.nodes = all;
        result
    }

    fn look<'a>(&'a self, nodes: &'a [PlanarNode]) -> Look<'a> {
        Look {
            problem: &self.problem,
            nodes,
            unit: self.cost_unit(),
            per_energy: self.per_energy,
        }
    }

    /// Whether anything rubs.
    pub(crate) fn has_friction(&self) -> bool {
        !self.problem.drive().friction.is_none()
    }

    /// Freezes friction as it is in a shape that a step starts from, among obstacles
    /// where they were then.
    pub(crate) fn freeze_friction(
        &mut self,
        obstacles: &[Obstacle],
        nodes: &[Bay<NU>],
        rubbing: &Rubbing,
    ) {
        if self.has_friction() || !self.friction.frozen.is_empty() {
            self.look_at(nodes, |friction, look| {
                friction.freeze(look, obstacles, rubbing);
            });
        }
    }

    /// Takes over what another solve of the same cables has frozen.
    pub(crate) fn freeze_friction_like(&mut self, other: &Self) {
        let (here, there) = (self.problem.drive(), other.problem.drive());
        self.friction.freeze_like(&other.friction, here, there);
    }

    /// Lets go of contacts in this solve. Whether any rubbed.
    pub(crate) fn let_go_of_contacts(&mut self) -> bool {
        self.friction.let_go(self.problem.drive())
    }

    /// Whether this solve goes without the friction of contacts.
    pub(crate) fn has_let_go_of_contacts(&self) -> bool {
        self.friction.let_go
    }

    /// Adds the multipliers of the rows that hold cables, to start a solve with.
    pub(crate) fn add_frozen_tensions(&self, multipliers: &mut Vec<(RowId, f64)>) {
        for (sum, group) in self.friction.groups.iter().enumerate() {
            let tension = self.friction.frozen[group.cable].tensions[group.first - 1];
            if tension > 0.0 {
                multipliers.push((self.group_id(sum), tension));
            }
        }
    }

    /// After a solve: freezes friction as it would be in the shape found.
    pub(crate) fn settle_friction(
        &mut self,
        point: &Point<Self, 3, NU>,
        multipliers: &[f64],
    ) -> Settling {
        let mut rows = std::mem::take(&mut self.friction.storage.rows);
        rows.clear();
        rows.extend(point.rows.iter().map(|row| row.id));
        let forces = Forces {
            rows: &rows,
            multipliers,
        };
        let settling = self.look_at(&point.nodes, |friction, look| friction.settle(look, forces));
        self.friction.storage.rows = rows;
        settling
    }

    /// What friction keeps of a shape where it has settled.
    pub(crate) fn write_friction(
        &self,
        point: &Point<Self, 3, NU>,
        multipliers: &[f64],
        rubbing: &mut Rubbing,
    ) {
        if !self.has_friction() {
            rubbing.strands.clear();
            rubbing.drags.clear();
            return;
        }
        let nodes: Vec<PlanarNode> = point.nodes.each().copied().collect();
        let rows: Vec<RowId> = point.rows.iter().map(|row| row.id).collect();
        let forces = Forces {
            rows: &rows,
            multipliers,
        };
        let look = self.look(&nodes);
        if self.friction.let_go {
            Friction::write_resting(look, forces, &mut rubbing.drags);
        } else {
            self.friction.write_drags(look, &mut rubbing.drags);
        }
        let strands = &mut rubbing.strands;
        self.friction.write_strands(look, forces.sums(), strands);
    }

    /// What is found of the cables where they rub.
    pub(crate) fn write_rubbing_cables(
        &self,
        point: &Point<Self, 3, NU>,
        multipliers: &[f64],
        cables: &mut Vec<CableState>,
    ) {
        let nodes: Vec<PlanarNode> = point.nodes.each().copied().collect();
        let sums = &multipliers[point.rows.len()..];
        let (look, unit) = (self.look(&nodes), self.cost_unit());
        let (mut tensions, mut drawn) = (Vec::new(), Vec::new());
        cables.extend((0..self.friction.frozen.len()).map(|cable| {
            let Below {
                tension,
                drawn,
                load,
            } = self
                .friction
                .below(cable, look, sums, &mut tensions, &mut drawn);
            CableState {
                pull: drawn,
                tension: unit * tension,
                load: unit * load,
                is_slack: tension == 0.0,
            }
        }));
    }

    /// Adds what obstacles hold back to a stage's cost.
    pub(crate) fn add_held(&self, k: usize, bay: &Bay<NU>, stage: &mut Stage<3, NU>) {
        for held in self.friction.held.iter().filter(|held| held.bay == k) {
            let (point, moves) = material(held, bay);
            let gap = held.tangent.dot(&(point - held.was));
            let force = -held.force_at(point) * held.tangent;
            stage.cost += (0.5 * held.stiffness * gap - held.force) * gap;
            stage.cost_by_state += moves.by_state(force);
            stage.cost_gradient += moves.by_control(force);
            let along = moves.by_control(held.tangent);
            stage.cost_curvature +=
                moves.curvature(force).by_control + held.stiffness * along * along.transpose();
        }
    }

    /// Adds the rest of the second derivative of that.
    pub(crate) fn add_held_curvature(
        &self,
        k: usize,
        bay: &Bay<NU>,
        curvature: &mut DynamicsCurvature<3, NU>,
    ) {
        for held in self.friction.held.iter().filter(|held| held.bay == k) {
            let (point, moves) = material(held, bay);
            let force = -held.force_at(point) * held.tangent;
            let own = moves.curvature(force);
            let (state, control) = (moves.by_state(held.tangent), moves.by_control(held.tangent));
            curvature.by_state += own.by_state + held.stiffness * state * state.transpose();
            curvature.mixed += own.mixed + held.stiffness * state * control.transpose();
        }
    }
}
