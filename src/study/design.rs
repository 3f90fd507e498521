//! A study with its scene: what its samples are, by their index.

use super::constraint::Constraint;
use super::error::StudyError;
use super::file::StudyFile;
use super::hash::digest;
use super::output::{Needs, Output};
use super::parameter::Parameter;
use super::sampler::{Position, Sampler};
use super::{MAX_SAMPLES, sobol};
use crate::mechanics::Problem;
use crate::scene::limits::LENGTH;
use crate::scene::{Scene, SceneError};

/// The key of the distance between disks, of which only some divide a robot's length.
const SPACING: &str = "robot.disk_spacing_mm";

/// A study that can be carried out: every name in it is known, every key is in its
/// scene.
#[derive(Clone, Debug)]
pub struct Study {
    file: StudyFile,
    scene: Scene,
    /// The scene with every key of a parameter in it, so that it is set at once.
    keyed: Scene,
    /// Of every axis, the parameters that go along it together.
    axes: Vec<Vec<usize>>,
    /// The steps of every axis on a grid; empty otherwise.
    steps: Vec<u64>,
    samples: u64,
    outputs: Vec<Output>,
    /// The outputs and what constraints look at beside them.
    computed: Vec<Output>,
    constraints: Vec<Constraint>,
    digest: u128,
}

impl Study {
    /// A study of a scene.
    ///
    /// # Errors
    /// The first fault: unknown outputs or keys, parameters that do not go together, too
    /// many samples, outputs that the scene cannot tell.
    pub fn new(file: StudyFile, scene: Scene) -> Result<Self, StudyError> {
        let outputs = outputs(&file)?;
        let constraints = constraints(&file)?;
        let mut computed = outputs.clone();
        for output in constraints.iter().flat_map(Constraint::outputs) {
            if !computed.contains(&output) {
                computed.push(output);
            }
        }
        let axes = axes(&file.parameters);
        let (steps, samples) = match file.sampler {
            Sampler::Grid => grid(&file, &axes)?,
            Sampler::Latin | Sampler::Sobol => (Vec::new(), asked(&file, axes.len())?),
        };
        let mut study = Self {
            digest: digest_of(&file, &scene),
            file,
            keyed: scene.clone(),
            scene,
            axes,
            steps,
            samples,
            outputs,
            computed,
            constraints,
        };
        study.check_keys()?;
        study.check_needs()?;
        for (parameter, value) in study.file.parameters.iter().zip(study.values(0)) {
            // What the scene refuses now it refuses of each sample.
            let _ = study.keyed.set_number(&parameter.key, value);
        }
        study.check_scene()?;
        Ok(study)
    }

    /// What the study's file says.
    pub fn file(&self) -> &StudyFile {
        &self.file
    }

    /// The scene that is varied.
    pub fn scene(&self) -> &Scene {
        &self.scene
    }

    /// How many samples there are.
    pub fn samples(&self) -> u64 {
        self.samples
    }

    /// What is told of each sample.
    pub fn outputs(&self) -> &[Output] {
        &self.outputs
    }

    /// What is computed of each sample: [`Study::outputs`] first, then what constraints
    /// look at beside them.
    pub fn computed(&self) -> &[Output] {
        &self.computed
    }

    /// What samples should meet.
    pub fn constraints(&self) -> &[Constraint] {
        &self.constraints
    }

    /// The parameters, in the order of the file.
    pub fn parameters(&self) -> &[Parameter] {
        &self.file.parameters
    }

    /// What tells this study and its results from every other: of what it says but its
    /// scene's file name, of the scene, and of this program's version.
    pub fn digest(&self) -> u128 {
        self.digest
    }

    /// The values of a sample, in the order of the parameters and in the units of their
    /// keys, and its scene. A distance between disks that does not divide the robot's
    /// length becomes the nearest that does: that with the nearest number of disks.
    ///
    /// # Errors
    /// If the scene does not take one of them.
    ///
    /// # Panics
    /// If there is no such sample.
    pub fn sample(&self, index: u64) -> (Vec<f64>, Result<Scene, SceneError>) {
        let mut values = self.asked_values(index);
        let mut scene = self.keyed.clone();
        // Spacings last, since they depend on the length and on the segments a bay.
        for spacings in [false, true] {
            for (parameter, value) in self.file.parameters.iter().zip(&mut values) {
                if (parameter.key == SPACING) != spacings {
                    continue;
                }
                if spacings {
                    *value = dividing(*value, scene.robot.length_mm);
                }
                if let Err(fault) = scene.set_number(&parameter.key, *value) {
                    return (values, Err(fault));
                }
            }
        }
        (values, Ok(scene))
    }

    /// The values of a sample, as they are where its scene takes them.
    ///
    /// # Panics
    /// If there is no such sample.
    pub fn values(&self, index: u64) -> Vec<f64> {
        let has_spacing = self.file.parameters.iter().any(|one| one.key == SPACING);
        match has_spacing {
            true => self.sample(index).0,
            false => self.asked_values(index),
        }
    }

    fn asked_values(&self, index: u64) -> Vec<f64> {
        assert!(index < self.samples, "sample {index} of {}", self.samples);
        let mut values = vec![0.0; self.file.parameters.len()];
        for (axis, along) in self.axes.iter().enumerate() {
            let position =
                self.file
                    .sampler
                    .position(index, axis, &self.steps, self.samples, self.file.seed);
            for place in along {
                values[*place] = self.file.parameters[*place].value(position);
            }
        }
        values
    }

    /// Every key is in the scene and takes a number, at one end at least.
    fn check_keys(&self) -> Result<(), StudyError> {
        for (place, parameter) in self.file.parameters.iter().enumerate() {
            let field = format!("parameter[{place}].key");
            let twice = self.file.parameters[..place]
                .iter()
                .any(|one| one.key == parameter.key);
            if twice {
                let problem = format!("is {}, which another parameter varies", parameter.key);
                return Err(StudyError::conflict(field, problem, "remove one of them"));
            }
            let at = |position| {
                let mut value = parameter.value(position);
                if parameter.key == SPACING {
                    value = dividing(value, self.scene.robot.length_mm);
                }
                self.scene.clone().set_number(&parameter.key, value)
            };
            let last = match parameter.values.count() {
                Some(count) => Position::Step(count - 1),
                None => Position::Share(1.0),
            };
            if let (Err(fault), Err(_)) = (at(Position::Step(0)), at(last)) {
                return Err(StudyError::Parameter { field, fault });
            }
        }
        Ok(())
    }

    /// The scene has no fault that all samples have: at both ends and in the middle.
    fn check_scene(&self) -> Result<(), StudyError> {
        let some = [0, self.samples / 2, self.samples - 1];
        let some = some.map(|index| match self.sample(index).1 {
            Ok(scene) => Problem::faults(&scene),
            Err(_) => Vec::new(),
        });
        let mut faults = Problem::faults(&self.scene).into_iter();
        match faults.find(|fault| some.iter().all(|faults| faults.contains(fault))) {
            Some(fault) => Err(StudyError::Scene { fault }),
            None => Ok(()),
        }
    }

    /// Every output can be told.
    fn check_needs(&self) -> Result<(), StudyError> {
        let robot = &self.scene.robot;
        let varied = |key: &str| self.file.parameters.iter().any(|one| one.key == key);
        let stiffness = "robot.bending_stiffness_nmm2";
        for output in &self.computed {
            let lacking = match output.needs() {
                Needs::Stiffness
                    if robot.bending_stiffness_nmm2.is_none() && !varied(stiffness) =>
                {
                    Some((stiffness, "give it in the scene, or as a parameter"))
                }
                Needs::Target if self.file.target_mm.is_none() => {
                    Some(("target_mm", "add target_mm = [x, y] to the study"))
                }
                Needs::Measured if self.scene.measured.is_none() => Some((
                    "measured.points_mm",
                    "add the measured backbone to the scene",
                )),
                _ => None,
            };
            if let Some((key, advice)) = lacking {
                let problem = format!("asks for {}, which needs {key}", output.name());
                return Err(StudyError::conflict("outputs", problem, advice));
            }
        }
        Ok(())
    }
}

fn digest_of(file: &StudyFile, scene: &Scene) -> u128 {
    let file = StudyFile {
        title: None,
        scene: "scene.toml".to_owned(),
        ..file.clone()
    };
    // A scene that was read can be written.
    let scene = scene.to_toml().unwrap_or_default();
    digest(&[&file.to_toml(), &scene, env!("CARGO_PKG_VERSION")])
}

/// The distance nearest to this one that divides a length: that of the nearest number of
/// disks. A length that no robot has is left to the scene's checks.
fn dividing(spacing: f64, length: f64) -> f64 {
    let disks = libm::round(length / spacing).max(1.0);
    if LENGTH.contain(length) && spacing > 0.0 && disks.is_finite() {
        length / disks
    } else {
        spacing
    }
}

fn outputs(file: &StudyFile) -> Result<Vec<Output>, StudyError> {
    if file.outputs.is_empty() {
        let advice = "name at least one; `sinew explore --outputs` lists them";
        return Err(StudyError::conflict("outputs", "names nothing", advice));
    }
    let mut outputs = Vec::new();
    for (index, name) in file.outputs.iter().enumerate() {
        let field = format!("outputs[{index}]");
        match Output::of_name(name) {
            Ok(output) if outputs.contains(&output) => {
                let problem = format!("is {name} a second time");
                return Err(StudyError::conflict(field, problem, "remove one of them"));
            }
            Ok(output) => outputs.push(output),
            Err(nearest) => {
                return Err(StudyError::Unknown {
                    field: format!("{field}, {},", crate::scene::quoted(name)),
                    what: "an output",
                    nearest,
                    known: Output::all().map(Output::name).collect(),
                });
            }
        }
    }
    Ok(outputs)
}

fn constraints(file: &StudyFile) -> Result<Vec<Constraint>, StudyError> {
    let texts = file.constraints.iter().enumerate();
    let each = texts.map(|(index, text)| {
        Constraint::new(text).map_err(|problem| {
            // Some say themselves what to do.
            let (problem, advice) = problem
                .split_once("; ")
                .unwrap_or((&problem, "write one as \"force_max_n < 0.2\""));
            StudyError::conflict(format!("constraints[{index}]"), problem, advice)
        })
    });
    each.collect()
}

/// Parameters of one name go along one axis, which stands where the first of them does.
fn axes(parameters: &[Parameter]) -> Vec<Vec<usize>> {
    let mut axes: Vec<Vec<usize>> = Vec::new();
    for (place, parameter) in parameters.iter().enumerate() {
        let along = axes
            .iter_mut()
            .find(|axis| parameter.name.is_some() && parameters[axis[0]].name == parameter.name);
        match along {
            Some(axis) => axis.push(place),
            None => axes.push(vec![place]),
        }
    }
    axes
}

/// The steps of every axis of a grid, and their product.
fn grid(file: &StudyFile, axes: &[Vec<usize>]) -> Result<(Vec<u64>, u64), StudyError> {
    if file.samples.is_some() {
        let problem = "has no meaning on a grid, whose steps say it";
        let advice = "remove it, or write sampler = \"sobol\"";
        return Err(StudyError::conflict("samples", problem, advice));
    }
    let mut steps = Vec::new();
    for axis in axes {
        let counts = axis.iter().map(|place| {
            file.parameters[*place]
                .values
                .count()
                .ok_or_else(|| StudyError::Missing {
                    field: format!("parameter[{place}].steps"),
                    what: "how many values a grid takes of the range, such as steps = 20",
                })
        });
        let counts: Vec<u64> = counts.collect::<Result<_, _>>()?;
        if let Some(other) = (1..counts.len()).find(|i| counts[*i] != counts[0]) {
            return Err(StudyError::conflict(
                format!("parameter[{}]", axis[other]),
                format!(
                    "has {} values, and parameter[{}] of the same name has {}",
                    counts[other], axis[0], counts[0]
                ),
                "give them as many, or other names",
            ));
        }
        steps.push(counts[0]);
    }
    let product = steps
        .iter()
        .fold(1_u128, |all, one| all.saturating_mul((*one).into()));
    match u64::try_from(product) {
        Ok(samples) if samples <= MAX_SAMPLES => Ok((steps, samples)),
        _ => Err(StudyError::TooMany { samples: product }),
    }
}

/// The number of samples of a sampler that has to be told.
fn asked(file: &StudyFile, axes: usize) -> Result<u64, StudyError> {
    let most = sobol::MOST_DIMENSIONS;
    if file.sampler == Sampler::Sobol && axes > most {
        let problem = format!("is sobol, which has {most} dimensions, and there are {axes}");
        let advice = "write sampler = \"latin\", or give parameters the same name";
        return Err(StudyError::conflict("sampler", problem, advice));
    }
    let stepped = file
        .parameters
        .iter()
        .position(|one| matches!(one.values, super::Values::Range { steps: Some(_), .. }));
    if let Some(place) = stepped {
        let problem = format!("has no meaning for sampler = \"{}\"", file.sampler.name());
        let advice = "remove it, or write sampler = \"grid\"";
        return Err(StudyError::conflict(
            format!("parameter[{place}].steps"),
            problem,
            advice,
        ));
    }
    match file.samples {
        None => Err(StudyError::Missing {
            field: "samples".to_owned(),
            what: "how many samples to take, such as samples = 1024",
        }),
        Some(0) => Err(StudyError::conflict("samples", "is 0", "take at least 1")),
        Some(samples) if samples > MAX_SAMPLES => Err(StudyError::TooMany {
            samples: samples.into(),
        }),
        Some(samples) => Ok(samples),
    }
}
