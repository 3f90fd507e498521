//! A solution as a table: a row for each node, base first, every number with
//! all its digits. What has no node (the certificate, the events) is left out.

use super::solution::{Side, Solution};
use crate::math::shortest;

/// A node's columns. The cable is the first, as far as it goes; the bend and the shear are those of the segment that ends
/// at the node, so the base's are empty; the multipliers are the sums over all
/// that presses at the node on either side, all cables counting as one.
pub const COLUMNS: [&str; 9] = [
    "node",
    "backbone_x_mm",
    "backbone_y_mm",
    "cable_x_mm",
    "cable_y_mm",
    "bend_rad",
    "shear_rad",
    "backbone_multiplier_rad2_per_mm",
    "cable_multiplier_rad2_per_mm",
];

/// What stands before a node's columns where a table holds several pulls.
pub const PULL_COLUMN: &str = "pull_mm";

/// A solution's rows, as [`COLUMNS`] says.
pub fn rows(solution: &Solution) -> impl Iterator<Item = [String; COLUMNS.len()]> + '_ {
    (0..solution.backbone_mm.len()).map(|node| row(solution, node))
}

fn row(solution: &Solution, node: usize) -> [String; COLUMNS.len()] {
    let [x, y] = solution.backbone_mm[node];
    let cable = solution.cables.first();
    let at = cable.and_then(|cable| cable.points_mm.get(node));
    let [u, v] = at.map_or_else(Default::default, |at| at.map(shortest));
    let of_segment = |angles: &[f64]| match node.checked_sub(1) {
        Some(segment) => shortest(angles[segment]),
        None => String::new(),
    };
    let pressing = |side: Side| {
        let here = solution.contacts.iter().filter(|c| c.node == node);
        let there = here.filter(|contact| contact.side == side);
        shortest(there.map(|contact| contact.multiplier).sum())
    };
    [
        node.to_string(),
        shortest(x),
        shortest(y),
        u,
        v,
        of_segment(&solution.bends_rad),
        of_segment(&solution.shears_rad),
        pressing(Side::Backbone),
        pressing(Side::Cable),
    ]
}
