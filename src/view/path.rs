//! Paths of straight lines and circular arcs, and the outlines of obstacles as
//! such paths: exact, and flattened only where a renderer has no arcs.

use crate::geometry::{Core, Obstacle, Vector, perpendicular};
use std::f64::consts::{PI, TAU};

/// The least turn between points of an arc, rad, however fine it is asked for: at
/// most some six thousand a circle.
const LEAST_TURN: f64 = 1e-3;
/// Ends this near, in metres, are one: the rounding of coordinates of some
/// kilometres, and far below anything drawn.
const CLOSED: f64 = 1e-12;

/// A part of a path, from where the part before ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Piece {
    /// A straight line.
    Line {
        /// Its end.
        to: Vector,
    },
    /// A circular arc.
    Arc {
        /// The circle's centre.
        centre: Vector,
        /// Its end.
        to: Vector,
        /// The angle it turns by, counterclockwise, in radians; at most π
        /// either way.
        sweep: f64,
    },
}

/// A connected line in the world, in metres.
#[derive(Clone, Debug, PartialEq)]
pub struct Path {
    /// Where it starts.
    pub start: Vector,
    /// Its parts, in order.
    pub pieces: Vec<Piece>,
    /// Whether it encloses an area.
    pub closed: bool,
}

impl Path {
    /// The open path through points. `None` where there are none.
    pub fn through(points: impl IntoIterator<Item = Vector>) -> Option<Self> {
        let mut points = points.into_iter();
        Some(Self {
            start: points.next()?,
            pieces: points.map(|to| Piece::Line { to }).collect(),
            closed: false,
        })
    }

    /// The line between two points.
    pub fn line(from: Vector, to: Vector) -> Self {
        Self {
            start: from,
            pieces: vec![Piece::Line { to }],
            closed: false,
        }
    }

    /// The path as points, no arc farther than `tolerance` (in metres, over
    /// zero) from its chords. A closed path does not repeat its start.
    pub fn flattened(&self, tolerance: f64) -> Vec<Vector> {
        let mut points = vec![self.start];
        for piece in &self.pieces {
            match *piece {
                Piece::Line { to } => points.push(to),
                Piece::Arc { centre, to, sweep } => {
                    let from = points[points.len() - 1] - centre;
                    let radius = from.norm();
                    // A chord that turns by α is r (1 − cos α/2) from its arc.
                    let most = 2.0 * libm::acos((1.0 - tolerance / radius).clamp(0.0, 1.0));
                    let count = (sweep.abs() / most.max(LEAST_TURN)).ceil().max(1.0);
                    for i in 1..count as usize {
                        let (sine, cosine) = libm::sincos(sweep * i as f64 / count);
                        points.push(centre + cosine * from + sine * perpendicular(from));
                    }
                    points.push(to);
                }
            }
        }
        if self.closed && points.len() > 1 {
            let last = points[points.len() - 1];
            if (last - self.start).norm() < CLOSED {
                points.pop();
            }
        }
        points
    }
}

/// The outline of an obstacle.
#[derive(Clone, Debug, PartialEq)]
pub enum Outline {
    /// A closed path, counterclockwise.
    Closed(Path),
    /// Everything behind a line without end.
    HalfPlane {
        /// A point of the line.
        point: Vector,
        /// The unit normal, towards the free side.
        normal: Vector,
    },
}

/// The exact outline of an obstacle.
pub fn outline(obstacle: &Obstacle) -> Outline {
    let (place, radius) = (obstacle.position(), obstacle.radius());
    let (sine, cosine) = libm::sincos(obstacle.angle());
    match obstacle.core() {
        Core::HalfPlane => {
            let normal = Vector::new(cosine, sine);
            Outline::HalfPlane {
                point: place + radius * normal,
                normal,
            }
        }
        Core::Point => Outline::Closed(circle(place, radius)),
        Core::Vertices(local) => {
            let turned = |v: &Vector| {
                place + v.x * Vector::new(cosine, sine) + v.y * Vector::new(-sine, cosine)
            };
            let vertices: Vec<Vector> = local.iter().map(turned).collect();
            Outline::Closed(grown(&vertices, radius))
        }
    }
}

/// A circle as two half turns.
pub fn circle(centre: Vector, radius: f64) -> Path {
    let half = Vector::new(radius, 0.0);
    let arc = |to| Piece::Arc {
        centre,
        to,
        sweep: PI,
    };
    Path {
        start: centre + half,
        pieces: vec![arc(centre - half), arc(centre + half)],
        closed: true,
    }
}

/// A convex polygon, counterclockwise, grown by a radius; two vertices make a
/// capsule.
fn grown(vertices: &[Vector], radius: f64) -> Path {
    let count = vertices.len();
    let normal = |i: usize| -> Vector {
        -perpendicular(vertices[(i + 1) % count] - vertices[i]).normalize()
    };
    let mut pieces = Vec::new();
    for i in 0..count {
        let next = (i + 1) % count;
        let (before, after) = (normal(i), normal(next));
        pieces.push(Piece::Line {
            to: vertices[next] + radius * before,
        });
        if radius > 0.0 {
            let turn = libm::atan2(after.y, after.x) - libm::atan2(before.y, before.x);
            pieces.push(Piece::Arc {
                centre: vertices[next],
                to: vertices[next] + radius * after,
                sweep: turn.rem_euclid(TAU),
            });
        }
    }
    Path {
        start: vertices[0] + radius * normal(0),
        pieces,
        closed: true,
    }
}

/// What a window shows of a half-plane.
#[derive(Clone, Debug, PartialEq)]
pub struct Clipped {
    /// The solid area inside the window, counterclockwise, in metres; empty where the
    /// window shows nothing of it.
    pub area: Vec<Vector>,
    /// The surface inside the window, in metres.
    pub surface: Option<[Vector; 2]>,
}

/// What a convex window, given by its corners in order, shows of the
/// half-plane behind the line through a point across a unit normal, which points
/// to its free side.
pub fn clip_half_plane(point: Vector, normal: Vector, window: &[Vector]) -> Clipped {
    let height = |corner: Vector| normal.dot(&(corner - point));
    let mut area = Vec::new();
    let mut cuts = Vec::new();
    for (i, &a) in window.iter().enumerate() {
        let b = window[(i + 1) % window.len()];
        let (from, to) = (height(a), height(b));
        if from <= 0.0 {
            area.push(a);
        }
        if (from <= 0.0) != (to <= 0.0) {
            let cut = a + from / (from - to) * (b - a);
            area.push(cut);
            cuts.push(cut);
        }
    }
    Clipped {
        area,
        surface: match cuts[..] {
            [a, b] => Some([a, b]),
            _ => None,
        },
    }
}

/// The short strokes by which a surface is drawn as solid: `spacing` apart
/// along it, slanting into the unit direction `into`, `depth` deep.
pub fn hatching([a, b]: [Vector; 2], into: Vector, spacing: f64, depth: f64) -> Vec<[Vector; 2]> {
    let along = b - a;
    let length = along.norm();
    if !(length > 0.0 && spacing > 0.0) {
        return Vec::new();
    }
    let direction = along / length;
    let count = (length / spacing).floor();
    let first = 0.5 * (length - count * spacing);
    (0..=count as usize)
        .map(|i| {
            let foot = a + (first + i as f64 * spacing) * direction;
            [foot, foot + depth * (into - direction)]
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The flattened outline reaches as far as the obstacle in every
    /// direction, short of it by no more than the tolerance.
    #[test]
    fn outlines_reach_as_far_as_their_obstacles() {
        let at = Vector::new(0.03, 0.08);
        let triangle = [
            Vector::new(0.0, 0.0),
            Vector::new(0.03, 0.0),
            Vector::new(0.0, 0.02),
        ];
        let cores = [
            Core::Point,
            Core::segment(0.05),
            Core::rectangle(0.04, 0.02),
            Core::polygon(&triangle).unwrap(),
        ];
        for core in cores {
            for radius in [0.0, 0.006] {
                if core == Core::Point && radius == 0.0 {
                    continue;
                }
                let obstacle = Obstacle::new(core.clone(), radius, at, 0.7);
                let Outline::Closed(path) = outline(&obstacle) else {
                    panic!("not closed");
                };
                let points = path.flattened(1e-5);
                for i in 0..100 {
                    let (sine, cosine) = libm::sincos(f64::from(i) * TAU / 100.0);
                    let direction = Vector::new(cosine, sine);
                    let reach = points.iter().map(|p| direction.dot(p));
                    let short = obstacle.support(direction).unwrap()
                        - reach.fold(f64::NEG_INFINITY, f64::max);
                    assert!((-1e-15..=1e-5).contains(&short), "{obstacle:?} {short}");
                }
            }
        }
    }

    #[test]
    fn flattening_keeps_its_tolerance() {
        let points = circle(Vector::zeros(), 0.05).flattened(1e-4);
        for (i, a) in points.iter().enumerate() {
            let middle = 0.5 * (a + points[(i + 1) % points.len()]);
            let sag = 0.05 - middle.norm();
            assert!((0.0..=1e-4).contains(&sag), "{sag}");
        }
        assert!(points.len() < 60);
    }

    #[test]
    fn a_half_plane_is_cut_at_the_window() {
        let window = [[0.0, 0.0], [2.0, 0.0], [2.0, 1.0], [0.0, 1.0]].map(Vector::from);
        let shown = clip_half_plane(Vector::new(0.5, 7.0), Vector::x(), &window);
        assert_eq!(shown.area.len(), 4);
        let [a, b] = shown.surface.unwrap();
        assert_eq!((a.x, b.x, (a - b).norm()), (0.5, 0.5, 1.0));
        let none = clip_half_plane(Vector::new(-1.0, 0.0), Vector::x(), &window);
        assert_eq!((none.area.len(), none.surface), (0, None));
        let all = clip_half_plane(Vector::new(3.0, 0.0), Vector::x(), &window);
        assert_eq!((all.area.len(), all.surface), (4, None));
    }
}
