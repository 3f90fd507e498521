//! What is said of a study that was explored.

use std::io::{self, Write};
use std::ops::Range;

use super::super::output::printable;
use super::count;
use super::folder::Folder;
use super::pool::{duration, rounded};
use super::table::Summary;
use crate::math::{decimals, unsigned_zero};
use crate::study::{Study, Verdict};

/// What is known before the computing begins.
pub(super) struct Told<'a> {
    study: &'a Study,
    todo: u64,
    threads: usize,
}

impl<'a> Told<'a> {
    pub fn begin(study: &'a Study, todo: &[Range<u64>], threads: usize) -> Self {
        Self {
            study,
            todo: count(todo),
            threads,
        }
    }

    /// Tells what came of it. A shard has no summary: others have the rest.
    pub fn end(
        &self,
        out: &mut impl Write,
        folder: &Folder<'_>,
        summary: Option<&Summary>,
        seconds: f64,
    ) -> io::Result<()> {
        writeln!(out, "{}\n", title(self.study))?;
        let pace = match self.todo {
            0 => "nothing that was not there".to_owned(),
            todo => format!(
                "{todo} in {}, {} a second on {}",
                duration(seconds),
                rounded(todo as f64 / seconds.max(1e-9)),
                threads(self.threads)
            ),
        };
        writeln!(out, "  computed     {pace}")?;
        match summary {
            Some(summary) => {
                let path = folder.csv();
                self::summary(out, self.study, summary)?;
                writeln!(out, "\n  {}", printable(&path.display().to_string()))
            }
            None => writeln!(
                out,
                "\n  Once all shards are there: sinew merge {}",
                printable(&folder.path().display().to_string())
            ),
        }
    }
}

/// The study's title, or its scene's.
pub(super) fn title(study: &Study) -> String {
    let titles = [&study.file().title, &study.scene().title];
    let title = titles.into_iter().flatten().next();
    printable(title.map_or("Untitled study", |title| title))
}

pub(super) fn threads(count: usize) -> String {
    match count {
        1 => "1 thread".to_owned(),
        count => format!("{count} threads"),
    }
}

/// The rows of a table in a few lines.
pub(super) fn summary(out: &mut impl Write, study: &Study, summary: &Summary) -> io::Result<()> {
    let verdicts = Verdict::ALL.iter().zip(summary.verdicts);
    let verdicts = verdicts.filter(|(_, count)| *count > 0);
    let verdicts = verdicts.map(|(verdict, count)| format!("{count} {}", verdict.word()));
    let verdicts: Vec<String> = verdicts.collect();
    writeln!(
        out,
        "  samples      {} of {}: {}",
        summary.rows,
        study.samples(),
        verdicts.join(", ")
    )?;
    if !study.constraints().is_empty() {
        let texts = study.constraints().iter().map(|one| one.text().trim());
        let texts: Vec<String> = texts.map(printable).collect();
        writeln!(
            out,
            "  constraints  {} samples meet {}",
            summary.feasible,
            texts.join(" and ")
        )?;
    }
    let width = summary.ends.iter().map(|(output, _)| output.name().len());
    let width = width.max().unwrap_or(0);
    if width > 0 {
        writeln!(
            out,
            "\n  {:<width$}  {:>12}  {:>10}  {:>12}  {:>10}",
            "output", "least", "sample", "greatest", "sample"
        )?;
    }
    for (output, ends) in &summary.ends {
        let name = output.name();
        match ends {
            None => writeln!(out, "  {name:<width$}  {:>12}", "-")?,
            Some(ends) => {
                let [(least, a), (greatest, b)] = [ends.least, ends.greatest];
                writeln!(
                    out,
                    "  {name:<width$}  {:>12}  {a:>10}  {:>12}  {b:>10}",
                    figures(least),
                    figures(greatest)
                )?;
            }
        }
    }
    Ok(())
}

/// A number with five figures.
fn figures(value: f64) -> String {
    let size = value.abs();
    if size != 0.0 && !(1e-4..1e7).contains(&size) {
        return format!("{value:.4e}");
    }
    let before = if size < 1.0 {
        0.0
    } else {
        libm::log10(size).floor()
    };
    decimals(unsigned_zero(value), (4.0 - before).max(0.0) as usize)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_have_five_figures() {
        let check = |value, expected: &str| assert_eq!(figures(value), expected);
        check(0.0, "0.0000");
        check(-0.0, "0.0000");
        check(1.0, "1.0000");
        check(-12.345_678, "-12.346");
        check(123_456.7, "123457");
        check(0.012_345, "0.0123");
        check(1.5e-6, "1.5000e-6");
        check(3e9, "3.0000e9");
    }
}
