//! Requests and updates as bytes, for a solver that shares no memory with the
//! window. Numbers arrive bit for bit.

use super::{Request, Update};

/// Bytes that are no message of this version of the program.
#[derive(Clone, Debug, thiserror::Error)]
#[error("a message between the window and its solver cannot be read or written: {0}")]
pub struct WireError(#[from] postcard::Error);

/// A request as bytes.
///
/// # Errors
/// None is known; those of the format.
pub fn write_request(request: &Request) -> Result<Vec<u8>, WireError> {
    Ok(postcard::to_stdvec(request)?)
}

/// The request that the bytes say.
///
/// # Errors
/// When they are not those of a request.
pub fn read_request(bytes: &[u8]) -> Result<Request, WireError> {
    Ok(postcard::from_bytes(bytes)?)
}

/// An update as bytes.
///
/// # Errors
/// None is known; those of the format.
pub fn write_update(update: &Update) -> Result<Vec<u8>, WireError> {
    Ok(postcard::to_stdvec(update)?)
}

/// The update that the bytes say.
///
/// # Errors
/// When they are not those of an update.
pub fn read_update(bytes: &[u8]) -> Result<Update, WireError> {
    Ok(postcard::from_bytes(bytes)?)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mechanics::Problem;
    use crate::scene::Scene;
    use crate::solving::{Job, StartFrom, Work};

    fn request() -> Request {
        let scene = Scene::from_toml(include_str!("../../assets/scenes/shapes.toml")).unwrap();
        Request {
            generation: 7,
            course: 3,
            problem: Problem::new(&scene).unwrap(),
            from: StartFrom::Straight,
            span: (0.0, 0.012),
        }
    }

    /// All that a request leads to, as bytes.
    fn answers(request: Request) -> Vec<Vec<u8>> {
        let mut job = Job::default();
        job.take(request);
        let mut found = Vec::new();
        loop {
            match job.work() {
                Work::More => {}
                Work::Found(update) => found.push(write_update(&update).unwrap()),
                Work::Done => return found,
            }
        }
    }

    #[test]
    fn a_request_that_went_by_wire_is_answered_bit_for_bit() {
        let sent = read_request(&write_request(&request()).unwrap()).unwrap();
        assert_eq!(answers(sent), answers(request()));
    }

    #[test]
    fn answers_are_the_same_after_the_wire() {
        let found = answers(request());
        assert_eq!(found.len(), 2);
        for bytes in found {
            let again = write_update(&read_update(&bytes).unwrap()).unwrap();
            assert_eq!(again, bytes);
        }
    }

    #[test]
    fn torn_messages_are_refused() {
        let bytes = write_request(&request()).unwrap();
        for length in 0..bytes.len() {
            assert!(read_request(&bytes[..length]).is_err(), "{length}");
        }
    }
}
