//! A circular arc of the backbone as a function of its bend, smooth through a
//! straight one.

/// The step along an arc of unit length, in the frame of the disk it starts from, with
/// two derivatives in its bend b, in radians, clockwise:
///
/// ```text
/// across = (1 − cos b)/b      towards the cable's side
/// along  = sin b / b          along the backbone
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Arc {
    /// The component along the disk, and its derivatives.
    pub across: [f64; 3],
    /// The component along the disk's normal, and its derivatives.
    pub along: [f64; 3],
    /// cos b and sin b.
    pub rotation: (f64, f64),
}

/// Bends below this, in radians, are taken by series: there the closed forms of the
/// second derivatives lose more than a digit.
const SMALL: f64 = 0.5;
/// (−1)^k/(2k+1)!, of sin(b)/b in b². The first term left out is 1e-20 at [`SMALL`].
const ALONG: [f64; 8] = coefficients(1);
/// (−1)^k/(2k+2)!, of (1 − cos b)/b² in b².
const ACROSS: [f64; 8] = coefficients(2);

/// (−1)^k/(2k + first)!.
const fn coefficients(first: usize) -> [f64; 8] {
    let mut all = [0.0; 8];
    let mut factorial = if first == 2 { 2.0 } else { 1.0 };
    let mut sign = 1.0;
    let mut k = 0;
    while k < 8 {
        all[k] = sign / factorial;
        let next = 2 * k + first;
        factorial *= ((next + 1) * (next + 2)) as f64;
        sign = -sign;
        k += 1;
    }
    all
}

/// A polynomial with its first two derivatives.
fn series(coefficients: &[f64; 8], x: f64) -> [f64; 3] {
    let (mut value, mut slope, mut half) = (0.0, 0.0, 0.0);
    for coefficient in coefficients.iter().rev() {
        half = half * x + slope;
        slope = slope * x + value;
        value = value * x + coefficient;
    }
    [value, slope, 2.0 * half]
}

impl Arc {
    /// The arc of a bend within ±2π, in radians.
    pub fn of(bend: f64) -> Self {
        if bend.abs() < SMALL {
            let x = bend * bend;
            let [h, slope, curvature] = series(&ALONG, x);
            let [g, rise, bow] = series(&ACROSS, x);
            return Self {
                across: [
                    bend * g,
                    g + 2.0 * x * rise,
                    bend * (6.0 * rise + 4.0 * x * bow),
                ],
                along: [h, 2.0 * bend * slope, 2.0 * slope + 4.0 * x * curvature],
                rotation: (1.0 - x * g, bend * h),
            };
        }
        let (sine, cosine) = libm::sincos(bend);
        let along = sine / bend;
        let across = (1.0 - cosine) / bend;
        let (along_rate, across_rate) = ((cosine - along) / bend, (sine - across) / bend);
        Self {
            across: [across, across_rate, (cosine - 2.0 * across_rate) / bend],
            along: [along, along_rate, -(sine + 2.0 * along_rate) / bend],
            rotation: (cosine, sine),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A closed form, the sum rule at a half turn, and derivatives by differences that
    /// err by h²/6 of the third derivative, on both sides of the seam.
    #[test]
    fn arcs_have_known_chords_and_exact_derivatives() {
        let straight = Arc::of(0.0);
        assert_eq!((straight.across[0], straight.along[0]), (0.0, 1.0));
        let half = Arc::of(std::f64::consts::PI);
        assert!((half.across[0] - 2.0 / std::f64::consts::PI).abs() < 1e-16);
        assert!(half.along[0].abs() < 1e-16);
        let h = 1e-4;
        for bend in [0.0, 1e-9, 0.03, -0.2, 0.4999, 0.5001, -1.3, 2.5] {
            let [before, here, after] = [bend - h, bend, bend + h].map(Arc::of);
            let (cosine, sine) = here.rotation;
            assert!((cosine - libm::cos(bend)).abs() < 2e-16);
            assert!((sine - libm::sin(bend)).abs() < 2e-16);
            for part in [|arc: &Arc| arc.across, |arc: &Arc| arc.along] {
                let [low, mid, high] = [&before, &here, &after].map(part);
                let slope = (high[0] - low[0]) / (2.0 * h);
                let curvature = (high[1] - low[1]) / (2.0 * h);
                assert!((slope - mid[1]).abs() < 2e-9, "{bend}: {slope}");
                assert!((curvature - mid[2]).abs() < 2e-9, "{bend}: {curvature}");
            }
        }
        let (below, above) = (Arc::of(SMALL - 1e-15), Arc::of(SMALL));
        for (a, b) in [(below.across, above.across), (below.along, above.along)] {
            assert!(a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-14));
        }
    }
}
