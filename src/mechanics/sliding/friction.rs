//! Friction of the cables in their holes, as an outer iteration around the solver.
//!
//! ```text
//! in   (cable towards the base)   T_k = T_{k-1} exp(−μ|θ|)
//! out  (towards the tip)          T_k = T_{k-1} exp(+μ|θ|)
//! sticks                          the length beyond stays, T_k/T_{k-1} between the two
//! ```
//!
//! A solve is one of a minimisation: how much each stretch is tenser than the first one
//! that is held by the same row stays frozen, as a weight on that stretch, and what is
//! beyond a hole that sticks is a row of its own. After it the differences follow from
//! its angles and mean tension, until they stay (an error of the bends falls by about
//! 1/μθ a pass), and then holes change: those where the cable went the other way stick,
//! and those whose cone is left slip. The solver sees symmetric problems only, so all
//! that it promises of steps, tunnelling and inertia holds with friction.
//!
//! Holes change from the base outwards, and after a few rounds one at a time: all at
//! once they can go round in circles.

use super::bay::Bay;
use super::chain::Sliding;
use super::stretch::Stretch;
use crate::geometry::{Obstacle, Vector, cross};
use crate::mechanics::friction::{Rubbing, Slip, Strand, slipping_ratio};
use crate::mechanics::{Input, Mechanics, Settling};
use crate::solver::{Point, RowId};

/// The greatest change of a tension in a pass, over the greatest of the cable, at which
/// friction has settled: a hundredth of what a certificate allows, which compares with
/// moments that may be a tenth of the forces that cancel in them.
const SETTLED: f64 = 1e-11;
/// The same at which it is looked at which holes slip.
const NEARLY: f64 = 1e-3;
/// A tension outside a hole's cone by this share of the greatest makes it slip.
pub(super) const OUTSIDE: f64 = 1e-9;
/// In how many rounds of a solve all holes may change that would.
const BULK_ROUNDS: usize = 3;
/// Passes for each hole before a solve is given up.
const PASSES_A_HOLE: usize = 6;
/// Passes besides.
const PASSES: usize = 40;

/// What is frozen of a cable's friction in a solve.
#[derive(Clone, Debug, Default)]
pub(super) struct Frozen {
    /// By stretch, the tension beyond the multiplier of the row that holds it, in the
    /// chain's unit; all of it where no row does.
    pub extra: Vec<f64>,
    /// By hole.
    pub slips: Vec<Slip>,
    /// By hole, how much shorter the cable beyond it was when the step began.
    pub drawn: Vec<f64>,
    /// The load below the base when the step began, in the chain's unit.
    load: f64,
    /// The tensions that the next solve starts from, in the chain's unit.
    pub tensions: Vec<f64>,
}

/// The stretches of a cable that one row holds, ends included.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Group {
    pub cable: usize,
    pub first: usize,
    pub last: usize,
}

/// A cable where it enters the robot.
#[derive(Clone, Copy, Debug)]
pub(super) struct Below {
    /// The tension of its first stretch, in the chain's unit.
    pub tension: f64,
    /// The length drawn in, without its stretch, in metres.
    pub drawn: f64,
    /// What hangs on it, or would hold it, in the chain's unit.
    pub load: f64,
}

/// Passes and rounds of a solve so far.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Effort {
    passes: usize,
    rounds: usize,
}

impl<const NU: usize> Sliding<NU> {
    /// Whether anything rubs.
    pub(super) fn rubs(&self) -> bool {
        let friction = self.problem().drive().friction;
        !friction.is_none()
    }

    /// The rows that hold cables, from what each is given and where it sticks.
    pub(super) fn group(&mut self) {
        self.groups.clear();
        let drive = self.problem.drive();
        for (cable, driven) in drive.cables.iter().enumerate() {
            let last = driven.cable.last_disk;
            let sticks = |hole: usize| match self.frozen.get(cable) {
                Some(frozen) => frozen.slips.get(hole) == Some(&Slip::Sticks),
                None => false,
            };
            let mut from = match driven.input {
                Input::Load(_) if !sticks(0) => None,
                _ => Some(1),
            };
            for hole in 1..=last {
                if hole < last && !sticks(hole) {
                    continue;
                }
                if let Some(first) = from {
                    self.groups.push(Group {
                        cable,
                        first,
                        last: hole,
                    });
                }
                from = Some(hole + 1);
            }
        }
    }

    /// Freezes friction as it is in a shape that a step starts from, among obstacles
    /// where they were then.
    pub(super) fn freeze(&mut self, obstacles: &[Obstacle], nodes: &[Bay<NU>], rubbing: &Rubbing) {
        self.effort = Effort::default();
        self.anderson.reset();
        self.freeze_contacts(obstacles, nodes, &rubbing.drags);
        if !self.rubs() {
            self.frozen.clear();
            self.group();
            return;
        }
        let strands = &rubbing.strands;
        let unit = self.cost_unit();
        let count = self.problem.drive().cables.len();
        self.frozen.resize_with(count, Frozen::default);
        for cable in 0..count {
            let holes = self.problem.drive().cables[cable].cable.last_disk;
            let mut frozen = std::mem::take(&mut self.frozen[cable]);
            frozen.tensions.clear();
            frozen.slips.clear();
            frozen.load = 0.0;
            match strands.get(cable).filter(|it| it.tensions.len() == holes) {
                Some(strand) => {
                    let tensions = strand.tensions.iter().map(|tension| tension / unit);
                    frozen.tensions.extend(tensions);
                    frozen.slips.extend_from_slice(&strand.slips);
                    frozen.load = strand.load / unit;
                }
                None => frozen.tensions.resize(holes, 0.0),
            }
            // What hangs loose slips as soon as it is drawn in.
            if frozen.tensions.iter().all(|tension| *tension == 0.0) {
                frozen.slips.clear();
                frozen.slips.resize(holes, Slip::In);
            }
            self.measure(cable, nodes, &frozen.tensions, &mut frozen.drawn);
            self.frozen[cable] = frozen;
        }
        self.group();
        for cable in 0..count {
            self.follow_ratios(cable, nodes);
        }
    }

    /// Takes over what another solve of the same cables has frozen.
    pub(super) fn freeze_like(&mut self, other: &Self) {
        self.frozen.clone_from(&other.frozen);
        self.groups.clone_from(&other.groups);
        self.held.clone_from(&other.held);
        self.started.clone_from(&other.started);
        self.origins.clone_from(&other.origins);
        let here = self.problem.drive().cables.iter();
        let pairs = here.zip(&other.problem.drive().cables);
        for (frozen, (here, there)) in self.frozen.iter_mut().zip(pairs) {
            if let (Input::Load(here), Input::Load(there)) = (here.input, there.input)
                && frozen.slips.first() != Some(&Slip::Sticks)
                && there > 0.0
            {
                let held = frozen.slips.iter().position(|slip| *slip == Slip::Sticks);
                let given = held.unwrap_or(frozen.extra.len());
                for extra in &mut frozen.extra[..given] {
                    *extra *= here / there;
                }
            }
        }
    }

    /// Multipliers of the rows that hold cables, to start a solve with.
    pub(super) fn add_tensions(&self, multipliers: &mut Vec<(RowId, f64)>) {
        for (sum, group) in self.groups.iter().enumerate() {
            let tension = self.frozen[group.cable].tensions[group.first - 1];
            if tension > 0.0 {
                multipliers.push((self.group_id(sum), tension));
            }
        }
    }

    /// After a solve: freezes friction as it would be in the shape found.
    pub(super) fn settle(&mut self, point: &Point<Self, 3, NU>, multipliers: &[f64]) -> Settling {
        let summed = &multipliers[point.rows.len()..];
        let holes: usize = self.frozen.iter().map(|frozen| frozen.slips.len()).sum();
        self.effort.passes += 1;
        if self.effort.passes > PASSES + PASSES_A_HOLE * holes {
            return Settling::Failed;
        }
        let before = self.unknowns();
        let mut change = 0.0_f64;
        for cable in 0..self.frozen.len() {
            self.find_tensions(cable, summed);
            change = change.max(self.follow_ratios(cable, &point.nodes));
        }
        change = change.max(self.follow_contacts(point, multipliers));
        if change <= NEARLY && self.change_standings(point, multipliers) {
            self.anderson.reset();
            return Settling::Again;
        }
        if change <= SETTLED {
            // What the shape was solved with is what balances it.
            self.set_unknowns(&before);
            return Settling::Settled;
        }
        let mut after = self.unknowns();
        self.anderson.improve(&before, &mut after);
        self.set_unknowns(&after);
        Settling::Again
    }

    /// Lets holes and contacts slip and stick as the shape found asks for. Whether any
    /// changed.
    fn change_standings(&mut self, point: &Point<Self, 3, NU>, multipliers: &[f64]) -> bool {
        let bulk = self.effort.rounds < BULK_ROUNDS;
        let mut changed = false;
        for cable in 0..self.frozen.len() {
            changed |= self.change_slips(cable, &point.nodes, bulk);
        }
        if bulk || !changed {
            changed |= self.change_slides(point, multipliers, bulk);
        }
        if changed {
            self.effort.rounds += 1;
            self.group();
            for cable in 0..self.frozen.len() {
                self.follow_ratios(cable, &point.nodes);
            }
        }
        changed
    }

    /// All that is frozen in numbers: tensions beyond their rows', and forces of contacts.
    fn unknowns(&self) -> Vec<f64> {
        let extra = self
            .frozen
            .iter()
            .flat_map(|frozen| frozen.extra.iter().copied());
        extra.chain(self.held_forces()).collect()
    }

    fn set_unknowns(&mut self, unknowns: &[f64]) {
        let mut unknowns = unknowns.iter().copied();
        for frozen in &mut self.frozen {
            for (extra, unknown) in frozen.extra.iter_mut().zip(&mut unknowns) {
                *extra = unknown;
            }
        }
        self.set_held_forces(unknowns);
    }

    /// What friction keeps of a shape where it has settled.
    pub(super) fn write_rubbing(
        &self,
        point: &Point<Self, 3, NU>,
        multipliers: &[f64],
        rubbing: &mut Rubbing,
    ) {
        self.write_drags(point, &mut rubbing.drags);
        let strands = &mut rubbing.strands;
        strands.resize_with(self.frozen.len(), Strand::default);
        let unit = self.cost_unit();
        let sums = &multipliers[point.rows.len()..];
        let mut drawn = Vec::new();
        for (cable, strand) in strands.iter_mut().enumerate() {
            let frozen = &self.frozen[cable];
            self.tensions(cable, sums, &mut strand.tensions);
            self.measure(cable, &point.nodes, &strand.tensions, &mut drawn);
            strand.before.clone_from(&frozen.drawn);
            let moved = drawn.iter().zip(&frozen.drawn);
            strand.slips.clear();
            strand
                .slips
                .extend(moved.map(|(now, then)| Slip::of(now - then)));
            strand.load = unit * self.found(cable, point, sums).load;
            for tension in &mut strand.tensions {
                *tension *= unit;
            }
        }
    }

    /// What is found of a cable below its first disk.
    pub(super) fn found(&self, cable: usize, point: &Point<Self, 3, NU>, sums: &[f64]) -> Below {
        let (mut tensions, mut drawn) = (Vec::new(), Vec::new());
        self.tensions(cable, sums, &mut tensions);
        self.measure(cable, &point.nodes, &tensions, &mut drawn);
        let slip = Slip::of(drawn[0] - self.frozen[cable].drawn[0]);
        Below {
            tension: tensions[0],
            drawn: match self.problem.drive().cables[cable].input {
                Input::Pull(pull) => pull,
                Input::Load(_) => drawn[0],
            },
            load: self.load_below(cable, tensions[0], slip, &point.nodes),
        }
    }

    /// P, what must hang below the base for this tension of the first stretch, in the
    /// chain's unit.
    fn load_below(&self, cable: usize, tension: f64, slip: Slip, nodes: &[Bay<NU>]) -> f64 {
        if let Some(load) = self.given_tension(cable) {
            return load;
        }
        let ratio = |slip| self.ratio(cable, 0, slip, nodes);
        match slip {
            Slip::Sticks => {
                let (least, most) = (tension / ratio(Slip::Out), tension / ratio(Slip::In));
                crate::math::within(self.frozen[cable].load, least, most)
            }
            slip => tension / ratio(slip),
        }
    }

    /// The tensions of a cable's stretches, in the chain's unit.
    fn tensions(&self, cable: usize, summed: &[f64], tensions: &mut Vec<f64>) {
        tensions.clone_from(&self.frozen[cable].extra);
        for (group, multiplier) in self.groups.iter().zip(summed) {
            if group.cable == cable {
                for tension in &mut tensions[group.first - 1..group.last] {
                    // What hangs loose has none, whatever was frozen.
                    let is_loose = *multiplier == 0.0;
                    *tension = if is_loose { 0.0 } else { *tension + multiplier };
                }
            }
        }
    }

    fn find_tensions(&mut self, cable: usize, summed: &[f64]) {
        let mut tensions = std::mem::take(&mut self.frozen[cable].tensions);
        self.tensions(cable, summed, &mut tensions);
        self.frozen[cable].tensions = tensions;
    }

    /// How much shorter the cable beyond each hole is than along the straight robot,
    /// without its stretch, in metres.
    fn measure(&self, cable: usize, nodes: &[Bay<NU>], tensions: &[f64], drawn: &mut Vec<f64>) {
        let driven = &self.problem.drive().cables[cable];
        let yielding = self.yielding(cable);
        drawn.clear();
        drawn.resize(tensions.len(), 0.0);
        let mut beyond = 0.0;
        for (k, tension) in tensions.iter().enumerate().rev() {
            let stretch = Stretch::of(&nodes[k + 1], driven.cable.offset);
            beyond += self.bay_length() - stretch.length + yielding * tension;
            drawn[k] = beyond;
        }
    }

    /// By how much a stretch yields to a unit of tension, in metres.
    pub(super) fn yielding(&self, cable: usize) -> f64 {
        let cable = &self.problem.drive().cables[cable].cable;
        match self.per_energy {
            0.0 => 0.0,
            per_energy => cable.compliance / (per_energy * cable.last_disk as f64),
        }
    }

    /// T beyond a hole over T below it, where the cable slips as told.
    fn ratio(&self, cable: usize, hole: usize, slip: Slip, nodes: &[Bay<NU>]) -> f64 {
        let offset = self.problem.drive().cables[cable].cable.offset;
        let friction = self.problem.drive().friction;
        let along = |k: usize| {
            let bay: &Bay<NU> = &nodes[k];
            bay.at(bay.arcs(), offset) - bay.at(0, offset)
        };
        let (below, lost) = match hole {
            0 => (nodes[0].end().normal(), friction.base_loss),
            _ => (along(hole), 0.0),
        };
        slipping_ratio(slip, friction.holes, angle(below, along(hole + 1)), lost)
    }

    /// Freezes the tensions that a cable's slipping holes ask for, of the same mean in
    /// every group. Returns the greatest change, over the greatest tension.
    fn follow_ratios(&mut self, cable: usize, nodes: &[Bay<NU>]) -> f64 {
        let mut frozen = std::mem::take(&mut self.frozen[cable]);
        let given = self
            .given_tension(cable)
            .filter(|_| frozen.slips[0] != Slip::Sticks);
        let holes = frozen.slips.len();
        frozen.extra.resize(holes, 0.0);
        let most = frozen
            .tensions
            .iter()
            .fold(f64::MIN_POSITIVE, |a, b| a.max(*b));
        let mut change = 0.0_f64;
        let mut first = 0;
        while first < holes {
            let beyond = (first + 1..holes).find(|&hole| frozen.slips[hole] == Slip::Sticks);
            let end = beyond.unwrap_or(holes);
            let group = &mut frozen.extra[first..end];
            let mut ratio = 1.0;
            let mut sum = 0.0;
            for (place, extra) in group.iter_mut().enumerate() {
                if place > 0 {
                    let hole = first + place;
                    ratio *= self.ratio(cable, hole, frozen.slips[hole], nodes);
                }
                *extra = ratio;
                sum += ratio;
            }
            let tensions = &mut frozen.tensions[first..end];
            let held = given.is_none() || first > 0;
            let lead = if held {
                tensions.iter().sum::<f64>() / sum
            } else {
                given.unwrap_or(0.0) * self.ratio(cable, 0, frozen.slips[0], nodes)
            };
            for (extra, tension) in group.iter_mut().zip(tensions) {
                let now = lead * *extra;
                change = change.max((now - *tension).abs());
                *tension = now;
                *extra = if held { now - lead } else { now };
            }
            first = end;
        }
        self.frozen[cable] = frozen;
        change / most
    }

    /// Lets holes slip and stick as the shape found asks for. Whether any changed.
    fn change_slips(&mut self, cable: usize, nodes: &[Bay<NU>], bulk: bool) -> bool {
        let mut frozen = std::mem::take(&mut self.frozen[cable]);
        let tensions = &frozen.tensions;
        let most = tensions.iter().fold(0.0_f64, |a, b| a.max(*b));
        let load = self.given_tension(cable);
        let mut drawn = Vec::new();
        self.measure(cable, nodes, tensions, &mut drawn);
        // Under pull nothing is asked of the base's hole.
        let holes = usize::from(load.is_none())..frozen.slips.len();
        let below = |hole: usize| match hole.checked_sub(1) {
            Some(stretch) => tensions[stretch],
            None => load.unwrap_or(0.0),
        };
        let mut changed = false;
        for hole in holes.clone() {
            let moved = drawn[hole] - frozen.drawn[hole];
            let wrong = match frozen.slips[hole] {
                Slip::In => moved < -Slip::UNMOVED,
                Slip::Out => moved > Slip::UNMOVED,
                Slip::Sticks => false,
            };
            if wrong && below(hole).max(tensions[hole]) > OUTSIDE * most {
                frozen.slips[hole] = Slip::Sticks;
                changed = true;
            }
        }
        let sticking = if changed { 0..0 } else { holes };
        for hole in sticking {
            if frozen.slips[hole] != Slip::Sticks {
                continue;
            }
            let ratio = |slip| self.ratio(cable, hole, slip, nodes);
            let (below, beyond) = (below(hole), tensions[hole]);
            let slip = if beyond < ratio(Slip::In) * below - OUTSIDE * most {
                Slip::In
            } else if beyond > ratio(Slip::Out) * below + OUTSIDE * most {
                Slip::Out
            } else {
                continue;
            };
            frozen.slips[hole] = slip;
            changed = true;
            if !bulk {
                break;
            }
        }
        self.frozen[cable] = frozen;
        changed
    }
}

/// The angle between two directions, in radians, ≥ 0.
fn angle(a: Vector, b: Vector) -> f64 {
    libm::atan2(cross(a, b).abs(), a.dot(&b))
}
