//! Bends and shears by segment: where the robot gives, and how it differs from
//! the free robot's arc.

use super::cache::PlotCache;
use super::data::{Link, Plot, PlotData};
use super::pane::{
    Asked, Quantities, Surface, Text, Whole, canvas, cell, curve, empty, header, hue, named,
    ordinate,
};
use crate::app::look::{Tokens, theme_of};
use crate::app::workbench::{Hovered, nodes_of_stretch};
use crate::units::degrees;
use crate::view::{Axis, Chart, CurveStyle, Quantity, Series};
use eframe::egui::{Align2, Rect, Ui, vec2};

pub(super) fn show(
    ui: &mut Ui,
    data: &PlotData<'_>,
    cache: &PlotCache,
    link: &mut Link,
) -> Option<Asked> {
    let (theme, tokens) = (theme_of(ui), Tokens::in_ui(ui));
    let shape = &cache.shape;
    let segments = data.solved.bends.len();
    let segment = match link.hovered {
        Hovered::Node(node) => (1..=segments).contains(&node).then_some(node),
        _ => None,
    };
    let mut reading = Text::default();
    if let Some(segment) = segment {
        let bend = degrees(data.solved.bends[segment - 1]);
        let shear = degrees(data.solved.shears[segment - 1]);
        reading = Text::of(&format!("segment {segment}"), tokens.muted)
            .value("bend", &Quantity::fixed(bend, 2, "°"), &tokens)
            .value("shear", &Quantity::fixed(shear, 2, "°"), &tokens);
    }
    let angle = Quantities {
        name: "Angle, clockwise",
        unit: "°",
    };
    let name = ordinate(&angle, &tokens);
    let asked = header(ui, Plot::Bends, name, reading, |_| {});
    if segments == 0 {
        empty(ui, "The first shape is being solved.", |_| {});
        return asked;
    }
    let abscissa = Quantities {
        name: "Segment, from the base",
        unit: "",
    };
    let height = ui.available_height();
    let plot = canvas("bends", height, &abscissa, &tokens, Whole::Yes)
        .set_margin_fraction(vec2(0.01, 0.1))
        .include_x(0.5)
        .include_x(segments as f64 + 0.5)
        .include_y(0.0)
        .include_y(shape.free_bend);
    let series = [("bend", &shape.bends, 0), ("shear", &shape.shears, 1)];
    let shown = plot.show(ui, |plot| {
        for (name, points, index) in series {
            plot.line(curve(name, points, hue(theme, index)));
        }
    });
    named(&shown.response, "Bends and shears by segment");
    let painter = ui.painter().with_clip_rect(*shown.transform.frame());
    let surface = Surface::of(&painter, &shown.response, shown.transform, &tokens);
    let frame = surface.frame();
    surface.zero(&tokens);
    let level = surface.y(shape.free_bend);
    let ends = [frame.left(), frame.right()].map(|x| eframe::egui::pos2(x, level));
    surface.dashed(ends, tokens.muted);
    if let Some(value) = surface.value() {
        let segment = (value.round().max(1.0) as usize).min(segments);
        link.hovering = Hovered::Node(segment);
    }
    let lit = match link.hovered {
        Hovered::Stretch { stretch, .. } => {
            let nodes = nodes_of_stretch(data.problem(), stretch);
            Some([nodes.start + 1, nodes.end])
        }
        _ => segment.map(|segment| [segment, segment]),
    };
    if let Some([first, last]) = lit {
        let (left, right) = (surface.x(first as f64 - 0.5), surface.x(last as f64 + 0.5));
        let band = Rect::from_x_y_ranges(left..=right.max(left + 2.0), frame.y_range());
        painter.rect_filled(band, 0.0, tokens.accent.gamma_multiply(0.12));
    }
    let mut names: Vec<Rect> = Vec::new();
    let free = (shape.free_bend, "free robot's bend", tokens.muted);
    let curves = series.map(|(name, points, index)| {
        let level = points.last().map_or(0.0, |point| point.y);
        (level, name, hue(theme, index))
    });
    for (level, name, ink) in curves.into_iter().chain([free]) {
        // On whichever side of its line no other name is.
        let right = frame.right() - 4.0;
        let y = surface.y(level);
        let places = [
            (y - 3.0, Align2::RIGHT_BOTTOM),
            (y + 3.0, Align2::RIGHT_TOP),
            (y - 19.0, Align2::RIGHT_BOTTOM),
            (y + 19.0, Align2::RIGHT_TOP),
        ];
        let free_place = places.into_iter().find(|(y, anchor)| {
            let size = vec2(7.0 * name.len() as f32, 14.0);
            let area = anchor.anchor_size(eframe::egui::pos2(right, *y), size);
            frame.contains_rect(area) && !names.iter().any(|other| other.intersects(area))
        });
        if let Some((y, anchor)) = free_place {
            let at = eframe::egui::pos2(right, y);
            names.push(surface.name(at, anchor, Text::of(name, ink)));
        }
    }
    asked
}

pub(super) fn csv(data: &PlotData<'_>, table: &mut csv::Writer<Vec<u8>>) -> csv::Result<()> {
    table.write_record(["segment", "bend_deg", "shear_deg", "free_bend_deg"])?;
    let free = cell(degrees(data.free_bend()));
    let angles = data.solved.bends.iter().zip(&data.solved.shears);
    for (index, (bend, shear)) in angles.enumerate() {
        let segment = (index + 1).to_string();
        let (bend, shear) = (cell(degrees(*bend)), cell(degrees(*shear)));
        table.write_record([&segment, &bend, &shear, &free])?;
    }
    Ok(())
}

pub(super) fn charts(cache: &PlotCache) -> Vec<Chart> {
    let shape = &cache.shape;
    let corners = |points: &[egui_plot::PlotPoint]| points.iter().map(|p| (p.x, p.y)).collect();
    let last = shape.bends.last().map_or(1.0, |point| point.x);
    let free = vec![(0.5, shape.free_bend), (last, shape.free_bend)];
    vec![Chart {
        title: "Bends and shears by segment".to_owned(),
        word: "bends",
        x: Axis::new("segment, from the base", ""),
        y: Axis::new("angle, clockwise", "deg"),
        series: vec![
            Series::new("bend", CurveStyle::Line, corners(&shape.bends)),
            Series::new("free robot's bend", CurveStyle::Dashed, free),
            Series::new("shear", CurveStyle::Line, corners(&shape.shears)),
        ],
    }]
}
