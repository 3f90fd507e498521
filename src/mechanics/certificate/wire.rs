//! A certificate between the solver and the window.
//!
//! The four-bar robot's conditions go without their names, in their order, five
//! numbers, two answers and the slope: a shape is told many times a second, and
//! its bytes are those that answers have been compared by since before
//! conditions had names. Any other list goes by name, after a number that no
//! first residual is.

use super::{Certificate, Condition};
use serde::de::{Error, SeqAccess, Visitor};
use serde::ser::{SerializeTuple, Serializer};
use serde::{Deserialize, Deserializer, Serialize};
use std::fmt::{Formatter, Result as Written};

/// The conditions that go without their names: residuals, then answers.
const RESIDUALS: [Condition; 5] = [
    Condition::Stationarity,
    Condition::Links,
    Condition::Penetration,
    Condition::Complementarity,
    Condition::Dual,
];
const ANSWERS: [Condition; 2] = [Condition::Orientation, Condition::Minimum];
/// Those with the slope.
const LENGTH: usize = RESIDUALS.len() + ANSWERS.len() + 1;
/// In the place of the first residual: the conditions follow by name.
const BY_NAME: f64 = -1.0;

impl Serialize for Certificate {
    fn serialize<S: Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
        let known = RESIDUALS.into_iter().chain(ANSWERS);
        let goes_bare = known.eq(self.conditions().map(|(it, _)| it));
        if !goes_bare || self.values[0].1 == BY_NAME {
            let named: Vec<_> = self.conditions().collect();
            return (BY_NAME, named, self.energy_slope).serialize(to);
        }
        let mut bare = to.serialize_tuple(LENGTH)?;
        for (_, value) in self.conditions().take(RESIDUALS.len()) {
            bare.serialize_element(&value)?;
        }
        for (_, value) in self.conditions().skip(RESIDUALS.len()) {
            bare.serialize_element(&(value == 1.0))?;
        }
        bare.serialize_element(&self.energy_slope)?;
        bare.end()
    }
}

impl<'de> Deserialize<'de> for Certificate {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
        from.deserialize_tuple(LENGTH, Reader)
    }
}

struct Reader;

impl<'de> Visitor<'de> for Reader {
    type Value = Certificate;

    fn expecting(&self, to: &mut Formatter<'_>) -> Written {
        write!(to, "a certificate")
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut from: A) -> Result<Certificate, A::Error> {
        let mut certificate = Certificate::default();
        let first: f64 = next(&mut from)?;
        if first == BY_NAME {
            let named: Vec<(Condition, f64)> = next(&mut from)?;
            for (condition, value) in named {
                if !certificate.try_set(condition, value) {
                    return Err(A::Error::custom("a condition of a certificate is damaged"));
                }
            }
        } else {
            certificate.set(RESIDUALS[0], first);
            for condition in &RESIDUALS[1..] {
                certificate.set(*condition, next::<f64, _>(&mut from)?);
            }
            for condition in ANSWERS {
                certificate.set(condition, next::<bool, _>(&mut from)?);
            }
        }
        certificate.energy_slope = next(&mut from)?;
        Ok(certificate)
    }
}

fn next<'de, T: Deserialize<'de>, A: SeqAccess<'de>>(from: &mut A) -> Result<T, A::Error> {
    let torn = || A::Error::custom("a certificate is torn");
    from.next_element()?.ok_or_else(torn)
}

#[cfg(test)]
#[cfg(feature = "wire")]
mod tests {
    use super::*;

    fn bytes(certificate: &Certificate) -> Vec<u8> {
        postcard::to_stdvec(certificate).unwrap()
    }

    /// Goes by wire, bit for bit.
    #[track_caller]
    fn arrives(certificate: &Certificate) {
        let sent = bytes(certificate);
        let again: Certificate = postcard::from_bytes(&sent).unwrap();
        assert_eq!(bytes(&again), sent);
        let values = |of: &Certificate| -> Vec<_> {
            let all = of.conditions();
            all.map(|(it, value)| (it, value.to_bits())).collect()
        };
        assert_eq!(values(&again), values(certificate));
        assert_eq!(again.energy_slope, certificate.energy_slope);
    }

    /// The four-bar robot's.
    fn bare() -> Certificate {
        let mut certificate = Certificate::default();
        for (k, condition) in RESIDUALS.into_iter().enumerate() {
            certificate.set(condition, 0.1 + k as f64);
        }
        certificate.set(Condition::Orientation, true);
        certificate.set(Condition::Minimum, false);
        certificate.energy_slope = 0.3;
        certificate
    }

    #[test]
    fn numbers_and_answers_are_all_that_goes_of_the_known_conditions() {
        let certificate = bare();
        let mut expected = Vec::new();
        for number in [0.1, 1.1, 2.1, 3.1, 4.1] {
            expected.extend(f64::to_le_bytes(number));
        }
        expected.extend([1, 0]);
        expected.extend(f64::to_le_bytes(0.3));
        assert_eq!(bytes(&certificate), expected);
        arrives(&certificate);
    }

    #[test]
    fn any_list_arrives() {
        arrives(&Certificate::default());
        for first in [0.0, f64::NAN, f64::INFINITY, BY_NAME] {
            let mut certificate = bare();
            certificate.set(Condition::Stationarity, first);
            arrives(&certificate);
        }
        let mut certificate = Certificate::default();
        certificate.set(Condition::Minimum, true);
        certificate.set(Condition::Links, 2e-12);
        certificate.energy_slope = -0.2;
        arrives(&certificate);
    }

    #[test]
    fn a_torn_certificate_is_refused() {
        for certificate in [bare(), Certificate::default()] {
            let sent = bytes(&certificate);
            for length in 0..sent.len() {
                let read = postcard::from_bytes::<Certificate>(&sent[..length]);
                assert!(read.is_err(), "{length}");
            }
        }
    }

    #[test]
    fn what_is_neither_met_nor_not_is_refused() {
        for (value, fits) in [(1.0, true), (0.0, true), (0.5, false)] {
            let sent = postcard::to_stdvec(&(BY_NAME, [(Condition::Minimum, value)].to_vec(), 0.0));
            let read = postcard::from_bytes::<Certificate>(&sent.unwrap());
            assert_eq!(read.is_ok(), fits, "{value}");
        }
    }
}
