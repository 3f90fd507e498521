//! The robot against the load cell with a cable that slides: without friction, what
//! mechanics alone says of the force, with nothing fitted to a measurement; and with one
//! set of constants of friction, fitted to all of them.

use super::ExperimentError;
use super::item::Check;
use super::scenes::PaperScene;
use super::table::{Errors, ForceTable};
use crate::forces::{LoadSteps, Stiffness};
use crate::mechanics::Problem;
use crate::scene::{Friction, Line, Listed, Mechanics, Scene, Shape};
use crate::units::{grams, newtons};

/// The friction that comes near the table's 28 forces: the same coefficient in the holes
/// and on the cell, and a loss below the base. Others come as near, with one of the three
/// for another: the data do not tell them apart.
pub(super) const FITTED: Friction = Friction {
    holes: 0.275,
    contacts: 0.275,
    base_loss: 0.165,
};

/// What a cable is called that slides with this friction.
pub(super) fn named(friction: &Friction) -> &'static str {
    if friction.is_none() {
        "sliding cable without friction"
    } else {
        "sliding cable with friction"
    }
}

/// The robot pressed against the cell by loads.
pub(super) struct SlidingCell {
    /// The pull at which it begins to press, in metres.
    pub contact: f64,
    /// The load at which it begins to press, in N.
    pub datum: f64,
    /// The load counted from there, and the force on the cell, both in grams.
    pub by_load_g: Vec<(f64, f64)>,
}

impl SlidingCell {
    /// The cell at a distance from the straight backbone, in mm, under the table's
    /// loads.
    pub(super) fn at(
        distance_mm: f64,
        friction: Friction,
        table: &ForceTable,
    ) -> Result<Self, ExperimentError> {
        Self::of(distance_mm, None, friction, table)
    }

    /// The same where another node of the cable, from 1, is kept off the cell.
    pub(super) fn at_node(
        distance_mm: f64,
        node: usize,
        friction: Friction,
        table: &ForceTable,
    ) -> Result<Self, ExperimentError> {
        Self::of(distance_mm, Some(node), friction, table)
    }

    fn of(
        distance_mm: f64,
        node: Option<usize>,
        friction: Friction,
        table: &ForceTable,
    ) -> Result<Self, ExperimentError> {
        let mut scene = PaperScene::LoadCell.scene()?;
        scene.model.mechanics = Mechanics::Sliding;
        scene.friction = friction;
        if let Some(node) = node {
            scene.contact.listed = vec![Listed {
                line: Line::Cable,
                node: node as u32,
                cable: 0,
            }];
        }
        move_cell(&mut scene, distance_mm);
        let stiffness = Stiffness::of_scene(&scene).ok().flatten();
        let stiffness = stiffness.ok_or(ExperimentError::NoContact("a known stiffness"))?;
        let loads_g: Vec<f64> = table.rows().iter().map(|row| row.load_g).collect();
        let loads: Vec<f64> = loads_g.iter().map(|load| newtons(*load)).collect();
        let steps = LoadSteps::of(&Problem::new(&scene)?, stiffness, &loads)?;
        if let Some(end) = steps.end {
            return Err(end.into());
        }
        let (contact, datum) = (steps.contact, steps.datum);
        let forces = steps.states.iter().map(|state| {
            let contacts = state.statics.contacts.iter();
            grams(contacts.map(|contact| contact.normal_force).sum())
        });
        Ok(Self {
            contact: contact.ok_or(ExperimentError::NoContact("the load cell"))?,
            datum,
            by_load_g: loads_g.into_iter().zip(forces).collect(),
        })
    }

    /// F/P_l, by least squares through 0.
    pub(super) fn force_per_load(&self) -> f64 {
        let points = self.by_load_g.iter();
        let (product, square) = points.fold((0.0, 0.0), |(product, square), (load, force)| {
            (product + load * force, square + load * load)
        });
        product / square
    }

    /// The mean |error| against the forces measured at a distance of the table, by its
    /// place, in grams.
    pub(super) fn mean_error_g(&self, table: &ForceTable, column: usize) -> f64 {
        let pairs = table.rows().iter().zip(&self.by_load_g);
        let errors = pairs.map(|(row, (_, force))| (force - row.measured_g[column]).abs());
        errors.sum::<f64>() / table.rows().len() as f64
    }
}

/// What the two sliding cables make of the table, by distance and over all: force over
/// load with friction, and the average errors, the paper's own beside them.
pub(super) fn errors_by_model(
    table: &ForceTable,
    paper: &Errors,
    frictionless: &[SlidingCell],
    rubbing: &[SlidingCell],
) -> Vec<Check> {
    let mut checks = Vec::new();
    let models = [
        ("sliding cable without friction", frictionless),
        ("sliding cable with friction (fitted)", rubbing),
    ];
    let error = |of: String, error_g: f64| {
        Check::ours(format!("Average error{of}"), "g", error_g).decimals(3)
    };
    for (column, distance) in table.distances_mm().iter().enumerate() {
        let at = format!("d = {distance} mm");
        let papers_g = paper.by_distance_g[column];
        checks.push(error(format!(", the paper's theory, {at}"), papers_g));
        for (model, cells) in models {
            let error_g = cells[column].mean_error_g(table, column);
            checks.push(error(format!(", {model}, {at}"), error_g));
        }
        let quantity = format!("Force over load, sliding cable with friction (fitted), {at}");
        checks.push(Check::ours(quantity, "", rubbing[column].force_per_load()).decimals(4));
    }
    checks.push(error(
        " over all 28, the paper's theory".to_owned(),
        paper.mean_g,
    ));
    for (model, cells) in models {
        let means = cells.iter().enumerate();
        let sum: f64 = means.map(|(k, cell)| cell.mean_error_g(table, k)).sum();
        checks.push(error(
            format!(" over all 28, {model}"),
            sum / cells.len() as f64,
        ));
    }
    checks
}

fn move_cell(scene: &mut Scene, distance_mm: f64) {
    for obstacle in &mut scene.obstacles {
        if let Shape::Wall { point_mm, .. } = &mut obstacle.shape {
            point_mm[0] = distance_mm;
        }
    }
}
