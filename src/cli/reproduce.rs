//! `sinew reproduce`: the paper's figures and table, printed and as a page.

use std::fs;
use std::io::{self, Write};
use std::path::Path;

use serde::Serialize;

use super::arguments::{Report, Reproduce};
use super::draw::named;
use super::input::BadInput;
use super::output::{object, paragraph, printable, write_out};
use super::{Failure, Outcome, tables};
use crate::experiments::{self, Check, Id, Item, Picture};
use crate::math::shortest;
use crate::report::{chart, page, svg};
use crate::view::{Axis, Chart, Notes, charts, draw};

pub(super) fn run(what: &Reproduce) -> Result<Outcome, Failure> {
    let ids = wanted(&what.items)?;
    let table = tables::table_1()?;
    let made: Result<Vec<Item>, _> = ids
        .iter()
        .map(|id| experiments::reproduce(*id, &table))
        .collect();
    let items = made.map_err(|error| Failure::Making(error.into()))?;
    write_report(&what.out, &items)?;
    write_out(|out| match what.format {
        Report::Text => text(out, &items, &what.out),
        Report::Json => json(out, &items),
    })?;
    Ok(Outcome::Done)
}

/// The items named, in the paper's order and each once.
fn wanted(words: &[String]) -> Result<Vec<Id>, BadInput> {
    if words.is_empty() {
        return Ok(Id::ALL.to_vec());
    }
    let mut ids = Vec::new();
    for word in words {
        match Id::of_word(word) {
            Some(id) => ids.push(id),
            None => {
                let known: Vec<&str> = Id::ALL.iter().map(|id| id.word()).collect();
                return Err(BadInput::Arguments(format!(
                    "{} is no figure or table that can be recomputed; choose from {}",
                    printable(word),
                    known.join(", ")
                )));
            }
        }
    }
    ids.sort_unstable();
    ids.dedup();
    Ok(ids)
}

/// The page, the curves' data and the figures.
fn write_report(folder: &Path, items: &[Item]) -> Result<(), Failure> {
    let drawn = |error: chart::ChartError| Failure::Making(error.into());
    let (data, figures) = (folder.join("data"), folder.join("figures"));
    for needed in [&data, &figures] {
        fs::create_dir_all(needed).map_err(|error| named(needed, &error))?;
    }
    let write = |path: &Path, contents: &str| -> Result<(), Failure> {
        Ok(fs::write(path, contents).map_err(|error| named(path, &error))?)
    };
    for item in items {
        for one in &charts(item) {
            let name = format!("{}-{}", item.id.word(), one.word);
            write(&data.join(format!("{name}.csv")), &curves(one)?)?;
            let picture = chart::svg_file(one).map_err(drawn)?;
            write(&figures.join(format!("{name}.svg")), &picture)?;
        }
        let name = format!("{}-comparison.csv", item.id.word());
        write(&data.join(name), &comparison(&item.checks)?)?;
    }
    let mut pictures = Vec::with_capacity(items.len());
    for item in items {
        let mut shown = Vec::with_capacity(item.pictures.len());
        for one in &item.pictures {
            let svg = robot(one);
            let name = format!("{}-{}.svg", item.id.word(), one.word);
            write(&figures.join(name), &svg)?;
            shown.push(page::Figure {
                title: one.title.clone(),
                element: page::image(&svg, &one.title),
            });
        }
        pictures.push(shown);
    }
    let html = page::html(items, &pictures).map_err(drawn)?;
    write(&folder.join("report.html"), &html)
}

/// A shape as a picture.
fn robot(one: &Picture) -> String {
    let notes = Notes {
        names: one.names.clone(),
        ..Notes::default()
    };
    let drawing = draw(&one.solved, &notes);
    svg::render_adaptive(&drawing, svg::Size::suiting(&drawing))
}

/// A chart's curves as CSV: a row for each point, with its curve's name.
fn curves(one: &Chart) -> io::Result<String> {
    let head = |axis: &Axis| match axis.unit {
        "" => axis.name.to_owned(),
        unit => format!("{} [{unit}]", axis.name),
    };
    let mut rows = vec![vec!["curve".to_owned(), head(&one.x), head(&one.y)]];
    for series in &one.series {
        for (x, y) in &series.points {
            rows.push(vec![series.name.clone(), shortest(*x), shortest(*y)]);
        }
    }
    csv_text(&rows)
}

/// An item's comparison as CSV, with all digits.
fn comparison(checks: &[Check]) -> io::Result<String> {
    let head = [
        "quantity",
        "unit",
        "relation",
        "paper",
        "ours",
        "difference",
        "verdict",
    ];
    let mut rows = vec![head.map(str::to_owned).to_vec()];
    let number = |value: Option<f64>| value.map_or(String::new(), shortest);
    for check in checks {
        rows.push(vec![
            check.quantity.clone(),
            check.unit.to_owned(),
            check.relation.to_owned(),
            number(check.paper),
            number(check.ours),
            number(check.difference()),
            check.verdict.word().to_owned(),
        ]);
    }
    csv_text(&rows)
}

fn csv_text(rows: &[Vec<String>]) -> io::Result<String> {
    let mut table = ::csv::Writer::from_writer(Vec::new());
    for row in rows {
        table.write_record(row).map_err(io::Error::other)?;
    }
    let bytes = table.into_inner().map_err(io::Error::other)?;
    String::from_utf8(bytes).map_err(io::Error::other)
}

fn text(out: &mut impl Write, items: &[Item], folder: &Path) -> io::Result<()> {
    for item in items {
        writeln!(out, "{}  {}\n", item.id.name(), item.title)?;
        paragraph(out, "  ", &item.about)?;
        writeln!(out)?;
        let widest = item.checks.iter().map(|check| label(check).chars().count());
        let width = widest.max().unwrap_or(0).max("quantity".len());
        writeln!(
            out,
            "  {:<width$}  {:>10}  {:>10}  {:>10}  verdict",
            "quantity", "paper", "ours", "difference"
        )?;
        for check in &item.checks {
            let [paper, ours, difference] = page::cells(check);
            writeln!(
                out,
                "  {:<width$}  {paper:>10}  {ours:>10}  {difference:>10}  {}",
                label(check),
                check.verdict.word()
            )?;
        }
        for note in &item.notes {
            writeln!(out)?;
            paragraph(out, "  ", note)?;
        }
        for sentence in &item.missing {
            writeln!(out)?;
            paragraph(out, "  Not in the text: ", sentence)?;
        }
        writeln!(out)?;
    }
    let report = folder.join("report.html");
    writeln!(out, "Report: {}", printable(&report.display().to_string()))
}

fn label(check: &Check) -> String {
    match check.unit {
        "" => check.quantity.clone(),
        unit => format!("{}, {unit}", check.quantity),
    }
}

/// The version of the keys below.
const SCHEMA: &str = "sinew-reproduce-1";

#[derive(Serialize)]
struct ItemsJson<'a> {
    schema: &'static str,
    items: Vec<ItemJson<'a>>,
}

#[derive(Serialize)]
struct ItemJson<'a> {
    id: &'static str,
    name: &'static str,
    title: &'static str,
    about: &'a str,
    checks: Vec<CheckJson<'a>>,
    charts: Vec<ChartJson>,
    notes: &'a [String],
    missing: &'a [String],
}

/// A check; what there is none of is left out.
#[derive(Serialize)]
struct CheckJson<'a> {
    quantity: &'a str,
    unit: &'static str,
    relation: &'static str,
    #[serde(skip_serializing_if = "Option::is_none")]
    paper: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    ours: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    difference: Option<f64>,
    verdict: &'static str,
}

#[derive(Serialize)]
struct ChartJson {
    title: String,
    x: String,
    y: String,
    series: Vec<SeriesJson>,
}

#[derive(Serialize)]
struct SeriesJson {
    name: String,
    points: Vec<(f64, f64)>,
}

fn json(out: &mut impl Write, items: &[Item]) -> io::Result<()> {
    let axis = |axis: &Axis| format!("{} {}", axis.name, axis.unit).trim().to_owned();
    let items = items.iter().map(|item| ItemJson {
        id: item.id.word(),
        name: item.id.name(),
        title: item.title,
        about: &item.about,
        checks: item
            .checks
            .iter()
            .map(|check| CheckJson {
                quantity: &check.quantity,
                unit: check.unit,
                relation: check.relation,
                paper: check.paper,
                ours: check.ours,
                difference: check.difference(),
                verdict: check.verdict.word(),
            })
            .collect(),
        charts: charts(item)
            .into_iter()
            .map(|chart| ChartJson {
                title: chart.title,
                x: axis(&chart.x),
                y: axis(&chart.y),
                series: chart
                    .series
                    .into_iter()
                    .map(|series| SeriesJson {
                        name: series.name,
                        points: series.points,
                    })
                    .collect(),
            })
            .collect(),
        notes: &item.notes,
        missing: &item.missing,
    });
    let all = ItemsJson {
        schema: SCHEMA,
        items: items.collect(),
    };
    object(out, &all)
}
