//! Friction of the robot on obstacles, in the same outer iteration as that of the
//! cables: see [`super::friction`].
//!
//! The obstacle's tangential force on the robot's material that touches it stays frozen
//! in a solve, a dead load. Where that material slides, it is μ_w N against the motion;
//! where it sticks, a spring holds it besides, whose force goes into the frozen one
//! after every pass (an augmented Lagrangian), until the material stays where it was.

use super::bay::Bay;
use super::chain::Sliding;
use super::friction::OUTSIDE;
use crate::contact::{Inside, Kinematics, Place, RowKind};
use crate::geometry::{Obstacle, Vector, perpendicular};
use crate::mechanics::Mechanics;
use crate::mechanics::friction::{Drag, Slip};
use crate::robot::{Nodes, PlanarNode};
use crate::solver::{DynamicsCurvature, Point, RowId, Stage};

/// The stiffness of the spring at a contact that sticks, in the chain's unit of energy
/// and the robot's length: far above the robot's own, so that a few passes do.
const HOLDING: f64 = 1e5;

/// How a contact's material moves along its tangent.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Slide {
    Forward,
    Back,
    Sticks,
}

impl Slide {
    fn of(slid: f64) -> Self {
        match Slip::of(slid) {
            Slip::In => Slide::Forward,
            Slip::Out => Slide::Back,
            Slip::Sticks => Slide::Sticks,
        }
    }

    /// The friction of a unit normal force at a coefficient.
    fn resists(self, coefficient: f64) -> f64 {
        match self {
            Slide::Forward => -coefficient,
            Slide::Back => coefficient,
            Slide::Sticks => 0.0,
        }
    }
}

/// A contact's friction, frozen in a solve.
#[derive(Clone, Copy, Debug)]
pub(super) struct Held {
    row: RowId,
    slide: Slide,
    /// Along the tangent, in the chain's unit.
    force: f64,
    tangent: Vector,
    /// The bay, and in it the nodes that carry the material, with their shares.
    bay: usize,
    bearers: [Bearer; 2],
    /// Where the material was when the step began, and how stiffly it is held there.
    was: Vector,
    stiffness: f64,
}

/// A node that carries touching material.
#[derive(Clone, Copy, Debug)]
struct Bearer {
    /// The node's place in the bay.
    place: usize,
    /// The material in the frame of the node's disk, in metres.
    at: Vector,
    share: f64,
}

fn carried(node: &PlanarNode, at: Vector) -> Vector {
    node.position + at.x * node.disk + at.y * node.normal()
}

fn in_frame(node: &PlanarNode, point: Vector) -> Vector {
    let arm = point - node.position;
    Vector::new(arm.dot(&node.disk), arm.dot(&node.normal()))
}

/// Where a point of an obstacle was when it was elsewhere.
fn before(then: &Obstacle, now: &Obstacle, point: Vector) -> Vector {
    let (sine, cosine) = libm::sincos(then.angle() - now.angle());
    let arm = point - now.position();
    let turned = Vector::new(cosine * arm.x - sine * arm.y, sine * arm.x + cosine * arm.y);
    then.position() + turned
}

impl Held {
    /// The material, and how it moves with its bay.
    fn material<const NU: usize>(&self, bay: &Bay<NU>) -> (Vector, Inside<NU>) {
        let [lower, upper] = self.bearers.map(|bearer| {
            let point = carried(bay.node(bearer.place), bearer.at);
            (bearer.share, point, bay.carried(bearer.place, point))
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

    /// The tangential force on material there, in the chain's unit.
    fn force_at(&self, point: Vector) -> f64 {
        self.force - self.stiffness * self.tangent.dot(&(point - self.was))
    }
}

impl<const NU: usize> Sliding<NU> {
    fn contact_friction(&self) -> f64 {
        self.problem.drive().friction.contacts
    }

    /// Freezes what obstacles hold back in a shape that a step starts from.
    pub(super) fn freeze_contacts(
        &mut self,
        obstacles: &[Obstacle],
        nodes: &[Bay<NU>],
        drags: &[Drag],
    ) {
        self.held.clear();
        self.started.clear();
        self.origins.clear();
        if self.contact_friction() == 0.0 {
            return;
        }
        self.started.extend_from_slice(nodes);
        self.origins.extend_from_slice(obstacles);
        let unit = self.cost_unit();
        for drag in drags {
            let slide = Slide::of(drag.slid);
            self.held
                .extend(self.hold(nodes, drag.row, slide, drag.force / unit));
        }
    }

    /// A contact's friction, at a shape that it belongs to.
    fn hold(&self, nodes: &[Bay<NU>], row: RowId, slide: Slide, force: f64) -> Option<Held> {
        let count = self.problem.obstacles().len();
        let RowKind::Contact {
            candidate,
            obstacle,
            vertex,
        } = RowKind::of(row, count)
        else {
            return None;
        };
        let candidate = &self.problem.candidates()[candidate];
        let now = &self.problem.obstacles()[obstacle];
        let Place {
            point,
            normal,
            along,
        } = candidate.place(nodes, now, vertex);
        // What slides is the surface.
        let down = -candidate.radius * normal;
        let (start, end) = candidate.ends(nodes);
        let bearers = candidate.bearers(along);
        let bay = nodes.stage(bearers[1].0);
        let arcs = nodes[bay].arcs();
        let is_edge = bearers[0].0 != bearers[1].0;
        let lever = candidate.signed_lever();
        let bearers = bearers.map(|(node, share)| {
            let carrier = nodes.node(node);
            let at = if is_edge {
                carrier.at(lever)
            } else {
                start + along * (end - start)
            };
            Bearer {
                place: node + arcs - bay * arcs,
                at: in_frame(carrier, at + down),
                share,
            }
        });
        let mut held = Held {
            row,
            slide,
            force,
            tangent: -perpendicular(normal),
            bay,
            bearers,
            was: Vector::zeros(),
            stiffness: 0.0,
        };
        let (began, _) = held.material(&self.started[bay]);
        // Relative to the obstacle, wherever it has moved since.
        let touched = point + down;
        let moved = match self.origins.get(obstacle) {
            Some(then) => touched - before(then, now, touched),
            None => Vector::zeros(),
        };
        held.was = began + moved;
        if slide == Slide::Sticks {
            let length = self.problem.length();
            held.stiffness = HOLDING / (length * length);
        }
        Some(held)
    }

    /// Adds what obstacles hold back to a stage's cost.
    pub(super) fn add_held(&self, k: usize, bay: &Bay<NU>, stage: &mut Stage<3, NU>) {
        for held in self.held.iter().filter(|held| held.bay == k) {
            let (point, moves) = held.material(bay);
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
    pub(super) fn add_held_curvature(
        &self,
        k: usize,
        bay: &Bay<NU>,
        curvature: &mut DynamicsCurvature<3, NU>,
    ) {
        for held in self.held.iter().filter(|held| held.bay == k) {
            let (point, moves) = held.material(bay);
            let force = -held.force_at(point) * held.tangent;
            let own = moves.curvature(force);
            let (state, control) = (moves.by_state(held.tangent), moves.by_control(held.tangent));
            curvature.by_state += own.by_state + held.stiffness * state * state.transpose();
            curvature.mixed += own.mixed + held.stiffness * state * control.transpose();
        }
    }

    /// Lets friction of contacts follow the shape found. Returns the greatest change of
    /// a force, over the greatest normal force.
    pub(super) fn follow_contacts(
        &mut self,
        point: &Point<Self, 3, NU>,
        multipliers: &[f64],
    ) -> f64 {
        let coefficient = self.contact_friction();
        if coefficient == 0.0 {
            return 0.0;
        }
        let old = std::mem::take(&mut self.held);
        let count = self.problem.obstacles().len();
        let most = self.largest(multipliers);
        let mut change = 0.0_f64;
        let mut held = Vec::with_capacity(old.len());
        for (row, &normal) in point.rows.iter().zip(multipliers) {
            let is_contact = matches!(RowKind::of(row.id, count), RowKind::Contact { .. });
            let before = old.iter().find(|held| held.row == row.id);
            if !is_contact || normal <= 0.0 {
                change = change.max(before.map_or(0.0, |held| held.force.abs() / most));
                continue;
            }
            let slide = before.map(|held| held.slide);
            let force = before.map_or(0.0, |held| {
                let (point, _) = held.material(&point.nodes[held.bay]);
                held.force_at(point)
            });
            let Some(mut now) = self.hold(&point.nodes, row.id, Slide::Sticks, force) else {
                continue;
            };
            now.slide = slide.unwrap_or_else(|| Slide::of(self.slid(&now, &point.nodes)));
            if now.slide != Slide::Sticks {
                now.stiffness = 0.0;
                now.force = normal * now.slide.resists(coefficient);
            }
            let frozen = before.map_or(0.0, |held| held.force);
            let turned = before.map_or(0.0, |held| (held.tangent - now.tangent).norm());
            let change_here = (now.force - frozen).abs() + turned * now.force.abs();
            change = change.max(change_here / most);
            held.push(now);
        }
        self.held = held;
        change
    }

    /// The greatest of all multipliers and tensions, in the chain's unit.
    fn largest(&self, multipliers: &[f64]) -> f64 {
        let tensions = self.frozen.iter().flat_map(|frozen| &frozen.tensions);
        let all = multipliers.iter().chain(tensions);
        all.fold(f64::MIN_POSITIVE, |a, b| a.max(*b))
    }

    /// The frozen forces, by row.
    pub(super) fn held_forces(&self) -> impl Iterator<Item = f64> + '_ {
        self.held.iter().map(|held| held.force)
    }

    pub(super) fn set_held_forces(&mut self, forces: impl Iterator<Item = f64>) {
        for (held, force) in self.held.iter_mut().zip(forces) {
            held.force = force;
        }
    }

    /// How far a contact's material has slid since the step began.
    fn slid(&self, held: &Held, nodes: &[Bay<NU>]) -> f64 {
        let (point, _) = held.material(&nodes[held.bay]);
        held.tangent.dot(&(point - held.was))
    }

    /// Lets contacts slide and stick as the shape found asks for. Whether any changed.
    pub(super) fn change_slides(
        &mut self,
        point: &Point<Self, 3, NU>,
        multipliers: &[f64],
        bulk: bool,
    ) -> bool {
        let coefficient = self.contact_friction();
        let length = self.problem.length();
        let mut held = std::mem::take(&mut self.held);
        let most = self.largest(multipliers);
        let mut changed = false;
        for held in &mut held {
            if changed && !bulk {
                break;
            }
            let row = point.rows.binary_search_by_key(&held.row, |row| row.id);
            let Ok(row) = row else { continue };
            let limit = coefficient * multipliers[row];
            let slid = self.slid(held, &point.nodes);
            let slide = match held.slide {
                Slide::Forward if slid < -Slip::UNMOVED => Slide::Sticks,
                Slide::Back if slid > Slip::UNMOVED => Slide::Sticks,
                Slide::Sticks if held.force > limit + OUTSIDE * most => Slide::Back,
                Slide::Sticks if held.force < -limit - OUTSIDE * most => Slide::Forward,
                _ => continue,
            };
            held.slide = slide;
            held.stiffness = 0.0;
            match slide {
                Slide::Sticks => held.stiffness = HOLDING / (length * length),
                slides => held.force = multipliers[row] * slides.resists(coefficient),
            }
            changed = true;
        }
        self.held = held;
        changed
    }

    /// What obstacles hold back in a shape where friction has settled.
    pub(super) fn write_drags(&self, point: &Point<Self, 3, NU>, drags: &mut Vec<Drag>) {
        let unit = self.cost_unit();
        drags.clear();
        drags.extend(self.held.iter().map(|held| {
            let (point_now, _) = held.material(&point.nodes[held.bay]);
            Drag {
                row: held.row,
                force: unit * held.force_at(point_now),
                slid: self.slid(held, &point.nodes),
            }
        }));
    }
}
