//! `sinew cycle`: a cable's pull or load there and back, and the loop of load against
//! pull.

use std::fs;
use std::io::{self, Write};

use super::arguments::{Cycle as Asked, Driving, Format};
use super::draw::named;
use super::input::{self, BadInput};
use super::output::{csv_row, object, write_out};
use super::progress::Progress;
use super::{Failure, Outcome, numbers};
use crate::explore::{Course, Cycle, Given};
use crate::forces::Stiffness;
use crate::math::{decimals, shortest, unsigned_zero};
use crate::mechanics::{Model, Problem};
use crate::record::cycle::{Cycle as Record, Row};
use crate::report::chart;
use crate::scene::limits;
use crate::units::{grams, metres, millimetres, newtons};
use crate::view::{Axis, Chart, CurveStyle, Series};

/// Steps of the progress bar.
const RESOLUTION: u32 = 1000;

pub(super) fn run(what: &Asked) -> Result<Outcome, Failure> {
    let (given, listed) = match (&what.pull, &what.load) {
        (Some(pulls), _) => (Given::Pull, numbers::course("--pull", pulls, "mm")?),
        (None, loads) => {
            let loads = loads.as_deref().unwrap_or_default();
            (Given::Load, numbers::course("--load", loads, "grams")?)
        }
    };
    let driving = Driving {
        pull: (given == Given::Pull).then(|| listed[0]),
        load: (given == Given::Load).then(|| listed[0]),
        cable: what.cable,
    };
    let (scene, problem) = input::problem(&what.scene, &what.edits, &driving)?;
    check(given, &listed, &problem)?;
    let cable = what.cable.unwrap_or(0);
    let si = |value: &f64| match given {
        Given::Pull => metres(*value),
        Given::Load => newtons(*value),
    };
    let course = Course {
        cable,
        given,
        waypoints: listed.iter().map(si).collect(),
        steps: what.steps as usize,
    };
    let mut progress = Progress::new("following", RESOLUTION);
    let found = Cycle::follow(&problem, &course, |share| {
        progress.at((share * f64::from(RESOLUTION)) as u32);
    });
    drop(progress);
    // Its range was checked with the scene's.
    let stiffness = Stiffness::of_scene(&scene).ok().flatten();
    let per_bend = stiffness.map(|stiffness| stiffness.per_bend(&problem));
    let title = scene
        .title
        .clone()
        .unwrap_or_else(|| input::origin(&what.scene));
    let record = Record::of(&found, cable, title, per_bend);
    if let Some(path) = &what.out {
        let picture = picture(&record).ok_or_else(|| {
            let needs = "--out draws the load, which needs robot.bending_stiffness_nmm2, and two \
                         states";
            BadInput::Arguments(needs.to_owned())
        })?;
        fs::write(path, picture).map_err(|error| named(path, &error))?;
    }
    write_out(|out| match what.format {
        Format::Text => text(out, &record),
        Format::Json => object(out, &record),
        Format::Csv => csv(out, &record),
    })?;
    Ok(match &record.reason {
        None => Outcome::Done,
        Some(reason) => Outcome::NotConverged(format!(
            "after {} of {} states: {reason}",
            record.rows.len(),
            1 + (listed.len() - 1) * what.steps as usize
        )),
    })
}

/// Refuses waypoints that no scene could hold.
fn check(given: Given, listed: &[f64], problem: &Problem) -> Result<(), BadInput> {
    if problem.model() == Model::Equal && given == Given::Load {
        let told = "--load cannot be followed in the paper's model yet; give --pull, or set \
                    model.mechanics to \"sliding\"";
        return Err(BadInput::Arguments(told.to_owned()));
    }
    let (least, most, unit) = match given {
        Given::Pull => {
            let (least, most) = problem.pull_range();
            (millimetres(least), millimetres(most), "mm")
        }
        Given::Load => (0.0, 1e6, "g"),
    };
    match listed.iter().find(|value| !(least..=most).contains(*value)) {
        None => Ok(()),
        Some(value) => Err(BadInput::Arguments(format!(
            "the waypoint {} {unit} is not from {} to {} {unit}",
            limits::shown(*value),
            decimals(least, 1),
            decimals(most, 1)
        ))),
    }
}

fn text(out: &mut impl Write, record: &Record) -> io::Result<()> {
    writeln!(out, "{}\n", record.title)?;
    writeln!(
        out,
        "  leg    pull, mm    load, g    far end, g    force, g    tip x, mm    tip y, mm  holes"
    )?;
    for row in &record.rows {
        let cell = |value: Option<f64>| {
            value.map_or("-".to_owned(), |n| decimals(unsigned_zero(grams(n)), 2))
        };
        let far = row.tensions_n.as_ref().and_then(|all| all.last().copied());
        writeln!(
            out,
            "  {:>3}  {:>10}  {:>9}  {:>12}  {:>10}  {:>11}  {:>11}  {}",
            row.leg,
            decimals(unsigned_zero(row.pull_mm), 4),
            cell(row.load_n),
            cell(far),
            cell(pressed(row)),
            decimals(unsigned_zero(row.tip_mm[0]), 4),
            decimals(row.tip_mm[1], 4),
            signs(row),
        )?;
    }
    if record.rows.iter().any(|row| row.slips.is_some()) {
        writeln!(
            out,
            "\n  Holes from the base: < slips towards it, > towards the tip, . sticks."
        )?;
    }
    if let Some(work) = &record.work {
        writeln!(
            out,
            "\n  Work of cables and loads {} N mm: {} stored at the end, {} lost to friction and \
             jumps.\n  The cable's own, over its pull: {} N mm.",
            decimals(work.done_nmm, 3),
            decimals(work.stored_nmm, 3),
            decimals(unsigned_zero(work.lost_nmm), 3),
            decimals(work.loop_nmm, 3)
        )?;
    }
    Ok(())
}

/// The sum of the contacts' normal forces, in N.
fn pressed(row: &Row) -> Option<f64> {
    let forces = row.contacts.iter().map(|contact| contact.force_n);
    row.load_n.and(Some(forces.flatten().sum()))
}

fn signs(row: &Row) -> String {
    let slips = row.slips.iter().flatten();
    slips
        .map(|slip| match *slip {
            "in" => '<',
            "out" => '>',
            _ => '.',
        })
        .collect()
}

fn csv(out: &mut impl Write, record: &Record) -> io::Result<()> {
    let mut table = ::csv::Writer::from_writer(out);
    let stretches = record.rows.first().and_then(|row| row.tensions_n.as_ref());
    let count = stretches.map_or(0, Vec::len);
    let mut head: Vec<String> = [
        "leg",
        "pull_mm",
        "load_n",
        "force_n",
        "tip_x_mm",
        "tip_y_mm",
        "tip_bend_deg",
        "energy_nmm",
        "slips",
    ]
    .map(str::to_owned)
    .into();
    head.extend((1..=count).map(|k| format!("tension_{k}_n")));
    csv_row(&mut table, &head)?;
    for row in &record.rows {
        let or_empty = |value: Option<f64>| value.map(shortest).unwrap_or_default();
        let mut cells = vec![
            row.leg.to_string(),
            shortest(row.pull_mm),
            or_empty(row.load_n),
            or_empty(pressed(row)),
            shortest(row.tip_mm[0]),
            shortest(row.tip_mm[1]),
            shortest(row.tip_bend_deg),
            or_empty(row.energy_nmm),
            signs(row),
        ];
        cells.extend(
            row.tensions_n
                .iter()
                .flatten()
                .map(|tension| shortest(*tension)),
        );
        csv_row(&mut table, &cells)?;
    }
    table.flush()
}

/// The loop of load against pull, leg by leg.
fn picture(record: &Record) -> Option<String> {
    let legs = record.rows.last()?.leg;
    let series = (1..=legs).map(|leg| {
        let first = record
            .rows
            .iter()
            .position(|row| row.leg == leg)?
            .checked_sub(1)?;
        let rows = record.rows.iter().skip(first);
        let points = rows
            .take_while(|row| row.leg <= leg)
            .map(|row| Some((row.pull_mm, grams(row.load_n?))));
        let points: Option<Vec<(f64, f64)>> = points.collect();
        let style = if leg % 2 == 1 {
            CurveStyle::Line
        } else {
            CurveStyle::Dashed
        };
        Some(Series::new(format!("leg {leg}"), style, points?))
    });
    let series: Option<Vec<Series>> = series.collect();
    let chart = Chart {
        title: format!("{}: load against pull", record.title),
        word: "cycle",
        x: Axis::new("pull", "mm"),
        y: Axis::new("load on the cable", "g"),
        series: series.filter(|series| !series.is_empty())?,
    };
    chart::svg_file(&chart).ok()
}
