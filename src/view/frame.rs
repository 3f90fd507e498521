//! From the world to a screen: metres, y upward, to pixels, y downward.

use super::bounds::Bounds;
use crate::geometry::Vector;

/// A window on the world. Scales both axes alike.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Frame {
    /// The window on the screen, in pixels; `least` is its upper left corner.
    pub window: Bounds,
    /// Pixels in a metre.
    pub scale: f64,
    /// The point of the world in the middle of the window.
    pub middle: Vector,
}

impl Frame {
    /// The frame that shows all of `bounds` as large as the window allows.
    /// Both must have an area.
    pub fn fitting(bounds: &Bounds, window: Bounds) -> Self {
        let ratio = window.size().component_div(&bounds.size());
        Self {
            window,
            scale: ratio.min(),
            middle: bounds.centre(),
        }
    }

    /// Where a point of the world is on the screen.
    pub fn to_screen(&self, point: Vector) -> Vector {
        let away = self.scale * (point - self.middle);
        self.window.centre() + Vector::new(away.x, -away.y)
    }

    /// The point of the world at a place on the screen.
    pub fn to_world(&self, place: Vector) -> Vector {
        let away = (place - self.window.centre()) / self.scale;
        self.middle + Vector::new(away.x, -away.y)
    }

    /// What the window shows of the world, in metres.
    pub fn shown(&self) -> Bounds {
        Bounds::of(self.window.corners().map(|corner| self.to_world(corner)))
    }
}
