//! One sample, from its index to its row: its scene, the way from the straight robot,
//! the outputs. The same bits wherever it is computed.

use super::design::Study;
use super::output::Output;
use super::row::{Row, Verdict};
use crate::equilibrium::{Occurrence, Run, Settings, Solution, Solved, Start, solve};
use crate::experiments::{Measured, compare};
use crate::forces::Stiffness;
use crate::geometry::Vector;
use crate::math::greatest;
use crate::mechanics::{CableState, Drive, Problem};
use crate::scene::Scene;
use crate::units::{degrees, grams, metres, millimetres};
use std::cell::OnceCell;

/// Parts of the way on which the tip's track is looked at.
const PARTS: u32 = 32;

impl Study {
    /// Computes a sample.
    ///
    /// # Panics
    /// If there is no such sample.
    pub fn compute(&self, index: u64) -> Row {
        let bad = |reason: String| Row {
            verdict: Verdict::BadScene,
            reason,
            numbers: vec![f64::NAN; self.computed().len()],
        };
        let scene = match self.sample(index).1 {
            Ok(scene) => scene,
            Err(fault) => return bad(fault.to_string()),
        };
        let problem = match Problem::new(&scene) {
            Ok(problem) => problem,
            Err(fault) => return bad(fault.to_string()),
        };
        let mut run = Run::new(&problem, Start::Straight, Settings::default());
        run.finish();
        self.row(&scene, &problem, &run)
    }

    /// The row of a run that is done.
    fn row(&self, scene: &Scene, problem: &Problem, run: &Run) -> Row {
        let status = &run.solution().status;
        let verdict = Verdict::of_status(status);
        let is_there = verdict == Verdict::Converged;
        let measure = Measure {
            study: self,
            scene,
            goal: problem,
            run,
            solution: run.solution(),
            solved: OnceCell::new(),
            // Its range was checked with the scene's.
            per_bend: Stiffness::of_scene(scene)
                .ok()
                .flatten()
                .map(|stiffness| stiffness.per_bend(problem)),
            free: OnceCell::new(),
        };
        let number = |output: &Output| {
            if !is_there && !output.is_of_the_way() {
                return f64::NAN;
            }
            let number = measure.number(*output);
            // All that are none are one, and no zero has a sign, for the sake of bits.
            number
                .filter(|number| number.is_finite())
                .map_or(f64::NAN, |number| number + 0.0)
        };
        Row {
            verdict,
            reason: if is_there {
                String::new()
            } else {
                status.reason()
            },
            numbers: self.computed().iter().map(number).collect(),
        }
    }

    /// Whether a row meets every constraint.
    pub fn is_feasible(&self, row: &Row) -> bool {
        let value = |output: Output| {
            let place = self.computed().iter().position(|one| *one == output);
            place
                .map(|place| row.numbers[place])
                .filter(|number| !number.is_nan())
        };
        let mut constraints = self.constraints().iter();
        constraints.all(|constraint| constraint.holds(row.verdict, value))
    }
}

/// What outputs are read from.
struct Measure<'a> {
    study: &'a Study,
    scene: &'a Scene,
    goal: &'a Problem,
    run: &'a Run,
    solution: &'a Solution,
    /// The solution with its problem, once something needs both.
    solved: OnceCell<Solved>,
    /// EI/2l_0, in N·m, where EI is known.
    per_bend: Option<f64>,
    /// The robot that touches nothing where this one first does, once that is asked for.
    free: OnceCell<Option<CableState>>,
}

impl Measure<'_> {
    fn number(&self, output: Output) -> Option<f64> {
        let solution = self.solution;
        let truth = |holds: bool| f64::from(u8::from(holds));
        let forces = || solution.pressing().map(|contact| contact.multiplier);
        let newtons = |multiplier: f64| self.per_bend.map(|per_bend| per_bend * multiplier);
        let load = |cable: &CableState| newtons(cable.load).map(grams);
        let first = || solution.cables.first();
        let tip = || solution.tip().position;
        match output {
            Output::Status => Some(truth(self.is_converged())),
            Output::Certificate => Some(truth(solution.certificate.holds())),
            Output::StableUnderLoad => self.solved().rests_under_load().map(truth),
            Output::TipX => Some(millimetres(tip().x)),
            Output::TipY => Some(millimetres(tip().y)),
            Output::TipSlope => Some(degrees(solution.bends.iter().sum())),
            Output::Reach => Some(millimetres((tip() - self.straight_tip()).norm())),
            Output::Swept => Some(1e6 * self.swept()),
            Output::TargetDistance => {
                let target = Vector::from(self.study.file().target_mm?.map(metres));
                Some(millimetres((tip() - target).norm()))
            }
            Output::ProfileRms => {
                let held = self.scene.measured.as_ref()?;
                let measured = Measured::of_scene(held, self.goal).ok()?;
                Some(millimetres(compare(solution, &measured).rms))
            }
            // What touches is there to the solver's tolerance, below a nanometre.
            Output::ClearanceMin if forces().next().is_some() => Some(0.0),
            Output::ClearanceMin => {
                let clearances = self.solved().clearances();
                let each = clearances.iter().map(|one| one.clearance);
                each.reduce(f64::min)
                    .map(|least| greatest(0.0, millimetres(least)))
            }
            Output::Contacts => Some(forces().count() as f64),
            Output::ForceMax => newtons(forces().fold(0.0, greatest)),
            Output::ForceTotal => newtons(solution.pressed()),
            Output::Tension => {
                let tensions = solution.cables.iter().map(|cable| cable.tension);
                tensions.reduce(greatest).and_then(newtons)
            }
            Output::Pull => first().map(|cable| millimetres(cable.pull)),
            Output::Load => first().and_then(load),
            Output::FirstContactPull => {
                let cable = self.at_first_contact()?;
                Some(millimetres(cable.pull))
            }
            Output::FirstContactLoad => load(&self.at_first_contact()?),
            Output::BendMax => Some(degrees(largest(&solution.bends))),
            Output::ShearMax => Some(degrees(largest(&solution.shears))),
            Output::Energy => newtons(solution.energy).map(millimetres),
            Output::ReachedShare => Some(self.run.driven_share()),
            Output::EndPull if self.is_converged() => None,
            Output::EndPull => first().map(|cable| millimetres(cable.pull)),
            Output::Jumps => {
                let events = solution.events.iter();
                let jumps = events.filter(|event| matches!(event.what, Occurrence::Jump { .. }));
                Some(jumps.count() as f64)
            }
        }
    }

    fn solved(&self) -> &Solved {
        self.solved.get_or_init(|| self.run.solved_for(self.goal))
    }

    fn is_converged(&self) -> bool {
        Verdict::of_status(&self.solution.status) == Verdict::Converged
    }

    /// The straight robot's tip.
    fn straight_tip(&self) -> Vector {
        let base = self.goal.robot().base;
        // The disks' direction turned to the backbone's.
        base.position + self.goal.length() * Vector::new(-base.disk.y, base.disk.x)
    }

    /// The first cable of the robot without obstacles, at what is given of it where this
    /// one first touches. `None` where it never does.
    fn at_first_contact(&self) -> Option<CableState> {
        *self.free.get_or_init(|| {
            let first = self.solution.events.iter().find(|event| {
                matches!(
                    event.what,
                    Occurrence::ContactMade { .. } | Occurrence::PushedAside { .. }
                )
            })?;
            let drive = self.run.drive_at(first.share);
            // Where nothing rubs or weighs on it, the free robot of one cable has one
            // shape, whatever the way.
            let is_simple =
                drive.cables.len() == 1 && drive.friction.is_none() && !drive.loads.any();
            let start = match is_simple {
                true => Start::Direct,
                false => Start::Straight,
            };
            let mut free = self.goal.without_obstacles();
            free.set_drive(&drive);
            let solved = solve(&free, start, Settings::default());
            match Verdict::of_status(&solved.status) {
                Verdict::Converged => solved.cables.first().copied(),
                _ => None,
            }
        })
    }

    /// The area that the line from the base to the tip goes over between the straight
    /// robot and this one, in m²; there and back counts twice.
    fn swept(&self) -> f64 {
        let all = self.run.solution().drive.clone();
        let slack = all.slackened();
        let base = self.goal.robot().base.position;
        let mut target = self.goal.clone();
        let mut drive: Drive = slack.clone();
        target.set_drive(&slack);
        let mut run = Run::new(&target, Start::Straight, Settings::default());
        let mut before = run.finish().tip().position - base;
        let mut area = 0.0;
        for part in 1..=PARTS {
            drive.set_between(&slack, &all, f64::from(part) / f64::from(PARTS));
            target.set_drive(&drive);
            run.retarget(&target);
            let tip = run.finish().tip().position - base;
            area += 0.5 * (before.x * tip.y - before.y * tip.x).abs();
            before = tip;
        }
        area
    }
}

/// The largest amount of some angles; 0 of none.
fn largest(angles: &[f64]) -> f64 {
    let amounts = angles.iter().map(|angle| angle.abs());
    amounts.fold(0.0, greatest)
}
