//! The robot in the other mechanics, as an outline beside the live one, with its own
//! arrows: hollow, on the scale of the live one's. In an ink of its own.

use crate::app::look::Tokens;
use crate::app::paint::to_screen;
use crate::app::workbench::Workbench;
use crate::contact::{Class, Contact};
use crate::geometry::Vector;
use crate::mechanics::Model;
use crate::units::per_millimetre;
use crate::view::{Arrowhead, Frame, Quantity};
use eframe::egui::{Align2, Color32, FontId, Painter, Pos2, Rect, Shape, Stroke, pos2, vec2};

/// An arrow is no longer than this, over the robot's length: the other model's may be
/// many times the live one's.
const LONGEST: f64 = 0.5;
/// Arrows shorter than this on the screen, in points, are only numbers.
const SHORTEST: f64 = 4.0;
/// Width of the live backbone on the screen, in points, at least.
const BACKBONE: f64 = 3.0;
/// Half of what the live backbone and its contacts keep clear of labels, in points.
const CLEAR: f32 = 7.0;
/// Room around a label, in points.
const AROUND: f32 = 3.0;

/// Paints the outline over the live robot: the edges of backbone and disks, the cable
/// thin, all with a seam that shows them on whatever lies below.
pub fn outline(painter: &Painter, bench: &Workbench, frame: &Frame, tokens: &Tokens) {
    let Some(other) = bench.other.solved().filter(|it| !it.nodes.is_empty()) else {
        return;
    };
    let at = |point: Vector| to_screen(frame, point);
    let robot = other.problem().robot();
    // No thinner than the live backbone is drawn.
    let half = (0.5 * robot.sizes.backbone).max(0.5 * BACKBONE / frame.scale);
    let edge = |side: f64| -> Vec<Pos2> { other.nodes.iter().map(|it| at(it.at(side))).collect() };
    let mut backbone = edge(-half);
    backbone.extend(edge(half).into_iter().rev());
    let cables = 0..other.problem().drive().cables.len();
    let cables: Vec<Vec<Pos2>> = cables
        .map(|index| other.cable_points(index).into_iter().map(at).collect())
        .collect();
    let points = backbone.iter().chain(cables.iter().flatten());
    if !points.into_iter().all(|point| point.is_finite()) {
        return;
    }
    let seam = Stroke::new(3.0, tokens.canvas.gamma_multiply(0.7));
    let line = Stroke::new(1.25, tokens.other);
    let disks = other.nodes.iter().enumerate();
    let disks = disks
        .filter(|(index, _)| robot.has_disk(*index))
        .map(|(_, node)| {
            let thick = 0.5 * robot.sizes.disk;
            let rim = robot.sizes.rim;
            let corner = |across: f64, along: f64| at(node.at(across) + along * node.normal());
            vec![
                corner(-rim, -thick),
                corner(rim, -thick),
                corner(rim, thick),
                corner(-rim, thick),
            ]
        });
    let disks: Vec<Vec<Pos2>> = disks.collect();
    for stroke in [seam, line] {
        for disk in &disks {
            painter.add(Shape::closed_line(disk.clone(), stroke));
        }
        painter.add(Shape::closed_line(backbone.clone(), stroke));
    }
    for cable in &cables {
        painter.extend(Shape::dashed_line(cable, line, 5.0, 4.0));
    }
}

/// Paints the arrows with their numbers, and what the outline is, beside what is
/// `taken` by other labels.
pub fn forces(
    painter: &Painter,
    bench: &Workbench,
    frame: &Frame,
    taken: impl Iterator<Item = Rect>,
    tokens: &Tokens,
) {
    let Some(other) = bench.other.solved().filter(|it| !it.nodes.is_empty()) else {
        return;
    };
    let mut taken: Vec<Rect> = taken.collect();
    taken.extend(robot_on_screen(bench, frame));
    let scale = bench.live.drawing().scale;
    let length = other.problem().length();
    for contact in other.contacts.iter().filter(is_pressing) {
        let long = scale.length(contact.multiplier).min(LONGEST * length);
        let tail = contact.point;
        let tip = tail + long * contact.normal;
        let [from, to] = [tail, tip].map(|point| frame.to_screen(point));
        if !(from - to).norm().is_finite() {
            continue;
        }
        if (from - to).norm() > SHORTEST {
            let outline = Arrowhead::STANDARD.outline(from.into(), to.into());
            let outline = outline.iter().map(|[x, y]| pos2(*x as f32, *y as f32));
            let stroke = Stroke::new(1.25, tokens.other);
            painter.add(Shape::closed_line(outline.collect(), stroke));
        }
        let text = match bench.document.force(contact.multiplier) {
            Some(force) => force.text(),
            None => Quantity::significant(per_millimetre(contact.multiplier), "rad²/mm").text(),
        };
        let towards = vec2(contact.normal.x as f32, -contact.normal.y as f32);
        let tip = pos2(to.x as f32, to.y as f32);
        label(painter, &mut taken, tip, towards, &text, tokens);
    }
    let name = match other.problem().model() {
        Model::Sliding => "sliding cable",
        Model::Equal => "paper’s model",
    };
    let tip = to_screen(frame, other.tip().position);
    label(painter, &mut taken, tip, vec2(0.0, -1.0), name, tokens);
}

fn is_pressing(contact: &&Contact) -> bool {
    contact.class == Class::Pressing
}

/// What the live backbone and its contacts cover of the screen.
fn robot_on_screen(bench: &Workbench, frame: &Frame) -> Vec<Rect> {
    let live = bench.live.solution();
    let backbone = live.into_iter().flat_map(|it| it.backbone());
    let contacts = live.into_iter().flat_map(|it| it.contacts.iter());
    let points = backbone.chain(contacts.map(|contact| contact.point));
    let around = |point| Rect::from_center_size(to_screen(frame, point), vec2(2.0, 2.0) * CLEAR);
    points.map(around).collect()
}

/// A quiet label on a plate beyond a point, where there is room; elsewhere none.
fn label(
    painter: &Painter,
    taken: &mut Vec<Rect>,
    point: Pos2,
    towards: eframe::egui::Vec2,
    text: &str,
    tokens: &Tokens,
) {
    if !point.is_finite() {
        return;
    }
    let font = FontId::proportional(12.0);
    let galley = painter.layout_no_wrap(text.to_owned(), font.clone(), Color32::WHITE);
    let half = 0.5 * galley.size();
    for away in [8.0, 20.0, 34.0, 50.0, 70.0] {
        for turn in [0.0_f32, 0.6, -0.6, 1.2, -1.2, 2.2, -2.2] {
            let (sine, cosine) = turn.sin_cos();
            let way = vec2(
                cosine * towards.x - sine * towards.y,
                sine * towards.x + cosine * towards.y,
            );
            // As far as the box reaches back towards the point.
            let reach = (half.x / way.x.abs()).min(half.y / way.y.abs());
            let middle = point + (reach + away) * way;
            let plate = Rect::from_center_size(middle, 2.0 * half).expand(AROUND);
            let free = taken.iter().all(|other| !other.intersects(plate));
            if free && painter.clip_rect().contains_rect(plate) {
                painter.rect_filled(plate, 4.0, tokens.canvas.gamma_multiply(0.85));
                painter.text(middle, Align2::CENTER_CENTER, text, font, tokens.other);
                taken.push(plate);
                return;
            }
        }
    }
}
