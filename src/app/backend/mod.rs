//! Where live solving happens: on a thread or in a worker of its own, or
//! between frames. The window never waits: it asks [`SolverBackend::poll`]
//! once a frame.

mod inline;
#[cfg(not(target_arch = "wasm32"))]
mod thread;
#[cfg(all(target_arch = "wasm32", feature = "web"))]
mod worker;

pub use inline::Inline;
#[cfg(not(target_arch = "wasm32"))]
pub use thread::Thread;
#[cfg(all(target_arch = "wasm32", feature = "web"))]
pub use worker::{Arrived, SLICE, Worker};

use crate::solving::{Job, Request, Update, Work};
use web_time::{Duration, Instant};

/// Something that solves while the window goes on.
pub trait SolverBackend {
    /// Replaces whatever is being solved.
    fn submit(&mut self, request: Request);

    /// The next thing that was found, if any; never waits.
    fn poll(&mut self) -> Option<Found>;

    /// Whether it goes on only when it is polled.
    fn wants_frames(&self) -> bool;
}

/// Something that was found, and how long it took.
#[derive(Clone, Debug)]
pub struct Found {
    /// What.
    pub update: Update,
    /// Time spent on it, without pauses.
    pub time: Duration,
}

/// A job with a clock.
#[derive(Debug, Default)]
struct Timed {
    job: Job,
    spent: Duration,
}

/// What a slice of timed work led to.
enum Slice {
    More,
    Found(Found),
    Done,
}

impl Timed {
    fn take(&mut self, request: Request) {
        self.spent = Duration::ZERO;
        self.job.take(request);
    }

    fn work(&mut self) -> Slice {
        let begin = Instant::now();
        let work = self.job.work();
        self.spent += begin.elapsed();
        match work {
            Work::More => Slice::More,
            Work::Done => Slice::Done,
            Work::Found(update) => {
                let time = std::mem::take(&mut self.spent);
                Slice::Found(Found { update, time })
            }
        }
    }
}
