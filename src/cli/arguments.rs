//! What may be typed after `sinew`, and the help that says so.

mod study;

pub(super) use study::{Explore, Merge};

use std::path::PathBuf;

use clap::{Args, Parser, Subcommand, ValueEnum, value_parser};

const EXAMPLES: &str = "\
Examples:
  sinew                                       the window
  sinew two-discs.toml                        the window on a scene
  sinew solve two-discs.toml                  a report for people
  sinew solve two-discs.toml --format json    the same for programs
  sinew draw two-discs.toml -o two-discs.svg  a picture
  sinew check two-discs.toml                  every fault of a scene file
  sinew force load-cell.toml                  contact force against load
  sinew cycle two-posts.toml --pull 0:6:0     there and back, with its loop
  sinew calibrate load-cell.toml forces.csv --fit ei,holes
                                              stiffness and friction from readings
  sinew compare free.toml photo.csv           a measured shape against the computed
  sinew explore study.toml                    a design's map: many scenes at once
  sinew reproduce                             the paper's figures and table
  sinew schema > scene.schema.json            for editors that complete TOML

Exit codes: 0 solved, 1 no results, 2 bad input, 3 not converged.";

const SOLVE_EXAMPLES: &str = "\
Examples:
  sinew solve two-discs.toml --pull 5
  sinew solve antagonists.toml --load 300 --cable 1
  sinew solve two-discs.toml --set robot.segments_per_bay=1 --set robot.disks=9
  sinew solve two-discs.toml --path 20                  a line for each pull
  sinew solve two-discs.toml --path 20 --format csv > path.csv
  sinew solve two-discs.toml --repeat 1000              how long a solve takes
  generate-scene | sinew solve - --format json";

const DRAW_EXAMPLES: &str = "\
Examples:
  sinew draw two-discs.toml -o two-discs.svg
  sinew draw two-discs.toml -o two-discs.png --pull 5 --theme dark";

const FORCE_EXAMPLES: &str = "\
Examples:
  sinew force load-cell.toml --loads 50:350:50 --measured 250:17.8
  sinew force load-cell.toml --friction -0.9 --window 0:8 --format csv
  sinew force load-cell.toml --rod 2.2:3        also by multipliers
  sinew force load-cell.toml --weighed 350:6.5  the same, EI from one weight";

const CYCLE_EXAMPLES: &str = "\
Examples:
  sinew cycle two-posts.toml --pull 0:12:4:12
  sinew cycle two-posts.toml --load 0:300:0 --set friction.holes=0.3
  sinew cycle antagonists.toml --load 0:200:0 --cable 1 --format csv
  sinew cycle two-posts.toml --load 0:300:0 --out loop.svg";

const CALIBRATE_EXAMPLES: &str = "\
Examples:
  sinew calibrate load-cell.toml table-1-by-row.csv --fit holes,contacts,base_loss
  sinew calibrate two-posts.toml weights.csv --fit ei
  sinew calibrate two-posts.toml weights.csv --fit ei,holes --set friction.contacts=0.2

The fit starts from the scene's own values, which --set changes; frictions that the
scene does not have start from 0.2, 0.2 and a loss of 0.1.";

const COMPARE_EXAMPLES: &str = "\
Examples:
  sinew compare free.toml photo.csv                 the pull that fits best
  sinew compare free.toml photo.csv --pull 10 --out both.svg
  sinew compare free.toml scan.txt                  as numpy saves it
  sinew compare measured.toml                       the points in the scene";

const REPRODUCE_EXAMPLES: &str = "\
Examples:
  sinew reproduce                             everything, into sinew-report
  sinew reproduce fig4b table1 --out results
  sinew reproduce table1 --format json

The report is DIR/report.html; its curves are DIR/data/*.csv and
DIR/figures/*.svg.";

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
    /// Estimates the contact force against the load, by virtual work and by
    /// multipliers.
    Force(Force),
    /// Follows a cable's pull or load there and back, with the loop it makes.
    Cycle(Cycle),
    /// Fits stiffness and friction to measured forces and pulls.
    Calibrate(Calibrate),
    /// Compares a measured backbone with the computed one.
    Compare(Compare),
    /// Computes the samples of a study: what a design's sizes do to outputs.
    Explore(Explore),
    /// Makes the table of a study that was explored in shards.
    Merge(Merge),
    /// Recomputes the paper's figures and table, and writes a report.
    Reproduce(Reproduce),
    /// Prints the JSON Schema of scene files.
    Schema,
}

/// What is changed of a scene before anything is done with it.
#[derive(Args, Default)]
pub(super) struct Edits {
    /// Set a value of the scene first, by its name in the file and in messages:
    /// obstacle[0].center_mm[0]=44. May be given several times and is done in
    /// that order. Beside the file's keys there are robot.disks and
    /// robot.disk_spacing_mm, which set the number of segments at the length
    /// and the segments a bay that the robot then has.
    #[arg(long, value_name = "KEY=VALUE")]
    pub set: Vec<String>,
}

/// What drives a cable, in the place of what the scene says.
#[derive(Args, Default)]
pub(super) struct Driving {
    /// Draw in this much cable instead of what the scene says.
    #[arg(long, value_name = "MM", allow_hyphen_values = true, group = "drive")]
    pub pull: Option<f64>,

    /// Hang this weight on the cable, in grams, instead of what the scene says.
    #[arg(long, value_name = "G", allow_hyphen_values = true, group = "drive")]
    pub load: Option<f64>,

    /// The cable that --pull or --load is about, from 0; to be given where the
    /// scene has several.
    #[arg(long, value_name = "K", requires = "drive")]
    pub cable: Option<usize>,
}

impl Driving {
    /// A pull of the one cable, if any.
    pub fn of_pull(pull: Option<f64>) -> Self {
        Self {
            pull,
            ..Self::default()
        }
    }
}

#[derive(Args)]
#[command(after_help = SOLVE_EXAMPLES)]
pub(super) struct Solve {
    /// The scene file, or - for standard input.
    pub scene: PathBuf,

    #[command(flatten)]
    pub driving: Driving,

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

    #[command(flatten)]
    pub edits: Edits,
}

#[derive(Args)]
#[command(after_help = DRAW_EXAMPLES)]
pub(super) struct Draw {
    /// The scene file, or - for standard input.
    pub scene: PathBuf,

    /// Where to write the picture: a name ending in .svg or .png, or - for an
    /// SVG on standard output.
    #[arg(short, long, value_name = "FILE")]
    pub output: PathBuf,

    #[command(flatten)]
    pub driving: Driving,

    /// The colours. An SVG with auto follows its viewer; a PNG is light then.
    #[arg(long, value_enum, default_value_t = Look::Auto)]
    pub theme: Look,

    #[command(flatten)]
    pub edits: Edits,
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

    #[command(flatten)]
    pub edits: Edits,
}

#[derive(Args)]
#[command(after_help = FORCE_EXAMPLES)]
pub(super) struct Force {
    /// The scene file, or - for standard input.
    pub scene: PathBuf,

    /// Loads on the cable in grams, counted from contact: FIRST:LAST:STEP or a
    /// list such as 50,100,350. Those up to the end of the branch are printed.
    #[arg(
        long,
        value_name = "GRAMS",
        default_value = "50:350:50",
        allow_hyphen_values = true
    )]
    pub loads: String,

    /// The node whose motion does the virtual work, from 0 at the base; the tip
    /// where none is given, as in the paper.
    #[arg(long)]
    pub node: Option<usize>,

    /// The pulls that the straight lines are fitted on, in mm.
    #[arg(
        long,
        value_name = "FIRST:LAST",
        default_value = "0:10",
        allow_hyphen_values = true
    )]
    pub window: String,

    /// Whose motion the lines follow.
    #[arg(long, value_enum, default_value_t = Motion::Free)]
    pub motion: Motion,

    /// mu = P_y / P_x; where neither this nor a measured point is given, what
    /// the scene's calibration says, or else 0.
    #[arg(
        long,
        value_name = "MU",
        allow_hyphen_values = true,
        conflicts_with = "measured"
    )]
    pub friction: Option<f64>,

    /// One measured force that fixes mu, as load and force in grams.
    #[arg(long, value_name = "LOAD:FORCE", allow_hyphen_values = true)]
    pub measured: Option<String>,

    /// The backbone's bending stiffness EI in N mm², for forces by multipliers;
    /// the scene's, where no stiffness is given here.
    #[arg(
        long,
        value_name = "EI",
        allow_hyphen_values = true,
        group = "stiffness"
    )]
    pub ei: Option<f64>,

    /// The stiffness from Young's modulus in GPa and a round rod's diameter in
    /// mm.
    #[arg(
        long,
        value_name = "GPA:MM",
        allow_hyphen_values = true,
        group = "stiffness"
    )]
    pub rod: Option<String>,

    /// The stiffness from one whole weight on the cable in grams and the pull
    /// in mm that it held.
    #[arg(
        long,
        value_name = "LOAD:PULL",
        allow_hyphen_values = true,
        group = "stiffness"
    )]
    pub weighed: Option<String>,

    /// How to print the result.
    #[arg(long, value_enum, default_value_t = Format::Text)]
    pub format: Format,

    #[command(flatten)]
    pub edits: Edits,
}

#[derive(Args)]
#[command(after_help = CYCLE_EXAMPLES)]
#[command(group(clap::ArgGroup::new("course").required(true).args(["pull", "load"])))]
pub(super) struct Cycle {
    /// The scene file, or - for standard input.
    pub scene: PathBuf,

    /// The pulls to go to one after the other, in mm.
    #[arg(long, value_name = "FROM:TO:…", allow_hyphen_values = true)]
    pub pull: Option<String>,

    /// The loads to go to one after the other, in grams.
    #[arg(long, value_name = "FROM:TO:…", allow_hyphen_values = true)]
    pub load: Option<String>,

    /// The cable, from 0; to be given where the scene has several.
    #[arg(long, value_name = "K")]
    pub cable: Option<usize>,

    /// Equal steps from one to the next.
    #[arg(long, value_name = "N", default_value_t = 40, value_parser = value_parser!(u32).range(1..=10_000))]
    pub steps: u32,

    /// Also write the loop of load against pull as a picture.
    #[arg(long, value_name = "FILE.svg")]
    pub out: Option<PathBuf>,

    /// How to print the result; CSV has a row for each state.
    #[arg(long, value_enum, default_value_t = Format::Text)]
    pub format: Format,

    #[command(flatten)]
    pub edits: Edits,
}

#[derive(Args)]
#[command(after_help = CALIBRATE_EXAMPLES)]
pub(super) struct Calibrate {
    /// The scene file. Its cables slide, whatever it says.
    pub scene: PathBuf,

    /// The readings: CSV with load_g, the whole weight on the first cable,
    /// load_from_contact_g, or pull_mm, and force_g, the force on all
    /// obstacles; under a load pull_mm is a reading, too. A column named by a
    /// key of the scene, as obstacle[0].point_mm[0], sets it for its row. - for
    /// standard input.
    pub measured: PathBuf,

    /// What to fit: ei, holes, contacts, base_loss, with commas between.
    #[arg(long, value_name = "NAME,…")]
    pub fit: String,

    /// How far a force may be off, in grams, which weighs forces against pulls
    /// where both were read.
    #[arg(
        long,
        value_name = "G",
        default_value_t = 0.5,
        allow_hyphen_values = true
    )]
    pub force_error: f64,

    /// The same of a pull, in mm.
    #[arg(
        long,
        value_name = "MM",
        default_value_t = 0.1,
        allow_hyphen_values = true
    )]
    pub pull_error: f64,

    /// How to print the result; CSV has a row for each reading.
    #[arg(long, value_enum, default_value_t = Format::Text)]
    pub format: Format,

    #[command(flatten)]
    pub edits: Edits,
}

/// Whose motion virtual work looks at.
#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(super) enum Motion {
    /// The robot's without its obstacles, as in the paper.
    Free,
    /// The robot's as it meets its obstacles.
    Contact,
}

#[derive(Args)]
#[command(after_help = COMPARE_EXAMPLES)]
pub(super) struct Compare {
    /// The scene file.
    pub scene: PathBuf,

    /// The measured backbone: CSV with columns x_mm, y_mm and perhaps node, in
    /// the scene's frame, base to tip; - for standard input. A head may name
    /// other units, as x_m or "x (cm)". The one in the scene, where none is
    /// named.
    pub measured: Option<PathBuf>,

    /// The pull in mm, where it is known; otherwise the one that fits best on
    /// the whole branch.
    #[arg(long, value_name = "MM", allow_hyphen_values = true)]
    pub pull: Option<f64>,

    /// Also write a picture of both shapes.
    #[arg(long, value_name = "FILE.svg")]
    pub out: Option<PathBuf>,

    /// How to print the result; CSV has a row for each measured point.
    #[arg(long, value_enum, default_value_t = Format::Text)]
    pub format: Format,

    #[command(flatten)]
    pub edits: Edits,
}

#[derive(Args)]
#[command(after_help = REPRODUCE_EXAMPLES)]
pub(super) struct Reproduce {
    /// Which to recompute: fig3b, fig4a, fig4b, fig5, fig7, fig9, fig10a,
    /// fig10b, table1. All, if none is named.
    #[arg(value_name = "FIG|TABLE")]
    pub items: Vec<String>,

    /// The folder for the report and its data; made where it is missing.
    #[arg(long, value_name = "DIR", default_value = "sinew-report")]
    pub out: PathBuf,

    /// How to print the comparison.
    #[arg(long, value_enum, default_value_t = Report::Text)]
    pub format: Report,
}

/// A way to print a comparison.
#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(super) enum Report {
    /// Tables for people.
    Text,
    /// Everything there is, as one object.
    Json,
}

/// A way to print results.
#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(super) enum Format {
    /// A report for people.
    Text,
    /// Everything there is, as one object.
    Json,
    /// A row for each node, load or measured point.
    Csv,
}
