//! Records as JSON, one object to a line.

use std::io::{self, Write};

use serde::Serialize;

use crate::record::Solution;
use crate::record::json::{PATH_END, PATH_START, text};

pub(super) fn path_state(out: &mut impl Write, index: usize, state: &Solution) -> io::Result<()> {
    let before = if index == 0 { PATH_START } else { "," };
    write!(out, "{before}\n{}", text(state)?)
}

pub(super) fn path_end(out: &mut impl Write, states: usize) -> io::Result<()> {
    if states == 0 {
        write!(out, "{PATH_START}")?;
    }
    writeln!(out, "\n{PATH_END}")
}

/// Anything that is printed as JSON, on a line of its own.
pub(in crate::cli) fn object(out: &mut impl Write, what: &impl Serialize) -> io::Result<()> {
    writeln!(out, "{}", text(what)?)
}
