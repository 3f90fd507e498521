//! A bar on standard error for whoever waits longer than a second at a
//! terminal. Everyone else sees nothing of it.

use std::io::{self, IsTerminal};
use std::time::{Duration, Instant};

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

/// A wait shorter than this needs no bar.
const PATIENCE: Duration = Duration::from_secs(1);

/// A progress bar that appears late and is gone when dropped.
pub(super) struct Progress {
    bar: ProgressBar,
    /// When to appear; `None` where it has, or never will.
    appears: Option<Instant>,
}

impl Progress {
    /// A bar of so many steps.
    pub fn new(what: &'static str, steps: u32) -> Self {
        let hidden = ProgressDrawTarget::hidden();
        let bar = ProgressBar::with_draw_target(Some(steps.into()), hidden).with_message(what);
        let template = "{msg} [{bar:30}] {percent} %, {elapsed}";
        if let Ok(style) = ProgressStyle::with_template(template) {
            bar.set_style(style.progress_chars("=> "));
        }
        let watched = io::stderr().is_terminal();
        Self {
            bar,
            appears: watched.then(|| Instant::now() + PATIENCE),
        }
    }

    /// Moves the bar to a step.
    pub fn at(&mut self, step: u32) {
        if self.appears.is_some_and(|time| time <= Instant::now()) {
            self.appears = None;
            self.bar.set_draw_target(ProgressDrawTarget::stderr());
        }
        self.bar.set_position(step.into());
    }

    /// Says something else than what the bar was made with.
    pub fn say(&self, what: String) {
        self.bar.set_message(what);
    }

    /// Does something that may write to the same terminal.
    pub fn aside<T>(&self, act: impl FnOnce() -> T) -> T {
        self.bar.suspend(act)
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        self.bar.finish_and_clear();
    }
}
