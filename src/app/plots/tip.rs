//! The tip over the pull, the paper's Fig. 7: its displacement and its slope,
//! with the straight lines of eq. 7 in a window that a hand can move.

use super::cache::PlotCache;
use super::data::{Link, Plot, PlotData};
use super::over_pull::{Cursor, Edges, Knob, read_at, window_shade};
use super::pane::{
    Asked, Quantities, SMALL, Surface, Text, Whole, canvas, cell, curve, empty, header, hue, named,
    ordinate,
};
use crate::app::look::{Tokens, theme_of};
use crate::app::plots::cache::Piece;
use crate::explore::Path;
use crate::forces::{LineFit, Rates, Window};
use crate::record::path::{COLUMNS, rows};
use crate::units::{degrees, metres, millimetres};
use crate::view::{Axis, Chart, CurveStyle, Quantity, Series};
use eframe::egui::{Align2, DragValue, RichText, Sense, Ui, pos2, vec2};
use egui_plot::PlotPoint;

/// The share of the height that the displacement takes.
const UPPER: f32 = 0.56;
/// Room that an axis takes below a plot.
const ABSCISSA: f32 = 34.0;
/// Height of the lower half's header.
const MIDDLE: f32 = 20.0;

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
    let base = data.problem().robot().base;
    let tip = base.position + data.problem().length() * base.normal();
    [
        Curve {
            name: "Δx",
            hue: 0,
            of: |piece| &piece.x,
            line: |rates| &rates.x,
            scale: millimetres,
            straight: tip.x,
            unit: "mm",
        },
        Curve {
            name: "Δy",
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
) -> Option<Asked> {
    let tokens = Tokens::in_ui(ui);
    let curves = curves(data);
    let displacement = Quantities {
        name: "Displacement",
        unit: "mm",
    };
    let pull = read_at(data, link);
    let mut reading = Text::default();
    let known = !cache.along.pieces.is_empty();
    if known {
        // In millimetres all, as the ordinate says.
        let shown = Quantity::fixed(millimetres(pull), 2, "");
        reading = reading.value("pull", &shown, &tokens);
        for curve in &curves {
            if let Some(value) = cache.along.value(curve.of, millimetres(pull)) {
                let (decimals, unit) = match curve.unit {
                    "mm" => (2, ""),
                    unit => (1, unit),
                };
                let shown = Quantity::fixed(value, decimals, unit);
                reading = reading.value(curve.name, &shown, &tokens);
            }
        }
    }
    let name = ordinate(&displacement, &tokens);
    let range = data.path.and_then(Path::range);
    let asked = header(ui, Plot::Tip, name, reading, |ui| {
        window(ui, link, range.unwrap_or(data.asked.pull_range()));
    });
    if !known {
        empty(ui, "The robot is being followed along its pull.", |_| {});
        return asked;
    }
    let nothing = Quantities { name: "", unit: "" };
    let pull_axis = Quantities {
        name: "Pull",
        unit: "mm",
    };
    let room = ui.available_height() - MIDDLE - ABSCISSA;
    let upper = Half {
        id: "Displacement of the tip over the pull",
        curves: &curves[..2],
        height: UPPER * room,
        abscissa: &nothing,
    };
    half(ui, &upper, data, cache, link);
    middle(ui, &curves, cache, &tokens);
    let lower = Half {
        id: "Slope of the tip over the pull",
        curves: &curves[2..],
        height: ui.available_height(),
        abscissa: &pull_axis,
    };
    half(ui, &lower, data, cache, link);
    asked
}

/// The ends of the window as numbers, for hands on a keyboard.
fn window(ui: &mut Ui, link: &mut Link, range: (f64, f64)) {
    ui.separator();
    ui.label(RichText::new("Lines are fitted from").size(SMALL).weak());
    ui.horizontal(|ui| {
        let (mut first, mut last) = (
            millimetres(link.window.first),
            millimetres(link.window.last),
        );
        let (least, most) = (millimetres(range.0), millimetres(range.1));
        let ends = [
            (&mut first, least..=last, "First pull of the window"),
            (
                &mut last,
                millimetres(link.window.first)..=most,
                "Last pull of the window",
            ),
        ];
        let mut changed = false;
        for (end, range, name) in ends {
            let field = DragValue::new(end)
                .speed(0.05)
                .range(range)
                .fixed_decimals(2);
            changed |= ui.add(field.suffix(" mm")).on_hover_text(name).changed();
        }
        if changed && first < last {
            link.window = Window {
                first: metres(first),
                last: metres(last),
            };
        }
    });
}

/// The name of the lower half, and the slopes of all lines.
fn middle(ui: &mut Ui, curves: &[Curve], cache: &PlotCache, tokens: &Tokens) {
    let theme = theme_of(ui);
    let slope = Quantities {
        name: "Slope",
        unit: "°",
    };
    let size = vec2(ui.available_width(), MIDDLE);
    let (rect, _) = ui.allocate_exact_size(size, Sense::hover());
    let name = ui.painter().layout_job(ordinate(&slope, tokens).job());
    let mut rates = Text::default();
    if let Some(Ok(fitted)) = &cache.fits.path {
        for (index, curve) in curves.iter().enumerate() {
            let unit = match curve.unit {
                "mm" => "mm/mm",
                _ => "°/mm",
            };
            let ink = hue(theme, curve.hue);
            let rate = Quantity::fixed(curve.rate(fitted), 3, unit);
            rates = rates
                .and(if index == 0 { "" } else { "  " }, ink)
                .and("f′", ink)
                .index(curve.name.trim_start_matches('Δ'), ink)
                .and(&format!(" {}", rate.digits), tokens.text);
            // x and y have the same unit.
            if index > 0 {
                rates = rates.and(&format!(" {unit}"), tokens.muted).ended();
            }
        }
    }
    let room = rect.width() - name.size().x - 48.0;
    let rates = rates.within(ui.painter(), room);
    let y = |height: f32| rect.center().y - 0.5 * height + 1.0;
    let at = pos2(rect.right() - 36.0 - rates.size().x, y(rates.size().y));
    ui.painter().galley(at, rates, tokens.text);
    let at = pos2(rect.left() + 4.0, y(name.size().y));
    ui.painter().galley(at, name, tokens.text);
}

/// One of the two halves of the plot.
struct Half<'a> {
    id: &'static str,
    curves: &'a [Curve],
    height: f32,
    abscissa: &'a Quantities<'a>,
}

fn half(ui: &mut Ui, half: &Half<'_>, data: &PlotData<'_>, cache: &PlotCache, link: &mut Link) {
    let (theme, tokens) = (theme_of(ui), Tokens::in_ui(ui));
    let pieces = &cache.along.pieces;
    let group = ui.scope_id().with("pull axis");
    let plot = canvas(half.id, half.height, half.abscissa, &tokens, Whole::No)
        .link_axis(group, [true, false])
        .show_axes([!half.abscissa.name.is_empty(), true])
        .include_y(0.0);
    let shown = plot.show(ui, |plot| {
        plot.span(window_shade(data, &tokens));
        for one in half.curves {
            for piece in pieces {
                plot.line(curve(one.name, (one.of)(piece), hue(theme, one.hue)));
            }
        }
    });
    named(&shown.response, half.id);
    let clip = shown.transform.frame().expand2(vec2(0.0, 6.0));
    let painter = ui.painter().with_clip_rect(clip);
    let surface = Surface::of(&painter, &shown.response, shown.transform, &tokens);
    surface.zero(&tokens);
    for one in half.curves {
        let ink = hue(theme, one.hue);
        for pair in pieces.windows(2) {
            surface.jump((one.of)(&pair[0]).last(), (one.of)(&pair[1]).first(), ink);
        }
        if let Some(Ok(rates)) = &cache.fits.path {
            let ends = [data.window.first, data.window.last];
            let ends = ends.map(|pull| surface.at(millimetres(pull), one.line_at(rates, pull)));
            surface.dashed(ends, ink);
        }
        // Its own name, beyond its end.
        if let Some(last) = pieces.last().and_then(|piece| (one.of)(piece).last()) {
            let at = surface.at(last.x, last.y) + vec2(5.0, 0.0);
            surface.name(at, Align2::LEFT_CENTER, Text::of(one.name, ink));
        }
    }
    let on_axis = !half.abscissa.name.is_empty();
    let cursor = Cursor {
        edges: Edges::Shown,
        knob: if on_axis { Knob::Shown } else { Knob::Hidden },
    };
    cursor.show(ui, &surface, &shown.response, data, link);
    let pull = millimetres(data.solved.pull);
    for one in half.curves {
        if let Some(here) = cache.along.value(one.of, pull) {
            surface.dot(surface.at(pull, here), hue(theme, one.hue), &tokens);
        }
    }
}

pub(super) fn csv(data: &PlotData<'_>, table: &mut csv::Writer<Vec<u8>>) -> csv::Result<()> {
    table.write_record(COLUMNS)?;
    for row in data.path.into_iter().flat_map(rows) {
        table.write_record(row.map(cell))?;
    }
    Ok(())
}

pub(super) fn charts(data: &PlotData<'_>, cache: &PlotCache) -> Vec<Chart> {
    let pieces = &cache.along.pieces;
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
                series.push(Series::new(name, CurveStyle::Line, points));
            }
            if let Some(Ok(rates)) = &cache.fits.path {
                let ends = [data.window.first, data.window.last];
                let ends = ends.map(|pull| (millimetres(pull), curve.line_at(rates, pull)));
                let rate = Quantity::fixed(curve.rate(rates), 4, "").digits;
                let name = format!("{}, line: f′ = {rate} {}/mm", curve.name, curve.unit);
                series.push(Series::new(name, CurveStyle::Dashed, ends.to_vec()));
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
