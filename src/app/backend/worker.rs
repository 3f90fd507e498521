//! Solving in a Web Worker: orders and updates go to and fro as bytes, since
//! the worker shares no memory with the page. Where the worker fails, solving
//! goes on between frames.

use super::{Found, Inline, SolverBackend};
use crate::solving::wire::{read_update, write_order};
use crate::solving::{Order, Queue, Update};
use js_sys::{Array, Uint8Array};
use std::cell::{Cell, RefCell};
use std::collections::VecDeque;
use std::rc::Rc;
use wasm_bindgen::prelude::*;
use web_sys::{ErrorEvent, MessageEvent};
use web_time::Duration;

/// Time for solving between frames where there is no worker.
pub const SLICE: Duration = Duration::from_millis(4);

/// A backend that solves in a Web Worker.
pub struct Worker {
    worker: web_sys::Worker,
    arrived: Rc<Arrived>,
    /// The last request and the tasks that have no answer, for whoever has to
    /// answer them in the worker's place …
    unanswered: Queue,
    /// … which is this one.
    here: Option<Inline>,
    _on_message: Closure<dyn FnMut(MessageEvent)>,
    _on_error: Closure<dyn FnMut(ErrorEvent)>,
}

/// What has come from a worker.
#[derive(Default)]
pub struct Arrived {
    found: RefCell<VecDeque<Found>>,
    failed: Cell<bool>,
}

impl Arrived {
    /// Whether the worker has failed.
    pub fn has_failed(&self) -> bool {
        self.failed.get()
    }

    fn fail(&self, why: &str) {
        if !self.failed.replace(true) {
            log::warn!("the solver's worker has failed, so the window solves by itself: {why}");
        }
    }

    /// Takes a message: an update's bytes after the milliseconds that it
    /// took, or a sentence on why there will be no more.
    fn take(&self, message: &JsValue) {
        if let Some(why) = message.as_string() {
            return self.fail(&why);
        }
        let Some(parts) = message.dyn_ref::<Array>() else {
            return self.fail("it sends what is no message");
        };
        let milliseconds = parts.get(0).as_f64().unwrap_or_default();
        let time = Duration::from_secs_f64(milliseconds.max(0.0) * 1e-3);
        match read_update(&Uint8Array::new(&parts.get(1)).to_vec()) {
            Ok(update) => self.found.borrow_mut().push_back(Found { update, time }),
            Err(error) => self.fail(&error.to_string()),
        }
    }
}

impl Worker {
    /// A backend in a worker that runs `worker.js`; calls `found` whenever
    /// there is something to poll.
    pub fn new(worker: web_sys::Worker, found: impl Fn() + Clone + 'static) -> Self {
        let arrived = Rc::new(Arrived::default());
        let on_message = Closure::<dyn FnMut(MessageEvent)>::new({
            let (arrived, found) = (Rc::clone(&arrived), found.clone());
            move |event: MessageEvent| {
                arrived.take(&event.data());
                found();
            }
        });
        let on_error = Closure::<dyn FnMut(ErrorEvent)>::new({
            let arrived = Rc::clone(&arrived);
            move |event: ErrorEvent| {
                arrived.fail(&event.message());
                found();
            }
        });
        worker.set_onmessage(Some(on_message.as_ref().unchecked_ref()));
        worker.set_onerror(Some(on_error.as_ref().unchecked_ref()));
        Self {
            worker,
            arrived,
            unanswered: Queue::default(),
            here: None,
            _on_message: on_message,
            _on_error: on_error,
        }
    }

    /// What has come from the worker, for whoever wants to know how it is.
    pub fn arrived(&self) -> Rc<Arrived> {
        Rc::clone(&self.arrived)
    }

    fn post(&self, order: &Order) -> Result<(), String> {
        let bytes = write_order(order).map_err(|error| error.to_string())?;
        let bytes = Uint8Array::from(bytes.as_slice());
        let transferred = Array::of1(&bytes.buffer());
        let posted = self.worker.post_message_with_transfer(&bytes, &transferred);
        posted.map_err(|error| format!("{error:?}"))
    }

    /// Where the worker has failed, what solves in its place.
    fn here(&mut self) -> Option<&mut Inline> {
        if self.arrived.has_failed() && self.here.is_none() {
            self.worker.terminate();
            let mut here = Inline::sliced(SLICE);
            for order in std::mem::take(&mut self.unanswered).into_orders() {
                here.submit(order);
            }
            self.here = Some(here);
        }
        self.here.as_mut()
    }
}

impl SolverBackend for Worker {
    fn submit(&mut self, order: Order) {
        if let Some(here) = self.here() {
            return here.submit(order);
        }
        if let Err(why) = self.post(&order) {
            self.arrived.fail(&why);
        }
        self.unanswered.take(order);
    }

    fn poll(&mut self) -> Option<Found> {
        let found = self.arrived.found.borrow_mut().pop_front();
        if let Some(Update::Answer { task, .. }) = found.as_ref().map(|found| &found.update) {
            self.unanswered.remove(*task);
        }
        found.or_else(|| self.here()?.poll())
    }

    fn wants_frames(&self) -> bool {
        let here = self.here.as_ref();
        here.is_some_and(SolverBackend::wants_frames)
    }
}

impl Drop for Worker {
    fn drop(&mut self) {
        self.worker.set_onmessage(None);
        self.worker.set_onerror(None);
        self.worker.terminate();
    }
}
