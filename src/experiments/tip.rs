//! Fig. 7: the tip's displacement over the pull, with the lines of eq. 7.

use super::ExperimentError;
use super::item::{Axis, Chart, Check, Id, Item, Mark, Series};
use super::scenes::PaperScene;
use crate::forces::{LineFit, Rates, Sweep, VirtualWork, Window};
use crate::model::Problem;
use crate::units::{degrees, metres, millimetres};

/// The window of the fits, in mm. The text does not give the figure's.
pub(super) const WINDOW_MM: f64 = 10.0;

/// Pulls of a sweep over a window: steps of a quarter of a millimetre.
const PULLS: usize = 41;

/// The lines through a free robot's node from no pull to `last_mm`.
pub(super) fn free_rates(node: usize, last_mm: f64) -> Result<Rates, ExperimentError> {
    let (_, problem) = PaperScene::Free.problem()?;
    Ok(sweep(&problem, node, last_mm)?.1)
}

fn sweep(problem: &Problem, node: usize, last_mm: f64) -> Result<(Sweep, Rates), ExperimentError> {
    let window = Window {
        first: 0.0,
        last: metres(last_mm),
    };
    let pulls = Sweep::pulls(window.first, window.last, PULLS);
    let sweep = Sweep::of(problem, node, &pulls)?;
    let rates = Rates::fit(&sweep, window)?;
    Ok((sweep, rates))
}

pub(super) fn figure_7() -> Result<Item, ExperimentError> {
    let (_, problem) = PaperScene::Free.problem()?;
    let tip = problem.robot().segments;
    let (sweep, rates) = sweep(&problem, tip, WINDOW_MM)?;
    let start = sweep.points[0];
    let curve = |of: &dyn Fn(&crate::forces::SweepPoint) -> f64| -> Vec<(f64, f64)> {
        let points = sweep.points.iter();
        points.map(|p| (millimetres(p.pull), of(p))).collect()
    };
    let line = |fit: &LineFit, from: f64, scale: fn(f64) -> f64| -> Vec<(f64, f64)> {
        let ends = [0.0, metres(WINDOW_MM)];
        ends.map(|pull| (millimetres(pull), scale(fit.at(pull) - from)))
            .to_vec()
    };
    let place = Chart {
        title: "Displacement of the tip".to_owned(),
        word: "displacement",
        x: Axis::new("pull", "mm"),
        y: Axis::new("displacement", "mm"),
        series: vec![
            Series::new("x", Mark::Line, curve(&|p| millimetres(p.x - start.x))),
            Series::new(
                "x, line",
                Mark::Dashed,
                line(&rates.x, start.x, millimetres),
            ),
            Series::new("y", Mark::Line, curve(&|p| millimetres(p.y - start.y))),
            Series::new(
                "y, line",
                Mark::Dashed,
                line(&rates.y, start.y, millimetres),
            ),
        ],
    };
    let slope = Chart {
        title: "Slope of the tip, counterclockwise".to_owned(),
        word: "slope",
        x: Axis::new("pull", "mm"),
        y: Axis::new("slope", "deg"),
        series: vec![
            Series::new("θ", Mark::Line, curve(&|p| degrees(p.angle - start.angle))),
            Series::new(
                "θ, line",
                Mark::Dashed,
                line(&rates.angle, start.angle, degrees),
            ),
        ],
    };
    let fits = [
        ("f′_x", "mm/mm", rates.x, 1.0),
        ("f′_y", "mm/mm", rates.y, 1.0),
        ("f′_θ", "rad/mm", rates.angle, metres(1.0)),
    ];
    let mut checks = Vec::new();
    for (name, unit, fit, scale) in fits {
        checks.push(Check::ours(name, unit, scale * fit.slope).decimals(4));
        checks.push(Check::ours(format!("{name}: R²"), "", fit.r_squared).decimals(5));
        let (residual, unit) = if name == "f′_θ" {
            (degrees(fit.rms_residual), "deg")
        } else {
            (millimetres(fit.rms_residual), "mm")
        };
        checks.push(Check::ours(format!("{name}: RMS residual"), unit, residual));
    }
    let caveats = VirtualWork::new(problem.robot().offset, rates, 0.0)?.caveats(tip);
    let mut notes: Vec<String> = caveats.iter().map(|c| format!("{c}.")).collect();
    notes.push(
        "x is positive towards the cable, y along the straight robot, θ counterclockwise; the robot \
         bends clockwise."
            .to_owned(),
    );
    Ok(Item {
        id: Id::Fig7,
        title: "Tip displacement over the pull",
        about: format!(
            "The free robot's tip from a continuation in the pull, with the straight lines of eq. 7 \
             by least squares from 0 to {WINDOW_MM} mm."
        ),
        checks,
        charts: vec![place, slope],
        pictures: Vec::new(),
        notes,
        missing: vec![format!(
            "The text gives neither the figure's slopes nor its window; ours is 0 to \
                 {WINDOW_MM} mm."
        )],
    })
}
