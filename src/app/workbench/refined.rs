//! Whether what is found changes with the number of segments: the scene solved once more
//! from straight, with twice as many, where that is asked for.

use super::Workbench;
use crate::equilibrium::{Solution, Solved};
use crate::forces::Stiffness;
use crate::mechanics::Problem;
use crate::scene::{Candidates, Scene};
use crate::solving::{Task, TaskId};
use crate::units::{grams, millimetres};
use crate::view::Quantity;

/// The scene with twice the segments.
#[derive(Default)]
pub struct Refined {
    /// The scene that was asked of, with its own segments.
    of: Option<Scene>,
    asked: Option<(TaskId, Problem)>,
    solved: Option<Solved>,
    is_impossible: bool,
}

/// What is known of it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Refinement {
    /// Nothing was asked.
    Unknown,
    /// It is being solved.
    Solving,
    /// There can be no scene of as many segments.
    Impossible,
    /// How far tip and forces move, in a sentence.
    Known(String),
}

impl Refined {
    /// What is known, beside the live robot.
    pub fn told(&self, live: Option<&Solved>, stiffness: Option<Stiffness>) -> Refinement {
        if self.is_impossible {
            return Refinement::Impossible;
        }
        if self.asked.is_some() {
            return Refinement::Solving;
        }
        match (&self.solved, live) {
            (Some(finer), Some(live)) if !finer.nodes.is_empty() && !live.nodes.is_empty() => {
                Refinement::Known(compared(live, finer, stiffness))
            }
            _ => Refinement::Unknown,
        }
    }

    /// Whether a task was begun for it.
    pub(super) fn has_asked(&self, task: TaskId) -> bool {
        matches!(self.asked, Some((asked, _)) if asked == task)
    }

    pub(super) fn take(&mut self, task: TaskId, shape: Solution) {
        if let Some((_, problem)) = self.asked.take_if(|(asked, _)| *asked == task) {
            self.solved = Solved::pair(problem, shape);
        }
    }
}

/// How far tip and forces move, in a sentence.
fn compared(live: &Solved, finer: &Solved, stiffness: Option<Stiffness>) -> String {
    let moved = (live.tip().position - finer.tip().position).norm();
    let mut told = format!(
        "With n = {} the tip is {} away",
        finer.problem().robot().segments,
        Quantity::fixed(millimetres(moved), 3, "mm").text()
    );
    let force = |solved: &Solved, stiffness: Stiffness| {
        grams(stiffness.per_bend(solved.problem()) * solved.pressed())
    };
    if let Some(stiffness) = stiffness {
        let [here, there] = [live, finer].map(|solved| force(solved, stiffness));
        if here > 0.0 || there > 0.0 {
            let [here, there] = [here, there].map(|force| Quantity::significant(force, "g").text());
            told += &format!(", and obstacles take {there} instead of {here}");
        }
    }
    told + "."
}

impl Workbench {
    /// Asks how far tip and forces move with twice the segments.
    pub fn refine(&mut self) {
        self.refined = Refined::default();
        let mut scene = self.document.scene.clone();
        self.refined.of = Some(scene.clone());
        // Listed nodes would be others.
        let counted = scene.contact.candidates != Candidates::Listed;
        scene.robot.segments = scene.robot.segments.saturating_mul(2);
        scene.robot.segments_per_bay = scene.robot.segments_per_bay.saturating_mul(2);
        match Problem::new(&scene) {
            Ok(problem) if counted => {
                let task = Task::Shape {
                    problem: problem.clone(),
                };
                self.refined.asked = Some((self.begin(task), problem));
            }
            _ => self.refined.is_impossible = true,
        }
    }

    /// Forgets what was asked of another scene.
    pub(super) fn look_at_refined(&mut self) {
        let of = self.refined.of.as_ref();
        if of.is_some_and(|of| *of != self.document.scene) {
            if let Some((task, _)) = self.refined.asked.take() {
                self.cancel(task);
            }
            self.refined = Refined::default();
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use eframe::egui::Context;

    #[test]
    fn twice_the_segments_move_little_and_another_scene_forgets_it() {
        let text = include_str!("../../../assets/scenes/two-posts.toml");
        let mut bench = Workbench::with(Scene::from_toml(text).unwrap());
        let told = |bench: &Workbench| {
            let live = bench.live.solution();
            bench.refined.told(live, bench.document.stiffness())
        };
        bench.poll();
        assert_eq!(told(&bench), Refinement::Unknown);
        bench.refine();
        assert_eq!(told(&bench), Refinement::Solving);
        bench.poll();
        let Refinement::Known(words) = told(&bench) else {
            panic!("{:?}", told(&bench));
        };
        assert!(words.starts_with("With n = 36 the tip is 0."), "{words}");
        assert!(words.contains("obstacles take"), "{words}");
        bench.document.scene.set_pull_mm(5.0);
        bench.settle(&Context::default());
        assert_eq!(told(&bench), Refinement::Unknown);
    }
}
