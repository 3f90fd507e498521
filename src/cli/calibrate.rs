//! `sinew calibrate`: stiffness and friction from measured forces and pulls.

use std::io::{self, Write};

use super::arguments::{Calibrate, Driving, Format};
use super::input::{self, BadInput};
use super::output::{csv_row, object, paragraph, printable, write_out};
use super::progress::Progress;
use super::{Failure, Outcome, tell};
use crate::experiments::calibration::{
    CalibrationError, Constant as Kind, ReadingErrors, calibrate,
};
use crate::experiments::measured_csv::Trials;
use crate::math::{decimals, shortest, typeset, unsigned_zero};
use crate::record::calibration::{Calibration, Constant};
use crate::scene::limits::shown;

/// Evaluations of a usual fit, for the progress bar; it stays full after them.
const USUAL: u32 = 100;

/// A difference of a row, in standard errors of all, from which on it is told: one in
/// four hundred is as far off by chance.
const FAR: f64 = 3.0;

pub(super) fn run(what: &Calibrate) -> Result<Outcome, Failure> {
    let constants = Kind::list(&what.fit).map_err(|fault| bad(&format!("--fit: {fault}")))?;
    let errors = ReadingErrors {
        force_g: positive("--force-error", what.force_error, "g")?,
        pull_mm: positive("--pull-error", what.pull_error, "mm")?,
    };
    let (scene, _) = input::problem(&what.scene, &what.edits, &Driving::default())?;
    let origin = input::origin(&what.measured);
    let read = input::bytes(&what.measured, "measurements are a CSV text file")
        .and_then(|bytes| Ok(Trials::read(&bytes)?));
    let (trials, left_out) = read.map_err(|error| BadInput::from(error.context(origin.clone())))?;
    if !left_out.rows().is_empty() {
        tell(&format!("{origin}: {left_out}"));
    }
    let mut progress = Progress::new("fitting", USUAL);
    let found = calibrate(&scene, &trials, &constants, errors, &mut |evaluation| {
        progress.at((evaluation as u32).min(USUAL));
    });
    drop(progress);
    let found = match found {
        Ok(found) => found,
        Err(fault) => {
            let told = match &fault {
                CalibrationError::NoStiffness => {
                    format!("{}: {fault}", input::origin(&what.scene))
                }
                _ => format!("{origin}: {fault}"),
            };
            return if fault.is_of_the_solver() {
                Ok(Outcome::NotConverged(told))
            } else {
                Err(bad(&told).into())
            };
        }
    };
    let title = scene.title.as_deref().unwrap_or("Untitled scene");
    let record = Calibration::of(&found, title.to_owned(), &scene);
    write_out(|out| match what.format {
        Format::Text => text(out, &record),
        Format::Json => object(out, &record),
        Format::Csv => csv(out, &record),
    })?;
    Ok(Outcome::Done)
}

fn bad(told: &str) -> BadInput {
    BadInput::Arguments(told.to_owned())
}

fn positive(option: &str, value: f64, unit: &str) -> Result<f64, BadInput> {
    if value > 0.0 && value.is_finite() {
        return Ok(value);
    }
    Err(bad(&format!(
        "{option} is {} {unit}; it has to be above 0",
        shown(value)
    )))
}

fn text(out: &mut impl Write, record: &Calibration) -> io::Result<()> {
    writeln!(out, "{}\n", printable(&record.title))?;
    let count = |of: &dyn Fn(&crate::record::calibration::Row) -> Option<f64>| {
        record.rows.iter().filter(|row| of(row).is_some()).count()
    };
    let (forces, pulls) = (
        count(&|row| row.read_force_g),
        count(&|row| row.read_pull_mm),
    );
    let mut left = Vec::new();
    if let Some(rms) = record.force_rms_g {
        left.push(format!("RMS {} g over {forces} forces", decimals(rms, 4)));
    }
    if let Some(rms) = record.pull_rms_mm {
        left.push(format!("RMS {} mm over {pulls} pulls", decimals(rms, 4)));
    }
    let but = match record.scene_mechanics {
        "equal" => " (the scene says equal, which knows no friction)",
        _ => "",
    };
    writeln!(out, "  mechanics  {}{but}", record.mechanics)?;
    writeln!(out, "  left       {}", left.join(", "))?;
    writeln!(out, "  steps      {}\n", record.iterations)?;
    writeln!(out, "  constant          value         error  key")?;
    for constant in &record.constants {
        let error = match constant.error {
            _ if constant.at_bound => "at its bound".to_owned(),
            _ if record.open.contains(&constant.name) => "open".to_owned(),
            Some(error) => figures(constant, error),
            None => "-".to_owned(),
        };
        writeln!(
            out,
            "  {:<9}  {:>12}  {error:>12}  {}",
            constant.name,
            figures(constant, constant.value),
            constant.key
        )?;
    }
    if record.constants.len() > 1 {
        correlation(out, record)?;
    }
    writeln!(out)?;
    for sentence in sentences(record) {
        paragraph(out, "  ", &sentence)?;
    }
    Ok(())
}

fn correlation(out: &mut impl Write, record: &Calibration) -> io::Result<()> {
    write!(out, "\n  correlation")?;
    for constant in &record.constants {
        write!(out, "  {:>9}", constant.name)?;
    }
    writeln!(out)?;
    for (constant, row) in record.constants.iter().zip(&record.correlation) {
        write!(out, "  {:<11}", constant.name)?;
        for value in row {
            let cell = value.map_or("-".to_owned(), |value| typeset(value, 4));
            write!(out, "  {cell:>9}")?;
        }
        writeln!(out)?;
    }
    Ok(())
}

/// A number in a constant's unit.
fn figures(constant: &Constant, value: f64) -> String {
    if constant.key == Kind::Stiffness.key() {
        decimals(value, 1)
    } else {
        decimals(unsigned_zero(value), 4)
    }
}

/// What the data say of the constants, and what they do not.
fn sentences(record: &Calibration) -> Vec<String> {
    let mut told = Vec::new();
    for group in &record.unseparated {
        let exchange = group.exchange.iter().map(|part| {
            let constant = record.constants.iter().find(|it| it.name == part.name);
            let size = constant.map_or_else(String::new, |it| figures(it, part.by.abs()));
            let sign = if part.by < 0.0 { '−' } else { '+' };
            format!("{} {sign}{size}", part.name)
        });
        let exchange: Vec<String> = exchange.collect();
        told.push(format!(
            "The data cannot tell {} apart: they can be exchanged for one another with hardly a \
             change of what is computed, as by {}. Only what they do together is known; fix all \
             but one by other measurements.",
            listed(&group.names),
            exchange.join(", ")
        ));
    }
    for constant in &record.constants {
        let (name, value) = (constant.name, constant.value);
        if record.without_effect.contains(&name) {
            told.push(format!("Nothing that was read depends on {name}."));
        } else if constant.at_bound {
            told.push(format!(
                "{name} is at the bound of its range, {}: the data ask for a value beyond it.",
                figures(constant, value)
            ));
        } else if record.open.contains(&name) {
            told.push(format!(
                "The data leave {name} open: even if all else were known, what was read would \
                 hardly change with it."
            ));
        }
    }
    let all_told = record.unseparated.is_empty() && record.open.is_empty();
    if record.constants.len() > 1 && all_told && record.without_effect.is_empty() {
        told.push("The data tell these constants apart.".to_owned());
    }
    if let Some(rms) = record.force_rms_g {
        let far = record.rows.iter().filter_map(|row| {
            let off = row.force_g - row.read_force_g?;
            (off.abs() > FAR * rms).then(|| row.row.to_string())
        });
        let far: Vec<String> = far.collect();
        if !far.is_empty() {
            told.push(format!(
                "More than {FAR} times the RMS off: the force of row {}.",
                far.join(", ")
            ));
        }
    }
    told
}

fn listed(names: &[&str]) -> String {
    match names {
        [] => String::new(),
        [name] => (*name).to_owned(),
        [names @ .., last] => format!("{} and {last}", names.join(", ")),
    }
}

fn csv(out: &mut impl Write, record: &Calibration) -> io::Result<()> {
    let mut table = ::csv::Writer::from_writer(out);
    csv_row(
        &mut table,
        [
            "row",
            "load_g",
            "pull_mm",
            "read_pull_mm",
            "force_g",
            "read_force_g",
        ],
    )?;
    let or_empty = |value: Option<f64>| value.map(shortest).unwrap_or_default();
    for row in &record.rows {
        csv_row(
            &mut table,
            [
                row.row.to_string(),
                shortest(row.load_g),
                shortest(row.pull_mm),
                or_empty(row.read_pull_mm),
                shortest(row.force_g),
                or_empty(row.read_force_g),
            ],
        )?;
    }
    table.flush()
}
