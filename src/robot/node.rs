//! A node of the planar robot: where it is and how its disk points; and a shape,
//! whoever keeps its nodes.

use crate::geometry::{Vector, perpendicular};
use serde::{Deserialize, Serialize};

/// A backbone point with the direction of its disk towards the cable.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct PlanarNode {
    /// The backbone point, in metres.
    pub position: Vector,
    /// (cos φ, sin φ), from the backbone towards the cable.
    pub disk: Vector,
    /// φ, counterclockwise from +x and not wrapped.
    pub angle: f64,
}

impl PlanarNode {
    /// The point of the disk a distance `lever` from the backbone, positive
    /// towards the cable.
    pub fn at(&self, lever: f64) -> Vector {
        self.position + lever * self.disk
    }

    /// The disk's normal, along the backbone towards the tip.
    pub fn normal(&self) -> Vector {
        perpendicular(self.disk)
    }
}

/// The nodes of a shape, base first, however a chain keeps them.
pub trait Nodes {
    /// n + 1.
    fn count(&self) -> usize;

    /// A node, from 0.
    ///
    /// # Panics
    /// If there is none of this index.
    fn node(&self, index: usize) -> &PlanarNode;

    /// A node, if there is one of this index.
    fn find(&self, index: usize) -> Option<&PlanarNode> {
        (index < self.count()).then(|| self.node(index))
    }

    /// All of them.
    fn each(&self) -> impl Iterator<Item = &PlanarNode> {
        (0..self.count()).map(|index| self.node(index))
    }
}

impl Nodes for [PlanarNode] {
    #[inline]
    fn count(&self) -> usize {
        self.len()
    }

    #[inline]
    fn node(&self, index: usize) -> &PlanarNode {
        &self[index]
    }
}

impl<T> Nodes for Vec<T>
where
    [T]: Nodes,
{
    #[inline]
    fn count(&self) -> usize {
        self.as_slice().count()
    }

    #[inline]
    fn node(&self, index: usize) -> &PlanarNode {
        self.as_slice().node(index)
    }
}
