//! Where the executor is that does the window's live work and its tasks: on a
//! thread or in a worker of its own, or between frames. The window never waits:
//! it asks [`SolverBackend::poll`] once a frame.

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

use crate::solving::{Executor, Order, Update, Work};
use web_time::{Duration, Instant};

/// Something that solves while the window goes on.
pub trait SolverBackend {
    /// Gives the executor an order.
    fn submit(&mut self, order: Order);

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
    /// Time spent since the last thing or the last live request, without
    /// pauses: for a shape, on it.
    pub time: Duration,
}

/// An executor with a clock.
#[derive(Debug, Default)]
struct Timed {
    executor: Executor,
    spent: Duration,
}

/// What a slice of timed work led to.
enum Slice {
    More,
    Found(Found),
    Done,
}

impl Timed {
    fn take(&mut self, order: Order) {
        if matches!(order, Order::Live(_)) {
            self.spent = Duration::ZERO;
        }
        self.executor.take(order);
    }

    fn work(&mut self) -> Slice {
        let begin = Instant::now();
        let work = self.executor.work();
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
