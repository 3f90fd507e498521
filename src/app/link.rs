//! A whole scene in the fragment of a link, and back. Opens no address and
//! touches no clipboard: text in, text out.
//!
//! A fragment is `#s1.` and then the scene's TOML, without what may be left
//! out of it, deflated (RFC 1951) and written in the letters of base64url
//! (RFC 4648) without padding. A fragment never leaves the browser, so a link
//! needs no server that keeps scenes.
//!
//! Links come from strangers. Neither a long link nor a short one that inflates
//! to much costs more than fixed amounts of time and memory.

use std::io::Write as _;

use base64::Engine as _;
use base64::engine::general_purpose::URL_SAFE_NO_PAD as LETTERS;
use flate2::write::DeflateEncoder;
use flate2::{Compression, Decompress, FlushDecompress, Status};
use toml::{Table, Value};

use crate::scene::{Scene, SceneError};

/// The most characters of a fragment, `#` included. Programs that pass links on
/// cut longer ones; some cut at 8192.
pub const MAX_CHARACTERS: usize = 8000;

/// The most bytes of TOML in a link: some twenty times what usually fits into
/// one, for scenes that repeat themselves.
pub const MAX_TEXT_BYTES: usize = 128 << 10;

/// What a fragment starts with, the `#` aside, before its version.
const MARK: char = 's';
/// The only version of links there is.
const VERSION: &str = "1";

/// Why a scene cannot be put into a link, or a link not be opened.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum LinkError {
    /// The scene does not fit.
    #[error(
        "the link would have {characters} characters and most programs cut it after \
         {MAX_CHARACTERS}; {advice}"
    )]
    TooMuch {
        /// How long it would be.
        characters: usize,
        /// What to leave out, or do instead.
        advice: &'static str,
    },
    /// The scene's text is too long for a link however well it packs.
    #[error(
        "the scene has {bytes} bytes of text, and a link holds at most {MAX_TEXT_BYTES}; {advice}"
    )]
    TooMuchText {
        /// Its length.
        bytes: usize,
        /// What to leave out, or do instead.
        advice: &'static str,
    },
    /// The text is no link to a scene.
    #[error(
        "this is no link to a scene; one ends in #s1. and many letters and digits: copy all of it"
    )]
    NoScene,
    /// A link of another version.
    #[error(
        "the link is of version {0}, and this program reads version {VERSION}; open it with a newer one"
    )]
    Version(String),
    /// The link is longer than any that holds a scene.
    #[error(
        "the link has {characters} characters after its #; one to a scene has at most {MAX_CHARACTERS}"
    )]
    TooLong {
        /// How many it has.
        characters: usize,
    },
    /// A character that cannot be in a link.
    #[error(
        "character {place} after the # is {found:?}, which no link to a scene has; copy the link again"
    )]
    Character {
        /// Which character it is, from 1.
        place: usize,
        /// The character.
        found: char,
    },
    /// The link was cut.
    #[error("the end of the link is missing; copy all of it")]
    Cut,
    /// What is in the link is not what any scene was packed into.
    #[error("the link is damaged; copy it again")]
    Damaged,
    /// The link inflates beyond all measure.
    #[error("the link unpacks to more than {MAX_TEXT_BYTES} bytes, which no link to a scene does")]
    Bomb,
    /// The link holds text that is no scene, or a scene with faults, or such a
    /// scene was to be put into one.
    #[error("the scene of the link is at fault: {0}")]
    Scene(#[from] SceneError),
}

/// The fragment that holds a scene, from its `#` on. A photograph is left out:
/// its file is not where the link is opened.
///
/// # Errors
/// [`LinkError::Scene`] for a scene with faults, [`LinkError::TooMuch`] and
/// [`LinkError::TooMuchText`] for one that does not fit.
pub fn encode(scene: &Scene) -> Result<String, LinkError> {
    scene.check()?;
    let text = short_toml(scene)?;
    if text.len() > MAX_TEXT_BYTES {
        return Err(LinkError::TooMuchText {
            bytes: text.len(),
            advice: advice(scene),
        });
    }
    let link = format!(
        "#{MARK}{VERSION}.{}",
        LETTERS.encode(deflated(text.as_bytes())?)
    );
    if link.len() > MAX_CHARACTERS {
        return Err(LinkError::TooMuch {
            characters: link.len(),
            advice: advice(scene),
        });
    }
    Ok(link)
}

/// The scene that a link holds: a whole address, its fragment with or without
/// `#`, with white space around it. The scene has no faults of its fields, but
/// [`crate::mechanics::Problem`] may still refuse it.
///
/// # Errors
/// When the link holds no scene: see [`LinkError`].
pub fn decode(link: &str) -> Result<Scene, LinkError> {
    let link = link.trim();
    let fragment = link.split_once('#').map_or(link, |(_, after)| after);
    let characters = fragment.chars().count();
    if characters >= MAX_CHARACTERS {
        return Err(LinkError::TooLong { characters });
    }
    let letters = letters(fragment)?;
    let packed = LETTERS
        .decode(letters)
        .map_err(|error| not_letters(fragment, letters, &error))?;
    let scene = Scene::from_toml_bytes(&inflated(&packed)?)?;
    scene.check()?;
    Ok(scene)
}

/// What follows the mark and the version.
fn letters(fragment: &str) -> Result<&str, LinkError> {
    let after = fragment.strip_prefix(MARK).ok_or(LinkError::NoScene)?;
    let digits = after.len() - after.trim_start_matches(|c: char| c.is_ascii_digit()).len();
    let (version, rest) = after.split_at(digits);
    match rest.strip_prefix('.') {
        _ if version.is_empty() || version.len() > 9 => Err(LinkError::NoScene),
        Some(letters) if version == VERSION => Ok(letters),
        Some(_) => Err(LinkError::Version(version.to_owned())),
        None if rest.is_empty() => Err(LinkError::Cut),
        None => Err(LinkError::NoScene),
    }
}

fn not_letters(fragment: &str, letters: &str, error: &base64::DecodeError) -> LinkError {
    let base64::DecodeError::InvalidByte(offset, _) = error else {
        // A number of letters, or a last letter, that only a cut leaves.
        return LinkError::Cut;
    };
    let at = fragment.len() - letters.len() + offset;
    // The offset is a byte's, and all before it are single ones.
    match fragment.get(at..).and_then(|rest| rest.chars().next()) {
        Some(found) => LinkError::Character {
            place: at + 1,
            found,
        },
        None => LinkError::Damaged,
    }
}

/// What to do about a scene that is too long.
fn advice(scene: &Scene) -> &'static str {
    let measured = scene.measured.as_ref();
    if measured.is_some_and(|measured| !measured.points_mm.is_empty()) {
        "leave the measured backbone out, or send the scene's file"
    } else if measured.is_some_and(|measured| !measured.forces.is_empty()) {
        "leave the force readings out, or send the scene's file"
    } else {
        "leave some obstacles out, or send the scene's file"
    }
}

/// The scene without its photograph as TOML, without defaults and decimal
/// points that say nothing.
fn short_toml(scene: &Scene) -> Result<String, LinkError> {
    let not_writable = |error: toml::ser::Error| SceneError::NotWritable {
        message: error.to_string(),
    };
    let mut table = Table::try_from(scene).map_err(not_writable)?;
    table.remove("photo");
    table.iter_mut().for_each(|(_, value)| shorten(value));
    let zero = Value::Integer(0);
    if let Some(Value::Table(robot)) = table.get_mut("robot") {
        for key in [
            "disk_thickness_mm",
            "backbone_diameter_mm",
            "base_angle_deg",
        ] {
            leave_out(robot, key, &zero);
        }
        leave_out(robot, "segments_per_bay", &Value::Integer(2));
        let origin = Value::Array(vec![zero.clone(), zero.clone()]);
        leave_out(robot, "base_mm", &origin);
    }
    if let Some(Value::Array(cables)) = table.get_mut("cable") {
        for cable in cables.iter_mut().filter_map(Value::as_table_mut) {
            leave_out(cable, "diameter_mm", &zero);
        }
    }
    if let Some(Value::Table(model)) = table.get_mut("model") {
        leave_out(model, "mechanics", &Value::String("sliding".to_owned()));
    }
    leave_out(&mut table, "model", &Value::Table(Table::new()));
    if let Some(Value::Array(obstacles)) = table.get_mut("obstacle") {
        for obstacle in obstacles.iter_mut().filter_map(Value::as_table_mut) {
            leave_out(obstacle, "rotation_deg", &zero);
            leave_out(obstacle, "corner_radius_mm", &zero);
        }
    }
    if let Some(Value::Table(contact)) = table.get_mut("contact") {
        leave_out(contact, "candidates", &Value::String("nodes".to_owned()));
    }
    leave_out(&mut table, "contact", &Value::Table(Table::new()));
    Ok(toml::to_string(&table).map_err(not_writable)?)
}

fn leave_out(table: &mut Table, key: &str, default: &Value) {
    if table.get(key) == Some(default) {
        table.remove(key);
    }
}

/// Writes whole numbers without a decimal point, which a scene reads the same.
fn shorten(value: &mut Value) {
    match value {
        // A float tells -0 from 0.
        Value::Float(number)
            if number.fract() == 0.0
                && number.abs() < 1e15
                && (*number != 0.0 || number.is_sign_positive()) =>
        {
            *value = Value::Integer(*number as i64);
        }
        Value::Array(items) => items.iter_mut().for_each(shorten),
        Value::Table(table) => table.iter_mut().for_each(|(_, item)| shorten(item)),
        _ => {}
    }
}

fn deflated(text: &[u8]) -> Result<Vec<u8>, LinkError> {
    let mut packer = DeflateEncoder::new(Vec::new(), Compression::best());
    let packed = packer.write_all(text).and_then(|()| packer.finish());
    Ok(packed.map_err(|error| SceneError::NotWritable {
        message: error.to_string(),
    })?)
}

/// The text that was packed, in one buffer that does not grow.
fn inflated(packed: &[u8]) -> Result<Vec<u8>, LinkError> {
    let mut unpacker = Decompress::new(false);
    let mut text = Vec::with_capacity(MAX_TEXT_BYTES + 1);
    let status = unpacker
        .decompress_vec(packed, &mut text, FlushDecompress::Finish)
        .map_err(|_| LinkError::Damaged)?;
    match status {
        _ if text.len() > MAX_TEXT_BYTES => Err(LinkError::Bomb),
        Status::StreamEnd if unpacker.total_in() == packed.len() as u64 => Ok(text),
        Status::StreamEnd => Err(LinkError::Damaged),
        Status::Ok | Status::BufError => Err(LinkError::Cut),
    }
}

#[cfg(test)]
mod tests;
