//! The record of a measured backbone against the computed one.

use serde::Serialize;

use crate::experiments::{Measured, ShapeFit};
use crate::math::shortest;
use crate::mechanics::Problem;
use crate::units::millimetres;

/// The version of the keys below.
const SCHEMA: &str = "sinew-compare-1";

/// How near the shapes are, in the order of its keys in JSON.
#[derive(Serialize)]
pub struct Fit {
    /// The version of the keys.
    pub schema: &'static str,
    /// What the scene is called.
    pub title: String,
    /// The pull of the computed shape.
    pub pull_mm: f64,
    /// `given`, `best fit` or, where the given one is not reached, that it is
    /// the last good one.
    pub pull: &'static str,
    /// What each point was compared with.
    pub against: &'static str,
    /// The root of the mean squared distance.
    pub rms_mm: f64,
    /// The same, of the backbone's length.
    pub rms_percent_of_length: f64,
    /// The greatest distance.
    pub max_mm: f64,
    /// The same, of the backbone's length.
    pub max_percent_of_length: f64,
    /// The row of the farthest point.
    pub max_row: usize,
    /// The length of the line through the points.
    pub length_mm: f64,
    /// The same, of the backbone's length.
    pub length_percent: f64,
    /// The rows that hold nothing.
    pub left_out: Vec<usize>,
    /// The measured points, by row.
    pub points: Vec<FitPoint>,
}

/// A measured point.
#[derive(Serialize)]
pub struct FitPoint {
    /// Its row in the file, from 1.
    pub row: usize,
    /// Its place, in the scene's frame.
    pub x_mm: f64,
    /// See `x_mm`.
    pub y_mm: f64,
    /// How far it is from what it was compared with.
    pub distance_mm: f64,
}

impl Fit {
    /// The record of a fit to a problem's robot; `how` says where its pull is
    /// from.
    pub fn of(
        title: String,
        how: &'static str,
        problem: &Problem,
        measured: &Measured,
        fit: &ShapeFit,
    ) -> Self {
        let percent = |distance: f64| 100.0 * distance / problem.length();
        let points = measured.points().iter().zip(&fit.distances);
        Self {
            schema: SCHEMA,
            title,
            pull_mm: millimetres(fit.pull),
            pull: how,
            against: if measured.by_node() {
                "its own node"
            } else {
                "the nearest point of the backbone"
            },
            rms_mm: millimetres(fit.rms),
            rms_percent_of_length: percent(fit.rms),
            max_mm: millimetres(fit.max),
            max_percent_of_length: percent(fit.max),
            max_row: fit.max_row,
            length_mm: millimetres(measured.length()),
            length_percent: percent(measured.length()),
            left_out: Vec::new(),
            points: points
                .map(|(point, distance)| FitPoint {
                    row: point.row,
                    x_mm: millimetres(point.position.x),
                    y_mm: millimetres(point.position.y),
                    distance_mm: millimetres(*distance),
                })
                .collect(),
        }
    }

    /// With the rows of the points' file that hold nothing.
    pub fn leaving_out(self, rows: &[usize]) -> Self {
        Self {
            left_out: rows.to_vec(),
            ..self
        }
    }

    /// The names of a table's columns, a row a point.
    pub const COLUMNS: [&str; 4] = ["row", "x_mm", "y_mm", "distance_mm"];

    /// Its rows, every number with all its digits.
    pub fn rows(&self) -> impl Iterator<Item = [String; 4]> + '_ {
        self.points.iter().map(|point| {
            [
                point.row.to_string(),
                shortest(point.x_mm),
                shortest(point.y_mm),
                shortest(point.distance_mm),
            ]
        })
    }
}
