//! An axis-aligned box: of the world, in metres, or of the screen, in pixels.

use crate::geometry::Vector;

/// A box that holds points; empty until it holds one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounds {
    /// The corner of least x and y.
    pub least: Vector,
    /// The corner of greatest x and y.
    pub most: Vector,
}

impl Bounds {
    /// The box that holds nothing.
    pub const EMPTY: Self = Self {
        least: Vector::new(f64::INFINITY, f64::INFINITY),
        most: Vector::new(f64::NEG_INFINITY, f64::NEG_INFINITY),
    };

    /// The smallest box that holds all points.
    pub fn of(points: impl IntoIterator<Item = Vector>) -> Self {
        points.into_iter().fold(Self::EMPTY, Self::with)
    }

    /// The box that also holds a point. A point that is not finite is left
    /// out.
    pub fn with(self, point: Vector) -> Self {
        if !(point.x.is_finite() && point.y.is_finite()) {
            return self;
        }
        Self {
            least: self.least.inf(&point),
            most: self.most.sup(&point),
        }
    }

    /// The box that also holds another box.
    pub fn and(self, other: Self) -> Self {
        Self {
            least: self.least.inf(&other.least),
            most: self.most.sup(&other.most),
        }
    }

    /// What two boxes have in common.
    pub fn within(self, other: Self) -> Self {
        Self {
            least: self.least.sup(&other.least),
            most: self.most.inf(&other.most),
        }
    }

    /// The box with `by` more on each side, in its unit.
    pub fn grown(self, by: f64) -> Self {
        let by = Vector::new(by, by);
        Self {
            least: self.least - by,
            most: self.most + by,
        }
    }

    /// Width and height, in its unit; negative where the box is empty.
    pub fn size(&self) -> Vector {
        self.most - self.least
    }

    /// The middle.
    pub fn centre(&self) -> Vector {
        0.5 * (self.least + self.most)
    }

    /// Whether the box holds nothing.
    pub fn is_empty(&self) -> bool {
        let size = self.size();
        !(size.x >= 0.0 && size.y >= 0.0)
    }

    /// Whether the box holds a point, its edges included.
    pub fn holds(&self, point: Vector) -> bool {
        point == point.sup(&self.least).inf(&self.most)
    }

    /// The four corners, counterclockwise from the lower left.
    pub fn corners(&self) -> [Vector; 4] {
        let (a, b) = (self.least, self.most);
        [a, Vector::new(b.x, a.y), b, Vector::new(a.x, b.y)]
    }
}
