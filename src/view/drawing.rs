//! What there is to draw, as plain data: marks in the world with what they
//! mean, not how they look. Lengths in metres, y upward.

use super::bounds::Bounds;
use super::force_scale::ForceScale;
use super::path::{Path, clip_half_plane};
use super::quantity::Quantity;
use crate::contact::Class;
use crate::geometry::Vector;

/// A picture of a robot among obstacles.
#[derive(Clone, Debug, PartialEq)]
pub struct Drawing {
    /// What it must show, with a margin around it.
    pub bounds: Bounds,
    /// Step of the grid: 1, 2 or 5 times a power of ten.
    pub grid: f64,
    /// Length of the scale bar: 1, 2 or 5 times a power of ten.
    pub scale_bar: f64,
    /// The marks, from back to front.
    pub marks: Vec<Mark>,
    /// What is written beside the marks. Where it goes depends on the size of
    /// letters: see [`super::place_labels`].
    pub labels: Vec<Label>,
    /// What arrows, glow and colours of contacts measure by.
    pub scale: ForceScale,
    /// Whether anything presses, so that the scale has something to say.
    pub presses: bool,
    /// What is written above the picture.
    pub caption: Caption,
    /// Whether the shape is to be believed.
    pub standing: Standing,
}

/// Something to draw.
#[derive(Clone, Debug, PartialEq)]
pub struct Mark {
    /// What it is.
    pub role: Role,
    /// Where it is.
    pub geometry: Geometry,
    /// How thick a line it is in the world, in metres; it is drawn no thinner
    /// than its role's width.
    pub thickness: f64,
}

/// What a mark is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Role {
    /// An obstacle, by its index in the problem.
    Obstacle(usize),
    /// Where the robot is held.
    Base,
    /// The strokes that show the base as solid.
    BaseHatch,
    /// Where the tip has been.
    TipTrace,
    /// A disk.
    Disk,
    /// A disk that presses; the greatest of its multipliers as a share of the
    /// scale.
    TouchedDisk(f64),
    /// A cable.
    Cable,
    /// A cable that hangs loose, with its sag.
    SlackCable,
    /// The backbone.
    Backbone,
    /// A node of the backbone.
    Node,
    /// The last node.
    Tip,
    /// A contact's multiplier, along its normal, as a share of the scale.
    Force(f64),
    /// What friction can hold back at a contact: the cone about its normal that the
    /// obstacle's force cannot leave.
    Cone {
        /// The contact's multiplier as a share of the scale.
        share: f64,
        /// Whether the force is at the cone's edge, so that the robot slides.
        slides: bool,
    },
    /// Friction at a contact, along the obstacle's surface, as a share of the scale.
    Friction(f64),
    /// A contact.
    Contact {
        /// Its multiplier as a share of the scale.
        share: f64,
        /// Whether it carries a force.
        class: Class,
    },
}

impl Role {
    /// The role in a word or two, as in the classes of an SVG.
    pub fn word(self) -> &'static str {
        match self {
            Role::Obstacle(_) => "obstacle",
            Role::Base => "base",
            Role::BaseHatch => "base-hatch",
            Role::TipTrace => "tip-trace",
            Role::Disk => "disk",
            Role::TouchedDisk(_) => "touched-disk",
            Role::Cable => "cable",
            Role::SlackCable => "slack-cable",
            Role::Backbone => "backbone",
            Role::Node => "node",
            Role::Tip => "tip",
            Role::Force(_) => "force",
            Role::Cone { .. } => "friction-cone",
            Role::Friction(_) => "friction",
            Role::Contact {
                class: Class::Pressing,
                ..
            } => "pressing",
            Role::Contact {
                class: Class::Grazing,
                ..
            } => "grazing",
        }
    }
}

/// Where a mark is.
#[derive(Clone, Debug, PartialEq)]
pub enum Geometry {
    /// A line or an area.
    Path(Path),
    /// Everything behind a line without end: see [`super::clip_half_plane`].
    HalfPlane {
        /// A point of the line.
        point: Vector,
        /// The unit normal, towards the free side.
        normal: Vector,
    },
    /// A point, drawn at its role's size whatever the scale.
    Dot(Vector),
    /// An arrow.
    Arrow {
        /// Where it starts.
        tail: Vector,
        /// Where it points to.
        tip: Vector,
    },
}

impl Geometry {
    /// Points, in metres, whose convex hull holds the geometry, arcs to within
    /// `tolerance`, > 0 and in metres; of a half-plane what `window` shows.
    pub fn points(&self, tolerance: f64, window: &Bounds) -> Vec<Vector> {
        match self {
            Geometry::Path(path) => path.flattened(tolerance),
            Geometry::HalfPlane { point, normal } => {
                clip_half_plane(*point, *normal, &window.corners()).area
            }
            Geometry::Dot(point) => vec![*point],
            Geometry::Arrow { tail, tip } => vec![*tail, *tip],
        }
    }
}

/// A few words or a number beside a mark.
#[derive(Clone, Debug, PartialEq)]
pub struct Label {
    /// What is written.
    pub text: LabelText,
    /// Where it belongs.
    pub spot: Spot,
}

/// What a label says.
#[derive(Clone, Debug, PartialEq)]
pub enum LabelText {
    /// A number that the picture is about.
    Value(Quantity),
    /// A name, in the background.
    Name(String),
}

/// Where a label belongs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Spot {
    /// Beyond a point, in a unit direction.
    Beyond {
        /// The point.
        point: Vector,
        /// The direction.
        towards: Vector,
    },
    /// Inside something of this extent or, where it is too small, beside it.
    Inside(Bounds),
}

/// Whether a shape is to be believed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Standing {
    /// A certified equilibrium of what was asked for.
    Certified,
    /// Anything else: drawn greyed, with the reason.
    Greyed {
        /// A word or two, such as `Branch ended`.
        what: &'static str,
        /// A sentence, without its full stop.
        reason: String,
    },
}

impl Standing {
    /// Whether the shape is to be greyed.
    pub fn is_greyed(&self) -> bool {
        matches!(self, Standing::Greyed { .. })
    }
}

/// What is written above a picture.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Caption {
    /// The scene's title.
    pub title: Option<String>,
    /// What was measured, in order.
    pub facts: Vec<Fact>,
    /// What the picture would make one believe wrongly without it.
    pub note: Option<String>,
}

/// A named number.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Fact {
    /// Its name, such as `pull`.
    pub name: &'static str,
    /// Its value.
    pub value: Quantity,
}
