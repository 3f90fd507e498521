//! Obstacles as a scene file gives them. No distances are computed here.

use serde::{Deserialize, Serialize};

/// Something rigid that the robot cannot enter.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Obstacle {
    /// What the obstacle is called.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub name: Option<String>,
    /// Its shape, with its place.
    #[serde(flatten)]
    pub shape: Shape,
}

/// The outline of an obstacle, in the file's millimetres and degrees.
///
/// Rotations are counterclockwise. Each field's range is in [`super::limits`].
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(tag = "shape", rename_all = "lowercase")]
pub enum Shape {
    /// A round post.
    Disc {
        /// Its centre, [x, y].
        center_mm: [f64; 2],
        /// Its radius.
        radius_mm: f64,
    },
    /// Everything behind a straight line.
    Wall {
        /// A point of the line, [x, y].
        point_mm: [f64; 2],
        /// Direction of the outward normal, towards the free side, from +x.
        #[serde(default)]
        rotation_deg: f64,
        /// Shifts the surface outward by as much.
        #[serde(default)]
        corner_radius_mm: f64,
    },
    /// A rectangle.
    Box {
        /// Its centre, [x, y].
        center_mm: [f64; 2],
        /// Its outer size, [width, height], before the turn.
        size_mm: [f64; 2],
        /// Its turn about its centre.
        #[serde(default)]
        rotation_deg: f64,
        /// Rounds the corners inside the outer size; at most half the smaller
        /// side.
        #[serde(default)]
        corner_radius_mm: f64,
    },
    /// A straight bar with round ends.
    Capsule {
        /// Its centre, [x, y].
        center_mm: [f64; 2],
        /// Distance between the centres of its two round ends.
        length_mm: f64,
        /// Radius of the ends, half the bar's thickness.
        radius_mm: f64,
        /// Direction of its axis from +x.
        #[serde(default)]
        rotation_deg: f64,
    },
    /// A convex polygon, grown by a radius.
    Polygon {
        /// Its vertices in order, [x, y] each, either way round; 3 to
        /// [`super::limits::VERTICES`] of them.
        points_mm: Vec<[f64; 2]>,
        /// Its turn about the mean of its vertices.
        #[serde(default)]
        rotation_deg: f64,
        /// The outline lies this far outside the vertices' polygon.
        #[serde(default)]
        corner_radius_mm: f64,
    },
}

impl Shape {
    /// The shape's word in scene files, such as `disc`.
    pub fn word(&self) -> &'static str {
        match self {
            Shape::Disc { .. } => "disc",
            Shape::Wall { .. } => "wall",
            Shape::Box { .. } => "box",
            Shape::Capsule { .. } => "capsule",
            Shape::Polygon { .. } => "polygon",
        }
    }

    /// The point the shape is placed by and turns about, [x, y], mm: its
    /// centre, the point of a wall, the mean of a polygon's vertices.
    ///
    /// Not finite for a polygon without vertices, which [`super::Scene::faults`]
    /// reports.
    pub fn anchor_mm(&self) -> [f64; 2] {
        match self {
            Shape::Disc { center_mm, .. }
            | Shape::Box { center_mm, .. }
            | Shape::Capsule { center_mm, .. } => *center_mm,
            Shape::Wall { point_mm, .. } => *point_mm,
            Shape::Polygon { points_mm, .. } => {
                let count = points_mm.len() as f64;
                let mean = |axis: usize| points_mm.iter().map(|p| p[axis]).sum::<f64>() / count;
                [mean(0), mean(1)]
            }
        }
    }

    /// Moves the shape so that its anchor is at a point, [x, y], mm.
    pub fn move_to_mm(&mut self, to: [f64; 2]) {
        let from = self.anchor_mm();
        match self {
            Shape::Disc { center_mm, .. }
            | Shape::Box { center_mm, .. }
            | Shape::Capsule { center_mm, .. } => *center_mm = to,
            Shape::Wall { point_mm, .. } => *point_mm = to,
            Shape::Polygon { points_mm, .. } => {
                for point in points_mm {
                    for axis in 0..2 {
                        point[axis] += to[axis] - from[axis];
                    }
                }
            }
        }
    }

    /// The shape's turn about its anchor, counterclockwise, deg; 0 for a disc.
    pub fn rotation_deg(&self) -> f64 {
        match self {
            Shape::Disc { .. } => 0.0,
            Shape::Wall { rotation_deg, .. }
            | Shape::Box { rotation_deg, .. }
            | Shape::Capsule { rotation_deg, .. }
            | Shape::Polygon { rotation_deg, .. } => *rotation_deg,
        }
    }
}

impl From<Shape> for Obstacle {
    fn from(shape: Shape) -> Self {
        Obstacle { name: None, shape }
    }
}
