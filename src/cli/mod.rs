//! The command line: arguments in, reports out, an exit code. No mechanics.
//!
//! Results go to standard output and everything else to standard error. The
//! exit code is 0 for a solved scene, 2 for bad input, 3 for a solve that did
//! not converge and 1 where the results could not be made or written.

mod arguments;
mod calibrate;
mod check;
mod compare;
mod cycle;
mod draw;
mod explore;
mod force;
mod force_text;
mod input;
mod numbers;
mod output;
mod progress;
mod reproduce;
mod solve;
mod tables;
mod timing;

use std::io::{self, Write};
use std::process::ExitCode;

use clap::Parser;

use arguments::{Arguments, Command};
use input::BadInput;
use output::{printable, reader};

/// How a command ended, where it could do its work.
enum Outcome {
    /// As asked.
    Done,
    /// A solve did not converge, for this reason.
    NotConverged(String),
}

/// What kept a command from its work.
#[derive(Debug, thiserror::Error)]
enum Failure {
    #[error(transparent)]
    Input(#[from] BadInput),
    #[error("cannot write the results: {0}")]
    Output(#[from] io::Error),
    #[error("cannot make the results: {0}")]
    Making(anyhow::Error),
}

/// Runs the command that the program's arguments ask for.
pub fn run() -> ExitCode {
    let arguments = match Arguments::try_parse() {
        Ok(arguments) => arguments,
        Err(error) => {
            explain(&error);
            return ExitCode::from(u8::try_from(error.exit_code()).unwrap_or(2));
        }
    };
    let outcome = match arguments.command {
        Command::Solve(what) => solve::run(&what),
        Command::Check(what) => check::run(&what),
        Command::Draw(what) => draw::run(&what),
        Command::Force(what) => force::run(&what),
        Command::Cycle(what) => cycle::run(&what),
        Command::Calibrate(what) => calibrate::run(&what),
        Command::Compare(what) => compare::run(&what),
        Command::Explore(what) => explore::run(&what),
        Command::Merge(what) => explore::merge(&what),
        Command::Reproduce(what) => reproduce::run(&what),
        Command::Schema => schema(),
    };
    match outcome {
        Ok(Outcome::Done) => ExitCode::SUCCESS,
        Ok(Outcome::NotConverged(reason)) => {
            complain(&reason);
            ExitCode::from(3)
        }
        Err(Failure::Input(input)) => {
            input.complaints().iter().for_each(|text| complain(text));
            ExitCode::from(2)
        }
        Err(failure) => {
            complain(&failure.to_string());
            ExitCode::from(1)
        }
    }
}

fn schema() -> Result<Outcome, Failure> {
    let text = crate::scene::schema::json();
    reader(writeln!(io::stdout().lock(), "{text}"))?;
    Ok(Outcome::Done)
}

/// Help and usage. Where nobody reads them, nobody reads about it.
fn explain(error: &clap::Error) {
    let plain = error.render().to_string();
    let lines: Vec<String> = plain.lines().map(printable).collect();
    let safe = lines.join("\n");
    // In colour, unless an argument that is told of would do more than colour.
    let _ = if safe.trim_end() == plain.trim_end() {
        error.print()
    } else {
        writeln!(io::stderr().lock(), "{}", safe.trim_end())
    };
}

/// A line on standard error that complains of nothing.
fn tell(text: &str) {
    let _ = writeln!(io::stderr().lock(), "note: {text}");
}

/// One line on standard error. Unlike `eprintln!`, it survives that being
/// closed.
fn complain(text: &str) {
    let _ = writeln!(io::stderr().lock(), "error: {}", printable(text));
}
