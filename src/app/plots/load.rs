//! The load on a cable against its pull: what a hand did, there and back, as a line
//! with the present on it, over the curve of the path from the straight robot.

use super::cache::PlotCache;
use super::data::{Link, Plot, PlotData};
use super::multipliers::ceiling;
use super::over_pull::{Cursor, Edges, Knob, read_at};
use super::pane::{
    Asked, Quantities, Surface, Text, Whole, canvas, cell, empty, header, hue, named, ordinate,
};
use super::tension::in_unit;
use crate::app::look::{Tokens, theme_of};
use crate::app::workbench::Hovered;
use crate::units::{grams, millimetres, per_millimetre};
use crate::view::{Axis, Chart, CurveStyle, Quantity, Series};
use eframe::egui::{Color32, Stroke, Ui, vec2};
use egui_plot::{Line, PlotPoint};

/// A hand has gone through pulls that are worth a scale of their own once they are so
/// far apart, over the greatest pull of the path.
const WORTH: f64 = 0.02;

/// What the plot shows: pulls, in mm, and loads, as computed.
struct Extent {
    pulls: [f64; 2],
    loads: [f64; 2],
}

impl Extent {
    /// What a hand has gone through, its pulls in steps so that the axis keeps still;
    /// before that the whole path, but for the last shapes of a branch, which need
    /// more load without bound.
    fn of(data: &PlotData<'_>, cache: &PlotCache) -> Self {
        let per_bend = per_bend(data);
        let walked = data.walked.iter();
        let walked = walked.filter_map(|step| step.cables.get(data.cable));
        let pulls: Vec<f64> = walked.clone().map(|it| millimetres(it.pull)).collect();
        let loads = walked.map(|it| per_bend * it.load);
        let loads = about(loads);
        let end = path(data, cache).last().and_then(|piece| piece.last());
        let end = end.map_or(0.0, |point| point.x);
        let first = pulls.first().copied().unwrap_or(0.0);
        let goes = pulls.iter().any(|pull| (pull - first).abs() > WORTH * end);
        let pulls = about(pulls.into_iter());
        if goes {
            let pulls = pulls.map(stepped);
            return Self { pulls, loads };
        }
        Self {
            pulls: [pulls[0], pulls[1].max(end)],
            loads: [loads[0], loads[1].max(cache.forces.widest_load)],
        }
    }
}

/// The least and the greatest of some values and zero.
fn about(values: impl Iterator<Item = f64>) -> [f64; 2] {
    values.fold([0.0, 0.0], |[least, most]: [f64; 2], value| {
        [least.min(value), most.max(value)]
    })
}

/// The end of an axis that is to show a value on the way from zero.
fn stepped(value: f64) -> f64 {
    match value {
        value if value > 0.0 => ceiling(value),
        value if value < 0.0 => -ceiling(-value),
        _ => 0.0,
    }
}

/// What a hand did, as pieces between jumps, in mm and the unit of the axis.
fn walked(data: &PlotData<'_>, factor: f64) -> Vec<Vec<PlotPoint>> {
    let mut pieces: Vec<Vec<PlotPoint>> = vec![Vec::new()];
    for step in data.walked {
        let Some(loaded) = step.cables.get(data.cable) else {
            continue;
        };
        let point = PlotPoint::new(millimetres(loaded.pull), factor * loaded.load);
        if step.is_leap {
            pieces.push(Vec::new());
        }
        if let Some(piece) = pieces.last_mut() {
            piece.push(point);
        }
    }
    pieces.retain(|piece| !piece.is_empty());
    pieces
}

/// Newtons in a tension without its stiffness, or 1.
fn per_bend(data: &PlotData<'_>) -> f64 {
    data.stiffness()
        .map_or(1.0, |ei| ei.per_bend(data.problem()))
}

/// The path's curve, which is that of the first cable.
fn path<'a>(data: &PlotData<'_>, cache: &'a PlotCache) -> &'a [Vec<PlotPoint>] {
    match data.cable {
        0 => &cache.forces.loads,
        _ => &[],
    }
}

/// The curves of pinned robots, as far as they are inside, in their colours.
fn pinned(
    data: &PlotData<'_>,
    extent: &Extent,
    most: f64,
    tokens: &Tokens,
) -> Vec<(Vec<PlotPoint>, Color32)> {
    let known = data.stiffness().is_some() && data.cable == 0;
    let pins = data.pins.iter().filter(|_| known);
    let known = pins.filter_map(|pin| Some((pin, pin.path.as_ref()?, pin.newtons?)));
    let curves = known.flat_map(|(pin, path, newtons)| {
        let ink = pin.ink(tokens).gamma_multiply(0.8);
        path.pieces().map(move |piece| {
            let [first, last] = extent.pulls;
            let points = piece.iter();
            let points = points.map(|state| {
                let load = grams(newtons * state.load());
                PlotPoint::new(millimetres(state.pull), load)
            });
            let inside = |at: &PlotPoint| (first..=last).contains(&at.x) && at.y <= most;
            let seen = points.skip_while(|at| !inside(at)).take_while(inside);
            (seen.collect(), ink)
        })
    });
    curves.collect()
}

pub(super) fn show(
    ui: &mut Ui,
    data: &PlotData<'_>,
    cache: &PlotCache,
    link: &mut Link,
) -> Option<Asked> {
    let (theme, tokens) = (theme_of(ui), Tokens::in_ui(ui));
    let per_bend = per_bend(data);
    let states = data.solved.cables.get(data.cable);
    let here = states.map(|state| (millimetres(state.pull), per_bend * state.load));
    let curves = path(data, cache);
    let extent = Extent::of(data, cache);
    let (factor, unit) = in_unit(data, extent.loads[1]);
    let loads = extent.loads.map(|load| stepped(factor * load));
    let name = match data.problem().drive().cables.len() {
        0 | 1 => "Load on the cable".to_owned(),
        _ => format!("Load on cable {}", data.cable + 1),
    };
    let load = Quantities {
        name: &name,
        unit: &unit,
    };
    let read = match data.cable {
        0 => {
            let pull = millimetres(read_at(data, link));
            cache.forces.load_at(pull).map(|load| (pull, load))
        }
        _ => None,
    };
    let read = match read.filter(|_| matches!(link.hovered, Hovered::Pull(_))) {
        None => here,
        hovered => hovered,
    };
    let mut reading = Text::default();
    if let Some((pull, load)) = read {
        reading = reading.value("pull", &Quantity::fixed(pull, 2, "mm"), &tokens);
        reading = match data.stiffness() {
            Some(_) => reading.value("load", &Quantity::fixed(factor * load, 1, "g"), &tokens),
            None => reading.value("load", &Quantity::significant(factor * load, ""), &tokens),
        };
    }
    let asked = header(ui, Plot::Load, ordinate(&load, &tokens), reading, |_| {});
    let walked = walked(data, factor * per_bend);
    if walked.is_empty() && curves.is_empty() {
        empty(ui, "The first shape is being solved.", |_| {});
        return asked;
    }
    let abscissa = Quantities {
        name: "Pull",
        unit: "mm",
    };
    let height = ui.available_height();
    let plot = canvas("load", height, &abscissa, &tokens, Whole::No)
        .set_margin_fraction(vec2(0.03, 0.03))
        .include_x(extent.pulls[0])
        .include_x(extent.pulls[1].max(extent.pulls[0] + 1e-3))
        .include_y(loads[0])
        .include_y(loads[1].max(loads[0] + 1e-9));
    let behind: Vec<Vec<PlotPoint>> = curves
        .iter()
        .map(|piece| {
            // What is outside must not set the scale.
            let [first, last] = extent.pulls;
            let inside = |point: &&PlotPoint| {
                (first..=last).contains(&point.x) && factor * point.y <= loads[1]
            };
            let seen = piece.iter().skip_while(|point| !inside(point));
            seen.take_while(inside)
                .map(|point| PlotPoint::new(point.x, factor * point.y))
                .collect()
        })
        .collect();
    let pinned = pinned(data, &extent, loads[1], &tokens);
    let quiet = Stroke::new(1.25, tokens.muted.gamma_multiply(0.6));
    let strong = Stroke::new(2.0, hue(theme, 0));
    let shown = plot.show(ui, |plot| {
        for (piece, ink) in &pinned {
            let line = Line::new("pinned", &piece[..]).stroke(Stroke::new(1.25, *ink));
            plot.line(line.allow_hover(false).allow_band(false));
        }
        for (pieces, stroke) in [(&behind, quiet), (&walked, strong)] {
            for piece in pieces {
                let line = Line::new("load", &piece[..]).stroke(stroke);
                plot.line(line.allow_hover(false).allow_band(false));
            }
        }
    });
    named(&shown.response, "Load against pull");
    let painter = ui.painter().with_clip_rect(*shown.transform.frame());
    let surface = Surface::of(&painter, &shown.response, shown.transform, &tokens);
    surface.zero(&tokens);
    for pair in behind.windows(2) {
        surface.jump(pair[0].last(), pair[1].first(), quiet.color);
    }
    for pair in walked.windows(2) {
        surface.jump(pair[0].last(), pair[1].first(), strong.color);
    }
    // Of another cable there is nothing to be set by a hand on the plot.
    if data.cable == 0 {
        let cursor = Cursor {
            edges: Edges::Hidden,
            knob: Knob::Shown,
        };
        cursor.show(ui, &surface, &shown.response, data, link);
    }
    if let Some((pull, load)) = here {
        surface.dot(surface.at(pull, factor * load), strong.color, &tokens);
    }
    asked
}

pub(super) fn csv(data: &PlotData<'_>, table: &mut csv::Writer<Vec<u8>>) -> csv::Result<()> {
    let per_bend = per_bend(data);
    let known = data.stiffness().is_some();
    let load = if known { "load_g" } else { "load_rad2_per_mm" };
    table.write_record(["step", "cable", "pull_mm", load, "jumped"])?;
    for (index, step) in data.walked.iter().enumerate() {
        for (cable, loaded) in step.cables.iter().enumerate() {
            let load = match known {
                true => grams(per_bend * loaded.load),
                false => per_millimetre(loaded.load),
            };
            table.write_record([
                index.to_string(),
                (cable + 1).to_string(),
                cell(millimetres(loaded.pull)),
                cell(load),
                u8::from(step.is_leap).to_string(),
            ])?;
        }
    }
    Ok(())
}

pub(super) fn charts(data: &PlotData<'_>, cache: &PlotCache) -> Vec<Chart> {
    let (factor, unit) = match data.stiffness() {
        Some(_) => (grams(1.0), "g"),
        None => (1e6 * per_millimetre(1.0), "10⁻⁶ rad²/mm"),
    };
    let points = |piece: &[PlotPoint], factor: f64| {
        let points = piece.iter().map(|point| (point.x, factor * point.y));
        points.collect()
    };
    let mut series: Vec<Series> = Vec::new();
    let usual = cache.forces.widest_load;
    for piece in path(data, cache) {
        let seen = piece.partition_point(|point| point.y <= usual);
        let points = points(&piece[..seen], factor);
        series.push(Series::new("from straight", CurveStyle::Dashed, points));
    }
    for piece in walked(data, per_bend(data)) {
        let points = points(&piece, factor);
        series.push(Series::new("as pulled", CurveStyle::Line, points));
    }
    let state = data.solved.cables.get(data.cable);
    series.extend(state.map(|state| {
        let now = (
            millimetres(state.pull),
            factor * per_bend(data) * state.load,
        );
        Series::new("now", CurveStyle::Dots, vec![now])
    }));
    vec![Chart {
        title: "Load against pull".to_owned(),
        word: "load",
        x: Axis::new("pull", "mm"),
        y: Axis::new("load", unit),
        series,
    }]
}
