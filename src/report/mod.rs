//! Results as files' contents: drawings as SVG text and, with the
//! features that need them, as PNG, charts and pages. It writes no files.

mod characters;
#[cfg(any(feature = "app", feature = "cli"))]
pub mod chart;
#[cfg(feature = "cli")]
pub mod page;
// A browser rasterises by itself.
#[cfg(all(any(feature = "app", feature = "cli"), not(target_arch = "wasm32")))]
pub mod png;
pub mod svg;
mod text;

pub use characters::on_a_terminal;
