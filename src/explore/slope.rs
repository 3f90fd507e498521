//! Which pull a load on the cable amounts to. Without friction the load holds the shape
//! whose energy rises with the pull as steeply as the load pulls, T = (EI/2l_0) dJ/dl;
//! with friction it takes more.

use super::path::{Path, PathState};

impl Path {
    /// The pull, in metres, at which the first cable first needs `load`, in rad²/m: the
    /// shape that a robot takes whose load grows slowly from nothing. Straight
    /// between the path's states; where the robot jumps to a shape that needs
    /// more, the pull of the jump. `None` where no state needs as much.
    pub fn pull_at_load(&self, load: f64) -> Option<f64> {
        let after = self.states.iter().position(|it| it.load() >= load)?;
        let b = &self.states[after];
        let before = after.checked_sub(1).map(|index| &self.states[index]);
        let Some(a) = before.filter(|a| a.branch == b.branch) else {
            return Some(b.pull);
        };
        let share = (load - a.load()) / (b.load() - a.load());
        Some(a.pull + share * (b.pull - a.pull))
    }

    /// A load that few states exceed, in rad²/m: see [`usual_end`].
    pub fn usual_load(&self) -> f64 {
        usual_end(self.states.iter().map(PathState::load))
    }
}

/// Where a scale of these values is to end: at the greatest of them or, where a
/// few are far greater than all others, at twice what three quarters of them do
/// not exceed. Loads grow without bound where a branch ends. 0 where none is
/// positive.
pub fn usual_end(values: impl Iterator<Item = f64>) -> f64 {
    let mut values: Vec<f64> = values.filter(|value| *value > 0.0).collect();
    values.sort_by(f64::total_cmp);
    let quartile = values.get(values.len() * 3 / 4).copied();
    let greatest = values.last().copied().unwrap_or(0.0);
    quartile.map_or(0.0, |quartile| greatest.min(2.0 * quartile))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::explore::PathRun;
    use crate::mechanics::Problem;
    use crate::scene::{Mechanics, Scene};

    #[test]
    fn a_scale_ends_at_the_greatest_value_unless_few_are_far_beyond() {
        let up_to = |n: u32| (1..=n).map(f64::from);
        assert_eq!(usual_end(up_to(8)), 8.0);
        assert_eq!(usual_end(up_to(8).chain([1e6])), 14.0);
        assert_eq!(usual_end([-1.0, 0.0].into_iter()), 0.0);
        assert_eq!(usual_end(std::iter::empty()), 0.0);
    }

    #[test]
    fn pull_and_load_lead_to_each_other() {
        let problem = Problem::new(&Scene::default()).unwrap();
        let mut run = PathRun::over(&problem, 0.0, 0.010, 41);
        run.advance(usize::MAX);
        let path = run.finish();
        for pull in [0.0, 0.00123, 0.0075, 0.010] {
            let load = path.at(pull).unwrap().load();
            let back = path.pull_at_load(load).unwrap();
            assert!((back - pull).abs() < 1e-12, "{pull} {back}");
        }
        let end = path.at(0.010).unwrap().load();
        assert_eq!(path.pull_at_load(1.001 * end), None);
        assert_eq!(path.pull_at_load(-1.0), Some(0.0));
    }

    #[test]
    fn a_cable_that_rubs_needs_more_load_than_its_first_stretch_has() {
        let mut scene = Scene::default();
        scene.model.mechanics = Mechanics::Sliding;
        scene.robot.bending_stiffness_nmm2 = Some(8000.0);
        scene.friction.holes = 0.275;
        scene.friction.base_loss = 0.165;
        let problem = Problem::new(&scene).unwrap();
        let mut run = PathRun::over(&problem, 0.0, 0.010, 41);
        run.advance(usize::MAX);
        let path = run.finish();
        let state = path.at(0.010).unwrap();
        // Below the base, and a little where the cable turns in the base's hole.
        let kept = (1.0 - scene.friction.base_loss) * state.load();
        assert!(state.energy_slope < kept && state.energy_slope > 0.95 * kept);
        let back = path.pull_at_load(state.load()).unwrap();
        assert!((back - 0.010).abs() < 1e-12, "{back}");
    }
}
