//! What bends the robot, as chains for the solver.
//!
//! [`Problem::new`] parses a scene once into something that cannot be wrong. Each
//! [`Mechanics`] makes a chain of it, and all that a run asks beyond one. SI units
//! throughout.

mod certificate;
mod condition;
mod drive;
mod four_bar;
mod friction;
mod from_scene;
mod problem;
mod sliding;
mod touching;

pub use certificate::Certificate;
pub use condition::{Answers, Condition, ConditionKind};
pub use drive::{Drive, DrivenCable, Input, Loads};
pub use four_bar::{Bend, Certifier, Equal, FourBar, FreeArc, MOST_BEND, MOST_TURN};
pub use friction::{Drag, Rubbing, Slip, Strand};
pub use problem::{Model, Problem};
pub use sliding::{Sliding, rests_under_load};

use crate::contact::Contact;
use crate::geometry::Obstacle;
use crate::robot::Nodes;
use crate::solver::{Chain, Control, Point, RowId};
use serde::{Deserialize, Serialize};
use std::fmt::Debug;
use std::ops::Deref;

/// What is found of a cable.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct CableState {
    /// The length drawn in at the base, in metres; of one that stretches, without its
    /// stretch.
    pub pull: f64,
    /// The tension of its first stretch, in rad²/m as multipliers are: without friction
    /// that of all, dJ/dpull.
    pub tension: f64,
    /// What hangs on it below the base or would hold it as it is, in rad²/m: its tension
    /// where nothing rubs.
    pub load: f64,
    /// Whether it hangs loose.
    pub is_slack: bool,
}

/// A solved point of a mechanics: a shape, and the forces on it.
#[derive(Clone, Copy, Debug)]
pub struct Found<'a, N: ?Sized> {
    /// The nodes, base first.
    pub nodes: &'a N,
    /// What touches.
    pub contacts: &'a [Contact],
    /// The cables, in the order of the scene.
    pub cables: &'a [CableState],
    /// What friction keeps of them; none where nothing rubs.
    pub strands: &'a [Strand],
}

/// What friction says of a shape that was solved for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Settling {
    /// It is as it was frozen.
    Settled,
    /// It has been frozen anew: solve again.
    Again,
    /// It goes round in circles.
    Failed,
}

/// What bends the robot: a chain of a problem, and what a run along a branch of its
/// equilibria and its certificate ask of it beyond that.
pub trait Mechanics<const NU: usize>:
    Chain<3, NU> + Clone + Debug + Deref<Target = Problem>
{
    /// A shape as the chain keeps it.
    type Shape: Nodes + ?Sized;
    /// The storage of a certificate.
    type Certifier: Clone + Debug + Default;

    /// The mechanics of a problem of its model.
    fn new(problem: Problem) -> Self;

    /// Changes the problem.
    fn change(&mut self, change: impl FnOnce(&mut Problem));

    /// The chain's nodes as a shape.
    fn shape(nodes: &[Self::Node]) -> &Self::Shape;

    /// The controls of the free robot at what drives it, or near it.
    fn free_controls(&self) -> Vec<Control<NU>>;

    /// The change of a control that is a large one, whatever the number of segments.
    fn control_scale(&self) -> f64;

    /// The energy Σ β², in rad², that the solver's cost counts as 1; 0 where the robot
    /// has none.
    fn cost_unit(&self) -> f64;

    /// The segment, from 1, that is nearest to its limit.
    fn most_strained(&self, controls: &[Control<NU>]) -> usize;

    /// The segment whose limit a row is, if it is one. Eq. 5 knows no such limit: a
    /// shape that presses against it is none of its equilibria.
    fn limited_segment(&self, row: RowId) -> Option<usize>;

    /// The controls written in a solution; `None` where they are not of this problem.
    fn read_controls(&self, written: &[f64]) -> Option<Vec<Control<NU>>>;

    /// Writes controls, one number a segment.
    fn write_controls(&self, controls: &[Control<NU>], written: &mut Vec<f64>);

    /// Writes ψ of each segment, in radians, clockwise.
    fn write_shears(&self, controls: &[Control<NU>], shears: &mut Vec<f64>);

    /// What is found of the cables at a point with its multipliers.
    fn write_cables(
        &self,
        point: &Point<Self, 3, NU>,
        multipliers: &[f64],
        cables: &mut Vec<CableState>,
    );

    /// Whether friction has a say.
    fn rubs(&self) -> bool {
        false
    }

    /// Freezes friction as it is in a shape that a step starts from, among obstacles
    /// where they were then.
    fn freeze(&mut self, _obstacles: &[Obstacle], _nodes: &[Self::Node], _rubbing: &Rubbing) {}

    /// Freezes friction as it is frozen in another solve of the same cables.
    fn freeze_like(&mut self, _other: &Self) {}

    /// Adds the multipliers of the rows that hold cables, as frozen.
    fn add_tensions(&self, _multipliers: &mut Vec<(RowId, f64)>) {}

    /// Freezes friction as it would be at the end of a solve.
    fn settle(&mut self, _point: &Point<Self, 3, NU>, _multipliers: &[f64]) -> Settling {
        Settling::Settled
    }

    /// Lets go of the friction of contacts in this solve, where it cannot be settled.
    /// Whether there was any.
    fn let_go(&mut self) -> bool {
        false
    }

    /// Whether this solve goes without it.
    fn has_let_go(&self) -> bool {
        false
    }

    /// Writes what friction keeps of a point where it has settled.
    fn write_rubbing(
        &self,
        _point: &Point<Self, 3, NU>,
        _multipliers: &[f64],
        _rubbing: &mut Rubbing,
    ) {
    }

    /// The certificate of what was found.
    fn certify(
        &self,
        certifier: &mut Self::Certifier,
        found: Found<'_, Self::Shape>,
    ) -> Certificate;
}
