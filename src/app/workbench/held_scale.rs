//! The scale that forces are drawn by: held while a hand is at work, so that arrows
//! grow and shrink as forces do, and changed in visible steps where it no longer fits.

use super::Workbench;
use crate::explore::{PathState, usual_end};
use crate::forces::Stiffness;
use crate::view::ForceScale;

/// A scale is for forces of which the greatest is at least this share of its end.
const LEAST: f64 = 0.2;
/// Room for greater forces that the path is to bring, over the present ones.
const ROOM: f64 = 1.2;

/// What is held.
#[derive(Clone, Copy, Debug, Default)]
pub struct HeldScale {
    /// The scale's end, in the unit that it is written in, and whether that is one of
    /// forces.
    end: Option<(f64, bool)>,
    /// The greatest multiplier that the path is to bring, and the path's revision.
    path: (u64, f64),
    /// Whether a hand is at work.
    pub(super) is_going: bool,
}

impl Workbench {
    /// Looks whether the scale fits what presses now, and returns it.
    pub(super) fn force_scale(&mut self) -> ForceScale {
        let stiffness = Stiffness::of_scene(&self.document.scene).ok().flatten();
        let solved = self.live.solved();
        let problem = solved.problem();
        let now = solved.contacts.iter().map(|contact| contact.multiplier);
        let now = now.fold(0.0, f64::max);
        let held = &mut self.held_scale;
        let revision = self.live.path_revision();
        if held.path.0 != revision {
            let greatest = |state: &PathState| {
                let all = state.contacts.iter().map(|contact| contact.multiplier);
                all.fold(0.0, f64::max)
            };
            let states = self.live.path().map_or(&[][..], |path| &path.states);
            held.path = (revision, usual_end(states.iter().map(greatest)));
        }
        let kept = held.end.filter(|(_, of)| *of == stiffness.is_some());
        let kept = kept.map(|(end, _)| ForceScale::ending(problem, stiffness, end));
        let fits = |scale: &ForceScale| {
            let small = now > 0.0 && scale.share(now) < LEAST && !held.is_going;
            scale.holds(now) && !small
        };
        let scale = match kept.filter(fits) {
            Some(scale) => scale,
            // A step further, and no more, under a hand.
            None if held.is_going => ForceScale::above(problem, stiffness, now),
            None => {
                let room = held.path.1.min(ROOM * now);
                ForceScale::above(problem, stiffness, now.max(room))
            }
        };
        // Before anything has pressed there is nothing to be held.
        if now > 0.0 || kept.is_some() {
            held.end = Some((scale.end(), stiffness.is_some()));
        }
        scale
    }
}

#[cfg(test)]
mod tests {
    use crate::app::workbench::{Playing, Workbench};
    use crate::scene::Scene;
    use crate::view::{Geometry, Role};
    use eframe::egui::Context;

    fn pull(bench: &mut Workbench, pull_mm: f64) {
        bench.set_pull(pull_mm, Playing::Stops);
        bench.take_edits(&Context::default());
        bench.poll();
    }

    /// The longest arrow, in metres, and the greatest multiplier.
    fn longest(bench: &Workbench) -> (f64, f64) {
        let marks = bench.live.drawing().marks.iter();
        let arrows = marks.filter_map(|mark| match (mark.role, &mark.geometry) {
            (Role::Force(_), Geometry::Arrow { tail, tip }) => Some((tip - tail).norm()),
            _ => None,
        });
        let contacts = bench.live.solution().unwrap().contacts.iter();
        let most = contacts.map(|contact| contact.multiplier);
        (arrows.fold(0.0, f64::max), most.fold(0.0, f64::max))
    }

    #[test]
    fn under_a_hand_arrows_grow_as_forces_do_and_the_scale_steps_only_up() {
        let text = include_str!("../../../assets/scenes/two-posts.toml");
        let mut bench = Workbench::with(Scene::from_toml(text).unwrap());
        bench.poll();
        bench.held_scale.is_going = true;
        let end = |bench: &Workbench| bench.live.drawing().scale.end();
        let mut ends = vec![end(&bench)];
        for pull_mm in [6.5, 8.0, 9.5, 11.0] {
            pull(&mut bench, pull_mm);
            ends.push(end(&bench));
        }
        assert!(ends.windows(2).all(|pair| pair[0] <= pair[1]), "{ends:?}");
        assert!(ends[4] > ends[0], "{ends:?}");
        // On the way back nothing changes but the arrows, as the forces do.
        let (long, most) = longest(&bench);
        assert!(long > 0.0);
        for pull_mm in [9.5, 8.0, 6.5, 5.55] {
            pull(&mut bench, pull_mm);
            assert_eq!(end(&bench), ends[4]);
            let (other, force) = longest(&bench);
            let off = other / long - force / most;
            assert!(force > 0.0 && off.abs() < 1e-9, "{pull_mm}: {off}");
        }
    }
}
