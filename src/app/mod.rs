//! The window: canvas, panels and plots around a solver that never makes them
//! wait. The only layer that knows egui.
//!
//! Its own layers, each using those above it only (`tests/layers.rs` holds
//! them):
//!
//! - [`look`], [`link`], [`examples`], [`backend`] and `pixels` know nothing of
//!   the window.
//! - `words`, `shapes`, `paint` and [`platform`]: what is said, held and painted,
//!   and the system around it all.
//! - `commands`: all that can be asked for by a key or a button.
//! - [`Workbench`]: the user's work. It knows no part of the window.
//! - `photo`, `measured` and [`files`]: what goes in and out.
//! - `widgets`: what panels and tables are made of.
//! - The parts, which do not know each other: `canvas`, `space`, `panels`,
//!   [`plots`] and, around these, [`dock`]; `sheets`. Each is shown as
//!   `show(ui, &mut Part, &mut Workbench)`.
//! - [`window`] owns the workbench and the parts; `desktop` and `page` open it.

pub mod backend;
mod canvas;
mod commands;
#[cfg(not(target_arch = "wasm32"))]
pub mod desktop;
pub mod dock;
pub mod examples;
pub mod files;
pub mod link;
pub mod look;
mod measured;
#[cfg(all(target_arch = "wasm32", feature = "web"))]
pub mod page;
mod paint;
mod panels;
mod photo;
mod pixels;
pub mod platform;
pub mod plots;
mod shapes;
mod sheets;
mod space;
mod widgets;
pub mod window;
mod words;
pub mod workbench;

pub use canvas::Canvas;
pub use commands::Command;
pub use shapes::Tool;
pub use window::Sinew;
pub use workbench::{Document, Hovered, Preferences, Selection, Views, Workbench};
