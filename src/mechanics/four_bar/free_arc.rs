//! The robot that touches nothing: all its segments bend alike, so that its
//! shape is known without solving; and the pulls for which it has one.

use super::linkage::FourBar;
use crate::geometry::Vector;
use crate::robot::{PlanarNode, Robot};

/// The shape of the robot without obstacles at a pull.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FreeArc {
    /// β*, the bend of every segment, in radians, clockwise.
    pub bend: f64,
    /// The last node.
    pub tip: PlanarNode,
}

impl Robot {
    /// The pulls for which a linkage exists, in metres, ends included.
    pub fn pull_range(&self) -> (f64, f64) {
        let n = self.segments as f64;
        let (least, most) = FourBar::shortening_range(self.length / n, self.offset);
        (n * least, n * most)
    }

    /// The shape without obstacles at a pull within [`Robot::pull_range`], in
    /// metres. With s the first segment's step in the base's disk frame, the n
    /// steps sum to
    ///
    /// ```text
    /// Σ R(−kβ*) s = sin(nβ*/2)/sin(β*/2) R(−(n−1)β*/2) s,    k = 0 … n−1
    /// ```
    pub fn free_arc(&self, pull: f64) -> FreeArc {
        let count = self.segments as f64;
        let segment = FourBar::new(self.length / count, pull / count, self.offset);
        let [step, ..] = segment.at(0.0).step;
        let bend = segment.free_bend();
        // Accurate for any bend but none at all: nothing cancels.
        let steps = if bend == 0.0 {
            count
        } else {
            libm::sin(0.5 * count * bend) / libm::sin(0.5 * bend)
        };
        let (sine, cosine) = libm::sincos(-0.5 * (count - 1.0) * bend);
        let along = steps
            * Vector::new(
                cosine * step.x - sine * step.y,
                sine * step.x + cosine * step.y,
            );
        // The base's disk frame: x along the disk, y along its normal.
        let base = self.base;
        let angle = base.angle - count * bend;
        FreeArc {
            bend,
            tip: PlanarNode {
                position: base.position + along.x * base.disk + along.y * base.normal(),
                disk: Vector::new(libm::cos(angle), libm::sin(angle)),
                angle,
            },
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::mechanics::{Equal, Mechanics, Problem};
    use crate::scene::Scene;
    use crate::solver::Chain;

    /// Against the chain itself, at controls of zero: a sum of n steps, of n
    /// roundings.
    #[test]
    fn the_tip_is_where_the_segments_lead() {
        let mut scene = Scene::default();
        scene.robot.base_mm = [3.0, -7.0];
        scene.robot.base_angle_deg = 20.0;
        for (segments, pull_mm) in [
            (18, 0.0),
            (18, 1e-300),
            (18, 1e-7),
            (18, 4.9),
            (18, -20.0),
            (1000, 1e-9),
            (1000, 60.0),
        ] {
            scene.robot.segments = segments;
            scene.set_pull_mm(pull_mm);
            let problem = Equal::new(Problem::new(&scene).unwrap());
            let controls = problem.free_controls();
            let links = controls.iter().enumerate();
            let tip = links.fold(problem.base(), |node, (k, turn)| {
                problem.stage(k + 1, &node, turn).0
            });
            let arc = problem.robot().free_arc(problem.pull());
            assert!(
                (arc.tip.position - tip.position).norm() < 1e-14,
                "{pull_mm}"
            );
            assert!((arc.tip.angle - tip.angle).abs() < 1e-12, "{pull_mm}");
            assert!((arc.tip.disk - tip.disk).norm() < 1e-12, "{pull_mm}");
            assert_eq!(arc.bend, problem.segment().free_bend());
        }
    }
}
