//! Robots that were pinned: shapes as they were found, with what they did along their
//! pull, to be compared with the live one. They are no part of the scene.

use super::{Notice, Workbench};
use crate::app::look::Tokens;
use crate::equilibrium::Solved;
use crate::explore::Path;
use crate::units::{degrees, grams, millimetres};
use crate::view::Quantity;
use eframe::egui::Color32;
use std::sync::Arc;

/// A pinned robot.
#[derive(Clone, Debug)]
pub struct Pin {
    /// The letter that it is called by.
    pub letter: char,
    /// Its shape.
    pub solved: Solved,
    /// What it did along the pull of its first cable, where that was known.
    pub path: Option<Arc<Path>>,
    /// What a multiplier of 1 rad²/m was, in newtons, where its stiffness was known.
    pub newtons: Option<f64>,
}

/// The pinned robots, by letter.
#[derive(Clone, Debug, Default)]
pub struct Pins {
    pins: Vec<Pin>,
}

/// A robot's shape, and what a multiplier of 1 rad²/m is of it, in newtons.
#[derive(Clone, Copy)]
pub struct Compared<'a> {
    solved: &'a Solved,
    newtons: Option<f64>,
}

/// What is compared of two robots: its name with its unit, its value and decimals.
pub type Measure = (&'static str, fn(Compared<'_>) -> Option<f64>, usize);

/// The letters that there are.
const LETTERS: [char; 4] = ['A', 'B', 'C', 'D'];

impl Pins {
    /// The pinned robots.
    pub fn all(&self) -> &[Pin] {
        &self.pins
    }

    /// Whether another one can be pinned.
    pub fn have_room(&self) -> bool {
        self.pins.len() < LETTERS.len()
    }

    /// Lets one go.
    pub fn remove(&mut self, letter: char) {
        self.pins.retain(|pin| pin.letter != letter);
    }

    /// Lets all go.
    pub fn clear(&mut self) {
        self.pins.clear();
    }
}

impl Pin {
    /// What pinned robots are compared by: name, value and decimals.
    pub const MEASURES: [Measure; 6] = [
        ("Pull, mm", |one| Some(millimetres(one.solved.pull)), 2),
        ("Load P, g", |one| one.weight(one.solved.load()), 1),
        (
            "Tip x, mm",
            |one| Some(millimetres(one.solved.tip().position.x)),
            2,
        ),
        (
            "Tip y, mm",
            |one| Some(millimetres(one.solved.tip().position.y)),
            2,
        ),
        (
            "Bend, °",
            |one| Some(degrees(one.solved.bends.iter().sum())),
            1,
        ),
        ("Forces F, g", |one| one.weight(one.solved.pressed()), 1),
    ];

    /// Its colour: one of those that tell robots beside the live one.
    pub fn ink(&self, tokens: &Tokens) -> Color32 {
        let place = LETTERS.iter().position(|letter| *letter == self.letter);
        place.map_or(tokens.muted, |place| tokens.ghosts[place])
    }

    /// What the live robot has more of than this one, as it is written; nothing where
    /// it is not known of both.
    pub fn difference(&self, live: Compared<'_>, (_, of, decimals): Measure) -> Option<String> {
        let own = Compared {
            solved: &self.solved,
            newtons: self.newtons,
        };
        let more = of(live)? - of(own)?;
        let digits = Quantity::fixed(more, decimals, "").digits;
        let is_more = digits.starts_with(|first: char| first.is_ascii_digit());
        let is_nothing = digits.chars().all(|digit| matches!(digit, '0' | '.'));
        Some(match is_more && !is_nothing {
            true => format!("+{digits}"),
            false => digits,
        })
    }
}

impl Compared<'_> {
    fn weight(&self, multiplier: f64) -> Option<f64> {
        Some(grams(self.newtons? * multiplier))
    }
}

impl Workbench {
    /// The live robot, to be compared with pinned ones; `None` without a shape.
    pub fn compared(&self) -> Option<Compared<'_>> {
        let solved = self.live.solution().filter(|it| !it.nodes.is_empty())?;
        let newtons = self.document.newtons_per_multiplier();
        Some(Compared { solved, newtons })
    }

    /// Pins the live robot under the first letter that is free.
    pub fn pin(&mut self) {
        let taken = |letter: &char| self.pins.pins.iter().any(|pin| pin.letter == *letter);
        let free = LETTERS.into_iter().find(|letter| !taken(letter));
        let (Some(letter), Some(live)) = (free, self.compared()) else {
            return;
        };
        let current = self.live.path_is_current();
        let pin = Pin {
            letter,
            solved: live.solved.clone(),
            path: self.live.path().filter(|_| current).cloned(),
            newtons: live.newtons,
        };
        self.pins.pins.push(pin);
        self.pins.pins.sort_by_key(|pin| pin.letter);
        let told = format!("Pinned as {letter}. Change the robot and compare.");
        self.notices.tell(Notice::information(told));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::Scene;
    use eframe::egui::Context;

    #[test]
    fn four_are_pinned_and_tell_what_the_live_one_has_more() {
        let text = include_str!("../../../assets/scenes/two-posts.toml");
        let mut bench = Workbench::with(Scene::from_toml(text).unwrap());
        bench.poll();
        bench.pin();
        bench.document.scene.set_pull_mm(5.05);
        bench.take_edits(&Context::default());
        bench.poll();
        let told = |bench: &Workbench, pin: usize, measure: usize| {
            let (pin, live) = (&bench.pins.all()[pin], bench.compared().unwrap());
            pin.difference(live, Pin::MEASURES[measure]).unwrap()
        };
        assert_eq!(told(&bench, 0, 0), "−0.50");
        let force = told(&bench, 0, 5);
        assert!(force.starts_with('−') || force.starts_with('+'), "{force}");
        // The same is no more and no less.
        for _ in 0..4 {
            bench.pin();
        }
        assert_eq!(bench.pins.all().len(), 4);
        assert!(!bench.pins.have_room());
        assert_eq!(told(&bench, 1, 0), "0.00");
        // The first free letter comes next.
        bench.pins.remove('A');
        bench.pin();
        let letters = bench.pins.all().iter().map(|pin| pin.letter);
        assert_eq!(letters.collect::<String>(), "ABCD");
        // Another document has none.
        bench.open(Scene::default()).unwrap();
        assert!(bench.pins.all().is_empty());
    }
}
