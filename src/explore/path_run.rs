//! The run that makes a path: one robot drawn in from pull to pull.

use super::path::{End, Path, PathState};
use crate::equilibrium::{Event, Occurrence, Progress, Run, Settings, Start, Status};
use crate::math::within;
use crate::mechanics::Problem;

/// Which way from the straight robot.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Way {
    /// Drawn in.
    Up,
    /// Let out, to pulls below zero.
    Down,
}

/// A path in the making, advanced in slices. However long these are, the path
/// is the same, bit for bit. Dropping it cancels it.
#[derive(Clone, Debug)]
pub struct PathRun {
    goal: Problem,
    run: Run,
    /// The run at the last state, to go back to where a jump lies between.
    settled: Run,
    /// The run at the straight robot, for the way down.
    straight: Option<Run>,
    way: Way,
    /// Pulls still to be met, the next one last.
    up: Vec<f64>,
    down: Vec<f64>,
    branch: i32,
    /// The nearest pull known to lie past a change of contacts, while it is
    /// closed in on.
    corner: Option<f64>,
    /// Jumps and changes that were closed in on.
    closed_in: usize,
    progress: Progress,
    asked: usize,
    share: f64,
    path: Path,
}

/// Jumps are met by runs to this share of the robot's length: 2 µm of pull on the
/// paper's robot, less than a pixel of a plot of all pulls. A jump nearer than three of
/// them is not closed in on again.
const JUMP_GRAIN: f64 = 1e-5;
/// Changes of contacts are met to twice this share of it: 0.4 µm on the paper's
/// robot, where the cable's tension changes by less than 0.01 g.
const CORNER_GRAIN: f64 = 1e-6;
/// Jumps and changes that are closed in on, so that a robot that chatters costs
/// no more than a hundred states.
const MOST_CLOSED_IN: usize = 48;

impl PathRun {
    /// A run over these pulls, in metres, in any order, and the straight
    /// robot's; those outside the linkage's range are moved to its ends. The
    /// problem's own pull does not matter.
    pub fn new(problem: &Problem, pulls: Vec<f64>) -> Self {
        let (least, most) = problem.pull_range();
        let mut pulls = pulls;
        pulls.retain(|pull| pull.is_finite() && *pull != 0.0);
        for pull in &mut pulls {
            *pull = within(*pull, least, most);
        }
        pulls.sort_by(f64::total_cmp);
        pulls.dedup();
        let (down, up) = pulls.split_at(pulls.partition_point(|pull| *pull < 0.0));
        let mut goal = problem.clone();
        goal.set_pull(0.0);
        let run = Run::new(&goal, Start::Straight, Settings::default());
        Self {
            settled: run.clone(),
            straight: None,
            way: Way::Up,
            up: up.iter().rev().copied().collect(),
            down: down.to_vec(),
            branch: 0,
            corner: None,
            closed_in: 0,
            progress: Progress::Running,
            asked: pulls.len() + 1,
            share: 0.0,
            path: Path {
                length: problem.length(),
                ..Path::default()
            },
            goal,
            run,
        }
    }

    /// A run over `count` pulls from `first` to `last`, in metres, both
    /// included, and the problem's own, so that its solution can be compared
    /// with the path exactly.
    pub fn over(problem: &Problem, first: f64, last: f64, count: usize) -> Self {
        let mut pulls = crate::forces::Sweep::pulls(first, last, count);
        pulls.push(problem.pull());
        Self::new(problem, pulls)
    }

    /// Steps at most `iterations` iterations.
    pub fn advance(&mut self, iterations: usize) -> Progress {
        for _ in 0..iterations {
            if self.progress == Progress::Done {
                break;
            }
            if self.run.advance(1) == Progress::Done {
                self.arrive();
            }
        }
        self.progress
    }

    /// Runs to the end.
    pub fn finish(mut self) -> Path {
        while self.advance(1024) == Progress::Running {}
        self.path
    }

    /// The path as far as it is known.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// The share of the pulls that were met, from 0 to 1; never falls.
    pub fn share(&self) -> f64 {
        self.share
    }

    /// Takes what the run has led to and sends it on.
    fn arrive(&mut self) {
        if self.closes_in() {
            return;
        }
        let settled = self.settled.solution();
        // A corner's near side may have been met and not been taken.
        if settled.status == Status::Converged {
            self.path
                .take(self.way, PathState::of(settled, self.branch));
        }
        let solution = self.run.solution();
        let jumps = solution
            .events
            .iter()
            .filter(|event| is_jump(event))
            .count() as i32;
        self.branch += match self.way {
            Way::Up => jumps,
            Way::Down => -jumps,
        };
        self.path.note(self.way, &solution.events);
        // The end of a branch is an equilibrium like any other.
        if solution.certificate.holds() {
            self.path
                .take(self.way, PathState::of(solution, self.branch));
        }
        let converged = solution.status == Status::Converged;
        if !converged {
            let end = Some(End {
                pull: solution.pull,
                status: solution.status.clone(),
            });
            match self.way {
                Way::Up => self.path.end = end,
                Way::Down => self.path.start = end,
            }
        }
        self.go_on(converged);
    }

    /// Goes back to before a jump or a change of contacts and on in smaller
    /// steps, unless it is met closely enough, so that the path has both sides
    /// of it. Without this, what is read off between states would be rounded at
    /// every corner.
    fn closes_in(&mut self) -> bool {
        let length = self.goal.length();
        let (from, to) = (self.settled.solution().pull, self.goal.pull());
        let solution = self.run.solution();
        let begins = self.settled.solution().status == Status::Unfinished;
        if begins {
            return false;
        }
        let converged = solution.status == Status::Converged;
        let jump = solution.events.iter().find(|event| is_jump(event));
        let jump = jump.map(|event| event.pull);
        if let Some(at) = jump
            && (at - from).abs() > 3.0 * JUMP_GRAIN * length
            && self.closed_in < MOST_CLOSED_IN
        {
            self.closed_in += 1;
            self.corner = None;
            self.waiting().push(to);
            if at != to {
                self.waiting().push(at);
            }
            let before = at - 2.0 * JUMP_GRAIN * length * (to - from).signum();
            self.go_back_towards(before);
            return true;
        }
        let grain = CORNER_GRAIN * length;
        let changes = solution.events.iter().any(is_change);
        match self.corner {
            // Not there yet.
            Some(corner) if !changes && converged && to != corner => {
                self.settled = self.run.clone();
                let halfway = 0.5 * (to + corner);
                let near = (corner - to).abs() <= 2.0 * grain;
                self.go_back_towards(if near { corner } else { halfway });
                true
            }
            _ if changes
                && jump.is_none()
                && (to - from).abs() > 2.0 * grain
                && self.closed_in < MOST_CLOSED_IN =>
            {
                if self.corner.is_none() {
                    self.waiting().push(to);
                }
                self.corner = Some(to);
                self.go_back_towards(0.5 * (from + to));
                true
            }
            _ => {
                self.closed_in += usize::from(self.corner.take().is_some());
                false
            }
        }
    }

    /// Sends the run on from the last state but to another pull.
    fn go_back_towards(&mut self, pull: f64) {
        self.goal.set_pull(pull);
        self.run.clone_from(&self.settled);
        self.run.retarget(&self.goal);
    }

    fn waiting(&mut self) -> &mut Vec<f64> {
        match self.way {
            Way::Up => &mut self.up,
            Way::Down => &mut self.down,
        }
    }

    fn go_on(&mut self, converged: bool) {
        let begins = self.settled.solution().status == Status::Unfinished;
        if begins && converged && !self.down.is_empty() {
            self.straight = Some(self.run.clone());
        }
        if !converged {
            self.waiting().clear();
        }
        if self.way == Way::Up && self.up.is_empty() {
            // Without a straight robot there is no way down either.
            match self.straight.take() {
                Some(straight) => {
                    self.way = Way::Down;
                    self.branch = 0;
                    self.run = straight;
                }
                None => self.down.clear(),
            }
        }
        // Closing in asks for more pulls than there were.
        let left = (self.up.len() + self.down.len()).min(self.asked);
        match self.waiting().pop() {
            Some(pull) => {
                self.share = self.share.max(1.0 - left as f64 / self.asked as f64);
                self.settled = self.run.clone();
                self.goal.set_pull(pull);
                self.run.retarget(&self.goal);
            }
            None => {
                self.share = 1.0;
                self.progress = Progress::Done;
            }
        }
    }
}

impl Path {
    /// Adds a state at the end that the way leads to, unless it is there.
    fn take(&mut self, way: Way, state: PathState) {
        if self.states.iter().any(|known| known.pull == state.pull) {
            return;
        }
        match way {
            Way::Up => self.states.push(state),
            Way::Down => self.states.insert(0, state),
        }
    }

    /// Adds events at the end that the way leads to.
    fn note(&mut self, way: Way, events: &[Event]) {
        match way {
            Way::Up => self.events.extend_from_slice(events),
            Way::Down => {
                self.events.splice(0..0, events.iter().rev().copied());
            }
        }
    }
}

fn is_jump(event: &Event) -> bool {
    matches!(event.what, Occurrence::Jump { .. })
}

fn is_change(event: &Event) -> bool {
    matches!(
        event.what,
        Occurrence::ContactMade { .. } | Occurrence::ContactLost { .. }
    )
}
