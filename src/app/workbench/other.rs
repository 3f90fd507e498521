//! The scene in the other mechanics: what keeps it from being switched to, and its
//! shape where both are drawn.

use super::Workbench;
use crate::equilibrium::{Solution, Solved};
use crate::mechanics::Problem;
use crate::scene::{Drive, Mechanics, Scene, SceneError};
use crate::solving::{Task, TaskId};

/// The scene in the other mechanics.
#[derive(Default)]
pub struct Other {
    /// What it was made of.
    of: Option<Scene>,
    /// It, or what keeps it from being solved.
    scene: Option<Result<(Scene, Problem), Vec<SceneError>>>,
    /// What was asked of the solver and is not answered yet.
    asked: Option<(TaskId, Problem)>,
    /// The last answer.
    solved: Option<Solved>,
    /// Whether that is the answer for this scene.
    is_current: bool,
}

impl Other {
    /// What keeps the scene from being solved in the other mechanics; nothing where it
    /// can be.
    pub fn faults(&self) -> &[SceneError] {
        match &self.scene {
            Some(Err(faults)) => faults,
            _ => &[],
        }
    }

    /// Its shape: the last one known, perhaps of a moment ago.
    pub fn solved(&self) -> Option<&Solved> {
        self.solved.as_ref()
    }

    /// Whether [`Other::solved`] is the answer for the scene as it is.
    pub fn is_current(&self) -> bool {
        self.is_current
    }

    /// Takes the shape that a task has led to; nothing of one that was given up.
    pub(super) fn take(&mut self, task: TaskId, shape: Solution) {
        if let Some((_, problem)) = self.asked.take_if(|(asked, _)| *asked == task) {
            self.solved = Solved::pair(problem, shape);
        }
    }
}

/// The other one of the two mechanics.
fn other_than(mechanics: Mechanics) -> Mechanics {
    match mechanics {
        Mechanics::Sliding => Mechanics::Equal,
        Mechanics::Equal => Mechanics::Sliding,
    }
}

impl Workbench {
    /// Switches to the other mechanics, at the pulls that the cables have. Not where
    /// the scene cannot be solved in it: [`Other::faults`] says why.
    pub fn switch_mechanics(&mut self) {
        self.look_at_the_other();
        if let Some(Ok((scene, _))) = &self.other.scene {
            self.transport.stop();
            self.document.scene.clone_from(scene);
        }
    }

    /// The scene in the other mechanics, not checked.
    fn in_the_other(&self) -> Scene {
        let mut scene = self.document.scene.clone();
        scene.model.mechanics = other_than(scene.model.mechanics);
        if scene.model.mechanics == Mechanics::Equal {
            // The paper's model is asked for a pull.
            for cable in 0..scene.cable_count() {
                let drive = Drive::PullMm(self.pull_mm_of(cable));
                scene.set_drive(cable, drive);
            }
        }
        scene
    }

    /// Keeps up with the scene, and asks for the shape where both are drawn and the
    /// live one is there. Whether it asked.
    pub(super) fn look_at_the_other(&mut self) -> bool {
        let scene = self.in_the_other();
        if self.other.of.as_ref() != Some(&scene) {
            self.other.of = Some(scene.clone());
            self.other.scene = Some(Problem::parse(&scene).map(|problem| (scene, problem)));
            self.other.is_current = false;
        }
        let Some(Ok((_, problem))) = &self.other.scene else {
            self.other.solved = None;
            return false;
        };
        let idle = self.other.asked.is_none() && !self.live.is_waiting();
        if self.other.is_current || !idle || !self.preferences.compare {
            return false;
        }
        let problem = problem.clone();
        self.other.is_current = true;
        let task = Task::Shape {
            problem: problem.clone(),
        };
        let id = self.begin(task);
        self.other.asked = Some((id, problem));
        true
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mechanics::Model;

    fn scene(edit: impl FnOnce(&mut Scene)) -> Scene {
        let text = include_str!("../../../assets/scenes/two-posts.toml");
        let mut scene = Scene::from_toml(text).unwrap();
        edit(&mut scene);
        scene
    }

    fn settle(bench: &mut Workbench) {
        let ctx = eframe::egui::Context::default();
        bench.take_edits(&ctx);
        bench.poll();
    }

    #[test]
    fn the_switch_keeps_the_pull_and_leads_back() {
        let mut bench = Workbench::with(scene(|_| ()));
        settle(&mut bench);
        bench.switch_mechanics();
        settle(&mut bench);
        assert_eq!(bench.model(), Model::Equal);
        assert_eq!(bench.pull_mm(), 5.55);
        bench.switch_mechanics();
        settle(&mut bench);
        assert_eq!(bench.document.scene, scene(|_| ()));
        // A load becomes the pull that it leads to.
        bench.hold(0, crate::app::workbench::Held::Load);
        settle(&mut bench);
        assert!(bench.document.scene.cable(0).drive.pull_mm().is_none());
        bench.switch_mechanics();
        settle(&mut bench);
        assert!((bench.pull_mm() - 5.55).abs() < 1e-3, "{}", bench.pull_mm());
        assert_eq!(bench.model(), Model::Equal);
    }

    #[test]
    fn what_the_other_cannot_take_is_told_and_not_switched_to() {
        let with_force = scene(|scene| scene.loads.tip_force_n = [0.0, -0.1]);
        let mut bench = Workbench::with(with_force.clone());
        settle(&mut bench);
        let fields = bench.other.faults().iter().map(SceneError::field);
        assert_eq!(fields.collect::<Vec<_>>(), [Some("loads.tip_force_n")]);
        bench.switch_mechanics();
        settle(&mut bench);
        assert_eq!(bench.document.scene, with_force);
    }

    #[test]
    fn both_are_solved_where_both_are_drawn() {
        let mut bench = Workbench::with(scene(|_| ()));
        settle(&mut bench);
        bench.poll();
        assert!(bench.other.solved().is_none());
        bench.preferences.compare = true;
        bench.look_at_the_other();
        bench.poll();
        let other = bench.other.solved().unwrap();
        assert_eq!(other.problem().model(), Model::Equal);
        assert_eq!(other.pull, 5.55e-3);
        assert!(other.certificate.holds());
        // It follows.
        bench.document.scene.set_pull_mm(5.0);
        settle(&mut bench);
        bench.poll();
        assert_eq!(bench.other.solved().unwrap().pull, 5.0e-3);
        assert!(bench.other.is_current());
    }
}
