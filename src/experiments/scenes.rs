//! The paper's scenes, as they are in `assets/scenes`.

use super::ExperimentError;
use super::item::Picture;
use crate::equilibrium::{Settings, Solved, Start, Status, solve};
use crate::forces::SweepError;
use crate::mechanics::Problem;
use crate::scene::{Scene, Shape};
use crate::units::metres;

/// A scene that the paper describes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PaperScene {
    /// Nothing around the robot.
    Free,
    /// The post of Fig. 4a.
    OneDisc,
    /// The posts of Fig. 4b.
    TwoDiscs,
    /// The load cell of Fig. 8 and 9.
    LoadCell,
}

impl PaperScene {
    /// The scene, as its file says.
    ///
    /// # Errors
    /// None: the files are part of the program and tested.
    pub fn scene(self) -> Result<Scene, ExperimentError> {
        let text = match self {
            PaperScene::Free => include_str!("../../assets/scenes/free.toml"),
            PaperScene::OneDisc => include_str!("../../assets/scenes/one-disc.toml"),
            PaperScene::TwoDiscs => include_str!("../../assets/scenes/two-discs.toml"),
            PaperScene::LoadCell => include_str!("../../assets/scenes/load-cell.toml"),
        };
        Ok(Scene::from_toml(text)?)
    }

    /// The scene with its problem.
    pub(super) fn problem(self) -> Result<(Scene, Problem), ExperimentError> {
        let scene = self.scene()?;
        let problem = Problem::new(&scene)?;
        Ok((scene, problem))
    }

    /// The load cell's problem with its surface at a distance from the straight
    /// backbone, in metres.
    pub(super) fn load_cell_at(distance: f64) -> Result<Problem, ExperimentError> {
        let mut scene = PaperScene::LoadCell.scene()?;
        for obstacle in &mut scene.obstacles {
            if let Shape::Wall { point_mm, .. } = &mut obstacle.shape {
                point_mm[0] = crate::units::millimetres(distance);
            }
        }
        Ok(Problem::new(&scene)?)
    }
}

/// The equilibrium at a pull, in mm, from the straight robot.
pub(super) fn solved_at(problem: &Problem, pull_mm: f64) -> Result<Solved, ExperimentError> {
    let mut there = problem.clone();
    there.set_pull(metres(pull_mm));
    let solved = solve(&there, Start::Straight, Settings::default());
    if solved.status == Status::Converged {
        Ok(solved)
    } else {
        let (pull, status) = (solved.pull, solved.status.clone());
        Err(SweepError::NotReached { pull, status }.into())
    }
}

/// A picture of a scene at a pull.
pub(super) fn picture(word: &'static str, scene: &Scene, solved: Solved) -> Picture {
    let pull_mm = crate::units::millimetres(solved.pull);
    Picture {
        title: format!("At a pull of {pull_mm:.2} mm"),
        word,
        names: scene.obstacles.iter().map(|o| o.name.clone()).collect(),
        solved,
    }
}
