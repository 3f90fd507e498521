//! Whether a motion of the robot from one shape to another leads through an
//! obstacle. It judges motions between two instants; it moves nothing.

use super::surroundings::Surroundings;
use crate::robot::Nodes;

/// Motions below this share of the backbone's length are not asked whether they
/// dip: 0.2 mm of 180, below which a step follows its branch anyhow.
const LEAST_DIP: f64 = 1e-3;
/// How near a vertex an edge may be at either end of a motion and still be on its
/// own side, over the backbone's length: the rounding of the nodes' places.
const ROUNDING: f64 = 1e-12;

impl Surroundings {
    /// Whether a point of the robot dips into an obstacle on the straight way
    /// between two shapes, and the obstacle's normal there turns by more than
    /// an angle with the cosine `least_cosine(candidate, obstacle)`. The
    /// obstacles move meanwhile from where they are here to where they are in
    /// `later`. Points that move less than a thousandth of the robot's length
    /// are not looked at: at a sharp corner every motion would count.
    pub fn motion_dips<N: Nodes + ?Sized>(
        &self,
        later: &Self,
        from: &N,
        to: &N,
        least_cosine: impl Fn(usize, usize) -> f64,
    ) -> bool {
        let least = LEAST_DIP * self.length;
        let moved = self.greatest_motion(from, to);
        let mut pairs = self.obstacles.iter().zip(&later.obstacles).enumerate();
        pairs.any(|(index, (now, then))| {
            let moved = moved + now.change(then);
            let mut candidates = self.candidates.iter().enumerate();
            moved > least
                && candidates.any(|(number, candidate)| {
                    if !candidate.is_point() {
                        return false;
                    }
                    let way = (candidate.ends(from).0, candidate.ends(to).0);
                    now.point_dips(then, way, candidate.radius, (least, moved))
                        .is_some_and(|turned| turned < least_cosine(number, index))
                })
        })
    }

    /// Whether a candidate would pass through an obstacle that moves from
    /// where it is here to where it is in `later`, while the robot's nodes
    /// move straight.
    pub fn motion_passes<N: Nodes + ?Sized>(&self, later: &Self, from: &N, to: &N) -> bool {
        let tolerance = ROUNDING * self.length;
        let moved = self.greatest_motion(from, to);
        let mut pairs = self.obstacles.iter().zip(&later.obstacles);
        pairs.any(|(now, then)| {
            let moved = moved + now.change(then);
            self.candidates.iter().any(|candidate| {
                let before = candidate.ends(from);
                let after = || candidate.ends(to);
                if candidate.is_point() {
                    let motion = || (before.0, after().0);
                    !now.is_beyond(before.0, candidate.radius + moved)
                        && now.point_passes(then, motion(), candidate.radius, moved)
                } else {
                    let after = after();
                    let ends = ((before.0, after.0), (before.1, after.1));
                    now.edge_passes(then, ends, tolerance, moved)
                }
            })
        })
    }

    /// What no point of a disk that may touch moves farther than between two
    /// shapes, in metres, and at most twice what some point does: twice the motion
    /// of its node or, if that is more, its lever times the change of the disk's
    /// direction.
    pub fn greatest_motion<N: Nodes + ?Sized>(&self, from: &N, to: &N) -> f64 {
        let half = |index: usize| {
            let (a, b) = (from.node(index), to.node(index));
            let moved = (b.position - a.position).norm_squared();
            moved.max(self.reach * self.reach * (b.disk - a.disk).norm_squared())
        };
        let count = from.count().min(to.count());
        2.0 * (0..count).map(half).fold(0.0, f64::max).sqrt()
    }
}
