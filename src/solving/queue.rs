//! What waits to be done: of live requests the newest, of tasks all.

use super::{Order, Request, StartFrom, Task, TaskId};
use std::collections::VecDeque;

/// Orders that nobody has begun yet.
#[derive(Debug, Default)]
pub struct Queue {
    live: Option<Request>,
    tasks: VecDeque<(TaskId, Task)>,
}

impl Queue {
    /// Takes an order. A live request replaces the one that waits; a task comes
    /// after those that wait; one that is cancelled waits no more.
    pub fn take(&mut self, order: Order) {
        match order {
            Order::Live(mut request) => {
                // That one was to follow the robot from its start anew. The new
                // one goes on from there, and not from what was before.
                let replaced = self.live.as_ref();
                if replaced.is_some_and(|it| it.from == StartFrom::Straight) {
                    request.from = StartFrom::Straight;
                }
                self.live = Some(request);
            }
            Order::Task(id, task) => self.tasks.push_back((id, task)),
            Order::Cancel(id) => self.remove(id),
        }
    }

    /// Forgets a task, if it waits.
    pub fn remove(&mut self, id: TaskId) {
        self.tasks.retain(|(waiting, _)| *waiting != id);
    }

    /// The newest live request, if there is one that nobody has been given.
    pub fn next_live(&mut self) -> Option<Request> {
        self.live.take()
    }

    /// The task that waits longest.
    pub fn next_task(&mut self) -> Option<(TaskId, Task)> {
        self.tasks.pop_front()
    }

    /// All that waits, as orders that lead to the same.
    pub fn into_orders(self) -> impl Iterator<Item = Order> {
        let tasks = self.tasks.into_iter();
        let tasks = tasks.map(|(id, task)| Order::Task(id, task));
        self.live.map(Order::Live).into_iter().chain(tasks)
    }
}

#[cfg(test)]
mod tests {
    use super::super::tests::{live, search};
    use super::*;

    #[test]
    fn of_live_requests_the_newest_is_done() {
        let mut queue = Queue::default();
        for generation in 1..=3 {
            queue.take(live(generation, StartFrom::Last));
        }
        assert_eq!(queue.next_live().unwrap().generation, 3);
        assert!(queue.next_live().is_none());
    }

    #[test]
    fn a_start_that_was_replaced_is_made_all_the_same() {
        let mut queue = Queue::default();
        queue.take(live(1, StartFrom::Straight));
        queue.take(live(2, StartFrom::Last));
        assert_eq!(queue.next_live().unwrap().from, StartFrom::Straight);
        // The next one goes on from there.
        queue.take(live(3, StartFrom::Last));
        assert_eq!(queue.next_live().unwrap().from, StartFrom::Last);
    }

    #[test]
    fn what_waits_can_wait_elsewhere() {
        let mut queue = Queue::default();
        queue.take(Order::Task(TaskId(1), search()));
        queue.take(Order::Task(TaskId(2), search()));
        queue.take(live(5, StartFrom::Last));
        queue.remove(TaskId(1));
        let mut other = Queue::default();
        queue.into_orders().for_each(|order| other.take(order));
        assert_eq!(other.next_live().unwrap().generation, 5);
        assert_eq!(other.next_task().unwrap().0, TaskId(2));
        assert!(other.next_task().is_none());
    }

    #[test]
    fn all_tasks_are_done_in_their_order() {
        let mut queue = Queue::default();
        for id in 1..=4 {
            queue.take(Order::Task(TaskId(id), search()));
        }
        queue.take(Order::Cancel(TaskId(2)));
        queue.take(Order::Cancel(TaskId(9)));
        let done = std::iter::from_fn(|| queue.next_task());
        let done: Vec<_> = done.map(|(id, _)| id.0).collect();
        assert_eq!(done, [1, 3, 4]);
    }
}
