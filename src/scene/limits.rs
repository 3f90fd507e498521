//! The range of every number in a scene, stated once.
//!
//! Generous on purpose: a range keeps out slips and values that no arithmetic
//! survives, not unusual robots. Checks, messages and the JSON Schema all read
//! these constants.

use std::fmt;

/// A closed range of numbers and their unit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Limits {
    /// The least value allowed, in `unit`.
    pub min: f64,
    /// The greatest value allowed, in `unit`.
    pub max: f64,
    /// What the numbers count.
    pub unit: Unit,
}

/// A unit of scene files.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unit {
    /// Millimetres.
    Millimetre,
    /// Degrees.
    Degree,
    /// Grams, as weights.
    Gram,
    /// N mm², of bending stiffnesses.
    NewtonSquareMillimetre,
    /// Newtons.
    Newton,
    /// N mm, of moments.
    NewtonMillimetre,
    /// m/s², of accelerations.
    MetrePerSecondSquared,
    /// Plain counts and shares.
    One,
}

/// Length of the backbone.
pub const LENGTH: Limits = mm(1.0, 1e5);
/// Number of segments.
pub const SEGMENTS: Limits = count(1.0, 1e5);
/// Number of segments between neighbouring disks.
pub const SEGMENTS_PER_BAY: Limits = SEGMENTS;
/// Number of segments between neighbouring disks where the cables slide: a bay
/// is solved as one block, whose cost grows with its cube, and more than two
/// serve contacts between disks only.
pub const SLIDING_SEGMENTS_PER_BAY: Limits = count(1.0, 8.0);
/// Number of disks without the base's.
pub const DISKS: Limits = SEGMENTS;
/// Distance between neighbouring disks.
pub const DISK_SPACING: Limits = mm(1e-5, 1e5);
/// Distance between backbone and cable.
pub const CABLE_OFFSET: Limits = mm(0.01, 1e4);
/// Distance between backbone and cable, negative on the other side. Its amount
/// is in the range [`CABLE_OFFSET`], too.
pub const CABLE_SIDE: Limits = mm(-CABLE_OFFSET.max, CABLE_OFFSET.max);
/// Most cables of a robot: more than any robot has that was built.
pub const CABLES: usize = 16;
/// Index of a cable, which is also below their number.
pub const CABLE: Limits = count(0.0, (CABLES - 1) as f64);
/// The disk that a cable ends at, which is also at most the last.
pub const TO_DISK: Limits = DISKS;
/// Stiffness of a cable against stretching: from far below a rubber thread's to
/// that of solid steel as thick as an arm.
pub const AXIAL_STIFFNESS: Limits = Limits {
    min: 1e-6,
    max: 1e12,
    unit: Unit::Newton,
};
/// Coefficient of friction. No dry pair of materials comes near the most, which
/// lets a cable be held fast in its holes.
pub const FRICTION: Limits = count(0.0, 1000.0);
/// Share of a load that is lost below the base. Were it 1, nothing of a load
/// would arrive, and no load would hold a pull.
pub const BASE_LOSS: Limits = count(0.0, 0.999);
/// Either component of the force on the tip: the weight of a hundred tonnes.
pub const TIP_FORCE: Limits = Limits {
    min: -1e6,
    max: 1e6,
    unit: Unit::Newton,
};
/// Moment on the tip: that of the greatest force at a metre.
pub const TIP_MOMENT: Limits = Limits {
    min: -1e9,
    max: 1e9,
    unit: Unit::NewtonMillimetre,
};
/// Either component of gravity: a hundred times the earth's.
pub const GRAVITY: Limits = Limits {
    min: -1000.0,
    max: 1000.0,
    unit: Unit::MetrePerSecondSquared,
};
/// Mass of a disk or of the backbone: up to a tonne.
pub const MASS: Limits = grams(0.0, 1e6);
/// Radius of a disk's rim, which is also at least the largest cable offset.
pub const DISK_RADIUS: Limits = mm(0.01, 1e4);
/// Thickness of a disk.
pub const DISK_THICKNESS: Limits = mm(0.0, 1e4);
/// Diameter of the backbone or of the cable.
pub const LINE_DIAMETER: Limits = mm(0.0, 1e4);
/// Bending stiffness of the backbone: from far below a hair's to that of solid
/// steel as thick as an arm.
pub const BENDING_STIFFNESS: Limits = Limits {
    min: 1e-6,
    max: 1e12,
    unit: Unit::NewtonSquareMillimetre,
};
/// Length of cable drawn in.
pub const PULL: Limits = mm(-1e5, 1e5);
/// Index of a listed node, which is also at most the number of segments.
pub const NODE: Limits = SEGMENTS;
/// Either coordinate of any point.
pub const COORDINATE: Limits = mm(-1e6, 1e6);
/// Any angle.
pub const ANGLE: Limits = Limits {
    min: -36_000.0,
    max: 36_000.0,
    unit: Unit::Degree,
};
/// Radius of a disc or of a capsule's ends.
pub const RADIUS: Limits = mm(0.001, 1e6);
/// Side of a box, or distance between a capsule's ends.
pub const SIDE: Limits = mm(0.001, 1e6);
/// Radius that grows or rounds an outline.
pub const CORNER_RADIUS: Limits = mm(0.0, 1e6);
/// Least distance between two vertices of a polygon, mm.
pub const VERTEX_SPACING_MM: f64 = 0.001;
/// Fewest vertices of a polygon.
pub const LEAST_VERTICES: usize = 3;
/// Most vertices of a polygon.
pub const VERTICES: usize = 64;
/// Most obstacles in a scene.
pub const OBSTACLES: usize = 1000;
/// Fewest points of a measured backbone.
pub const LEAST_MEASURED_POINTS: usize = 2;
/// Most points of a measured backbone.
pub const MEASURED_POINTS: usize = 10_000;
/// Node of a measured point, which is also at most the number of segments.
pub const MEASURED_NODE: Limits = count(0.0, 1e5);
/// Weight on a cable: up to a tonne.
pub const LOAD: Limits = grams(0.0, 1e6);
/// Contact force that was read.
pub const FORCE: Limits = grams(-1e6, 1e6);
/// Most readings of forces.
pub const READINGS: usize = 1000;
/// Index of the reading that fixes μ, which is also below their number.
pub const READING: Limits = count(0.0, (READINGS - 1) as f64);
/// Width of a photograph.
pub const PHOTO_WIDTH: Limits = mm(0.001, 1e6);
/// How much of a photograph shows.
pub const OPACITY: Limits = count(0.0, 1.0);

const fn mm(min: f64, max: f64) -> Limits {
    Limits {
        min,
        max,
        unit: Unit::Millimetre,
    }
}

const fn count(min: f64, max: f64) -> Limits {
    Limits {
        min,
        max,
        unit: Unit::One,
    }
}

const fn grams(min: f64, max: f64) -> Limits {
    Limits {
        min,
        max,
        unit: Unit::Gram,
    }
}

impl Limits {
    /// Whether the value lies in the range; false for NaN.
    pub fn contain(&self, value: f64) -> bool {
        (self.min..=self.max).contains(&value)
    }
}

/// `from 1 to 100000`, without the unit.
impl fmt::Display for Limits {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "from {} to {}", shown(self.min), shown(self.max))
    }
}

impl Unit {
    /// The sign after a number, empty for plain counts.
    pub fn symbol(self) -> &'static str {
        match self {
            Unit::Millimetre => "mm",
            Unit::Degree => "deg",
            Unit::Gram => "g",
            Unit::NewtonSquareMillimetre => "N mm²",
            Unit::Newton => "N",
            Unit::NewtonMillimetre => "N mm",
            Unit::MetrePerSecondSquared => "m/s²",
            Unit::One => "",
        }
    }
}

/// A number as one would write it in a scene file: `5`, `0.25`, `1e300`, `nan`.
pub fn shown(value: f64) -> String {
    if value.is_nan() {
        return "nan".to_owned();
    }
    let text = format!("{value:?}");
    match text.strip_suffix(".0") {
        Some(whole) if whole != "-0" => whole.to_owned(),
        _ => text,
    }
}
