//! The table itself: every key, what it means, and what it may hold.

use super::{Key, Kind, Presence, ShapeKeys, newer, optional, required};
use crate::scene::limits;

pub(in crate::scene) const SCENE: &[Key] = &[
    required("version", "the version of the file format", Kind::Version),
    optional("title", "what the scene is called", Kind::Text),
    newer(
        "model",
        "what the scene is to be solved with",
        Kind::Table(MODEL),
    ),
    required("robot", "the robot", Kind::Table(ROBOT)),
    optional("actuation", "what drives the robot", Kind::Table(ACTUATION)),
    newer(
        "cable",
        "the cables, in the place of robot.cable_offset_mm and actuation",
        Kind::Tables(CABLE, limits::CABLES, "each under its own [[cable]]"),
    ),
    newer("friction", "where the robot rubs", Kind::Table(FRICTION)),
    newer(
        "loads",
        "what acts on the robot beside its cables and obstacles",
        Kind::Table(LOADS),
    ),
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

const MODEL: &[Key] = &[newer(
    "mechanics",
    "how the cables act: they slide through the disks, or every segment of a cable shortens alike, as in the paper",
    Kind::Word(&["sliding", "equal"]),
)];

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
    optional(
        "cable_offset_mm",
        "the distance between backbone and cable",
        Kind::Number(limits::CABLE_OFFSET),
    ),
    optional(
        "disk_radius_mm",
        "the radius of the disks' rim, at least the largest offset of a cable and equal to it when left out",
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
    newer(
        "disk_mass_g",
        "the mass of each disk but the base's",
        Kind::Number(limits::MASS),
    ),
    newer(
        "backbone_mass_g",
        "the mass of the backbone, spread evenly along it",
        Kind::Number(limits::MASS),
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

/// Numbers that a scene does not keep and that can be set all the same: they
/// stand for `robot.segments`.
pub(in crate::scene) const SPACING: &[Key] = &[
    optional(
        "disk_spacing_mm",
        "the distance between neighbouring disks",
        Kind::Number(limits::DISK_SPACING),
    ),
    optional(
        "disks",
        "the number of disks without the base's",
        Kind::Whole(limits::DISKS),
    ),
];

const ACTUATION: &[Key] = &[PULL, LOAD];

const PULL: Key = Key {
    name: "pull_mm",
    about: "the length of cable drawn in, negative to let cable out",
    kind: Kind::Number(limits::PULL),
    presence: Presence::OneOf,
    since: 1,
};
const LOAD: Key = Key {
    name: "load_g",
    about: "the weight that hangs on the cable",
    kind: Kind::Number(limits::LOAD),
    presence: Presence::OneOf,
    since: 2,
};

const CABLE: &[Key] = &[
    required(
        "offset_mm",
        "the distance from the backbone, negative on the other side and not 0",
        Kind::Number(limits::CABLE_SIDE),
    ),
    PULL,
    LOAD,
    optional(
        "to_disk",
        "the disk that the cable ends at, the base's being 0; the last when left out",
        Kind::Whole(limits::TO_DISK),
    ),
    optional(
        "axial_stiffness_n",
        "the stiffness against stretching EA; the cable does not stretch when it is left out",
        Kind::Number(limits::AXIAL_STIFFNESS),
    ),
    optional(
        "diameter_mm",
        "the diameter of the cable",
        Kind::Number(limits::LINE_DIAMETER),
    ),
];

const FRICTION: &[Key] = &[
    optional(
        "holes",
        "the coefficient of friction of a cable in every hole",
        Kind::Number(limits::FRICTION),
    ),
    optional(
        "contacts",
        "the coefficient of friction of the robot on an obstacle",
        Kind::Number(limits::FRICTION),
    ),
    optional(
        "base_loss",
        "the share of a cable's load that is lost below the base",
        Kind::Number(limits::BASE_LOSS),
    ),
];

const LOADS: &[Key] = &[
    optional(
        "tip_force_n",
        "the force on the backbone's tip, in the scene's frame",
        Kind::Pair(limits::TIP_FORCE),
    ),
    optional(
        "tip_moment_nmm",
        "the moment on the last disk, clockwise",
        Kind::Number(limits::TIP_MOMENT),
    ),
    optional(
        "gravity_m_s2",
        "the acceleration by gravity, in the scene's frame",
        Kind::Pair(limits::GRAVITY),
    ),
];

const CONTACT: &[Key] = &[
    optional(
        "candidates",
        "what obstacles keep out: all nodes of backbone and cables, the robot's whole body, or the listed nodes",
        Kind::Word(&["nodes", "body", "listed"]),
    ),
    optional(
        "listed",
        "the nodes that obstacles keep out when candidates is \"listed\"",
        // No more nodes than the robot has can be listed once each.
        Kind::Tables(
            LISTED,
            (2 + limits::CABLES) * limits::SEGMENTS.max as usize,
            "such as [{ line = \"cable\", node = 1 }]",
        ),
    ),
];

const LISTED: &[Key] = &[
    required(
        "line",
        "the line the node is on; a rim is both ends of the node's disk",
        Kind::Word(&["backbone", "cable", "rim"]),
    ),
    newer(
        "cable",
        "the cable the node is on, the first being 0",
        Kind::Whole(limits::CABLE),
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

pub(in crate::scene) const SHAPES: &[ShapeKeys] = &[
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
pub(in crate::scene) const SHAPE: Key = required(
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
