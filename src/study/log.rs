//! Results as bytes: a head that names the study, then chunks of rows, each with its
//! checksum. Only ever added to; cut off anywhere, all whole chunks before are read.
//!
//! | bytes | of the head |
//! |---|---|
//! | 8 | `sinewlog` |
//! | 4 | the version of these bytes |
//! | 4 | numbers of a row |
//! | 16 | the study's digest |
//! | 8, 8 | the first sample and the one after the last |
//! | 8 | checksum of the bytes before |
//!
//! | bytes | of a chunk |
//! |---|---|
//! | 8 | its first sample |
//! | 4 | its rows |
//! | 4 | bytes of them all |
//! | each row: 1, 2, … | verdict, bytes of the reason, the reason |
//! | each row: 8 each | its numbers |
//! | 8 | checksum of the bytes before |
//!
//! All numbers have their least byte first.

use std::ops::Range;

use super::hash::checksum;
use super::row::{Row, Verdict};

/// The version of the bytes.
const VERSION: u32 = 1;
/// What a file begins with.
const MAGIC: &[u8; 8] = b"sinewlog";
/// Bytes of the head.
pub const HEAD_BYTES: usize = 56;
/// Bytes of a chunk before its rows.
pub const CHUNK_HEAD_BYTES: usize = 16;
/// Bytes of a checksum.
pub const CHECKSUM_BYTES: usize = 8;
/// Most rows of a chunk.
pub const MOST_ROWS: usize = 16_384;
/// Longest reason that is kept, in bytes.
const LONGEST_REASON: usize = 1000;

/// What a log is of.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Head {
    /// The study's digest.
    pub digest: u128,
    /// Numbers of a row.
    pub width: u32,
    /// The samples that it is to hold.
    pub samples: Range<u64>,
}

/// Why bytes are no log's head.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum HeadError {
    /// Too few of them: writing was cut off at once, and nothing is lost.
    #[error("the file ends within its head")]
    CutOff,
    /// Other bytes.
    #[error("the file is no log of a study's results")]
    Other,
    /// Of a version that this program does not know.
    #[error("the file is of version {0}; this program reads version {VERSION}")]
    Version(u32),
}

impl Head {
    /// The bytes that a file begins with.
    pub fn to_bytes(&self) -> Vec<u8> {
        let mut bytes = MAGIC.to_vec();
        bytes.extend(VERSION.to_le_bytes());
        bytes.extend(self.width.to_le_bytes());
        bytes.extend(self.digest.to_le_bytes());
        bytes.extend(self.samples.start.to_le_bytes());
        bytes.extend(self.samples.end.to_le_bytes());
        bytes.extend(checksum(&bytes).to_le_bytes());
        bytes
    }

    /// The head of the bytes that a file begins with.
    ///
    /// # Errors
    /// If they are none.
    pub fn of_bytes(bytes: &[u8]) -> Result<Self, HeadError> {
        let begins = bytes.len().min(MAGIC.len());
        if bytes[..begins] != MAGIC[..begins] {
            return Err(HeadError::Other);
        }
        if bytes.len() < HEAD_BYTES {
            return Err(HeadError::CutOff);
        }
        let mut reader = Reader(&bytes[MAGIC.len()..HEAD_BYTES]);
        let read = || {
            let (version, width) = (reader.u32()?, reader.u32()?);
            let digest = u128::from_le_bytes(reader.array()?);
            let samples = reader.u64()?..reader.u64()?;
            Some((version, width, digest, samples, reader.u64()?))
        };
        let (version, width, digest, samples, sum) = { read }().ok_or(HeadError::CutOff)?;
        if sum != checksum(&bytes[..HEAD_BYTES - CHECKSUM_BYTES]) {
            return Err(HeadError::Other);
        }
        if version != VERSION {
            return Err(HeadError::Version(version));
        }
        Ok(Self {
            digest,
            width,
            samples,
        })
    }
}

/// The bytes of a chunk of rows from a sample on.
///
/// # Panics
/// If there are more than [`MOST_ROWS`].
pub fn chunk(first: u64, rows: &[Row]) -> Vec<u8> {
    assert!(rows.len() <= MOST_ROWS, "{} rows", rows.len());
    let mut body = Vec::new();
    for row in rows {
        let place = Verdict::ALL
            .iter()
            .position(|verdict| *verdict == row.verdict);
        body.push(place.unwrap_or_default() as u8);
        let reason = kept(&row.reason);
        body.extend((reason.len() as u16).to_le_bytes());
        body.extend(reason.bytes());
        for number in &row.numbers {
            body.extend(number.to_bits().to_le_bytes());
        }
    }
    let mut bytes = first.to_le_bytes().to_vec();
    bytes.extend((rows.len() as u32).to_le_bytes());
    bytes.extend((body.len() as u32).to_le_bytes());
    bytes.extend(body);
    bytes.extend(checksum(&bytes).to_le_bytes());
    bytes
}

fn kept(reason: &str) -> &str {
    let end = (0..=LONGEST_REASON.min(reason.len())).rev();
    let end = end.into_iter().find(|end| reason.is_char_boundary(*end));
    &reason[..end.unwrap_or(0)]
}

/// The bytes of a whole chunk, from those before its rows; `None` where no chunk begins
/// so.
pub fn chunk_bytes(head: &[u8], width: u32) -> Option<usize> {
    let mut reader = Reader(head);
    let (_, rows, body) = (
        reader.u64()?,
        reader.u32()? as usize,
        reader.u32()? as usize,
    );
    let most = rows.checked_mul(3 + LONGEST_REASON + 8 * width as usize)?;
    let is_one = (1..=MOST_ROWS).contains(&rows) && body <= most;
    is_one.then_some(CHUNK_HEAD_BYTES + body + CHECKSUM_BYTES)
}

/// The rows of a whole chunk's bytes and its first sample; `None` where they are none.
pub fn rows(bytes: &[u8], width: u32) -> Option<(u64, Vec<Row>)> {
    if chunk_bytes(bytes, width)? != bytes.len() {
        return None;
    }
    let (checked, sum) = bytes.split_at(bytes.len() - CHECKSUM_BYTES);
    if checksum(checked).to_le_bytes() != sum {
        return None;
    }
    let mut reader = Reader(checked);
    let (first, count, _) = (reader.u64()?, reader.u32()?, reader.u32()?);
    let mut rows = Vec::new();
    for _ in 0..count {
        let [verdict] = reader.array()?;
        let length = u16::from_le_bytes(reader.array()?);
        let reason = reader.take(length.into())?;
        let numbers = (0..width).map(|_| reader.u64().map(f64::from_bits));
        let numbers = numbers.collect::<Option<_>>()?;
        rows.push(Row {
            verdict: *Verdict::ALL.get(usize::from(verdict))?,
            reason: str::from_utf8(reason).ok()?.to_owned(),
            numbers,
        });
    }
    reader.0.is_empty().then_some((first, rows))
}

/// Bytes still to be read.
struct Reader<'a>(&'a [u8]);

impl<'a> Reader<'a> {
    fn take(&mut self, count: usize) -> Option<&'a [u8]> {
        let (taken, rest) = self.0.split_at_checked(count)?;
        self.0 = rest;
        Some(taken)
    }

    fn array<const N: usize>(&mut self) -> Option<[u8; N]> {
        self.take(N)?.try_into().ok()
    }

    fn u32(&mut self) -> Option<u32> {
        self.array().map(u32::from_le_bytes)
    }

    fn u64(&mut self) -> Option<u64> {
        self.array().map(u64::from_le_bytes)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn some_rows() -> Vec<Row> {
        vec![
            Row {
                verdict: Verdict::Converged,
                reason: String::new(),
                numbers: vec![1.5, f64::NAN],
            },
            Row {
                verdict: Verdict::BadScene,
                reason: "robot.length_mm is −1 mm".to_owned(),
                numbers: vec![f64::NAN, f64::NAN],
            },
        ]
    }

    fn head() -> Head {
        Head {
            digest: 1 << 100,
            width: 2,
            samples: 3..77,
        }
    }

    #[test]
    fn what_is_written_is_read() {
        let bytes = head().to_bytes();
        assert_eq!(bytes.len(), HEAD_BYTES);
        assert_eq!(Head::of_bytes(&bytes), Ok(head()));
        let bytes = chunk(9, &some_rows());
        assert_eq!(
            chunk_bytes(&bytes[..CHUNK_HEAD_BYTES], 2),
            Some(bytes.len())
        );
        let (first, read) = rows(&bytes, 2).unwrap();
        assert_eq!(first, 9);
        // By bits, for no NaN equals another.
        assert_eq!(chunk(9, &read), bytes);
        assert_eq!(read[1].reason, some_rows()[1].reason);
    }

    #[test]
    fn a_byte_that_is_wrong_or_missing_is_found() {
        let whole = head().to_bytes();
        for end in 0..whole.len() {
            assert_eq!(
                Head::of_bytes(&whole[..end]),
                Err(HeadError::CutOff),
                "{end}"
            );
        }
        let chunk = chunk(9, &some_rows());
        for place in 0..whole.len() {
            let mut bytes = whole.clone();
            bytes[place] ^= 1;
            assert!(Head::of_bytes(&bytes).is_err(), "{place}");
        }
        for place in 0..chunk.len() {
            assert!(rows(&chunk[..place], 2).is_none(), "{place}");
            let mut bytes = chunk.clone();
            bytes[place] ^= 1;
            assert!(rows(&bytes, 2).is_none(), "{place}");
        }
    }

    #[test]
    fn a_long_reason_is_cut_between_characters() {
        let mut row = some_rows().swap_remove(1);
        row.reason = "−".repeat(5000);
        let bytes = chunk(0, &[row]);
        assert_eq!(rows(&bytes, 2).unwrap().1[0].reason, "−".repeat(333));
    }
}
