//! Friction of the cables in their holes.
//!
//! ```text
//! in   (cable towards the base)   T_k = T_{k-1} exp(−μ|θ|)
//! out  (towards the tip)          T_k = T_{k-1} exp(+μ|θ|)
//! sticks                          the length beyond stays, T_k/T_{k-1} between the two
//! ```
//!
//! How much each stretch is tenser than the first one that is held by the same row stays
//! frozen in a solve, as a weight on that stretch, and what is beyond a hole that sticks
//! is a row of its own. The differences then follow from a row's angles and mean tension.

use super::{Friction, Look, OUTSIDE};
use crate::geometry::{Vector, cross};
use crate::mechanics::friction::{Slip, Strand, slipping_ratio};
use crate::mechanics::{Drive, DrivenCable, Input};

/// What is frozen of a cable's friction in a solve.
#[derive(Clone, Debug, Default)]
pub(crate) struct Frozen {
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
pub(crate) struct Group {
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

/// The load on a cable, in the chain's unit, where that is what is given; `per_energy`
/// is what a newton metre is of the chain's unit.
pub(crate) fn given_tension(driven: &DrivenCable, per_energy: f64) -> Option<f64> {
    match driven.input {
        Input::Load(load) => Some(per_energy * load),
        Input::Pull(_) => None,
    }
}

/// By how much a stretch of a cable yields to a unit of tension, in metres.
pub(crate) fn yielding(driven: &DrivenCable, per_energy: f64) -> f64 {
    match per_energy {
        0.0 => 0.0,
        per_energy => driven.cable.compliance / (per_energy * driven.cable.last_disk as f64),
    }
}

impl Look<'_> {
    /// The length of a bay, in metres.
    fn bay_length(&self) -> f64 {
        let robot = self.problem.robot();
        robot.segment_length() * robot.segments_per_bay as f64
    }

    /// A cable's hole in a disk, from 0 at the base.
    fn hole(&self, cable: usize, disk: usize) -> Vector {
        let node = &self.nodes[disk * self.problem.robot().segments_per_bay];
        node.at(self.problem.drive().cables[cable].cable.offset)
    }

    /// From a stretch's lower hole to its upper one.
    fn along(&self, cable: usize, stretch: usize) -> Vector {
        self.hole(cable, stretch) - self.hole(cable, stretch - 1)
    }

    fn given_tension(&self, cable: usize) -> Option<f64> {
        given_tension(&self.problem.drive().cables[cable], self.per_energy)
    }

    /// T beyond a hole over T below it, where the cable slips as told.
    fn ratio(&self, cable: usize, hole: usize, slip: Slip) -> f64 {
        let friction = self.problem.drive().friction;
        let (below, lost) = match hole {
            0 => (self.nodes[0].normal(), friction.base_loss),
            _ => (self.along(cable, hole), 0.0),
        };
        let turned = angle(below, self.along(cable, hole + 1));
        slipping_ratio(slip, friction.holes, turned, lost)
    }

    /// How much shorter the cable beyond each hole is than along the straight robot,
    /// without its stretch, in metres.
    fn measure(&self, cable: usize, tensions: &[f64], drawn: &mut Vec<f64>) {
        let yielding = yielding(&self.problem.drive().cables[cable], self.per_energy);
        drawn.clear();
        drawn.resize(tensions.len(), 0.0);
        let mut beyond = 0.0;
        for (k, tension) in tensions.iter().enumerate().rev() {
            let length = self.along(cable, k + 1).norm();
            beyond += self.bay_length() - length + yielding * tension;
            drawn[k] = beyond;
        }
    }
}

impl Friction {
    /// The rows that hold cables, from what each is given and where it sticks.
    pub fn group(&mut self, drive: &Drive) {
        self.groups.clear();
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

    /// Freezes the cables' friction as it is in a shape that a step starts from.
    pub(super) fn freeze_holes(&mut self, look: Look<'_>, strands: &[Strand]) {
        let cables = &look.problem.drive().cables;
        self.frozen.resize_with(cables.len(), Frozen::default);
        for (cable, (frozen, driven)) in self.frozen.iter_mut().zip(cables).enumerate() {
            let holes = driven.cable.last_disk;
            frozen.tensions.clear();
            frozen.slips.clear();
            frozen.load = 0.0;
            match strands.get(cable).filter(|it| it.tensions.len() == holes) {
                Some(strand) => {
                    let tensions = strand.tensions.iter().map(|tension| tension / look.unit);
                    frozen.tensions.extend(tensions);
                    frozen.slips.extend_from_slice(&strand.slips);
                    frozen.load = strand.load / look.unit;
                }
                None => frozen.tensions.resize(holes, 0.0),
            }
            // What hangs loose slips as soon as it is drawn in.
            if frozen.tensions.iter().all(|tension| *tension == 0.0) {
                frozen.slips.clear();
                frozen.slips.resize(holes, Slip::In);
            }
            look.measure(cable, &frozen.tensions, &mut frozen.drawn);
        }
    }

    /// Brings what is frozen of cables under load from one drive's loads to another's.
    pub(super) fn scale_loads(&mut self, here: &Drive, there: &Drive) {
        let pairs = here.cables.iter().zip(&there.cables);
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

    /// What friction keeps of cables where it has settled.
    pub(super) fn write_strands(&self, look: Look<'_>, sums: &[f64], strands: &mut Vec<Strand>) {
        strands.resize_with(self.frozen.len(), Strand::default);
        let mut drawn = Vec::new();
        for (cable, strand) in strands.iter_mut().enumerate() {
            let below = self.below(cable, look, sums, &mut strand.tensions, &mut drawn);
            strand.load = look.unit * below.load;
            strand.before.clone_from(&self.frozen[cable].drawn);
            let moved = drawn.iter().zip(&strand.before);
            strand.slips.clear();
            let slips = moved.map(|(now, then)| Slip::of(now - then));
            strand.slips.extend(slips);
            for tension in &mut strand.tensions {
                *tension *= look.unit;
            }
        }
    }

    /// What is found of a cable below its first disk. Leaves the tensions of its
    /// stretches, and how much shorter it is beyond each hole.
    pub(super) fn below(
        &self,
        cable: usize,
        look: Look<'_>,
        sums: &[f64],
        tensions: &mut Vec<f64>,
        drawn: &mut Vec<f64>,
    ) -> Below {
        self.tensions(cable, sums, tensions);
        look.measure(cable, tensions, drawn);
        let slip = Slip::of(drawn[0] - self.frozen[cable].drawn[0]);
        Below {
            tension: tensions[0],
            drawn: match look.problem.drive().cables[cable].input {
                Input::Pull(pull) => pull,
                Input::Load(_) => drawn[0],
            },
            load: self.load_below(cable, tensions[0], slip, look),
        }
    }

    /// P, what must hang below the base for this tension of the first stretch, in the
    /// chain's unit.
    fn load_below(&self, cable: usize, tension: f64, slip: Slip, look: Look<'_>) -> f64 {
        if let Some(load) = look.given_tension(cable) {
            return load;
        }
        let ratio = |slip| look.ratio(cable, 0, slip);
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

    pub(super) fn find_tensions(&mut self, cable: usize, summed: &[f64]) {
        let mut tensions = std::mem::take(&mut self.frozen[cable].tensions);
        self.tensions(cable, summed, &mut tensions);
        self.frozen[cable].tensions = tensions;
    }

    /// Freezes the tensions that a cable's slipping holes ask for, of the same mean in
    /// every group. Returns the greatest change, over the greatest tension.
    pub(super) fn follow_ratios(&mut self, cable: usize, look: Look<'_>) -> f64 {
        let mut frozen = std::mem::take(&mut self.frozen[cable]);
        let given = look
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
                    ratio *= look.ratio(cable, hole, frozen.slips[hole]);
                }
                *extra = ratio;
                sum += ratio;
            }
            let tensions = &mut frozen.tensions[first..end];
            let held = given.is_none() || first > 0;
            let lead = if held {
                tensions.iter().sum::<f64>() / sum
            } else {
                given.unwrap_or(0.0) * look.ratio(cable, 0, frozen.slips[0])
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
    pub(super) fn change_slips(&mut self, cable: usize, look: Look<'_>, bulk: bool) -> bool {
        let mut frozen = std::mem::take(&mut self.frozen[cable]);
        let tensions = &frozen.tensions;
        let most = tensions.iter().fold(0.0_f64, |a, b| a.max(*b));
        let load = look.given_tension(cable);
        let mut drawn = std::mem::take(&mut self.storage.drawn);
        look.measure(cable, tensions, &mut drawn);
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
            let ratio = |slip| look.ratio(cable, hole, slip);
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
        self.storage.drawn = drawn;
        self.frozen[cable] = frozen;
        changed
    }
}

/// The angle between two directions, in radians, ≥ 0.
fn angle(a: Vector, b: Vector) -> f64 {
    libm::atan2(cross(a, b).abs(), a.dot(&b))
}
