//! Triangles with normals and materials, and the surfaces they are made of.
//! Knows no robot.
//!
//! Everything lies along the plane of the robot, so that tubes and solids of
//! revolution need no frames that turn: one direction in the plane, the other
//! is z.

use super::outline::Corner;
use bytemuck::{Pod, Zeroable};
use nalgebra::Vector3;
use std::f32::consts::{FRAC_PI_2, TAU};

/// A point or direction in space, in metres from the mesh's origin.
pub type Point = nalgebra::Vector3<f32>;
/// A point or direction in the plane.
pub type Flat = nalgebra::Vector2<f32>;

/// A corner of a triangle.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
pub struct Vertex {
    /// In metres, from the mesh's origin.
    pub position: [f32; 3],
    /// The outward unit normal; of a glow, where in its square the corner is,
    /// in metres.
    pub normal: [f32; 3],
    /// Red, green, blue in sRGB and opacity.
    pub colour: [u8; 4],
    /// Emission, gloss, metal and how open to the sky it is; 0 to 255.
    pub finish: [u8; 4],
}

/// What a surface looks like.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Material {
    /// Red, green, blue in sRGB.
    pub colour: [u8; 3],
    /// How much light of its own it gives, 0 to 255.
    pub emission: u8,
    /// How sharp and strong its reflections are, 0 to 255.
    pub gloss: u8,
    /// How much its reflections take its colour, 0 to 255.
    pub metal: u8,
}

/// Triangles, counterclockwise as seen from outside.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Triangles {
    /// The corners.
    pub vertices: Vec<Vertex>,
    /// Three indices of corners a triangle.
    pub indices: Vec<u32>,
}

/// A point of the profile of a solid of revolution.
#[derive(Clone, Copy, Debug)]
pub struct Turned {
    /// Along the axis.
    pub along: f32,
    /// From the axis.
    pub radius: f32,
    /// The normal's angle from the radial direction towards the axis'.
    pub slope: f32,
}

impl Triangles {
    /// Adds a corner and gives its index.
    pub fn vertex(
        &mut self,
        position: Point,
        normal: Point,
        material: &Material,
        open: f32,
    ) -> u32 {
        let [red, green, blue] = material.colour;
        let open = (255.0 * open) as u8;
        self.vertices.push(Vertex {
            position: position.into(),
            normal: normal.into(),
            colour: [red, green, blue, 255],
            finish: [material.emission, material.gloss, material.metal, open],
        });
        self.vertices.len() as u32 - 1
    }

    /// Adds two triangles between four corners in order.
    pub fn quad(&mut self, a: u32, b: u32, c: u32, d: u32) {
        self.indices.extend([a, b, c, a, c, d]);
    }

    /// Connects two rings of `sides` corners that start at these indices; seen
    /// against the way from the first to the second they run
    /// counterclockwise.
    fn connect(&mut self, first: u32, second: u32, sides: u32) {
        for i in 0..sides {
            let next = (i + 1) % sides;
            self.quad(first + i, first + next, second + next, second + i);
        }
    }

    /// Adds a tube along a line in the plane with round ends. `path`: at least
    /// two points, each with the unit direction of the line there.
    pub fn tube(&mut self, path: &[(Flat, Flat)], radius: f32, sides: u32, material: &Material) {
        const CAP: i32 = 4;
        let (Some(first), Some(last)) = (path.first(), path.last()) else {
            return;
        };
        let circle = circle(sides);
        let start = self.vertices.len() as u32;
        let mut rings = 0;
        let mut ring = |centre: Flat, direction: Flat, tilt: f32| {
            let (sine, cosine) = tilt.sin_cos();
            let centre = lifted(centre + radius * sine * direction);
            let aside = Point::new(-direction.y, direction.x, 0.0);
            let forward = lifted(direction);
            for (x, z) in &circle {
                let out = *x * aside + *z * Point::z();
                let normal = cosine * out + sine * forward;
                self.vertex(centre + radius * cosine * out, normal, material, 1.0);
            }
            rings += 1;
        };
        let tilt = |i: i32| FRAC_PI_2 * i as f32 / CAP as f32;
        for i in -CAP..0 {
            ring(first.0, first.1, tilt(i));
        }
        for (point, direction) in path {
            ring(*point, *direction, 0.0);
        }
        for i in 1..=CAP {
            ring(last.0, last.1, tilt(i));
        }
        for i in 1..rings {
            self.connect(start + (i - 1) * sides, start + i * sides, sides);
        }
    }

    /// Adds a solid of revolution about an axis in the plane, from its profile
    /// along the unit direction `axis`.
    pub fn turned(
        &mut self,
        origin: Point,
        axis: Flat,
        profile: &[Turned],
        sides: u32,
        material: &Material,
    ) {
        let circle = circle(sides);
        let start = self.vertices.len() as u32;
        let aside = Point::new(-axis.y, axis.x, 0.0);
        let forward = lifted(axis);
        for point in profile {
            let (sine, cosine) = point.slope.sin_cos();
            for (x, z) in &circle {
                let out = *x * aside + *z * Point::z();
                let at = origin + point.along * forward + point.radius * out;
                self.vertex(at, cosine * out + sine * forward, material, 1.0);
            }
        }
        for i in 1..profile.len() as u32 {
            self.connect(start + (i - 1) * sides, start + i * sides, sides);
        }
    }

    /// Adds a ball.
    pub fn ball(&mut self, centre: Point, radius: f32, material: &Material) {
        const RINGS: i32 = 6;
        let profile: Vec<_> = (-RINGS..=RINGS)
            .map(|i| {
                let slope = FRAC_PI_2 * i as f32 / RINGS as f32;
                Turned {
                    along: radius * slope.sin(),
                    radius: radius * slope.cos(),
                    slope,
                }
            })
            .collect();
        self.turned(centre, Flat::x(), &profile, 20, material);
    }

    /// Adds a convex outline drawn out along z from `back` to `front`, with a
    /// bevelled front.
    pub fn prism(
        &mut self,
        outline: &[Corner],
        [back, front]: [f32; 2],
        bevel: f32,
        material: &Material,
    ) {
        /// How open the foot is to the sky, where it meets the board.
        const FOOT: f32 = 0.35;
        let neck = front - bevel;
        let foot = back + 0.35 * (neck - back);
        let count = outline.len() as u32;
        let start = self.vertices.len() as u32;
        // Rings: the foot, where it is open, the neck, the edge, the face.
        #[expect(clippy::type_complexity, reason = "three rings of one outline")]
        let rings: [(&dyn Fn(&Corner) -> Point, f32); 3] = [
            (&|c| c.position.push(back), FOOT),
            (&|c| c.position.push(foot), 0.9),
            (&|c| c.position.push(neck), 1.0),
        ];
        for (place, open) in rings {
            for corner in outline {
                self.vertex(place(corner), corner.normal.push(0.0), material, open);
            }
        }
        for corner in outline {
            self.vertex(corner.inset.push(front), Point::z(), material, 1.0);
        }
        for ring in 0..3 {
            let (below, above) = (start + ring * count, start + (ring + 1) * count);
            for i in 0..count {
                let next = (i + 1) % count;
                let (a, b) = (&outline[i as usize], &outline[next as usize]);
                if a.position != b.position {
                    self.quad(below + i, below + next, above + next, above + i);
                }
            }
        }
        let behind = self.vertices.len() as u32;
        for corner in outline {
            self.vertex(corner.position.push(back), -Point::z(), material, 1.0);
        }
        let face = start + 3 * count;
        for i in 2..count {
            self.indices.extend([face, face + i - 1, face + i]);
            self.indices.extend([behind, behind + i, behind + i - 1]);
        }
    }
}

/// A point of the plane, in space.
pub fn lifted(flat: Flat) -> Point {
    flat.push(0.0)
}

/// Cosines and sines of equal angles around.
pub fn circle(sides: u32) -> Vec<(f32, f32)> {
    (0..sides)
        .map(|i| {
            let (sine, cosine) = (TAU * i as f32 / sides as f32).sin_cos();
            (cosine, sine)
        })
        .collect()
}

/// A box in space along the axes, in metres.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounds3 {
    /// The corner of least coordinates.
    pub least: Vector3<f64>,
    /// The corner of greatest coordinates.
    pub most: Vector3<f64>,
}

impl Bounds3 {
    /// The extents along the axes.
    pub fn size(&self) -> Vector3<f64> {
        self.most - self.least
    }

    /// The middle.
    pub fn centre(&self) -> Vector3<f64> {
        0.5 * (self.least + self.most)
    }

    /// Whether it holds nothing, or is no box of numbers.
    pub fn is_empty(&self) -> bool {
        let size = self.size();
        !(size
            .iter()
            .all(|extent| *extent >= 0.0 && extent.is_finite()))
    }

    /// The eight corners.
    pub fn corners(&self) -> [Vector3<f64>; 8] {
        std::array::from_fn(|i| {
            let pick = |axis: usize| {
                let from = if i >> axis & 1 == 0 {
                    self.least
                } else {
                    self.most
                };
                from[axis]
            };
            Vector3::new(pick(0), pick(1), pick(2))
        })
    }
}

/// What a picture in space shows, ready to be sent.
#[derive(Clone, Debug, PartialEq)]
pub struct Mesh {
    /// What the vertices are relative to, in metres.
    pub origin: Vector3<f64>,
    /// The z of the board behind everything, in metres.
    pub board: f64,
    /// The backbone's length, in metres.
    pub length: f64,
    /// What a camera should look at.
    pub focus: Bounds3,
    /// What stands in space and casts shadows.
    pub solids: Triangles,
    /// What is seen through everything: arrows and marks of contacts.
    pub overlay: Triangles,
    /// Soft discs that face the viewer: six corners each.
    pub glows: Vec<Vertex>,
}

impl Mesh {
    /// Adds a glow about a point.
    pub fn add_glow(
        glows: &mut Vec<Vertex>,
        at: Point,
        radius: f32,
        [red, green, blue]: [u8; 3],
        strength: f32,
    ) {
        for (x, y) in [(-1, -1), (1, -1), (1, 1), (-1, -1), (1, 1), (-1, 1)] {
            glows.push(Vertex {
                position: at.into(),
                normal: [x as f32 * radius, y as f32 * radius, radius],
                colour: [red, green, blue, (255.0 * strength) as u8],
                finish: [0; 4],
            });
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::{Core, Obstacle, Vector};
    use crate::render::outline;
    use crate::view::Bounds;
    use std::f32::consts::PI;

    pub const GREY: Material = Material {
        colour: [128; 3],
        emission: 0,
        gloss: 0,
        metal: 0,
    };

    impl Triangles {
        fn corners(&self) -> impl Iterator<Item = [(Point, Point); 3]> + '_ {
            let at = |i: u32| {
                let v = &self.vertices[i as usize];
                (Point::from(v.position), Point::from(v.normal))
            };
            let triples = self.indices.chunks_exact(3);
            triples.map(move |t| [at(t[0]), at(t[1]), at(t[2])])
        }

        /// Everything is finite, normals are unit vectors, and triangles face
        /// the way their normals point.
        pub fn check(&self) {
            assert!(!self.indices.is_empty() && self.indices.len().is_multiple_of(3));
            for [(a, n), (b, m), (c, o)] in self.corners() {
                for normal in [n, m, o] {
                    assert!((normal.norm() - 1.0).abs() < 1e-5, "{normal}");
                }
                let area = (b - a).cross(&(c - a));
                assert!(area.iter().all(|x| x.is_finite()));
                let size = (b - a).norm().max((c - a).norm());
                if area.norm() > 1e-4 * size * size {
                    let facing = area.normalize().dot(&(n + m + o));
                    assert!(facing > 0.5, "{a} {b} {c} face {facing}");
                }
            }
        }

        /// The volume inside, where the triangles enclose one.
        pub fn volume(&self) -> f32 {
            let parts = self.corners().map(|[a, b, c]| a.0.dot(&b.0.cross(&c.0)));
            parts.sum::<f32>() / 6.0
        }

        /// How often a line along the unit direction passes a surface.
        pub fn crossings(&self, from: Point, direction: Point) -> usize {
            let crossed = |[a, b, c]: [(Point, Point); 3]| {
                let side = |p: Point, q: Point| direction.dot(&(p - from).cross(&(q - from)));
                let sides = [side(a.0, b.0), side(b.0, c.0), side(c.0, a.0)];
                sides.iter().all(|s| *s > 0.0) || sides.iter().all(|s| *s < 0.0)
            };
            self.corners().filter(|corners| crossed(*corners)).count()
        }
    }

    #[test]
    fn tubes_are_closed() {
        let path: Vec<(Flat, Flat)> = (0..=40)
            .map(|i| {
                let (sine, cosine) = (0.03 * i as f32).sin_cos();
                (Flat::new(cosine, sine), Flat::new(-sine, cosine))
            })
            .collect();
        let mut tube = Triangles::default();
        tube.tube(&path, 0.05, 24, &GREY);
        tube.check();
        let volume = PI * 0.05f32.powi(2) * (1.2 + 4.0 / 3.0 * 0.05);
        assert!(
            (tube.volume() / volume - 1.0).abs() < 0.02,
            "{}",
            tube.volume()
        );
        // Every edge belongs to two triangles, except at the poles.
        let mut edges: Vec<[u32; 2]> = Vec::new();
        for t in tube.indices.chunks_exact(3) {
            for [a, b] in [[t[0], t[1]], [t[1], t[2]], [t[2], t[0]]] {
                let at = |i: u32| Point::from(tube.vertices[i as usize].position);
                if (at(a) - at(b)).norm() > 1e-6 {
                    edges.push([a.min(b), a.max(b)]);
                }
            }
        }
        edges.sort_unstable();
        assert!(edges.chunk_by(|a, b| a == b).all(|same| same.len() == 2));
    }

    #[test]
    fn prisms_are_as_large_as_their_outlines() {
        let check = |core: Core, radius: f64, area: f32| {
            let obstacle = Obstacle::new(core, radius, Vector::new(0.3, 0.2), 0.4);
            let origin = Vector::new(0.3, 0.2);
            let area_shown = Bounds::of([origin]).grown(1.0);
            let (corners, bevel) =
                outline::corners(&obstacle, &area_shown, origin, 1e-4, 0.1).unwrap();
            let mut prism = Triangles::default();
            prism.prism(&corners, [-0.2, 0.3], bevel as f32, &GREY);
            prism.check();
            let volume = 0.5 * area;
            assert!(
                (prism.volume() / volume - 1.0).abs() < 0.01,
                "{}",
                prism.volume()
            );
        };
        check(Core::Point, 0.1, PI * 0.01);
        check(Core::rectangle(0.2, 0.1), 0.0, 0.02);
        check(Core::rectangle(0.2, 0.1), 0.01, 0.02 + 0.006 + PI * 1e-4);
        check(Core::segment(0.2), 0.05, 0.02 + PI * 0.0025);
        // The slab of a wall, on a slant.
        check(Core::HalfPlane, 0.0, 0.1 * 2.0 / 0.4f32.cos());
    }

    #[test]
    fn balls_are_round() {
        let mut ball = Triangles::default();
        ball.ball(Point::new(0.1, 0.0, 0.2), 0.3, &GREY);
        ball.check();
        let volume = 4.0 / 3.0 * PI * 0.027;
        assert!((ball.volume() / volume - 1.0).abs() < 0.05);
    }
}
