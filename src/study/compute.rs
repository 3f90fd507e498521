//! One sample, from its index to its row: its scene, the way from the straight robot,
//! the outputs. The same bits wherever it is computed.

use super::design::Study;
use super::output::Output;
use super::row::{Row, Verdict};
use crate::contact::Class;
use crate::equilibrium::{Occurrence, Run, Settings, Solved, Start, solve};
use crate::experiments::{Measured, compare};
use crate::forces::Stiffness;
use crate::geometry::Vector;
use crate::math::greatest;
use crate::mechanics::{Drive, Problem};
use crate::scene::Scene;
use crate::units::{degrees, grams, millimetres};

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
            solved: run.solved(),
            // Its range was checked with the scene's.
            stiffness: Stiffness::of_scene(scene).ok().flatten(),
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
    solved: Solved,
    stiffness: Option<Stiffness>,
}

impl Measure<'_> {
    fn number(&self, output: Output) -> Option<f64> {
        let solved = &self.solved;
        let truth = |holds: bool| f64::from(u8::from(holds));
        let pressing = || {
            solved
                .contacts
                .iter()
                .filter(|c| c.class == Class::Pressing)
        };
        let per_bend = self
            .stiffness
            .map(|stiffness| stiffness.per_bend(self.goal));
        let force = |multiplier: f64| per_bend.map(|per_bend| per_bend * multiplier);
        let tip = || solved.tip().position;
        let millimetres = |length: f64| Some(millimetres(length));
        match output {
            Output::Status => Some(truth(self.is_converged())),
            Output::Certificate => Some(truth(solved.certificate.holds())),
            Output::StableUnderLoad => solved.rests_under_load().map(truth),
            Output::TipX => millimetres(tip().x),
            Output::TipY => millimetres(tip().y),
            Output::TipSlope => Some(degrees(solved.bends.iter().sum())),
            Output::Reach => millimetres((tip() - self.straight_tip()).norm()),
            Output::Swept => Some(self.swept() * 1e6),
            Output::TargetDistance => {
                let [x, y] = self.study.file().target_mm?;
                let target = Vector::new(crate::units::metres(x), crate::units::metres(y));
                millimetres((tip() - target).norm())
            }
            Output::ProfileRms => {
                let held = self.scene.measured.as_ref()?;
                let measured = Measured::of_scene(held, self.goal).ok()?;
                millimetres(compare(solved, &measured).rms)
            }
            Output::ClearanceMin => {
                let clearances = solved.clearances();
                let least = clearances
                    .iter()
                    .map(|one| one.clearance)
                    .reduce(f64::min)?;
                // What touches is there to the solver's tolerance, below a nanometre.
                millimetres(if pressing().next().is_some() {
                    0.0
                } else {
                    least
                })
            }
            Output::Contacts => Some(pressing().count() as f64),
            Output::ForceMax => force(largest(pressing().map(|contact| contact.multiplier))),
            Output::ForceTotal => force(pressing().map(|contact| contact.multiplier).sum()),
            Output::Tension => force(largest(solved.cables.iter().map(|cable| cable.tension))),
            Output::Pull => millimetres(solved.cables.first()?.pull),
            Output::Load => force(solved.cables.first()?.tension).map(grams),
            Output::FirstContactPull => self.at_first_contact(|solved| {
                solved
                    .cables
                    .first()
                    .map(|cable| crate::units::millimetres(cable.pull))
            }),
            Output::FirstContactLoad => self.at_first_contact(|solved| {
                let tension = solved.cables.first()?.tension;
                force(tension).map(grams)
            }),
            Output::BendMax => Some(degrees(largest(solved.bends.iter().map(|b| b.abs())))),
            Output::ShearMax => Some(degrees(largest(solved.shears.iter().map(|s| s.abs())))),
            Output::Energy => force(solved.energy).and_then(millimetres),
            Output::ReachedShare => Some(self.run.driven_share()),
            Output::EndPull => {
                let pull = solved.cables.first()?.pull;
                if self.is_converged() {
                    None
                } else {
                    millimetres(pull)
                }
            }
            Output::Jumps => {
                let events = solved.events.iter();
                let jumps = events.filter(|event| matches!(event.what, Occurrence::Jump { .. }));
                Some(jumps.count() as f64)
            }
        }
    }

    fn is_converged(&self) -> bool {
        Verdict::of_status(&self.solved.status) == Verdict::Converged
    }

    /// The straight robot's tip.
    fn straight_tip(&self) -> Vector {
        let base = self.goal.robot().base;
        // The disks' direction turned to the backbone's.
        base.position + self.goal.length() * Vector::new(-base.disk.y, base.disk.x)
    }

    /// What a robot that touches nothing tells where this one first does; at what is
    /// given there of its cables. `None` where it never touches.
    fn at_first_contact(&self, tell: impl Fn(&Solved) -> Option<f64>) -> Option<f64> {
        let first = self.solved.events.iter().find(|event| {
            matches!(
                event.what,
                Occurrence::ContactMade { .. } | Occurrence::PushedAside { .. }
            )
        })?;
        let drive = self.run.drive_at(first.share);
        let mut free = free_of_obstacles(self.scene)?;
        free.set_drive(&drive);
        let solved = solve(&free, Start::Straight, Settings::default());
        if Verdict::of_status(&solved.status) != Verdict::Converged {
            return None;
        }
        tell(&solved)
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

/// The problem of the same robot with nothing around it.
fn free_of_obstacles(scene: &Scene) -> Option<Problem> {
    let mut alone = scene.clone();
    alone.obstacles.clear();
    Problem::new(&alone).ok()
}

/// The largest of some numbers that are at least 0; 0 of none.
fn largest(numbers: impl Iterator<Item = f64>) -> f64 {
    numbers.fold(0.0, greatest)
}
