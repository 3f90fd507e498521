//! A disk of the robot: a round plate with a hole for the backbone and one for
//! the cable, or a notch where the cable runs at the rim.

use super::mesh::{Flat, Material, Point, Triangles};
use std::f32::consts::{PI, TAU};

/// Half the angle of the sector that holds the cable's hole: its sides pass
/// the hole, and its middle sees all of it, for holes of at most 0.45 of the
/// cable's distance.
const SECTOR: f32 = 0.75;
/// Width of the rim's bevel, over the thickness.
const BEVEL: f32 = 0.22;

/// A plate's sizes, in metres.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plate {
    /// Radius of the rim.
    pub rim: f32,
    /// Thickness.
    pub thickness: f32,
    /// Radius of the hole for the backbone, at the centre.
    pub middle_hole: f32,
    /// Distance of the cable's hole from the centre.
    pub offset: f32,
    /// Radius of the cable's hole, at most 0.4 of its distance.
    pub cable_hole: f32,
}

/// A plate's surface in its own frame: x towards the cable, y along the
/// backbone, z across. Positions and normals, and triangles.
#[derive(Clone, Debug, Default)]
pub struct Template {
    corners: Vec<(Point, Point)>,
    indices: Vec<u32>,
}

impl Template {
    /// The plate with arcs of at least `slices` chords a turn.
    pub fn new(plate: &Plate, slices: u32) -> Self {
        let mut template = Self::default();
        let half = 0.5 * plate.thickness;
        let bevel = (BEVEL * plate.thickness).min(0.1 * plate.rim);
        let face = plate.rim - bevel;
        let strips = [plate.ring(face, slices), plate.sector(face, slices)];
        for strip in &strips {
            template.face(strip, half, 1.0);
            template.face(strip, half, -1.0);
        }
        let inward = |(radius, angle): (f32, f32)| {
            let out = at(1.0, angle);
            (radius * out, -out)
        };
        let middle: Vec<_> = arc(0.0, TAU, slices)
            .map(|angle| inward((plate.middle_hole, -angle)))
            .collect();
        template.wall(&middle, half);
        let centre = Flat::new(plate.offset, 0.0);
        // The hole's edge, or what of it is inside the rim.
        let reach = |angle: f32| centre + plate.cable_hole * at(1.0, angle);
        let opening = plate.opening(plate.rim);
        let hole: Vec<_> = match opening {
            None => arc(0.0, TAU, slices / 2).collect(),
            Some(angle) => {
                let edge = at(plate.rim, angle) - centre;
                let from = edge.y.atan2(edge.x);
                arc(from, TAU - from, slices / 2).collect()
            }
        };
        let hole: Vec<_> = hole
            .into_iter()
            .rev()
            .map(|angle| (reach(angle), -at(1.0, angle)))
            .collect();
        template.wall(&hole, half);
        let opening = opening.unwrap_or(0.0);
        template.rim(plate.rim, bevel, half, opening, slices);
        template
    }

    /// Adds the plate to a mesh: its middle, the unit direction towards the
    /// cable, and what it is made of.
    pub fn add(&self, mesh: &mut Triangles, middle: Flat, cable: Flat, material: &Material) {
        let first = mesh.vertices.len() as u32;
        let placed = |v: &Point| {
            Point::new(
                v.x * cable.x - v.y * cable.y,
                v.x * cable.y + v.y * cable.x,
                v.z,
            )
        };
        mesh.vertices.reserve(self.corners.len());
        for (position, normal) in &self.corners {
            let position = placed(position) + middle.push(0.0);
            mesh.vertex(position, placed(normal), material, 1.0);
        }
        mesh.indices.extend(self.indices.iter().map(|i| first + i));
    }

    /// A face, at y = ± `half`, from pairs of points: quads between
    /// neighbouring pairs, counterclockwise from the first of a pair over its
    /// second to the next second, seen from +z over x.
    fn face(&mut self, strip: &[(Flat, Flat)], half: f32, side: f32) {
        let first = self.corners.len() as u32;
        let normal = side * Point::y();
        for (a, b) in strip {
            for point in [a, b] {
                let position = Point::new(point.x, side * half, point.y);
                self.corners.push((position, normal));
            }
        }
        for i in 1..strip.len() as u32 {
            let (a, b) = (first + 2 * i - 2, first + 2 * i - 1);
            let (c, d) = (b + 2, b + 1);
            if side < 0.0 {
                self.indices.extend([a, b, c, a, c, d]);
            } else {
                self.indices.extend([a, c, b, a, d, c]);
            }
        }
    }

    /// A wall along y, through points with their normals that run
    /// counterclockwise about the solid.
    fn wall(&mut self, line: &[(Flat, Flat)], half: f32) {
        self.strips(line.iter().map(|(point, normal)| {
            let corner = |y: f32| (Point::new(point.x, y, point.y), in_plane(*normal));
            vec![corner(half), corner(-half)]
        }));
    }

    /// The rim: bevel, wall, bevel, from the angle `opening` round to it.
    fn rim(&mut self, radius: f32, bevel: f32, half: f32, opening: f32, slices: u32) {
        let lines = arc(opening, TAU - opening, slices).map(|angle| {
            let out = at(1.0, angle);
            let corner = |inset: f32, y: f32, up: f32| {
                let place = (radius - inset) * out;
                let normal = in_plane((1.0 - up.abs()) * out) + up * Point::y();
                (Point::new(place.x, y, place.y), normal.normalize())
            };
            vec![
                corner(bevel, half, 0.5),
                corner(0.0, half - bevel, 0.0),
                corner(0.0, bevel - half, 0.0),
                corner(bevel, -half, -0.5),
            ]
        });
        self.strips(lines);
    }

    /// Quads between neighbouring lines of corners, each from the upper face
    /// to the lower.
    fn strips(&mut self, lines: impl Iterator<Item = Vec<(Point, Point)>>) {
        let first = self.corners.len() as u32;
        let mut width = 0;
        for line in lines {
            width = line.len() as u32;
            self.corners.extend(line);
        }
        let count = (self.corners.len() as u32 - first) / width.max(1);
        for i in 1..count {
            for j in 1..width {
                let a = first + (i - 1) * width + j - 1;
                let (b, c, d) = (a + width, a + width + 1, a + 1);
                self.indices.extend([a, b, c, a, c, d]);
            }
        }
    }
}

impl Plate {
    /// Half the angle over which the cable's hole opens a circle about the
    /// middle; `None` where it lies inside.
    fn opening(&self, radius: f32) -> Option<f32> {
        let (a, h) = (self.offset, self.cable_hole);
        // What is left outside would be thinner than anything real.
        if a + h < 0.98 * self.rim {
            return None;
        }
        let cosine = (radius * radius + a * a - h * h) / (2.0 * radius * a);
        Some(cosine.clamp(-1.0, 1.0).acos())
    }

    /// The face without the sector around the cable.
    fn ring(&self, face: f32, slices: u32) -> Vec<(Flat, Flat)> {
        arc(SECTOR, TAU - SECTOR, slices)
            .map(|angle| (at(self.middle_hole, angle), at(face, angle)))
            .collect()
    }

    /// The sector around the cable: from the hole's edge to the sector's, in
    /// every direction from the hole's middle.
    fn sector(&self, face: f32, slices: u32) -> Vec<(Flat, Flat)> {
        const SIDE: u32 = 4;
        let inner = self.middle_hole;
        let rim = self.seen_rim(face, slices);
        let mut border: Vec<Flat> = Vec::new();
        border.extend(rim.iter().map(|angle| at(face, *angle)));
        let side = |i: u32| face + (inner - face) * i as f32 / SIDE as f32;
        border.extend((1..SIDE).map(|i| at(side(i), SECTOR)));
        border.extend(arc(SECTOR, -SECTOR, slices / 2).map(|angle| at(inner, angle)));
        border.extend((1..SIDE).rev().map(|i| at(side(i), -SECTOR)));
        border.extend(rim.iter().rev().map(|angle| at(face, -*angle)));
        let centre = Flat::new(self.offset, 0.0);
        border
            .into_iter()
            .map(|point| {
                let direction = (point - centre).normalize();
                // Where the hole's edge is outside the face, the face begins
                // where the line enters it.
                let middle = -centre.dot(&direction);
                let chord = face * face - centre.norm_squared() + middle * middle;
                let entry = middle - chord.max(0.0).sqrt();
                let from = self.cable_hole.max(entry).min((point - centre).norm());
                (centre + from * direction, point)
            })
            .collect()
    }

    /// The angles of the rim, up to the sector's side, that can be seen from
    /// the middle of the cable's hole through the face.
    fn seen_rim(&self, face: f32, slices: u32) -> Vec<f32> {
        let Some(open) = self.opening(face) else {
            return arc(0.0, SECTOR, slices).collect();
        };
        if self.offset <= face {
            return arc(open, SECTOR, slices).collect();
        }
        // From outside the rim the near side is where lines enter: what is
        // seen begins where one touches it.
        let touching = (face / self.offset).acos();
        // The line over the notch's corner leaves the face as far behind its
        // foot from the middle as it enters before it.
        let centre = Flat::new(self.offset, 0.0);
        let along = (at(face, open) - centre).normalize();
        let foot = centre - centre.dot(&along) * along;
        let corner = (2.0 * foot.y.atan2(foot.x) - open).min(SECTOR);
        let mut angles: Vec<f32> = arc(touching, corner, 8 * slices).collect();
        angles.extend(arc(corner, SECTOR, slices).skip(1));
        angles
    }
}

/// The point at an angle from +x towards +z.
fn at(radius: f32, angle: f32) -> Flat {
    let (sine, cosine) = angle.sin_cos();
    Flat::new(radius * cosine, radius * sine)
}

/// A direction across the backbone, in the plate's frame.
fn in_plane(flat: Flat) -> Point {
    Point::new(flat.x, 0.0, flat.y)
}

/// Angles from one to another, no farther apart than a share of a turn.
fn arc(from: f32, to: f32, slices: u32) -> impl DoubleEndedIterator<Item = f32> {
    let steps = (slices as f32 * (to - from).abs() / (2.0 * PI))
        .ceil()
        .max(1.0);
    (0..=steps as i32).map(move |i| from + (to - from) * i as f32 / steps)
}

#[cfg(test)]
mod tests {
    use super::*;

    const GREY: Material = Material {
        colour: [128; 3],
        emission: 0,
        gloss: 0,
        metal: 0,
    };

    const HOLED: Plate = Plate {
        rim: 1.0,
        thickness: 0.2,
        middle_hole: 0.15,
        offset: 0.7,
        cable_hole: 0.1,
    };

    /// The cable at the rim, as where a scene gives none.
    const NOTCHED: Plate = Plate {
        offset: 1.0,
        ..HOLED
    };

    fn solid(plate: &Plate) -> Triangles {
        let mut mesh = Triangles::default();
        Template::new(plate, 96).add(&mut mesh, Flat::new(3.0, 2.0), Flat::new(0.6, 0.8), &GREY);
        mesh
    }

    /// How often a line along the backbone crosses the plate, at a place in
    /// the plate's own x (towards the cable) and z.
    fn crossings(mesh: &Triangles, x: f32, z: f32) -> usize {
        let from = Point::new(3.0 + 0.6 * x, 2.0 + 0.8 * x, z);
        mesh.crossings(from, Point::new(-0.8, 0.6, 0.0))
    }

    #[test]
    fn plates_have_holes() {
        for plate in [HOLED, NOTCHED] {
            let mesh = solid(&plate);
            mesh.check();
            for i in 0..60 {
                let angle = 0.1 + i as f32 * 0.1047;
                let around = |x: f32, radius: f32| {
                    let point = at(radius, angle);
                    crossings(&mesh, x + point.x, point.y)
                };
                // Off the edges by more than what chords cut off.
                assert_eq!(around(0.0, 0.14), 0, "through the backbone's hole");
                assert_eq!(around(0.0, 0.16), 2, "beside the backbone's hole");
                assert_eq!(around(plate.offset, 0.09), 0, "through the cable's hole");
                assert_eq!(around(0.0, 1.01), 0, "beyond the rim");
                let beside = at(0.11, angle) + Flat::new(plate.offset, 0.0);
                let inside = beside.norm() < 0.9;
                if inside {
                    assert_eq!(around(plate.offset, 0.11), 2, "beside the cable's hole");
                }
                let far = at(0.93, angle);
                if (far - Flat::new(plate.offset, 0.0)).norm() > 0.11 {
                    assert_eq!(around(0.0, 0.93), 2, "inside the rim at {angle}");
                }
            }
        }
    }

    /// Closed all round: the volume is the disc's less the holes', within what
    /// the bevel takes.
    #[test]
    fn plates_have_the_volume_of_plates() {
        let volume = PI * (1.0 - 0.15f32.powi(2) - 0.1f32.powi(2)) * 0.2;
        let found = solid(&HOLED).volume();
        assert!(
            (0.97..1.0).contains(&(found / volume)),
            "{found} of {volume}"
        );
    }
}
