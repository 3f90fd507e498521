//! A bay of the sliding-cable robot: the arcs of the backbone from one disk to the
//! next, and how any point of a disk on the way moves when they bend.

use super::arc::Arc;
use crate::contact::{Inside, Kinematics};
use crate::geometry::{Vector, perpendicular};
use crate::robot::{Nodes, PlanarNode};
use crate::solver::Control;

/// A bay with up to `NU` arcs, evaluated.
#[derive(Clone, Copy, Debug)]
pub struct Bay<const NU: usize> {
    /// The node it starts from.
    start: PlanarNode,
    /// The node after each arc. Behind the last arc's it is repeated.
    nodes: [PlanarNode; NU],
    /// The change of each arc's end with a unit change of its control, as if nothing
    /// beyond it turned, in metres.
    rates: [Vector; NU],
    /// The rate of change of that.
    accelerations: [Vector; NU],
    /// m, the number of arcs.
    arcs: usize,
    /// The bend, in radians, of a unit change of a control.
    bend: f64,
}

impl<const NU: usize> Bay<NU> {
    /// The bay before the first, of which only its end is looked at.
    pub fn base(node: PlanarNode, arcs: usize) -> Self {
        Self {
            start: node,
            nodes: [node; NU],
            rates: [Vector::zeros(); NU],
            accelerations: [Vector::zeros(); NU],
            arcs,
            bend: 0.0,
        }
    }

    /// The bay of as many arcs as the one before, of `length` metres each, with bends
    /// of `bend` radians times each control.
    pub fn after(before: &Self, length: f64, bend: f64, control: &Control<NU>) -> Self {
        let mut bay = Self::base(before.end(), before.arcs);
        bay.bend = bend;
        let mut from = bay.start;
        for i in 0..bay.arcs {
            let turn = bend * control[i];
            let arc = Arc::of(turn);
            let normal = from.normal();
            let world = |k: usize| arc.across[k] * from.disk + arc.along[k] * normal;
            let (cosine, sine) = arc.rotation;
            let disk = cosine * from.disk - sine * normal;
            bay.rates[i] = length * bend * world(1);
            bay.accelerations[i] = length * bend * bend * world(2);
            from = PlanarNode {
                position: from.position + length * world(0),
                // One Newton step towards unit length, so that rounding does not add
                // up along the chain.
                disk: disk * (1.5 - 0.5 * disk.norm_squared()),
                angle: from.angle - turn,
            };
            bay.nodes[i] = from;
        }
        for i in bay.arcs..NU {
            bay.nodes[i] = from;
        }
        bay
    }

    /// The node it ends at, whose disk the next one starts from.
    pub fn end(&self) -> PlanarNode {
        self.nodes[NU - 1]
    }

    /// The bay's node `j`, from 0 at its start to m.
    pub fn node(&self, j: usize) -> &PlanarNode {
        match j.checked_sub(1) {
            Some(arc) => &self.nodes[arc],
            None => &self.start,
        }
    }

    /// m, the number of arcs.
    pub fn arcs(&self) -> usize {
        self.arcs
    }

    /// The point of the disk at the bay's node `j`, from 0 at its start to m, a distance
    /// `lever` from the backbone.
    pub fn at(&self, j: usize, lever: f64) -> Vector {
        self.node(j).at(lever)
    }

    /// How that point moves.
    pub fn point(&self, j: usize, lever: f64) -> Inside<NU> {
        self.carried(j, self.at(j, lever))
    }

    /// How a point moves that the disk at the bay's node `j` carries.
    pub fn carried(&self, j: usize, point: Vector) -> Inside<NU> {
        let mut inside = Inside {
            by_turn: perpendicular(point - self.start.position),
            by_control: [Vector::zeros(); NU],
            own: [Vector::zeros(); NU],
            bend: self.bend,
        };
        for i in 0..j.min(self.arcs) {
            // What is beyond the arc turns clockwise about its end.
            let arm = point - self.nodes[i].position;
            inside.by_control[i] = self.rates[i] - self.bend * perpendicular(arm);
            inside.own[i] = self.accelerations[i] - self.bend * self.bend * arm;
        }
        inside
    }
}

/// Which bay a node is in, and where in it; the base is the end of bay 0.
#[inline]
fn place<const NU: usize>(bays: &[Bay<NU>], node: usize) -> (usize, usize) {
    if NU == 1 {
        return (node, 1);
    }
    let arcs = bays[0].arcs;
    match node.checked_sub(1) {
        Some(below) => (below / arcs + 1, below % arcs + 1),
        None => (0, arcs),
    }
}

impl<const NU: usize> Nodes for [Bay<NU>] {
    #[inline]
    fn count(&self) -> usize {
        self.first()
            .map_or(0, |base| (self.len() - 1) * base.arcs + 1)
    }

    #[inline]
    fn node(&self, index: usize) -> &PlanarNode {
        let (bay, place) = place(self, index);
        &self[bay].nodes[place - 1]
    }
}

impl<const NU: usize> Kinematics<NU> for [Bay<NU>] {
    #[inline]
    fn stage(&self, node: usize) -> usize {
        place(self, node).0
    }

    #[inline]
    fn is_inside(&self, node: usize) -> bool {
        NU > 1 && place(self, node).1 < self[0].arcs
    }

    fn inside(&self, stage: usize, node: usize, lever: f64) -> Option<Inside<NU>> {
        let bay = self.get(stage)?;
        Some(bay.point((node + bay.arcs).checked_sub(stage * bay.arcs)?, lever))
    }
}
