//! One segment as a four-bar linkage with one degree of freedom.
//!
//! The bars are the lower disk, the backbone link, the upper disk and the
//! cable link. All link constraints of eq. 4 hold exactly for every turn τ of
//! the shorter link (the cable when it is drawn in), so τ is the only unknown
//! a segment. With d the mean direction of the two disks and m its normal:
//!
//! ```text
//! t = l_s sin τ          both links' component along d
//! q = l_s cos τ          the shorter link's along m
//! c = √(l_g² − t²)       the longer link's along m
//! sin(β/2) = ±(l_g² − l_s²) / (2a (c + q))      + where the cable is shorter
//! ```
//!
//! The last line is (l_0's component − l_a's) / 2a without its cancellation.
//!
//! | symbol | meaning | identifier |
//! |---|---|---|
//! | l_s, l_g | the shorter and the longer link | `shorter`, `longer` |
//! | a | cable offset | `offset` |
//! | τ | turn of the shorter link from m, clockwise | `turn` |
//! | β | bend, the clockwise angle between the disks | [`SegmentShape::bend`] |
//! | β* | bend at τ = 0, the free optimum | [`FourBar::free_bend`] |
//! | ψ | shear, the backbone link's angle from m | [`FourBar::shear`] |
//!
//! Differs from the paper: the cost is (β/β*)² instead of β². The minimiser
//! is the same; the limit of no pull is sec²τ instead of nothing, so that the
//! shape and the forces per pull stay defined at every pull, zero included.

use crate::geometry::Vector;
use crate::math::asinc;

/// The largest turn τ a solution may show, in radians: 0.01 rad before the
/// shorter link lies along the disks, where the linkage would change its
/// assembly.
pub const MOST_TURN: f64 = std::f64::consts::FRAC_PI_2 - 0.01;

/// The largest bend a segment may show, in radians: beyond it neighbouring
/// disks would face each other.
pub const MOST_BEND: f64 = 170.0 / 180.0 * std::f64::consts::PI;

/// A segment's dimensions at one pull, and what follows from them once.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FourBar {
    offset: f64,
    backbone: f64,
    shorter: f64,
    longer: f64,
    /// ±(l_g² − l_s²)/2a, signed like the bend.
    numerator: f64,
    /// (l_g + l_s) · s*/asin(s*), with s* = sin(β*/2).
    normaliser: f64,
    free_bend: f64,
    most_turn: f64,
    cable_is_shorter: bool,
}

/// A segment at one turn: the next node in the disk frame of the one before
/// (d along its disk, m along its normal), each with two derivatives in τ.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SegmentShape {
    /// Displacement along the lower disk and its normal.
    pub step: [Vector; 3],
    /// β.
    pub bend: [f64; 3],
    /// (β/β*)².
    pub cost: [f64; 3],
    /// cos β and sin β.
    pub rotation: Vector,
}

impl FourBar {
    /// A segment of backbone length `backbone` whose cable link is shorter by
    /// `shortening` (longer, where negative), at cable offset `offset`, all
    /// in metres. Needs a shortening within [`FourBar::shortening_range`].
    pub fn new(backbone: f64, shortening: f64, offset: f64) -> Self {
        let cable = backbone - shortening;
        let (shorter, longer) = (backbone.min(cable), backbone.max(cable));
        let free_sine = shortening / (2.0 * offset);
        // The bend grows with |τ|. It reaches MOST_BEND where c + q has fallen
        // to D = (l_g² − l_s²)/(2a sin(MOST_BEND/2)), and then, since c² − q² =
        // l_g² − l_s², at q = (D − (l_g² − l_s²)/D)/2.
        let difference = shortening.abs() * (longer + shorter);
        let least_sum = difference / (2.0 * offset * libm::sin(0.5 * MOST_BEND));
        let least_cosine = if least_sum > 0.0 {
            0.5 * (least_sum - difference / least_sum) / shorter
        } else {
            0.0
        };
        let most_turn = libm::acos(least_cosine.clamp(-1.0, 1.0)).min(MOST_TURN);
        Self {
            offset,
            backbone,
            shorter,
            longer,
            numerator: free_sine * (longer + shorter),
            normaliser: (longer + shorter) / asinc(free_sine),
            free_bend: 2.0 * libm::asin(free_sine),
            most_turn,
            cable_is_shorter: shortening >= 0.0,
        }
    }

    /// The shortenings for which a linkage exists and its free bend stays
    /// within [`MOST_BEND`], ends included.
    pub fn shortening_range(backbone: f64, offset: f64) -> (f64, f64) {
        let most = 2.0 * offset * libm::sin(0.5 * MOST_BEND);
        (-most, most.min(0.98 * backbone))
    }

    /// β*, the bend of the free segment; a circular arc has it everywhere.
    pub fn free_bend(&self) -> f64 {
        self.free_bend
    }

    /// The largest |τ| a solution may show: [`MOST_TURN`], or less where the
    /// bend would reach [`MOST_BEND`] before.
    pub fn most_turn(&self) -> f64 {
        self.most_turn
    }

    /// Length of the backbone link, the paper's l_0.
    pub fn backbone(&self) -> f64 {
        self.backbone
    }

    /// Length of the cable link, the paper's l_a.
    pub fn cable(&self) -> f64 {
        if self.cable_is_shorter {
            self.shorter
        } else {
            self.longer
        }
    }

    /// The cable offset a.
    pub fn offset(&self) -> f64 {
        self.offset
    }

    /// ψ at a turn: the clockwise angle of the backbone link from the normal
    /// of the mean disk direction.
    pub fn shear(&self, turn: f64) -> f64 {
        if self.cable_is_shorter {
            let along = self.shorter * libm::sin(turn);
            libm::atan2(along, (self.longer * self.longer - along * along).sqrt())
        } else {
            turn
        }
    }

    /// The segment at a turn. Not finite where the linkage cannot close.
    pub fn at(&self, turn: f64) -> SegmentShape {
        let (sine, cosine) = libm::sincos(turn);
        let t = self.shorter * sine;
        let q = self.shorter * cosine;
        let c = (self.longer * self.longer - t * t).sqrt();
        // Divisions are the dearest part of a roll-out: one a divisor.
        let (per_c, per_sum) = (1.0 / c, 1.0 / (c + q));
        // r = t/c, with (c + q)′ = −r (c + q).
        let r = t * per_c;
        let r1 = q * per_c * (1.0 + r * r);

        // s = sin(β/2): s′ = r s, s″ = (r² + r′) s.
        let s = self.numerator * per_sum;
        let growth = r * r + r1;
        let half_cosine = (1.0 - s * s).sqrt();
        let per_half_cosine = 1.0 / half_cosine;
        let half = libm::asin(s);
        let half1 = r * s * per_half_cosine;
        let half2 = (growth * s + s * half1 * half1) * per_half_cosine;

        // β/β* and its derivatives, smooth through no pull at all.
        let scaled = self.normaliser * per_sum;
        let ratio = scaled * if s.abs() < 1e-4 { asinc(s) } else { half / s };
        let ratio1 = r * scaled * per_half_cosine;
        let ratio2 = (growth * scaled + s * half1 * ratio1) * per_half_cosine;

        // The backbone link's component along m is the longer link's where
        // the cable is the shorter one.
        let (b, b1, b2) = if self.cable_is_shorter {
            let c1 = -r * q;
            (c, c1, r * t - r1 * q)
        } else {
            (q, -t, -q)
        };
        // (d, m) are turned by −β/2 from the lower disk: rotating by it, with
        // ′ of the rotation = −half1 times a quarter turn.
        let turned = |d: f64, m: f64| Vector::new(d * half_cosine + m * s, m * half_cosine - d * s);
        let step = turned(t, b);
        let rate = turned(q, b1);
        let acceleration = turned(-t, b2);
        let clockwise = |v: Vector| Vector::new(v.y, -v.x);
        let step1 = rate + half1 * clockwise(step);
        let step2 = acceleration + 2.0 * half1 * clockwise(rate) + half2 * clockwise(step)
            - half1 * half1 * step;
        SegmentShape {
            step: [step, step1, step2],
            bend: [2.0 * half, 2.0 * half1, 2.0 * half2],
            cost: [
                ratio * ratio,
                2.0 * ratio * ratio1,
                2.0 * (ratio1 * ratio1 + ratio * ratio2),
            ],
            rotation: Vector::new(1.0 - 2.0 * s * s, 2.0 * s * half_cosine),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn segments() -> Vec<FourBar> {
        vec![
            FourBar::new(0.010, 5e-3 / 18.0, 0.008),
            FourBar::new(0.010, 12e-3 / 18.0, 0.008),
            FourBar::new(0.010, -5e-3 / 18.0, 0.008),
            FourBar::new(0.010, 0.0, 0.008),
            FourBar::new(0.010, 1e-9, 0.008),
            FourBar::new(0.040, 0.015, 0.010),
        ]
    }

    #[test]
    fn all_links_close_at_every_turn() {
        for segment in segments() {
            for i in -15..=15 {
                let turn = 0.1 * f64::from(i);
                let shape = segment.at(turn);
                if !shape.cost[0].is_finite() {
                    continue;
                }
                let step = shape.step[0];
                assert!((step.norm() - segment.backbone()).abs() < 1e-17);
                let (sine, cosine) = libm::sincos(-shape.bend[0]);
                let upper = segment.offset() * Vector::new(cosine, sine);
                let cable = step + upper - Vector::new(segment.offset(), 0.0);
                assert!((cable.norm() - segment.cable()).abs() < 2e-17, "{turn}");
                // The backbone's angle from the mean normal is the shear.
                let mean = -0.5 * shape.bend[0];
                let angle = libm::atan2(step.x, step.y) + mean;
                assert!((angle - segment.shear(turn)).abs() < 1e-14);
            }
        }
    }

    /// Complex steps need analytic code; central differences of step 1e-5 err
    /// by 1e-10 of the third derivative and 1e-16/1e-5 of rounding.
    #[test]
    fn derivatives_against_finite_differences() {
        let h = 1e-5;
        for segment in segments() {
            for i in -12..=12 {
                let turn = 0.1 * f64::from(i);
                let (before, here, after) =
                    (segment.at(turn - h), segment.at(turn), segment.at(turn + h));
                if !after.cost[0].is_finite() || !before.cost[0].is_finite() {
                    continue;
                }
                for order in 0..2 {
                    let check = |a: f64, b: f64, exact: f64, what: &str| {
                        let difference = (a - b) / (2.0 * h);
                        assert!(
                            (difference - exact).abs() < 2e-8 * (1.0 + exact.abs()),
                            "{what} order {order} at {turn}: {difference} {exact}"
                        );
                    };
                    check(
                        after.bend[order],
                        before.bend[order],
                        here.bend[order + 1],
                        "bend",
                    );
                    check(
                        after.cost[order],
                        before.cost[order],
                        here.cost[order + 1],
                        "cost",
                    );
                    for axis in 0..2 {
                        check(
                            after.step[order][axis],
                            before.step[order][axis],
                            here.step[order + 1][axis],
                            "step",
                        );
                    }
                }
            }
        }
    }

    #[test]
    fn the_most_turn_bends_at_most_to_the_limit() {
        for segment in segments() {
            let [bend, ..] = segment.at(segment.most_turn()).bend;
            assert!(bend.abs() <= MOST_BEND + 1e-12);
            if segment.most_turn() < MOST_TURN {
                assert!((bend.abs() - MOST_BEND).abs() < 1e-9);
            }
        }
        let short = FourBar::new(0.040, 0.015, 0.010);
        assert!(short.most_turn() < 1.4, "{}", short.most_turn());
    }

    #[test]
    fn no_turn_is_the_least_cost_and_costs_one() {
        for segment in segments() {
            let [cost, slope, curvature] = segment.at(0.0).cost;
            assert!((cost - 1.0).abs() < 1e-15 && slope == 0.0 && curvature > 0.0);
            assert!((segment.at(0.0).bend[0] - segment.free_bend()).abs() < 1e-17);
        }
    }

    #[test]
    fn without_pull_the_cost_is_the_squared_secant() {
        let segment = FourBar::new(0.010, 0.0, 0.008);
        for turn in [-1.2, -0.3, 0.0, 0.7] {
            let [cost, slope, _] = segment.at(turn).cost;
            let secant = 1.0 / f64::cos(turn);
            assert!((cost - secant * secant).abs() < 1e-13);
            assert!((slope - 2.0 * secant * secant * libm::tan(turn)).abs() < 1e-13);
        }
    }
}
