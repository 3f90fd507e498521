//! Fig. 7: the tip's displacement over the pull, with the lines of eq. 7.

use super::ExperimentError;
use super::data::{Data, TipMotion};
use super::item::{Check, Id, Item};
use super::scenes::PaperScene;
use crate::forces::{Rates, Sweep, VirtualWork, Window};
use crate::mechanics::Problem;
use crate::units::{degrees, metres, millimetres, per_millimetre};

/// The window of the fits, in mm. The text does not give the figure's.
pub(super) const WINDOW_MM: f64 = 10.0;

/// Pulls of a sweep over a window: steps of a quarter of a millimetre.
const PULLS: usize = 41;

/// The lines through a free robot's node from no pull to `last_mm`.
pub(super) fn free_rates(node: usize, last_mm: f64) -> Result<Rates, ExperimentError> {
    let (_, problem) = PaperScene::Free.problem()?;
    Ok(motion(&problem, node, last_mm)?.rates)
}

fn motion(problem: &Problem, node: usize, last_mm: f64) -> Result<TipMotion, ExperimentError> {
    let window = Window {
        first: 0.0,
        last: metres(last_mm),
    };
    let pulls = Sweep::pulls(window.first, window.last, PULLS);
    let sweep = Sweep::of(problem, node, &pulls)?;
    let rates = Rates::fit(&sweep, window)?;
    Ok(TipMotion {
        sweep,
        rates,
        window,
    })
}

pub(super) fn figure_7() -> Result<Item, ExperimentError> {
    let (_, problem) = PaperScene::Free.problem()?;
    let tip = problem.robot().segments;
    let motion = motion(&problem, tip, WINDOW_MM)?;
    let rates = motion.rates;
    let fits = [
        ("f′_x", "mm/mm", rates.x, rates.x.slope),
        ("f′_y", "mm/mm", rates.y, rates.y.slope),
        (
            "f′_θ",
            "rad/mm",
            rates.angle,
            per_millimetre(rates.angle.slope),
        ),
    ];
    let mut checks = Vec::new();
    for (name, unit, fit, slope) in fits {
        checks.push(Check::ours(name, unit, slope).decimals(4));
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
        data: vec![Data::TipMotion(motion)],
        pictures: Vec::new(),
        notes,
        missing: vec![format!(
            "The text gives neither the figure's slopes nor its window; ours is 0 to \
                 {WINDOW_MM} mm."
        )],
    })
}
