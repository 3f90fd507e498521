//! Solving on the thread that asks, a slice at each poll: for tests, whose
//! pictures must not depend on a race, and where there are no workers.

use super::{Found, Slice, SolverBackend, Timed};
use crate::solving::Order;
use web_time::{Duration, Instant};

/// A backend that solves inside [`SolverBackend::poll`].
#[derive(Debug)]
pub struct Inline {
    executor: Timed,
    busy: bool,
    patience: Patience,
    /// Time and slices of this look: the polls up to one that finds nothing.
    time: Duration,
    slices: usize,
}

/// How long one look may take.
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
            executor: Timed::default(),
            busy: false,
            patience: Patience::Endless,
            time: Duration::ZERO,
            slices: 0,
        }
    }

    /// Solves for at most about so long in one look, which is the polls up to
    /// one that finds nothing.
    pub fn sliced(patience: Duration) -> Self {
        Self {
            patience: Patience::Time(patience),
            ..Self::to_the_end()
        }
    }

    /// Does so many slices of work in one look: the same on every machine.
    pub fn by_slices(count: usize) -> Self {
        Self {
            patience: Patience::Slices(count),
            ..Self::to_the_end()
        }
    }
}

impl SolverBackend for Inline {
    fn submit(&mut self, order: Order) {
        self.executor.take(order);
        self.busy = true;
    }

    fn poll(&mut self) -> Option<Found> {
        let begin = Instant::now();
        while self.busy {
            match self.executor.work() {
                Slice::Found(found) => {
                    self.time += begin.elapsed();
                    return Some(found);
                }
                Slice::Done => self.busy = false,
                Slice::More => {
                    self.slices += 1;
                    let over = match self.patience {
                        Patience::Endless => false,
                        Patience::Time(most) => self.time + begin.elapsed() > most,
                        Patience::Slices(most) => self.slices >= most,
                    };
                    if over {
                        break;
                    }
                }
            }
        }
        self.time = Duration::ZERO;
        self.slices = 0;
        None
    }

    fn wants_frames(&self) -> bool {
        self.busy
    }
}
