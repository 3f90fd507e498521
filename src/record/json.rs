//! Records as JSON: compact, on one line, every number with all its digits and
//! no zero with a sign.

// serde_json writes through this trait; here always into memory.
use std::io::{Result, Write};

use serde::Serialize;
use serde_json::Serializer;
use serde_json::ser::{CompactFormatter, Formatter};

/// What stands before the first state of a path.
pub const PATH_START: &str = r#"{"schema":"sinew-path-2","states":["#;

/// What stands after its last one.
pub const PATH_END: &str = "]}";

/// A record as JSON.
///
/// # Errors
/// For a map whose keys are no texts, which no record here has.
pub fn text(record: &impl Serialize) -> serde_json::Result<String> {
    let mut bytes = Vec::new();
    record.serialize(&mut Serializer::with_formatter(&mut bytes, UnsignedZero))?;
    // It writes nothing but UTF-8.
    Ok(String::from_utf8_lossy(&bytes).into_owned())
}

/// Compact JSON in which no zero has a sign.
struct UnsignedZero;

impl Formatter for UnsignedZero {
    fn write_f64<W: ?Sized + Write>(&mut self, writer: &mut W, value: f64) -> Result<()> {
        CompactFormatter.write_f64(writer, crate::math::unsigned_zero(value))
    }
}

#[cfg(test)]
mod tests {
    use super::text;

    #[test]
    fn zero_has_no_sign_and_numbers_all_their_digits() {
        let numbers = [0.0, -0.0, -0.1, 1e-7, 2.0 / 3.0];
        let expected = "[0.0,0.0,-0.1,1e-7,0.6666666666666666]";
        assert_eq!(text(&numbers).unwrap(), expected);
        assert_eq!(text(&"-0.0, µ").unwrap(), "\"-0.0, µ\"");
    }
}
