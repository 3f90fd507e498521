//! The robot along its pull in what the scene does not assume: the paper's model, and the
//! sliding cable without friction. The force's plot draws them beside each other. They
//! are followed in the pauses of live work, while that plot is shown.

use super::{Workbench, pull};
use crate::explore::Path;
use crate::mechanics::{Model, Problem};
use crate::scene::{Drive, Friction, Mechanics, Scene};
use crate::solving::{Task, TaskId};
use std::sync::Arc;

/// What a force is computed from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Assumed {
    /// Every segment of the cable shortens alike: the paper's multipliers.
    Equal,
    /// The cable slides, and nothing rubs.
    Sliding,
    /// The cable slides, and rubs as the scene says.
    Rubbing,
}

impl Assumed {
    /// What a problem assumes.
    pub fn of(problem: &Problem) -> Self {
        match problem.model() {
            Model::Equal => Assumed::Equal,
            Model::Sliding if problem.drive().friction.is_none() => Assumed::Sliding,
            Model::Sliding => Assumed::Rubbing,
        }
    }

    /// The scene in what is assumed, at no pull and without its looks; `None` for
    /// friction, which no scene but its own knows.
    fn scene(self, scene: &Scene) -> Option<Scene> {
        let mut scene = scene.clone();
        (scene.title, scene.photo, scene.measured) = (None, None, None);
        scene.friction = Friction::default();
        scene.model.mechanics = match self {
            Assumed::Equal => Mechanics::Equal,
            Assumed::Sliding => Mechanics::Sliding,
            Assumed::Rubbing => return None,
        };
        scene.set_drive(0, Drive::PullMm(0.0));
        Some(scene)
    }
}

/// A robot followed along its pull.
#[derive(Clone, Debug)]
pub struct Followed {
    /// What it assumes.
    pub assumed: Assumed,
    /// The robot and its obstacles, at no pull.
    pub problem: Problem,
    /// What it does.
    pub path: Arc<Path>,
}

/// The other models along the pull.
#[derive(Default)]
pub struct Models {
    /// Whether a part of the window shows them in this frame.
    pub wanted: bool,
    /// What they were made of: a scene for each.
    of: Vec<(Assumed, Scene)>,
    /// Those still to be asked for, the next one last.
    to_ask: Vec<Assumed>,
    asked: Option<(TaskId, Assumed, Problem)>,
    followed: Vec<Followed>,
    revision: u64,
}

impl Models {
    /// Those that are known, perhaps of a moment ago.
    pub fn followed(&self) -> &[Followed] {
        &self.followed
    }

    /// Counts the changes of [`Models::followed`].
    pub fn revision(&self) -> u64 {
        self.revision
    }

    /// Whether a task was begun for them.
    pub(super) fn has_asked(&self, task: TaskId) -> bool {
        matches!(self.asked, Some((asked, ..)) if asked == task)
    }

    /// Takes the path that a task has led to; nothing of one that was given up.
    pub(super) fn take(&mut self, task: TaskId, path: Path) {
        let Some((_, assumed, problem)) = self.asked.take_if(|(asked, ..)| *asked == task) else {
            return;
        };
        self.followed.retain(|it| it.assumed != assumed);
        if path.range().is_some() {
            self.followed.push(Followed {
                assumed,
                problem,
                path: Arc::new(path),
            });
        }
        self.revision += 1;
    }
}

impl Workbench {
    /// Keeps up with the scene where the other models are wanted. Whether it asked.
    pub(super) fn look_at_models(&mut self) -> bool {
        let known = self.document.stiffness().is_some();
        if !std::mem::take(&mut self.models.wanted) || !known {
            return false;
        }
        let own = Assumed::of(self.document.problem());
        let scene = &self.document.scene;
        let others = [Assumed::Sliding, Assumed::Equal].into_iter();
        let others = others.filter(|assumed| *assumed != own);
        let of: Vec<_> = others
            .filter_map(|assumed| Some((assumed, assumed.scene(scene)?)))
            .collect();
        if self.models.of != of {
            // The other cables have gone, or the paper's model cannot take what came.
            let known = |it: &Followed| of.iter().any(|(assumed, _)| *assumed == it.assumed);
            self.models.followed.retain(known);
            self.models.to_ask = of.iter().rev().map(|(assumed, _)| *assumed).collect();
            self.models.of = of;
            self.models.revision += 1;
            if let Some((task, ..)) = self.models.asked.take() {
                self.cancel(task);
            }
        }
        if self.live.is_waiting() || self.models.asked.is_some() {
            return false;
        }
        while let Some(assumed) = self.models.to_ask.pop() {
            let mut of = self.models.of.iter();
            let scene = of.find(|(one, _)| *one == assumed).map(|(_, scene)| scene);
            match scene.map(Problem::new) {
                Some(Ok(problem)) => {
                    let task = Task::Path {
                        problem: problem.clone(),
                        span: pull::span(&self.document),
                    };
                    self.models.asked = Some((self.begin(task), assumed, problem));
                    return true;
                }
                // Not a scene of this model's.
                _ => self.models.followed.retain(|it| it.assumed != assumed),
            }
        }
        false
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use eframe::egui::Context;

    fn assumed(bench: &Workbench) -> Vec<Assumed> {
        let followed = bench.models.followed().iter();
        let mut all: Vec<_> = followed.map(|it| it.assumed).collect();
        all.sort_by_key(|it| *it as u8);
        all
    }

    /// Frames in which the plot is shown, until nothing more comes.
    fn shown(bench: &mut Workbench) {
        for _ in 0..4 {
            bench.models.wanted = true;
            bench.settle(&Context::default());
            bench.poll();
        }
    }

    #[test]
    fn the_others_are_followed_while_they_are_shown() {
        let text = include_str!("../../../assets/scenes/two-posts.toml");
        let mut bench = Workbench::with(Scene::from_toml(text).unwrap());
        bench.poll();
        bench.settle(&Context::default());
        assert!(bench.models.followed().is_empty());
        shown(&mut bench);
        assert_eq!(assumed(&bench), [Assumed::Equal]);
        // With friction, the cable that slides freely, too.
        bench.document.scene.friction.holes = 0.275;
        shown(&mut bench);
        assert_eq!(assumed(&bench), [Assumed::Equal, Assumed::Sliding]);
        let mut followed = bench.models.followed().iter();
        let free = followed.find(|it| it.assumed == Assumed::Sliding).unwrap();
        let free = free.path.at(5.55e-3).unwrap().load();
        let rubs = bench.live.solution().unwrap().cables[0].load;
        assert!(rubs > 1.02 * free, "{rubs} {free}");
        // In the paper's model, the sliding cable alone.
        bench.document.scene.friction.holes = 0.0;
        bench.switch_mechanics();
        shown(&mut bench);
        assert_eq!(assumed(&bench), [Assumed::Sliding]);
        // What a model cannot take has no curve.
        bench.switch_mechanics();
        bench.document.scene.loads.tip_force_n = [0.0, -0.1];
        shown(&mut bench);
        assert_eq!(assumed(&bench), []);
    }
}
