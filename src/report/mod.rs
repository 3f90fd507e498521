//! Drawings as files' contents: SVG text and, with the feature `cli`, PNG.
//! It writes no files.

#[cfg(feature = "cli")]
pub mod png;
pub mod svg;
mod text;
