//! What may be typed after `sinew explore` and `sinew merge`.

use super::Edits;
use clap::{Args, value_parser};
use std::path::PathBuf;

const EXPLORE_EXAMPLES: &str = "\
Examples:
  sinew explore study.toml --explain              what it would take
  sinew explore study.toml --out results
  sinew explore study.toml --out results --resume after it was stopped
  sinew explore study.toml --out results --shard 2/8
  sinew merge results                             the shards' table
  sinew explore --outputs                         what can be asked for

A study names a scene, parameters of it and outputs:
  version = 1
  scene = \"two-posts.toml\"
  sampler = \"grid\"               # or latin or sobol, with samples = and seed =
  outputs = [\"force_max_n\", \"reach_mm\"]
  constraints = [\"force_max_n < 0.2\"]
  [[parameter]]
  key = \"robot.cable_offset_mm\"  # as --set has it
  from = 4                        # or values = [4, 6, 8]; scale = \"log\"
  to = 10
  steps = 40

A sample that has no shape is a row that says why, and no failure.";

#[derive(Args)]
#[command(after_help = EXPLORE_EXAMPLES)]
pub(in crate::cli) struct Explore {
    /// The study's file. The scene that it names lies beside it.
    #[arg(required_unless_present = "outputs")]
    pub study: Option<PathBuf>,

    /// The folder for the results; made where it is missing.
    #[arg(long, value_name = "DIR", default_value = "sinew-study")]
    pub out: PathBuf,

    /// Compute only the K-th of N parts, from 1; sinew merge puts them together.
    #[arg(long, value_name = "K/N")]
    pub shard: Option<String>,

    /// Tell how many samples there are, and about what time and room they take;
    /// compute nothing else.
    #[arg(long)]
    pub explain: bool,

    /// Go on where an earlier run was stopped: compute what the folder has not.
    #[arg(long)]
    pub resume: bool,

    /// Threads to compute on; as many as there are processors, if not given.
    #[arg(long, value_name = "N", value_parser = value_parser!(u32).range(1..=1024))]
    pub threads: Option<u32>,

    /// List what can be asked of a sample, with units.
    #[arg(long, conflicts_with_all = ["study", "shard", "explain", "resume", "threads"])]
    pub outputs: bool,

    #[command(flatten)]
    pub edits: Edits,
}

#[derive(Args)]
pub(in crate::cli) struct Merge {
    /// The folders that the shards were computed into, in any order; one, if it
    /// was the same for all.
    #[arg(required = true, value_name = "DIR")]
    pub folders: Vec<PathBuf>,

    /// Where to write the table, or - for standard output; results.csv in the
    /// first folder, if not given.
    #[arg(short, long, value_name = "FILE.csv")]
    pub out: Option<PathBuf>,

    /// Make the table of the samples that there are, where some are missing.
    #[arg(long)]
    pub partial: bool,
}
