//! The path along a cable that is not the first: what happens while it is drawn in
//! and all others keep what is held of them. It is followed in the pauses of live
//! work, while that cable is the one that is set.

use super::{Loads, Workbench};
use crate::explore::Path;
use crate::mechanics::Problem;
use crate::scene::{Drive, Scene};
use crate::solving::{Task, TaskId};
use crate::units::{metres, millimetres};
use std::sync::Arc;

/// A mark that is so near in pull, in mm, is where the robot is.
const SAME_MM: f64 = 1e-3;

/// A way along a path.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Way {
    /// Towards greater pulls.
    Up,
    /// Towards smaller ones.
    Down,
}

/// The path along the cable that is set.
#[derive(Default)]
pub struct Along {
    /// The scene with that cable as the first, at no pull.
    of: Option<Scene>,
    asked: Option<TaskId>,
    path: Option<Arc<Path>>,
    /// Whether the path is that of the scene.
    is_current: bool,
}

impl Along {
    /// The path, perhaps of a moment ago; `None` while the first cable is set, whose
    /// path is the live one.
    pub fn path(&self) -> Option<&Arc<Path>> {
        self.path.as_ref()
    }

    /// Whether the path is that of the scene as it is.
    pub fn is_current(&self) -> bool {
        self.is_current && self.asked.is_none()
    }

    /// Takes the path that a task has led to; nothing of one that was given up.
    pub(super) fn take(&mut self, task: TaskId, path: Path) {
        if self.asked.take_if(|asked| *asked == task).is_some() {
            self.path = Some(Arc::new(path));
        }
    }
}

/// A scene with one of its cables as the first, at no pull, and no looks.
fn along(scene: &Scene, cable: usize) -> Scene {
    let mut scene = scene.clone();
    scene.cables.swap(0, cable);
    scene.set_drive(0, Drive::PullMm(0.0));
    (scene.title, scene.photo, scene.measured) = (None, None, None);
    scene
}

impl Workbench {
    /// Keeps up with the scene and with which cable is set. Whether it asked.
    pub(super) fn look_along(&mut self) -> bool {
        let cable = self.cable();
        if cable == 0 || cable >= self.document.scene.cables.len() {
            if let Some(task) = self.along.asked.take() {
                self.cancel(task);
            }
            self.along = Along::default();
            return false;
        }
        let scene = along(&self.document.scene, cable);
        if self.along.of.as_ref() != Some(&scene) {
            self.along.of = Some(scene);
            self.along.is_current = false;
        }
        if self.along.is_current || self.live.is_waiting() {
            return false;
        }
        self.along.is_current = true;
        if let Some(task) = self.along.asked.take() {
            self.cancel(task);
        }
        let problem = self.along.of.as_ref().map(Problem::new);
        let Some(Ok(problem)) = problem else {
            self.along.path = None;
            return false;
        };
        let (first, last) = self.span_mm_of(cable);
        let task = Task::Path {
            problem,
            span: (metres(first), metres(last)),
        };
        self.along.asked = Some(self.begin(task));
        true
    }

    /// The path along the cable that is set, and whether it is that of the scene as it
    /// is.
    pub fn path_along(&self) -> Option<(Arc<Path>, bool)> {
        match self.cable() {
            0 => {
                let path = Arc::clone(self.live.path()?);
                Some((path, self.live.path_is_current()))
            }
            _ => {
                let path = Arc::clone(self.along.path()?);
                Some((path, self.along.is_current()))
            }
        }
    }

    /// Brings the cable that is set to the next mark of its path, if there is one.
    pub fn go_to_mark(&mut self, way: Way) {
        let Some((path, _)) = self.path_along() else {
            return;
        };
        let now = self.pull_mm_of(self.cable());
        let marks = path.events.iter().map(|event| millimetres(event.pull));
        let next = match way {
            Way::Up => marks.filter(|mark| *mark > now + SAME_MM).reduce(f64::min),
            Way::Down => marks.filter(|mark| *mark < now - SAME_MM).reduce(f64::max),
        };
        if let Some(mark) = next {
            self.transport.stop();
            self.go_along(mark);
        }
    }

    /// The loads in the place of the pulls of the cable that is set; `None` where the
    /// stiffness is not known, or the path not yet.
    pub fn loads_along(&self) -> Option<Loads> {
        match self.cable() {
            0 => self.loads(),
            _ => {
                let newtons = self.document.newtons_per_multiplier()?;
                Loads::on(Arc::clone(self.along.path()?), newtons)
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::equilibrium::Occurrence;
    use eframe::egui::Context;

    #[test]
    fn the_second_cable_has_a_path_of_its_own_while_it_is_set() {
        let text = include_str!("../../../assets/scenes/two-posts.toml");
        let mut scene = Scene::from_toml(text).unwrap();
        let first = scene.cable(0);
        scene.robot.cable_offset_mm = None;
        scene.robot.cable_diameter_mm = 0.0;
        scene.actuation = None;
        let post = scene.obstacles[0].clone();
        // A post on the other side, which only the second cable bends the robot to.
        let mut mirrored = post.shape.clone();
        mirrored.move_to_mm([-45.0, 140.0]);
        scene.obstacles = vec![mirrored.into()];
        scene.cables = vec![first, first];
        scene.cables[0].drive = Drive::LoadG(20.0);
        scene.cables[1].offset_mm = -8.0;
        scene.cables[1].drive = Drive::PullMm(1.0);
        let mut bench = Workbench::with(scene);
        let ctx = Context::default();
        let frame = |bench: &mut Workbench| {
            bench.take_edits(&ctx);
            bench.poll();
            bench.settle(&ctx);
            bench.poll();
        };
        frame(&mut bench);
        assert!(bench.along.path().is_none());
        let made = |path: &Path| {
            let mut events = path.events.iter();
            events.any(|event| {
                event.pull > 0.0 && matches!(event.what, Occurrence::ContactMade { .. })
            })
        };
        assert!(!made(bench.live.path().unwrap()));
        bench.transport.cable = 1;
        frame(&mut bench);
        let (path, current) = bench.path_along().unwrap();
        assert!(current && made(&path));
        // At the pull that it has it is the robot that is shown.
        let here = path.at(1e-3).unwrap();
        let tip = bench.live.solution().unwrap().tip();
        assert!((here.tip.position - tip.position).norm() < 1e-5);
        assert!(bench.loads_along().is_some());
        bench.transport.cable = 0;
        frame(&mut bench);
        assert!(bench.along.path().is_none());
    }
}
