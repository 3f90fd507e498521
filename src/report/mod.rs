//! Charts and pages of results, as text. It writes no files.

#[cfg(feature = "cli")]
pub mod chart;
#[cfg(feature = "cli")]
pub mod page;
