//! What drives the robot: the one place where it is read and set. Today that is
//! the pull of a single cable.

use super::document::Document;
use super::transport::span_mm;
use super::{Loads, Workbench};
use crate::scene::Scene;
use crate::units::metres;

/// What becomes of playing when the pull is set.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Playing {
    /// It goes on from there.
    GoesOn,
    /// It stops: a hand has taken the robot.
    Stops,
}

/// The pull of a scene, in mm.
pub fn pull_mm_of(scene: &Scene) -> f64 {
    scene.actuation.pull_mm
}

impl Workbench {
    /// The pull, in mm.
    pub fn pull_mm(&self) -> f64 {
        pull_mm_of(&self.document.scene)
    }

    /// Sets the pull, in mm. Where it is beyond what the robot can do, the edit
    /// is taken back like any other.
    pub fn set_pull(&mut self, pull_mm: f64, playing: Playing) {
        if playing == Playing::Stops {
            self.transport.stop();
        }
        self.document.scene.actuation.pull_mm = pull_mm;
    }

    /// Sets the pull, in mm, to the nearest that the slider offers.
    pub fn set_pull_within_span(&mut self, pull_mm: f64, playing: Playing) {
        let (least, most) = self.span_mm();
        self.set_pull(pull_mm.clamp(least, most), playing);
    }

    /// The pulls that the slider covers, in mm.
    pub fn span_mm(&self) -> (f64, f64) {
        span_mm_of(&self.document)
    }

    /// The loads in the place of the pulls; `None` where the stiffness is not
    /// known, or the path not yet.
    pub fn loads(&self) -> Option<Loads> {
        Loads::of(&self.document, &self.live)
    }

    /// Plays on for some seconds, if the robot plays.
    pub fn play_on(&mut self, seconds: f64) {
        let (span, mut pull_mm) = (self.span_mm(), self.pull_mm());
        self.transport.advance(&mut pull_mm, span, seconds);
        self.set_pull(pull_mm, Playing::GoesOn);
    }

    /// Starts to play, or stops.
    pub fn play_or_pause(&mut self) {
        let (span, mut pull_mm) = (self.span_mm(), self.pull_mm());
        self.transport.toggle(&mut pull_mm, span);
        self.set_pull(pull_mm, Playing::GoesOn);
    }
}

/// The pulls that the slider covers, in mm.
fn span_mm_of(document: &Document) -> (f64, f64) {
    let allowed = document.problem().robot().pull_range();
    let scene = &document.scene;
    span_mm(&scene.robot, allowed, pull_mm_of(scene))
}

/// The pulls that the path of a document covers, in metres.
pub(super) fn span(document: &Document) -> (f64, f64) {
    let (least, most) = span_mm_of(document);
    (metres(least), metres(most))
}
