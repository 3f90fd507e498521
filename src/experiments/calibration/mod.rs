//! Stiffness and friction from measured forces and pulls, by least squares: which values
//! of the constants make the sliding cable come nearest to all that was read, how sure
//! they are, and which of them the data cannot tell apart.
//!
//! The fit is that of MPFIT (Levenberg and Marquardt's, with bounds). The stiffness goes
//! in as its logarithm: it is positive, of any size, and what it changes goes by its
//! ratio. Coefficients of friction and the loss keep their own scale within the bounds
//! of a scene, and the fit holds them at a bound where the data ask for less than
//! nothing: a transformation that cannot reach zero would move "no friction" to
//! infinity, where no error means anything.

mod apart;
mod fault;
mod model;

pub use apart::{Uncertainty, Unseparated};
pub use fault::CalibrationError;

use super::measured_csv::Trials;
use crate::scene::limits::{self, Limits};
use crate::scene::{Scene, nearest};
use model::Measurement;
use rmpfit::{MPConfig, MPError, MPFitter, MPPar, MPResult, MPSuccess};

/// A constant that can be fitted.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Constant {
    /// EI, in N mm².
    Stiffness,
    /// μ of cables in holes.
    Holes,
    /// μ of the robot on obstacles.
    Contacts,
    /// The share of a load that is lost below the base.
    BaseLoss,
}

impl Constant {
    /// All of them.
    pub const ALL: [Self; 4] = [Self::Stiffness, Self::Holes, Self::Contacts, Self::BaseLoss];

    /// Its word on command lines.
    pub fn word(self) -> &'static str {
        match self {
            Self::Stiffness => "ei",
            Self::Holes => "holes",
            Self::Contacts => "contacts",
            Self::BaseLoss => "base_loss",
        }
    }

    /// Its key in a scene.
    pub fn key(self) -> &'static str {
        match self {
            Self::Stiffness => "robot.bending_stiffness_nmm2",
            Self::Holes => "friction.holes",
            Self::Contacts => "friction.contacts",
            Self::BaseLoss => "friction.base_loss",
        }
    }

    /// The constants in a list with commas, each once.
    ///
    /// # Errors
    /// For a word that is none, and for one that comes twice.
    pub fn list(text: &str) -> Result<Vec<Self>, CalibrationError> {
        let mut list = Vec::new();
        for word in text.split(',').map(str::trim) {
            let Some(constant) = Self::ALL.into_iter().find(|it| it.word() == word) else {
                let words = Self::ALL.map(Self::word);
                return Err(CalibrationError::UnknownConstant {
                    found: crate::scene::quoted(word),
                    nearest: nearest(word, &words),
                });
            };
            if list.contains(&constant) {
                return Err(CalibrationError::Twice(constant.word()));
            }
            list.push(constant);
        }
        Ok(list)
    }

    /// The range that scenes allow.
    fn limits(self) -> Limits {
        match self {
            Self::Stiffness => limits::BENDING_STIFFNESS,
            Self::Holes | Self::Contacts => limits::FRICTION,
            Self::BaseLoss => limits::BASE_LOSS,
        }
    }

    /// Its value in a scene, in the scene's unit.
    fn get(self, scene: &Scene) -> Option<f64> {
        match self {
            Self::Stiffness => scene.robot.bending_stiffness_nmm2,
            Self::Holes => Some(scene.friction.holes),
            Self::Contacts => Some(scene.friction.contacts),
            Self::BaseLoss => Some(scene.friction.base_loss),
        }
    }

    fn set(self, scene: &mut Scene, value: f64) {
        match self {
            Self::Stiffness => scene.robot.bending_stiffness_nmm2 = Some(value),
            Self::Holes => scene.friction.holes = value,
            Self::Contacts => scene.friction.contacts = value,
            Self::BaseLoss => scene.friction.base_loss = value,
        }
    }

    /// Where the fit starts: the scene's own or, where nothing rubs, a common plastic on
    /// a common cord, since at a bound a fit sees one side only.
    fn start(self, scene: &Scene) -> Result<f64, CalibrationError> {
        match (self, self.get(scene)) {
            (Self::Holes | Self::Contacts, Some(0.0)) => Ok(0.2),
            (Self::BaseLoss, Some(0.0)) => Ok(0.1),
            (_, Some(value)) => Ok(value),
            (_, None) => Err(CalibrationError::NoStiffness),
        }
    }

    /// Its value as the fit has it.
    fn inside(self, value: f64) -> f64 {
        match self {
            Self::Stiffness => libm::log(value),
            _ => value,
        }
    }

    /// The value of what the fit has.
    fn outside(self, inside: f64) -> f64 {
        match self {
            Self::Stiffness => libm::exp(inside),
            _ => inside,
        }
    }
}

/// How far readings may be off, which weighs forces against pulls where both were read.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ReadingErrors {
    /// Of a force, in grams.
    pub force_g: f64,
    /// Of a pull, in mm.
    pub pull_mm: f64,
}

/// A constant that was fitted.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fitted {
    /// Which.
    pub constant: Constant,
    /// Its value, in the scene's unit.
    pub value: f64,
    /// Where the fit started, in the scene's unit.
    pub start: f64,
    /// Its standard error, in the scene's unit; `None` at a bound, and where the data do
    /// not depend on it.
    pub error: Option<f64>,
    /// Whether the data ask for a value beyond the range of scenes.
    pub at_bound: bool,
}

/// What was read in a row, and what the fitted constants make of it.
#[derive(Clone, Debug, PartialEq)]
pub struct Compared {
    /// Its line in the file, from 1.
    pub row: usize,
    /// The weight on the first cable, whole, in grams: what hung on it, or would hold
    /// its pull.
    pub load_g: f64,
    /// The pull computed, in mm.
    pub pull_mm: f64,
    /// The pull that was read under a weight, in mm.
    pub read_pull_mm: Option<f64>,
    /// The force on all obstacles computed, in grams.
    pub force_g: f64,
    /// The force that was read, in grams.
    pub read_force_g: Option<f64>,
}

/// What a fit came to.
#[derive(Clone, Debug, PartialEq)]
pub struct Calibration {
    /// The constants.
    pub constants: Vec<Fitted>,
    /// How sure they are, together.
    pub uncertainty: Uncertainty,
    /// By row of the file.
    pub rows: Vec<Compared>,
    /// The root of the mean squared difference of forces, in grams, where some were read.
    pub force_rms_g: Option<f64>,
    /// The same of pulls, in mm.
    pub pull_rms_mm: Option<f64>,
    /// Steps of the fit.
    pub iterations: usize,
}

/// Fits constants of a scene to trials, from the scene's own values on. The cables
/// slide, whatever the scene says of its mechanics.
///
/// # Errors
/// For constants that the trials set themselves, settings that the scene does not have,
/// fewer readings than it takes, and where a row cannot be computed or the fit finds no
/// end; each names the row.
pub fn calibrate(
    scene: &Scene,
    trials: &Trials,
    constants: &[Constant],
    errors: ReadingErrors,
    each: &mut dyn FnMut(usize),
) -> Result<Calibration, CalibrationError> {
    let key = |constant: &&Constant| trials.keys.iter().any(|key| key == constant.key());
    if let Some(constant) = constants.iter().find(key) {
        return Err(CalibrationError::Set {
            row: trials.head,
            key: constant.key(),
        });
    }
    let starts = constants.iter().map(|constant| constant.start(scene));
    let starts: Vec<f64> = starts.collect::<Result<_, _>>()?;
    let measurement = Measurement::of(scene, trials, errors)?;
    let readings = measurement.readings();
    if readings <= constants.len() {
        return Err(CalibrationError::TooFew {
            readings,
            constants: constants.len(),
        });
    }
    // A start that cannot be computed is a fault of the input; on the way it is none.
    measurement.compared(constants, &starts)?;
    let mut fit = Fit::new(&measurement, constants, each);
    let insides = constants.iter().zip(&starts);
    let mut at: Vec<f64> = insides.map(|(it, value)| it.inside(*value)).collect();
    let ended = fit.mpfit(&mut at).map_err(ended)?;
    if matches!(ended.success, MPSuccess::MaxIter | MPSuccess::NotDone) {
        return Err(CalibrationError::NotConverged(ended.n_iter));
    }
    let values: Vec<f64> = constants
        .iter()
        .zip(&at)
        .map(|(it, inside)| it.outside(*inside))
        .collect();
    let rows = measurement.compared(constants, &values)?;
    let uncertainty = Uncertainty::of(&measurement, constants, &at)?;
    let fitted = constants
        .iter()
        .enumerate()
        .map(|(index, constant)| Fitted {
            constant: *constant,
            value: values[index],
            start: starts[index],
            error: uncertainty.errors[index],
            at_bound: uncertainty.at_bound[index],
        });
    Ok(Calibration {
        constants: fitted.collect(),
        force_rms_g: rms(rows.iter().map(|row| Some(row.force_g - row.read_force_g?))),
        pull_rms_mm: rms(rows.iter().map(|row| Some(row.pull_mm - row.read_pull_mm?))),
        rows,
        uncertainty,
        iterations: ended.n_iter,
    })
}

fn rms(differences: impl Iterator<Item = Option<f64>>) -> Option<f64> {
    let (mut sum, mut count) = (0.0, 0_u32);
    for difference in differences.flatten() {
        sum += difference * difference;
        count += 1;
    }
    (count > 0).then(|| (sum / f64::from(count)).sqrt())
}

/// Why MPFIT gave up; what else it refuses has been refused before.
fn ended(error: MPError) -> CalibrationError {
    CalibrationError::Refused(error.to_string())
}

/// The problem as MPFIT has it.
struct Fit<'a> {
    measurement: &'a Measurement,
    constants: &'a [Constant],
    bounds: Vec<MPPar>,
    config: MPConfig,
    each: &'a mut dyn FnMut(usize),
    evaluations: usize,
}

/// Steps of differences in the fit's own scale: a thousandth of EI, and of the
/// friction's. What a shape remembers of its way changes forces by 1e-9 of them.
const STEP: f64 = 1e-3;

/// A relative change of the sum of squares, or of the constants, that ends the fit: far
/// below every standard error.
const UNCHANGED: f64 = 1e-8;

/// Steps of the fit at most.
const MOST: usize = 200;

impl<'a> Fit<'a> {
    fn new(
        measurement: &'a Measurement,
        constants: &'a [Constant],
        each: &'a mut dyn FnMut(usize),
    ) -> Self {
        let bounds = constants.iter().map(|constant| MPPar {
            limited_low: true,
            limited_up: true,
            limit_low: constant.inside(constant.limits().min),
            limit_up: constant.inside(constant.limits().max),
            step: STEP,
            ..MPPar::new()
        });
        Self {
            measurement,
            constants,
            bounds: bounds.collect(),
            config: MPConfig {
                ftol: UNCHANGED,
                xtol: UNCHANGED,
                gtol: UNCHANGED,
                max_iter: MOST,
                // Where nothing is known yet, no constant jumps by more than its size.
                step_factor: 1.0,
                ..MPConfig::new()
            },
            each,
            evaluations: 0,
        }
    }
}

impl MPFitter for Fit<'_> {
    fn eval(&mut self, at: &[f64], deviates: &mut [f64]) -> MPResult<()> {
        self.evaluations += 1;
        (self.each)(self.evaluations);
        let found = self.measurement.deviations(self.constants, at);
        deviates.copy_from_slice(&found);
        Ok(())
    }

    fn number_of_points(&self) -> usize {
        self.measurement.readings()
    }

    fn config(&self) -> &MPConfig {
        &self.config
    }

    fn parameters(&self) -> &[MPPar] {
        &self.bounds
    }
}
