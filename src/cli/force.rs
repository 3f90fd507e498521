//! `sinew force`: contact force against load, by virtual work (eq. 11) and,
//! where the stiffness is known, by multipliers.

use std::io::{self, BufWriter, Write};

use serde::Serialize;

use super::arguments::{Force, Format, Motion};
use super::input::{self, BadInput};
use super::output::{printable, reader};
use super::{Failure, Outcome, numbers};
use crate::equilibrium::{Settings, Start, Status, solve};
use crate::experiments::shown;
use crate::forces::{
    Loading, Profile, Rates, Stiffness, Sweep, SweepError, VirtualWork, Window, part_name,
    share_of_tension,
};
use crate::model::Problem;
use crate::scene::{Measurements, Scene};
use crate::units::{
    degrees, grams, metres, millimetres, newton_square_metres, newton_square_millimetres, newtons,
};

/// Pulls in the window of the fits.
const PULLS: usize = 41;

pub(super) fn run(what: &Force) -> Result<Outcome, Failure> {
    let (scene, problem) = input::problem(&what.scene, None)?;
    let loads = numbers::loads("--loads", &what.loads)?;
    let found = match estimate(what, &scene, &problem, &loads) {
        Ok(found) => found,
        Err(Trouble::Input(input)) => return Err(input.into()),
        Err(Trouble::Sweep(error @ SweepError::NotReached { .. })) => {
            return Ok(Outcome::NotConverged(error.to_string()));
        }
        Err(Trouble::Sweep(error)) => return Err(BadInput::Arguments(error.to_string()).into()),
    };
    let mut out = BufWriter::new(io::stdout().lock());
    let written = match what.format {
        Format::Text => text(&mut out, &found),
        Format::Json => json(&mut out, &found),
        Format::Csv => csv(&mut out, &found),
    };
    reader(written.and_then(|()| out.flush()))?;
    Ok(Outcome::Done)
}

/// What keeps the estimate from being made.
enum Trouble {
    Input(BadInput),
    Sweep(SweepError),
}

impl From<BadInput> for Trouble {
    fn from(input: BadInput) -> Self {
        Trouble::Input(input)
    }
}

impl From<SweepError> for Trouble {
    fn from(error: SweepError) -> Self {
        Trouble::Sweep(error)
    }
}

fn wrong(error: impl std::fmt::Display) -> BadInput {
    BadInput::Arguments(error.to_string())
}

const SCHEMA: &str = "sinew-force-1";

/// Everything that is printed.
#[derive(Serialize)]
struct Found {
    schema: &'static str,
    title: String,
    node: usize,
    motion: &'static str,
    window_mm: [f64; 2],
    x: Line,
    y: Line,
    slope: Line,
    friction: f64,
    /// Where the friction comes from: an option, a field of the scene, or neither.
    friction_from: String,
    force_per_load: f64,
    caveats: Vec<String>,
    /// At the scene's own pull.
    contacts: Vec<Share>,
    pull_mm: f64,
    #[serde(skip_serializing_if = "Option::is_none")]
    by_multipliers: Option<ByMultipliers>,
    loads: Vec<Row>,
}

/// A straight line over the pull: x and y in mm, the slope in degrees.
#[derive(Serialize)]
struct Line {
    per_mm: f64,
    intercept: f64,
    rms_residual: f64,
    max_residual: f64,
    r_squared: f64,
    points: usize,
}

/// A contact's force over the cable's tension.
#[derive(Serialize)]
struct Share {
    contact: String,
    node: usize,
    obstacle: usize,
    #[serde(skip_serializing_if = "Option::is_none")]
    force_over_tension: Option<f64>,
}

#[derive(Serialize)]
struct ByMultipliers {
    ei_n_mm2: f64,
    /// Where it comes from: an option or a field of the scene.
    ei_from: &'static str,
    #[serde(skip_serializing_if = "Option::is_none")]
    contact_pull_mm: Option<f64>,
    datum_g: f64,
}

#[derive(Serialize)]
struct Row {
    load_g: f64,
    force_x_g: f64,
    force_y_g: f64,
    #[serde(skip_serializing_if = "Option::is_none")]
    multipliers: Option<Loaded>,
}

/// The state under a load, by multipliers.
#[derive(Serialize)]
struct Loaded {
    pull_mm: f64,
    tension_g: f64,
    /// The sum of the normal forces on obstacles.
    force_g: f64,
    force_n: f64,
    contacts: Vec<Pressed>,
    clamp_force_n: [f64; 2],
    clamp_moment_n_mm: f64,
    unbalanced_force: f64,
    unbalanced_moment: f64,
}

#[derive(Serialize)]
struct Pressed {
    contact: String,
    node: usize,
    obstacle: usize,
    point_mm: [f64; 2],
    normal: [f64; 2],
    force_g: f64,
    /// What the obstacle exerts on the robot.
    on_robot_n: [f64; 2],
}

fn estimate(
    what: &Force,
    scene: &Scene,
    problem: &Problem,
    loads: &[f64],
) -> Result<Found, Trouble> {
    let tip = problem.robot().segments;
    let node = what.node.unwrap_or(tip);
    let pair = |option, text| numbers::pair(option, text, "write two numbers as 0:10");
    let (first, last) = pair("--window", &what.window)?;
    let window = Window {
        first: metres(first),
        last: metres(last),
    };
    let (mover, motion) = match what.motion {
        Motion::Free => (without_obstacles(problem), "free"),
        Motion::Contact => (problem.clone(), "contact"),
    };
    let pulls = Sweep::pulls(window.first, window.last, PULLS);
    let rates = Rates::fit(&Sweep::of(&mover, node, &pulls)?, window).map_err(wrong)?;
    let offset = problem.robot().offset;
    let calibrated =
        |load, force| VirtualWork::calibrated(offset, rates, newtons(load), newtons(force));
    let held = scene.measured.as_ref().and_then(Measurements::calibrating);
    let (estimator, friction_from) = match (&what.measured, what.friction, held) {
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
    let loading = match stiffness(what, scene, problem)? {
        Some((ei, from)) => {
            let loads: Vec<f64> = loads.iter().map(|load| newtons(*load)).collect();
            Some((ei, from, Loading::of(problem, ei, &loads)?))
        }
        None => None,
    };
    let caveats = estimator.caveats(tip);
    let (contacts, pull_mm) = shares(scene, problem)?;
    let mut rows = Vec::with_capacity(loads.len());
    for (index, load_g) in loads.iter().enumerate() {
        let force = estimator.force(newtons(*load_g)).map_err(wrong)?;
        rows.push(Row {
            load_g: *load_g,
            force_x_g: grams(force.x),
            force_y_g: grams(force.y) + 0.0,
            multipliers: loading
                .as_ref()
                .map(|(_, _, loading)| loaded(scene, problem, &loading.states[index])),
        });
    }
    Ok(Found {
        schema: SCHEMA,
        title: printable(scene.title.as_deref().unwrap_or("Untitled scene")),
        node,
        motion,
        window_mm: [first, last],
        x: line(&rates.x, millimetres),
        y: line(&rates.y, millimetres),
        slope: line(&rates.angle, degrees),
        friction: estimator.friction(),
        friction_from,
        force_per_load: estimator.force_per_load(),
        caveats: caveats.iter().map(ToString::to_string).collect(),
        contacts,
        pull_mm,
        by_multipliers: loading.as_ref().map(|(ei, from, loading)| ByMultipliers {
            ei_n_mm2: newton_square_millimetres(ei.value()),
            ei_from: from,
            contact_pull_mm: loading.contact.map(millimetres),
            datum_g: grams(loading.datum),
        }),
        loads: rows,
    })
}

fn without_obstacles(problem: &Problem) -> Problem {
    let candidates = problem.candidates().to_vec();
    Problem::from_parts(*problem.robot(), problem.pull(), candidates, Vec::new())
}

fn line(fit: &crate::forces::LineFit, unit: fn(f64) -> f64) -> Line {
    Line {
        per_mm: unit(fit.slope * metres(1.0)),
        intercept: unit(fit.intercept),
        rms_residual: unit(fit.rms_residual),
        max_residual: unit(fit.max_residual),
        r_squared: fit.r_squared,
        points: fit.points,
    }
}

/// The stiffness asked for, or else the scene's, with where it comes from.
fn stiffness(
    what: &Force,
    scene: &Scene,
    problem: &Problem,
) -> Result<Option<(Stiffness, &'static str)>, Trouble> {
    let pair = |option, text| numbers::pair(option, text, "write two numbers as 2.2:3");
    let (made, from) = if let Some(ei) = what.ei {
        (Stiffness::new(newton_square_metres(ei)), "--ei")
    } else if let Some(text) = &what.rod {
        let (young_gpa, diameter_mm) = pair("--rod", text)?;
        let profile = Profile::Rod {
            diameter: metres(diameter_mm.max(0.0)),
        };
        (Stiffness::of_section(young_gpa * 1e9, profile), "--rod")
    } else if let Some(text) = &what.weighed {
        let (load_g, pull_mm) = pair("--weighed", text)?;
        let (least, most) = problem.robot().pull_range();
        let pull = metres(pull_mm);
        if !(least..=most).contains(&pull) {
            return Err(SweepError::OutOfRange { pull, least, most }.into());
        }
        let mut there = problem.clone();
        there.set_pull(pull);
        let solution = solve(&there, Start::Straight, Settings::default());
        if solution.status != Status::Converged {
            let (pull, status) = (solution.pull, solution.status);
            return Err(SweepError::NotReached { pull, status }.into());
        }
        let made = Stiffness::calibrated(&there, &solution, newtons(load_g));
        (made, "--weighed")
    } else {
        let held = Stiffness::of_scene(scene).map_err(wrong)?;
        return Ok(held.map(|ei| (ei, "robot.bending_stiffness_nmm2")));
    };
    Ok(Some((made.map_err(wrong)?, from)))
}

/// A contact in words: `disk 6, cable side, on lower`.
fn label(scene: &Scene, part: String, obstacle: usize) -> String {
    let on = scene.obstacles.get(obstacle).map_or_else(String::new, |o| {
        let name = o.name.as_deref().map(printable);
        name.unwrap_or_else(|| format!("{} {obstacle}", o.shape.word()))
    });
    format!("{part}, on {on}")
}

/// F/T of every contact at the scene's own pull, which needs no stiffness.
fn shares(scene: &Scene, problem: &Problem) -> Result<(Vec<Share>, f64), Trouble> {
    let solution = solve(problem, Start::Straight, Settings::default());
    if solution.status != Status::Converged {
        let (pull, status) = (solution.pull, solution.status);
        return Err(SweepError::NotReached { pull, status }.into());
    }
    let contacts = solution.contacts.iter().map(|contact| Share {
        contact: label(scene, part_name(problem.robot(), contact), contact.obstacle),
        node: contact.node,
        obstacle: contact.obstacle,
        force_over_tension: share_of_tension(&solution, contact),
    });
    Ok((contacts.collect(), millimetres(solution.pull)))
}

fn loaded(scene: &Scene, problem: &Problem, state: &crate::forces::Loaded) -> Loaded {
    let statics = &state.statics;
    let total: f64 = statics.contacts.iter().map(|c| c.normal_force).sum();
    let contacts = statics.contacts.iter().map(|force| {
        let contact = &force.contact;
        Pressed {
            contact: label(scene, part_name(problem.robot(), contact), contact.obstacle),
            node: contact.node,
            obstacle: contact.obstacle,
            point_mm: [millimetres(contact.point.x), millimetres(contact.point.y)],
            normal: [contact.normal.x, contact.normal.y],
            force_g: grams(force.normal_force),
            on_robot_n: [force.on_robot.x + 0.0, force.on_robot.y + 0.0],
        }
    });
    Loaded {
        pull_mm: millimetres(state.pull),
        tension_g: grams(statics.tension),
        force_g: grams(total) + 0.0,
        force_n: total + 0.0,
        contacts: contacts.collect(),
        clamp_force_n: [statics.clamp.force.x, statics.clamp.force.y],
        clamp_moment_n_mm: millimetres(statics.clamp.moment),
        unbalanced_force: statics.unbalanced_force,
        unbalanced_moment: statics.unbalanced_moment,
    }
}

fn json(out: &mut impl Write, found: &Found) -> io::Result<()> {
    serde_json::to_writer(&mut *out, found)?;
    writeln!(out)
}

fn csv(out: &mut impl Write, found: &Found) -> io::Result<()> {
    let mut table = ::csv::Writer::from_writer(out);
    let mut head = vec!["load_g", "virtual_work_x_g", "virtual_work_y_g"];
    if found.by_multipliers.is_some() {
        head.extend(["pull_mm", "tension_g", "multipliers_g"]);
    }
    super::output::record(&mut table, head)?;
    for row in &found.loads {
        let mut fields = vec![row.load_g, row.force_x_g, row.force_y_g];
        if let Some(loaded) = &row.multipliers {
            fields.extend([loaded.pull_mm, loaded.tension_g, loaded.force_g]);
        }
        let fields = fields.iter().map(|value| format!("{value:?}"));
        super::output::record(&mut table, fields)?;
    }
    table.flush()
}

fn text(out: &mut impl Write, found: &Found) -> io::Result<()> {
    let [first, last] = found.window_mm;
    writeln!(out, "{}\n", found.title)?;
    writeln!(out, "Virtual work (eq. 11)\n")?;
    let whose = match found.motion {
        "free" => "free robot",
        _ => "robot among its obstacles",
    };
    writeln!(
        out,
        "  motion   node {} of the {whose}, pulls of {first} to {last} mm",
        found.node
    )?;
    for (name, line, unit) in [
        ("x", &found.x, "mm"),
        ("y", &found.y, "mm"),
        ("slope", &found.slope, "deg"),
    ] {
        writeln!(
            out,
            "  {name:<7}  {:>9} {unit}/mm, R² {:.5}, residual {:.3} {unit} RMS, {:.3} at most",
            shown(line.per_mm, 4),
            line.r_squared,
            line.rms_residual,
            line.max_residual
        )?;
    }
    writeln!(
        out,
        "  mu       {:>9} ({})",
        shown(found.friction, 4),
        found.friction_from
    )?;
    writeln!(
        out,
        "  force    {:>9} of the load",
        shown(found.force_per_load, 5)
    )?;
    for caveat in &found.caveats {
        writeln!(out, "  caution: {caveat}")?;
    }
    multipliers(out, found)?;
    table(out, found)
}

fn multipliers(out: &mut impl Write, found: &Found) -> io::Result<()> {
    writeln!(out, "\nMultipliers\n")?;
    match &found.by_multipliers {
        Some(known) => {
            writeln!(
                out,
                "  EI       {:.1} N mm² ({})",
                known.ei_n_mm2, known.ei_from
            )?;
            match known.contact_pull_mm {
                Some(pull) => writeln!(
                    out,
                    "  contact  from a pull of {pull:.3} mm, with {:.1} g on the cable; loads count from there",
                    known.datum_g
                )?,
                None => writeln!(out, "  contact  none; loads count from the straight robot")?,
            }
        }
        None => writeln!(
            out,
            "  Forces need a stiffness: --ei, --rod, --weighed or the scene's. Without one:"
        )?,
    }
    let pull_mm = found.pull_mm;
    if found.contacts.is_empty() {
        writeln!(out, "  At a pull of {pull_mm} mm nothing touches.")?;
    }
    for contact in &found.contacts {
        if let Some(share) = contact.force_over_tension {
            let name = &contact.contact;
            writeln!(
                out,
                "  At a pull of {pull_mm} mm: {share:.5} of the cable's tension at {name} (node {})",
                contact.node
            )?;
        }
    }
    Ok(())
}

fn table(out: &mut impl Write, found: &Found) -> io::Result<()> {
    let both = found.by_multipliers.is_some();
    write!(out, "\n  {:>8}  {:>8}  {:>8}", "load", "P_x", "P_y")?;
    if both {
        write!(
            out,
            "  {:>8}  {:>8}  {:>8}  by multipliers",
            "pull", "tension", "force"
        )?;
    }
    write!(out, "\n  {:>8}  {:>8}  {:>8}", "g", "g", "g")?;
    if both {
        write!(out, "  {:>8}  {:>8}  {:>8}", "mm", "g", "g")?;
    }
    writeln!(out)?;
    for row in &found.loads {
        write!(
            out,
            "  {:>8}  {:>8}  {:>8}",
            row.load_g,
            shown(row.force_x_g, 2),
            shown(row.force_y_g, 2)
        )?;
        if let Some(loaded) = &row.multipliers {
            let parts = loaded.contacts.iter();
            let parts = parts.map(|c| format!("{} g at {}", shown(c.force_g, 2), c.contact));
            write!(
                out,
                "  {:>8.3}  {:>8.1}  {:>8.2}  {}",
                loaded.pull_mm,
                loaded.tension_g,
                loaded.force_g,
                parts.collect::<Vec<_>>().join("; ")
            )?;
        }
        writeln!(out)?;
    }
    Ok(())
}
