//! How the cables were loaded: the pull and the load of every cable in every shape
//! since the robot last started or was last another, in the order in which a hand
//! went through them.

use super::live::Live;
use crate::equilibrium::Occurrence;
use crate::mechanics::Problem;

/// Steps that are kept.
const MOST: usize = 4000;
/// A cable has moved on once its pull has, by so much of the backbone's length, or
/// its load, by so much of its greatest: less than half a pixel of a plot.
const PULL_APART: f64 = 1e-5;
const LOAD_APART: f64 = 1e-3;

/// A cable in one shape.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Loaded {
    /// The length drawn in, in metres.
    pub pull: f64,
    /// What hangs on it or would hold it, without its stiffness, in rad²/m.
    pub load: f64,
}

/// A shape on the way.
#[derive(Clone, Debug, PartialEq)]
pub struct Step {
    /// The cables, in the order of the scene.
    pub cables: Vec<Loaded>,
    /// Whether the robot jumped to it.
    pub is_leap: bool,
}

/// How the cables were loaded, for as long as the robot and what is around it stay as
/// they are.
#[derive(Clone, Debug, Default)]
pub struct LoadTrace {
    of: Option<Problem>,
    steps: Vec<Step>,
}

impl LoadTrace {
    /// The shapes, the last one last.
    pub fn steps(&self) -> &[Step] {
        &self.steps
    }

    /// Begins anew.
    pub fn clear(&mut self) {
        self.of = None;
        self.steps.clear();
    }

    /// Adds a new shape.
    pub(super) fn follow(&mut self, live: &Live) {
        let Some(solved) = live.solution().filter(|_| live.is_settled()) else {
            return;
        };
        if solved.nodes.is_empty() {
            return;
        }
        let problem = solved.problem();
        let same = self
            .of
            .as_ref()
            .is_some_and(|of| of.same_but_for_pull(problem));
        if !same {
            self.steps.clear();
            self.of = Some(problem.clone());
        }
        let cables = solved.cables.iter().map(|state| Loaded {
            pull: state.pull,
            load: state.load,
        });
        let leaps =
            |event: &crate::equilibrium::Event| matches!(event.what, Occurrence::Jump { .. });
        let step = Step {
            cables: cables.collect(),
            is_leap: !self.steps.is_empty() && solved.events.iter().any(leaps),
        };
        let grain = PULL_APART * problem.length();
        if self
            .steps
            .last()
            .is_none_or(|last| step.is_apart_from(last, grain))
        {
            self.steps.push(step);
        }
        if self.steps.len() > MOST {
            self.steps.drain(..MOST / 2);
        }
    }
}

impl Step {
    fn is_apart_from(&self, last: &Step, grain: f64) -> bool {
        let moved = |(a, b): (&Loaded, &Loaded)| {
            let load = a.load.abs().max(b.load.abs());
            (a.pull - b.pull).abs() > grain || (a.load - b.load).abs() > LOAD_APART * load
        };
        self.cables.len() != last.cables.len() || self.cables.iter().zip(&last.cables).any(moved)
    }
}

#[cfg(test)]
mod tests {
    use crate::app::workbench::{Playing, Workbench};
    use crate::scene::Scene;
    use crate::units::metres;
    use eframe::egui::Context;

    fn bench() -> Workbench {
        let text = include_str!("../../../assets/scenes/two-posts.toml");
        let mut bench = Workbench::with(Scene::from_toml(text).unwrap());
        bench.poll();
        bench
    }

    fn pull(bench: &mut Workbench, pull_mm: f64) {
        bench.set_pull(pull_mm, Playing::Stops);
        bench.take_edits(&Context::default());
        bench.poll();
    }

    #[test]
    fn there_and_back_without_friction_is_one_curve() {
        let mut bench = bench();
        for pull_mm in [5.0, 5.2, 5.4, 5.2, 5.0] {
            pull(&mut bench, pull_mm);
        }
        let steps = bench.load_trace.steps();
        let pulls: Vec<f64> = steps.iter().map(|step| step.cables[0].pull).collect();
        assert_eq!(pulls, [5.55, 5.0, 5.2, 5.4, 5.2, 5.0].map(metres));
        for (there, back) in [(1, 5), (2, 4)] {
            let [a, b] = [there, back].map(|at: usize| steps[at].cables[0].load);
            assert!((a - b).abs() < 1e-6 * a, "{a} {b}");
        }
        assert!(steps[3].cables[0].load > 1.02 * steps[2].cables[0].load);
        // Nothing more where nothing has moved.
        bench.poll();
        assert_eq!(bench.load_trace.steps().len(), 6);
    }

    #[test]
    fn another_robot_or_a_new_start_begins_anew() {
        let mut bench = bench();
        pull(&mut bench, 5.0);
        assert_eq!(bench.load_trace.steps().len(), 2);
        bench.restart();
        bench.poll();
        assert_eq!(bench.load_trace.steps().len(), 1);
        pull(&mut bench, 5.2);
        let obstacle = &mut bench.document.scene.obstacles[0];
        obstacle.shape.move_to_mm([33.0, 88.5]);
        pull(&mut bench, 5.2);
        assert_eq!(bench.load_trace.steps().len(), 1);
    }
}
