//! The user's choices.

use serde::{Deserialize, Serialize};

/// What the user has found out, by hint or without.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(default)]
pub struct Hints {
    /// That obstacles can be dragged.
    pub obstacle: bool,
    /// That the tip can.
    pub tip: bool,
}

/// Which views of the robot are open.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub enum Views {
    /// The plane.
    #[default]
    Plane,
    /// The robot in space.
    Space,
    /// Both, side by side.
    Both,
}

/// The user's choices, which outlive the window.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct Preferences {
    /// Which views are open.
    pub views: Views,
    /// Whether the clearance field is drawn behind the robot.
    pub field: bool,
    /// Whether the grid is drawn.
    pub grid: bool,
    /// Whether the tip leaves a trace.
    pub trace: bool,
    /// Whether the shape in the other mechanics is drawn, too.
    pub compare: bool,
    /// Whether the outline and the inspector are open.
    pub outline: bool,
    /// Whether the plots are open.
    pub dock: bool,
    /// Light, dark or the system's.
    pub theme: eframe::egui::ThemePreference,
    /// Enlarges everything, [`Preferences::ZOOMS`].
    pub zoom: f32,
    /// Whether nothing moves by itself.
    pub still: bool,
    /// Which hints were of use already.
    pub hints: Hints,
}

/// A change of [`Preferences::zoom`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rescale {
    /// By a step.
    Larger,
    /// By a step.
    Smaller,
    /// Back to 1.
    Usual,
}

impl Preferences {
    /// The least and greatest [`Preferences::zoom`].
    pub const ZOOMS: (f32, f32) = (0.75, 2.0);

    /// Changes the size of everything.
    pub fn rescale(&mut self, by: Rescale) {
        // Steps of an eighth, from wherever it is.
        let eighths = self.zoom * 8.0;
        self.zoom = match by {
            Rescale::Larger => (eighths.floor() + 1.0) / 8.0,
            Rescale::Smaller => (eighths.ceil() - 1.0) / 8.0,
            Rescale::Usual => 1.0,
        };
        self.bring_into_range();
    }

    /// Corrects values that no control can give, as from a damaged file.
    pub fn bring_into_range(&mut self) {
        let (least, most) = Self::ZOOMS;
        // The order also replaces NaN.
        self.zoom = self.zoom.max(least).min(most);
    }
}

impl Default for Preferences {
    fn default() -> Self {
        Self {
            views: Views::Plane,
            field: true,
            grid: true,
            trace: true,
            compare: false,
            outline: true,
            dock: true,
            theme: eframe::egui::ThemePreference::System,
            zoom: 1.0,
            still: false,
            hints: Hints::default(),
        }
    }
}
