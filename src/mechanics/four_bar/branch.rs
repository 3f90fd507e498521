//! What a run asks of the four-bar robot beyond the chain: which controls it
//! starts from, how large a change of them matters, where it is strained most, and
//! what the solver's cost counts as 1.

use super::certifier::Certifier;
use super::chain::Equal;
use crate::contact::RowKind;
use crate::mechanics::{CableState, Certificate, Found, Mechanics, Problem};
use crate::robot::PlanarNode;
use crate::solver::{Control, Point, RowId};
use std::ops::Deref;

impl Deref for Equal {
    type Target = Problem;

    fn deref(&self) -> &Problem {
        &self.0
    }
}

impl Mechanics<1> for Equal {
    type Shape = [PlanarNode];
    type Certifier = Certifier;

    fn new(problem: Problem) -> Self {
        Self(problem)
    }

    fn change(&mut self, change: impl FnOnce(&mut Problem)) {
        change(&mut self.0);
    }

    fn shape(nodes: &[PlanarNode]) -> &[PlanarNode] {
        nodes
    }

    /// No turn anywhere: straight, or an arc.
    fn free_controls(&self) -> Vec<Control<1>> {
        vec![Control::zeros(); self.robot().segments]
    }

    /// A turn of 1 rad.
    fn control_scale(&self) -> f64 {
        1.0
    }

    /// The cost is Σ (β/β*)²; 0 without pull.
    fn cost_unit(&self) -> f64 {
        let bend = self.segment().free_bend();
        bend * bend
    }

    /// The one whose shorter link turned most.
    fn most_strained(&self, controls: &[Control<1>]) -> usize {
        let turns = controls.iter().map(|control| control[0].abs());
        let most = turns.enumerate().fold(
            (0, 0.0),
            |most, next| {
                if next.1 > most.1 { next } else { most }
            },
        );
        most.0 + 1
    }

    fn limited_segment(&self, row: RowId) -> Option<usize> {
        match RowKind::of(row, self.obstacles().len()) {
            RowKind::TurnLimit { segment, .. } => Some(segment),
            RowKind::Contact { .. } | RowKind::Cable { .. } => None,
        }
    }

    fn read_controls(&self, written: &[f64]) -> Option<Vec<Control<1>>> {
        let fits = written.len() == self.robot().segments && written.iter().all(|u| u.is_finite());
        fits.then(|| written.iter().map(|u| Control::from_element(*u)).collect())
    }

    fn write_controls(&self, controls: &[Control<1>], written: &mut Vec<f64>) {
        written.clear();
        written.extend(controls.iter().map(|u| u[0]));
    }

    fn write_shears(&self, controls: &[Control<1>], shears: &mut Vec<f64>) {
        shears.clear();
        shears.extend(controls.iter().map(|turn| self.segment().shear(turn[0])));
    }

    /// Its tension is found by the certificate.
    fn write_cables(
        &self,
        _point: &Point<Self, 3, 1>,
        _multipliers: &[f64],
        cables: &mut Vec<CableState>,
    ) {
        cables.clear();
    }

    fn certify(&self, certifier: &mut Certifier, found: Found<'_, [PlanarNode]>) -> Certificate {
        let offset = self.robot().offset;
        let points = found
            .nodes
            .iter()
            .map(|node| (node.position, node.at(offset)));
        certifier.certify(self, points, found.contacts)
    }
}
