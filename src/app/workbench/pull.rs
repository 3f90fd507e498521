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
    scene.pull_mm()
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
        self.document.scene.set_pull_mm(pull_mm);
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
    span_mm(scene.offset_mm(), allowed, pull_mm_of(scene))
}

/// The pulls that the path of a document covers, in metres.
pub(super) fn span(document: &Document) -> (f64, f64) {
    let (least, most) = span_mm_of(document);
    (metres(least), metres(most))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_hand_on_the_robot_stops_playing_and_one_on_the_slider_does_not() {
        let mut bench = Workbench::with(Scene::default());
        bench.play_or_pause();
        bench.set_pull(3.0, Playing::GoesOn);
        bench.play_on(0.1);
        assert!((bench.pull_mm() - 3.2).abs() < 1e-12);
        bench.set_pull(4.0, Playing::Stops);
        bench.play_on(0.1);
        assert_eq!(bench.pull_mm(), 4.0);
    }

    #[test]
    fn a_pull_beyond_the_span_becomes_its_end() {
        let mut bench = Workbench::with(Scene::default());
        bench.set_pull(1.0, Playing::Stops);
        let (least, most) = bench.span_mm();
        bench.set_pull_within_span(1e3, Playing::Stops);
        assert_eq!(bench.pull_mm(), most);
        bench.set_pull(1.0, Playing::Stops);
        bench.set_pull_within_span(-1e3, Playing::Stops);
        assert_eq!(bench.pull_mm(), least);
    }
}
