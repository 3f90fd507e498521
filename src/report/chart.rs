//! A chart as SVG, with plotters. It reads in light and dark, on a phone and
//! in print: series differ in mark as well as in hue, and every colour has a
//! counterpart for dark backgrounds in [`STYLE`].

use super::characters::printable;
use crate::math::{unsigned_zero, with_minus};
use crate::view::{Axis, Chart, CurveStyle, Series};
use plotters::coord::Shift;
use plotters::coord::types::RangedCoordf64;
use plotters::prelude::*;
use std::ops::Range;

/// Size of a chart, in pixels, and how much finer its coordinates are: plotters
/// rounds them to whole ones, which would make curves ragged.
const WIDTH: u32 = 560;
const HEIGHT: u32 = 380;
const FINE: u32 = 8;

/// Room beyond the data, over what it spans.
const MARGIN: f64 = 0.05;
/// What data spans that is all alike, in an axis's unit: enough for plotters to
/// divide by, and no number that a tick would show.
const NO_SPAN: f64 = 1e-12;
/// Numbers at grid lines are rounded to a millionth of an axis's unit: grid lines
/// are round numbers, and what is left behind them is rounding.
const TICKS_A_UNIT: f64 = 1e6;

const INK: RGBColor = RGBColor(0x1c, 0x20, 0x28);
const MUTED: RGBColor = RGBColor(0x5c, 0x60, 0x69);
const GRID: RGBColor = RGBColor(0xe2, 0xe2, 0xdc);
/// Okabe and Ito's hues that carry a line on white: blue, vermilion, green,
/// purple, orange, black.
const HUES: [RGBColor; 6] = [
    RGBColor(0x00, 0x72, 0xb2),
    RGBColor(0xd5, 0x5e, 0x00),
    RGBColor(0x00, 0x9e, 0x73),
    RGBColor(0xa8, 0x52, 0x82),
    RGBColor(0xb8, 0x7a, 0x00),
    RGBColor(0x33, 0x37, 0x40),
];

/// What a chart's colours become where the reader prefers dark pages.
pub const STYLE: &str = "@media screen and (prefers-color-scheme:dark){\
[fill='#1C2028']{fill:#e8e8e4}[stroke='#1C2028']{stroke:#e8e8e4}\
[fill='#5C6069']{fill:#a6aab3}[stroke='#5C6069']{stroke:#a6aab3}\
[stroke='#E2E2DC']{stroke:#30343c}\
[fill='#0072B2']{fill:#56b4e9}[stroke='#0072B2']{stroke:#56b4e9}\
[fill='#D55E00']{fill:#ff8a3c}[stroke='#D55E00']{stroke:#ff8a3c}\
[fill='#009E73']{fill:#2fd0a2}[stroke='#009E73']{stroke:#2fd0a2}\
[fill='#A85282']{fill:#e79cc4}[stroke='#A85282']{stroke:#e79cc4}\
[fill='#B87A00']{fill:#f0b93a}[stroke='#B87A00']{stroke:#f0b93a}\
[fill='#333740']{fill:#d4d6da}[stroke='#333740']{stroke:#d4d6da}}";

/// Why a chart could not be drawn.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("the chart “{title}” cannot be drawn: {reason}")]
pub struct ChartError {
    /// The chart's title.
    pub title: String,
    /// What went wrong.
    pub reason: String,
}

/// The text with what HTML would read as markup written out.
pub fn escaped(text: &str) -> String {
    let mut safe = String::with_capacity(text.len());
    for character in printable(text).chars() {
        match character {
            '&' => safe.push_str("&amp;"),
            '<' => safe.push_str("&lt;"),
            '>' => safe.push_str("&gt;"),
            '"' => safe.push_str("&quot;"),
            '\'' => safe.push_str("&#39;"),
            other => safe.push(other),
        }
    }
    safe
}

type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;
type Plane<'a, 'b> = ChartContext<'a, SVGBackend<'b>, Cartesian2d<RangedCoordf64, RangedCoordf64>>;
type Drawn = Result<(), Box<dyn std::error::Error + Send + Sync>>;

/// The chart as an `<svg>` element, to be put into a page that has [`STYLE`].
///
/// # Errors
/// If a range of the data is not finite.
pub fn svg(chart: &Chart) -> Result<String, ChartError> {
    let mut text = String::new();
    let failed = |reason: String| ChartError {
        title: chart.title.clone(),
        reason,
    };
    {
        let size = (WIDTH * FINE, HEIGHT * FINE);
        let root = SVGBackend::with_string(&mut text, size).into_drawing_area();
        draw(chart, &root).map_err(|error| failed(error.to_string()))?;
        root.present().map_err(|error| failed(error.to_string()))?;
    }
    let from = format!(
        "<svg width=\"{}\" height=\"{}\"",
        WIDTH * FINE,
        HEIGHT * FINE
    );
    let label = escaped(&chart.title);
    let to =
        format!("<svg width=\"{WIDTH}\" height=\"{HEIGHT}\" role=\"img\" aria-label=\"{label}\"");
    Ok(text.replacen(&from, &to, 1))
}

/// The chart as the contents of a file of its own.
///
/// # Errors
/// Those of [`svg()`].
pub fn svg_file(chart: &Chart) -> Result<String, ChartError> {
    let text = svg(chart)?;
    let style = format!(">\n<style>{STYLE}</style>");
    Ok(text.replacen('>', &style, 1))
}

/// Charts below each other as the contents of one file.
///
/// # Errors
/// Those of [`svg()`].
pub fn svg_column(charts: &[Chart]) -> Result<String, ChartError> {
    let mut text = String::new();
    for (row, chart) in charts.iter().enumerate() {
        let y = row as u32 * HEIGHT;
        text += &svg(chart)?.replacen("<svg ", &format!("<svg y=\"{y}\" "), 1);
    }
    let height = HEIGHT * charts.len() as u32;
    Ok(format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{WIDTH}\" height=\"{height}\" \
         viewBox=\"0 0 {WIDTH} {height}\">\n<style>{STYLE}</style>{text}</svg>\n"
    ))
}

fn draw(chart: &Chart, root: &Area<'_>) -> Drawn {
    let legend = legend_lines(&chart.series);
    let (top, plot) = root.split_vertically(px(8 + 22 * legend.len() as u32));
    draw_legend(chart, &legend, &top)?;
    let (x, y) = ranges(chart);
    let mut plane = ChartBuilder::on(&plot)
        .margin_top(px(8))
        .margin_right(px(18))
        .x_label_area_size(px(46))
        .y_label_area_size(px(62))
        .build_cartesian_2d(x, y)?;
    plane
        .configure_mesh()
        .max_light_lines(0)
        .bold_line_style(GRID.stroke_width(FINE))
        .axis_style(MUTED.stroke_width(FINE))
        .label_style(font(13, &MUTED))
        .axis_desc_style(font(14, &INK))
        .x_labels(8)
        .y_labels(7)
        .x_label_formatter(&|v| tick(*v))
        .y_label_formatter(&|v| tick(*v))
        .x_desc(axis_name(&chart.x))
        .y_desc(axis_name(&chart.y))
        .set_all_tick_mark_size(px(4))
        .draw()?;
    for (index, series) in chart.series.iter().enumerate() {
        draw_series(&mut plane, series, index, &chart.series)?;
    }
    Ok(())
}

/// A length on the page.
fn px(pixels: u32) -> u32 {
    pixels * FINE
}

fn font(size: u32, colour: &'static RGBColor) -> TextStyle<'static> {
    // plotters divides by 1.24 on the way to SVG.
    let size = f64::from(px(size)) * 1.24;
    TextStyle::from(
        (
            "system-ui, -apple-system, 'Segoe UI', Roboto, sans-serif",
            size,
        )
            .into_font(),
    )
    .color(colour)
}

fn axis_name(axis: &Axis) -> String {
    match axis.unit {
        "" => axis.name.to_owned(),
        unit => format!("{}, {unit}", axis.name),
    }
}

/// A number at a grid line: as short as it is exact, with a minus sign.
fn tick(value: f64) -> String {
    let rounded = unsigned_zero((value * TICKS_A_UNIT).round() / TICKS_A_UNIT);
    with_minus(&rounded.to_string())
}

/// The hue of a series: a dashed line has that of the line before it, whose
/// model it is.
fn hue(index: usize, all: &[Series]) -> RGBColor {
    let own = all[..=index]
        .iter()
        .filter(|s| s.style != CurveStyle::Dashed);
    HUES[own.count().saturating_sub(1) % HUES.len()]
}

/// Which of the marks for points a series has.
fn mark_of(index: usize, all: &[Series]) -> usize {
    all[..index]
        .iter()
        .filter(|s| s.style == CurveStyle::Dots)
        .count()
}

fn draw_series(plane: &mut Plane<'_, '_>, series: &Series, index: usize, all: &[Series]) -> Drawn {
    let colour = hue(index, all);
    let points = series.points.iter().copied();
    let line = colour.stroke_width(px(2));
    match series.style {
        CurveStyle::Line => {
            plane.draw_series(LineSeries::new(points, line))?;
        }
        CurveStyle::Dashed => {
            plane.draw_series(DashedLineSeries::new(points, px(7), px(5), line))?;
        }
        CurveStyle::Dots => {
            let shape = mark_of(index, all);
            for point in points {
                dot(plane.plotting_area(), point, shape, colour)?;
            }
        }
        CurveStyle::Stems => {
            for (x, y) in points {
                let stem = vec![(x, 0.0), (x, y)];
                plane.draw_series(LineSeries::new(stem, line))?;
                let (shape, colour, size) = match y {
                    0.0 => (0, MUTED, 2),
                    _ => (index, colour, 5),
                };
                dot_of_size(plane.plotting_area(), (x, y), shape, colour, size)?;
            }
        }
    }
    Ok(())
}

fn dot<'a, C: CoordTranslate<From = (A, A)>, A: Copy + Clone + 'static>(
    area: &DrawingArea<SVGBackend<'a>, C>,
    at: (A, A),
    shape: usize,
    colour: RGBColor,
) -> Drawn {
    dot_of_size(area, at, shape, colour, 5)
}

/// One of four marks, so that series differ without colour.
fn dot_of_size<'a, C: CoordTranslate<From = (A, A)>, A: Copy + Clone + 'static>(
    area: &DrawingArea<SVGBackend<'a>, C>,
    at: (A, A),
    shape: usize,
    colour: RGBColor,
    size: u32,
) -> Drawn {
    let size = px(size);
    match shape % 4 {
        0 => area.draw(&Circle::new(at, size, colour.filled()))?,
        1 => area.draw(&TriangleMarker::new(at, size + px(1), colour.filled()))?,
        2 => area.draw(&Cross::new(at, size, colour.stroke_width(px(2))))?,
        _ => area.draw(&Circle::new(at, size, colour.stroke_width(px(2))))?,
    }
    Ok(())
}

/// The room a name takes in the legend, in pixels: its mark, its letters at
/// a generous width of 14 px type, a gap.
fn room(series: &Series) -> u32 {
    34 + 8 * series.name.chars().count() as u32 + 14
}

/// Which series stand in which line of the legend.
fn legend_lines(series: &[Series]) -> Vec<Vec<usize>> {
    let mut lines: Vec<Vec<usize>> = Vec::new();
    let mut left = 0;
    for (index, one) in series.iter().enumerate() {
        let needed = room(one);
        match lines.last_mut() {
            Some(line) if needed <= left => line.push(index),
            _ => {
                lines.push(vec![index]);
                left = WIDTH - 24;
            }
        }
        left = left.saturating_sub(needed);
    }
    lines
}

fn draw_legend(chart: &Chart, lines: &[Vec<usize>], area: &Area<'_>) -> Drawn {
    let at = |x: u32, y: u32| (px(x) as i32, px(y) as i32);
    for (row, line) in lines.iter().enumerate() {
        let (mut x, y) = (12, 16 + 22 * row as u32);
        for &index in line {
            let series = &chart.series[index];
            let colour = hue(index, &chart.series);
            let stroke = colour.stroke_width(px(2));
            let path = |from: u32, to: u32| PathElement::new(vec![at(from, y), at(to, y)], stroke);
            match series.style {
                CurveStyle::Line => area.draw(&path(x, x + 24))?,
                CurveStyle::Dashed => {
                    for start in [x, x + 9, x + 18] {
                        area.draw(&path(start, start + 6))?;
                    }
                }
                CurveStyle::Dots => {
                    dot(area, at(x + 12, y), mark_of(index, &chart.series), colour)?
                }
                CurveStyle::Stems => dot(area, at(x + 12, y), index, colour)?,
            }
            let style = font(14, &INK).pos(plotters::style::text_anchor::Pos::new(
                plotters::style::text_anchor::HPos::Left,
                plotters::style::text_anchor::VPos::Center,
            ));
            area.draw(&Text::new(printable(&series.name), at(x + 31, y), style))?;
            x += room(series);
        }
    }
    Ok(())
}

/// What both axes show: the data with a margin; a map's axes to one scale.
fn ranges(chart: &Chart) -> (Range<f64>, Range<f64>) {
    let span = |axis: &Axis, of: fn(&(f64, f64)) -> f64| -> Range<f64> {
        let all = chart.series.iter().flat_map(|s| s.points.iter().map(of));
        let start = if axis.from_zero {
            (0.0, 0.0)
        } else {
            (f64::INFINITY, f64::NEG_INFINITY)
        };
        let (least, most) = all.fold(start, |(a, b), v| (a.min(v), b.max(v)));
        let margin = MARGIN * (most - least).max(NO_SPAN);
        let below = if least < 0.0 || !axis.from_zero {
            margin
        } else {
            0.0
        };
        least - below..most + margin
    };
    let (x, y) = (span(&chart.x, |p| p.0), span(&chart.y, |p| p.1));
    if !(chart.x.to_scale && chart.y.to_scale) {
        return (x, y);
    }
    let legend = 8 + 22 * legend_lines(&chart.series).len() as u32;
    let room = [
        f64::from(WIDTH - 62 - 18),
        f64::from(HEIGHT - legend - 8 - 46),
    ];
    let size = |range: &Range<f64>| range.end - range.start;
    // Millimetres a pixel, the same for both.
    let scale = (size(&x) / room[0]).max(size(&y) / room[1]);
    let fitted = |range: Range<f64>, room: f64| {
        let spare = scale * room - size(&range);
        range.start - 0.5 * spare..range.end + 0.5 * spare
    };
    (fitted(x, room[0]), fitted(y, room[1]))
}
