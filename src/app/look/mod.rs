//! How the window looks: its fonts, its icons, its style in both themes. What
//! the robot and its obstacles look like is [`crate::view::Theme`]'s.

mod fonts;
pub mod icons;
mod scale;
mod segments;
mod style;

#[cfg(target_arch = "wasm32")]
pub use fonts::fonts_for_svg;
pub use fonts::{icon_font, semibold};
pub use scale::contact_scale;
pub use segments::{Segment, segments};
pub use style::{
    MOTION_SECONDS, Tokens, colour, fit_fingers, fits_fingers, icon, icon_button, theme_of,
};

use eframe::egui;

/// Gives a context the window's fonts and both its themes.
pub fn install(ctx: &egui::Context) {
    fonts::install(ctx);
    style::install(ctx);
}
