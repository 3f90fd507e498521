//! A measured backbone over the computed shape, as a chart to scale.

use super::chart::{Axis, Chart, CurveStyle, Series};
use crate::equilibrium::Solved;
use crate::experiments::{Measured, ShapeFit};
use crate::geometry::Vector;
use crate::math::decimals;
use crate::units::millimetres;

/// The chart of a fit: the solved robot's backbone and cable, in the
/// scene's frame, and the measured points, all in mm.
pub fn compared(solved: &Solved, measured: &Measured, fit: &ShapeFit) -> Chart {
    let name = format!("computed, pull {} mm", decimals(millimetres(fit.pull), 2));
    let cable = solved.cable();
    let points = measured.points().iter().map(|point| point.position);
    Chart {
        title: "Measured and computed backbone".to_owned(),
        word: "both",
        x: Axis::map("x"),
        y: Axis::map("y"),
        series: vec![
            Series::new(name, CurveStyle::Line, outline(solved.backbone())),
            Series::new("cable", CurveStyle::Dashed, outline(cable)),
            Series::new("measured", CurveStyle::Dots, outline(points)),
        ],
    }
}

/// Points in metres as x over y in mm.
pub(super) fn outline(points: impl Iterator<Item = Vector>) -> Vec<(f64, f64)> {
    points
        .map(|p| (millimetres(p.x), millimetres(p.y)))
        .collect()
}
