//! Records on their way out: as text for a terminal, JSON or CSV. What a record
//! holds is not its business.

mod csv;
mod json;
mod text;

use std::io::{self, BufWriter, ErrorKind, StdoutLock, Write};

use super::arguments::Format;
use crate::equilibrium::Caution;
use crate::math::{decimals, unsigned_zero};
use crate::mechanics::{Drive, Input, Problem};
use crate::record::Solution;
use crate::scene::Scene;
use crate::scene::limits::shown;
use crate::units::{grams, millimetres};

pub(super) use self::csv::csv_row;
pub(super) use self::json::object;

pub(super) use crate::report::on_a_terminal as printable;

/// What the numbers of a state are about, for whoever reads them as text.
pub(super) struct Labels {
    title: String,
    /// The obstacles' names or, where they have none, their shapes.
    obstacles: Vec<String>,
    /// What was asked for of the cables.
    goal: Vec<Input>,
}

impl Labels {
    /// The labels of a scene and of its problem.
    pub fn of(scene: &Scene, problem: &Problem) -> Self {
        let title = scene.title.as_deref().unwrap_or("Untitled scene");
        let obstacles = scene.obstacles.iter().map(|obstacle| {
            let name = obstacle.name.as_deref();
            printable(name.unwrap_or(obstacle.shape.word()))
        });
        Self {
            title: printable(title),
            obstacles: obstacles.collect(),
            goal: inputs(problem.drive()).collect(),
        }
    }

    /// An obstacle by its index and its name.
    fn obstacle(&self, index: usize) -> String {
        match self.obstacles.get(index) {
            Some(name) => format!("{index} {name}"),
            None => index.to_string(),
        }
    }

    /// A caution as a sentence of its own, with what helps.
    pub fn caution(&self, caution: &Caution) -> String {
        let obstacle = |index| format!("obstacle {}", self.obstacle(index));
        let sentence = caution.sentence(obstacle);
        let mut letters = sentence.chars();
        let first = letters.next().map(char::to_uppercase);
        let first: String = first.into_iter().flatten().collect();
        let help = match caution.remedy() {
            Some(remedy) => format!("; {remedy} keeps it out"),
            None => String::new(),
        };
        format!("{first}{}{help}.", letters.as_str())
    }
}

/// Where records of solutions go, in one of the formats.
pub(super) struct Output<W> {
    out: W,
    format: Format,
    labels: Labels,
    /// States of the path written so far.
    states: usize,
}

impl<W: Write> Output<W> {
    /// An output that nothing is written to yet.
    pub fn new(out: W, format: Format, labels: Labels) -> Self {
        Self {
            out,
            format,
            labels,
            states: 0,
        }
    }

    /// Writes the result of one solve.
    pub fn solution(&mut self, state: &Solution) -> io::Result<()> {
        match self.format {
            Format::Text => text::solution(&mut self.out, &self.labels, state)?,
            Format::Json => json::object(&mut self.out, state)?,
            Format::Csv => csv::solution(&mut self.out, state)?,
        }
        self.out.flush()
    }

    /// Writes one state of a path, at once.
    pub fn path_state(&mut self, state: &Solution) -> io::Result<()> {
        let index = self.states;
        self.states += 1;
        match self.format {
            Format::Text => text::path_state(&mut self.out, &self.labels, index, state)?,
            Format::Json => json::path_state(&mut self.out, index, state)?,
            Format::Csv => csv::path_state(&mut self.out, index, state)?,
        }
        self.out.flush()
    }

    /// Writes what belongs after the last state of a path.
    pub fn path_end(&mut self) -> io::Result<()> {
        if self.format == Format::Json {
            json::path_end(&mut self.out, self.states)?;
        }
        self.out.flush()
    }
}

/// Whether anybody reads on.
pub(super) enum Reader {
    /// Yes, as far as is known.
    Listening,
    /// No: the pipe is closed, as by `head`. That is no fault.
    Gone,
}

/// What became of writing. Everything but a closed pipe stays an error.
pub(super) fn reader(written: io::Result<()>) -> io::Result<Reader> {
    match written {
        Ok(()) => Ok(Reader::Listening),
        Err(error) if error.kind() == ErrorKind::BrokenPipe => Ok(Reader::Gone),
        Err(error) => Err(error),
    }
}

/// Writes to standard output. Whoever stopped reading still gets the exit code.
pub(super) fn write_out(
    write: impl FnOnce(&mut BufWriter<StdoutLock<'static>>) -> io::Result<()>,
) -> io::Result<()> {
    let mut out = BufWriter::new(io::stdout().lock());
    let written = write(&mut out);
    reader(written.and_then(|()| out.flush()))?;
    Ok(())
}

/// Text in lines of a readable length.
pub(super) fn paragraph(out: &mut impl Write, start: &str, text: &str) -> io::Result<()> {
    let mut line = start.to_owned();
    for word in text.split_whitespace() {
        if line.chars().count() + word.chars().count() > 88 && !line.trim().is_empty() {
            writeln!(out, "{}", line.trim_end())?;
            line = "  ".to_owned();
        }
        line.push_str(word);
        line.push(' ');
    }
    writeln!(out, "{}", line.trim_end())
}

/// A pull in metres as millimetres: to 0.1 µm, as near as a run finds the end
/// of a branch, and a smaller one with all its digits.
pub(super) fn pull_shown(pull: f64) -> String {
    let pull_mm = millimetres(pull);
    let grain = if pull_mm.abs() < 1.0 { 1e9 } else { 1e4 };
    shown(unsigned_zero((pull_mm * grain).round() / grain))
}

/// A force in newtons as grams, with four figures.
pub(super) fn grams_shown(newtons: f64) -> String {
    let size = grams(newtons).abs();
    let count = match size {
        0.0 => 0.0,
        size => (3.0 - libm::log10(size).floor()).clamp(0.0, 4.0),
    };
    decimals(grams(newtons), count as usize)
}

fn inputs(drive: &Drive) -> impl Iterator<Item = Input> + '_ {
    drive.cables.iter().map(|driven| driven.input)
}

/// What is given of the cables, in words: `pull 4.9 mm`, `pull 6 mm and load 60 g`.
pub(super) fn driven_shown(drive: &Drive) -> String {
    let each = inputs(drive).map(|input| match input {
        Input::Pull(pull) => format!("pull {} mm", pull_shown(pull)),
        Input::Load(load) => format!("load {} g", grams_shown(load)),
    });
    each.collect::<Vec<_>>().join(" and ")
}
