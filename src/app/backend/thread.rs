//! Solving on a thread of its own. The mailbox holds one request: a newer one
//! replaces it, and is looked for between any two slices of work.

use super::{Found, Slice, SolverBackend, Timed};
use crate::solving::Request;
use std::collections::VecDeque;
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};
use std::thread::{Builder, JoinHandle};

/// What both threads see.
#[derive(Default)]
struct Mailbox {
    slots: Mutex<Slots>,
    /// Signals a request or the end.
    mail: Condvar,
}

#[derive(Default)]
struct Slots {
    request: Option<Request>,
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
    let mut job = Timed::default();
    loop {
        let mut slots = mailbox.slots();
        if slots.over {
            return;
        }
        if let Some(request) = slots.request.take() {
            // What was found before stays until it is asked for: a path holds
            // for later requests, too, and is not found again for them.
            slots.working = true;
            drop(slots);
            job.take(request);
        } else if slots.working {
            drop(slots);
            match job.work() {
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
    fn submit(&mut self, request: Request) {
        self.mailbox.slots().request = Some(request);
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
