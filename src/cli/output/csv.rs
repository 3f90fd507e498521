//! States as CSV: a row for each node, base first, every number with all its
//! digits. What has no node (the certificate, the events) is left out.

use std::io::{self, Write};

use super::State;
use super::state::Side;
use crate::math::shortest;

/// A node's columns. The bend and the shear are those of the segment that ends
/// at the node, so the base's are empty; the multipliers are the sums over all
/// that presses at the node on either side.
const COLUMNS: [&str; 9] = [
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

pub(super) fn solution(out: &mut impl Write, state: &State) -> io::Result<()> {
    let mut table = ::csv::Writer::from_writer(out);
    record(&mut table, COLUMNS)?;
    for node in 0..state.backbone_mm.len() {
        record(&mut table, row(state, node))?;
    }
    table.flush()
}

pub(super) fn path_state(out: &mut impl Write, index: usize, state: &State) -> io::Result<()> {
    let mut table = ::csv::Writer::from_writer(out);
    if index == 0 {
        record(&mut table, ["pull_mm"].into_iter().chain(COLUMNS))?;
    }
    for node in 0..state.backbone_mm.len() {
        let pull = shortest(state.pull_mm);
        record(&mut table, [pull].into_iter().chain(row(state, node)))?;
    }
    table.flush()
}

fn row(state: &State, node: usize) -> [String; 9] {
    let [x, y] = state.backbone_mm[node];
    let [u, v] = state.cable_mm[node];
    let of_segment = |angles: &[f64]| match node.checked_sub(1) {
        Some(segment) => shortest(angles[segment]),
        None => String::new(),
    };
    let pressing = |side: Side| {
        let here = state.contacts.iter().filter(|c| c.node == node);
        let there = here.filter(|contact| contact.side == side);
        shortest(there.map(|contact| contact.multiplier).sum())
    };
    [
        node.to_string(),
        shortest(x),
        shortest(y),
        shortest(u),
        shortest(v),
        of_segment(&state.bends_rad),
        of_segment(&state.shears_rad),
        pressing(Side::Backbone),
        pressing(Side::Cable),
    ]
}

/// Writes a row; a closed pipe stays known for one.
pub(in crate::cli) fn record<W: Write, T: AsRef<[u8]>>(
    table: &mut ::csv::Writer<W>,
    fields: impl IntoIterator<Item = T>,
) -> io::Result<()> {
    table
        .write_record(fields)
        .map_err(|error| match error.into_kind() {
            // As it is, so that a closed pipe is known for one.
            ::csv::ErrorKind::Io(error) => error,
            other => io::Error::other(format!("{other:?}")),
        })
}
