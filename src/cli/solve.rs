//! `sinew solve`: one solve, or a run along the pull, reported state by state.

use std::io::{self, BufWriter, Write};

use super::arguments::{Format, Solve};
use super::input::{self, BadInput};
use super::output::{Labels, Output, Reader, driven_shown, reader};
use super::progress::Progress;
use super::{Failure, Outcome, timing};
use crate::equilibrium::{self, Caution, Run, Settings, Start, Status};
use crate::forces::Stiffness;
use crate::mechanics::Problem;
use crate::record::Solution;

/// Steps of the progress bar of one solve.
pub(super) const RESOLUTION: u32 = 1000;
/// Stages of the chain that a slice of a solve may go through, so that the bar
/// moves: a few milliseconds.
const SLICE: usize = 20_000;

pub(super) fn run(what: &Solve) -> Result<Outcome, Failure> {
    if what.repeat.is_some() && what.format == Format::Csv {
        return Err(BadInput::Arguments(
            "--repeat has no place in CSV; print text or JSON, or leave it out".to_owned(),
        )
        .into());
    }
    let (scene, problem) = input::problem(&what.scene, &what.edits, &what.driving)?;
    let out = BufWriter::new(io::stdout().lock());
    let mut output = Output::new(out, what.format, Labels::of(&scene, &problem));
    // Its range was checked with the scene's.
    let stiffness = Stiffness::of_scene(&scene).ok().flatten();
    let about = About {
        stiffness,
        caution: Caution::of_scene(&scene),
    };
    match what.path {
        Some(steps) => path(&problem, about, steps, &mut output),
        None => single(&problem, about, what.repeat, &mut output),
    }
}

/// What a state's record says that only the scene knows.
#[derive(Clone, Copy)]
struct About {
    stiffness: Option<Stiffness>,
    caution: Option<Caution>,
}

impl About {
    /// The record of the state a run is in.
    fn state(self, run: &Run) -> Option<Solution> {
        let state = Solution::of(run, self.stiffness)?;
        Some(state.with_caution(self.caution))
    }
}

fn single<W: Write>(
    problem: &Problem,
    about: About,
    repeat: Option<u32>,
    output: &mut Output<W>,
) -> Result<Outcome, Failure> {
    let mut run = Run::new(problem, Start::Straight, Settings::default());
    let mut progress = Progress::new("solving", RESOLUTION);
    finish(&mut run, |run| {
        progress.at((run.share() * f64::from(RESOLUTION)) as u32);
    });
    drop(progress);
    let Some(mut state) = about.state(&run) else {
        return Ok(not_finite(problem));
    };
    let outcome = outcome(&run, problem);
    if let (Some(count), Outcome::Done) = (repeat, &outcome) {
        state.timing_us = Some(timing::measure(problem, count));
    }
    // Whoever stopped reading still gets the exit code.
    reader(output.solution(&state))?;
    Ok(outcome)
}

fn path<W: Write>(
    goal: &Problem,
    about: About,
    steps: u32,
    output: &mut Output<W>,
) -> Result<Outcome, Failure> {
    let (slack, all) = (goal.drive().slackened(), goal.drive());
    let mut target = goal.clone();
    let mut drive = slack.clone();
    target.set_drive(&drive);
    let mut run = Run::new(&target, Start::Straight, Settings::default());
    let mut progress = Progress::new("solving", steps);
    let mut ended = Outcome::Done;
    let share = |step: u32| f64::from(step) / f64::from(steps);
    for step in 0..=steps {
        if step > 0 {
            drive.set_between(&slack, all, share(step));
            target.set_drive(&drive);
            run.retarget(&target);
        }
        finish(&mut run, |_| progress.at(step));
        let Some(state) = about.state(&run) else {
            ended = not_finite(&target);
            break;
        };
        let state = state.on_the_way(share(step.saturating_sub(1)), share(step));
        let told = progress.aside(|| reader(output.path_state(&state)))?;
        ended = outcome(&run, &target);
        if matches!(
            (&ended, told),
            (Outcome::NotConverged(_), _) | (_, Reader::Gone)
        ) {
            break;
        }
    }
    drop(progress);
    reader(output.path_end())?;
    Ok(ended)
}

/// Runs to the end in slices, with a look at the run after each.
pub(super) fn finish(run: &mut Run, mut after_slice: impl FnMut(&Run)) {
    let slice = (SLICE / run.problem().robot().segments).clamp(1, 1024);
    while run.advance(slice) == equilibrium::Progress::Running {
        after_slice(run);
    }
    after_slice(run);
}

/// Done, or why the run did not reach its goal.
pub(super) fn outcome(run: &Run, problem: &Problem) -> Outcome {
    let solution = run.solution();
    if solution.status == Status::Converged {
        return Outcome::Done;
    }
    let goal = driven_shown(problem.drive());
    let reached = driven_shown(&solution.drive);
    let not_there = if run.obstacles_are_placed() {
        ""
    } else {
        " and with obstacles not yet in their place"
    };
    let state = if solution.certificate.holds() {
        "the last good state"
    } else {
        "the last state, whose certificate does not hold"
    };
    Outcome::NotConverged(format!(
        "not converged at {goal}: {}; {state}, at {reached}{not_there}, is printed",
        solution.status.reason()
    ))
}

fn not_finite(goal: &Problem) -> Outcome {
    Outcome::NotConverged(format!(
        "not converged at {}: the numbers of its shape are not finite, so that there is nothing \
         to print",
        driven_shown(goal.drive())
    ))
}
