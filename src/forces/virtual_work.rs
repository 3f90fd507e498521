//! The paper's estimate of the contact force from kinematics and virtual work
//! (eq. 6 to 11).
//!
//! With x, y and θ of the touching node as functions of the pull l (eq. 6) and
//! f′ the slopes of straight lines through them,
//!
//! ```text
//! P_x f′_x + P_y f′_y + M_e f′_θ = 0      M_e = a P_l       (10)
//! P_y = μ P_x
//! P_x = −a P_l f′_θ / (μ f′_y + f′_x)                       (11)
//! ```
//!
//! P is what the robot exerts on the obstacle, θ is counterclockwise and P_l
//! counts from the moment of contact. As the cable is drawn in, f′_x > 0,
//! f′_y < 0 and f′_θ < 0: P_x is positive, towards the cable's side, and a tip
//! that slides down drags the obstacle along, so that friction makes μ
//! negative. The paper states neither sign.
//!
//! What it assumes: contact at the tip, motion that is linear in the pull, and
//! the same slopes in contact as in the free robot, hence a force that does not
//! depend on where the obstacle stands. [`VirtualWork::caveats`] says which of
//! this does not hold. And since μ is found from a measured force, the f′ drop
//! out of every later estimate: P_x is then the measured point scaled by the
//! load. μ is what makes the kinematics agree with that point, whatever the
//! cause, and need not be a coefficient of friction.

use super::line_fit::{FitError, LineFit};
use super::sweep::Sweep;
use super::told;
use crate::units::{grams, millimetres};

/// A range of pulls, in metres, both ends included.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Window {
    /// The least pull, in metres.
    pub first: f64,
    /// The greatest pull, in metres.
    pub last: f64,
}

/// How a node moves with the pull: eq. 7's f′, with the lines they come from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rates {
    /// x over the pull; its slope, f′_x, is a pure number.
    pub x: LineFit,
    /// y over the pull, likewise.
    pub y: LineFit,
    /// φ over the pull; its slope, f′_θ, is in rad/m.
    pub angle: LineFit,
    /// The pulls the lines were fitted on.
    pub window: Window,
    /// The node.
    pub node: usize,
    /// At which of the pulls something pressed.
    pub touch: Touch,
}

/// At which pulls of a window the robot pressed on something.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Touch {
    /// At none: the slopes are the free robot's.
    Never,
    /// At some: contact begins or ends inside the window.
    Sometimes,
    /// At all.
    Always,
}

/// A force on an obstacle, in N, by components.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PressingForce {
    /// P_x, in N, towards the cable's side of the straight robot.
    pub x: f64,
    /// P_y = μ P_x, in N, along the straight robot.
    pub y: f64,
}

/// The estimator: a cable offset, the rates of a node, and μ.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct VirtualWork {
    offset: f64,
    rates: Rates,
    friction: f64,
}

/// Why there is no estimate.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum VirtualWorkError {
    /// The window holds too few pulls for a line.
    #[error(
        "the window from {:.3} to {:.3} mm of pull: {fit}; widen it or sweep in smaller steps",
        millimetres(window.first),
        millimetres(window.last)
    )]
    Window {
        /// The window.
        window: Window,
        /// What is wrong with it.
        fit: FitError,
    },
    /// The force is not determined.
    #[error(
        "with mu = {friction} the node does not move along the force (mu f'_y + f'_x is zero), so \
         that virtual work says nothing about it; choose another mu or window"
    )]
    NoWork {
        /// The μ asked for.
        friction: f64,
    },
    /// The node does not move along y, so that μ cannot be found.
    #[error("the node does not move along y on this window, so that no mu fits a measured force")]
    NoSlide,
    /// The measured point is no point to calibrate on.
    #[error(
        "a load of {} g with a force of {} g cannot calibrate mu; both have to be positive",
        told(grams(*.load)),
        told(grams(*.force))
    )]
    NotMeasured {
        /// The load, in N.
        load: f64,
        /// The measured force, in N.
        force: f64,
    },
    /// A load is not a positive number.
    #[error("a load of {} g gives no contact force; loads count from contact and are positive", told(grams(*.0)))]
    NoLoad(f64),
}

/// Where an estimate is outside what it was derived for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Caveat {
    /// The node is not the tip.
    NotAtTip {
        /// The node.
        node: usize,
        /// The tip.
        tip: usize,
    },
    /// A line misses a coordinate by much.
    Curved {
        /// Which coordinate: x, y or slope.
        coordinate: &'static str,
        /// R² of its line.
        r_squared: f64,
        /// Its greatest residual over its range on the line.
        share: f64,
    },
    /// Contact begins or ends inside the window.
    MeetsContact,
    /// μ is no likely coefficient of friction.
    Friction(f64),
    /// The slopes were taken from a robot that touches: they depend on where.
    SiteDependent,
}

/// A pull this near to the end of a window, over the window's reach, is inside:
/// pulls are often computed as shares of the ends, and rounded.
const GRAIN: f64 = 1e-9;
/// Work below this, over the larger of its two parts, is none: they cancel, and
/// what is left of slopes that are known to nine digits means nothing.
const NO_WORK: f64 = 1e-9;

impl Rates {
    /// Lines through the points of a sweep whose pulls lie in a window.
    ///
    /// # Errors
    /// If the window holds too few different pulls.
    pub fn fit(sweep: &Sweep, window: Window) -> Result<Self, VirtualWorkError> {
        let grain = GRAIN * window.first.abs().max(window.last.abs());
        let inside = |pull: f64| (window.first - grain..=window.last + grain).contains(&pull);
        let within: Vec<_> = sweep.points.iter().filter(|p| inside(p.pull)).collect();
        let line = |of: fn(&super::SweepPoint) -> f64| {
            let points: Vec<_> = within.iter().map(|p| (p.pull, of(p))).collect();
            LineFit::through(&points).map_err(|fit| VirtualWorkError::Window { window, fit })
        };
        let touching = within.iter().filter(|p| p.pressing > 0).count();
        Ok(Self {
            x: line(|p| p.x)?,
            y: line(|p| p.y)?,
            angle: line(|p| p.angle)?,
            window,
            node: sweep.node,
            touch: match touching {
                0 => Touch::Never,
                all if all == within.len() => Touch::Always,
                _ => Touch::Sometimes,
            },
        })
    }
}

impl VirtualWork {
    /// A line whose greatest residual is more than this share of what it spans
    /// is no longer straight: 5 % is what the paper's Fig. 7 would show to the
    /// eye.
    pub const STRAIGHT: f64 = 0.05;

    /// The estimator with a cable offset, in metres, the rates of a node, and
    /// a given μ.
    ///
    /// # Errors
    /// If μ f′_y + f′_x is zero.
    pub fn new(offset: f64, rates: Rates, friction: f64) -> Result<Self, VirtualWorkError> {
        let estimator = Self {
            offset,
            rates,
            friction,
        };
        let work = estimator.work();
        let largest = rates.x.slope.abs().max((friction * rates.y.slope).abs());
        if work.is_finite() && work.abs() > NO_WORK * largest {
            Ok(estimator)
        } else {
            Err(VirtualWorkError::NoWork { friction })
        }
    }

    /// The estimator whose μ makes the force at one measured load come out as
    /// measured: eq. 11 solved for μ. Both in N.
    ///
    /// # Errors
    /// If either is not positive, or the node does not move along y.
    pub fn calibrated(
        offset: f64,
        rates: Rates,
        load: f64,
        force: f64,
    ) -> Result<Self, VirtualWorkError> {
        if !(load > 0.0 && force > 0.0 && load.is_finite() && force.is_finite()) {
            return Err(VirtualWorkError::NotMeasured { load, force });
        }
        let work = -offset * load * rates.angle.slope / force;
        let friction = (work - rates.x.slope) / rates.y.slope;
        if !friction.is_finite() {
            return Err(VirtualWorkError::NoSlide);
        }
        Self::new(offset, rates, friction)
    }

    /// μ = P_y / P_x.
    pub fn friction(&self) -> f64 {
        self.friction
    }

    /// The rates it works with.
    pub fn rates(&self) -> &Rates {
        &self.rates
    }

    /// μ f′_y + f′_x, the denominator of eq. 11: how far the force's line of
    /// action is travelled per pull.
    pub fn work(&self) -> f64 {
        self.friction * self.rates.y.slope + self.rates.x.slope
    }

    /// P_x per load: the same at every load.
    pub fn force_per_load(&self) -> f64 {
        -self.offset * self.rates.angle.slope / self.work()
    }

    /// P_x and P_y for a load counted from contact, in N (eq. 11).
    ///
    /// # Errors
    /// If the load is not positive.
    pub fn force(&self, load: f64) -> Result<PressingForce, VirtualWorkError> {
        if !(load > 0.0 && load.is_finite()) {
            return Err(VirtualWorkError::NoLoad(load));
        }
        let x = load * self.force_per_load();
        Ok(PressingForce {
            x,
            y: self.friction * x,
        })
    }

    /// Where this estimate is outside its assumptions; `tip` is the robot's
    /// last node.
    pub fn caveats(&self, tip: usize) -> Vec<Caveat> {
        let rates = &self.rates;
        let mut found = Vec::new();
        if rates.node != tip {
            let node = rates.node;
            found.push(Caveat::NotAtTip { node, tip });
        }
        let width = rates.window.last - rates.window.first;
        for (coordinate, line) in [("x", &rates.x), ("y", &rates.y), ("slope", &rates.angle)] {
            let span = (line.slope * width).abs();
            let share = line.max_residual / span.max(f64::MIN_POSITIVE);
            if share > Self::STRAIGHT {
                found.push(Caveat::Curved {
                    coordinate,
                    r_squared: line.r_squared,
                    share,
                });
            }
        }
        match rates.touch {
            Touch::Never => {}
            Touch::Sometimes => found.push(Caveat::MeetsContact),
            Touch::Always => found.push(Caveat::SiteDependent),
        }
        // Dry plastics slide at 0.1 to 0.6.
        if self.friction.abs() > 0.6 {
            found.push(Caveat::Friction(self.friction));
        }
        found
    }
}

impl std::fmt::Display for Caveat {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Caveat::NotAtTip { node, tip } => write!(
                f,
                "Eq. 8 to 11 were derived for contact at the tip (node {tip}), not at node {node}"
            ),
            Caveat::Curved {
                coordinate,
                r_squared,
                share,
            } => write!(
                f,
                "{coordinate} is not linear on this window: R² is {r_squared:.4}, and the line \
                 misses by up to {:.0} % of what it spans",
                100.0 * share
            ),
            Caveat::MeetsContact => write!(
                f,
                "Contact begins or ends inside the window, so that the lines mix two motions"
            ),
            Caveat::Friction(friction) => write!(
                f,
                "|μ| = {:.3} is a calibration factor: dry plastics slide with 0.1 to 0.6",
                friction.abs()
            ),
            Caveat::SiteDependent => write!(
                f,
                "The slopes are those of a robot that touches, and hold for this obstacle only"
            ),
        }
    }
}
