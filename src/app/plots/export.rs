//! The plots as the contents of files: tables with every digit, and charts.

use super::cache::PlotCache;
use super::data::{Plot, PlotData};
use super::{bends, energy, force, load, multipliers, tension, tip};
use crate::report::chart::{ChartError, svg_column};
use crate::view::Chart;

/// The numbers of a plot, as CSV with a row of names that carry the units.
pub fn csv(plot: Plot, data: &PlotData<'_>) -> String {
    let mut table = csv::Writer::from_writer(Vec::new());
    let written = match plot {
        Plot::Multipliers => multipliers::csv(data, &mut table),
        Plot::Tip => tip::csv(data, &mut table),
        Plot::Force => {
            let mut cache = PlotCache::default();
            cache.refresh(data);
            force::csv(data, &cache, &mut table)
        }
        Plot::Energy => energy::csv(data, &mut table),
        Plot::Bends => bends::csv(data, &mut table),
        Plot::Load => load::csv(data, &mut table),
        Plot::Tension => {
            let mut cache = PlotCache::default();
            cache.refresh(data);
            tension::csv(data, &cache, &mut table)
        }
    };
    // A vector takes all that is written to it, and rows are of one length.
    debug_assert!(written.is_ok(), "{written:?}");
    let bytes = table.into_inner().unwrap_or_default();
    String::from_utf8_lossy(&bytes).into_owned()
}

/// A plot as SVG.
///
/// # Errors
/// If its numbers cannot be drawn.
pub fn svg(plot: Plot, data: &PlotData<'_>) -> Result<String, ChartError> {
    let mut cache = PlotCache::default();
    cache.refresh(data);
    svg_from(plot, data, &cache)
}

pub(super) fn svg_from(
    plot: Plot,
    data: &PlotData<'_>,
    cache: &PlotCache,
) -> Result<String, ChartError> {
    svg_column(&charts(plot, data, cache))
}

fn charts(plot: Plot, data: &PlotData<'_>, cache: &PlotCache) -> Vec<Chart> {
    match plot {
        Plot::Multipliers => multipliers::charts(data, cache),
        Plot::Tip => tip::charts(data, cache),
        Plot::Force => force::charts(data, cache),
        Plot::Energy => energy::charts(cache),
        Plot::Bends => bends::charts(cache),
        Plot::Load => load::charts(data, cache),
        Plot::Tension => tension::charts(data, cache),
    }
}
