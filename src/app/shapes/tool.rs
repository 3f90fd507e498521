//! The tools of the hand: to select, or to add an obstacle of a shape.

use crate::app::look::icons;

/// What clicks and drags on the canvas do.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Tool {
    /// They select, move and resize.
    #[default]
    Select,
    /// They add a disc.
    Disc,
    /// They add a box.
    Box,
    /// They add a capsule.
    Capsule,
    /// They add a polygon, vertex by vertex.
    Polygon,
    /// They add a wall.
    Wall,
}

impl Tool {
    /// All tools, from top to bottom.
    pub const ALL: [Self; 6] = [
        Self::Select,
        Self::Disc,
        Self::Box,
        Self::Capsule,
        Self::Polygon,
        Self::Wall,
    ];

    /// The tool's icon.
    pub const fn icon(self) -> &'static str {
        match self {
            Tool::Select => icons::HAND_POINTING,
            Tool::Disc => icons::CIRCLE,
            Tool::Box => icons::SQUARE,
            Tool::Capsule => icons::PILL,
            Tool::Polygon => icons::POLYGON,
            Tool::Wall => icons::WALL,
        }
    }
}
