//! What drives a robot: its cables, each with what is given of it, and the loads on
//! it. No mechanics.

use super::CableState;
use crate::geometry::Vector;
use crate::robot::{Cable, Robot};
use crate::scene::Friction;
use serde::{Deserialize, Serialize};

/// What is given of a cable.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub enum Input {
    /// The length drawn in at the base, in metres; negative lets cable out.
    Pull(f64),
    /// The load that hangs on it below the base, in newtons, at least 0.
    Load(f64),
}

impl Input {
    /// The pull, in metres; 0 where the load is given.
    pub fn pull(self) -> f64 {
        match self {
            Input::Pull(pull) => pull,
            Input::Load(_) => 0.0,
        }
    }

    /// The input a share `t` of the way between two of one kind; the second of two
    /// kinds.
    fn between(a: Self, b: Self, t: f64) -> Self {
        let mix = |a: f64, b: f64| (1.0 - t) * a + t * b;
        match (a, b) {
            (Input::Pull(a), Input::Pull(b)) => Input::Pull(mix(a, b)),
            (Input::Load(a), Input::Load(b)) => Input::Load(mix(a, b)),
            _ => b,
        }
    }
}

/// A cable and what is given of it.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct DrivenCable {
    /// The cable.
    pub cable: Cable,
    /// What is given of it.
    pub input: Input,
}

/// Dead loads, in the frame of the scene.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Loads {
    /// The force on the tip, in newtons.
    pub tip_force: Vector,
    /// The moment on the tip, in N m, clockwise.
    pub tip_moment: f64,
    /// The weight of every disk but the base's, in newtons.
    pub disk: Vector,
    /// The weight of the backbone, in newtons, spread evenly.
    pub backbone: Vector,
}

impl Loads {
    /// Whether there is any.
    pub fn any(&self) -> bool {
        *self != Self::default()
    }

    fn between(a: &Self, b: &Self, t: f64) -> Self {
        let mix = |a: Vector, b: Vector| (1.0 - t) * a + t * b;
        Self {
            tip_force: mix(a.tip_force, b.tip_force),
            tip_moment: (1.0 - t) * a.tip_moment + t * b.tip_moment,
            disk: mix(a.disk, b.disk),
            backbone: mix(a.backbone, b.backbone),
        }
    }

    /// What they bend the robot's tip by when it is straight and they are small, in
    /// radians, were they all to act across it.
    fn turn(&self, robot: &Robot, stiffness: f64) -> f64 {
        let length = robot.length;
        let disks = (robot.segments / robot.segments_per_bay) as f64;
        let across = self.tip_force.norm() / 2.0
            + disks * self.disk.norm() / 3.0
            + self.backbone.norm() / 6.0;
        (across * length + self.tip_moment.abs()) * length / stiffness
    }
}

/// All that drives a robot.
#[derive(Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Drive {
    /// Its cables, at least one but before anything is solved.
    pub cables: Vec<DrivenCable>,
    /// The loads on it.
    pub loads: Loads,
    /// EI, in N m², where it is known. Without it there are no loads, no weight hangs
    /// on a cable and none stretches.
    pub stiffness: Option<f64>,
    /// Where cables and robot rub, and how much.
    pub friction: Friction,
}

impl Clone for Drive {
    fn clone(&self) -> Self {
        Self {
            cables: self.cables.clone(),
            ..*self
        }
    }

    fn clone_from(&mut self, source: &Self) {
        self.cables.clone_from(&source.cables);
        self.loads = source.loads;
        self.stiffness = source.stiffness;
        self.friction = source.friction;
    }
}

impl Drive {
    /// One cable that does not stretch, to the last disk, at a pull in metres.
    pub fn of_pull(robot: &Robot, pull: f64) -> Self {
        let cable = Cable {
            offset: robot.offset,
            last_disk: robot.segments / robot.segments_per_bay,
            compliance: 0.0,
            diameter: robot.sizes.cable,
        };
        Self {
            cables: vec![DrivenCable {
                cable,
                input: Input::Pull(pull),
            }],
            loads: Loads::default(),
            stiffness: None,
            friction: Friction::default(),
        }
    }

    /// What is given of the first cable, in metres; 0 where that is its load.
    pub fn pull(&self) -> f64 {
        self.cables
            .first()
            .map_or(0.0, |driven| driven.input.pull())
    }

    /// The load on the first cable, in newtons, where that is what is given.
    pub fn load(&self) -> Option<f64> {
        match self.cables[0].input {
            Input::Pull(_) => None,
            Input::Load(load) => Some(load),
        }
    }

    /// The change of a pull that is a large one, in metres: the greatest offset, over
    /// which the free robot's tip turns by 1 rad.
    pub fn pull_scale(&self) -> f64 {
        let offsets = self.cables.iter().map(|driven| driven.cable.offset.abs());
        offsets.fold(0.0, f64::max)
    }

    /// Whether two cables that do not stretch are drawn in against each other: to the same
    /// disk, on both sides of the backbone, by pulls that no bend gives both of. Only a
    /// robot that buckles yields a little to that.
    pub fn cables_oppose(&self) -> bool {
        let stiff = self.cables.iter().filter(|it| it.cable.compliance == 0.0);
        let asked = stiff.filter_map(|driven| match driven.input {
            Input::Pull(pull) => Some((driven.cable, pull / driven.cable.offset)),
            Input::Load(_) => None,
        });
        let mut inwards = asked.clone().filter(|(cable, _)| cable.offset > 0.0);
        inwards.any(|(near, least)| {
            asked.clone().any(|(far, most)| {
                far.offset < 0.0 && far.last_disk == near.last_disk && most < least
            })
        })
    }

    /// Whether another drives the same cables, by whatever inputs.
    pub fn same_cables(&self, other: &Self) -> bool {
        let mut pairs = self.cables.iter().zip(&other.cables);
        self.cables.len() == other.cables.len()
            && pairs.all(|(a, b)| a.cable == b.cable)
            && self.stiffness == other.stiffness
    }

    /// The same inputs with the values that cables in these states have.
    pub fn at(&self, states: &[CableState], robot: &Robot) -> Self {
        let mut drive = self.clone();
        let unit = self.stiffness.unwrap_or(0.0) / (2.0 * robot.segment_length());
        for (driven, state) in drive.cables.iter_mut().zip(states) {
            driven.input = match driven.input {
                Input::Pull(_) => Input::Pull(state.pull),
                Input::Load(_) => Input::Load(unit * state.load),
            };
        }
        drive
    }

    /// The same without anything that bends the robot: no pull, no load.
    pub fn slackened(&self) -> Self {
        let mut slack = self.clone();
        for driven in &mut slack.cables {
            driven.input = match driven.input {
                Input::Pull(_) => Input::Pull(0.0),
                Input::Load(_) => Input::Load(0.0),
            };
        }
        slack.loads = Loads::default();
        slack
    }

    /// Whether another drives the same cables by the same kinds of input, so that one
    /// can be turned into the other.
    pub fn resembles(&self, other: &Self) -> bool {
        let same = |(a, b): (&DrivenCable, &DrivenCable)| {
            let kinds = std::mem::discriminant(&a.input) == std::mem::discriminant(&b.input);
            a.cable == b.cable && kinds
        };
        self.stiffness == other.stiffness
            && self.cables.len() == other.cables.len()
            && self.cables.iter().zip(&other.cables).all(same)
    }

    /// Becomes what is a share `t` in \[0, 1\] of the way from `a` to `b`, which
    /// resemble each other and this one. Allocates nothing.
    pub fn set_between(&mut self, a: &Self, b: &Self, t: f64) {
        for (to, (a, b)) in self.cables.iter_mut().zip(a.cables.iter().zip(&b.cables)) {
            to.input = Input::between(a.input, b.input, t);
        }
        self.loads = Loads::between(&a.loads, &b.loads, t);
        let mix = |a: f64, b: f64| (1.0 - t) * a + t * b;
        self.friction = Friction {
            holes: mix(a.friction.holes, b.friction.holes),
            contacts: mix(a.friction.contacts, b.friction.contacts),
            base_loss: mix(a.friction.base_loss, b.friction.base_loss),
        };
    }

    /// How far another is from this, as the pull that would bend a free robot by as
    /// much, in metres. Of one cable under pull it is the change of the pull.
    pub fn change(&self, other: &Self, robot: &Robot) -> f64 {
        let stiffness = self.stiffness.unwrap_or(f64::INFINITY);
        let mut change = 0.0;
        for (a, b) in self.cables.iter().zip(&other.cables) {
            let offset = a.cable.offset.abs();
            change += match (a.input, b.input) {
                (Input::Pull(a), Input::Pull(b)) => (b - a).abs(),
                (Input::Load(a), Input::Load(b)) => {
                    (b - a).abs() * offset * offset * robot.length / stiffness
                }
                _ => offset,
            };
        }
        if self.loads != other.loads {
            let difference = Loads {
                tip_force: other.loads.tip_force - self.loads.tip_force,
                tip_moment: other.loads.tip_moment - self.loads.tip_moment,
                disk: other.loads.disk - self.loads.disk,
                backbone: other.loads.backbone - self.loads.backbone,
            };
            change += robot.offset.abs() * difference.turn(robot, stiffness);
        }
        let (a, b) = (&self.friction, &other.friction);
        let rubs = (b.holes - a.holes).abs()
            + (b.contacts - a.contacts).abs()
            + (b.base_loss - a.base_loss).abs();
        if rubs > 0.0 {
            change += rubs * robot.offset.abs();
        }
        change
    }
}
