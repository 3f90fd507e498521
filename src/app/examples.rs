//! The examples of the gallery: the scenes of `assets/scenes`, each with what it
//! shows. Solves nothing.

use crate::scene::{Scene, SceneError};

/// A scene that comes with the program.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Example {
    /// What it is called in addresses and preferences: the name of its file.
    pub id: &'static str,
    /// Its title, the scene's own.
    pub title: &'static str,
    /// What it shows, in a sentence.
    pub lesson: &'static str,
    /// Under which heading it stands.
    pub group: Group,
    /// The scene file.
    pub text: &'static str,
}

/// A heading of the gallery.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Group {
    /// Robots whose cables slide: true forces.
    Sliding,
    /// What the paper describes, in the paper's model.
    Paper,
    /// What was made up to show one thing.
    TryThis,
}

impl Group {
    /// All of them, in the order of the gallery.
    pub const ALL: [Group; 3] = [Group::Sliding, Group::Paper, Group::TryThis];

    /// The heading.
    pub fn title(self) -> &'static str {
        match self {
            Group::Sliding => "A cable that slides",
            Group::Paper => "The paper, in its own model",
            Group::TryThis => "Try this, in the paper’s model",
        }
    }
}

impl Example {
    /// The scene, as its file says.
    ///
    /// # Errors
    /// None: the files are part of the program and tested.
    pub fn scene(&self) -> Result<Scene, SceneError> {
        Scene::from_toml(self.text)
    }

    /// The example of this id, if there is one.
    pub fn named(id: &str) -> Option<&'static Example> {
        EXAMPLES.iter().find(|example| example.id == id)
    }
}

/// All examples in the order of the gallery, group by group; the first is the
/// one the window opens on.
pub const EXAMPLES: &[Example] = &[
    Example {
        id: "two-posts",
        title: "Two posts",
        lesson: "The cable slides through the disks: each arrow is the force that a load cell would show there.",
        group: Group::Sliding,
        text: include_str!("../../assets/scenes/two-posts.toml"),
    },
    Example {
        id: "hysteresis",
        title: "A loop of hysteresis",
        lesson: "Pull in and let out: with friction the load draws a loop, and holes change from slip to stick.",
        group: Group::Sliding,
        text: include_str!("../../assets/scenes/hysteresis.toml"),
    },
    Example {
        id: "antagonists",
        title: "Two cables, one slack",
        lesson: "What one cable draws in the other lets go; without a load on it the other hangs slack.",
        group: Group::Sliding,
        text: include_str!("../../assets/scenes/antagonists.toml"),
    },
    Example {
        id: "two-discs",
        title: "Two discs (Fig. 4b)",
        lesson: "Two posts press at once, on two of the disks, at pulls of 4.77 to 5.1 mm and no others.",
        group: Group::Paper,
        text: include_str!("../../assets/scenes/two-discs.toml"),
    },
    Example {
        id: "one-disc",
        title: "One disc (Fig. 4a)",
        lesson: "Beyond the post the robot is an arc, as if free; below it, backbone and disks are sheared.",
        group: Group::Paper,
        text: include_str!("../../assets/scenes/one-disc.toml"),
    },
    Example {
        id: "free",
        title: "Free (Fig. 3b)",
        lesson: "With nothing in its way the robot is an arc whose angle grows in proportion to the pull.",
        group: Group::Paper,
        text: include_str!("../../assets/scenes/free.toml"),
    },
    Example {
        id: "load-cell",
        title: "Load cell (Fig. 9)",
        lesson: "One node leans on a wall, and the multiplier tells how hard.",
        group: Group::Paper,
        text: include_str!("../../assets/scenes/load-cell.toml"),
    },
    Example {
        id: "load-cell-readings",
        title: "Measured forces (Table 1)",
        lesson: "One measured force is enough to predict the others to within half a gram.",
        group: Group::Paper,
        text: include_str!("../../assets/scenes/load-cell-readings.toml"),
    },
    Example {
        id: "slip-off",
        title: "Slip-off",
        lesson: "Pull on: the post holds the robot back until no equilibrium is left, and it jumps past.",
        group: Group::TryThis,
        text: include_str!("../../assets/scenes/slip-off.toml"),
    },
    Example {
        id: "s-bend",
        title: "S-bend around two discs",
        lesson: "The disks turn much as they would without posts, and yet the backbone makes an S.",
        group: Group::TryThis,
        text: include_str!("../../assets/scenes/s-bend.toml"),
    },
    Example {
        id: "grip",
        title: "Grip",
        lesson: "Pull on: disk after disk comes to press, as a finger closes round what it holds.",
        group: Group::TryThis,
        text: include_str!("../../assets/scenes/grip.toml"),
    },
    Example {
        id: "narrow-gap",
        title: "Narrow gap",
        lesson: "The gap holds the robot's middle; beyond it the robot is an arc, as if free.",
        group: Group::TryThis,
        text: include_str!("../../assets/scenes/narrow-gap.toml"),
    },
    Example {
        id: "wedge",
        title: "Wedge",
        lesson: "Braced between two walls, the robot comes to a pull beyond which there is no shape.",
        group: Group::TryThis,
        text: include_str!("../../assets/scenes/wedge.toml"),
    },
    Example {
        id: "body-contact",
        title: "Two discs against the whole body",
        lesson: "Disks have a size: their rims meet the lower post 1 mm of pull before the paper's nodes do.",
        group: Group::TryThis,
        text: include_str!("../../assets/scenes/body-contact.toml"),
    },
    Example {
        id: "many-segments",
        title: "Sixty segments among five shapes",
        lesson: "Three times as many segments, five shapes of obstacle, and the answer is still there at once.",
        group: Group::TryThis,
        text: include_str!("../../assets/scenes/many-segments.toml"),
    },
    Example {
        id: "shapes",
        title: "One of every shape",
        lesson: "Every shape that an obstacle can have, to be dragged against the robot.",
        group: Group::TryThis,
        text: include_str!("../../assets/scenes/shapes.toml"),
    },
];
