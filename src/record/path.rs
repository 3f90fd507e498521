//! A path as rows of numbers, in the units of files.

use crate::explore::Path;
use crate::units::{degrees, millimetres, per_millimetre};

/// The names of a row's numbers, with their units.
pub const COLUMNS: [&str; 9] = [
    "pull_mm",
    "branch",
    "tip_x_mm",
    "tip_y_mm",
    "tip_slope_deg",
    "energy_rad2",
    "energy_slope_rad2_per_mm",
    "contacts",
    "multipliers_rad2_per_mm",
];

/// A row a state, by rising pull, as [`COLUMNS`] says: the slope is
/// counterclockwise, contacts are those that press, and the last number is the
/// sum of their multipliers.
pub fn rows(path: &Path) -> impl Iterator<Item = [f64; COLUMNS.len()]> + '_ {
    path.states.iter().map(|state| {
        [
            millimetres(state.pull),
            f64::from(state.branch),
            millimetres(state.tip.position.x),
            millimetres(state.tip.position.y),
            degrees(state.tip.angle),
            state.energy,
            per_millimetre(state.energy_slope),
            state.contacts.len() as f64,
            per_millimetre(state.total_multiplier()) + 0.0,
        ]
    })
}
