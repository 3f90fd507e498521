//! The scene being worked on, where it is kept, and whether it differs from
//! what is kept. It is always one that can be solved: see [`Document::settle`].

use crate::forces::Stiffness;
use crate::mechanics::Problem;
use crate::scene::{Scene, SceneError};
use crate::units::grams;
use crate::view::Quantity;
use std::path::PathBuf;

/// A scene with its file.
#[derive(Clone, Debug)]
pub struct Document {
    /// The scene. Panels and gestures change it freely; what they make of it
    /// counts once it is settled.
    pub scene: Scene,
    /// Where it was opened from or saved to.
    pub file: Option<PathBuf>,
    /// What the scene was when it was last opened or saved.
    kept: Scene,
    /// The last scene that can be solved, and its problem.
    sound: Scene,
    problem: Problem,
}

/// What settling a scene led to.
#[derive(Clone, Debug, PartialEq)]
pub enum Settled {
    /// The scene is as it was.
    Unchanged,
    /// The scene was changed to one that can be solved.
    Changed,
    /// The change was taken back, for these faults.
    Refused(Vec<SceneError>),
}

impl Document {
    /// A document of a scene that is nowhere kept.
    ///
    /// # Errors
    /// All of the scene's faults, at least one.
    pub fn new(scene: Scene) -> Result<Self, Vec<SceneError>> {
        let problem = Problem::parse(&scene)?;
        Ok(Self {
            kept: scene.clone(),
            sound: scene.clone(),
            scene,
            file: None,
            problem,
        })
    }

    /// What the scene was when it was last opened or saved.
    pub fn kept(&self) -> &Scene {
        &self.kept
    }

    /// Takes the scene as it has become or, if it cannot be solved, takes the
    /// last change back.
    pub fn settle(&mut self) -> Settled {
        if self.scene == self.sound {
            return Settled::Unchanged;
        }
        match Problem::parse(&self.scene) {
            Ok(problem) => {
                self.problem = problem;
                self.sound.clone_from(&self.scene);
                Settled::Changed
            }
            Err(faults) => {
                self.scene.clone_from(&self.sound);
                Settled::Refused(faults)
            }
        }
    }

    /// The problem of the last settled scene.
    pub fn problem(&self) -> &Problem {
        &self.problem
    }

    /// The backbone's stiffness, if the last settled scene gives it.
    pub fn stiffness(&self) -> Option<Stiffness> {
        Stiffness::of_scene(&self.sound).ok().flatten()
    }

    /// What a multiplier of 1 rad²/m amounts to, in newtons, where the
    /// stiffness is known.
    pub fn newtons_per_multiplier(&self) -> Option<f64> {
        Some(self.stiffness()?.per_bend(&self.problem))
    }

    /// The force of a multiplier, in rad²/m, as it is written; `None` where the
    /// stiffness is not known.
    pub fn force(&self, multiplier: f64) -> Option<Quantity> {
        let force = self.newtons_per_multiplier()? * multiplier;
        Some(Quantity::significant(grams(force), "g"))
    }

    /// Whether the scene differs from what is kept.
    pub fn is_changed(&self) -> bool {
        self.scene != self.kept
    }

    /// Whether something would be lost that cost work. Not where no file is
    /// concerned and only the cable was pulled: playing with an example is no
    /// work.
    pub fn holds_work(&self) -> bool {
        if self.file.is_some() {
            return self.is_changed();
        }
        let mut played = self.kept.clone();
        played.take_drives(&self.scene);
        self.scene != played
    }

    /// Notes that the scene is kept as it is.
    pub fn mark_kept(&mut self) {
        self.kept.clone_from(&self.scene);
    }

    /// Notes that this scene is kept, which may be an older one than the
    /// present.
    pub fn mark_kept_as(&mut self, scene: Scene) {
        self.kept = scene;
    }

    /// Notes that the scene is nowhere kept as it is.
    pub fn mark_unkept(&mut self) {
        self.kept.version = 0;
    }

    /// What the document is called: its title, its file's name or neither.
    pub fn name(&self) -> String {
        if let Some(title) = &self.scene.title {
            return title.clone();
        }
        let file = self.file.as_ref().and_then(|file| file.file_name());
        match file {
            Some(name) => name.to_string_lossy().into_owned(),
            None => "Untitled".to_owned(),
        }
    }
}
