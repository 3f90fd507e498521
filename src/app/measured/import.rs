//! A table of measurements on its way into the scene.

use crate::app::state::State;
use std::path::Path;

/// Brings a table's measurements into the scene.
pub fn import(_state: &mut State, _path: &Path, _bytes: &[u8]) {}
