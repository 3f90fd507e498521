//! States as JSON: one object to a line, every number with all its digits.

use std::io::{self, Write};

use super::State;

/// The version of what surrounds the states of a path.
const PATH_SCHEMA: &str = "sinew-path-1";

pub(super) fn solution(out: &mut impl Write, state: &State) -> io::Result<()> {
    serde_json::to_writer(&mut *out, state)?;
    writeln!(out)
}

pub(super) fn path_state(out: &mut impl Write, index: usize, state: &State) -> io::Result<()> {
    if index == 0 {
        path_start(out)?;
    } else {
        write!(out, ",")?;
    }
    writeln!(out)?;
    Ok(serde_json::to_writer(out, state)?)
}

pub(super) fn path_end(out: &mut impl Write, states: usize) -> io::Result<()> {
    if states == 0 {
        path_start(out)?;
    }
    writeln!(out, "\n]}}")
}

fn path_start(out: &mut impl Write) -> io::Result<()> {
    write!(out, r#"{{"schema":"{PATH_SCHEMA}","states":["#)
}
