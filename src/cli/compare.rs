//! `sinew compare`: a measured backbone against the computed one.

use std::fs;
use std::io::{self, Write};

use super::arguments::{Compare, Driving, Format};
use super::input::{self, BadInput};
use super::output::{csv_row, object, printable, pull_shown, write_out};
use super::progress::Progress;
use super::{Failure, Outcome, tables};
use crate::equilibrium::{Settings, Solved, Start, Status, solve};
use crate::experiments::measured_csv::LeftOut;
use crate::experiments::{Measured, ShapeError, ShapeFit, best_pull, compare};
use crate::math::decimals;
use crate::mechanics::Problem;
use crate::record::Fit;
use crate::report::chart;
use crate::scene::Scene;
use crate::view::compared;

/// Steps of the progress bar.
const RESOLUTION: u32 = 1000;

pub(super) fn run(what: &Compare) -> Result<Outcome, Failure> {
    let standard_input = |path: &std::path::PathBuf| path.as_os_str() == "-";
    if standard_input(&what.scene) && what.measured.as_ref().is_some_and(standard_input) {
        let both = "the scene and the measured backbone cannot both be standard input";
        return Err(BadInput::Arguments(both.to_owned()).into());
    }
    let (scene, problem) = input::problem(&what.scene, &what.edits, &Driving::of_pull(what.pull))?;
    let (measured, left_out) = match &what.measured {
        Some(path) => tables::measured(path, &problem)?,
        None => {
            let origin = input::origin(&what.scene);
            let measured = held(&scene, &problem, &origin)?.ok_or_else(|| none_held(&origin))?;
            (measured, LeftOut::default())
        }
    };
    let (solved, fit, how, ended) = match what.pull {
        Some(_) => {
            let solution = solve(&problem, Start::Straight, Settings::default());
            let reason = match &solution.status {
                Status::Converged => None,
                status => Some(format!(
                    "not converged at pull {} mm: {}",
                    pull_shown(problem.pull()),
                    status.reason()
                )),
            };
            if let Some(reason) = &reason
                && !solution.certificate.holds()
            {
                return Ok(Outcome::NotConverged(reason.clone()));
            }
            let how = match reason {
                Some(_) => "the last good before the one given",
                None => "given",
            };
            let ended = reason.map(|reason| {
                let last = pull_shown(solution.pull);
                format!("{reason}; the last good state, at pull {last} mm, is compared")
            });
            let fit = compare(&solution, &measured);
            (solution, fit, how, ended)
        }
        None => match best(&problem, &measured) {
            Ok((solved, fit)) => (solved, fit, "best fit", None),
            Err(ShapeError::NotReached(status)) => {
                return Ok(Outcome::NotConverged(status.reason()));
            }
        },
    };
    if let Some(path) = &what.out {
        let picture = chart::svg_file(&compared(&solved, &measured, &fit))
            .map_err(|error| Failure::Making(error.into()))?;
        fs::write(path, picture).map_err(|error| super::draw::named(path, &error))?;
    }
    let title = printable(scene.title.as_deref().unwrap_or("Untitled scene"));
    let found = Fit::of(title, how, solved.problem(), &measured, &fit).leaving_out(left_out.rows());
    write_out(|out| match what.format {
        Format::Text => text(out, &found, &left_out),
        Format::Json => object(out, &found),
        Format::Csv => csv(out, &found),
    })?;
    // The other formats hold it.
    if !left_out.rows().is_empty() && what.format == Format::Csv {
        super::tell(&left_out.to_string());
    }
    Ok(ended.map_or(Outcome::Done, Outcome::NotConverged))
}

/// The best pull, with a bar for whoever waits.
fn best(problem: &Problem, measured: &Measured) -> Result<(Solved, ShapeFit), ShapeError> {
    let mut progress = Progress::new("fitting", RESOLUTION);
    best_pull(problem, measured, |share| {
        progress.at((share * f64::from(RESOLUTION)) as u32);
    })
}

/// The measured backbone that the scene itself holds, if any.
pub(super) fn held(
    scene: &Scene,
    problem: &Problem,
    origin: &str,
) -> Result<Option<Measured>, BadInput> {
    let held = scene.measured.as_ref();
    let held = held.filter(|held| !held.points_mm.is_empty());
    held.map(|held| Measured::of_scene(held, problem))
        .transpose()
        .map_err(|fault| BadInput::Arguments(format!("{origin}: measured.points_mm: {fault}")))
}

fn none_held(origin: &str) -> BadInput {
    BadInput::Arguments(format!(
        "{origin}: the scene holds no measured backbone; name a CSV file of one, or add \
         measured.points_mm"
    ))
}

fn text(out: &mut impl Write, found: &Fit, left_out: &LeftOut) -> io::Result<()> {
    writeln!(out, "{}\n", found.title)?;
    let pull = decimals(found.pull_mm, 3);
    writeln!(out, "  pull     {pull} mm ({})", found.pull)?;
    writeln!(
        out,
        "  RMS      {:.3} mm, {:.2} % of the length",
        found.rms_mm, found.rms_percent_of_length
    )?;
    writeln!(
        out,
        "  maximum  {:.3} mm, {:.2} % of the length, at row {}",
        found.max_mm, found.max_percent_of_length, found.max_row
    )?;
    writeln!(
        out,
        "  points   {}, each against {}",
        found.points.len(),
        found.against
    )?;
    writeln!(
        out,
        "  length   {:.1} mm through the points, {:.1} % of the robot's",
        found.length_mm, found.length_percent
    )?;
    if !found.left_out.is_empty() {
        writeln!(out, "  caution: {left_out}")?;
    }
    Ok(())
}

fn csv(out: &mut impl Write, fit: &Fit) -> io::Result<()> {
    let mut table = ::csv::Writer::from_writer(out);
    csv_row(&mut table, Fit::COLUMNS)?;
    for row in fit.rows() {
        csv_row(&mut table, row)?;
    }
    table.flush()
}
