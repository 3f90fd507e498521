//! The robot's dimensions. Nothing of its shape, nor of what is around it.

use super::node::PlanarNode;
use super::sizes::Sizes;
use serde::{Deserialize, Serialize};

/// The robot's dimensions, in metres.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Robot {
    /// Length of the backbone.
    pub length: f64,
    /// n, the number of segments.
    pub segments: usize,
    /// Segments between neighbouring disks.
    pub segments_per_bay: usize,
    /// The cable offset a.
    pub offset: f64,
    /// How thick its parts are.
    pub sizes: Sizes,
    /// Where the robot starts, and how its first disk points (0 for a robot
    /// that rises along +y).
    pub base: PlanarNode,
}

impl Robot {
    /// Clearances within this share of the backbone's length of zero count as
    /// touching: well above the rounding of any coordinates that a scene may
    /// have, well below anything visible.
    pub const TOUCHING: f64 = 1e-9;

    /// The greatest size of a clearance that counts as none, in metres.
    pub fn touching(&self) -> f64 {
        Self::TOUCHING * self.length
    }

    /// The length of a segment's backbone, in metres.
    pub fn segment_length(&self) -> f64 {
        self.length / self.segments as f64
    }

    /// Whether a node carries a disk.
    pub fn has_disk(&self, node: usize) -> bool {
        node.is_multiple_of(self.segments_per_bay)
    }

    /// Whether another robot moves like this one where the same parts may
    /// touch: whether it is this one but for its sizes.
    pub fn moves_like(&self, other: &Self) -> bool {
        let sizes = self.sizes;
        *self == Self { sizes, ..*other }
    }
}
