//! What there is to plot, and what a hand on a plot asks for: plain data, with
//! no pane and no picture.

use crate::app::workbench::{Followed, Hovered, Pin, Step};
use crate::equilibrium::Solved;
use crate::explore::Path;
use crate::forces::{Stiffness, Window};
use crate::math::within;
use crate::mechanics::Problem;
use crate::scene::{ForceReading, Scene};
use crate::view::ForceScale;

/// A plot of the dock.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, serde::Serialize, serde::Deserialize)]
pub enum Plot {
    /// Multipliers by node, the paper's Fig. 5.
    Multipliers,
    /// The tip over the pull, Fig. 7.
    Tip,
    /// Force over load, Fig. 10.
    Force,
    /// Energy and events over the pull.
    Energy,
    /// Bends and shears by segment.
    Bends,
    /// The cables' tension, stretch by stretch.
    Tension,
    /// A cable's load over its pull, as a hand went.
    Load,
}

impl Plot {
    /// All of them, in the order of the dock.
    pub const ALL: [Plot; 7] = [
        Plot::Multipliers,
        Plot::Tip,
        Plot::Force,
        Plot::Energy,
        Plot::Bends,
        Plot::Tension,
        Plot::Load,
    ];

    /// Its name on its tab.
    pub fn title(self) -> &'static str {
        match self {
            Plot::Multipliers => "Multipliers",
            Plot::Tip => "Tip",
            Plot::Force => "Force",
            Plot::Energy => "Energy",
            Plot::Bends => "Bends",
            Plot::Tension => "Tension",
            Plot::Load => "Load over pull",
        }
    }

    /// Its word in files' names.
    pub fn word(self) -> &'static str {
        match self {
            Plot::Multipliers => "multipliers",
            Plot::Tip => "tip",
            Plot::Force => "force",
            Plot::Energy => "energy",
            Plot::Bends => "bends",
            Plot::Tension => "tension",
            Plot::Load => "load",
        }
    }
}

/// What there is to plot.
#[derive(Clone, Copy)]
pub struct PlotData<'a> {
    /// The scene: names, the stiffness, readings.
    pub scene: &'a Scene,
    /// The problem that was asked for last.
    pub asked: &'a Problem,
    /// The robot as it is known; without nodes where it is not yet.
    pub solved: &'a Solved,
    /// The robot along its pull, as far as it is known.
    pub path: Option<&'a Path>,
    /// The first cable's path in other models, for the force's plot.
    pub models: &'a [Followed],
    /// Changes whenever these do.
    pub models_generation: u64,
    /// Robots that were pinned, with their paths.
    pub pins: &'a [Pin],
    /// How the cables were loaded.
    pub walked: &'a [Step],
    /// The cable that is set, from 0.
    pub cable: usize,
    /// What forces are drawn by.
    pub scale: ForceScale,
    /// The pulls that lines are fitted on.
    pub window: Window,
    /// Changes whenever the problem or the solution does.
    pub shape_generation: u64,
    /// Changes whenever the path does.
    pub path_generation: u64,
}

impl PlotData<'_> {
    /// The problem that the robot is known for.
    pub fn problem(&self) -> &Problem {
        self.solved.problem()
    }

    /// The stiffness, where the scene has one.
    pub fn stiffness(&self) -> Option<Stiffness> {
        Stiffness::of_scene(self.scene).ok().flatten()
    }

    /// The bend of a segment of the free robot at the pull that the robot has, in
    /// radians.
    pub fn free_bend(&self) -> f64 {
        let robot = self.problem().robot();
        let (least, most) = robot.pull_range();
        robot.free_arc(within(self.solved.pull, least, most)).bend
    }

    /// The force readings of the scene.
    pub fn readings(&self) -> &[ForceReading] {
        let measured = self.scene.measured.as_ref();
        measured.map_or(&[], |measured| &measured.forces)
    }

    /// The index of the reading that fixes μ.
    pub fn calibration(&self) -> Option<usize> {
        let index = self.scene.measured.as_ref()?.calibration?;
        let index = usize::try_from(index).ok()?;
        (index < self.readings().len()).then_some(index)
    }
}

/// What connects the plots with each other and with the rest of the window.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Link {
    /// What the pointer was on in the last frame, anywhere in the window.
    pub hovered: Hovered,
    /// What it is on now, if it is on a plot; not touched otherwise.
    pub hovering: Hovered,
    /// A pull that was clicked or dragged to, in metres.
    pub pull: Option<f64>,
    /// The pulls that lines are fitted on; its edges can be dragged.
    pub window: Window,
    /// The index of a reading that is to fix μ.
    pub calibrate: Option<usize>,
}

/// What a plot asks for.
#[derive(Clone, Debug, PartialEq)]
pub enum PlotAction {
    /// A file to be saved.
    Save {
        /// Its name without extension.
        name: String,
        /// `csv` or `svg`.
        extension: &'static str,
        /// Its contents.
        bytes: Vec<u8>,
    },
    /// The backbone's stiffness is to be given.
    AskStiffness,
    /// A force reading is to be given.
    AskReading,
    /// The cable is to slide.
    Slide,
}
