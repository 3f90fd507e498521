//! Force against load, the paper's Fig. 10: by multipliers where the stiffness
//! is known, by virtual work where a reading fixes μ, and what was read.

use super::cache::{PlotCache, value_at};
use super::data::{Link, Plot, PlotData};
use super::legend;
use super::multipliers::ceiling;
use super::pane::{
    Asked, Quantities, Surface, Text, Whole, canvas, cell, curve, empty, header, hue, named,
    ordinate,
};
use crate::app::look::{Tokens, icon, icons, theme_of};
use crate::app::words;
use crate::app::workbench::{Assumed, Hovered};
use crate::explore::LoadPoint;
use crate::mechanics::Model;
use crate::scene::ForceReading;
use crate::units::{grams, millimetres, newtons};
use crate::view::{Axis, Chart, CurveStyle, Quantity, Series};
use eframe::egui::{Align2, CursorIcon, Pos2, Response, RichText, Sense, Stroke, Ui, pos2, vec2};
use egui_plot::{Line, PlotPoint};

/// How near the pointer has to be to a reading.
const NEAR: f32 = 14.0;

/// The force by virtual work under a load, both in grams.
fn by_work(cache: &PlotCache, load_g: f64) -> Option<f64> {
    match &cache.forces.work {
        Some(Ok(work)) => Some(grams(newtons(load_g) * work.force_per_load())),
        _ => None,
    }
}

/// The force by multipliers under a load, in grams.
fn by_multipliers(cache: &PlotCache, load_g: f64) -> Option<f64> {
    let point = cache.forces.curve.as_ref()?.at(newtons(load_g))?;
    Some(grams(point.total))
}

/// The present shape as a load and a force, in grams, where it presses.
fn present(data: &PlotData<'_>, cache: &PlotCache) -> Option<PlotPoint> {
    let curve = cache.forces.curve.as_ref()?;
    let per_bend = data.stiffness()?.per_bend(data.problem());
    let force = per_bend * data.solved.pressed();
    let load = per_bend * data.solved.load() - curve.datum;
    (curve.contact.is_some() && force > 0.0).then(|| PlotPoint::new(grams(load), grams(force)))
}

pub(super) fn show(
    ui: &mut Ui,
    data: &PlotData<'_>,
    cache: &PlotCache,
    link: &mut Link,
) -> Option<Asked> {
    let tokens = Tokens::in_ui(ui);
    let force = Quantities {
        name: "Force on obstacles",
        unit: "g",
    };
    let here = present(data, cache);
    let twin = twin(cache, link);
    let mut reading = Text::default();
    let twin = twin.map(|point| PlotPoint::new(grams(point.load), grams(point.total)));
    if let Some(PlotPoint { x: load, y: force }) = twin.or(here) {
        reading = reading
            .value("load", &Quantity::fixed(load, 1, "g"), &tokens)
            .value("force", &Quantity::significant(force, "g"), &tokens);
    }
    let name = ordinate(&force, &tokens);
    let mut asked = header(ui, Plot::Force, name, reading, |_| {});
    if let Some(asked) = nothing(ui, data, cache) {
        return asked.or(asked);
    }
    let shown = curves(ui, data, cache);
    let (response, transform) = (shown.response, shown.transform);
    named(&response, "Force against load");
    let painter = ui.painter().with_clip_rect(*transform.frame());
    let surface = Surface::of(&painter, &response, transform, &tokens);
    surface.zero(&tokens);
    let below = caveats(ui, &surface, cache, &tokens);
    let (slide, below) = understated(ui, data, below, &tokens);
    asked = asked.or(slide);
    legend::paint(ui, &surface, data, cache, below);
    for point in [here, twin].into_iter().flatten() {
        let at = surface.at(point.x, point.y);
        painter.circle_filled(at, 4.5, tokens.accent);
        painter.circle_stroke(at, 5.5, Stroke::new(1.5, tokens.panel));
    }
    let nearest = nearest(&surface, data.readings());
    readings(&surface, data, cache, nearest, &tokens);
    match nearest {
        Some(index) => {
            if response.clicked() {
                link.calibrate = Some(index);
            }
            let response = response.on_hover_cursor(CursorIcon::PointingHand);
            told(response, data, cache, index);
        }
        None => {
            let value = surface.value();
            if let (Some(load), Some(curve)) = (value, &cache.forces.curve)
                && let Some(point) = curve.at(newtons(load))
            {
                link.hovering = Hovered::Pull(point.pull);
                if response.clicked() {
                    link.pull = Some(point.pull);
                }
            }
        }
    }
    if data.readings().is_empty() || data.stiffness().is_none() {
        asked = asked.or(missing(ui, data, &surface));
    }
    asked
}

/// The curve's point at the pull that the pointer is on somewhere.
fn twin(cache: &PlotCache, link: &Link) -> Option<LoadPoint> {
    match link.hovered {
        Hovered::Pull(pull) => cache.forces.curve.as_ref()?.at_pull(pull),
        _ => None,
    }
}

/// What a plot without anything to show says; `None` where there is something.
fn nothing(ui: &mut Ui, data: &PlotData<'_>, cache: &PlotCache) -> Option<Option<Asked>> {
    let forces = &cache.forces;
    let mut asked = None;
    if data.stiffness().is_none() && data.readings().is_empty() {
        let sentence = "Forces in grams need the backbone's stiffness or a measured force.";
        empty(ui, sentence, |ui| {
            if ui.button("Set the stiffness").clicked() {
                asked = Some(Asked::Stiffness);
            }
            if ui.button("Add a reading").clicked() {
                asked = Some(Asked::Reading);
            }
        });
        return Some(asked);
    }
    if data.readings().is_empty() {
        match &forces.curve {
            None => empty(ui, "The robot is being followed along its pull.", |_| {}),
            Some(curve) if curve.contact.is_none() => {
                empty(ui, "The robot presses on nothing along its pull.", |_| {});
            }
            Some(_) => return None,
        }
        return Some(None);
    }
    None
}

/// That the multipliers' forces are the paper's, with the way to true ones; and where
/// there is room below that.
fn understated(
    ui: &mut Ui,
    data: &PlotData<'_>,
    corner: Pos2,
    tokens: &Tokens,
) -> (Option<Asked>, Pos2) {
    if data.problem().model() != Model::Equal || data.stiffness().is_none() {
        return (None, corner);
    }
    let rect = eframe::egui::Rect::from_min_size(corner - vec2(6.0, 0.0), vec2(150.0, 22.0));
    let text = RichText::new("Forces understated").size(12.0).weak();
    let sign = icon(icons::WARNING).size(14.0).color(tokens.warning);
    let button = eframe::egui::Button::new((sign, text)).frame_when_inactive(false);
    let tip = "The paper’s model does not let the cable slide, so that its forces by multipliers \
               come out too small. Click to let the cable slide.";
    let response = ui.put(rect, button).on_hover_text(tip);
    let asked = response.clicked().then_some(Asked::Slide);
    (asked, pos2(corner.x, rect.bottom()))
}

/// How many of the estimate's assumptions do not hold; which, on hover. Returns where
/// there is room below that.
fn caveats(ui: &mut Ui, surface: &Surface<'_>, cache: &PlotCache, tokens: &Tokens) -> Pos2 {
    let corner = surface.frame().left_top() + vec2(8.0, 4.0);
    let caveats = &cache.forces.caveats;
    let text = match (caveats.len(), &cache.forces.work) {
        (0, _) => return corner,
        (_, Some(Err(_))) => "no estimate by virtual work".to_owned(),
        (1, _) => "an assumption of virtual work does not hold".to_owned(),
        (count, _) => format!("{count} assumptions of virtual work do not hold"),
    };
    let text = Text::of(&text, tokens.warning);
    let area = surface.name(corner, Align2::LEFT_TOP, text);
    let id = ui.scope_id().with("caveats");
    let response = ui.interact(area, id, Sense::hover());
    named(&response, "Assumptions of virtual work");
    response.on_hover_text(caveats.join("\n"));
    pos2(corner.x, area.bottom())
}

/// The least extent of an axis, in g: one of nothing would have no scale, and no
/// scale shows less than a microgram.
const LEAST_EXTENT_G: f64 = 1e-6;

/// The greatest load that is shown: the readings' or the path's usual one, and the
/// present one in any case.
fn widest(data: &PlotData<'_>, cache: &PlotCache) -> f64 {
    let here = present(data, cache).map_or(0.0, |point| ceiling(1.05 * point.x));
    cache.forces.widest.max(here).max(LEAST_EXTENT_G)
}

fn curves(ui: &mut Ui, data: &PlotData<'_>, cache: &PlotCache) -> egui_plot::PlotResponse<()> {
    let (theme, tokens) = (theme_of(ui), Tokens::in_ui(ui));
    let forces = &cache.forces;
    let abscissa = Quantities {
        name: "Load on the cable, from contact on",
        unit: "g",
    };
    let widest = widest(data, cache);
    let mut highest = data
        .readings()
        .iter()
        .map(|reading| reading.force_g)
        .fold(0.0, f64::max);
    let others = forces.others.iter().flat_map(|(_, pieces)| pieces);
    for piece in forces.total.iter().chain(others) {
        let seen = piece.iter().filter(|point| point.x <= widest);
        highest = seen.map(|point| point.y).fold(highest, f64::max);
    }
    if let Some(here) = present(data, cache) {
        highest = highest.max(here.y);
    }
    if let Some(force) = by_work(cache, widest) {
        highest = highest.max(force);
    }
    let height = ui.available_height();
    let plot = canvas("force", height, &abscissa, &tokens, Whole::No)
        .set_margin_fraction(vec2(0.02, 0.04))
        .include_x(0.0)
        .include_x(widest)
        .include_y(0.0)
        .include_y(1.05 * highest.max(LEAST_EXTENT_G));
    let work = by_work(cache, widest);
    plot.show(ui, |plot| {
        // A branch that stiffens without bound must not set the scale.
        let seen = |piece: &[PlotPoint]| {
            let beyond = piece.iter().position(|point| point.x > widest);
            beyond.unwrap_or(piece.len())
        };
        for (assumed, pieces) in &forces.others {
            let thin = Stroke::new(1.25, legend::ink(*assumed, theme));
            for piece in pieces {
                let line = curve("other", &piece[..seen(piece)], thin.color);
                plot.line(line.stroke(thin));
            }
        }
        let own = legend::ink(Assumed::of(data.problem()), theme);
        for piece in &forces.total {
            plot.line(curve("own", &piece[..seen(piece)], own));
        }
        if let Some(force) = work {
            let ends = vec![[0.0, 0.0], [widest, force]];
            let line = Line::new("virtual work", ends).allow_hover(false);
            plot.line(line.stroke(Stroke::new(2.0, hue(theme, 1))));
        }
    })
}

/// The index of the reading that the pointer is on.
fn nearest(surface: &Surface<'_>, readings: &[ForceReading]) -> Option<usize> {
    let pointer = surface.pointer?;
    let far = |reading: &ForceReading| {
        surface
            .at(reading.load_g, reading.force_g)
            .distance(pointer)
    };
    let distances = readings.iter().map(far).enumerate();
    let nearest = distances.min_by(|a, b| a.1.total_cmp(&b.1))?;
    (nearest.1 <= NEAR).then_some(nearest.0)
}

/// What was read, each with the way to what theory says.
fn readings(
    surface: &Surface<'_>,
    data: &PlotData<'_>,
    cache: &PlotCache,
    nearest: Option<usize>,
    tokens: &Tokens,
) {
    for (index, reading) in data.readings().iter().enumerate() {
        let at = surface.at(reading.load_g, reading.force_g);
        let theory =
            by_work(cache, reading.load_g).or_else(|| by_multipliers(cache, reading.load_g));
        if let Some(theory) = theory {
            let there = surface.at(reading.load_g, theory);
            let ink = tokens.muted.gamma_multiply(0.8);
            surface
                .painter
                .line_segment([at, there], Stroke::new(1.0, ink));
        }
        let radius = if nearest == Some(index) { 5.5 } else { 4.0 };
        surface
            .painter
            .circle_filled(at, radius + 1.0, tokens.panel);
        surface.painter.circle_filled(at, radius, tokens.text);
        if data.calibration() == Some(index) {
            let ring = Stroke::new(2.0, tokens.accent);
            surface.painter.circle_stroke(at, radius + 3.5, ring);
        }
    }
}

/// What there is to say on a reading: a small table.
fn told(response: Response, data: &PlotData<'_>, cache: &PlotCache, index: usize) {
    let reading = data.readings()[index];
    response.on_hover_ui_at_pointer(|ui| {
        let shown = |value: f64| Quantity::fixed(value, 1, "g").text();
        let title = format!(
            "{} at a load of {}",
            shown(reading.force_g),
            shown(reading.load_g)
        );
        ui.label(RichText::new(title).size(12.0).strong());
        eframe::egui::Grid::new("errors")
            .num_columns(3)
            .show(ui, |ui| {
                let own = Assumed::of(data.problem());
                let work = ("virtual work", by_work(cache, reading.load_g));
                let own = (
                    legend::word(own, own),
                    by_multipliers(cache, reading.load_g),
                );
                let others = cache.forces.others.iter().map(|(assumed, pieces)| {
                    let mut pieces = pieces.iter().rev();
                    let force = pieces.find_map(|piece| value_at(piece, reading.load_g));
                    (legend::word(*assumed, Assumed::of(data.problem())), force)
                });
                let theories = [work, own].into_iter().chain(others);
                for (name, theory) in theories {
                    if let Some(theory) = theory {
                        let error = theory - reading.force_g;
                        let sign = if error > 0.05 { "+" } else { "" };
                        ui.label(RichText::new(name).size(12.0).weak());
                        ui.label(RichText::new(shown(theory)).size(12.0));
                        ui.label(
                            RichText::new(format!("{sign}{}", shown(error)))
                                .size(12.0)
                                .weak(),
                        );
                        ui.end_row();
                    }
                }
            });
        let text = if data.calibration() == Some(index) {
            "Fixes μ of virtual work."
        } else {
            "Click to fix μ of virtual work by this reading."
        };
        ui.label(RichText::new(text).size(12.0).weak());
    });
}

/// What would add the other of the two ways, as a quiet button in the corner.
fn missing(ui: &mut Ui, data: &PlotData<'_>, surface: &Surface<'_>) -> Option<Asked> {
    let (text, asked) = if data.stiffness().is_none() {
        ("Set the stiffness", Asked::Stiffness)
    } else {
        ("Add a reading", Asked::Reading)
    };
    let frame = surface.frame();
    let size = vec2(118.0, 22.0);
    let corner = frame.right_bottom() - size - vec2(8.0, 8.0);
    let rect = eframe::egui::Rect::from_min_size(corner, size);
    let text = RichText::new(text).size(12.0).weak();
    let button = eframe::egui::Button::new(text).frame_when_inactive(false);
    ui.put(rect, button).clicked().then_some(asked)
}

pub(super) fn csv(
    data: &PlotData<'_>,
    cache: &PlotCache,
    table: &mut csv::Writer<Vec<u8>>,
) -> csv::Result<()> {
    table.write_record(["source", "load_g", "force_g", "pull_mm", "obstacle"])?;
    let mut row = |source: &str, load: f64, force: f64, pull: &str, obstacle: &str| {
        let (load, force) = (cell(load), cell(force));
        table.write_record([source, load.as_str(), force.as_str(), pull, obstacle])
    };
    for reading in data.readings() {
        row("measured", reading.load_g, reading.force_g, "", "")?;
    }
    for reading in data.readings() {
        if let Some(force) = by_work(cache, reading.load_g) {
            row("virtual work", reading.load_g, force, "", "")?;
        }
    }
    let own = Assumed::of(data.problem());
    if let Some(curve) = &cache.forces.curve {
        let source = legend::word(own, own);
        for point in &curve.points {
            let pull = cell(millimetres(point.pull));
            let load = grams(point.load);
            row(source, load, grams(point.total), &pull, "all")?;
            for (index, force) in curve.obstacles.iter().zip(&point.by_obstacle) {
                let on = words::obstacle_of(data.scene, *index);
                row(source, load, grams(*force), &pull, &on)?;
            }
        }
    }
    for (assumed, pieces) in &cache.forces.others {
        let source = legend::word(*assumed, own);
        for point in pieces.iter().flatten() {
            row(source, point.x, point.y, "", "all")?;
        }
    }
    Ok(())
}

pub(super) fn charts(data: &PlotData<'_>, cache: &PlotCache) -> Vec<Chart> {
    let mut series = Vec::new();
    let widest = cache.forces.widest;
    let own = Assumed::of(data.problem());
    let seen = |piece: &[PlotPoint]| {
        let seen = piece.iter().filter(|point| point.x <= widest);
        seen.map(|point| (point.x, point.y)).collect()
    };
    for (index, piece) in cache.forces.total.iter().enumerate() {
        let name = match index {
            0 => legend::word(own, own).to_owned(),
            jumps => format!("after {jumps} jumps"),
        };
        series.push(Series::new(name, CurveStyle::Line, seen(piece)));
    }
    for (assumed, pieces) in &cache.forces.others {
        for piece in pieces {
            let name = legend::word(*assumed, own);
            series.push(Series::new(name, CurveStyle::Dashed, seen(piece)));
        }
    }
    if let Some(force) = by_work(cache, widest) {
        let ends = vec![(0.0, 0.0), (widest, force)];
        series.push(Series::new("virtual work", CurveStyle::Line, ends));
    }
    let read = data.readings().iter();
    let read: Vec<_> = read.map(|r| (r.load_g, r.force_g)).collect();
    if !read.is_empty() {
        series.push(Series::new("measured", CurveStyle::Dots, read));
    }
    vec![Chart {
        title: "Force against load".to_owned(),
        word: "force",
        x: Axis::new("load on the cable, from contact on", "g"),
        y: Axis::new("force on obstacles", "g"),
        series,
    }]
}
