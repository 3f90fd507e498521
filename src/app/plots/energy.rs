//! The energy over the pull, with what happens on the way: contacts made and
//! lost, jumps, ends.

use super::cache::{Piece, PlotCache};
use super::data::{Link, Plot, PlotData};
use super::marks;
use super::over_pull::{Cursor, Edges, Knob, read_at};
use super::pane::{
    Asked, Quantities, Surface, Text, Whole, canvas, cell, curve, empty, header, hue, named,
    ordinate,
};
use crate::app::look::{Tokens, theme_of};
use crate::app::words;
use crate::app::workbench::Hovered;
use crate::units::{grams, millimetres, per_millimetre};
use crate::view::{Axis, Chart, CurveStyle, Quantity, Series};
use eframe::egui::{Ui, vec2};
use egui_plot::PlotPoint;

/// The energy's symbol, what an energy of 1 rad² is in its unit, and that unit: that of
/// the bent backbone where its stiffness is known, the paper's sum of squares elsewhere.
fn in_unit(data: &PlotData<'_>) -> (&'static str, f64, &'static str) {
    match data.stiffness() {
        Some(stiffness) => {
            let newton_metres = stiffness.per_bend(data.problem());
            ("U", millimetres(newton_metres), "N mm")
        }
        None => ("J", 1.0, "rad²"),
    }
}

pub(super) fn show(
    ui: &mut Ui,
    data: &PlotData<'_>,
    cache: &PlotCache,
    link: &mut Link,
) -> Option<Asked> {
    let (theme, tokens) = (theme_of(ui), Tokens::in_ui(ui));
    let pieces = &cache.along.pieces;
    let pull = millimetres(read_at(data, link));
    let (symbol, factor, unit) = in_unit(data);
    let mut reading = Text::default();
    if let Some(energy) = cache.along.value(|piece| &piece.energy, pull) {
        reading = reading
            .value("pull", &Quantity::fixed(pull, 2, "mm"), &tokens)
            .value(
                symbol,
                &Quantity::significant(factor * energy, unit),
                &tokens,
            );
    }
    let name = format!("Energy {symbol}");
    let energy = Quantities { name: &name, unit };
    let name = ordinate(&energy, &tokens);
    let asked = header(ui, Plot::Energy, name, reading, |_| {});
    if pieces.is_empty() {
        empty(ui, "The robot is being followed along its pull.", |_| {});
        return asked;
    }
    let abscissa = Quantities {
        name: "Pull",
        unit: "mm",
    };
    let height = ui.available_height();
    // Room above the curve for the marks and their names.
    let top = marks::height(&cache.along.marks);
    let most = pieces.iter().flat_map(|piece| &piece.energy);
    let most = factor * most.map(|point| point.y).fold(0.0, f64::max);
    let scaled = |piece: &Piece| {
        let points = piece.energy.iter();
        points
            .map(|point| PlotPoint::new(point.x, factor * point.y))
            .collect::<Vec<_>>()
    };
    let pieces: Vec<Vec<PlotPoint>> = pieces.iter().map(scaled).collect();
    let inner = f64::from((height - 44.0).max(1.0));
    let headroom = most * (1.0 + f64::from(top) / (inner - f64::from(top)).max(1.0));
    let plot = canvas("energy", height, &abscissa, &tokens, Whole::No)
        .set_margin_fraction(vec2(0.03, 0.03))
        .include_y(headroom);
    let shown = plot.show(ui, |plot| {
        for piece in &pieces {
            plot.line(curve("energy", piece, hue(theme, 0)));
        }
    });
    named(&shown.response, "Energy over the pull");
    let painter = ui
        .painter()
        .with_clip_rect(shown.transform.frame().expand2(vec2(0.0, 6.0)));
    let surface = Surface::of(&painter, &shown.response, shown.transform, &tokens);
    surface.zero(&tokens);
    for pair in pieces.windows(2) {
        surface.jump(pair[0].last(), pair[1].first(), hue(theme, 0));
    }
    let cursor = Cursor {
        edges: Edges::Hidden,
        knob: Knob::Shown,
    };
    cursor.show(ui, &surface, &shown.response, data, link);
    // Over the cursor, so that their names can be read.
    let mark = marks::draw(&surface, &cache.along.marks, &tokens);
    let present = millimetres(data.solved.pull);
    if let Some(here) = cache.along.value(|piece| &piece.energy, present) {
        let at = surface.at(present, factor * here);
        surface.dot(at, hue(theme, 0), &tokens);
    }
    if let Some(mark) = mark {
        link.hovering = Hovered::Pull(mark.at);
        if shown.response.clicked() {
            link.pull = Some(mark.at);
        }
        // Everything that happened there at once.
        let together = cache.along.marks.iter();
        let together = together.filter(|other| marks::same(&surface, mark, other));
        let lines: Vec<&str> = together.map(|mark| mark.long.as_str()).collect();
        shown.response.on_hover_text_at_pointer(lines.join("\n"));
    }
    asked
}

pub(super) fn csv(data: &PlotData<'_>, table: &mut csv::Writer<Vec<u8>>) -> csv::Result<()> {
    let (per_bend, load) = match data.stiffness() {
        Some(stiffness) => (grams(stiffness.per_bend(data.problem())), "load_g"),
        None => (per_millimetre(1.0), "load_rad2_per_mm"),
    };
    // Of one cable the pull is said already, and the slope is its load.
    let count = match data.problem().drive().cables.len() {
        1 => 0,
        count => count,
    };
    let cables = (1..=count)
        .flat_map(|cable| ["pull_mm", load].map(|column| format!("cable_{cable}_{column}")));
    let heads = [
        "pull_mm",
        "energy_rad2",
        "energy_slope_rad2_per_mm",
        "event",
    ];
    table.write_record(heads.map(str::to_owned).into_iter().chain(cables))?;
    let nothing = vec![String::new(); 2 * count];
    let Some(path) = data.path else {
        return Ok(());
    };
    let mut events = path.events.iter().peekable();
    let mut note = |table: &mut csv::Writer<Vec<u8>>, before: f64| -> csv::Result<()> {
        while let Some(event) = events.next_if(|event| event.pull <= before) {
            let pull = cell(millimetres(event.pull));
            let what = words::occurrence(&event.what, data.scene);
            let row = [pull, String::new(), String::new(), what];
            table.write_record(row.iter().chain(&nothing))?;
        }
        Ok(())
    };
    for state in &path.states {
        note(table, state.pull)?;
        let slope = per_millimetre(state.energy_slope);
        let numbers = [millimetres(state.pull), state.energy, slope].map(cell);
        let cables = state
            .cables
            .iter()
            .take(count)
            .flat_map(|cable| [millimetres(cable.pull), per_bend * cable.load].map(cell));
        let row = numbers.into_iter().chain([String::new()]).chain(cables);
        table.write_record(row)?;
    }
    note(table, f64::INFINITY)
}

pub(super) fn charts(cache: &PlotCache) -> Vec<Chart> {
    let mut series: Vec<Series> = Vec::new();
    for (index, piece) in cache.along.pieces.iter().enumerate() {
        let name = match index {
            0 => "energy".to_owned(),
            jumps => format!("after {jumps} jumps"),
        };
        let points = piece.energy.iter().map(|p| (p.x, p.y)).collect();
        series.push(Series::new(name, CurveStyle::Line, points));
    }
    let at = |mark: &marks::Happening| {
        let energy = cache.along.value(|piece| &piece.energy, mark.pull);
        energy.map(|energy| (mark.pull, energy))
    };
    for (kind, name) in [
        (marks::Kind::Made, "contact made"),
        (marks::Kind::Lost, "contact lost"),
        (marks::Kind::Jump, "jump"),
        (marks::Kind::End, "end"),
    ] {
        let of_kind = cache.along.marks.iter().filter(|mark| mark.kind == kind);
        let points: Vec<_> = of_kind.filter_map(at).collect();
        if !points.is_empty() {
            series.push(Series::new(name, CurveStyle::Dots, points));
        }
    }
    vec![Chart {
        title: "Energy over the pull".to_owned(),
        word: "energy",
        x: Axis::new("pull", "mm"),
        y: Axis::new("energy", "rad²"),
        series,
    }]
}
