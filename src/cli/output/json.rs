//! States as JSON: one object to a line, every number with all its digits.

use std::io::{self, Write};

use serde::Serialize;
use serde_json::Serializer;
use serde_json::ser::Formatter;

use super::State;
use crate::math::unsigned_zero;

/// The version of what surrounds the states of a path.
const PATH_SCHEMA: &str = "sinew-path-1";

pub(super) fn solution(out: &mut impl Write, state: &State) -> io::Result<()> {
    object(out, state)
}

pub(super) fn path_state(out: &mut impl Write, index: usize, state: &State) -> io::Result<()> {
    if index == 0 {
        path_start(out)?;
    } else {
        write!(out, ",")?;
    }
    writeln!(out)?;
    value(out, state)
}

pub(super) fn path_end(out: &mut impl Write, states: usize) -> io::Result<()> {
    if states == 0 {
        path_start(out)?;
    }
    writeln!(out, "\n]}}")
}

/// Anything that is printed as JSON, on a line of its own.
pub(in crate::cli) fn object(out: &mut impl Write, what: &impl Serialize) -> io::Result<()> {
    value(out, what)?;
    writeln!(out)
}

fn value(out: &mut impl Write, what: &impl Serialize) -> io::Result<()> {
    Ok(what.serialize(&mut Serializer::with_formatter(out, UnsignedZero))?)
}

/// Compact JSON in which no zero has a sign.
struct UnsignedZero;

impl Formatter for UnsignedZero {
    fn write_f64<W: ?Sized + Write>(&mut self, writer: &mut W, value: f64) -> io::Result<()> {
        serde_json::ser::CompactFormatter.write_f64(writer, unsigned_zero(value))
    }
}

fn path_start(out: &mut impl Write) -> io::Result<()> {
    write!(out, r#"{{"schema":"{PATH_SCHEMA}","states":["#)
}
