//! The pull whose shape is nearest to a measured one, over the whole branch.
//!
//! The branch is followed from the straight robot in steps, both ways. Between
//! two shapes a and b of it, whose nodes are δ apart, a shape a share t of the
//! straight way has at least the mean square distance
//!
//! ```text
//! (1 − t) ρ_a² + t ρ_b² − t (1 − t) δ²
//! ```
//!
//! with ρ the RMS distances of both (Stewart's theorem): exactly that where
//! points know their nodes. Less how far the branch bows out from the straight way, the least of
//! it bounds what may be found between them. Pieces whose bound is below the
//! best distance known are halved, the lowest first, until there are none. Each
//! is solved from its near end, so that every shape is one that the robot comes
//! to when it is drawn in.

use super::shape_fit::rms_up_to;
use super::{Measured, ShapeFit, compare};
use crate::contact::Contact;
use crate::equilibrium::{Progress, Run, Settings, Solution, Solved, Start, Status};
use crate::geometry::Vector;
use crate::mechanics::{CableState, Drive, Problem};
use crate::robot::PlanarNode;
use serde::{Deserialize, Serialize};
use std::f64::consts::TAU;
use std::rc::Rc;

/// Why there is no best pull.
#[derive(Clone, Debug, PartialEq, thiserror::Error, Serialize, Deserialize)]
pub enum ShapeError {
    /// The robot does not even get away from its start.
    #[error("no pull of this robot can be solved for: {}", .0.reason())]
    NotReached(Status),
}

/// Steps along the branch, over the cable offset: the runs' own.
const STEP: f64 = 1.0 / 16.0;
/// Most steps at once where the shape is far off.
const STRIDE: f64 = 4.0;
/// Turns of the tip that the search goes through either way, and at most as
/// much cable as the robot is long.
const TURNS: f64 = 20.0;
/// Pieces shorter than this, over the length, are not halved: 0.2 nm of pull on
/// the paper's robot.
const GRAIN: f64 = 1e-9;
/// Nor are those that may be nearer by less than this, over the length.
const GAIN: f64 = 1e-11;
/// How far a step may bow out, over the distance of its ends: a corner of 90°
/// does.
const BOW: f64 = 0.5;
/// A half of it bows out by a quarter, where it has no corner.
const BOW_OF_HALF: f64 = 0.25;
/// A shape is far off that is worse than the best by this many times what it
/// moves in the longest step: then the step's bound is above it.
const FAR_OFF: f64 = 2.0;
/// Halvings before the best known is taken for the best there is: far more than
/// any shape needs that moves at all.
const MOST_HALVINGS: usize = 5000;
/// The share of the search's time that goes into the steps, about.
const STEPPING: f64 = 0.8;

/// Iterations between two looks at how far a search is that nobody interrupts.
const SLICE: usize = 1024;

/// The robot at the pull whose shape has the least RMS distance from a measured
/// one, with its distances. The search tells `progress` what share of it is
/// done, from 0 to 1, after each solve.
///
/// # Errors
/// If the robot cannot be solved for at all.
pub fn best_pull(
    problem: &Problem,
    measured: &Measured,
    mut progress: impl FnMut(f64),
) -> Result<(Solved, ShapeFit), ShapeError> {
    let mut search = PullSearch::new(problem.clone(), measured.clone());
    let mut told = None;
    loop {
        let ended = search.advance(SLICE) == Progress::Done;
        if told.replace(search.share()) != Some(search.share()) {
            progress(search.share());
        }
        if ended {
            return search.finish();
        }
    }
}

/// A search for the best pull in the making, advanced in slices. However long
/// these are, it finds the same, bit for bit. Dropping it cancels it.
#[derive(Debug)]
pub struct PullSearch {
    problem: Problem,
    measured: Measured,
    phase: Phase,
    best: Option<Best>,
    /// Pieces that may hold something better than the best.
    open: Vec<Piece>,
    /// Halvings begun.
    halvings: usize,
    /// How often the most halved piece was.
    deepest: u32,
    share: f64,
}

/// What the next call of [`PullSearch::advance`] does.
#[derive(Debug)]
enum Phase {
    /// Follows the branch.
    Stepping(Box<Walk>),
    /// Solves for the middle of a piece.
    Halving(Box<(Piece, Run)>),
    /// Nothing.
    Done(Result<(), ShapeError>),
}

/// The way along the branch, from the straight robot.
#[derive(Debug)]
struct Walk {
    way: Way,
    target: Problem,
    run: Run,
    before: Option<Rc<Place>>,
    /// How far the shape moves in a step, in metres; the robot's length where
    /// that is not known yet.
    moved: f64,
    /// How far it has come, in metres of pull, whichever way.
    pull: f64,
}

/// Which way from the straight robot.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Way {
    /// Drawn in.
    Up,
    /// Let out, to pulls below zero.
    Down,
}

impl Walk {
    fn new(problem: &Problem, way: Way) -> Self {
        let target = at(problem, 0.0);
        Self {
            way,
            run: Run::new(&target, Start::Straight, Settings::default()),
            target,
            before: None,
            moved: problem.robot().length,
            pull: 0.0,
        }
    }
}

/// A shape of the branch: of its solution no more than is compared with others
/// and than a run starts from, for thousands may be open.
#[derive(Debug)]
struct Place {
    pull: f64,
    drive: Drive,
    cables: Vec<CableState>,
    nodes: Vec<PlanarNode>,
    turns: Vec<f64>,
    contacts: Vec<Contact>,
    /// Its RMS distance, in metres, or something below it that is far off.
    rms: f64,
}

impl Place {
    fn new(solution: &Solution, rms: f64) -> Self {
        Self {
            pull: solution.pull,
            drive: solution.drive.clone(),
            cables: solution.cables.clone(),
            nodes: solution.nodes.clone(),
            turns: solution.turns.clone(),
            contacts: solution.contacts.clone(),
            rms,
        }
    }

    /// What a run can start from.
    fn solved(&self, problem: &Problem) -> Option<Solved> {
        let solution = Solution {
            pull: self.pull,
            drive: self.drive.clone(),
            cables: self.cables.clone(),
            nodes: self.nodes.clone(),
            turns: self.turns.clone(),
            contacts: self.contacts.clone(),
            ..Solution::default()
        };
        Solved::pair(problem.clone(), solution)
    }
}

/// The nearest shape that is known.
#[derive(Debug)]
struct Best {
    solved: Solved,
    /// Its RMS distance, in metres.
    rms: f64,
}

/// A piece of the branch, from a shape to one that the robot comes to from it.
#[derive(Debug)]
struct Piece {
    from: Rc<Place>,
    to: Rc<Place>,
    /// How far the branch may bow out between them.
    bow: f64,
    /// Below every distance between them.
    bound: f64,
    /// How often it was halved.
    halved: u32,
}

fn at(problem: &Problem, pull: f64) -> Problem {
    let mut there = problem.clone();
    there.set_pull(pull);
    there
}

impl PullSearch {
    /// A search for the pull whose shape is nearest to a measured one. The
    /// problem's own pull does not matter.
    pub fn new(problem: Problem, measured: Measured) -> Self {
        Self {
            phase: Phase::Stepping(Box::new(Walk::new(&problem, Way::Up))),
            problem,
            measured,
            best: None,
            open: Vec::new(),
            halvings: 0,
            deepest: 0,
            share: 0.0,
        }
    }

    /// Goes on with the search for about so many iterations.
    pub fn advance(&mut self, iterations: usize) -> Progress {
        let run = match &mut self.phase {
            Phase::Stepping(walk) => &mut walk.run,
            Phase::Halving(halving) => &mut halving.1,
            Phase::Done(_) => return Progress::Done,
        };
        if run.advance(iterations) == Progress::Running {
            return Progress::Running;
        }
        self.phase = match std::mem::replace(&mut self.phase, Phase::Done(Ok(()))) {
            Phase::Stepping(walk) => self.step(walk),
            Phase::Halving(halving) => {
                let (piece, run) = *halving;
                self.split(piece, run.solved_for(&self.problem));
                self.share_of_halving();
                self.halve()
            }
            done @ Phase::Done(_) => done,
        };
        match self.phase {
            Phase::Done(_) => Progress::Done,
            _ => Progress::Running,
        }
    }

    /// What share of it is done, from 0 to 1, about; it never falls.
    pub fn share(&self) -> f64 {
        self.share
    }

    /// What was found, by a search that is done; of another the best so far.
    ///
    /// # Errors
    /// If the robot cannot be solved for at all.
    pub fn finish(self) -> Result<(Solved, ShapeFit), ShapeError> {
        if let Phase::Done(Err(error)) = self.phase {
            return Err(error);
        }
        let best = self
            .best
            .ok_or(ShapeError::NotReached(Status::Unfinished))?;
        let fit = compare(&best.solved, &self.measured);
        Ok((best.solved, fit))
    }

    /// How far the branch is followed either way, up and down, in metres of
    /// pull.
    fn ends(&self) -> [f64; 2] {
        let (least, most) = self.problem.pull_range();
        let offset = self.problem.drive().pull_scale();
        let far = (TURNS * TAU * offset).min(self.problem.length());
        [most, -least].map(|end| end.min(far))
    }

    /// Takes a shape that the walk has come to, and what is to be done next.
    fn step(&mut self, mut walk: Box<Walk>) -> Phase {
        let step = STEP * self.problem.drive().pull_scale();
        let ends = self.ends();
        let (side, end, gone) = match walk.way {
            Way::Up => (1.0, ends[0], 0.0),
            Way::Down => (-1.0, ends[1], ends[0]),
        };
        let solution = walk.run.solution();
        let status = solution.status.clone();
        // The end of a branch is an equilibrium like any other.
        if solution.certificate.holds() {
            let far_off = self.best() + FAR_OFF * STRIDE * walk.moved;
            let solved = walk.run.solved_for(&self.problem);
            let here = self.visit(solved, far_off);
            if let Some(before) = walk.before.replace(here.clone()) {
                let steps = (here.pull - before.pull).abs() / step;
                walk.moved = self.consider(before, here, BOW, 0) / steps;
            }
        }
        self.share = STEPPING * (gone + walk.pull) / ends.iter().sum::<f64>();
        if status != Status::Converged && self.best.is_none() {
            return Phase::Done(Err(ShapeError::NotReached(status)));
        }
        if status != Status::Converged || walk.pull >= end {
            return match walk.way {
                Way::Up => Phase::Stepping(Box::new(Walk::new(&self.problem, Way::Down))),
                Way::Down => self.halve(),
            };
        }
        // As far as it has to move to become the best, and less.
        let here = walk.before.as_ref().map_or(f64::INFINITY, |it| it.rms);
        let needed = (here - self.best()) / (2.0 * walk.moved);
        walk.pull = (walk.pull + step * needed.clamp(1.0, STRIDE)).min(end);
        walk.target.set_pull(side * walk.pull);
        walk.run.retarget(&walk.target);
        Phase::Stepping(walk)
    }

    /// Takes the piece that may hold the least distance, until none may hold
    /// anything better.
    fn halve(&mut self) -> Phase {
        while self.halvings < MOST_HALVINGS {
            let bounds = self.open.iter().map(|piece| piece.bound).enumerate();
            let Some((lowest, _)) = bounds.min_by(|a, b| a.1.total_cmp(&b.1)) else {
                break;
            };
            let piece = self.open.swap_remove(lowest);
            self.halvings += 1;
            self.deepest = self.deepest.max(piece.halved);
            let (from, to) = (&piece.from, &piece.to);
            if (to.pull - from.pull).abs() > GRAIN * self.problem.length() {
                let middle = at(&self.problem, 0.5 * (from.pull + to.pull));
                let near = from.solved(&self.problem);
                let start = near.as_ref().map_or(Start::Straight, Start::From);
                let run = Run::new(&middle, start, Settings::default());
                return Phase::Halving(Box::new((piece, run)));
            }
            self.share_of_halving();
        }
        self.share = 1.0;
        Phase::Done(Ok(()))
    }

    /// Halves a piece at its middle's solution.
    fn split(&mut self, piece: Piece, solved: Solved) {
        if !solved.certificate.holds() {
            return;
        }
        let [from, middle, to] = [&piece.from.nodes, &solved.nodes, &piece.to.nodes];
        let bow = self.bow(from, middle, to).max(BOW_OF_HALF * piece.bow);
        let converged = solved.status == Status::Converged;
        let middle = self.visit(solved, f64::INFINITY);
        let halved = piece.halved + 1;
        self.consider(piece.from, middle.clone(), bow, halved);
        if converged {
            self.consider(middle, piece.to, bow, halved);
        }
    }

    fn share_of_halving(&mut self) {
        let grain = GRAIN * self.problem.length();
        let widths = std::iter::successors(Some(STEP * self.problem.drive().pull_scale()), |w| {
            Some(0.5 * w)
        });
        let levels = widths.take_while(|width| *width > grain).count().max(1);
        let share = (f64::from(self.deepest) / levels as f64).min(1.0);
        self.share = STEPPING + (1.0 - STEPPING) * share;
    }

    /// A shape with its distance, which may be the best. It is not measured
    /// exactly where it is above a limit.
    fn visit(&mut self, solved: Solved, limit: f64) -> Rc<Place> {
        let rms = rms_up_to(&solved, &self.measured, limit);
        let place = Rc::new(Place::new(&solved, rms));
        if self.best.is_none() || rms < self.best() {
            self.best = Some(Best { solved, rms });
            let promising = self.promising();
            self.open.retain(|piece| piece.bound < promising);
        }
        place
    }

    /// The least distance known, in metres.
    fn best(&self) -> f64 {
        self.best.as_ref().map_or(f64::INFINITY, |best| best.rms)
    }

    /// Bounds from here on upwards promise nothing.
    fn promising(&self) -> f64 {
        self.best() - GAIN * self.problem.length()
    }

    /// Keeps a piece, if it may hold something better than the best, and returns
    /// how far apart its ends are. The branch bows out by at most `bow`, in
    /// metres or, for one that was not halved, over that distance.
    fn consider(&mut self, from: Rc<Place>, to: Rc<Place>, bow: f64, halved: u32) -> f64 {
        let way = |node: usize| to.nodes[node].position - from.nodes[node].position;
        let apart = self.size(way);
        let bow = if halved == 0 {
            bow * apart
        } else {
            bow.min(BOW * apart)
        };
        let bound = bound(from.rms, to.rms, apart) - bow;
        if bound < self.promising() {
            self.open.push(Piece {
                from,
                to,
                bow,
                bound,
                halved,
            });
        }
        apart
    }

    /// How far the middle of a piece is from the straight way between its ends.
    fn bow(&self, from: &[PlanarNode], middle: &[PlanarNode], to: &[PlanarNode]) -> f64 {
        let way = |node: usize| to[node].position - from[node].position;
        let gone = |node: usize| middle[node].position - from[node].position;
        let nodes = 0..from.len();
        let (along, whole) = nodes.fold((0.0, 0.0), |sums, node| {
            let way = way(node);
            (sums.0 + way.dot(&gone(node)), sums.1 + way.norm_squared())
        });
        let share = if whole > 0.0 { along / whole } else { 0.0 };
        self.size(|node| gone(node) - share * way(node))
    }

    /// The size of a motion of the nodes, in the measure by which distances of
    /// shapes differ at most: RMS over the points where these know their nodes,
    /// and else the greatest.
    fn size(&self, moved: impl Fn(usize) -> Vector) -> f64 {
        if !self.measured.by_node() {
            let nodes = 0..=self.problem.robot().segments;
            return nodes.map(|node| moved(node).norm()).fold(0.0, f64::max);
        }
        let points = self.measured.points();
        let nodes = points.iter().filter_map(|point| point.node);
        let squares: f64 = nodes.map(|node| moved(node).norm_squared()).sum();
        (squares / points.len() as f64).sqrt()
    }
}

/// The least RMS distance on the straight way between two shapes of these RMS
/// distances, so far apart.
fn bound(from: f64, to: f64, apart: f64) -> f64 {
    let (from, to, apart) = (from * from, to * to, apart * apart);
    if apart == 0.0 {
        return from.min(to).sqrt();
    }
    let share = (0.5 * (apart + from - to) / apart).clamp(0.0, 1.0);
    let least = (1.0 - share) * from + share * to - share * (1.0 - share) * apart;
    least.max(0.0).sqrt()
}
