//! What is selected, and what the pointer is on.

/// What is selected.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Selection {
    /// Nothing.
    #[default]
    Nothing,
    /// The robot.
    Robot,
    /// An obstacle, by its index in the scene.
    Obstacle(usize),
    /// The photograph.
    Photo,
    /// What was measured.
    Measured,
}

impl Selection {
    /// The obstacle that is selected, by its index in the scene.
    pub fn obstacle(self) -> Option<usize> {
        match self {
            Selection::Obstacle(index) => Some(index),
            _ => None,
        }
    }
}

/// What the pointer is on, in whichever part of the window: its twins light up
/// in all others.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Hovered {
    /// Nothing that has a twin.
    #[default]
    Nothing,
    /// A node, from 0 at the base.
    Node(usize),
    /// A contact, by its index in the solution.
    Contact(usize),
    /// An obstacle, by its index in the scene.
    Obstacle(usize),
    /// A pull, in metres.
    Pull(f64),
}
