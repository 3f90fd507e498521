//! Whether a motion of the robot from one shape to another leads through an
//! obstacle. It judges motions between two instants; it moves nothing.

use super::surroundings::Surroundings;
use crate::robot::{Element, PlanarNode};

impl Surroundings {
    /// Whether a point of the robot dips into an obstacle on the straight way
    /// between two shapes, and the obstacle's normal there turns by more than
    /// an angle with the cosine `most_turn(candidate, obstacle)`. The
    /// obstacles move meanwhile from where they are here to where they are in
    /// `later`. Points that move less than a thousandth of the robot's length
    /// are not looked at: at a sharp corner every motion would count.
    pub fn motion_dips(
        &self,
        later: &Self,
        from: &[PlanarNode],
        to: &[PlanarNode],
        most_turn: impl Fn(usize, usize) -> f64,
    ) -> bool {
        let least = 1e-3 * self.length;
        let moved = self.greatest_motion(from, to);
        let mut pairs = self.obstacles.iter().zip(&later.obstacles).enumerate();
        pairs.any(|(index, (now, then))| {
            let moved = moved + now.change(then);
            let mut candidates = self.candidates.iter().enumerate();
            moved > least
                && candidates.any(|(number, candidate)| {
                    let Element::Point { .. } = candidate.element else {
                        return false;
                    };
                    let way = (candidate.ends(from).0, candidate.ends(to).0);
                    now.point_dips(then, way, candidate.radius, (least, moved))
                        .is_some_and(|turned| turned < most_turn(number, index))
                })
        })
    }

    /// Whether a candidate would pass through an obstacle that moves from
    /// where it is here to where it is in `later`, while the robot's nodes
    /// move straight.
    pub fn motion_passes(&self, later: &Self, from: &[PlanarNode], to: &[PlanarNode]) -> bool {
        // Rounding of the nodes' places.
        let tolerance = 1e-12 * self.length;
        let moved = self.greatest_motion(from, to);
        let mut pairs = self.obstacles.iter().zip(&later.obstacles);
        pairs.any(|(now, then)| {
            let moved = moved + now.change(then);
            self.candidates.iter().any(|candidate| {
                let before = candidate.ends(from);
                let after = || candidate.ends(to);
                match candidate.element {
                    Element::Point { .. } => {
                        !now.is_beyond(before.0, candidate.radius + moved)
                            && now.point_passes(
                                then,
                                (before.0, after().0),
                                candidate.radius,
                                moved,
                            )
                    }
                    _ => {
                        let after = after();
                        let ends = ((before.0, after.0), (before.1, after.1));
                        now.edge_passes(then, ends, tolerance, moved)
                    }
                }
            })
        })
    }

    /// What no point of a disk that may touch moves farther than between two
    /// shapes, in metres: at most twice what some point does.
    pub fn greatest_motion(&self, from: &[PlanarNode], to: &[PlanarNode]) -> f64 {
        2.0 * self.greatest_shift(from, to)
    }

    /// Half of what no point of a disk moves farther than: its node's motion,
    /// or its lever times the change of the disk's direction if that is more.
    fn greatest_shift(&self, from: &[PlanarNode], to: &[PlanarNode]) -> f64 {
        let shift = |(a, b): (&PlanarNode, &PlanarNode)| {
            let moved = (b.position - a.position).norm_squared();
            moved.max(self.reach * self.reach * (b.disk - a.disk).norm_squared())
        };
        from.iter().zip(to).map(shift).fold(0.0, f64::max).sqrt()
    }
}
