//! Results as files' contents: drawings as SVG text and, with the
//! features that need them, as PNG, charts and pages. It writes no files.

#[cfg(any(feature = "app", feature = "cli"))]
pub mod chart;
#[cfg(feature = "cli")]
pub mod page;
#[cfg(any(feature = "app", feature = "cli"))]
pub mod png;
pub mod svg;
mod text;
