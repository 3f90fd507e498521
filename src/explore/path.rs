//! A robot's equilibria along its pull, as data, and what lies between them.

use crate::equilibrium::{Event, Solution, Status};
use crate::forces::{Sweep, SweepPoint};
use crate::geometry::Vector;
use crate::mechanics::CableState;
use crate::robot::{Line, PlanarNode};
use serde::{Deserialize, Serialize};

/// A contact that carries a force.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Pressing {
    /// The line of the robot.
    pub line: Line,
    /// The node, from 1; the upper one of a link.
    pub node: usize,
    /// Index of the obstacle in the problem.
    pub obstacle: usize,
    /// λ, in rad²/m, > 0.
    pub multiplier: f64,
    /// The unit normal from the obstacle into the robot.
    pub normal: Vector,
    /// The touching point of the obstacle's surface, in metres.
    pub point: Vector,
}

/// The robot at one pull.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct PathState {
    /// The pull, in metres.
    pub pull: f64,
    /// Which smooth piece of the path: 0 is that of the straight robot, and
    /// every jump on the way away from it leads to the next, upwards for pulls
    /// above zero and downwards for those below.
    pub branch: i32,
    /// The last node.
    pub tip: PlanarNode,
    /// J = Σ β², in rad².
    pub energy: f64,
    /// dJ/dl, in rad²/m: the cable's tension without its stiffness.
    pub energy_slope: f64,
    /// What presses, by candidate.
    pub contacts: Vec<Pressing>,
    /// The cables, in the order of the scene.
    pub cables: Vec<CableState>,
}

/// Where a path stops short of the last pull asked for.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct End {
    /// The last pull that has an equilibrium, in metres.
    pub pull: f64,
    /// Why there is none after it.
    pub status: Status,
}

/// A robot's equilibria along its pull, from the straight robot on.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Path {
    /// By rising pull. Only those of equilibria whose certificate holds.
    pub states: Vec<PathState>,
    /// What happened, by rising pull.
    pub events: Vec<Event>,
    /// Where the path stops on the way up, if it does.
    pub end: Option<End>,
    /// Where it stops on the way to pulls below zero, if it does.
    pub start: Option<End>,
    /// The backbone's length, in metres: what distances are measured by.
    pub length: f64,
}

/// Tips this near to each other, over the backbone's length, are the same: far
/// above the solver's tolerance, far below what tells branches apart.
const SAME: f64 = 1e-6;

impl PathState {
    /// The state of a solution on a branch.
    pub(super) fn of(solution: &Solution, branch: i32) -> Self {
        Self {
            pull: solution.pull,
            branch,
            tip: solution.tip(),
            energy: solution.energy,
            energy_slope: solution.energy_slope(),
            contacts: solution
                .pressing()
                .map(|contact| Pressing {
                    line: contact.line,
                    node: contact.node,
                    obstacle: contact.obstacle,
                    multiplier: contact.multiplier,
                    normal: contact.normal,
                    point: contact.point,
                })
                .collect(),
            cables: solution.cables.clone(),
        }
    }

    /// What hangs on the first cable, or would hold it, in rad²/m: its tension, and
    /// with friction what is lost below the base.
    pub fn load(&self) -> f64 {
        self.cables
            .first()
            .map_or(self.energy_slope, |cable| cable.load)
    }

    /// Σ λ of what presses, in rad²/m.
    pub fn total_multiplier(&self) -> f64 {
        self.contacts.iter().map(|c| c.multiplier).sum()
    }

    /// The state a share `t` of the way to another one of the same branch. A
    /// contact that only one of the two has grows from nothing.
    fn towards(&self, other: &Self, t: f64) -> Self {
        let mix = |a: f64, b: f64| (1.0 - t) * a + t * b;
        let blend = |a: Vector, b: Vector| (1.0 - t) * a + t * b;
        let angle = mix(self.tip.angle, other.tip.angle);
        let mut contacts: Vec<Pressing> = Vec::new();
        for here in &self.contacts {
            let there = other.contacts.iter().find(|c| c.part() == here.part());
            contacts.push(match there {
                Some(there) => Pressing {
                    multiplier: mix(here.multiplier, there.multiplier),
                    normal: blend(here.normal, there.normal).normalize(),
                    point: blend(here.point, there.point),
                    ..*here
                },
                None => Pressing {
                    multiplier: mix(here.multiplier, 0.0),
                    ..*here
                },
            });
        }
        for there in &other.contacts {
            if !self.contacts.iter().any(|c| c.part() == there.part()) {
                let multiplier = mix(0.0, there.multiplier);
                contacts.push(Pressing {
                    multiplier,
                    ..*there
                });
            }
        }
        contacts.retain(|contact| contact.multiplier > 0.0);
        let cables = self.cables.iter().zip(&other.cables);
        let cables = cables.map(|(here, there)| CableState {
            pull: mix(here.pull, there.pull),
            tension: mix(here.tension, there.tension),
            load: mix(here.load, there.load),
            is_slack: if t < 0.5 {
                here.is_slack
            } else {
                there.is_slack
            },
        });
        Self {
            pull: mix(self.pull, other.pull),
            branch: self.branch,
            tip: PlanarNode {
                position: blend(self.tip.position, other.tip.position),
                disk: Vector::new(libm::cos(angle), libm::sin(angle)),
                angle,
            },
            energy: mix(self.energy, other.energy),
            energy_slope: mix(self.energy_slope, other.energy_slope),
            contacts,
            cables: cables.collect(),
        }
    }
}

impl Pressing {
    /// The part of the robot and the obstacle.
    fn part(&self) -> (Line, usize, usize) {
        (self.line, self.node, self.obstacle)
    }
}

impl Path {
    /// The smooth pieces of the path, by rising pull: between two of them the
    /// robot jumps. None is empty.
    pub fn pieces(&self) -> impl Iterator<Item = &[PathState]> {
        self.states.chunk_by(|a, b| a.branch == b.branch)
    }

    /// The least and the greatest pull that have states, in metres; `None` without
    /// states.
    pub fn range(&self) -> Option<(f64, f64)> {
        Some((self.states.first()?.pull, self.states.last()?.pull))
    }

    /// The tip's part of the path as a sweep, for lines through it; `tip` is the
    /// robot's last node.
    pub fn tip_sweep(&self, tip: usize) -> Sweep {
        let points = self.states.iter().map(|state| SweepPoint {
            pull: state.pull,
            x: state.tip.position.x,
            y: state.tip.position.y,
            angle: state.tip.angle,
            energy_slope: state.energy_slope,
            pressing: state.contacts.len(),
        });
        Sweep {
            node: tip,
            points: points.collect(),
        }
    }

    /// The state at a pull: straight between its neighbours, which errs by the
    /// square of their distance; at a jump the nearer of them. `None` outside
    /// the path's range.
    pub fn at(&self, pull: f64) -> Option<PathState> {
        let above = self.bracket(pull)?;
        let (a, b) = (&self.states[above - 1], &self.states[above]);
        let share = (pull - a.pull) / (b.pull - a.pull);
        Some(if share == 0.0 || (a.branch != b.branch && share < 0.5) {
            a.clone()
        } else if share == 1.0 || a.branch != b.branch {
            b.clone()
        } else {
            // Not what rounding makes of it.
            PathState {
                pull,
                ..a.towards(b, share)
            }
        })
    }

    /// Whether a solution of the same robot among the same obstacles is on
    /// another branch than the path at its pull, which happens after a jump on
    /// the way back and after obstacles were moved around the robot. `false`
    /// where the path says nothing yet; `true` past its end. The tip's place
    /// and slope decide.
    pub fn differs_from(&self, solution: &Solution) -> bool {
        if !solution.certificate.holds() {
            return false;
        }
        let pull = solution.pull;
        let Some(expected) = self.at(pull) else {
            let grain = SAME * self.length;
            let past = self.end.as_ref().is_some_and(|e| pull > e.pull + grain);
            let below = self.start.as_ref().is_some_and(|s| pull < s.pull - grain);
            return past || below;
        };
        let tip = solution.tip();
        let apart = |a: &PlanarNode, b: &PlanarNode| {
            let turned = self.length * (a.angle - b.angle).abs();
            (a.position - b.position).norm().max(turned)
        };
        apart(&expected.tip, &tip) > SAME * self.length + self.bow(pull)
    }

    /// How far the path may be from the straight line between the states about
    /// a pull, in metres of the tip: half the second differences there, four
    /// times what a smooth curve needs and twice what one with a corner does.
    fn bow(&self, pull: f64) -> f64 {
        let Some(above) = self.bracket(pull) else {
            return 0.0;
        };
        let states = &self.states;
        let exact = |i: usize| states[i].pull == pull;
        if exact(above) || exact(above - 1) {
            return 0.0;
        }
        let second = |i: usize| {
            let (Some(before), Some(after)) = (i.checked_sub(1), states.get(i + 1)) else {
                return 0.0;
            };
            let (a, b) = (&states[before], &states[i]);
            if a.branch != b.branch || b.branch != after.branch {
                return 0.0;
            }
            // Scaled to the bracket's width, since spacings may differ.
            let width = states[above].pull - states[above - 1].pull;
            let rate = |p: &PathState, q: &PathState| {
                let place = (q.tip.position - p.tip.position) / (q.pull - p.pull);
                (place, (q.tip.angle - p.tip.angle) / (q.pull - p.pull))
            };
            let (one, two) = (rate(a, b), rate(b, after));
            let turned = self.length * (two.1 - one.1).abs();
            width * (two.0 - one.0).norm().max(turned)
        };
        0.5 * (second(above - 1) + second(above))
    }

    /// The index of the upper of the two states about a pull, at least 1.
    fn bracket(&self, pull: f64) -> Option<usize> {
        let (first, last) = self.range()?;
        if self.states.len() < 2 || !(first..=last).contains(&pull) {
            return None;
        }
        let above = self.states.partition_point(|state| state.pull < pull);
        Some(above.max(1))
    }
}
