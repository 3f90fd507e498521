//! The live solution: what was asked of the solver, what it has answered, and
//! the drawing of it.

use crate::equilibrium::{Caution, Event, Occurrence, Solution, Solved, Status};
use crate::explore::Path;
use crate::geometry::Vector;
use crate::mechanics::Problem;
use crate::solving::{Request, Shape, StartFrom};
use crate::view::{Drawing, Notes, draw, draw_on_the_way};
use std::borrow::Cow;
use std::collections::VecDeque;
use std::sync::Arc;
use web_time::Duration;

/// A jump of the robot from one shape to another.
#[derive(Clone, Debug, PartialEq)]
pub struct Leap {
    /// The jump itself.
    pub jump: Event,
    /// The backbone's nodes in the shape that was known before, in metres.
    pub backbone: Vec<Vector>,
}

/// A shape that the solver has answered with, and the problem it was asked for.
#[derive(Clone, Debug)]
pub struct Answered {
    /// The request it answers.
    pub generation: u64,
    /// The solution with its problem: that of the request.
    pub solved: Solved,
    /// What it does not promise.
    pub cautions: Vec<Caution>,
}

/// Requests that are kept until they, or later ones, are answered: a second's or
/// more while something is dragged. An answer to an older one is not shown.
const OPEN: usize = 256;

/// The last of the solver's live answers.
pub struct Live {
    /// Requests made.
    generation: u64,
    asked: Problem,
    /// The problems of requests that may be answered yet, by generation.
    open: VecDeque<(u64, Problem)>,
    shape: Option<Answered>,
    /// How long the last answer took.
    time: Duration,
    path: Option<Arc<Path>>,
    /// Whether the path is that of the problem asked for.
    path_is_current: bool,
    /// Counts the robots and obstacles asked for.
    course: u64,
    /// The first request after the last start from the straight robot.
    start: u64,
    leap: Option<Leap>,
    drawing: Drawing,
    /// Counts the changes of the drawing.
    revision: u64,
    /// Counts the paths.
    path_revision: u64,
}

impl Live {
    /// No answer yet, and nothing asked, of this problem.
    pub fn new(problem: &Problem, notes: &Notes) -> Self {
        Self {
            generation: 0,
            asked: problem.clone(),
            open: VecDeque::new(),
            shape: None,
            time: Duration::ZERO,
            path: None,
            path_is_current: false,
            course: 0,
            start: 0,
            leap: None,
            drawing: draw(&Solved::unsolved(problem.clone()), notes),
            revision: 0,
            path_revision: 0,
        }
    }

    /// The request for a shape, which is waited for from now on. `span` is that
    /// of [`Request::span`].
    #[must_use = "it is to be given to the solver"]
    pub fn ask(&mut self, problem: &Problem, from: StartFrom, span: (f64, f64)) -> Request {
        if !shares_path(&self.asked, problem) {
            self.path_is_current = false;
            self.course += 1;
        }
        self.generation += 1;
        if from == StartFrom::Straight {
            self.start = self.generation;
            self.leap = None;
        }
        self.asked.clone_from(problem);
        if self.open.len() == OPEN {
            self.open.pop_front();
        }
        self.open.push_back((self.generation, problem.clone()));
        Request {
            generation: self.generation,
            course: self.course,
            problem: problem.clone(),
            from,
            span,
        }
    }

    /// Takes a shape that took so long. Whether it is news.
    pub fn take_shape(&mut self, shape: Shape, time: Duration) -> bool {
        // An answer to an older request shows less than what is known already,
        // and one from before the last start is of another robot.
        let newest = self.shape.as_ref().map_or(0, |known| known.generation);
        if shape.generation <= newest || shape.generation < self.start {
            return false;
        }
        let Some(answered) = self.answered(shape) else {
            return false;
        };
        // Of several answers in one frame each may be a leap.
        let leap = self.leap_to(&answered.solved, newest);
        self.leap = leap.or(self.leap.take());
        self.shape = Some(answered);
        self.time = time;
        true
    }

    /// A shape with the problem that it was asked for, by its generation:
    /// the only place where what the solver sends is put together with what it
    /// belongs to.
    fn answered(&mut self, shape: Shape) -> Option<Answered> {
        self.open
            .retain(|(generation, _)| *generation >= shape.generation);
        let is_its_own = |(generation, _): &mut _| *generation == shape.generation;
        let (generation, problem) = self.open.pop_front_if(is_its_own)?;
        Some(Answered {
            generation,
            solved: Solved::pair(problem, shape.solution)?,
            cautions: shape.cautions,
        })
    }

    /// Takes a path of this course.
    pub fn take_path(&mut self, course: u64, path: Box<Path>) {
        self.path = Some(Arc::from(path));
        self.path_revision += 1;
        self.path_is_current = course == self.course;
    }

    /// What the robot left if it jumped to this solution from the known shape,
    /// which answers the request `newest`.
    fn leap_to(&self, solution: &Solution, newest: u64) -> Option<Leap> {
        let mut events = solution.events.iter().rev();
        let jump = events.find(|event| matches!(event.what, Occurrence::Jump { .. }))?;
        let left = self.solution().filter(|_| newest >= self.start)?;
        Some(Leap {
            jump: *jump,
            backbone: left.backbone().collect(),
        })
    }

    /// The jump that led to the last answer, told once.
    pub fn take_leap(&mut self) -> Option<Leap> {
        self.leap.take()
    }

    /// Draws the scene as it is asked for, with the robot as it is known.
    pub fn redraw(&mut self, notes: &Notes) {
        self.drawing = draw_on_the_way(&self.solved(), &self.asked, notes);
        self.revision += 1;
    }

    /// The problem last asked for.
    pub fn problem(&self) -> &Problem {
        &self.asked
    }

    /// The last answer.
    pub fn shape(&self) -> Option<&Answered> {
        self.shape.as_ref()
    }

    /// What the robot does along its pull, as far as it is known: perhaps of
    /// a scene a moment ago, see [`Live::path_is_current`].
    pub fn path(&self) -> Option<&Arc<Path>> {
        self.path.as_ref()
    }

    /// Counts the changes of [`Live::path`].
    pub fn path_revision(&self) -> u64 {
        self.path_revision
    }

    /// Whether the path is that of the problem last asked for.
    pub fn path_is_current(&self) -> bool {
        self.path_is_current
    }

    /// Whether the shape shown is on another branch than the one that the
    /// straight robot comes to.
    pub fn is_on_another_branch(&self) -> bool {
        let path = self.path.as_ref().filter(|_| self.path_is_current);
        match (path, self.solution()) {
            (Some(path), Some(solution)) if self.is_settled() => path.differs_from(solution),
            _ => false,
        }
    }

    /// Whether friction keeps a shape that the straight robot does not come to: it
    /// remembers the way.
    pub fn has_history(&self) -> bool {
        let rubs = |solution: &Solved| !solution.drive.friction.is_none();
        self.solution().is_some_and(rubs) && self.is_on_another_branch()
    }

    /// How long the last answer took.
    pub fn time(&self) -> Duration {
        self.time
    }

    /// The last answer's solution, with its problem.
    pub fn solution(&self) -> Option<&Solved> {
        self.shape.as_ref().map(|shape| &shape.solved)
    }

    /// The same or, where there is no answer yet, the problem last asked for
    /// without a shape.
    pub fn solved(&self) -> Cow<'_, Solved> {
        let nothing = || Cow::Owned(Solved::unsolved(self.asked.clone()));
        self.solution().map_or_else(nothing, Cow::Borrowed)
    }

    /// What the last answer does not promise; nothing while a request has no
    /// answer yet.
    pub fn cautions(&self) -> &[Caution] {
        match &self.shape {
            Some(shape) if !self.is_waiting() => &shape.cautions,
            _ => &[],
        }
    }

    /// Whether what is shown is the certified answer to what was last asked.
    pub fn is_settled(&self) -> bool {
        self.shape.as_ref().is_some_and(|shape| {
            shape.generation == self.generation
                && shape.solved.status == Status::Converged
                && shape.solved.certificate.holds()
        })
    }

    /// Whether the last request has no answer yet.
    pub fn is_waiting(&self) -> bool {
        self.shape
            .as_ref()
            .is_none_or(|shape| shape.generation < self.generation)
    }

    /// The picture of all this.
    pub fn drawing(&self) -> &Drawing {
        &self.drawing
    }

    /// Counts the changes of [`Live::drawing`].
    pub fn revision(&self) -> u64 {
        self.revision
    }
}

/// Whether what one robot does along the pull of its first cable the other does, too.
fn shares_path(a: &Problem, b: &Problem) -> bool {
    let others = |problem: &'_ Problem| problem.drive().cables.get(1..).map(<[_]>::to_vec);
    a.same_but_for_pull(b) && others(a) == others(b)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{Cable, Drive, Mechanics, Scene};
    use crate::solving::{Job, Update, Work};

    const SPAN: (f64, f64) = (0.0, 0.012);

    fn problem(edit: impl FnOnce(&mut Scene)) -> Problem {
        let text = include_str!("../../../assets/scenes/one-disc.toml");
        let mut scene = Scene::from_toml(text).unwrap();
        edit(&mut scene);
        Problem::new(&scene).unwrap()
    }

    fn pulled(pull_mm: f64) -> Problem {
        problem(|scene| scene.set_pull_mm(pull_mm))
    }

    fn longer() -> Problem {
        problem(|scene| scene.robot.length_mm += 10.0)
    }

    /// All that a request leads to.
    fn solve(job: &mut Job, request: Request) -> Vec<Update> {
        job.take(request);
        let mut found = Vec::new();
        loop {
            match job.work() {
                Work::More => {}
                Work::Done => return found,
                Work::Found(update) => found.push(update),
            }
        }
    }

    fn take(live: &mut Live, found: Vec<Update>) {
        for update in found {
            match update {
                Update::Shape(shape) => {
                    live.take_shape(*shape, Duration::ZERO);
                }
                Update::Path { course, path } => live.take_path(course, path),
                other => panic!("{other:?}"),
            }
        }
    }

    /// A robot that is solved, and answers that were not looked at yet.
    fn solved() -> (Live, Job, Vec<Update>) {
        let mut job = Job::default();
        let mut live = Live::new(&pulled(4.0), &Notes::default());
        let request = live.ask(&pulled(4.0), StartFrom::Straight, SPAN);
        let found = solve(&mut job, request);
        (live, job, found)
    }

    #[test]
    fn a_path_that_was_found_before_the_next_request_is_shown() {
        let (mut live, mut job, mut found) = solved();
        let request = live.ask(&pulled(4.5), StartFrom::Last, SPAN);
        let more = solve(&mut job, request);
        // The same path holds.
        assert_eq!((found.len(), more.len()), (2, 1));
        found.extend(more);
        take(&mut live, found);
        assert!(live.is_settled() && live.path_is_current());
        assert!(!live.path().unwrap().states.is_empty());
    }

    #[test]
    fn a_robot_that_was_another_for_a_moment_has_its_path() {
        let (mut live, mut job, found) = solved();
        take(&mut live, found);
        assert!(live.path_is_current());
        // Replaced before anyone has seen it.
        let _ = live.ask(&longer(), StartFrom::Last, SPAN);
        assert!(!live.path_is_current());
        let request = live.ask(&pulled(4.0), StartFrom::Last, SPAN);
        let found = solve(&mut job, request);
        take(&mut live, found);
        assert!(live.is_settled() && live.path_is_current());
        assert_eq!(live.path().unwrap().length, pulled(4.0).length());
    }

    #[test]
    fn another_cable_that_is_drawn_in_has_another_path() {
        let strung = |pull_mm: f64| {
            problem(|scene| {
                scene.model.mechanics = Mechanics::Sliding;
                scene.robot.bending_stiffness_nmm2 = Some(8000.0);
                let first = scene.cable(0);
                scene.robot.cable_offset_mm = None;
                scene.actuation = None;
                let drive = Drive::PullMm(pull_mm);
                let offset_mm = -first.offset_mm;
                let second = Cable {
                    drive,
                    offset_mm,
                    ..first
                };
                scene.cables = vec![first, second];
            })
        };
        let mut live = Live::new(&strung(-6.0), &Notes::default());
        let course = |request: Request| request.course;
        let first = course(live.ask(&strung(-6.0), StartFrom::Straight, SPAN));
        assert_eq!(
            course(live.ask(&strung(-6.0), StartFrom::Last, SPAN)),
            first
        );
        assert_ne!(
            course(live.ask(&strung(-5.0), StartFrom::Last, SPAN)),
            first
        );
    }

    #[test]
    fn an_answer_belongs_to_the_problem_that_it_was_asked_for() {
        let (mut live, _, found) = solved();
        let _ = live.ask(&longer(), StartFrom::Last, SPAN);
        take(&mut live, found);
        assert!(live.is_waiting());
        let known = live.solution().unwrap();
        assert_eq!(known.problem().length(), pulled(4.0).length());
        assert_eq!(live.problem().length(), longer().length());
    }

    #[test]
    fn an_answer_to_a_request_that_is_forgotten_is_not_shown() {
        let (mut live, mut job, found) = solved();
        for _ in 0..OPEN {
            let _ = live.ask(&pulled(4.5), StartFrom::Last, SPAN);
        }
        take(&mut live, found);
        assert!(live.shape().is_none());
        let request = live.ask(&pulled(5.0), StartFrom::Last, SPAN);
        let found = solve(&mut job, request);
        take(&mut live, found);
        assert!(live.is_settled() && live.open.is_empty());
    }

    #[test]
    fn an_answer_from_before_the_last_start_is_not_shown() {
        let (mut live, mut job, found) = solved();
        let request = live.ask(&longer(), StartFrom::Straight, SPAN);
        take(&mut live, found);
        assert!(live.shape().is_none());
        let found = solve(&mut job, request);
        take(&mut live, found);
        assert!(live.is_settled());
    }
}
