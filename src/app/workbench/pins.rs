//! Robots that were pinned: shapes as they were found, with what they did along their
//! pull, to be compared with the live one. They are no part of the scene.

use super::{Notice, Workbench};
use crate::app::look::Tokens;
use crate::contact::Class;
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

/// What is compared of two robots: its name with its unit, and its value.
pub type Measure = (&'static str, fn(&Pin) -> Option<f64>, usize);

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
        ("Pull, mm", |pin| Some(millimetres(pin.solved.pull)), 2),
        (
            "Load P, g",
            |pin| pin.weight(pin.solved.cables.first()?.load),
            1,
        ),
        (
            "Tip x, mm",
            |pin| Some(millimetres(pin.solved.tip().position.x)),
            2,
        ),
        (
            "Tip y, mm",
            |pin| Some(millimetres(pin.solved.tip().position.y)),
            2,
        ),
        (
            "Bend, °",
            |pin| {
                let bends = pin.solved.bends.iter().sum();
                Some(degrees(bends))
            },
            1,
        ),
        ("Forces F, g", |pin| pin.weight(pin.pressed()), 1),
    ];

    /// Its colour: one of those that tell robots beside the live one.
    pub fn ink(&self, tokens: &Tokens) -> Color32 {
        let place = LETTERS.iter().position(|letter| *letter == self.letter);
        place.map_or(tokens.muted, |place| tokens.ghosts[place])
    }

    fn weight(&self, multiplier: f64) -> Option<f64> {
        Some(grams(self.newtons? * multiplier))
    }

    fn pressed(&self) -> f64 {
        let pressing = self.solved.contacts.iter();
        let pressing = pressing.filter(|contact| contact.class == Class::Pressing);
        pressing.map(|contact| contact.multiplier).sum()
    }

    /// What the live robot has more of than this one, as it is written; nothing where
    /// it is not known of both.
    pub fn difference(&self, live: &Pin, (_, of, decimals): Measure) -> Option<String> {
        let more = of(live)? - of(self)?;
        let digits = Quantity::fixed(more, decimals, "").digits;
        let is_more = digits.starts_with(|first: char| first.is_ascii_digit());
        let is_nothing = digits.chars().all(|digit| matches!(digit, '0' | '.'));
        Some(match is_more && !is_nothing {
            true => format!("+{digits}"),
            false => digits,
        })
    }
}

impl Workbench {
    /// The live robot as if it were pinned; `None` without a shape.
    pub fn as_pin(&self) -> Option<Pin> {
        let solved = self.live.solution().filter(|it| !it.nodes.is_empty())?;
        let current = self.live.path_is_current();
        Some(Pin {
            letter: ' ',
            solved: solved.clone(),
            path: self.live.path().filter(|_| current).cloned(),
            newtons: self.document.newtons_per_multiplier(),
        })
    }

    /// Pins the live robot under the first letter that is free.
    pub fn pin(&mut self) {
        let taken = |letter: &char| self.pins.pins.iter().any(|pin| pin.letter == *letter);
        let free = LETTERS.into_iter().find(|letter| !taken(letter));
        let (Some(letter), Some(pin)) = (free, self.as_pin()) else {
            return;
        };
        self.pins.pins.push(Pin { letter, ..pin });
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
        let live = bench.as_pin().unwrap();
        let told = |bench: &Workbench, measure: usize| {
            let pin = &bench.pins.all()[0];
            pin.difference(&live, Pin::MEASURES[measure]).unwrap()
        };
        assert_eq!(told(&bench, 0), "−0.50");
        let force = told(&bench, 5);
        assert!(force.starts_with('−') || force.starts_with('+'), "{force}");
        // The same is no more and no less.
        for _ in 0..4 {
            bench.pin();
        }
        assert_eq!(bench.pins.all().len(), 4);
        assert!(!bench.pins.have_room());
        let same = bench.pins.all()[1].difference(&live, Pin::MEASURES[0]);
        assert_eq!(same.unwrap(), "0.00");
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
