//! What the sliding cable makes of trials at given constants. A load or pull is come to
//! from the straight robot, as `solve` does; loads from contact are counted as `force`
//! counts them.

use super::{CalibrationError, Compared, Constant, ReadingErrors};
use crate::equilibrium::{Settings, Solved, Start, Status, solve};
use crate::experiments::measured_csv::{Trial, Trials, Weight};
use crate::forces::{LoadSteps, Stiffness, SweepError};
use crate::math::typeset;
use crate::mechanics::{Input, Problem};
use crate::scene::limits::shown;
use crate::scene::{Mechanics, Scene};
use crate::units::{grams, metres, millimetres, newtons};

/// Trials with the scenes that they were made in.
pub(super) struct Measurement {
    scenes: Vec<Scene>,
    trials: Vec<Placed>,
    errors: ReadingErrors,
}

/// A trial and which scene is its.
struct Placed {
    trial: Trial,
    scene: usize,
}

/// How far off, in standard errors of a reading, a row counts that cannot be computed
/// at constants that the fit tries: so far that it turns back.
const FAR_OFF: f64 = 1e4;

impl Measurement {
    /// Trials in a scene whose cables slide, whatever it says.
    pub fn of(
        scene: &Scene,
        trials: &Trials,
        errors: ReadingErrors,
    ) -> Result<Self, CalibrationError> {
        let mut sliding = scene.clone();
        sliding.model.mechanics = Mechanics::Sliding;
        let mut known: Vec<(&[String], usize)> = Vec::new();
        let (mut scenes, mut placed) = (Vec::new(), Vec::new());
        for trial in &trials.rows {
            let found = known.iter().find(|(known, _)| *known == trial.settings);
            let index = match found {
                Some((_, index)) => *index,
                None => {
                    scenes.push(set(&sliding, trials, trial)?);
                    known.push((&trial.settings, scenes.len() - 1));
                    scenes.len() - 1
                }
            };
            within_reach(&scenes[index], trial)?;
            placed.push(Placed {
                trial: trial.clone(),
                scene: index,
            });
        }
        Ok(Self {
            scenes,
            trials: placed,
            errors,
        })
    }

    /// How many numbers were read.
    pub fn readings(&self) -> usize {
        let trials = self.trials.iter().map(|placed| &placed.trial);
        trials.map(|trial| read(trial).count()).sum()
    }

    /// The readings of every row beside what is computed.
    pub fn compared(
        &self,
        constants: &[Constant],
        values: &[f64],
    ) -> Result<Vec<Compared>, CalibrationError> {
        self.rows(constants, values).into_iter().collect()
    }

    /// What is computed less what was read, over the error of a reading; `at` is where
    /// the fit is, in its own scale.
    pub fn deviations(&self, constants: &[Constant], at: &[f64]) -> Vec<f64> {
        let values: Vec<f64> = constants
            .iter()
            .zip(at)
            .map(|(constant, inside)| constant.outside(*inside))
            .collect();
        let mut deviations = Vec::with_capacity(self.readings());
        for (row, placed) in self.rows(constants, &values).iter().zip(&self.trials) {
            deviations.extend(read(&placed.trial).map(|reading| match (row, reading) {
                (Err(_), _) => FAR_OFF,
                (Ok(row), Reading::Force(read)) => (row.force_g - read) / self.errors.force_g,
                (Ok(row), Reading::Pull(read)) => (row.pull_mm - read) / self.errors.pull_mm,
            }));
        }
        deviations
    }

    fn rows(
        &self,
        constants: &[Constant],
        values: &[f64],
    ) -> Vec<Result<Compared, CalibrationError>> {
        // Each scene is made, and its contact looked for, once.
        let mut places: Vec<Option<Result<Place, CalibrationError>>> = Vec::new();
        places.resize_with(self.scenes.len(), || None);
        let words = in_words(constants, values);
        let rows = self.trials.iter().map(|Placed { trial, scene }| {
            let place = places[*scene].get_or_insert_with(|| {
                Place::of(&self.scenes[*scene], constants, values, trial.row)
            });
            match place {
                Ok(place) => place.compared(trial, &words),
                Err(fault) => Err(fault.clone()),
            }
        });
        rows.collect()
    }
}

enum Reading {
    Force(f64),
    Pull(f64),
}

/// What was read in a row.
fn read(trial: &Trial) -> impl Iterator<Item = Reading> {
    let pull = trial.pull_mm.filter(|_| trial.weight.is_some());
    let readings = [trial.force_g.map(Reading::Force), pull.map(Reading::Pull)];
    readings.into_iter().flatten()
}

/// The scene of a row.
fn set(scene: &Scene, trials: &Trials, trial: &Trial) -> Result<Scene, CalibrationError> {
    let row = trial.row;
    let fault = |fault| CalibrationError::Scene { row, fault };
    let mut scene = scene.clone();
    for (key, value) in trials.keys.iter().zip(&trial.settings) {
        scene.set(key, value).map_err(fault)?;
    }
    match Problem::faults(&scene).into_iter().next() {
        Some(found) => Err(fault(found)),
        None => Ok(scene),
    }
}

/// A pull that is given is at most the robot's length.
fn within_reach(scene: &Scene, trial: &Trial) -> Result<(), CalibrationError> {
    let most = scene.robot.length_mm;
    match trial.pull_mm {
        Some(pull_mm) if trial.weight.is_none() && pull_mm.abs() > most => {
            Err(CalibrationError::OutOfReach {
                row: trial.row,
                pull_mm: shown(pull_mm),
                most_mm: shown(most),
            })
        }
        _ => Ok(()),
    }
}

fn in_words(constants: &[Constant], values: &[f64]) -> String {
    let words = constants.iter().zip(values).map(|(constant, value)| {
        let count = if *constant == Constant::Stiffness {
            1
        } else {
            4
        };
        format!("{} = {}", constant.word(), typeset(*value, count))
    });
    words.collect::<Vec<_>>().join(", ")
}

/// A scene at given constants.
struct Place {
    problem: Problem,
    stiffness: Stiffness,
    per_bend: f64,
    /// The load at which the robot begins to press, in N: looked for once.
    datum: Option<Result<Option<f64>, SweepError>>,
}

impl Place {
    fn of(
        scene: &Scene,
        constants: &[Constant],
        values: &[f64],
        row: usize,
    ) -> Result<Self, CalibrationError> {
        let fault = |fault| CalibrationError::Scene { row, fault };
        let mut scene = scene.clone();
        for (constant, value) in constants.iter().zip(values) {
            constant.set(&mut scene, *value);
        }
        let problem = Problem::new(&scene).map_err(fault)?;
        let stiffness = Stiffness::of_scene(&scene).ok().flatten();
        let stiffness = stiffness.ok_or(CalibrationError::NoStiffness)?;
        let per_bend = stiffness.per_bend(&problem);
        Ok(Self {
            problem,
            stiffness,
            per_bend,
            datum: None,
        })
    }

    fn compared(&mut self, trial: &Trial, constants: &str) -> Result<Compared, CalibrationError> {
        let row = trial.row;
        let failed = |reason: String| CalibrationError::NoEquilibrium {
            row,
            constants: constants.to_owned(),
            reason,
        };
        let input = match (trial.weight, trial.pull_mm) {
            (Some(Weight::Whole(load)), _) => Input::Load(newtons(load)),
            (Some(Weight::FromContact(load)), _) => {
                let datum = self.datum().map_err(|error| failed(error.to_string()))?;
                let datum = datum.ok_or_else(|| CalibrationError::NoContact {
                    row,
                    constants: constants.to_owned(),
                })?;
                Input::Load(datum + newtons(load))
            }
            (None, pull) => Input::Pull(metres(pull.unwrap_or_default())),
        };
        let mut drive = self.problem.drive().clone();
        drive.cables[0].input = input;
        let mut problem = self.problem.clone();
        problem.set_drive(&drive);
        let solved = solve(&problem, Start::Straight, Settings::default());
        if solved.status != Status::Converged {
            return Err(failed(solved.status.reason().to_owned()));
        }
        let under_weight = trial.weight.is_some();
        Ok(Compared {
            row,
            load_g: self.load_g(&solved),
            pull_mm: millimetres(solved.pull),
            read_pull_mm: trial.pull_mm.filter(|_| under_weight),
            force_g: self.force_g(&solved),
            read_force_g: trial.force_g,
        })
    }

    fn datum(&mut self) -> Result<Option<f64>, SweepError> {
        let (problem, stiffness) = (&self.problem, self.stiffness);
        let datum = self.datum.get_or_insert_with(|| {
            let steps = LoadSteps::of(problem, stiffness, &[])?;
            Ok(steps.contact.map(|_| steps.datum))
        });
        datum.clone()
    }

    fn load_g(&self, solved: &Solved) -> f64 {
        let first = solved.cables.first();
        grams(self.per_bend * first.map_or(0.0, |cable| cable.load))
    }

    /// The sum of what obstacles press with along their normals.
    fn force_g(&self, solved: &Solved) -> f64 {
        let multipliers = solved.contacts.iter().map(|contact| contact.multiplier);
        grams(self.per_bend * multipliers.sum::<f64>())
    }
}
