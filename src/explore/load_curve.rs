//! Forces along a path, against the load on the cable: a curve where
//! [`crate::forces::Loading`] finds single points, from states that are known.
//!
//! Loads count from contact, as the paper's P_l: what hangs on the cable
//! is what it was when the robot began to press, and P_l more.

use super::path::Path;
use crate::forces::Stiffness;
use crate::mechanics::Problem;

/// The forces at one pull.
#[derive(Clone, Debug, PartialEq)]
pub struct LoadPoint {
    /// The pull, in metres.
    pub pull: f64,
    /// The smooth piece of the path, as [`super::PathState::branch`].
    pub branch: i32,
    /// P_l, counted from contact, in N; falls where the robot slips.
    pub load: f64,
    /// The sum of all normal forces, in N.
    pub total: f64,
    /// The sum of the normal forces on each of [`LoadCurve::obstacles`], in N.
    pub by_obstacle: Vec<f64>,
}

/// Forces against the load, from contact on.
#[derive(Clone, Debug, PartialEq)]
pub struct LoadCurve {
    /// The pull at which the robot begins to press, in metres; `None` where it
    /// presses on nothing.
    pub contact: Option<f64>,
    /// What hangs on the first cable there, which loads are counted from, in N; 0 without
    /// contact.
    pub datum: f64,
    /// The obstacles that are pressed on somewhere, by index.
    pub obstacles: Vec<usize>,
    /// By rising pull, from contact on, or from the straight robot on where it
    /// presses on nothing.
    pub points: Vec<LoadPoint>,
}

impl LoadCurve {
    /// The forces on a robot of this stiffness along its path. They err by the
    /// square of the distance between the path's states.
    pub fn of(path: &Path, problem: &Problem, stiffness: Stiffness) -> Self {
        let per_bend = stiffness.per_bend(problem);
        let states = &path.states[path.states.partition_point(|state| state.pull < 0.0)..];
        let mut obstacles: Vec<usize> = states
            .iter()
            .flat_map(|state| state.contacts.iter().map(|contact| contact.obstacle))
            .collect();
        obstacles.sort_unstable();
        obstacles.dedup();
        let pressing = states.iter().position(|state| !state.contacts.is_empty());
        // A path has both sides of every change: the first that presses does not
        // yet press to speak of.
        let onset = pressing.map(|first| &states[first]);
        let datum = onset.map_or(0.0, |state| per_bend * state.load());
        let from_contact = &states[pressing.unwrap_or(0)..];
        let points = from_contact.iter().map(|state| {
            let on = |obstacle: &usize| {
                let pressing = state.contacts.iter();
                let on_it = pressing.filter(|contact| contact.obstacle == *obstacle);
                per_bend * on_it.map(|contact| contact.multiplier).sum::<f64>()
            };
            LoadPoint {
                pull: state.pull,
                branch: state.branch,
                load: per_bend * state.load() - datum,
                total: per_bend * state.total_multiplier(),
                by_obstacle: obstacles.iter().map(on).collect(),
            }
        });
        Self {
            contact: onset.map(|state| state.pull),
            datum,
            points: points.collect(),
            obstacles,
        }
    }

    /// The point under a load, in N: the first at which it is reached, straight
    /// between the curve's points. `None` where it never is.
    pub fn at(&self, load: f64) -> Option<LoadPoint> {
        let after = self.points.iter().position(|point| point.load >= load)?;
        let b = &self.points[after];
        let before = after.checked_sub(1).map(|i| &self.points[i]);
        let Some(a) = before.filter(|a| a.branch == b.branch && a.load < b.load) else {
            return (b.load == load).then(|| b.clone());
        };
        let point = a.towards(b, (load - a.load) / (b.load - a.load));
        Some(LoadPoint { load, ..point })
    }

    /// The point at a pull, in metres, straight between the curve's points; at a
    /// jump the one after it. `None` outside the curve.
    pub fn at_pull(&self, pull: f64) -> Option<LoadPoint> {
        let after = self.points.iter().position(|point| point.pull >= pull)?;
        let b = &self.points[after];
        let before = after.checked_sub(1).map(|i| &self.points[i]);
        let Some(a) = before.filter(|a| a.branch == b.branch) else {
            return (after > 0 || b.pull == pull).then(|| b.clone());
        };
        let point = a.towards(b, (pull - a.pull) / (b.pull - a.pull));
        Some(LoadPoint { pull, ..point })
    }
}

impl LoadPoint {
    /// The point a share `t` of the way to another one of the same branch.
    fn towards(&self, other: &Self, t: f64) -> Self {
        let mix = |a: f64, b: f64| (1.0 - t) * a + t * b;
        let pairs = self.by_obstacle.iter().zip(&other.by_obstacle);
        Self {
            pull: mix(self.pull, other.pull),
            branch: self.branch,
            load: mix(self.load, other.load),
            total: mix(self.total, other.total),
            by_obstacle: pairs.map(|(a, b)| mix(*a, *b)).collect(),
        }
    }
}
