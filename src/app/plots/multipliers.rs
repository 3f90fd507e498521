//! Multipliers by node, the paper's Fig. 5: which parts of the robot press, and
//! how hard.

use super::cache::PlotCache;
use super::cache::{Side, Stem, Twin};
use super::data::{Link, Plot, PlotData};
use super::pane::{
    Asked, Quantities, Surface, Text, Whole, canvas, cell, header, heat, named, ordinate,
};
use crate::app::look::{Tokens, theme_of};
use crate::app::words;
use crate::app::workbench::{Hovered, nodes_of_stretch};
use crate::contact::Class;
use crate::robot::{disk_name, part_name};
use crate::units::{grams, millimetres, per_millimetre};
use crate::view::{Axis, Chart, CurveStyle, Quantity, Series, Theme, superscript};
use eframe::egui::{Align2, Color32, FontId, Pos2, Rect, Stroke, Ui, pos2, vec2};

/// How near the pointer has to be to a stem.
const NEAR: f32 = 16.0;
/// The greatest height of a stem, as a share of the scale's.
const FULL: f64 = 0.95;

/// The unit of the axis: a power of a thousand that leaves one to three digits
/// before the point.
pub(super) fn scale(greatest: f64) -> (f64, String) {
    if greatest <= 0.0 {
        return (1.0, "rad²/mm".to_owned());
    }
    let power = (greatest.log10() / 3.0).floor() as i32 * 3;
    if power == 0 {
        return (1.0, "rad²/mm".to_owned());
    }
    let unit = format!("10{} rad²/mm", superscript(power));
    (10f64.powi(-power), unit)
}

/// The least of 1, 1.5, 2, 3, 5 and 8 times a power of ten that a value fits under,
/// so that stems grow with the pull and the axis changes now and then only.
pub(super) fn ceiling(value: f64) -> f64 {
    if value <= 0.0 {
        return 1.0;
    }
    let power = 10f64.powf(value.log10().floor());
    let steps = [1.0, 1.5, 2.0, 3.0, 5.0, 8.0].map(|step| step * power);
    let fits = steps.into_iter().find(|step| FULL * step >= value);
    fits.unwrap_or(10.0 * power / FULL)
}

pub(super) fn show(
    ui: &mut Ui,
    data: &PlotData<'_>,
    cache: &PlotCache,
    link: &mut Link,
) -> Option<Asked> {
    let (theme, tokens) = (theme_of(ui), Tokens::in_ui(ui));
    let shape = &cache.shape;
    // In the paper's units where grams are not known.
    let (factor, unit) = match data.stiffness() {
        Some(stiffness) => (
            grams(stiffness.per_bend(data.problem())) / per_millimetre(1.0),
            "g".to_owned(),
        ),
        None => scale(shape.greatest),
    };
    let multiplier = Quantities {
        name: match data.stiffness() {
            Some(_) => "Contact force F",
            None => "Multiplier λ",
        },
        unit: &unit,
    };
    let reading = reading(data, link, &tokens);
    let name = ordinate(&multiplier, &tokens);
    let asked = header(ui, Plot::Multipliers, name, reading, |_| {});
    let abscissa = Quantities {
        name: "Node, from 0 at the base",
        unit: "",
    };
    let segments = data.problem().robot().segments as f64;
    let top = ceiling(factor * shape.greatest);
    let height = ui.available_height();
    let plot = canvas("multipliers", height, &abscissa, &tokens, Whole::Yes)
        .set_margin_fraction(vec2(0.025, 0.0))
        .include_x(0.0)
        .include_x(segments)
        .include_y(-0.04 * top)
        .include_y(top);
    let shown = plot.show(ui, |_| {});
    named(&shown.response, "Multipliers by node");
    let painter = ui
        .painter()
        .with_clip_rect(shown.transform.frame().expand(8.0));
    let surface = Surface::of(&painter, &shown.response, shown.transform, &tokens);
    nodes(&surface, data, link, &tokens);
    if shape.greatest <= 0.0 {
        let ink = tokens.muted;
        let font = FontId::proportional(super::pane::SMALL);
        let text = "Nothing presses at this pull.";
        painter.text(
            surface.frame().center(),
            Align2::CENTER_CENTER,
            text,
            font,
            ink,
        );
    }
    for stem in &shape.stems {
        let chosen = link.hovered == Hovered::Contact(stem.contact);
        draw(&surface, stem, factor, chosen, theme, &tokens);
    }
    values(&surface, &shape.stems, factor, &tokens);
    if let Some(pointer) = surface.pointer {
        let distance = |stem: &&Stem| {
            let head = head(&surface, stem, factor);
            (head.x - pointer.x).abs() + 0.2 * (head.y - pointer.y).abs()
        };
        let stems = shape.stems.iter();
        let nearest = stems
            .filter(|stem| (surface.x(stem.at) - pointer.x).abs() <= NEAR)
            .min_by(|a, b| distance(a).total_cmp(&distance(b)));
        link.hovering = match nearest {
            Some(stem) => Hovered::Contact(stem.contact),
            None => {
                let node = surface.value().unwrap_or(0.0).round();
                Hovered::Node(node.clamp(0.0, segments) as usize)
            }
        };
    }
    asked
}

/// What the cursor is on, in words and numbers.
fn reading(data: &PlotData<'_>, link: &Link, tokens: &Tokens) -> Text {
    let robot = data.problem().robot();
    match link.hovered {
        Hovered::Contact(index) => {
            let Some(contact) = data.solved.contacts.get(index) else {
                return Text::default();
            };
            let on = words::obstacle_of(data.scene, contact.obstacle);
            let part = part_name(robot, contact.line, contact.node);
            let multiplier = per_millimetre(contact.multiplier);
            let text = Text::of(&format!("{part}, on {on}"), tokens.text);
            let text = match contact.class {
                Class::Pressing => {
                    text.value("λ", &Quantity::significant(multiplier, "rad²/mm"), tokens)
                }
                Class::Grazing => text.and("   grazes", tokens.muted),
            };
            match data.stiffness() {
                Some(stiffness) => {
                    let force = stiffness.per_bend(data.problem()) * contact.multiplier;
                    text.value("F", &Quantity::significant(grams(force), "g"), tokens)
                }
                None => text,
            }
        }
        Hovered::Node(node) if node <= robot.segments => {
            let text = Text::of(&format!("node {node}"), tokens.muted);
            text.and(&format!(", {}", disk_name(robot, node)), tokens.muted)
        }
        _ => Text::default(),
    }
}

/// The base line with its nodes and disks, and the node that the pointer is on.
fn nodes(surface: &Surface<'_>, data: &PlotData<'_>, link: &Link, tokens: &Tokens) {
    let robot = data.problem().robot();
    let frame = surface.frame();
    let spacing = surface.x(1.0) - surface.x(0.0);
    let half = (0.5 * spacing).max(1.5);
    let lit = match link.hovered {
        Hovered::Node(node) => {
            let x = surface.x(node as f64);
            Some([x - half, x + half])
        }
        Hovered::Stretch { stretch, .. } => {
            let nodes = nodes_of_stretch(data.problem(), stretch);
            Some([nodes.start, nodes.end].map(|node| surface.x(node as f64)))
        }
        _ => None,
    };
    if let Some([left, right]) = lit {
        let band = Rect::from_x_y_ranges(left..=right, frame.y_range());
        surface
            .painter
            .rect_filled(band, 0.0, tokens.accent.gamma_multiply(0.10));
    }
    surface.zero(tokens);
    let foot = surface.y(0.0);
    if spacing >= 5.0 {
        for node in 0..=robot.segments {
            let at = pos2(surface.x(node as f64), foot);
            surface.painter.circle_filled(at, 1.5, tokens.muted);
        }
    }
    if spacing * robot.segments_per_bay as f32 >= 4.0 {
        let ink = Stroke::new(2.0, tokens.muted);
        for node in (0..=robot.segments).step_by(robot.segments_per_bay) {
            let x = surface.x(node as f64);
            surface.painter.vline(x, foot - 3.5..=foot + 3.5, ink);
        }
    }
}

/// Where a stem ends on the screen: a little aside of its node where the other
/// side presses as well.
fn head(surface: &Surface<'_>, stem: &Stem, factor: f64) -> Pos2 {
    let aside = match (stem.twin, stem.side) {
        (Twin::None, _) => 0.0,
        (Twin::OtherSide, Side::Cable) => 3.5,
        (Twin::OtherSide, Side::Backbone) => -3.5,
    };
    surface.at(stem.at, factor * stem.multiplier) + vec2(aside, 0.0)
}

/// A stem with its head: full on the cable's side, open on the backbone's.
fn draw(
    surface: &Surface<'_>,
    stem: &Stem,
    factor: f64,
    chosen: bool,
    theme: Theme,
    tokens: &Tokens,
) {
    let head = head(surface, stem, factor);
    let foot = pos2(head.x, surface.y(0.0));
    if stem.multiplier <= 0.0 {
        let ring = Stroke::new(1.0, tokens.muted);
        surface.painter.circle_stroke(foot, 4.5, ring);
        return;
    }
    let ink = heat(theme, stem.share);
    // The weak end of the scale would not stand out by day.
    let edge = match theme {
        Theme::Light => heat(theme, 1.0),
        Theme::Dark => ink,
    };
    surface.painter.line_segment(
        [foot, head],
        Stroke::new(if chosen { 4.0 } else { 2.5 }, ink),
    );
    let radius = if chosen { 6.5 } else { 5.0 };
    match stem.side {
        Side::Cable => {
            surface.painter.circle_filled(head, radius, ink);
            surface
                .painter
                .circle_stroke(head, radius, Stroke::new(1.0, edge));
        }
        Side::Backbone => {
            surface.painter.circle_filled(head, radius, tokens.panel);
            surface
                .painter
                .circle_stroke(head, radius - 1.0, Stroke::new(2.5, ink));
            surface
                .painter
                .circle_stroke(head, radius + 0.25, Stroke::new(0.75, edge));
        }
    }
}

/// The values and sides of the greatest stems, above their heads.
fn values(surface: &Surface<'_>, stems: &[Stem], factor: f64, tokens: &Tokens) {
    let mut order: Vec<&Stem> = stems.iter().filter(|stem| stem.multiplier > 0.0).collect();
    order.sort_by(|a, b| b.multiplier.total_cmp(&a.multiplier));
    order.truncate(6);
    let mut taken: Vec<Rect> = Vec::new();
    for stem in order {
        let head = head(surface, stem, factor);
        let digits = Quantity::significant(factor * stem.multiplier, "").digits;
        let text = Text::of(&digits, tokens.text).and(&format!(" {}", stem.part), tokens.muted);
        let galley = surface.painter.layout_job(text.job());
        let size = galley.size();
        let frame = surface.frame();
        // Beside the head where it is near the top or another name.
        let above = pos2(head.x - 0.5 * size.x, head.y - size.y - 8.0);
        let right = pos2(head.x + 10.0, head.y - 0.5 * size.y);
        let left = pos2(head.x - 10.0 - size.x, head.y - 0.5 * size.y);
        let place = [above, right, left].into_iter().find_map(|at| {
            let area = Rect::from_min_size(at, size);
            let stems = stems.iter().any(|other| {
                let x = surface.x(other.at);
                let top = surface.y(factor * other.multiplier) - 6.0;
                (area.left() - 4.0..=area.right() + 4.0).contains(&x) && area.bottom() > top
            });
            let free = !stems && frame.contains_rect(area);
            (free && !taken.iter().any(|other| other.intersects(area.expand(2.0)))).then_some(area)
        });
        if let Some(area) = place {
            surface
                .painter
                .galley(area.min, galley, Color32::PLACEHOLDER);
            taken.push(area);
        }
    }
}

pub(super) fn csv(data: &PlotData<'_>, table: &mut csv::Writer<Vec<u8>>) -> csv::Result<()> {
    table.write_record([
        "node",
        "part",
        "line",
        "obstacle",
        "class",
        "multiplier_rad2_per_mm",
        "force_g",
        "point_x_mm",
        "point_y_mm",
        "normal_x",
        "normal_y",
    ])?;
    let per_bend = data.stiffness().map(|ei| ei.per_bend(data.problem()));
    for contact in &data.solved.contacts {
        let force = per_bend.map(|per_bend| grams(per_bend * contact.multiplier));
        table.write_record([
            contact.node.to_string(),
            part_name(data.problem().robot(), contact.line, contact.node),
            contact.line.name().to_owned(),
            words::obstacle_of(data.scene, contact.obstacle),
            contact.class.word().to_owned(),
            cell(per_millimetre(contact.multiplier)),
            force.map_or_else(String::new, cell),
            cell(millimetres(contact.point.x)),
            cell(millimetres(contact.point.y)),
            cell(contact.normal.x),
            cell(contact.normal.y),
        ])?;
    }
    Ok(())
}

pub(super) fn charts(data: &PlotData<'_>, cache: &PlotCache) -> Vec<Chart> {
    let shape = &cache.shape;
    let nodes = data.problem().robot().segments;
    let series = [
        (Side::Cable, "cable side"),
        (Side::Backbone, "backbone side"),
    ]
    .map(|(side, name)| {
        let on = |node: usize| {
            let here = shape
                .stems
                .iter()
                .filter(|stem| stem.side == side && stem.at.round() == node as f64);
            1e6 * here.map(|stem| stem.multiplier).sum::<f64>() + 0.0
        };
        let points = (0..=nodes).map(|node| (node as f64, on(node)));
        Series::new(name, CurveStyle::Stems, points.collect())
    });
    vec![Chart {
        title: "Multipliers by node".to_owned(),
        word: "multipliers",
        x: Axis::new("node, from 0 at the base", ""),
        y: Axis::new("multiplier", "10⁻⁶ rad²/mm"),
        series: series.to_vec(),
    }]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_axis_has_one_to_three_digits() {
        let check = |greatest: f64, unit: &str, shown: f64| {
            let (factor, named) = scale(greatest);
            assert_eq!(named, unit);
            assert!(
                (factor * greatest - shown).abs() < 1e-9 * shown,
                "{greatest}"
            );
        };
        check(4.2e-3, "10⁻³ rad²/mm", 4.2);
        check(4.2e-4, "10⁻⁶ rad²/mm", 420.0);
        check(0.9, "10⁻³ rad²/mm", 900.0);
        check(12.0, "rad²/mm", 12.0);
        check(1.2e4, "10³ rad²/mm", 12.0);
        assert_eq!(scale(0.0).0, 1.0);
    }

    #[test]
    fn every_stem_fits_under_the_ceiling() {
        for value in [1e-9, 0.95, 0.96, 1.0, 2.9, 7.7, 9.6, 123.0] {
            let top = ceiling(value);
            assert!(FULL * top >= value * (1.0 - 1e-12), "{value} {top}");
            assert!(top <= 2.2 * value, "{value} {top}");
        }
        assert_eq!(ceiling(0.0), 1.0);
    }
}
