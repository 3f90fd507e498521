//! What was measured, against the robot on the screen: how far off the shape
//! is, and the pull that suits the measurement best, searched for while the
//! window goes on.

mod import;

pub use import::import;

use super::notices::Notice;
use super::state::State;
use crate::experiments::{Measured, MeasuredFault, ShapeFit, best_pull, compare};
use crate::scene::Scene;
use crate::units::millimetres;
use eframe::egui::Context;
use std::sync::mpsc::{Receiver, TryRecvError, channel};

/// Measurements against the robot.
#[derive(Default)]
pub struct Measuring {
    /// What the comparison is of, and how it turned out.
    compared: Option<(Basis, Result<ShapeFit, MeasuredFault>)>,
    /// The search for the best pull, while it goes on.
    search: Option<Search>,
    /// What it has found.
    best: Option<Best>,
}

/// What a comparison rests on; a new one is needed when this changes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Basis {
    /// Counts the drawings, which change with both the scene and the shape.
    revision: u64,
}

struct Search {
    /// The scene it was started for.
    scene: Scene,
    result: Receiver<Result<ShapeFit, String>>,
}

/// The pull that suits the measurement best.
#[derive(Clone, Debug, PartialEq)]
pub struct Best {
    /// The scene it was found for.
    scene: Scene,
    /// The distances that are left at that pull, or why there is no such pull.
    pub fit: Result<ShapeFit, String>,
}

impl Measuring {
    /// Whether the best pull is being searched for.
    pub fn is_searching(&self) -> bool {
        self.search.is_some()
    }

    /// The best pull, if it was found for this scene, whatever its pull is now.
    pub fn best(&self, scene: &Scene) -> Option<&Best> {
        self.best
            .as_ref()
            .filter(|best| same_but_for_pull(&best.scene, scene))
    }
}

fn same_but_for_pull(a: &Scene, b: &Scene) -> bool {
    let mut a = a.clone();
    a.actuation.clone_from(&b.actuation);
    // Looks change nothing.
    a.photo.clone_from(&b.photo);
    a.title.clone_from(&b.title);
    a == *b
}

/// The distances of the robot on the screen from the measured backbone; `None`
/// where nothing was measured or no shape is known.
pub fn fit(state: &mut State) -> Option<&Result<ShapeFit, MeasuredFault>> {
    let held = state.document.scene.measured.as_ref()?;
    if held.points_mm.is_empty() {
        return None;
    }
    let basis = Basis {
        revision: state.live.revision(),
    };
    let known = state.measuring.compared.as_ref();
    if known.is_none_or(|(known, _)| *known != basis) {
        let solution = state.live.solution()?;
        let measured = Measured::of_scene(held, state.live.problem());
        let fit = measured.map(|measured| compare(solution, &measured));
        state.measuring.compared = Some((basis, fit));
    }
    state.measuring.compared.as_ref().map(|(_, fit)| fit)
}

/// Begins to search for the pull that suits the measurement best.
pub fn search(state: &mut State) {
    let scene = state.document.scene.clone();
    let Some(held) = &scene.measured else {
        return;
    };
    let problem = state.document.problem().clone();
    let measured = match Measured::of_scene(held, &problem) {
        Ok(measured) => measured,
        Err(fault) => {
            let told = super::words::sentence(&fault.to_string());
            state.notices.tell(Notice::trouble(told));
            return;
        }
    };
    let (sender, result) = channel();
    state.measuring.search = Some(Search { scene, result });
    state.files.platform.work(Box::new(move || {
        let found = best_pull(&problem, &measured, |_| {});
        let found = found
            .map(|(_, _, fit)| fit)
            .map_err(|error| error.to_string());
        // Nobody listens only when the window is gone.
        let _ = sender.send(found);
    }));
}

/// Takes what the search has found.
pub fn arrive(state: &mut State, ctx: &Context) {
    let Some(search) = &state.measuring.search else {
        return;
    };
    let fit = match search.result.try_recv() {
        Err(TryRecvError::Empty) => return,
        Err(TryRecvError::Disconnected) => Err("the search has failed".to_owned()),
        Ok(fit) => fit,
    };
    if let Some(search) = state.measuring.search.take() {
        let scene = search.scene;
        state.measuring.best = Some(Best { scene, fit });
    }
    ctx.request_repaint();
}

/// Pulls the robot as suits the measurement best.
pub fn apply(state: &mut State) {
    let best = state.measuring.best(&state.document.scene);
    let pull = best
        .and_then(|best| best.fit.as_ref().ok())
        .map(|fit| fit.pull);
    if let Some(pull) = pull {
        state.transport.stop();
        state.document.scene.actuation.pull_mm = millimetres(pull);
    }
}
