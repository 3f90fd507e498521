//! The pull that brings the tip to a place.

use crate::app::workbench::Workbench;
use crate::explore::Path;
use crate::geometry::Vector;
use crate::units::metres;
use std::sync::Arc;

/// Pulls that are compared at first.
const COARSE: usize = 64;
/// Times a third of what is left between the best one's neighbours is cut off.
const FINE: usize = 40;

/// What tells the pull that belongs to a place of the tip, the same throughout
/// a drag.
#[derive(Clone, Debug)]
pub enum TipMap {
    /// The robot's own path among its obstacles.
    Path(Arc<Path>),
    /// The free robot's, while the path is not known.
    Free,
}

impl TipMap {
    /// The best map there is now.
    pub fn of(bench: &Workbench) -> Self {
        let live = &bench.live;
        let pull = metres(bench.pull_mm());
        let known = live.path().filter(|path| {
            let range = path.range();
            let covers = range.is_some_and(|(least, most)| (least..=most).contains(&pull));
            covers && live.path_is_current() && !live.is_on_another_branch()
        });
        known.map_or(Self::Free, |path| Self::Path(Arc::clone(path)))
    }

    /// The pull in metres, within the slider's span, that brings the tip
    /// nearest to a point in metres. The free robot's tip is elsewhere than one
    /// in contact: use it for differences.
    pub fn pull_for_tip(&self, bench: &Workbench, point: Vector) -> Option<f64> {
        let span = bench.span_mm();
        let span = (metres(span.0), metres(span.1));
        match self {
            Self::Path(path) => {
                let now = metres(bench.pull_mm());
                let pull = path.nearest_to_tip_from(point, now)?;
                Some(pull.clamp(span.0, span.1))
            }
            Self::Free => {
                let robot = bench.document.problem().robot();
                let (least, most) = robot.pull_range();
                let away = |pull: f64| (robot.free_arc(pull).tip.position - point).norm();
                nearest(away, (span.0.max(least), span.1.min(most)))
            }
        }
    }
}

/// Where the least of a function is that has one least value in reach of the
/// best of [`COARSE`] samples. `None` where it is nowhere finite.
fn nearest(away: impl Fn(f64) -> f64, (least, most): (f64, f64)) -> Option<f64> {
    let step = (most - least) / COARSE as f64;
    let samples = (0..=COARSE).map(|i| least + i as f64 * step);
    let samples = samples.filter(|pull| away(*pull).is_finite());
    let best = samples.min_by(|a, b| away(*a).total_cmp(&away(*b)))?;
    let (mut low, mut high) = ((best - step).max(least), (best + step).min(most));
    for _ in 0..FINE {
        let third = (high - low) / 3.0;
        if away(low + third) <= away(high - third) {
            high -= third;
        } else {
            low += third;
        }
    }
    Some(0.5 * (low + high))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mechanics::Problem;
    use crate::scene::Scene;

    #[test]
    fn the_nearest_pull_is_found_from_the_tip_it_leads_to() {
        let problem = Problem::new(&Scene::default()).unwrap();
        for pull in [0.0, 1e-3, 0.0049, 0.02, 0.025] {
            let tip_at = |pull: f64| problem.robot().free_arc(pull).tip.position;
            let tip = tip_at(pull);
            let away = |pull: f64| (tip_at(pull) - tip).norm();
            let found = nearest(away, (0.0, 0.025)).unwrap();
            assert!((found - pull).abs() < 1e-7, "{found} for {pull}");
        }
        assert_eq!(nearest(|_| f64::NAN, (0.0, 1.0)), None);
    }
}
