//! The bending stiffness EI, which turns multipliers into forces. The paper's
//! model does without it and never states one.

use super::told;
use crate::equilibrium::Solved;
use crate::mechanics::Problem;
use crate::scene::Scene;
use crate::units::{grams, millimetres, newton_square_metres, newton_square_millimetres};
use std::f64::consts::PI;

/// A bending stiffness EI, in N·m², positive and finite.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stiffness(f64);

/// A cross-section of the backbone, in metres.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Profile {
    /// A solid round rod.
    Rod {
        /// Its diameter.
        diameter: f64,
    },
    /// A round tube.
    Tube {
        /// Its outer diameter.
        outer: f64,
        /// Its inner diameter.
        inner: f64,
    },
    /// A strip, bent across its thickness.
    Strip {
        /// Its size across the plane of bending.
        width: f64,
        /// Its size in the plane of bending.
        thickness: f64,
    },
}

/// Why there is no stiffness.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum StiffnessError {
    /// The number is no stiffness.
    #[error(
        "a bending stiffness of {} N mm² is not positive and finite; give one that is",
        told(newton_square_millimetres(*.0))
    )]
    NotPositive(f64),
    /// The load that was measured is not positive.
    #[error("a load of {} g cannot calibrate the stiffness; give a positive one", told(grams(*.0)))]
    NoLoad(f64),
    /// The robot's cable is not tense.
    #[error(
        "at a pull of {} mm the robot is not bent by its cable, so that no load calibrates its \
         stiffness; give a load measured at a positive pull",
        told(millimetres(*.0))
    )]
    NoPull(f64),
}

impl Profile {
    /// The second moment of area about the axis of bending, in m⁴.
    pub fn second_moment(self) -> f64 {
        match self {
            Profile::Rod { diameter } => PI / 64.0 * libm::pow(diameter, 4.0),
            Profile::Tube { outer, inner } => {
                PI / 64.0 * (libm::pow(outer, 4.0) - libm::pow(inner, 4.0))
            }
            Profile::Strip { width, thickness } => width * libm::pow(thickness, 3.0) / 12.0,
        }
    }
}

impl Stiffness {
    /// A given stiffness, in N·m².
    ///
    /// # Errors
    /// If it is not positive and finite.
    pub fn new(newton_square_metres: f64) -> Result<Self, StiffnessError> {
        if newton_square_metres > 0.0 && newton_square_metres.is_finite() {
            Ok(Self(newton_square_metres))
        } else {
            Err(StiffnessError::NotPositive(newton_square_metres))
        }
    }

    /// The stiffness that a scene gives, if it gives one.
    ///
    /// # Errors
    /// If it is not positive and finite, which [`Scene::faults`] reports too.
    pub fn of_scene(scene: &Scene) -> Result<Option<Self>, StiffnessError> {
        let given = scene.robot.bending_stiffness_nmm2;
        given.map(newton_square_metres).map(Self::new).transpose()
    }

    /// E·I of a material's Young's modulus, in Pa, and a section.
    ///
    /// # Errors
    /// If the product is not positive and finite.
    pub fn of_section(young: f64, profile: Profile) -> Result<Self, StiffnessError> {
        Self::new(young * profile.second_moment())
    }

    /// The stiffness with which a load, in N, holds this shape: from
    /// T = (EI/2l_0) dJ/dl.
    ///
    /// # Errors
    /// If the load is not positive, or the shape's energy does not rise with
    /// the pull.
    pub fn calibrated(solved: &Solved, load: f64) -> Result<Self, StiffnessError> {
        if !(load > 0.0 && load.is_finite()) {
            return Err(StiffnessError::NoLoad(load));
        }
        let slope = solved.energy_slope();
        if !(slope > 0.0 && slope.is_finite()) {
            return Err(StiffnessError::NoPull(solved.pull));
        }
        Self::new(2.0 * solved.problem().robot().segment_length() * load / slope)
    }

    /// EI, in N·m².
    pub fn value(self) -> f64 {
        self.0
    }

    /// EI/2l_0, in N·m: what one rad² of Σ β² costs. Times a multiplier in
    /// rad²/m it is a force in N.
    pub fn per_bend(self, problem: &Problem) -> f64 {
        self.0 / (2.0 * problem.robot().segment_length())
    }
}
