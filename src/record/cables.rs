//! The record of cables: where they run, and what pulls them.

use serde::Serialize;

use crate::equilibrium::Solved;
use crate::geometry::Vector;
use crate::mechanics::{Drive, Input, Model};
use crate::units::{millimetres, per_millimetre};

/// A cable. What needs a bending stiffness is null without one.
#[derive(Serialize)]
pub struct Cable {
    /// Its distance from the backbone, negative on the −x side of the straight robot.
    pub offset_mm: f64,
    /// Around the backbone, from the straight robot's +x: 0 in the plane, where offsets
    /// have signs.
    pub angle_deg: f64,
    /// The disk that it ends at, the base's being 0.
    pub to_disk: usize,
    /// The length drawn in at the base; of one that stretches, without its stretch.
    pub pull_mm: f64,
    /// The load that hangs on it below the base or that would hold it as it is, in N.
    pub load_n: Option<f64>,
    /// How the energy rises with the pull, in rad²/mm: the tension without a stiffness.
    pub multiplier: f64,
    /// The tension of its first stretch, in N: without friction that of all, and how the
    /// energy in newtons rises with the pull.
    pub tension_n: Option<f64>,
    /// Of each stretch from disk to disk, base first; null in the paper's model, where
    /// links carry it.
    pub tensions_n: Option<Vec<f64>>,
    /// Of each hole, how the cable slips; null without friction.
    pub slips: Option<Vec<&'static str>>,
    /// Whether it hangs loose.
    pub slack: bool,
    /// At every node as far as it goes, base first.
    pub points_mm: Vec<[f64; 2]>,
    /// In the disks as far as it goes, base first.
    pub holes_mm: Vec<[f64; 2]>,
}

impl Cable {
    /// A cable of a solution, by its index; `per_bend` is EI/2l, in N m, where it is
    /// known.
    pub(super) fn of(solved: &Solved, index: usize, per_bend: Option<f64>) -> Self {
        let (problem, state) = (solved.problem(), solved.cables[index]);
        let cable = problem.drive().cables[index].cable;
        let tension = per_bend.map(|per_bend| per_bend * state.tension);
        let slides = problem.model() == Model::Sliding;
        let points = |points: Vec<Vector>| points.into_iter().map(point_mm).collect();
        Self {
            offset_mm: millimetres(cable.offset),
            angle_deg: 0.0,
            to_disk: cable.last_disk,
            pull_mm: millimetres(state.pull),
            load_n: per_bend.map(|per_bend| per_bend * state.load),
            multiplier: per_millimetre(state.tension),
            tension_n: tension,
            tensions_n: per_bend.filter(|_| slides).map(|per_bend| {
                let tensions = solved.tensions(index);
                tensions.iter().map(|tension| per_bend * tension).collect()
            }),
            slips: solved.strands.get(index).map(|strand| {
                let words = strand.slips.iter().map(|slip| slip.word());
                words.collect()
            }),
            slack: state.is_slack,
            points_mm: points(solved.cable_points(index)),
            holes_mm: points(solved.holes(index)),
        }
    }

    /// All its numbers.
    pub(super) fn numbers(&self) -> impl Iterator<Item = f64> + '_ {
        let points = self.points_mm.iter().chain(&self.holes_mm).flatten();
        let tensions = self.tensions_n.iter().flatten();
        [self.pull_mm, self.multiplier]
            .into_iter()
            .chain(self.load_n)
            .chain(tensions.copied())
            .chain(self.tension_n)
            .chain(points.copied())
    }
}

/// What is given of a cable: its pull or its load, the other being null.
#[derive(Serialize)]
pub struct Driven {
    /// The length drawn in.
    pub pull_mm: Option<f64>,
    /// The load that hangs on it, in N.
    pub load_n: Option<f64>,
}

impl Driven {
    /// What is given of every cable.
    pub(super) fn all(drive: &Drive) -> Vec<Self> {
        let inputs = drive.cables.iter().map(|driven| match driven.input {
            Input::Pull(pull) => Self {
                pull_mm: Some(millimetres(pull)),
                load_n: None,
            },
            Input::Load(load) => Self {
                pull_mm: None,
                load_n: Some(load),
            },
        });
        inputs.collect()
    }

    pub(super) fn numbers(&self) -> impl Iterator<Item = f64> + use<> {
        self.pull_mm.into_iter().chain(self.load_n)
    }
}

pub(super) fn point_mm(point: Vector) -> [f64; 2] {
    [millimetres(point.x), millimetres(point.y)]
}
