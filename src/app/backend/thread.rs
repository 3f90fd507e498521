//! Solving on a thread of its own, which looks for orders between any two
//! slices of work.

use super::{Found, Slice, SolverBackend, Timed};
use crate::solving::Order;
use std::collections::VecDeque;
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};
use std::thread::{Builder, JoinHandle};

/// What both threads see.
#[derive(Default)]
struct Mailbox {
    slots: Mutex<Slots>,
    /// Signals an order or the end.
    mail: Condvar,
}

#[derive(Default)]
struct Slots {
    orders: Vec<Order>,
    found: VecDeque<Found>,
    working: bool,
    over: bool,
}

impl Mailbox {
    fn slots(&self) -> MutexGuard<'_, Slots> {
        // What the slots hold is whole even if a thread died between two
        // changes of it.
        self.slots.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// A backend with a thread.
pub struct Thread {
    mailbox: Arc<Mailbox>,
    thread: Option<JoinHandle<()>>,
}

impl Thread {
    /// Starts the thread. It calls `found` whenever there is something to poll.
    ///
    /// # Errors
    /// When the system gives no thread.
    pub fn new(found: impl Fn() + Send + 'static) -> std::io::Result<Self> {
        let mailbox = Arc::new(Mailbox::default());
        let theirs = Arc::clone(&mailbox);
        let thread = Builder::new()
            .name("solver".to_owned())
            .spawn(move || serve(&theirs, found))?;
        Ok(Self {
            mailbox,
            thread: Some(thread),
        })
    }
}

fn serve(mailbox: &Mailbox, found: impl Fn()) {
    let mut executor = Timed::default();
    loop {
        let mut slots = mailbox.slots();
        if slots.over {
            return;
        }
        if !slots.orders.is_empty() {
            // What was found before stays until it is asked for: a path holds
            // for later requests, too, and is not found again for them.
            slots.working = true;
            let orders = std::mem::take(&mut slots.orders);
            drop(slots);
            for order in orders {
                executor.take(order);
            }
        } else if slots.working {
            drop(slots);
            match executor.work() {
                Slice::More => {}
                Slice::Found(result) => {
                    mailbox.slots().found.push_back(result);
                    found();
                }
                Slice::Done => {
                    mailbox.slots().working = false;
                    found();
                }
            }
        } else {
            let _woken = mailbox
                .mail
                .wait(slots)
                .unwrap_or_else(PoisonError::into_inner);
        }
    }
}

impl SolverBackend for Thread {
    fn submit(&mut self, order: Order) {
        self.mailbox.slots().orders.push(order);
        self.mailbox.mail.notify_one();
    }

    fn poll(&mut self) -> Option<Found> {
        self.mailbox.slots().found.pop_front()
    }

    fn wants_frames(&self) -> bool {
        false
    }
}

impl Drop for Thread {
    fn drop(&mut self) {
        self.mailbox.slots().over = true;
        self.mailbox.mail.notify_one();
        if let Some(thread) = self.thread.take() {
            // It ends after its slice; a panic in it has been told already.
            let _ = thread.join();
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::solving::tests::{live, search};
    use crate::solving::{StartFrom, TaskId, Update};
    use std::sync::mpsc::{Receiver, SyncSender, channel, sync_channel};

    /// A thread that stops whenever it has something to tell.
    struct Stopping {
        /// First, so that the thread goes on to its end when this is dropped.
        go: SyncSender<()>,
        told: Receiver<()>,
        thread: Thread,
    }

    impl Stopping {
        fn new() -> Self {
            let (tell, told) = channel();
            let (go, gone) = sync_channel(0);
            let thread = Thread::new(move || {
                // Nobody is there when the test is over.
                let _ = tell.send(());
                let _ = gone.recv();
            });
            let thread = thread.unwrap();
            Self { go, told, thread }
        }

        fn task(&mut self, id: u64) {
            self.thread.submit(Order::Task(TaskId(id), search()));
        }

        /// Waits until it stops: what it has found; nothing where it has nothing
        /// left to do.
        fn stop(&mut self) -> Option<String> {
            self.told.recv().unwrap();
            let found = self.thread.poll()?;
            Some(match found.update {
                Update::Shape(shape) => format!("shape {}", shape.generation),
                Update::Path { course, .. } => format!("path {course}"),
                Update::Share { task, .. } => format!("share of {}", task.0),
                Update::Answer { task, .. } => format!("task {}", task.0),
            })
        }

        fn go(&self) {
            self.go.send(()).unwrap();
        }

        /// Lets it go on to the end of its work: what it finds, without shares.
        fn rest(&mut self) -> Vec<String> {
            let mut all = Vec::new();
            loop {
                self.go();
                match self.stop() {
                    Some(found) => all.push(found),
                    None => break,
                }
            }
            all.retain(|found| !found.starts_with("share"));
            all
        }
    }

    #[test]
    fn live_work_goes_before_tasks_and_these_go_on() {
        let mut thread = Stopping::new();
        for id in 1..=3 {
            thread.task(id);
        }
        assert_eq!(thread.stop().as_deref(), Some("share of 1"));
        for generation in 1..=3 {
            thread.thread.submit(live(generation, StartFrom::Straight));
        }
        let expect = ["shape 3", "path 0", "task 1", "task 2", "task 3"];
        assert_eq!(thread.rest(), expect);
    }

    #[test]
    fn a_task_is_cancelled_while_it_is_done() {
        let mut thread = Stopping::new();
        thread.task(1);
        assert_eq!(thread.stop().as_deref(), Some("share of 1"));
        thread.thread.submit(Order::Cancel(TaskId(1)));
        assert!(thread.rest().is_empty());
        // It takes more.
        thread.task(2);
        assert_eq!(thread.rest(), ["task 2"]);
    }
}
