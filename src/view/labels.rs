//! Room for labels: where each goes on the screen so that none covers another,
//! and as little of the drawing as can be. It writes nothing.
//!
//! Greedy, in the order of the labels: numbers on contacts come first. Of a
//! few dozen places each takes the one that covers least; a label that fits
//! nowhere is left out rather than written over another.

use super::bounds::Bounds;
use super::drawing::{Drawing, Geometry, LabelText, Role, Spot};
use super::frame::Frame;
use super::path::clip_half_plane;
use crate::geometry::Vector;

/// A label with its place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Placed {
    /// Its index in [`Drawing::labels`].
    pub label: usize,
    /// The box its text fills on the screen, in pixels.
    pub area: Bounds,
}

/// Distance of labels from each other and from what they belong to, in pixels.
const GAP: f64 = 4.0;
/// Distance between the points that stand for a line, in pixels.
const SAMPLE: f64 = 3.0;
/// What a pixel of distance costs, in points covered.
const FARNESS: f64 = 0.08;
/// A name that covers more than this is left out.
const MOST_COVERED: f64 = 12.0;

/// The places of a drawing's labels. `measure` gives the width and height of a
/// text on the screen, in pixels.
pub fn place_labels(
    drawing: &Drawing,
    frame: &Frame,
    measure: impl Fn(&LabelText) -> Vector,
) -> Vec<Placed> {
    place_labels_beside(drawing, frame, &[], measure)
}

/// Like [`place_labels`], where some areas of the screen, in pixels, are taken
/// by other things.
pub fn place_labels_beside(
    drawing: &Drawing,
    frame: &Frame,
    taken: &[Bounds],
    measure: impl Fn(&LabelText) -> Vector,
) -> Vec<Placed> {
    let ink = ink(drawing, frame);
    let mut placed: Vec<Placed> = Vec::new();
    for (index, label) in drawing.labels.iter().enumerate() {
        let half = 0.5 * measure(&label.text);
        let area = |centre: Vector| Bounds {
            least: centre - half,
            most: centre + half,
        };
        let mut best: Option<(f64, Bounds)> = None;
        for (cost, centre) in places(&label.spot, frame, half) {
            let area = area(centre);
            let apart = area.grown(0.5 * GAP);
            let in_window = area.within(frame.window.grown(-GAP)) == area;
            let others = placed.iter().map(|other| &other.area);
            let free = others
                .chain(taken)
                .all(|other| apart.within(other.grown(0.5 * GAP)).is_empty());
            if !in_window || !free {
                continue;
            }
            let covered: f64 = ink
                .iter()
                .filter(|(point, _)| apart.holds(*point))
                .map(|(_, weight)| weight)
                .sum();
            let cost = FARNESS * cost + covered;
            if best.is_none_or(|(least, _)| cost < least) {
                best = Some((cost, area));
            }
        }
        if let Some((cost, area)) = best {
            let optional = matches!(label.text, LabelText::Name(_));
            if !optional || cost <= MOST_COVERED {
                placed.push(Placed { label: index, area });
            }
        }
    }
    placed
}

/// Middles of the boxes a label may fill, each with its distance in pixels
/// from the best.
fn places(spot: &Spot, frame: &Frame, half: Vector) -> Vec<(f64, Vector)> {
    let mut places = Vec::new();
    match spot {
        Spot::Beyond { point, towards } => {
            let point = frame.to_screen(*point);
            let straight = Vector::new(towards.x, -towards.y);
            for away in [0.0, 10.0, 22.0, 36.0, 54.0, 76.0, 102.0] {
                for turn in [0.0, 0.4, -0.4, 0.8, -0.8, 1.3, -1.3, 2.0, -2.0] {
                    let (sine, cosine) = libm::sincos(turn);
                    let direction = Vector::new(
                        cosine * straight.x - sine * straight.y,
                        sine * straight.x + cosine * straight.y,
                    );
                    // As far as the box reaches back towards the point.
                    let reach = (half.x / direction.x.abs()).min(half.y / direction.y.abs());
                    let centre = point + (reach + 2.0 * GAP + away) * direction;
                    places.push((away + 12.0 * turn.abs(), centre));
                }
            }
        }
        Spot::Inside(extent) => {
            let corners = extent.corners().map(|corner| frame.to_screen(corner));
            let extent = Bounds::of(corners).within(frame.window);
            let (middle, size) = (extent.centre(), 0.5 * extent.size());
            let room = (size - half).sup(&Vector::zeros());
            for row in [0.0, 0.25, -0.25, 0.5, -0.5, 0.75, -0.75] {
                for column in [0.0, 0.35, -0.35, 0.7, -0.7] {
                    let step = Vector::new(column * room.x, row * room.y);
                    places.push((0.3 * step.norm(), middle + step));
                }
            }
            let beside = size + half + Vector::new(GAP, GAP);
            for step in [
                Vector::new(beside.x, 0.0),
                Vector::new(0.0, beside.y),
                Vector::new(0.0, -beside.y),
                Vector::new(-beside.x, 0.0),
            ] {
                places.push((40.0, middle + step));
            }
        }
    }
    places
}

/// Points on the screen that stand for what is drawn, with what covering each
/// costs.
fn ink(drawing: &Drawing, frame: &Frame) -> Vec<(Vector, f64)> {
    let mut ink = Vec::new();
    for mark in &drawing.marks {
        let mut weight = match mark.role {
            Role::Obstacle(_) | Role::TipTrace | Role::BaseHatch => 0.3,
            // A label on the robot is worse than one that is far from what it is of.
            Role::Base => 0.6,
            Role::Disk | Role::TouchedDisk(_) => 3.0,
            Role::Cable | Role::SlackCable | Role::Backbone | Role::Node | Role::Tip => 3.0,
            Role::Force(_) | Role::Friction(_) => 1.5,
            Role::Cone { .. } => 0.3,
            Role::Contact { .. } => 6.0,
        };
        let mut points = match &mark.geometry {
            Geometry::HalfPlane { point, normal } => {
                let shown = clip_half_plane(*point, *normal, &frame.shown().corners());
                let Some(surface) = shown.surface else {
                    continue;
                };
                // The strokes behind the surface count as well.
                weight = 1.0;
                let behind = -8.0 / frame.scale * normal;
                vec![
                    surface[0],
                    surface[1],
                    surface[1] + behind,
                    surface[0] + behind,
                ]
            }
            geometry => geometry.points(1.0 / frame.scale, &drawing.bounds),
        };
        if let Geometry::Path(path) = &mark.geometry
            && path.closed
        {
            points.push(path.start);
        }
        let points: Vec<Vector> = points.into_iter().map(|p| frame.to_screen(p)).collect();
        ink.extend(points.iter().map(|point| (*point, weight)));
        for pair in points.windows(2) {
            let along = pair[1] - pair[0];
            // Far outside the window lines may be of any length.
            let count = (along.norm() / SAMPLE).ceil().min(2000.0);
            for i in 1..count as usize {
                ink.push((pair[0] + i as f64 / count * along, weight));
            }
        }
    }
    ink
}
