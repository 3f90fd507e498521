//! The paper's figures and table as charts, from what was computed for them.

use super::chart::{Axis, Chart, CurveStyle, Series};
use super::compared::outline;
use crate::experiments::{
    Backbone, CalibrationErrors, CellForces, Data, DiskForces, DiskModel, Forces, Item,
    PostMultipliers, TipMotion,
};
use crate::forces::{LineFit, SweepPoint};
use crate::units::{degrees, millimetres, per_millimetre};

/// The charts of a figure or table, in the order of its data.
pub fn charts(item: &Item) -> Vec<Chart> {
    let of = |data: &Data| match data {
        Data::Backbones(backbones) => vec![shapes(backbones)],
        Data::Multipliers(posts) => vec![multipliers(posts)],
        Data::TipMotion(motion) => vec![displacement(motion), slope(motion)],
        Data::CellForces(forces) => vec![cell_forces(forces)],
        Data::DiskForces(model, forces) => vec![disk_forces(*model, forces)],
        Data::CalibrationErrors(errors) => vec![calibration(errors)],
    };
    item.data.iter().flat_map(of).collect()
}

fn shapes(backbones: &[Backbone]) -> Chart {
    let series = backbones.iter().map(|backbone| {
        let name = format!("{} mm", backbone.pull_mm);
        let points = outline(backbone.points.iter().copied());
        Series::new(name, CurveStyle::Line, points)
    });
    Chart {
        title: "Backbone at four pulls".to_owned(),
        word: "shapes",
        x: Axis::map("x"),
        y: Axis::map("y"),
        series: series.collect(),
    }
}

fn multipliers(posts: &[PostMultipliers]) -> Chart {
    // The paper counts nodes from 1, and the base has none. Its axis is in
    // millionths, so that the ticks are short.
    let point = |(index, multiplier): (usize, &f64)| {
        let micro = per_millimetre(*multiplier) * 1e6;
        ((index + 2) as f64, micro + 0.0)
    };
    let series = posts.iter().map(|post| {
        let points = post.by_node.iter().enumerate().map(point);
        Series::new(post.name, CurveStyle::Stems, points.collect())
    });
    Chart {
        title: "Multipliers of the cable's nodes".to_owned(),
        word: "multipliers",
        x: Axis::new("node, from 1", ""),
        y: Axis::new("multiplier", "10⁻⁶ rad²/mm"),
        series: series.collect(),
    }
}

/// A quantity of the tip over the pull in mm, in the chart's unit.
fn curve(motion: &TipMotion, of: impl Fn(&SweepPoint) -> f64) -> Vec<(f64, f64)> {
    let points = motion.sweep.points.iter();
    points.map(|p| (millimetres(p.pull), of(p))).collect()
}

/// The ends of its straight line over the window, less its value at no pull.
fn line(motion: &TipMotion, fit: &LineFit, from: f64, scale: fn(f64) -> f64) -> Vec<(f64, f64)> {
    let ends = [motion.window.first, motion.window.last];
    let end = |pull| (millimetres(pull), scale(fit.at(pull) - from));
    ends.map(end).to_vec()
}

fn displacement(motion: &TipMotion) -> Chart {
    let (start, rates) = (motion.sweep.points[0], &motion.rates);
    let (x, y) = (
        curve(motion, |p| millimetres(p.x - start.x)),
        curve(motion, |p| millimetres(p.y - start.y)),
    );
    let x_line = line(motion, &rates.x, start.x, millimetres);
    let y_line = line(motion, &rates.y, start.y, millimetres);
    Chart {
        title: "Displacement of the tip".to_owned(),
        word: "displacement",
        x: Axis::new("pull", "mm"),
        y: Axis::new("displacement", "mm"),
        series: vec![
            Series::new("x", CurveStyle::Line, x),
            Series::new("x, line", CurveStyle::Dashed, x_line),
            Series::new("y", CurveStyle::Line, y),
            Series::new("y, line", CurveStyle::Dashed, y_line),
        ],
    }
}

fn slope(motion: &TipMotion) -> Chart {
    let start = motion.sweep.points[0].angle;
    let angle = curve(motion, |p| degrees(p.angle - start));
    let angle_line = line(motion, &motion.rates.angle, start, degrees);
    Chart {
        title: "Slope of the tip, counterclockwise".to_owned(),
        word: "slope",
        x: Axis::new("pull", "mm"),
        y: Axis::new("slope", "deg"),
        series: vec![
            Series::new("θ", CurveStyle::Line, angle),
            Series::new("θ, line", CurveStyle::Dashed, angle_line),
        ],
    }
}

const LOAD: Axis = Axis::new("load on the cable", "g");
const FORCE: Axis = Axis::new("force on the cell", "g");

fn cell_forces(forces: &[CellForces]) -> Chart {
    let series = forces.iter().map(|curve| {
        let (name, style) = match curve.of {
            Forces::Ours => ("virtual work, ours".to_owned(), CurveStyle::Line),
            Forces::Papers => ("virtual work, paper".to_owned(), CurveStyle::Dashed),
            Forces::Sliding { distance_mm } => (
                format!("sliding cable, no friction, d = {distance_mm} mm"),
                CurveStyle::Line,
            ),
            Forces::Rubbing { distance_mm } => (
                format!("sliding cable, fitted friction, d = {distance_mm} mm"),
                CurveStyle::Line,
            ),
            Forces::Measured { distance_mm } => {
                (format!("measured, d = {distance_mm} mm"), CurveStyle::Dots)
            }
        };
        Series::new(name, style, curve.by_load_g.clone())
    });
    // Where no theory of the paper's is among them, it is about friction.
    let is_papers = forces.iter().any(|curve| curve.of == Forces::Papers);
    let (title, word) = if is_papers {
        ("Force on the load cell", "force")
    } else {
        ("Force on the load cell, with fitted friction", "friction")
    };
    Chart {
        title: title.to_owned(),
        word,
        x: LOAD,
        y: FORCE,
        series: series.collect(),
    }
}

fn disk_forces(model: DiskModel, forces: &[DiskForces]) -> Chart {
    let series = forces.iter().map(|disk| {
        let points = disk.by_load_g.clone();
        Series::new(disk.name(), CurveStyle::Line, points)
    });
    let (title, word) = match model {
        DiskModel::VirtualWork => ("Force by contact point, virtual work", "force"),
        DiskModel::Frictionless => (
            "Force by contact point, sliding cable without friction",
            "sliding",
        ),
        DiskModel::Rubbing => (
            "Force by contact point, sliding cable with friction fitted at disk 3",
            "friction",
        ),
    };
    Chart {
        title: title.to_owned(),
        word,
        x: LOAD,
        y: FORCE,
        series: series.collect(),
    }
}

fn calibration(errors: &[CalibrationErrors]) -> Chart {
    let series = errors.iter().map(|at| {
        let name = format!("d = {} mm", at.distance_mm);
        Series::new(name, CurveStyle::Dots, at.by_load_g.clone())
    });
    Chart {
        title: "Average error, by the point that fixes μ".to_owned(),
        word: "calibration",
        x: Axis::new("load of the calibration point", "g"),
        y: Axis::new("average error over all", "g"),
        series: series.collect(),
    }
}
