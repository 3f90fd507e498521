//! Undo and redo, a step for each gesture: whatever changes while a button is
//! held, a field is edited or the robot plays becomes one step when it ends.

use crate::scene::{Cable, Obstacle, Scene, Shape};
use std::collections::VecDeque;

/// What the steps that are kept may take, in bytes, about.
const MOST_BYTES: usize = 64 << 20;

/// The scenes before and after the present one.
#[derive(Clone, Debug)]
pub struct History {
    present: Scene,
    past: VecDeque<Scene>,
    future: Vec<Scene>,
    /// What the past takes.
    bytes: usize,
}

/// Whether the user is in the middle of something.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Gesture {
    /// A step is to be made only when it is over.
    Going,
    /// What has changed is a step.
    Over,
}

impl History {
    /// A history that begins with a scene.
    pub fn new(scene: &Scene) -> Self {
        Self {
            present: scene.clone(),
            past: VecDeque::new(),
            future: Vec::new(),
            bytes: 0,
        }
    }

    /// Looks at the scene once a frame and makes a step of what has changed.
    pub fn observe(&mut self, scene: &Scene, gesture: Gesture) {
        if gesture == Gesture::Going || *scene == self.present {
            return;
        }
        let before = std::mem::replace(&mut self.present, scene.clone());
        self.remember(before);
        while self.bytes > MOST_BYTES
            && let Some(oldest) = self.past.pop_front()
        {
            self.bytes -= size(&oldest);
        }
        self.future.clear();
    }

    fn remember(&mut self, before: Scene) {
        self.bytes += size(&before);
        self.past.push_back(before);
    }

    /// Whether there is a step to take back, given the scene as it is now: one
    /// in the middle of a gesture is itself to be taken back.
    pub fn can_undo(&self, scene: &Scene) -> bool {
        !self.past.is_empty() || *scene != self.present
    }

    /// Whether a step was taken back.
    pub fn can_redo(&self) -> bool {
        !self.future.is_empty()
    }

    /// Takes the last step back.
    pub fn undo(&mut self, scene: &mut Scene) {
        self.observe(scene, Gesture::Over);
        if let Some(before) = self.past.pop_back() {
            self.bytes -= size(&before);
            let after = std::mem::replace(&mut self.present, before);
            self.future.push(after);
            scene.clone_from(&self.present);
        }
    }

    /// Takes the last step again.
    pub fn redo(&mut self, scene: &mut Scene) {
        self.observe(scene, Gesture::Over);
        if let Some(after) = self.future.pop() {
            let before = std::mem::replace(&mut self.present, after);
            self.remember(before);
            scene.clone_from(&self.present);
        }
    }
}

/// What a scene takes, in bytes, about: what it is made of without bound.
fn size(scene: &Scene) -> usize {
    let points = scene
        .obstacles
        .iter()
        .map(|obstacle| match &obstacle.shape {
            Shape::Polygon { points_mm, .. } => points_mm.len(),
            _ => 0,
        });
    let measured = scene.measured.as_ref();
    let measured = measured.map_or(0, |held| held.points_mm.len() + held.forces.len());
    let points = points.sum::<usize>() + measured + scene.contact.listed.len();
    std::mem::size_of::<Scene>()
        + scene.cables.len() * std::mem::size_of::<Cable>()
        + scene.obstacles.len() * std::mem::size_of::<Obstacle>()
        + points * std::mem::size_of::<[f64; 2]>()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn pulled(pull_mm: f64) -> Scene {
        let mut scene = Scene::default();
        scene.set_pull_mm(pull_mm);
        scene
    }

    #[test]
    fn a_gesture_is_one_step() {
        let mut history = History::new(&pulled(0.0));
        for pull in 1..10 {
            history.observe(&pulled(f64::from(pull)), Gesture::Going);
        }
        history.observe(&pulled(9.0), Gesture::Over);
        history.observe(&pulled(12.0), Gesture::Over);
        let mut scene = pulled(12.0);
        history.undo(&mut scene);
        assert_eq!(scene, pulled(9.0));
        history.undo(&mut scene);
        assert_eq!(scene, pulled(0.0));
        assert!(!history.can_undo(&scene));
        history.redo(&mut scene);
        assert_eq!(scene, pulled(9.0));
        history.observe(&pulled(5.0), Gesture::Over);
        assert!(!history.can_redo());
    }

    #[test]
    fn undo_in_the_middle_of_a_gesture_takes_the_gesture_back() {
        let mut history = History::new(&pulled(0.0));
        let mut scene = pulled(3.0);
        history.observe(&scene, Gesture::Going);
        assert!(history.can_undo(&scene));
        history.undo(&mut scene);
        assert_eq!(scene, pulled(0.0));
        history.redo(&mut scene);
        assert_eq!(scene, pulled(3.0));
    }

    #[test]
    fn the_oldest_steps_of_large_scenes_are_forgotten() {
        let large = |pull| {
            let mut scene = pulled(pull);
            let disc = Shape::Disc {
                center_mm: [0.0; 2],
                radius_mm: 1.0,
            };
            scene.obstacles = vec![disc.into(); 1000];
            scene
        };
        let steps = MOST_BYTES / size(&large(0.0));
        let mut history = History::new(&large(0.0));
        for pull in 1..=steps + 10 {
            history.observe(&large(pull as f64), Gesture::Over);
        }
        let mut scene = large((steps + 10) as f64);
        while history.can_undo(&scene) {
            history.undo(&mut scene);
        }
        assert_eq!(scene, large(10.0));
        assert_eq!(history.bytes, 0);
    }
}
