//! Conversions between the library's SI units and those of files and labels.
//!
//! The only place where a factor between them appears, be it a thousand or
//! π/180; the many units that a measured table may be in are listed where such
//! tables are read. It holds no quantities of its own.

/// Metres in a millimetre.
pub const METRES_PER_MM: f64 = 1e-3;

/// Metres from millimetres.
pub fn metres(millimetres: f64) -> f64 {
    millimetres * METRES_PER_MM
}

/// Millimetres from metres.
pub fn millimetres(metres: f64) -> f64 {
    metres / METRES_PER_MM
}

/// Radians from degrees.
pub fn radians(degrees: f64) -> f64 {
    degrees.to_radians()
}

/// Degrees from radians.
pub fn degrees(radians: f64) -> f64 {
    radians.to_degrees()
}

/// A quantity a millimetre from one a metre.
pub fn per_millimetre(per_metre: f64) -> f64 {
    per_metre * METRES_PER_MM
}

/// The unit of multipliers, and of the energy's slope over the pull, in files
/// and labels: what [`per_millimetre`] gives.
pub const RAD2_PER_MM: &str = "rad²/mm";

/// Picometres from metres.
pub fn picometres(metres: f64) -> f64 {
    1e12 * metres
}

/// Newtons in the weight of a gram, with the standard acceleration of gravity,
/// 9.80665 m/s².
pub const NEWTONS_PER_GRAM: f64 = 9.80665e-3;

/// Newtons from the weight of so many grams.
pub fn newtons(grams: f64) -> f64 {
    grams * NEWTONS_PER_GRAM
}

/// The grams that weigh so many newtons.
pub fn grams(newtons: f64) -> f64 {
    newtons / NEWTONS_PER_GRAM
}

/// Pascals from gigapascals.
pub fn pascals(gigapascals: f64) -> f64 {
    gigapascals * 1e9
}

/// N·m² from N·mm².
pub fn newton_square_metres(newton_square_millimetres: f64) -> f64 {
    newton_square_millimetres * METRES_PER_MM * METRES_PER_MM
}

/// N·mm² from N·m².
pub fn newton_square_millimetres(newton_square_metres: f64) -> f64 {
    newton_square_metres / (METRES_PER_MM * METRES_PER_MM)
}
