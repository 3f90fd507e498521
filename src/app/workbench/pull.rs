//! What drives the robot: the one place where it is read and set. Each cable is
//! held by its pull or, where cables slide and the stiffness is known, by its load;
//! the other of the two is what the solver finds. In the paper's model a load is only
//! another way to set the pull.

use super::document::Document;
use super::live::Live;
use super::transport::span_mm;
use super::{Loads, Workbench};
use crate::equilibrium::Status;
use crate::mechanics::{CableState, Input, Model};
use crate::scene::{Drive, Scene};
use crate::units::{grams, metres, millimetres};

/// What becomes of playing when the pull is set.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Playing {
    /// It goes on from there.
    GoesOn,
    /// It stops: a hand has taken the robot.
    Stops,
}

/// Which quantity of a cable is set, the other one being found.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Held {
    /// The length drawn in.
    Pull,
    /// The load that hangs on it.
    Load,
}

impl Workbench {
    /// The cable that slider and field are of, from 0.
    pub fn cable(&self) -> usize {
        let count = self.document.scene.cable_count();
        self.transport.cable.min(count.saturating_sub(1))
    }

    /// What of a cable is set.
    pub fn held(&self, cable: usize) -> Held {
        match (self.model(), self.document.scene.cable(cable).drive) {
            (Model::Sliding, Drive::LoadG(_)) => Held::Load,
            (Model::Sliding, Drive::PullMm(_)) => Held::Pull,
            // Beside it in the window, and only as long as it amounts to a pull.
            (Model::Equal, _) if self.transport.by_load && self.loads().is_some() => Held::Load,
            (Model::Equal, _) => Held::Pull,
        }
    }

    /// Sets the other quantity of a cable from now on, with the value that it has. Not
    /// where that is not known.
    pub fn hold(&mut self, cable: usize, held: Held) {
        if self.model() == Model::Equal {
            self.transport.by_load = held == Held::Load;
            return;
        }
        if held == self.held(cable) {
            return;
        }
        let drive = match held {
            Held::Pull => Drive::PullMm(rounded(self.pull_mm_of(cable), PULL_GRAIN_MM)),
            Held::Load => match self.load_g(cable) {
                Some(load_g) => Drive::LoadG(rounded(load_g, LOAD_GRAIN_G)),
                None => return,
            },
        };
        self.document.scene.set_drive(cable, drive);
    }

    /// How the cables of the last sound scene lie along the robot.
    pub fn model(&self) -> Model {
        self.document.problem().model()
    }

    /// What was found of a cable, if anything.
    pub fn found(&self, cable: usize) -> Option<CableState> {
        found(&self.live, cable)
    }

    /// The pull of the first cable, in mm: set or found.
    pub fn pull_mm(&self) -> f64 {
        self.pull_mm_of(0)
    }

    /// The pull of a cable, in mm: set or found.
    pub fn pull_mm_of(&self, cable: usize) -> f64 {
        pull_mm_in(&self.document.scene, &self.live, cable)
    }

    /// The load on a cable, in g, at least 0: set or found. `None` where the stiffness
    /// is not known, or nothing is found.
    pub fn load_g(&self, cable: usize) -> Option<f64> {
        if self.model() == Model::Equal {
            return Some(self.loads()?.load_g(self.pull_mm()));
        }
        match self.document.scene.cable(cable).drive {
            Drive::LoadG(load_g) => Some(load_g),
            Drive::PullMm(_) => {
                let newtons = self.document.newtons_per_multiplier()?;
                Some(grams(newtons * self.found(cable)?.load).max(0.0))
            }
        }
    }

    /// What a cable was brought to of what is held of it, in mm or g, where the robot
    /// gets no farther; `None` where it got there, or is on its way.
    pub fn reached(&self, cable: usize) -> Option<f64> {
        let live = &self.live;
        let solution = live.solution().filter(|_| !live.is_waiting())?;
        if solution.status == Status::Unfinished || solution.nodes.is_empty() {
            return None;
        }
        let now = solution.drive.cables.get(cable)?.input;
        let (asked, reached, grain) = match (self.document.scene.cable(cable).drive, now) {
            (Drive::PullMm(asked), Input::Pull(now)) => (asked, millimetres(now), SHOWN_MM),
            (Drive::LoadG(asked), Input::Load(now)) => (asked, grams(now), SHOWN_G),
            _ => return None,
        };
        ((asked - reached).abs() > grain).then_some(reached)
    }

    /// Sets the pull of the first cable, in mm. What is held stays held: where it is
    /// the load, the one that this pull amounts to along the path is set, if that is
    /// known. A pull beyond what the robot can do is taken back like any other edit.
    pub fn set_pull(&mut self, pull_mm: f64, playing: Playing) {
        if playing == Playing::Stops {
            self.transport.stop();
        }
        if self.model() == Model::Equal || self.held(0) == Held::Pull {
            self.document.scene.set_pull_mm(pull_mm);
        } else if let Some(loads) = self.loads() {
            let load_g = rounded(loads.load_g(pull_mm).max(0.0), LOAD_GRAIN_G);
            self.document.scene.set_drive(0, Drive::LoadG(load_g));
        }
    }

    /// Sets the pull of a cable, in mm, as what is held.
    pub fn set_pull_of(&mut self, cable: usize, pull_mm: f64) {
        let drive = Drive::PullMm(pull_mm);
        self.document.scene.set_drive(cable, drive);
    }

    /// Brings the cable that is set to a pull on its path, in mm. What is held of it
    /// stays held.
    pub fn go_along(&mut self, pull_mm: f64) {
        let cable = self.cable();
        match (cable, self.held(cable)) {
            (0, _) => self.set_pull(pull_mm, Playing::GoesOn),
            (_, Held::Pull) => self.set_pull_of(cable, pull_mm),
            (_, Held::Load) => {
                if let Some(loads) = self.loads_along() {
                    let load_g = rounded(loads.load_g(pull_mm).max(0.0), LOAD_GRAIN_G);
                    self.set_load(cable, load_g);
                }
            }
        }
    }

    /// Sets the load on a cable, in g.
    pub fn set_load(&mut self, cable: usize, load_g: f64) {
        match self.model() {
            Model::Sliding => {
                let drive = Drive::LoadG(load_g.max(0.0));
                self.document.scene.set_drive(cable, drive);
            }
            Model::Equal => {
                if let Some(loads) = self.loads() {
                    self.document.scene.set_pull_mm(loads.pull_mm(load_g));
                }
            }
        }
    }

    /// Sets the pull, in mm, to the nearest that the slider offers.
    pub fn set_pull_within_span(&mut self, pull_mm: f64, playing: Playing) {
        let (least, most) = self.span_mm();
        self.set_pull(pull_mm.clamp(least, most), playing);
    }

    /// The pulls that the first cable's slider covers, in mm.
    pub fn span_mm(&self) -> (f64, f64) {
        self.span_mm_of(0)
    }

    /// The pulls that a cable's slider covers, in mm.
    pub fn span_mm_of(&self, cable: usize) -> (f64, f64) {
        span_mm_at(&self.document, cable, self.pull_mm_of(cable))
    }

    /// The greatest load that a cable's slider offers, in g; `None` where the
    /// stiffness is not known. Of the first cable it is the path's; of another the
    /// one that bends the free robot to the end of the pulls.
    pub fn most_g(&self, cable: usize) -> Option<f64> {
        let most = match self.loads().filter(|_| cable == 0) {
            Some(loads) => loads.most_g(),
            None => {
                let stiffness = self.document.stiffness()?.value();
                let offset = metres(self.document.scene.cable(cable).offset_mm);
                let length = self.document.problem().length();
                let pull = metres(self.span_mm_of(cable).1);
                grams(stiffness * pull / (offset * offset * length))
            }
        };
        Some(match self.document.scene.cable(cable).drive {
            Drive::LoadG(load_g) => most.max(load_g),
            Drive::PullMm(_) => most,
        })
    }

    /// The loads in the place of the pulls of the first cable; `None` where the
    /// stiffness is not known, or the path not yet.
    pub fn loads(&self) -> Option<Loads> {
        Loads::of(&self.document, &self.live)
    }

    /// Plays on for some seconds, if the robot plays.
    pub fn play_on(&mut self, seconds: f64) {
        if self.transport.is_playing() {
            self.play(|transport, value, span, speed| {
                transport.advance(value, span, speed, seconds);
            });
        }
    }

    /// Starts to play, or stops.
    pub fn play_or_pause(&mut self) {
        self.play(|transport, value, span, _| transport.toggle(value, span));
    }

    /// Moves what is held of the cable at hand: a pull over its span, a load up to the
    /// last mark of its path.
    fn play(&mut self, step: impl FnOnce(&mut super::Transport, &mut f64, (f64, f64), f64)) {
        let cable = self.cable();
        match self.held(cable) {
            Held::Load => {
                let (Some(most_g), Some(load_g)) = (self.last_mark_g(), self.load_g(cable)) else {
                    return;
                };
                let mut moved_g = load_g;
                let speed = self.transport.speed_g;
                let span = (0.0, most_g.max(load_g));
                step(&mut self.transport, &mut moved_g, span, speed);
                if moved_g != load_g {
                    self.set_load(cable, moved_g);
                }
            }
            Held::Pull => {
                let mut pull_mm = self.pull_mm_of(cable);
                let (span, speed) = (self.span_mm_of(cable), self.transport.speed_mm);
                step(&mut self.transport, &mut pull_mm, span, speed);
                self.set_pull_of(cable, pull_mm);
            }
        }
    }

    /// The load of the last mark of the path of the cable at hand, in g; where nothing
    /// happens on it, or farther than the slider goes, the slider's greatest.
    fn last_mark_g(&self) -> Option<f64> {
        let most_g = self.most_g(self.cable()).filter(|most_g| *most_g > 0.0)?;
        let marks = self.path_along().zip(self.loads_along());
        let last = marks.and_then(|((path, _), loads)| {
            let marks = path.events.iter().map(|event| millimetres(event.pull));
            let loads = marks.map(|pull_mm| loads.load_g(pull_mm));
            loads.filter(|load_g| *load_g > 0.0).reduce(f64::max)
        });
        Some(last.map_or(most_g, |last| last.min(most_g)))
    }
}

/// What was reached is told where it is so far from what was asked, in mm and in g: as
/// far as what is shown of them.
const SHOWN_MM: f64 = 0.005;
const SHOWN_G: f64 = 0.05;

/// A pull that was found is set to this, in mm, and a load to that, in g: far below
/// what moves a pixel.
const PULL_GRAIN_MM: f64 = 1e-4;
const LOAD_GRAIN_G: f64 = 1e-3;

/// The multiple of a grain that is nearest, without the digits that a product adds.
fn rounded(value: f64, grain: f64) -> f64 {
    let per_unit = (1.0 / grain).round();
    (value * per_unit).round() / per_unit
}

fn found(live: &Live, cable: usize) -> Option<CableState> {
    live.solution()?.cables.get(cable).copied()
}

/// The pull of a cable, in mm: set or found.
fn pull_mm_in(scene: &Scene, live: &Live, cable: usize) -> f64 {
    match scene.cable(cable).drive {
        Drive::PullMm(pull_mm) => pull_mm,
        Drive::LoadG(_) => found(live, cable).map_or(0.0, |state| millimetres(state.pull)),
    }
}

/// The pulls that a cable's slider covers, in mm, at a pull: to either side where there
/// are antagonists.
fn span_mm_at(document: &Document, cable: usize, pull_mm: f64) -> (f64, f64) {
    let scene = &document.scene;
    let allowed = document.problem().pull_range();
    let offset_mm = scene.cable(cable).offset_mm.abs();
    let (least, most) = span_mm(offset_mm, allowed, pull_mm);
    match scene.cable_count() {
        0 | 1 => (least, most),
        _ => (least.min(-most), most),
    }
}

/// The pulls that the path of a document covers, in metres. A pull that is found is
/// not among what they depend on: the path is not to be followed anew for each.
pub(super) fn span(document: &Document) -> (f64, f64) {
    let (least, most) = span_mm_at(document, 0, document.scene.pull_mm());
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
    fn a_load_along_the_path_is_what_hangs_on_the_cable_with_friction_too() {
        let text = include_str!("../../../assets/scenes/two-posts.toml");
        let mut scene = Scene::from_toml(text).unwrap();
        scene.friction.holes = 0.275;
        scene.friction.base_loss = 0.165;
        let mut bench = Workbench::with(scene);
        bench.poll();
        bench.poll();
        let along = bench.loads().unwrap().load_g(bench.pull_mm());
        let now = bench.load_g(0).unwrap();
        assert!((along - now).abs() < 1e-3 * now, "{along} {now}");
    }

    #[test]
    fn a_load_is_played_in_grams_and_stops_at_the_last_mark() {
        let text = include_str!("../../../assets/scenes/two-posts.toml");
        let mut scene = Scene::from_toml(text).unwrap();
        scene.set_drive(0, Drive::LoadG(100.0));
        let mut bench = Workbench::with(scene);
        bench.poll();
        let last = bench.last_mark_g().unwrap();
        assert!(last > 200.0 && last <= bench.most_g(0).unwrap(), "{last}");
        bench.transport.looping = false;
        bench.play_or_pause();
        bench.play_on(0.1);
        assert!((bench.load_g(0).unwrap() - 105.0).abs() < 1e-9);
        for _ in 0..1000 {
            bench.play_on(0.1);
        }
        assert!(!bench.transport.is_playing());
        assert!((bench.load_g(0).unwrap() - last).abs() < 1e-6 * last);
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
