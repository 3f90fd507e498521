//! The colours of contacts as a bar.

use super::colour;
use crate::view::Theme;
use eframe::egui::{Mesh, Rect, Shape, pos2};

/// The contact scale from 0 to 1, left to right.
pub fn contact_scale(bar: Rect, theme: Theme) -> Shape {
    const STEPS: u32 = 24;
    let mut mesh = Mesh::default();
    for step in 0..=STEPS {
        let share = step as f32 / STEPS as f32;
        let ink = colour(theme.contact(f64::from(share)));
        let x = bar.left() + share * bar.width();
        mesh.colored_vertex(pos2(x, bar.top()), ink);
        mesh.colored_vertex(pos2(x, bar.bottom()), ink);
        if step > 0 {
            let next = 2 * step;
            mesh.add_triangle(next - 2, next - 1, next);
            mesh.add_triangle(next - 1, next, next + 1);
        }
    }
    Shape::mesh(mesh)
}
