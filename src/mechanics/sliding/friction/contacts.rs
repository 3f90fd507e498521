//! Friction of the robot on obstacles.
//!
//! The obstacle's tangential force on the robot's material that touches it stays frozen
//! in a solve, a dead load. Where that material slides, it is μ_w N against the motion;
//! where it sticks, a spring holds it besides, whose force goes into the frozen one
//! after every pass (an augmented Lagrangian), until the material stays where it was.

use super::{Forces, Friction, Look, OUTSIDE};
use crate::contact::{Place, RowKind};
use crate::geometry::{Obstacle, Vector, perpendicular};
use crate::mechanics::friction::{Drag, Slip};
use crate::robot::PlanarNode;
use crate::solver::RowId;

/// The stiffness of the spring at a contact that sticks, in the chain's unit of energy
/// and the robot's length: far above the robot's own, so that a few passes do.
const HOLDING: f64 = 1e5;

/// The friction of a unit normal force at a coefficient, along a contact's tangent, where
/// the robot goes forward along it (in) or back (out).
fn resists(slide: Slip, coefficient: f64) -> f64 {
    match slide {
        Slip::In => -coefficient,
        Slip::Out => coefficient,
        Slip::Sticks => 0.0,
    }
}

/// A contact's friction, frozen in a solve.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Held {
    row: RowId,
    slide: Slip,
    /// Along the tangent, in the chain's unit.
    pub force: f64,
    pub tangent: Vector,
    /// The bay that the material is in.
    pub bay: usize,
    /// The nodes that carry it.
    pub bearers: [Bearer; 2],
    /// Where it was when the step began, and how stiffly it is held there.
    pub was: Vector,
    pub stiffness: f64,
}

/// A node that carries touching material.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Bearer {
    node: usize,
    /// The material in the frame of the node's disk, in metres.
    at: Vector,
    pub share: f64,
}

impl Bearer {
    /// The node's place in its bay of so many arcs.
    pub fn place(&self, bay: usize, arcs: usize) -> usize {
        self.node + arcs - bay * arcs
    }

    /// The material, as the node carries it.
    pub fn carried(&self, node: &PlanarNode) -> Vector {
        node.position + self.at.x * node.disk + self.at.y * node.normal()
    }
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
    /// The material.
    fn material(&self, nodes: &[PlanarNode]) -> Vector {
        let [lower, upper] = self
            .bearers
            .map(|bearer| bearer.share * bearer.carried(&nodes[bearer.node]));
        lower + upper
    }

    /// How far it has slid since the step began.
    fn slid(&self, nodes: &[PlanarNode]) -> f64 {
        self.tangent.dot(&(self.material(nodes) - self.was))
    }

    /// The tangential force on material there, in the chain's unit.
    pub fn force_at(&self, point: Vector) -> f64 {
        self.force - self.stiffness * self.tangent.dot(&(point - self.was))
    }
}

impl Look<'_> {
    fn contact_friction(&self) -> f64 {
        self.problem.drive().friction.contacts
    }

    /// How stiffly what sticks is held.
    fn holding(&self) -> f64 {
        let length = self.problem.length();
        HOLDING / (length * length)
    }
}

impl Friction {
    /// Freezes what obstacles hold back in a shape that a step starts from.
    pub(super) fn freeze_contacts(
        &mut self,
        look: Look<'_>,
        obstacles: &[Obstacle],
        drags: &[Drag],
    ) {
        self.held.clear();
        self.started.clear();
        self.origins.clear();
        if look.contact_friction() == 0.0 {
            return;
        }
        self.started.extend_from_slice(look.nodes);
        self.origins.extend_from_slice(obstacles);
        for drag in drags {
            let slide = Slip::of(drag.slid);
            let held = self.hold(look, drag.row, slide, drag.force / look.unit);
            self.held.extend(held);
        }
    }

    /// A contact's friction, at a shape that it belongs to.
    fn hold(&self, look: Look<'_>, row: RowId, slide: Slip, force: f64) -> Option<Held> {
        let Look { problem, nodes, .. } = look;
        let RowKind::Contact {
            candidate,
            obstacle,
            vertex,
        } = RowKind::of(row, problem.obstacles().len())
        else {
            return None;
        };
        let candidate = &problem.candidates()[candidate];
        let now = &problem.obstacles()[obstacle];
        let Place {
            point,
            normal,
            along,
        } = candidate.place(nodes, now, vertex);
        // What slides is the surface.
        let down = -candidate.radius * normal;
        let (start, end) = candidate.ends(nodes);
        let bearers = candidate.bearers(along);
        let is_edge = bearers[0].0 != bearers[1].0;
        let lever = candidate.signed_lever();
        let bay = bearers[1].0.div_ceil(problem.robot().segments_per_bay);
        let bearers = bearers.map(|(node, share)| {
            let carrier = &nodes[node];
            let at = if is_edge {
                carrier.at(lever)
            } else {
                start + along * (end - start)
            };
            let at = in_frame(carrier, at + down);
            Bearer { node, at, share }
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
        // Relative to the obstacle, wherever it has moved since.
        let touched = point + down;
        let moved = match self.origins.get(obstacle) {
            Some(then) => touched - before(then, now, touched),
            None => Vector::zeros(),
        };
        held.was = held.material(&self.started) + moved;
        if slide == Slip::Sticks {
            held.stiffness = look.holding();
        }
        Some(held)
    }

    /// Lets friction of contacts follow the shape found. Returns the greatest change of
    /// a force, over the greatest of all.
    pub(super) fn follow_contacts(&mut self, look: Look<'_>, forces: Forces<'_>) -> f64 {
        let coefficient = look.contact_friction();
        if coefficient == 0.0 {
            return 0.0;
        }
        let count = look.problem.obstacles().len();
        let most = self.largest(forces);
        let mut change = 0.0_f64;
        let mut all = std::mem::take(&mut self.storage.held);
        all.clear();
        for (&row, &normal) in forces.rows.iter().zip(forces.multipliers) {
            let is_contact = matches!(RowKind::of(row, count), RowKind::Contact { .. });
            let before = self.held.iter().find(|held| held.row == row);
            if !is_contact || normal <= 0.0 {
                change = change.max(before.map_or(0.0, |held| held.force.abs() / most));
                continue;
            }
            let force = before.map_or(0.0, |held| held.force_at(held.material(look.nodes)));
            let Some(mut now) = self.hold(look, row, Slip::Sticks, force) else {
                continue;
            };
            now.slide = match before {
                Some(held) => held.slide,
                None => Slip::of(now.slid(look.nodes)),
            };
            if now.slide != Slip::Sticks {
                now.stiffness = 0.0;
                now.force = normal * resists(now.slide, coefficient);
            }
            let frozen = before.map_or(0.0, |held| held.force);
            let turned = before.map_or(0.0, |held| (held.tangent - now.tangent).norm());
            let change_here = (now.force - frozen).abs() + turned * now.force.abs();
            change = change.max(change_here / most);
            all.push(now);
        }
        std::mem::swap(&mut self.held, &mut all);
        self.storage.held = all;
        change
    }

    /// The greatest of all multipliers and tensions, in the chain's unit.
    fn largest(&self, forces: Forces<'_>) -> f64 {
        let tensions = self.frozen.iter().flat_map(|frozen| &frozen.tensions);
        let all = forces.multipliers.iter().chain(tensions);
        all.fold(f64::MIN_POSITIVE, |a, b| a.max(*b))
    }

    /// Lets contacts slide and stick as the shape found asks for. Whether any changed.
    pub(super) fn change_slides(&mut self, look: Look<'_>, forces: Forces<'_>, bulk: bool) -> bool {
        let coefficient = look.contact_friction();
        let most = self.largest(forces);
        let mut changed = false;
        for held in &mut self.held {
            if changed && !bulk {
                break;
            }
            let Ok(row) = forces.rows.binary_search(&held.row) else {
                continue;
            };
            let normal = forces.multipliers[row];
            let limit = coefficient * normal;
            let slid = held.slid(look.nodes);
            let slide = match held.slide {
                Slip::In if slid < -Slip::UNMOVED => Slip::Sticks,
                Slip::Out if slid > Slip::UNMOVED => Slip::Sticks,
                Slip::Sticks if held.force > limit + OUTSIDE * most => Slip::Out,
                Slip::Sticks if held.force < -limit - OUTSIDE * most => Slip::In,
                _ => continue,
            };
            held.slide = slide;
            if slide == Slip::Sticks {
                held.stiffness = look.holding();
            } else {
                held.stiffness = 0.0;
                held.force = normal * resists(slide, coefficient);
            }
            changed = true;
        }
        changed
    }

    /// What obstacles hold back where friction was let go, and the robot rests now.
    pub(super) fn write_resting(look: Look<'_>, forces: Forces<'_>, drags: &mut Vec<Drag>) {
        let count = look.problem.obstacles().len();
        let presses = |row: RowId, normal: f64| {
            normal > 0.0 && matches!(RowKind::of(row, count), RowKind::Contact { .. })
        };
        drags.clear();
        let rows = forces.rows.iter().zip(forces.multipliers);
        drags.extend(
            rows.filter(|(row, normal)| presses(**row, **normal))
                .map(|(&row, _)| Drag {
                    row,
                    force: 0.0,
                    slid: 0.0,
                }),
        );
    }

    /// What obstacles hold back in a shape where friction has settled.
    pub(super) fn write_drags(&self, look: Look<'_>, drags: &mut Vec<Drag>) {
        drags.clear();
        drags.extend(self.held.iter().map(|held| Drag {
            row: held.row,
            force: look.unit * held.force_at(held.material(look.nodes)),
            slid: held.slid(look.nodes),
        }));
    }
}
