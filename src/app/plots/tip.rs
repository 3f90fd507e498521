//! The tip over the pull, the paper's Fig. 7: its displacement and its slope,
//! with the straight lines of eq. 7 in a window that a hand can move.

use super::over_pull::{Edges, cursors, read_at, window_shade};
use super::pane::{
    Quantities, Surface, Text, Whole, canvas, empty, header, hue, named, ordinate, value_at,
};
use super::{Link, Plot, PlotAction, PlotCache, PlotData};
use crate::app::look::{Tokens, theme_of};
use crate::app::plots::cache::Piece;
use crate::experiments::{Axis, Chart, Mark, Series};
use crate::explore::{COLUMNS, rows};
use crate::forces::{LineFit, Rates};
use crate::units::{degrees, metres, millimetres};
use crate::view::Quantity;
use eframe::egui::{Align2, Color32, Stroke, Ui, pos2};
use egui_plot::{Line, PlotPoint};

/// The share of the height that the displacement takes.
const UPPER: f32 = 0.56;
/// Room that the names of an axis take below a plot.
const ABSCISSA: f32 = 20.0;

/// A curve of the plot: what it is called, where its points are, its line.
struct Curve {
    name: &'static str,
    hue: usize,
    of: fn(&Piece) -> &Vec<PlotPoint>,
    line: fn(&Rates) -> &LineFit,
    /// From SI to the axis, and what the straight robot has.
    scale: fn(f64) -> f64,
    straight: f64,
    unit: &'static str,
}

fn curves(data: &PlotData<'_>) -> [Curve; 3] {
    let base = data.problem.robot().base;
    let tip = base.position + data.problem.length() * base.normal();
    [
        Curve {
            name: "x",
            hue: 0,
            of: |piece| &piece.x,
            line: |rates| &rates.x,
            scale: millimetres,
            straight: tip.x,
            unit: "mm",
        },
        Curve {
            name: "y",
            hue: 1,
            of: |piece| &piece.y,
            line: |rates| &rates.y,
            scale: millimetres,
            straight: tip.y,
            unit: "mm",
        },
        Curve {
            name: "θ",
            hue: 2,
            of: |piece| &piece.slope,
            line: |rates| &rates.angle,
            scale: degrees,
            straight: base.angle,
            unit: "°",
        },
    ]
}

impl Curve {
    /// The slope of the fitted line, in the axis's unit over a millimetre.
    fn rate(&self, rates: &Rates) -> f64 {
        (self.scale)((self.line)(rates).slope) * metres(1.0)
    }

    fn line_at(&self, rates: &Rates, pull: f64) -> f64 {
        (self.scale)((self.line)(rates).at(pull) - self.straight)
    }
}

pub(super) fn show(
    ui: &mut Ui,
    data: &PlotData<'_>,
    cache: &PlotCache,
    link: &mut Link,
) -> Option<PlotAction> {
    let tokens = Tokens::in_ui(ui);
    let curves = curves(data);
    let displacement = Quantities {
        name: "Displacement of the tip",
        unit: "mm",
    };
    let pull = read_at(data, link);
    let mut reading = Text::default();
    let known = !cache.course.pieces.is_empty();
    if known {
        let shown = Quantity::fixed(millimetres(pull), 2, "mm");
        reading = reading.value("pull", &shown, &tokens);
        for curve in &curves {
            let pieces = cache.course.pieces.iter();
            let values = pieces.filter_map(|piece| value_at((curve.of)(piece), millimetres(pull)));
            if let Some(value) = values.last() {
                let decimals = if curve.unit == "mm" { 2 } else { 1 };
                let shown = Quantity::fixed(value, decimals, curve.unit);
                reading = reading.value(curve.name, &shown, &tokens);
            }
        }
    }
    let name = ordinate(&displacement, &tokens);
    let action = header(ui, Plot::Tip, data, cache, name, reading);
    if !known {
        empty(ui, "The robot is being followed along its pull.", |_| {});
        return action;
    }
    let room = ui.available_height() - 2.0 * ABSCISSA - 22.0;
    let nothing = Quantities { name: "", unit: "" };
    let pull_axis = Quantities {
        name: "Pull",
        unit: "mm",
    };
    pane(
        ui,
        "displacement",
        &curves[..2],
        data,
        cache,
        link,
        UPPER * room + ABSCISSA,
        &nothing,
    );
    let slope = Quantities {
        name: "Slope of the tip",
        unit: "°, counterclockwise",
    };
    let text = ui.painter().layout_job(ordinate(&slope, &tokens).job());
    let (rect, _) = ui.allocate_exact_size(
        eframe::egui::vec2(ui.available_width(), 18.0),
        eframe::egui::Sense::hover(),
    );
    ui.painter()
        .galley(rect.min + eframe::egui::vec2(4.0, 2.0), text, tokens.text);
    let rest = ui.available_height();
    pane(
        ui,
        "slope",
        &curves[2..],
        data,
        cache,
        link,
        rest,
        &pull_axis,
    );
    action
}

#[expect(clippy::too_many_arguments, reason = "one of the two halves of a plot")]
fn pane(
    ui: &mut Ui,
    id: &'static str,
    curves: &[Curve],
    data: &PlotData<'_>,
    cache: &PlotCache,
    link: &mut Link,
    height: f32,
    abscissa: &Quantities<'_>,
) {
    let theme = theme_of(ui);
    let tokens = Tokens::in_ui(ui);
    let group = ui.scope_id().with("pull axis");
    let plot = canvas(id, height, abscissa, &tokens, Whole::No)
        .link_axis(group, [true, false])
        .include_y(0.0);
    let shown = plot.show(ui, |plot| {
        plot.span(window_shade(data, &tokens));
        for curve in curves {
            for piece in &cache.course.pieces {
                let points = (curve.of)(piece).as_slice();
                let line = Line::new(curve.name, points);
                plot.line(line.stroke(Stroke::new(2.0, hue(theme, curve.hue))));
            }
        }
    });
    named(&shown.response, id);
    let painter = ui
        .painter()
        .with_clip_rect(shown.transform.frame().expand2([0.0, 6.0].into()));
    let surface = Surface::of(&painter, &shown.response, shown.transform);
    surface.zero(&tokens);
    if let Some(Ok(rates)) = &cache.fits.path {
        let window = data.window;
        let mut names = Vec::new();
        for curve in curves {
            let ends = [window.first, window.last]
                .map(|pull| surface.at(millimetres(pull), curve.line_at(rates, pull)));
            let ink = hue(theme, curve.hue);
            surface.dashed(ends, ink.gamma_multiply(0.8));
            names.push((ends[1], ink, curve));
        }
        slopes(&surface, &mut names, rates, &tokens);
    }
    // The curves' own names, where they end.
    for curve in curves {
        let last = cache
            .course
            .pieces
            .last()
            .and_then(|piece| (curve.of)(piece).last());
        if let Some(last) = last {
            let at = surface.at(last.x, last.y) + eframe::egui::vec2(-4.0, -4.0);
            let text = Text::of(curve.name, hue(theme, curve.hue));
            surface.name(at, Align2::RIGHT_BOTTOM, text);
        }
    }
    cursors(ui, &surface, &shown.response, data, link, Edges::Shown);
    // Where the curves are now.
    for curve in curves {
        let pull = millimetres(data.solution.pull);
        let pieces = cache.course.pieces.iter();
        let here = pieces
            .filter_map(|piece| value_at((curve.of)(piece), pull))
            .last();
        if let Some(here) = here {
            let at = surface.at(pull, here);
            surface.painter.circle_filled(at, 4.0, tokens.panel);
            surface
                .painter
                .circle_filled(at, 3.0, hue(theme, curve.hue));
        }
    }
}

/// The lines' slopes, beside the window's far edge, apart from each other.
fn slopes(
    surface: &Surface<'_>,
    names: &mut [(eframe::egui::Pos2, Color32, &Curve)],
    rates: &Rates,
    tokens: &Tokens,
) {
    names.sort_by(|a, b| a.0.y.total_cmp(&b.0.y));
    let mut lowest = f32::NEG_INFINITY;
    for (end, ink, curve) in names {
        let unit = match curve.unit {
            "mm" => "mm/mm",
            _ => "°/mm",
        };
        let rate = Quantity::fixed(curve.rate(rates), 3, unit);
        let text = Text::of("f′", *ink)
            .index(curve.name, *ink)
            .and(&format!(" {}", rate.digits), *ink)
            .and(&format!(" {}", rate.unit), tokens.muted);
        let at = pos2(end.x + 8.0, end.y.max(lowest + 16.0));
        let room = surface.frame().right() - end.x;
        let (at, anchor) = if room > 120.0 {
            (at, Align2::LEFT_CENTER)
        } else {
            (pos2(end.x - 8.0, at.y - 12.0), Align2::RIGHT_CENTER)
        };
        lowest = surface.name(at, anchor, text).center().y;
    }
}

pub(super) fn csv(data: &PlotData<'_>, table: &mut csv::Writer<Vec<u8>>) -> csv::Result<()> {
    table.write_record(COLUMNS)?;
    for row in data.path.into_iter().flat_map(rows) {
        table.write_record(row.map(|number| number.to_string()))?;
    }
    Ok(())
}

pub(super) fn charts(data: &PlotData<'_>, cache: &PlotCache) -> Vec<Chart> {
    let pieces = &cache.course.pieces;
    let curves = curves(data);
    let chart = |title: &str, word, y, curves: &[Curve]| {
        let mut series = Vec::new();
        for curve in curves {
            for (index, piece) in pieces.iter().enumerate() {
                let name = match index {
                    0 => curve.name.to_owned(),
                    jumps => format!("{}, after {jumps} jumps", curve.name),
                };
                let points = (curve.of)(piece).iter().map(|p| (p.x, p.y)).collect();
                series.push(Series::new(name, Mark::Line, points));
            }
            if let Some(Ok(rates)) = &cache.fits.path {
                let ends = [data.window.first, data.window.last];
                let ends = ends.map(|pull| (millimetres(pull), curve.line_at(rates, pull)));
                let rate = Quantity::fixed(curve.rate(rates), 4, "").digits;
                let name = format!("{}, line: f′ = {rate} {}/mm", curve.name, curve.unit);
                series.push(Series::new(name, Mark::Dashed, ends.to_vec()));
            }
        }
        Chart {
            title: title.to_owned(),
            word,
            x: Axis::new("pull", "mm"),
            y,
            series,
        }
    };
    vec![
        chart(
            "Displacement of the tip",
            "displacement",
            Axis::new("displacement", "mm"),
            &curves[..2],
        ),
        chart(
            "Slope of the tip, counterclockwise",
            "slope",
            Axis::new("slope", "deg"),
            &curves[2..],
        ),
    ]
}
