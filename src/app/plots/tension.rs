//! The tension along every cable, stretch by stretch: what its load becomes on the
//! way to where the cable ends.

use super::cache::{PlotCache, Pull};
use super::data::{Link, Plot, PlotData};
use super::holes;
use super::multipliers::{ceiling, scale};
use super::pane::{
    Asked, Quantities, Surface, Text, Whole, canvas, cell, curve, empty, header, hue, named,
    ordinate,
};
use crate::app::look::{Tokens, theme_of};
use crate::app::words;
use crate::app::workbench::{Hovered, nodes_of_stretch};
use crate::units::{grams, per_millimetre};
use crate::view::{Axis, Chart, CurveStyle, Quantity, Series};
use eframe::egui::{Align2, Rect, Stroke, Ui, vec2};

/// How near the pointer has to be to a line, in points, to be on that cable rather
/// than on the nearest.
const SPREAD: f32 = 12.0;
/// Space below zero, and above the highest line, over the scale.
const MARGINS: [f64; 2] = [0.04, 0.08];

/// A tension, as computed, in the unit of the axis, and that unit.
pub(super) fn in_unit(data: &PlotData<'_>, greatest: f64) -> (f64, String) {
    match data.stiffness() {
        Some(_) => (grams(1.0), "g".to_owned()),
        None => {
            let (factor, unit) = scale(per_millimetre(greatest));
            (per_millimetre(factor), unit)
        }
    }
}

pub(super) fn show(
    ui: &mut Ui,
    data: &PlotData<'_>,
    cache: &PlotCache,
    link: &mut Link,
) -> Option<Asked> {
    let (theme, tokens) = (theme_of(ui), Tokens::in_ui(ui));
    let pulls = &cache.shape.pulls;
    let all = || pulls.iter().flat_map(|pull| &pull.levels).copied();
    let (most, least) = (all().fold(0.0, f64::max), all().fold(0.0, f64::min));
    let (factor, unit) = in_unit(data, most.max(-least));
    let tension = Quantities {
        name: "Tension T",
        unit: &unit,
    };
    let chosen = chosen(data, link, pulls);
    let reading = reading(data, pulls, chosen, (factor, &unit), &tokens);
    let asked = header(
        ui,
        Plot::Tension,
        ordinate(&tension, &tokens),
        reading,
        |_| {},
    );
    if pulls.is_empty() {
        empty(ui, "The first shape is being solved.", |_| {});
        return asked;
    }
    let abscissa = Quantities {
        name: "Disk, from 0 at the base",
        unit: "",
    };
    let robot = data.problem().robot();
    let disks = robot.segments as f64 / robot.segments_per_bay as f64;
    let top = ceiling((1.0 + MARGINS[1]) * factor * most);
    // In the paper's model a cable can push.
    let bottom = match factor * least {
        least if least < 0.0 => -ceiling(-(1.0 + MARGINS[1]) * least),
        _ => -MARGINS[0] * top,
    };
    let height = ui.available_height();
    let plot = canvas("tension", height, &abscissa, &tokens, Whole::Yes)
        .set_margin_fraction(vec2(0.025, 0.0))
        .include_x(0.0)
        .include_x(disks)
        .include_y(bottom)
        .include_y(top);
    let steps: Vec<Vec<_>> = pulls.iter().map(|pull| pull.steps(factor)).collect();
    let shown = plot.show(ui, |plot| {
        for (index, steps) in steps.iter().enumerate() {
            plot.line(curve("tension", steps, hue(theme, index)));
        }
    });
    named(&shown.response, "Tension along the cables");
    let painter = ui.painter().with_clip_rect(*shown.transform.frame());
    let surface = Surface::of(&painter, &shown.response, shown.transform, &tokens);
    surface.zero(&tokens);
    if let Some((cable, stretch)) = chosen
        && let Some(pull) = pulls.get(cable)
    {
        let [from, to] = pull.ends(stretch);
        let (left, right) = (surface.x(from), surface.x(to));
        let frame = surface.frame();
        let band = Rect::from_x_y_ranges(left..=right.max(left + 2.0), frame.y_range());
        painter.rect_filled(band, 0.0, tokens.accent.gamma_multiply(0.10));
        let y = surface.y(factor * pull.levels[stretch]);
        painter.hline(left..=right, y, Stroke::new(4.0, hue(theme, cable)));
    }
    holes::paint(&surface, pulls, factor, theme, &tokens);
    names(&surface, pulls, factor, theme, &tokens);
    if let Some(on) = under(&surface, pulls, factor, link) {
        link.hovering = on;
    }
    asked
}

/// The cable and stretch that the pointer is on here or whose twin it is on elsewhere.
fn chosen(data: &PlotData<'_>, link: &Link, pulls: &[Pull]) -> Option<(usize, usize)> {
    let node = match link.hovered {
        Hovered::Stretch { cable, stretch } => {
            let known = stretch < pulls.get(cable)?.levels.len();
            return known.then_some((cable, stretch));
        }
        Hovered::Node(node) => node,
        Hovered::Contact(index) => data.solved.contacts.get(index)?.node,
        _ => return None,
    };
    // The stretch that ends at the node, or that it is on.
    let nodes = nodes_of_stretch(data.problem(), 0).len();
    let stretch = node.max(1).div_ceil(nodes) - 1;
    (stretch < pulls.first()?.levels.len()).then_some((0, stretch))
}

/// The tension of the stretch that is chosen.
fn reading(
    data: &PlotData<'_>,
    pulls: &[Pull],
    chosen: Option<(usize, usize)>,
    (factor, unit): (f64, &str),
    tokens: &Tokens,
) -> Text {
    let Some((cable, stretch)) = chosen else {
        return Text::default();
    };
    let place = words::stretch(data.problem(), pulls.len(), cable, stretch);
    let level = factor * pulls[cable].levels[stretch];
    let mut text = Text::of(&place, tokens.muted);
    if let Some(slip) = pulls[cable].slips.get(stretch) {
        let how = words::slips(*slip);
        text = text.and(&format!("  D{stretch} {how}"), tokens.muted);
    }
    match data.stiffness() {
        Some(_) => text.value("T", &Quantity::fixed(level, 1, "g"), tokens),
        None => text
            .value("T", &Quantity::significant(level, ""), tokens)
            .and(&format!(" {unit}"), tokens.muted),
    }
}

/// The cables' names over the ends of their lines, as far as there are several, and
/// that one hangs loose.
fn names(
    surface: &Surface<'_>,
    pulls: &[Pull],
    factor: f64,
    theme: crate::view::Theme,
    tokens: &Tokens,
) {
    let mut taken: Vec<Rect> = Vec::new();
    for (index, pull) in pulls.iter().enumerate() {
        let Some(last) = pull.levels.len().checked_sub(1) else {
            continue;
        };
        let mut text = Text::default();
        if pulls.len() > 1 {
            text = text.and(&format!("cable {}", index + 1), hue(theme, index));
        }
        if pull.is_slack {
            let word = if pulls.len() > 1 { ", slack" } else { "slack" };
            text = text.and(word, tokens.muted);
        } else if pulls.len() < 2 {
            continue;
        }
        let end = surface.at(pull.ends(last)[1], factor * pull.levels[last]);
        let (over, below) = (vec2(-4.0, -4.0), vec2(-4.0, 4.0));
        let places = [(over, Align2::RIGHT_BOTTOM), (below, Align2::RIGHT_TOP)];
        let size = surface.painter.layout_job(text.clone().job()).size();
        let free = places.into_iter().find(|(aside, anchor)| {
            let area = anchor.anchor_size(end + *aside, size);
            !taken.iter().any(|other| other.intersects(area))
        });
        let (aside, anchor) = free.unwrap_or(places[0]);
        taken.push(surface.name(end + aside, anchor, text));
    }
}

/// What the pointer is on: the stretch below it, of the cable whose line is nearest.
fn under(surface: &Surface<'_>, pulls: &[Pull], factor: f64, link: &Link) -> Option<Hovered> {
    let (pointer, disk) = (surface.pointer?, surface.value()?);
    let stretch_of = |pull: &Pull| {
        let stretch = (disk / pull.per_stretch).floor().max(0.0) as usize;
        stretch.min(pull.levels.len().saturating_sub(1))
    };
    let far = |index: usize, pull: &Pull| {
        let level = pull.levels.get(stretch_of(pull)).copied();
        let away = level.map_or(f32::INFINITY, |level| {
            (surface.y(factor * level) - pointer.y).abs()
        });
        // What is hovered stays so where lines lie on each other.
        let held = matches!(link.hovered, Hovered::Stretch { cable, .. } if cable == index);
        if held { away - SPREAD } else { away }
    };
    let reaches = |pull: &&Pull| disk <= pull.levels.len() as f64 * pull.per_stretch;
    let any = pulls.iter().any(|pull| reaches(&pull));
    let pulls = pulls.iter().enumerate();
    let (cable, pull) = pulls
        .filter(|(_, pull)| !pull.levels.is_empty() && (reaches(pull) || !any))
        .min_by(|a, b| far(a.0, a.1).total_cmp(&far(b.0, b.1)))?;
    Some(Hovered::Stretch {
        cable,
        stretch: stretch_of(pull),
    })
}

pub(super) fn csv(
    data: &PlotData<'_>,
    cache: &PlotCache,
    table: &mut csv::Writer<Vec<u8>>,
) -> csv::Result<()> {
    let known = data.stiffness().is_some();
    let tension = if known {
        "tension_g"
    } else {
        "tension_rad2_per_mm"
    };
    let head = ["cable", "stretch", "from_disk", "to_disk", tension, "slips"];
    table.write_record(head)?;
    for (index, pull) in cache.shape.pulls.iter().enumerate() {
        for (stretch, level) in pull.levels.iter().enumerate() {
            let [from, to] = pull.ends(stretch);
            let level = if known {
                grams(*level)
            } else {
                per_millimetre(*level)
            };
            table.write_record([
                (index + 1).to_string(),
                (stretch + 1).to_string(),
                cell(from),
                cell(to),
                cell(level),
                // Through the hole that the stretch starts from.
                pull.slips
                    .get(stretch)
                    .map_or("", |slip| slip.word())
                    .to_owned(),
            ])?;
        }
    }
    Ok(())
}

pub(super) fn charts(data: &PlotData<'_>, cache: &PlotCache) -> Vec<Chart> {
    let known = data.stiffness().is_some();
    let (factor, unit) = match known {
        true => (grams(1.0), "g"),
        false => (1e6 * per_millimetre(1.0), "10⁻⁶ rad²/mm"),
    };
    let pulls = cache.shape.pulls.iter().enumerate();
    let series = pulls.map(|(index, pull)| {
        let points = pull.steps(factor).iter().map(|p| (p.x, p.y)).collect();
        Series::new(format!("cable {}", index + 1), CurveStyle::Line, points)
    });
    vec![Chart {
        title: "Tension along the cables".to_owned(),
        word: "tension",
        x: Axis::new("disk, from 0 at the base", ""),
        y: Axis::new("tension", unit),
        series: series.collect(),
    }]
}
