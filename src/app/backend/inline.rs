//! Solving on the thread that asks, a slice at each poll: for tests, whose
//! pictures must not depend on a race, and where there are no workers.

use super::{Found, Slice, SolverBackend, Timed};
use crate::solving::Request;
use web_time::{Duration, Instant};

/// A backend that solves inside [`SolverBackend::poll`].
#[derive(Debug)]
pub struct Inline {
    job: Timed,
    busy: bool,
    patience: Patience,
}

/// How long one poll may take.
#[derive(Clone, Copy, Debug)]
enum Patience {
    Endless,
    Time(Duration),
    Slices(usize),
}

impl Inline {
    /// Solves everything at once in one poll, however long it takes.
    pub fn to_the_end() -> Self {
        Self {
            job: Timed::default(),
            busy: false,
            patience: Patience::Endless,
        }
    }

    /// Solves for at most about so long in one poll.
    pub fn sliced(patience: Duration) -> Self {
        Self {
            patience: Patience::Time(patience),
            ..Self::to_the_end()
        }
    }

    /// Does so many slices of work in one poll: the same on every machine.
    pub fn by_slices(count: usize) -> Self {
        Self {
            patience: Patience::Slices(count),
            ..Self::to_the_end()
        }
    }
}

impl SolverBackend for Inline {
    fn submit(&mut self, request: Request) {
        self.job.take(request);
        self.busy = true;
    }

    fn poll(&mut self) -> Option<Found> {
        let begin = Instant::now();
        let mut slices = 0;
        while self.busy {
            match self.job.work() {
                Slice::Found(found) => return Some(found),
                Slice::Done => self.busy = false,
                Slice::More => {
                    slices += 1;
                    let over = match self.patience {
                        Patience::Endless => false,
                        Patience::Time(most) => begin.elapsed() > most,
                        Patience::Slices(most) => slices >= most,
                    };
                    if over {
                        return None;
                    }
                }
            }
        }
        None
    }

    fn wants_frames(&self) -> bool {
        self.busy
    }
}
