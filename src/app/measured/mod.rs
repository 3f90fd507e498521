//! What was measured, against the robot on the screen: how far off the shape
//! is, and the pull that suits the measurement best, searched for while the
//! window goes on.

mod import;

pub use import::import;

use super::workbench::{Basis, Notice, Playing, Search, Workbench};
use crate::experiments::{Measured, MeasuredFault, ShapeFit, compare};
use crate::solving::Task;
use crate::units::millimetres;
use eframe::egui::Context;

/// The distances of the robot on the screen from the measured backbone; `None`
/// where nothing was measured or no shape is known.
pub fn fit(bench: &mut Workbench) -> Option<&Result<ShapeFit, MeasuredFault>> {
    let held = bench.document.scene.measured.as_ref()?;
    if held.points_mm.is_empty() {
        return None;
    }
    let basis = Basis {
        revision: bench.live.revision(),
    };
    let known = bench.measuring.compared.as_ref();
    if known.is_none_or(|(known, _)| *known != basis) {
        let solution = bench.live.solution()?;
        let measured = Measured::of_scene(held, solution.problem());
        let fit = measured.map(|measured| compare(solution, &measured));
        bench.measuring.compared = Some((basis, fit));
    }
    bench.measuring.compared.as_ref().map(|(_, fit)| fit)
}

/// Begins to search for the pull that suits the measurement best.
pub fn search(bench: &mut Workbench, ctx: &Context) {
    let scene = bench.document.scene.clone();
    let Some(held) = &scene.measured else {
        return;
    };
    let problem = bench.document.problem().clone();
    let measured = match Measured::of_scene(held, &problem) {
        Ok(measured) => measured,
        Err(fault) => {
            let told = super::words::sentence(&fault.to_string());
            bench.notices.tell(Notice::trouble(told));
            return;
        }
    };
    let task = bench.begin(Task::BestPull { problem, measured });
    bench.measuring.search = Some(Search {
        scene,
        task,
        share: 0.0,
    });
    // What solves between frames needs one to begin.
    ctx.request_repaint();
}

/// Gives the search up.
pub fn cancel(bench: &mut Workbench) {
    if let Some(search) = bench.measuring.search.take() {
        bench.cancel(search.task);
    }
}

/// Pulls the robot as suits the measurement best.
pub fn apply(bench: &mut Workbench) {
    let best = bench.measuring.best(&bench.document.scene);
    let pull = best
        .and_then(|best| best.fit.as_ref().ok())
        .map(|fit| fit.pull);
    if let Some(pull) = pull {
        bench.set_pull(millimetres(pull), Playing::Stops);
    }
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;
    use crate::app::backend::Inline;
    use crate::app::workbench::{Document, Preferences};
    use crate::experiments::ShapeError;
    use crate::scene::{Measurements, Scene, Shape};
    use crate::solving::tests::{measured, scene};

    /// A workbench whose solver does little at a time, with a robot that was
    /// measured at 3 mm of pull.
    pub fn bench() -> Workbench {
        let mut scene = scene();
        let measured = measured();
        let points = measured.points().iter();
        scene.measured = Some(Measurements {
            points_mm: points
                .clone()
                .map(|point| point.position.map(millimetres).into())
                .collect(),
            nodes: points.map(|point| point.node.unwrap() as u32).collect(),
            ..Measurements::default()
        });
        let document = Document::new(scene).unwrap();
        let solver = Box::new(Inline::by_slices(2));
        Workbench::new(document, solver, Preferences::default())
    }

    fn edited(bench: &mut Workbench, edit: impl FnOnce(&mut Scene)) {
        edit(&mut bench.document.scene);
        bench.take_edits(&Context::default());
    }

    /// Begins a search and lets it come as far as that.
    fn searched(bench: &mut Workbench, share: f64) {
        search(bench, &Context::default());
        while bench.measuring.search.as_ref().unwrap().share < share {
            assert!(bench.wants_frames());
            bench.poll();
        }
    }

    fn to_the_end(bench: &mut Workbench) -> Option<Result<ShapeFit, ShapeError>> {
        while bench.wants_frames() {
            bench.poll();
        }
        assert!(bench.measuring.search.is_none());
        let best = bench.measuring.best(&bench.document.scene);
        best.map(|best| best.fit.clone())
    }

    #[test]
    fn a_search_goes_on_while_the_robot_is_pulled() {
        let mut bench = bench();
        for (step, pull_mm) in [1.0, 2.0, 4.0].into_iter().enumerate() {
            match step {
                0 => searched(&mut bench, 0.1),
                _ => bench.poll(),
            }
            edited(&mut bench, |scene| scene.set_pull_mm(pull_mm));
        }
        let fit = to_the_end(&mut bench).unwrap().unwrap();
        assert!((millimetres(fit.pull) - 3.0).abs() < 1e-4);
        assert_eq!(bench.live.solution().unwrap().pull, 0.004);
        apply(&mut bench);
        assert!((bench.pull_mm() - 3.0).abs() < 1e-4);
    }

    #[test]
    fn a_search_that_is_cancelled_finds_nothing() {
        let mut bench = bench();
        searched(&mut bench, 0.1);
        cancel(&mut bench);
        assert!(to_the_end(&mut bench).is_none());
        // Another one begins anew.
        searched(&mut bench, 0.1);
        assert!(to_the_end(&mut bench).unwrap().is_ok());
    }

    #[test]
    fn a_search_for_a_robot_that_is_no_more_is_given_up() {
        let mut bench = bench();
        searched(&mut bench, 0.1);
        edited(&mut bench, |scene| {
            let disc = Shape::Disc {
                center_mm: [150.0, 20.0],
                radius_mm: 5.0,
            };
            scene.obstacles.push(disc.into());
        });
        assert!(bench.measuring.search.is_none());
        assert!(to_the_end(&mut bench).is_none());
        assert!(bench.live.is_settled());
        // Another one is for the new scene.
        searched(&mut bench, 0.1);
        assert!(to_the_end(&mut bench).unwrap().is_ok());
    }
}
