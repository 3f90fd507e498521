//! Friction of the cables in their holes and of the robot on obstacles, as an outer
//! iteration around the solver.
//!
//! A solve is one of a minimisation in which friction stays frozen: of a cable that
//! slips through a hole, by how much it is tenser beyond; of a contact, the tangential
//! force. What sticks is held by rows and springs of its own. After it friction follows
//! from the shape found, until it stays (an error of the bends falls by about 1/μθ a
//! pass), and then holes and contacts change: those that went the other way stick, and
//! those whose cone is left slip. The solver sees symmetric problems only, so all that
//! it promises of steps, tunnelling and inertia holds with friction.
//!
//! All of it looks at where disks are and not at how they got there: it is the same
//! for every number of arcs a bay. [`chain`] hands it the shapes of a chain.

mod chain;
mod contacts;
mod holes;

use contacts::Held;
pub(super) use holes::{Frozen, Group, given_tension, yielding};

use crate::geometry::Obstacle;
use crate::math::Anderson;
use crate::mechanics::friction::Rubbing;
use crate::mechanics::{Drive, Problem, Settling};
use crate::robot::PlanarNode;
use crate::solver::RowId;

/// The greatest change of a force in a pass, over the greatest, at which friction has
/// settled: a hundredth of what a certificate allows, which compares with moments that
/// may be a tenth of the forces that cancel in them.
const SETTLED: f64 = 1e-11;
/// The same at which it is looked at what slips.
const NEARLY: f64 = 1e-3;
/// A force outside its cone by this share of the greatest makes a hole or a contact slip.
const OUTSIDE: f64 = 1e-9;
/// In how many rounds of a solve all holes may change that would: after that they change
/// one at a time, from the base outwards, since all at once they can go round in circles.
const BULK_ROUNDS: usize = 3;
/// Passes for each hole before a solve is given up.
const PASSES_A_HOLE: usize = 6;
/// Passes besides.
const PASSES: usize = 40;

/// Friction as it stands in a solve.
#[derive(Debug, Default)]
pub(super) struct Friction {
    /// By cable; none where nothing rubs.
    pub frozen: Vec<Frozen>,
    /// The rows that hold cables, in the order of their ids.
    pub groups: Vec<Group>,
    /// What obstacles hold back, by row.
    pub held: Vec<Held>,
    /// Whether this solve goes without that.
    let_go: bool,
    /// Robot and obstacles where the step began; none where no contact rubs.
    started: Vec<PlanarNode>,
    origins: Vec<Obstacle>,
    passes: usize,
    rounds: usize,
    anderson: Anderson,
    storage: Storage,
}

/// What is kept only so that no pass allocates.
#[derive(Debug, Default)]
struct Storage {
    nodes: Vec<PlanarNode>,
    rows: Vec<RowId>,
    drawn: Vec<f64>,
    before: Vec<f64>,
    after: Vec<f64>,
    held: Vec<Held>,
}

impl Clone for Friction {
    fn clone(&self) -> Self {
        let mut clone = Self::default();
        clone.clone_from(self);
        clone
    }

    /// A clone has made no pass yet.
    fn clone_from(&mut self, source: &Self) {
        self.copy_frozen(source);
        self.passes = 0;
        self.rounds = 0;
        self.anderson.reset();
    }
}

/// A shape that friction looks at, every node of it, base first; and the chain's unit of
/// energy, EI/(L n), in what is asked of it.
#[derive(Clone, Copy)]
struct Look<'a> {
    problem: &'a Problem,
    nodes: &'a [PlanarNode],
    /// That unit in rad².
    unit: f64,
    /// What a newton metre is of it; 0 where EI is not known.
    per_energy: f64,
}

/// The rows of a solve that press or could, with the multipliers of all, those of the
/// rows that hold cables last.
#[derive(Clone, Copy)]
struct Forces<'a> {
    rows: &'a [RowId],
    multipliers: &'a [f64],
}

impl<'a> Forces<'a> {
    /// The multipliers of the rows that hold cables.
    fn sums(&self) -> &'a [f64] {
        &self.multipliers[self.rows.len()..]
    }
}

impl Friction {
    /// Freezes friction as it is in a shape that a step starts from, among obstacles
    /// where they were then.
    fn freeze(&mut self, look: Look<'_>, obstacles: &[Obstacle], rubbing: &Rubbing) {
        self.passes = 0;
        self.rounds = 0;
        self.anderson.reset();
        self.let_go = false;
        self.freeze_contacts(look, obstacles, &rubbing.drags);
        if look.problem.drive().friction.is_none() {
            self.frozen.clear();
        } else {
            self.freeze_holes(look, &rubbing.strands);
        }
        self.group(look.problem.drive());
        for cable in 0..self.frozen.len() {
            self.follow_ratios(cable, look);
        }
    }

    /// Takes over what another solve of the same cables has frozen.
    fn freeze_like(&mut self, other: &Self, here: &Drive, there: &Drive) {
        self.copy_frozen(other);
        self.scale_loads(here, there);
    }

    /// Lets go of contacts. Whether any rubbed.
    fn let_go(&mut self, drive: &Drive) -> bool {
        if drive.friction.contacts == 0.0 || self.let_go {
            return false;
        }
        self.passes = 0;
        self.rounds = 0;
        self.anderson.reset();
        self.held.clear();
        self.let_go = true;
        true
    }

    fn copy_frozen(&mut self, other: &Self) {
        self.let_go = other.let_go;
        self.frozen.clone_from(&other.frozen);
        self.groups.clone_from(&other.groups);
        self.held.clone_from(&other.held);
        self.started.clone_from(&other.started);
        self.origins.clone_from(&other.origins);
    }

    /// After a solve: freezes friction as it would be in the shape found.
    fn settle(&mut self, look: Look<'_>, forces: Forces<'_>) -> Settling {
        let holes: usize = self.frozen.iter().map(|frozen| frozen.slips.len()).sum();
        self.passes += 1;
        if self.passes > PASSES + PASSES_A_HOLE * holes {
            return Settling::Failed;
        }
        let mut before = std::mem::take(&mut self.storage.before);
        self.write_unknowns(&mut before);
        let mut change = 0.0_f64;
        for cable in 0..self.frozen.len() {
            self.find_tensions(cable, forces.sums());
            change = change.max(self.follow_ratios(cable, look));
        }
        if !self.let_go {
            change = change.max(self.follow_contacts(look, forces));
        }
        let settling = if change <= NEARLY && self.change_standings(look, forces) {
            self.anderson.reset();
            Settling::Again
        } else if change <= SETTLED {
            // What the shape was solved with is what balances it.
            self.set_unknowns(&before);
            Settling::Settled
        } else {
            let mut after = std::mem::take(&mut self.storage.after);
            self.write_unknowns(&mut after);
            self.anderson.improve(&before, &mut after);
            self.set_unknowns(&after);
            self.storage.after = after;
            Settling::Again
        };
        self.storage.before = before;
        settling
    }

    /// Lets holes and contacts slip and stick as the shape found asks for. Whether any
    /// changed.
    fn change_standings(&mut self, look: Look<'_>, forces: Forces<'_>) -> bool {
        let bulk = self.rounds < BULK_ROUNDS;
        let mut changed = false;
        for cable in 0..self.frozen.len() {
            changed |= self.change_slips(cable, look, bulk);
        }
        if !self.let_go && (bulk || !changed) {
            changed |= self.change_slides(look, forces, bulk);
        }
        if changed {
            self.rounds += 1;
            self.group(look.problem.drive());
            for cable in 0..self.frozen.len() {
                self.follow_ratios(cable, look);
            }
        }
        changed
    }

    /// All that is frozen in numbers: tensions beyond their rows', and forces of contacts.
    fn write_unknowns(&self, unknowns: &mut Vec<f64>) {
        unknowns.clear();
        for frozen in &self.frozen {
            unknowns.extend_from_slice(&frozen.extra);
        }
        unknowns.extend(self.held.iter().map(|held| held.force));
    }

    fn set_unknowns(&mut self, unknowns: &[f64]) {
        let extra = self.frozen.iter_mut().flat_map(|frozen| &mut frozen.extra);
        let forces = self.held.iter_mut().map(|held| &mut held.force);
        for (own, unknown) in extra.chain(forces).zip(unknowns) {
            *own = *unknown;
        }
    }
}
