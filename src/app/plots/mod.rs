//! The dock's plots: what presses at which node, the tip and the energy along
//! the pull, force against load, bends by segment, the cables' tension, their
//! loads against their pulls. They draw what is known and
//! change nothing: what a hand does on them is left in a [`Link`], what is to
//! be saved in a [`PlotAction`].
//!
//! All plots share one cursor. What the pointer is on in one of them, or on the
//! canvas, is marked in all others, and a click or a drag on a plot over the
//! pull sets the pull. Nothing is fitted or converted while a frame is drawn: a
//! [`PlotCache`] does that when what is plotted has changed.

mod bends;
mod cache;
pub mod data;
mod energy;
mod export;
mod force;
mod holes;
mod legend;
mod load;
mod marks;
mod multipliers;
mod over_pull;
mod pane;
mod tension;
mod tip;

pub use cache::PlotCache;
pub use data::{Link, Plot, PlotAction, PlotData};
pub use export::{csv, svg};

use eframe::egui::Ui;
use pane::Asked;

/// Shows a plot in the room there is.
pub fn show(
    ui: &mut Ui,
    plot: Plot,
    data: &PlotData<'_>,
    cache: &mut PlotCache,
    link: &mut Link,
) -> Option<PlotAction> {
    cache.refresh(data);
    let cache = &*cache;
    let asked = match plot {
        Plot::Multipliers => multipliers::show(ui, data, cache, link),
        Plot::Tip => tip::show(ui, data, cache, link),
        Plot::Force => force::show(ui, data, cache, link),
        Plot::Energy => energy::show(ui, data, cache, link),
        Plot::Bends => bends::show(ui, data, cache, link),
        Plot::Load => load::show(ui, data, cache, link),
        Plot::Tension => tension::show(ui, data, cache, link),
    };
    match asked? {
        Asked::Csv => Some(saved(plot, "csv", csv(plot, data))),
        Asked::Svg => {
            let text = export::svg_from(plot, data, cache).ok()?;
            Some(saved(plot, "svg", text))
        }
        Asked::Stiffness => Some(PlotAction::AskStiffness),
        Asked::Reading => Some(PlotAction::AskReading),
        Asked::Slide => Some(PlotAction::Slide),
    }
}

fn saved(plot: Plot, extension: &'static str, text: String) -> PlotAction {
    PlotAction::Save {
        name: plot.word().to_owned(),
        extension,
        bytes: text.into_bytes(),
    }
}
