//! Obstacles packed into a texture for the field's shader, with lists of which
//! may be nearest in which part of the window. Draws nothing.
//!
//! Web browsers without WebGPU have no storage buffers, so the data is a
//! texture of four floats a texel, read by index:
//!
//! - one texel a cell of the window, row by row from the lower left: where the
//!   cell's list starts and how long it is;
//! - one texel an entry of a list: where its obstacle starts, its number of
//!   vertices, its radius, its kind;
//! - an obstacle: one texel, or two a vertex.
//!
//! A cell's list leaves out only what cannot be nearest anywhere in it: no
//! clearance changes faster than the point it is taken at moves.
//!
//! Everything is relative to the middle of the window and computed in double
//! precision, so that single precision is enough however far one zooms in.

use crate::geometry::{Core, Obstacle, Vector, perpendicular};
use crate::view::Bounds;

/// Texels in a row of the texture.
pub const WIDTH: usize = 1024;
/// Cells along each side of the window, a power of two.
const CELLS: usize = 32;
/// A list this short is not worth dividing.
const FEW: usize = 3;
/// A disc whose centre is farther than this many half-diagonals of the window
/// from its middle is packed by its curvature there.
const FAR: f64 = 4.0;

/// The kinds of obstacles that the shader knows.
#[derive(Clone, Copy)]
enum Kind {
    /// By its clearance, normal and curvature at the window's middle.
    Arc = 0,
    /// By its centre.
    Point = 1,
    /// By its vertices; two make a segment.
    Polygon = 2,
}

/// Obstacles as the shader reads them: texels, row by row, in whole rows of
/// [`WIDTH`].
pub fn packed(obstacles: &[Obstacle], window: &Bounds) -> Vec<[f32; 4]> {
    let mut cells = Cells {
        obstacles,
        window,
        entries: vec![[0.0; 4]; obstacles.len()],
        texels: vec![[0.0; 4]; CELLS * CELLS],
    };
    let everything: Vec<usize> = (0..obstacles.len()).collect();
    let near = cells.nearest(&everything, window);
    for index in &near {
        cells.pack(*index);
    }
    cells.divide(&near, [0, 0], CELLS);
    let rows = cells.texels.len().div_ceil(WIDTH);
    cells.texels.resize(rows * WIDTH, [0.0; 4]);
    cells.texels
}

struct Cells<'a> {
    obstacles: &'a [Obstacle],
    window: &'a Bounds,
    /// By obstacle; only of those that may be nearest somewhere.
    entries: Vec<[f32; 4]>,
    texels: Vec<[f32; 4]>,
}

impl Cells<'_> {
    /// Which of these obstacles may be nearest somewhere in an area.
    fn nearest(&self, among: &[usize], area: &Bounds) -> Vec<usize> {
        // A little more, for the shader's rounding.
        let slack = 2.001 * 0.5 * area.size().norm();
        let middle = area.centre();
        let clearance = |index: usize| self.obstacles[index].clearance(middle).distance;
        let place = |index: &usize| (self.obstacles[*index].position() - middle).norm_squared();
        let guess = among.iter().min_by(|a, b| place(a).total_cmp(&place(b)));
        // Whatever is certainly farther than the nearest so far needs no exact
        // clearance.
        let mut least = guess.map_or(f64::INFINITY, |index| clearance(*index));
        let mut found = Vec::new();
        for index in among {
            if !self.obstacles[*index].is_beyond(middle, least + slack) {
                let clearance = clearance(*index);
                least = least.min(clearance);
                found.push((*index, clearance));
            }
        }
        found.retain(|(_, clearance)| *clearance <= least + slack);
        found.into_iter().map(|(index, _)| index).collect()
    }

    /// Fills the lists of a square of cells from those that may be nearest in
    /// it.
    fn divide(&mut self, near: &[usize], [column, row]: [usize; 2], side: usize) {
        if side == 1 || near.len() <= FEW {
            let start = self.texels.len();
            let list: Vec<_> = near.iter().map(|index| self.entries[*index]).collect();
            self.texels.extend(list);
            for y in row..row + side {
                let header = [start as f32, near.len() as f32, 0.0, 0.0];
                self.texels[y * CELLS + column..][..side].fill(header);
            }
            return;
        }
        let half = side / 2;
        for (right, up) in [(0, 0), (half, 0), (0, half), (half, half)] {
            let corner = [column + right, row + up];
            let nearer = self.nearest(near, &self.area(corner, half));
            self.divide(&nearer, corner, half);
        }
    }

    /// What a square of cells shows.
    fn area(&self, [column, row]: [usize; 2], side: usize) -> Bounds {
        let size = self.window.size();
        let at = |column: usize, row: usize| {
            let share = Vector::new(column as f64, row as f64) / CELLS as f64;
            self.window.least + share.component_mul(&size)
        };
        Bounds {
            least: at(column, row),
            most: at(column + side, row + side),
        }
    }

    /// Packs an obstacle and makes its entry.
    fn pack(&mut self, index: usize) {
        let obstacle = &self.obstacles[index];
        let (position, radius) = (obstacle.position(), obstacle.radius());
        let middle = self.window.centre();
        let (sine, cosine) = obstacle.angle().sin_cos();
        let first = self.texels.len();
        let (kind, count) = match obstacle.core() {
            Core::HalfPlane => {
                let normal = Vector::new(cosine, sine);
                let height = normal.dot(&(middle - position)) - radius;
                self.push([normal.x, normal.y, height, 0.0]);
                (Kind::Arc, 1)
            }
            Core::Point => {
                let away = middle - position;
                let distance = away.norm();
                if distance > FAR * 0.5 * self.window.size().norm() {
                    let normal = away / distance;
                    self.push([normal.x, normal.y, distance - radius, 1.0 / distance]);
                    (Kind::Arc, 1)
                } else {
                    self.push([-away.x, -away.y, 0.0, 0.0]);
                    (Kind::Point, 1)
                }
            }
            Core::Vertices(local) => {
                let corner = |vertex: Vector| {
                    let turned = cosine * vertex + sine * perpendicular(vertex);
                    position - middle + turned
                };
                for (i, vertex) in local.iter().enumerate() {
                    let from = corner(*vertex);
                    let along = corner(local[(i + 1) % local.len()]) - from;
                    let length = along.norm();
                    let normal = -perpendicular(along) / length;
                    let height = -normal.dot(&from);
                    self.push([from.x, from.y, normal.x, normal.y]);
                    self.push([height, length, height - radius, 0.0]);
                }
                (Kind::Polygon, local.len())
            }
        };
        self.entries[index] = [
            first as f32,
            count as f32,
            radius as f32,
            kind as i32 as f32,
        ];
    }

    fn push(&mut self, texel: [f64; 4]) {
        self.texels.push(texel.map(|part| part as f32));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn window() -> Bounds {
        Bounds {
            least: Vector::new(-0.1, 0.0),
            most: Vector::new(0.2, 0.2),
        }
    }

    /// A ring of discs, boxes and a wall, some far away.
    fn obstacles() -> Vec<Obstacle> {
        let disc = |i: usize| {
            let angle = i as f64;
            let place = (0.01 + 0.007 * angle) * Vector::new(angle.cos(), angle.sin());
            Obstacle::new(Core::Point, 0.004, place, 0.0)
        };
        let mut all: Vec<_> = (0..60).map(disc).collect();
        let block = Core::rectangle(0.02, 0.01);
        all.push(Obstacle::new(block, 0.001, Vector::new(0.12, 0.15), 0.3));
        all.push(Obstacle::new(
            Core::HalfPlane,
            0.0,
            Vector::new(0.0, -0.05),
            1.6,
        ));
        all
    }

    /// The list of every cell holds the obstacle that is nearest at each of
    /// many points of the cell, told by where its data starts.
    #[test]
    fn what_is_nearest_is_on_the_list() {
        let (obstacles, window) = (obstacles(), window());
        let texels = packed(&obstacles, &window);
        let mut cells = Cells {
            obstacles: &obstacles,
            window: &window,
            entries: vec![[0.0; 4]; obstacles.len()],
            texels: vec![[0.0; 4]; CELLS * CELLS],
        };
        let all: Vec<usize> = (0..obstacles.len()).collect();
        for index in cells.nearest(&all, &window) {
            cells.pack(index);
        }
        let mut longest = 0;
        for i in 0..200 {
            for j in 0..200 {
                let share = Vector::new(f64::from(i) + 0.5, f64::from(j) + 0.5) / 200.0;
                let point = window.least + share.component_mul(&window.size());
                let clearance = |i: &usize| obstacles[*i].clearance(point).distance;
                let nearest = all
                    .iter()
                    .copied()
                    .min_by(|a, b| clearance(a).total_cmp(&clearance(b)));
                let cell = (share * CELLS as f64).map(|s| s as usize);
                let [start, count, ..] = texels[cell.y * CELLS + cell.x].map(|v| v as usize);
                let list = &texels[start..start + count];
                assert!(list.contains(&cells.entries[nearest.unwrap()]), "{point}");
                longest = longest.max(count);
            }
        }
        assert!(longest < 20, "{longest} of {}", obstacles.len());
    }

    #[test]
    fn nothing_packs_to_empty_lists() {
        let texels = packed(&[], &window());
        assert_eq!(texels.len() % WIDTH, 0);
        assert!(texels.iter().all(|texel| texel[1] == 0.0));
    }
}
