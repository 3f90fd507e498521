//! Obstacles as convex outlines: clearances with exact first and second
//! derivatives, and motions that would lead through them.
//!
//! The only layer that uses parry. Lengths are in metres; nothing here knows
//! a robot.
//!
//! Every outline is a convex *core* grown by a *radius*: a disc is a grown
//! point, a capsule a grown segment, a box or polygon with rounded corners a
//! grown polygon, a wall a shifted half-plane. The signed distance to the
//! surface is then the distance to the core minus the radius.

mod clearance;
mod edge;
mod obstacle;
mod passage;

pub use clearance::PointClearance;
pub use edge::{Edge, EdgeClearance};
pub use obstacle::{Core, Obstacle};

/// A point, a direction or a displacement in the plane.
pub type Vector = nalgebra::Vector2<f64>;

/// A vector turned a quarter counterclockwise.
pub fn perpendicular(vector: Vector) -> Vector {
    Vector::new(-vector.y, vector.x)
}

/// The z component of a × b.
pub fn cross(a: Vector, b: Vector) -> f64 {
    a.x * b.y - a.y * b.x
}

/// parry's vector of the same components.
fn to_parry(vector: Vector) -> parry2d_f64::math::Vector {
    parry2d_f64::math::Vector::new(vector.x, vector.y)
}

/// The vector of the same components as parry's.
fn from_parry(vector: parry2d_f64::math::Vector) -> Vector {
    Vector::new(vector.x, vector.y)
}
