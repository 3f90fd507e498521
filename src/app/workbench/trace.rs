//! Where the tip has been.

use super::live::Live;
use crate::geometry::Vector;

/// Points of the trace that are kept.
const MOST: usize = 2000;

/// The tip has moved on once it is so far from the last point, over the
/// backbone's length: 0.04 mm on the paper's robot, less than a pixel of a
/// window that shows all of it.
const APART: f64 = 2e-4;

/// Where the tip has been since the last start.
#[derive(Clone, Debug, Default)]
pub struct Trace {
    points: Vec<Vector>,
}

impl Trace {
    /// Its points, in metres, the last one last.
    pub fn points(&self) -> &[Vector] {
        &self.points
    }

    /// Begins anew.
    pub fn clear(&mut self) {
        self.points.clear();
    }

    /// Adds the tip of a new shape.
    pub fn follow(&mut self, live: &Live) {
        let Some(solution) = live.solution() else {
            return;
        };
        if !live.is_settled() || solution.nodes.is_empty() {
            return;
        }
        let tip = solution.tip().position;
        let far = APART * live.problem().length();
        let last = self.points.last();
        if last.is_none_or(|last| (tip - last).norm() > far) {
            self.points.push(tip);
        }
        if self.points.len() > MOST {
            self.points.drain(..MOST / 2);
        }
    }
}
