//! Results as files' contents: drawings as SVG text, with the feature `app` or
//! `cli` charts, and with `cli` PNG and pages. It writes no files.

#[cfg(any(feature = "app", feature = "cli"))]
pub mod chart;
#[cfg(feature = "cli")]
pub mod page;
#[cfg(feature = "cli")]
pub mod png;
pub mod svg;
mod text;
