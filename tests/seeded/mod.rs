//! Random numbers that are the same on every run, for scenes of tests that can
//! be asked to look at many more than they do.

/// How many scenes to look at: `SINEW_SCENES`, or so many.
pub fn scenes(usually: u64) -> u64 {
    let asked = std::env::var("SINEW_SCENES").ok();
    asked.map_or(usually, |count| count.parse().unwrap())
}

/// Random numbers from a seed: SplitMix64 (Steele, Lea and Flood, 2014).
pub struct Random(u64);

impl Random {
    /// The numbers of a seed; those of neighbouring seeds have nothing in common.
    pub fn of(seed: u64) -> Self {
        Self(seed.wrapping_mul(0x2545_f491_4f6c_dd1d))
    }

    /// A number between two.
    pub fn between(&mut self, least: f64, most: f64) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        least + (most - least) * ((z ^ (z >> 31)) >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// One of the numbers from 0 to less than `count`.
    pub fn one_of(&mut self, count: u32) -> u32 {
        self.between(0.0, f64::from(count)) as u32
    }
}
