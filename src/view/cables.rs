//! Cables as lines: straight from hole to hole where they are tense, and sagging
//! between the disks where they hang loose.

use super::path::Path;
use crate::equilibrium::Solved;
use crate::geometry::Vector;
use crate::mechanics::{Input, Model};

/// The sag of a loose stretch, over its length: what is drawn at least, so that it is
/// seen, and at most, so that it stays beside its bay.
const SAG: [f64; 2] = [0.12, 0.4];
/// Chords of a loose stretch.
const CHORDS: usize = 8;

/// The line of a cable, and whether it hangs loose; `None` without a shape.
pub(super) fn line(solved: &Solved, index: usize) -> Option<(Path, bool)> {
    let slides = solved.problem().model() == Model::Sliding;
    let is_slack = slides && solved.cables.get(index).is_some_and(|cable| cable.is_slack);
    let points = match (slides, is_slack) {
        (false, _) => solved.cable_points(index),
        (true, false) => solved.holes(index),
        (true, true) => sagging(solved, index),
    };
    let path = Path::through(points).filter(|path| !path.pieces.is_empty())?;
    Some((path, is_slack))
}

/// Parabolas away from the backbone, whose sag takes up what the cable is too long by.
fn sagging(solved: &Solved, index: usize) -> Vec<Vector> {
    let driven = &solved.problem().drive().cables[index];
    let robot = solved.problem().robot();
    let holes = solved.holes(index);
    let bay = robot.segment_length() * robot.segments_per_bay as f64;
    let lengths: f64 = holes
        .windows(2)
        .map(|pair| (pair[1] - pair[0]).norm())
        .sum();
    let stretches = (holes.len() - 1) as f64;
    let spare = match driven.input {
        Input::Pull(pull) => bay * stretches - pull - lengths,
        Input::Load(_) => 0.0,
    };
    let side = driven.cable.offset.signum();
    let mut points = vec![holes[0]];
    for (k, pair) in holes.windows(2).enumerate() {
        let along = pair[1] - pair[0];
        // Of a flat parabola of length s over a chord c: s ≈ c + 8 h²/3c.
        let share = (spare / stretches / along.norm()).max(0.0);
        let sag = (0.375 * share).sqrt().clamp(SAG[0], SAG[1]) * along.norm();
        let disks = [k, k + 1].map(|disk| solved.nodes[disk * robot.segments_per_bay].disk);
        let outwards = side * (disks[0] + disks[1]).normalize();
        points.extend((1..=CHORDS).map(|i| {
            let at = i as f64 / CHORDS as f64;
            pair[0] + at * along + 4.0 * at * (1.0 - at) * sag * outwards
        }));
    }
    points
}
