//! What was measured, against the robot on the screen: how far off the shape
//! is, and the pull that suits the measurement best, searched for while the
//! window goes on.

mod import;

pub use import::import;

use super::workbench::{Basis, Best, Notice, Playing, Search, Workbench};
use crate::experiments::{Measured, MeasuredFault, ShapeFit, best_pull, compare};
use crate::units::millimetres;
use eframe::egui::Context;
use std::sync::mpsc::{TryRecvError, channel};

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
        let measured = Measured::of_scene(held, bench.live.problem());
        let fit = measured.map(|measured| compare(solution, &measured));
        bench.measuring.compared = Some((basis, fit));
    }
    bench.measuring.compared.as_ref().map(|(_, fit)| fit)
}

/// Begins to search for the pull that suits the measurement best.
pub fn search(bench: &mut Workbench) {
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
    let (sender, result) = channel();
    bench.measuring.search = Some(Search { scene, result });
    bench.files.platform.work(Box::new(move || {
        let found = best_pull(&problem, &measured, |_| {});
        let found = found
            .map(|(_, _, fit)| fit)
            .map_err(|error| error.to_string());
        // Nobody listens only when the window is gone.
        let _ = sender.send(found);
    }));
}

/// Takes what the search has found.
pub fn arrive(bench: &mut Workbench, ctx: &Context) {
    let Some(search) = &bench.measuring.search else {
        return;
    };
    let fit = match search.result.try_recv() {
        Err(TryRecvError::Empty) => return,
        Err(TryRecvError::Disconnected) => Err("the search has failed".to_owned()),
        Ok(fit) => fit,
    };
    if let Some(search) = bench.measuring.search.take() {
        let scene = search.scene;
        bench.measuring.best = Some(Best { scene, fit });
    }
    ctx.request_repaint();
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
