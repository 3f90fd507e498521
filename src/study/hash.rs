//! Bits from bits: seeds of samplers, checks of files. No secrets are kept by these.

/// The finaliser of SplitMix64 (Steele, Lea and Flood, 2014): a bijection of 64 bits in
/// which every bit of the result depends on every one of the input.
pub(super) fn mix(value: u64) -> u64 {
    let mut z = value.wrapping_add(0x9e37_79b9_7f4a_7c15);
    z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ (z >> 31)
}

/// A seed made of another and a number: different for each of either.
pub(super) fn seed(seed: u64, number: u64) -> u64 {
    mix(mix(seed) ^ number)
}

/// A number in [0, 1) of the 53 high bits.
pub(super) fn unit(bits: u64) -> f64 {
    (bits >> 11) as f64 / (1_u64 << 53) as f64
}

/// The hash FNV-1a of 64 bits (Fowler, Noll and Vo) of some bytes.
pub fn checksum(bytes: &[u8]) -> u64 {
    let mix = |hash: u64, byte: &u8| (hash ^ u64::from(*byte)).wrapping_mul(0x0100_0000_01b3);
    bytes.iter().fold(0xcbf2_9ce4_8422_2325, mix)
}

/// FNV-1a of 128 bits, which tells studies apart.
pub(super) fn digest(parts: &[&str]) -> u128 {
    let prime = (1_u128 << 88) | 0x13b;
    let mut hash = 0x6c62_272e_07bb_0142_62b8_2175_6295_c58d_u128;
    for part in parts {
        // The length first, so that no two lists of parts are alike.
        let bytes = (part.len() as u64)
            .to_le_bytes()
            .into_iter()
            .chain(part.bytes());
        for byte in bytes {
            hash = (hash ^ u128::from(byte)).wrapping_mul(prime);
        }
    }
    hash
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn hashes_are_the_published_ones() {
        // SplitMix64 from the state 1234567, by its authors' program.
        assert_eq!(mix(1_234_567), 6_457_827_717_110_365_317);
        assert_eq!(checksum(b""), 0xcbf2_9ce4_8422_2325);
        assert_eq!(checksum(b"foobar"), 0x8594_4171_f739_67e8);
    }

    #[test]
    fn parts_are_told_apart_by_where_they_end() {
        assert_ne!(digest(&["ab", "c"]), digest(&["a", "bc"]));
        assert_ne!(digest(&["abc"]), digest(&["abc", ""]));
    }
}
