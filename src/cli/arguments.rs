//! What may be typed after `sinew`, and the help that says so.

use std::path::PathBuf;

use clap::{Args, Parser, Subcommand, ValueEnum, value_parser};

const EXAMPLES: &str = "\
Examples:
  sinew solve two-discs.toml                  a report for people
  sinew solve two-discs.toml --format json    the same for programs
  sinew draw two-discs.toml -o two-discs.svg  a picture
  sinew check two-discs.toml                  every fault of a scene file
  sinew schema > scene.schema.json            for editors that complete TOML

Exit codes: 0 solved, 1 results not written, 2 bad input, 3 not converged.";

const SOLVE_EXAMPLES: &str = "\
Examples:
  sinew solve two-discs.toml --pull 5
  sinew solve two-discs.toml --path 20                  a line for each pull
  sinew solve two-discs.toml --path 20 --format csv > path.csv
  sinew solve two-discs.toml --repeat 1000              how long a solve takes
  generate-scene | sinew solve - --format json";

/// Simulates cable-driven continuum robots in contact with obstacles.
#[derive(Parser)]
#[command(name = "sinew", version, after_help = EXAMPLES)]
pub(super) struct Arguments {
    #[command(subcommand)]
    pub command: Command,
}

#[derive(Subcommand)]
pub(super) enum Command {
    /// Finds the robot's shape and what it presses on.
    Solve(Solve),
    /// Draws the robot where it rests, as SVG or PNG.
    Draw(Draw),
    /// Lists every fault of a scene file, or sums the scene up.
    Check(Check),
    /// Prints the JSON Schema of scene files.
    Schema,
}

#[derive(Args)]
#[command(after_help = SOLVE_EXAMPLES)]
pub(super) struct Solve {
    /// The scene file, or - for standard input.
    pub scene: PathBuf,

    /// Draw in this much cable instead of the scene's pull_mm.
    #[arg(long, value_name = "MM", allow_hyphen_values = true)]
    pub pull: Option<f64>,

    /// How to print the result.
    #[arg(long, value_enum, default_value_t = Format::Text)]
    pub format: Format,

    /// Print the state at this many equal steps from no pull to the pull.
    #[arg(long, value_name = "STEPS", value_parser = value_parser!(u32).range(1..=100_000))]
    pub path: Option<u32>,

    /// Solve this many times more and print how long a solve takes.
    #[arg(
        long,
        value_name = "N",
        value_parser = value_parser!(u32).range(1..=100_000),
        conflicts_with = "path"
    )]
    pub repeat: Option<u32>,
}

#[derive(Args)]
pub(super) struct Draw {
    /// The scene file, or - for standard input.
    pub scene: PathBuf,

    /// Where to write the picture: a name ending in .svg or .png, or - for an
    /// SVG on standard output.
    #[arg(short, long, value_name = "FILE")]
    pub output: PathBuf,

    /// Draw in this much cable instead of the scene's pull_mm.
    #[arg(long, value_name = "MM", allow_hyphen_values = true)]
    pub pull: Option<f64>,

    /// The colours. An SVG with auto follows its viewer; a PNG is light then.
    #[arg(long, value_enum, default_value_t = Look::Auto)]
    pub theme: Look,
}

/// The colours of a picture.
#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(super) enum Look {
    /// As the viewer prefers.
    Auto,
    /// Ink on paper.
    Light,
    /// Paper on ink.
    Dark,
}

#[derive(Args)]
pub(super) struct Check {
    /// The scene file, or - for standard input.
    pub scene: PathBuf,
}

/// A way to print results.
#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(super) enum Format {
    /// A report for people.
    Text,
    /// Everything there is, as one object.
    Json,
    /// A row for each node.
    Csv,
}
