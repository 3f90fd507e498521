//! Who does what is asked for: live work first, and in its pauses the tasks,
//! one after the other.

use super::task::Doing;
use super::{Job, Order, Queue, TaskId, Update, Work};
use crate::equilibrium::Progress;

/// A share of a task is told when it has grown by this much: a screen shows no
/// finer one.
const TOLD: f64 = 0.01;

/// Does live work and batches, in slices. It knows no thread and no clock:
/// whoever owns it calls [`Executor::work`] until there is nothing left, and
/// may give it orders between any two calls.
#[derive(Debug, Default)]
pub struct Executor {
    queue: Queue,
    job: Job,
    current: Option<Current>,
}

/// The task that has its turn.
#[derive(Debug)]
struct Current {
    id: TaskId,
    doing: Doing,
    /// The share of it that was told last.
    told: f64,
}

impl Executor {
    /// Takes an order. A live request replaces the one before it, even in the
    /// middle of its solve; a task that is cancelled leads to nothing more.
    pub fn take(&mut self, order: Order) {
        if let Order::Cancel(id) = order {
            self.current.take_if(|current| current.id == id);
        }
        self.queue.take(order);
    }

    /// Works for a moment: on a task only while there is no live work.
    pub fn work(&mut self) -> Work {
        if let Some(request) = self.queue.next_live() {
            self.job.take(request);
        }
        match self.job.work() {
            Work::Done => self.go_on(),
            work => work,
        }
    }

    /// Works on the task that has its turn.
    fn go_on(&mut self) -> Work {
        let next = || {
            let (id, task) = self.queue.next_task()?;
            let doing = Doing::begin(task);
            Some(Current {
                id,
                doing,
                told: 0.0,
            })
        };
        let Some(mut current) = self.current.take().or_else(next) else {
            return Work::Done;
        };
        let task = current.id;
        if current.doing.work() == Progress::Done {
            let answer = Box::new(current.doing.answer());
            return Work::Found(Update::Answer { task, answer });
        }
        let share = current.doing.share();
        let is_news = share >= current.told + TOLD;
        if is_news {
            current.told = share;
        }
        self.current = Some(current);
        if is_news {
            Work::Found(Update::Share { task, share })
        } else {
            Work::More
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::tests::{live, measured, problem, search};
    use super::*;
    use crate::equilibrium::{Settings, Start, solve};
    use crate::experiments::best_pull;
    use crate::solving::{Answer, StartFrom, Task};

    /// What an executor finds, in short, until it has nothing left to do.
    fn found(executor: &mut Executor) -> Vec<String> {
        let mut all = Vec::new();
        loop {
            match executor.work() {
                Work::More => {}
                Work::Done => return all,
                Work::Found(update) => all.extend(name(&update)),
            }
        }
    }

    /// Nothing for a share.
    fn name(update: &Update) -> Option<String> {
        match update {
            Update::Shape(shape) => Some(format!("shape {}", shape.generation)),
            Update::Path { course, .. } => Some(format!("path {course}")),
            Update::Answer { task, .. } => Some(format!("task {}", task.0)),
            Update::Share { .. } => None,
        }
    }

    fn begin(executor: &mut Executor, id: u64) {
        executor.take(Order::Task(TaskId(id), search()));
    }

    /// Works until the task that has its turn has told a share.
    fn half(executor: &mut Executor) {
        while !matches!(executor.work(), Work::Found(Update::Share { .. })) {}
    }

    #[test]
    fn live_work_is_done_before_tasks_that_came_earlier() {
        let mut executor = Executor::default();
        begin(&mut executor, 1);
        begin(&mut executor, 2);
        executor.take(live(1, StartFrom::Straight));
        executor.take(live(2, StartFrom::Last));
        let expect = ["shape 2", "path 0", "task 1", "task 2"];
        assert_eq!(found(&mut executor), expect);
    }

    #[test]
    fn a_task_pauses_for_a_live_request_and_goes_on() {
        let mut executor = Executor::default();
        begin(&mut executor, 1);
        half(&mut executor);
        executor.take(live(1, StartFrom::Straight));
        let mut shares = Vec::new();
        let mut order = Vec::new();
        loop {
            match executor.work() {
                Work::More => {}
                Work::Done => break,
                Work::Found(Update::Share { share, .. }) => shares.push(share),
                Work::Found(update) => {
                    // None came before the live work was done.
                    assert!(shares.is_empty() || order.len() == 2);
                    order.extend(name(&update));
                }
            }
        }
        assert_eq!(order, ["shape 1", "path 0", "task 1"]);
        // From where it was: the first share was told before.
        assert!(shares[0] > TOLD && shares.is_sorted(), "{shares:?}");
    }

    #[test]
    fn a_paused_search_finds_what_an_undisturbed_one_does() {
        let mut executor = Executor::default();
        begin(&mut executor, 1);
        let mut generation = 0;
        let answer = loop {
            match executor.work() {
                Work::More => {}
                Work::Done => panic!("no answer"),
                Work::Found(Update::Share { .. }) => {
                    generation += 1;
                    executor.take(live(generation, StartFrom::Last));
                }
                Work::Found(Update::Answer { answer, .. }) => break *answer,
                Work::Found(_) => {}
            }
        };
        assert!(generation > 10, "{generation}");
        let alone = best_pull(&problem(), &measured(), |_| {});
        match answer {
            Answer::BestPull(fit) => assert_eq!(fit, alone.map(|(_, fit)| fit)),
            other => panic!("{other:?}"),
        }
    }

    #[test]
    fn a_shape_that_is_asked_for_is_the_one_from_straight() {
        let mut executor = Executor::default();
        let problem = problem();
        let task = Task::Shape {
            problem: problem.clone(),
        };
        executor.take(Order::Task(TaskId(1), task));
        let answer = loop {
            match executor.work() {
                Work::Found(Update::Answer { answer, .. }) => break *answer,
                Work::Done => panic!("no answer"),
                Work::More | Work::Found(_) => {}
            }
        };
        let Answer::Shape(shape) = answer else {
            panic!("{answer:?}");
        };
        let alone = solve(&problem, Start::Straight, Settings::default());
        assert_eq!(
            (shape.nodes, shape.energy),
            (alone.nodes.clone(), alone.energy)
        );
    }

    #[test]
    fn a_cancelled_task_leads_to_nothing() {
        let mut executor = Executor::default();
        for id in 1..=3 {
            begin(&mut executor, id);
        }
        // One that has its turn, and one that waits.
        half(&mut executor);
        executor.take(Order::Cancel(TaskId(1)));
        executor.take(Order::Cancel(TaskId(2)));
        assert_eq!(found(&mut executor), ["task 3"]);
        // One that is done already.
        executor.take(Order::Cancel(TaskId(3)));
        assert!(found(&mut executor).is_empty());
    }
}
