//! `sinew force`: contact force against load, by virtual work (eq. 11) and,
//! where the stiffness is known, by multipliers.

use std::io::{self, Write};

use super::arguments::{Driving, Force, Format, Motion};
use super::input::{self, BadInput};
use super::output::{csv_row, driven_shown, object, printable, pull_shown, write_out};
use super::{Failure, Outcome, force_text, numbers};
use crate::contact::Contact;
use crate::equilibrium::{Settings, Start, Status, solve};
use crate::forces::{
    LoadSteps, Profile, Rates, Stiffness, Sweep, SweepError, VirtualWork, Window, share_of_tension,
};
use crate::mechanics::{Model, Problem};
use crate::record::force::{
    ByMultipliers, ByVirtualWork, Forces, Frictionless, Line, Loaded, Row, SCHEMA, Share,
};
use crate::robot::part_name;
use crate::scene::{Friction, Measurements, Mechanics, Scene};
use crate::units::{
    degrees, grams, metres, millimetres, newton_square_metres, newton_square_millimetres, newtons,
    pascals,
};

/// Pulls in the window of the fits.
const PULLS: usize = 41;

pub(super) fn run(what: &Force) -> Result<Outcome, Failure> {
    let (scene, problem) = input::problem(&what.scene, &what.edits, &Driving::default())?;
    let loads = numbers::loads("--loads", &what.loads)?;
    if problem.model() == Model::Sliding {
        papers_alone(what)?;
    }
    let found = estimate(what, &scene, &problem, &loads)?;
    write_out(|out| match what.format {
        Format::Text => force_text::text(out, &found),
        Format::Json => object(out, &found),
        Format::Csv => csv(out, &found),
    })?;
    Ok(found.reason.map_or(Outcome::Done, Outcome::NotConverged))
}

/// What the robot does not get to, each once.
#[derive(Default)]
struct Unreached(Vec<String>);

impl Unreached {
    /// The result, unless the robot does not get there.
    fn but<T>(&mut self, result: Result<T, SweepError>) -> Result<Option<T>, BadInput> {
        match result {
            Ok(found) => Ok(Some(found)),
            Err(error @ SweepError::NotReached { .. }) => {
                self.note(error.to_string());
                Ok(None)
            }
            Err(error) => Err(wrong(error)),
        }
    }

    fn note(&mut self, reason: String) {
        if !self.0.contains(&reason) {
            self.0.push(reason);
        }
    }

    fn reason(self) -> Option<String> {
        (!self.0.is_empty()).then(|| self.0.join("; "))
    }
}

fn wrong(error: impl std::fmt::Display) -> BadInput {
    BadInput::Arguments(error.to_string())
}

/// Refuses what only virtual work has a use for.
fn papers_alone(what: &Force) -> Result<(), BadInput> {
    let given = [
        (what.friction.is_some(), "--friction"),
        (what.measured.is_some(), "--measured"),
        (what.node.is_some(), "--node"),
        (what.motion == Motion::Contact, "--motion"),
    ];
    match given.iter().find(|(is_given, _)| *is_given) {
        None => Ok(()),
        Some((_, option)) => Err(BadInput::Arguments(format!(
            "{option} is about virtual work, which is an estimate for the paper's model; leave it \
             out, or set model.mechanics to \"equal\""
        ))),
    }
}

fn estimate(
    what: &Force,
    scene: &Scene,
    problem: &Problem,
    loads: &[f64],
) -> Result<Forces, BadInput> {
    let mut unreached = Unreached::default();
    let worked = match problem.model() {
        Model::Equal => virtual_work(what, scene, problem, &mut unreached)?,
        Model::Sliding => None,
    };
    let stiffness = unreached.but(stiffness(what, scene, problem)?)?.flatten();
    // Loads in newtons act on the stiffness that was asked for.
    let stiff;
    let problem = match (problem.model(), stiffness) {
        (Model::Sliding, Some((ei, _))) => {
            stiff = problem.with_stiffness(ei.value());
            &stiff
        }
        _ => problem,
    };
    let loading = match stiffness {
        Some((ei, from)) => {
            let newtons: Vec<f64> = loads.iter().map(|load| newtons(*load)).collect();
            let loading = unreached.but(LoadSteps::of(problem, ei, &newtons))?;
            loading.map(|loading| (ei, from, loading))
        }
        None => None,
    };
    let beside = match &loading {
        Some((ei, ..)) => frictionless(scene, *ei, loads),
        None => None,
    };
    let (contacts, pull_mm) = shares(scene, problem, &mut unreached);
    let mut rows = Vec::with_capacity(loads.len());
    for load_g in loads {
        let load = newtons(*load_g);
        let state = match &loading {
            Some((_, _, loading)) => {
                let state = loading.states.iter().find(|state| state.load == load);
                // Nor does virtual work pull where no robot can follow.
                let Some(state) = state else {
                    continue;
                };
                Some(Loaded::of(state, |contact| label(scene, problem, contact)))
            }
            None => None,
        };
        let force = worked.as_ref().map(|(estimator, _)| estimator.force(load));
        let force = force.transpose().map_err(wrong)?;
        if force.is_none() && state.is_none() {
            break;
        }
        rows.push(Row {
            load_g: *load_g,
            force_x_g: force.map(|force| grams(force.x)),
            force_y_g: force.map(|force| grams(force.y) + 0.0),
            multipliers: state,
            frictionless_force_g: beside.as_ref().and_then(|beside| pressed_g(beside, load)),
        });
    }
    if let Some((_, _, LoadSteps { end: Some(end), .. })) = &loading {
        let reached = |load: &&f64| rows.iter().any(|row| row.load_g == **load);
        let missing = loads.iter().filter(|load| !reached(load));
        let least = missing.copied().fold(f64::INFINITY, f64::min);
        unreached.note(format!("a load of {least} g is not reached: {end}"));
    }
    Ok(Forces {
        schema: SCHEMA,
        title: printable(scene.title.as_deref().unwrap_or("Untitled scene")),
        mechanics: problem.model().word(),
        virtual_work: worked.map(|(_, told)| told),
        contacts,
        pull_mm,
        by_multipliers: loading.as_ref().map(|(ei, from, loading)| ByMultipliers {
            ei_nmm2: newton_square_millimetres(ei.value()),
            ei_from: from,
            contact_pull_mm: loading.contact.map(millimetres),
            tension_at_contact_g: grams(loading.datum),
        }),
        frictionless: beside.map(|beside| Frictionless {
            contact_pull_mm: beside.contact.map(millimetres),
            tension_at_contact_g: grams(beside.datum),
        }),
        loads: rows,
        reason: unreached.reason(),
    })
}

/// The same robot with a cable that slides without friction, under loads in grams; none
/// where the scene's own is that, or where it has no such cable.
fn frictionless(scene: &Scene, stiffness: Stiffness, loads: &[f64]) -> Option<LoadSteps> {
    if scene.model.mechanics == Mechanics::Sliding && scene.friction.is_none() {
        return None;
    }
    let mut beside = scene.clone();
    beside.model.mechanics = Mechanics::Sliding;
    beside.friction = Friction::default();
    let problem = Problem::new(&beside).ok()?;
    let problem = problem.with_stiffness(stiffness.value());
    let loads: Vec<f64> = loads.iter().map(|load| newtons(*load)).collect();
    LoadSteps::of(&problem, stiffness, &loads).ok()
}

/// The sum of what obstacles press with under a load in newtons, in grams.
fn pressed_g(steps: &LoadSteps, load: f64) -> Option<f64> {
    let state = steps.states.iter().find(|state| state.load == load)?;
    let contacts = state.statics.contacts.iter();
    Some(grams(contacts.map(|contact| contact.normal_force).sum()))
}

/// The estimator of virtual work, with what is told about it.
fn virtual_work(
    what: &Force,
    scene: &Scene,
    problem: &Problem,
    unreached: &mut Unreached,
) -> Result<Option<(VirtualWork, ByVirtualWork)>, BadInput> {
    let tip = problem.robot().segments;
    let node = what.node.unwrap_or(tip);
    let pair = |option, text| numbers::pair(option, text, "write two numbers as 0:10");
    let (first, last) = pair("--window", &what.window)?;
    let window = Window {
        first: metres(first),
        last: metres(last),
    };
    let (mover, motion) = match what.motion {
        Motion::Free => (problem.without_obstacles(), "free"),
        Motion::Contact => (problem.clone(), "contact"),
    };
    let pulls = Sweep::pulls(window.first, window.last, PULLS);
    let Some(sweep) = unreached.but(Sweep::of(&mover, node, &pulls))? else {
        return Ok(None);
    };
    let rates = Rates::fit(&sweep, window).map_err(wrong)?;
    let offset = problem.robot().offset;
    let calibrated =
        |load, force| VirtualWork::calibrated(offset, rates, newtons(load), newtons(force));
    let held = scene.measured.as_ref().and_then(Measurements::calibrating);
    let (estimator, mu_from) = match (&what.measured, what.friction, held) {
        (Some(text), _, _) => {
            let (load, force) = pair("--measured", text)?;
            (calibrated(load, force), "--measured".to_owned())
        }
        (None, Some(friction), _) => (
            VirtualWork::new(offset, rates, friction),
            "--friction".to_owned(),
        ),
        (None, None, Some(reading)) => {
            let (load, force) = (reading.load_g, reading.force_g);
            let from = format!("measured.calibration, {force} g under {load} g");
            (calibrated(load, force), from)
        }
        (None, None, None) => (
            VirtualWork::new(offset, rates, 0.0),
            "none given".to_owned(),
        ),
    };
    let estimator = estimator.map_err(wrong)?;
    let caveats = estimator.caveats(tip);
    let told = ByVirtualWork {
        node,
        motion,
        window_mm: [first, last],
        x: Line::of(&rates.x, millimetres),
        y: Line::of(&rates.y, millimetres),
        slope: Line::of(&rates.angle, degrees),
        mu: estimator.friction(),
        mu_from,
        force_per_load: estimator.force_per_load(),
        caveats: caveats.iter().map(ToString::to_string).collect(),
    };
    Ok(Some((estimator, told)))
}

/// A stiffness with where it comes from, or why there is none.
type Known = Result<Option<(Stiffness, &'static str)>, SweepError>;

/// The stiffness asked for, or else the scene's.
fn stiffness(what: &Force, scene: &Scene, problem: &Problem) -> Result<Known, BadInput> {
    let pair = |option, text| numbers::pair(option, text, "write two numbers as 2.2:3");
    let (made, from) = if let Some(ei) = what.ei {
        (Stiffness::new(newton_square_metres(ei)), "--ei")
    } else if let Some(text) = &what.rod {
        let (young_gpa, diameter_mm) = pair("--rod", text)?;
        let profile = Profile::Rod {
            diameter: metres(diameter_mm.max(0.0)),
        };
        (Stiffness::of_section(pascals(young_gpa), profile), "--rod")
    } else if let Some(text) = &what.weighed {
        let (load_g, pull_mm) = pair("--weighed", text)?;
        if problem.drive().loads.any() {
            return Err(wrong(
                "--weighed cannot tell the stiffness of a robot that other loads bend, too; give \
                 --ei or --rod, or leave out what [loads] says",
            ));
        }
        let (least, most) = problem.pull_range();
        let pull = metres(pull_mm);
        if !(least..=most).contains(&pull) {
            return Ok(Err(SweepError::OutOfRange { pull, least, most }));
        }
        let mut there = problem.clone();
        there.set_pull(pull);
        let solution = solve(&there, Start::Straight, Settings::default());
        if solution.status != Status::Converged {
            let (pull, status) = (solution.pull, solution.status.clone());
            return Ok(Err(SweepError::NotReached { pull, status }));
        }
        let made = Stiffness::calibrated(&solution, newtons(load_g));
        (made, "--weighed")
    } else {
        let held = Stiffness::of_scene(scene).map_err(wrong)?;
        return Ok(Ok(held.map(|ei| (ei, "robot.bending_stiffness_nmm2"))));
    };
    Ok(Ok(Some((made.map_err(wrong)?, from))))
}

/// A contact in words: `D5, cable side, on lower`.
fn label(scene: &Scene, problem: &Problem, contact: &Contact) -> String {
    let obstacle = contact.obstacle;
    let on = scene.obstacles.get(obstacle).map_or_else(String::new, |o| {
        let name = o.name.as_deref().map(printable);
        name.unwrap_or_else(|| format!("{} {obstacle}", o.shape.word()))
    });
    let part = part_name(problem.robot(), contact.line, contact.node);
    format!("{part}, on {on}")
}

/// F/T of every contact at the scene's own pull, which needs no stiffness, or
/// at the last before it that the robot gets to, and that pull in mm.
fn shares(
    scene: &Scene,
    problem: &Problem,
    unreached: &mut Unreached,
) -> (Vec<Share>, Option<f64>) {
    let solution = solve(problem, Start::Straight, Settings::default());
    if solution.status != Status::Converged {
        let reason = solution.status.reason();
        let (all, last) = (driven_shown(problem.drive()), driven_shown(&solution.drive));
        let one_pull = problem.drive().cables.len() == 1 && problem.drive().load().is_none();
        unreached.note(if one_pull {
            let (pull, last) = (pull_shown(problem.pull()), pull_shown(solution.pull));
            format!("the scene's pull of {pull} mm is not reached, only {last} mm: {reason}")
        } else {
            format!("what the scene asks for, {all}, is not reached, only {last}: {reason}")
        });
        if !solution.certificate.holds() {
            return (Vec::new(), None);
        }
    }
    let contacts = solution.contacts.iter().map(|contact| Share {
        contact: label(scene, problem, contact),
        node: contact.node,
        obstacle: contact.obstacle,
        force_over_tension: share_of_tension(&solution, contact),
    });
    (contacts.collect(), Some(millimetres(solution.pull)))
}

fn csv(out: &mut impl Write, found: &Forces) -> io::Result<()> {
    let mut table = ::csv::Writer::from_writer(out);
    csv_row(&mut table, found.columns())?;
    for row in found.rows() {
        csv_row(&mut table, row)?;
    }
    table.flush()
}
