//! Every key a scene file may have, with what it means and may hold.
//!
//! The one table behind the messages about unknown, missing and mistyped keys
//! and behind the JSON Schema. The values themselves are read by serde into
//! the types of this layer; a test holds the two together.

use super::VERSION;
use super::limits::{self, Limits, Unit};

/// A key of a table.
pub(super) struct Key {
    /// The key as written.
    pub name: &'static str,
    /// What it means: a phrase without a full stop.
    pub about: &'static str,
    /// What it may hold.
    pub kind: Kind,
    /// Whether it may be left out.
    pub presence: Presence,
}

/// Whether a key may be left out.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Presence {
    Required,
    Optional,
}

/// What a key may hold.
pub(super) enum Kind {
    Version,
    Number(Limits),
    Whole(Limits),
    Text,
    Word(&'static [&'static str]),
    /// Two numbers, x and y, or width and height.
    Pair(Limits),
    /// Pairs, so many at least and at most.
    #[cfg_attr(
        not(feature = "cli"),
        expect(dead_code, reason = "only the JSON Schema tells how many")
    )]
    Points(Limits, usize, usize),
    /// Whole numbers, so many at most.
    #[cfg_attr(
        not(feature = "cli"),
        expect(dead_code, reason = "only the JSON Schema tells how many")
    )]
    Wholes(Limits, usize),
    Table(&'static [Key]),
    /// Tables, so many at most, with the end of the sentence on how to write
    /// them.
    #[cfg_attr(
        not(feature = "cli"),
        expect(dead_code, reason = "only the JSON Schema tells how many")
    )]
    Tables(&'static [Key], usize, &'static str),
    /// Tables whose keys depend on their `shape`.
    Obstacles,
}

/// The keys of one shape of obstacle.
pub(super) struct ShapeKeys {
    pub word: &'static str,
    #[cfg_attr(
        not(feature = "cli"),
        expect(dead_code, reason = "only the JSON Schema tells it")
    )]
    pub about: &'static str,
    pub keys: &'static [Key],
}

pub(super) const SCENE: &[Key] = &[
    required("version", "the version of the file format", Kind::Version),
    optional("title", "what the scene is called", Kind::Text),
    required("robot", "the robot", Kind::Table(ROBOT)),
    required("actuation", "what drives the robot", Kind::Table(ACTUATION)),
    optional(
        "contact",
        "which parts of the robot obstacles keep out",
        Kind::Table(CONTACT),
    ),
    optional("obstacle", "what stands around the robot", Kind::Obstacles),
    optional(
        "measured",
        "what was measured on the robot",
        Kind::Table(MEASURED),
    ),
    optional("photo", "a photograph behind the robot", Kind::Table(PHOTO)),
];

const ROBOT: &[Key] = &[
    required(
        "length_mm",
        "the length of the backbone",
        Kind::Number(limits::LENGTH),
    ),
    required(
        "segments",
        "the number of segments the backbone is divided into",
        Kind::Whole(limits::SEGMENTS),
    ),
    optional(
        "segments_per_bay",
        "the number of segments between neighbouring disks, which must divide segments",
        Kind::Whole(limits::SEGMENTS_PER_BAY),
    ),
    required(
        "cable_offset_mm",
        "the distance between backbone and cable",
        Kind::Number(limits::CABLE_OFFSET),
    ),
    optional(
        "disk_radius_mm",
        "the radius of the disks' rim, at least cable_offset_mm and equal to it when left out",
        Kind::Number(limits::DISK_RADIUS),
    ),
    optional(
        "disk_thickness_mm",
        "the thickness of a disk",
        Kind::Number(limits::DISK_THICKNESS),
    ),
    optional(
        "backbone_diameter_mm",
        "the diameter of the backbone",
        Kind::Number(limits::LINE_DIAMETER),
    ),
    optional(
        "cable_diameter_mm",
        "the diameter of the cable",
        Kind::Number(limits::LINE_DIAMETER),
    ),
    optional(
        "bending_stiffness_nmm2",
        "the backbone's bending stiffness EI, which turns multipliers into forces",
        Kind::Number(limits::BENDING_STIFFNESS),
    ),
    optional(
        "base_mm",
        "where the backbone starts",
        Kind::Pair(limits::COORDINATE),
    ),
    optional(
        "base_angle_deg",
        "the turn of the whole robot about its base, counterclockwise from +y",
        Kind::Number(limits::ANGLE),
    ),
];

const ACTUATION: &[Key] = &[required(
    "pull_mm",
    "the length of cable drawn in, negative to let cable out",
    Kind::Number(limits::PULL),
)];

const CONTACT: &[Key] = &[
    optional(
        "candidates",
        "what obstacles keep out: all nodes of backbone and cable, the robot's whole body, or the listed nodes",
        Kind::Word(&["nodes", "body", "listed"]),
    ),
    optional(
        "listed",
        "the nodes that obstacles keep out when candidates is \"listed\"",
        // No more nodes than the robot has can be listed once each.
        Kind::Tables(
            LISTED,
            2 * limits::SEGMENTS.max as usize,
            "such as [{ line = \"cable\", node = 1 }]",
        ),
    ),
];

const LISTED: &[Key] = &[
    required(
        "line",
        "the line the node is on",
        Kind::Word(&["backbone", "cable"]),
    ),
    required(
        "node",
        "the index of the node, the base being 0 and the tip robot.segments",
        Kind::Whole(limits::NODE),
    ),
];

const MEASURED: &[Key] = &[
    optional(
        "points_mm",
        "a measured backbone in the scene's frame, base to tip",
        Kind::Points(
            limits::COORDINATE,
            limits::LEAST_MEASURED_POINTS,
            limits::MEASURED_POINTS,
        ),
    ),
    optional(
        "nodes",
        "the node that each of points_mm is, ascending, the base being 0",
        Kind::Wholes(limits::MEASURED_NODE, limits::MEASURED_POINTS),
    ),
    optional(
        "calibration",
        "the index of the reading that fixes the ratio of the force's components, the first being 0",
        Kind::Whole(limits::READING),
    ),
    optional(
        "force",
        "readings of the contact force",
        Kind::Tables(
            READING,
            limits::READINGS,
            "each under its own [[measured.force]]",
        ),
    ),
];

const READING: &[Key] = &[
    required(
        "load_g",
        "the weight on the cable, counted from contact",
        Kind::Number(limits::LOAD),
    ),
    required(
        "force_g",
        "the contact force that was read, as a weight",
        Kind::Number(limits::FORCE),
    ),
];

const PHOTO: &[Key] = &[
    required(
        "file",
        "the picture's file, from the folder of the scene file",
        Kind::Text,
    ),
    CENTER,
    required(
        "width_mm",
        "its width in the scene before its turn",
        Kind::Number(limits::PHOTO_WIDTH),
    ),
    optional(
        "rotation_deg",
        "its turn about its centre, counterclockwise",
        Kind::Number(limits::ANGLE),
    ),
    optional(
        "opacity",
        "how much of it shows",
        Kind::Number(limits::OPACITY),
    ),
];

pub(super) const SHAPES: &[ShapeKeys] = &[
    ShapeKeys {
        word: SHAPE_WORDS[0],
        about: "a round post",
        keys: &[SHAPE, NAME, CENTER, RADIUS],
    },
    ShapeKeys {
        word: SHAPE_WORDS[1],
        about: "everything behind a straight line",
        keys: &[
            SHAPE,
            NAME,
            required(
                "point_mm",
                "a point of the wall's surface",
                Kind::Pair(limits::COORDINATE),
            ),
            optional(
                "rotation_deg",
                "the direction from the wall towards the free side, counterclockwise from +x",
                Kind::Number(limits::ANGLE),
            ),
            optional(
                "corner_radius_mm",
                "how far the surface is shifted towards the free side",
                Kind::Number(limits::CORNER_RADIUS),
            ),
        ],
    },
    ShapeKeys {
        word: SHAPE_WORDS[2],
        about: "a rectangle",
        keys: &[
            SHAPE,
            NAME,
            CENTER,
            required(
                "size_mm",
                "its outer width and height before its turn",
                Kind::Pair(limits::SIDE),
            ),
            TURN,
            optional(
                "corner_radius_mm",
                "the radius that rounds its corners, inside its outer size and at most half the smaller side",
                Kind::Number(limits::CORNER_RADIUS),
            ),
        ],
    },
    ShapeKeys {
        word: SHAPE_WORDS[3],
        about: "a straight bar with round ends",
        keys: &[
            SHAPE,
            NAME,
            CENTER,
            required(
                "length_mm",
                "the distance between the centres of its round ends",
                Kind::Number(limits::SIDE),
            ),
            RADIUS,
            optional(
                "rotation_deg",
                "the direction of its axis, counterclockwise from +x",
                Kind::Number(limits::ANGLE),
            ),
        ],
    },
    ShapeKeys {
        word: SHAPE_WORDS[4],
        about: "a convex polygon, grown by a radius",
        keys: &[
            SHAPE,
            NAME,
            required(
                "points_mm",
                "its vertices in order, either way round",
                Kind::Points(limits::COORDINATE, limits::LEAST_VERTICES, limits::VERTICES),
            ),
            TURN,
            optional(
                "corner_radius_mm",
                "how far outside the vertices' polygon the outline lies",
                Kind::Number(limits::CORNER_RADIUS),
            ),
        ],
    },
];

const SHAPE_WORDS: &[&str] = &["disc", "wall", "box", "capsule", "polygon"];
/// The key that tells which of [`SHAPES`] an obstacle's other keys are.
pub(super) const SHAPE: Key = required(
    "shape",
    "the shape of the obstacle",
    Kind::Word(SHAPE_WORDS),
);
const NAME: Key = optional("name", "what the obstacle is called", Kind::Text);
const CENTER: Key = required("center_mm", "its centre", Kind::Pair(limits::COORDINATE));
const RADIUS: Key = required("radius_mm", "its radius", Kind::Number(limits::RADIUS));
const TURN: Key = optional(
    "rotation_deg",
    "its turn about its centre or the mean of its vertices, counterclockwise",
    Kind::Number(limits::ANGLE),
);

const fn required(name: &'static str, about: &'static str, kind: Kind) -> Key {
    Key {
        name,
        about,
        kind,
        presence: Presence::Required,
    }
}

const fn optional(name: &'static str, about: &'static str, kind: Kind) -> Key {
    Key {
        name,
        about,
        kind,
        presence: Presence::Optional,
    }
}

/// What the value has to be, as the end of a sentence: `a number of
/// millimetres, from 1 to 10`.
pub(super) fn expected(kind: &Kind) -> String {
    match kind {
        Kind::Version => format!("the whole number {VERSION}"),
        Kind::Number(range) => number(range),
        Kind::Whole(range) => format!("a whole number, {range}"),
        Kind::Text => "a string, \"in quotes\"".to_owned(),
        Kind::Word(words) => {
            let quoted: Vec<_> = words.iter().map(|word| format!("\"{word}\"")).collect();
            format!("one of {}", quoted.join(", "))
        }
        Kind::Pair(range) => format!("a pair such as [1, 2], each {}", number(range)),
        Kind::Points(..) => {
            "a list of points in millimetres, such as [[0, 0], [1, 0], [0, 1]]".to_owned()
        }
        Kind::Wholes(range, _) => {
            format!("a list of whole numbers such as [0, 2, 4], each {range}")
        }
        Kind::Table(_) => "a table".to_owned(),
        Kind::Tables(_, _, written) => format!("a list of tables, {written}"),
        Kind::Obstacles => "a list of tables, each under its own [[obstacle]]".to_owned(),
    }
}

/// What a number in this range has to be.
pub(super) fn number(range: &Limits) -> String {
    match range.unit {
        Unit::Millimetre => format!("a number of millimetres, {range}"),
        Unit::Degree => format!("a number of degrees, {range}"),
        Unit::Gram => format!("a number of grams, {range}"),
        Unit::NewtonSquareMillimetre => format!("a number of N mm², {range}"),
        Unit::One => format!("a number, {range}"),
    }
}
