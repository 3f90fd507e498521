//! The robot against the load cell with a cable that slides: without friction, what
//! mechanics alone says of the force, with nothing fitted to a measurement; and with one
//! set of constants of friction, fitted to all of them.

use super::ExperimentError;
use super::item::Check;
use super::scenes::PaperScene;
use super::table::ForceTable;
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

/// The robot pressed against the cell by loads.
pub(super) struct SlidingCell {
    /// The pull at which it begins to press, in metres.
    pub contact: f64,
    /// The load counted from there, and the force on the cell, both in grams.
    pub by_load_g: Vec<(f64, f64)>,
}

impl SlidingCell {
    /// The cell at a distance from the straight backbone, in mm, under the table's
    /// loads.
    pub(super) fn at(distance_mm: f64, table: &ForceTable) -> Result<Self, ExperimentError> {
        Self::of(distance_mm, None, Friction::default(), table)
    }

    /// The same where another node of the cable, from 1, is kept off the cell.
    pub(super) fn at_node(
        distance_mm: f64,
        node: usize,
        table: &ForceTable,
    ) -> Result<Self, ExperimentError> {
        Self::of(distance_mm, Some(node), Friction::default(), table)
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
        let contact = steps.contact;
        let forces = steps.states.iter().map(|state| {
            let contacts = state.statics.contacts.iter();
            grams(contacts.map(|contact| contact.normal_force).sum())
        });
        Ok(Self {
            contact: contact.ok_or(ExperimentError::NoContact("the load cell"))?,
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
}

/// What the fitted friction makes of the table: force over load and the average error by
/// distance, and the error over all.
pub(super) fn with_friction(table: &ForceTable) -> Result<Vec<Check>, ExperimentError> {
    let mut checks = Vec::new();
    let (mut sum, mut count) = (0.0, 0);
    for (column, distance) in table.distances_mm().iter().enumerate() {
        let cell = SlidingCell::of(*distance, None, FITTED, table)?;
        let pairs = table.rows().iter().zip(&cell.by_load_g);
        let errors = pairs.map(|(row, (_, force))| (force - row.measured_g[column]).abs());
        let here: f64 = errors.sum();
        sum += here;
        count += table.rows().len();
        let at = format!("sliding cable with friction (fitted), d = {distance} mm");
        checks.push(
            Check::ours(format!("Force over load, {at}"), "", cell.force_per_load()).decimals(4),
        );
        let mean = here / table.rows().len() as f64;
        checks.push(Check::ours(format!("Average error, {at}"), "g", mean).decimals(3));
    }
    let name = "Average error over all 28, sliding cable with friction (fitted)";
    checks.push(Check::ours(name, "g", sum / f64::from(count as u32)).decimals(3));
    Ok(checks)
}

fn move_cell(scene: &mut Scene, distance_mm: f64) {
    for obstacle in &mut scene.obstacles {
        if let Shape::Wall { point_mm, .. } = &mut obstacle.shape {
            point_mm[0] = distance_mm;
        }
    }
}
