//! What a run notes on its way: contacts made and lost, jumps.

use super::{Branch, Rows, pressing};
use crate::contact::RowKind;
use crate::equilibrium::event::{Event, Occurrence};
use crate::math::within;
use crate::mechanics::Mechanics;
use crate::robot::Nodes;
use crate::solver::RowId;

/// What a change of a row's standing makes.
#[derive(Clone, Copy)]
enum Made {
    Contact,
    Gap,
}

impl<M: Mechanics<NU>, const NU: usize> Branch<M, NU> {
    /// Notes something at the present pull.
    pub(super) fn note(&mut self, what: Occurrence) {
        self.solution.events.push(Event {
            pull: self.now.pull(),
            share: self.drive_share(self.target()),
            load: self.now.drive().load(),
            what,
        });
    }

    /// Notes which contacts the step made and lost.
    pub(super) fn note_contacts(&mut self) {
        let count = self.now.obstacles().len();
        let mut old = self
            .anchor
            .rows
            .multipliers
            .iter()
            .map(|(id, _)| *id)
            .peekable();
        let mut events = std::mem::take(&mut self.solution.events);
        let first = events.len();
        let mut note = |id: RowId, made: Made| {
            if let RowKind::Contact {
                candidate,
                obstacle,
                ..
            } = RowKind::of(id, count)
            {
                let candidate = &self.now.candidates()[candidate];
                let (line, node) = (candidate.line, candidate.node);
                let what = match made {
                    Made::Contact => Occurrence::ContactMade {
                        line,
                        node,
                        obstacle,
                    },
                    Made::Gap => Occurrence::ContactLost {
                        line,
                        node,
                        obstacle,
                    },
                };
                let at = self.crossing(id, made);
                let (pull, load) = self.inputs_at(at);
                let share = self.drive_share(at);
                events.push(Event {
                    pull,
                    share,
                    load,
                    what,
                });
            }
        };
        for (row, _) in pressing(&self.sqp) {
            while let Some(id) = old.next_if(|id| *id < row) {
                note(id, Made::Gap);
            }
            if old.next_if_eq(&row).is_none() {
                note(row, Made::Contact);
            }
        }
        old.for_each(|id| note(id, Made::Gap));
        // In the order they happened along the step.
        let input = |(pull, load): (f64, Option<f64>)| load.unwrap_or(pull);
        let forward = input(self.inputs_at(1.0)) >= input(self.inputs_at(0.0));
        events[first..].sort_by(|a, b| {
            let (a, b) = (input((a.pull, a.load)), input((b.pull, b.load)));
            if forward {
                a.total_cmp(&b)
            } else {
                b.total_cmp(&a)
            }
        });
        self.solution.events = events;
    }

    /// The first cable's pull and, where that is what is given, its load at a share
    /// of the leg.
    fn inputs_at(&self, share: f64) -> (f64, Option<f64>) {
        let (from, to) = (self.from.drive(), self.to.drive());
        let mix = |a: f64, b: f64| (1.0 - share) * a + share * b;
        let loads = from.load().zip(to.load());
        (mix(from.pull(), to.pull()), loads.map(|(a, b)| mix(a, b)))
    }

    /// The share of the leg at which a row's clearance (or, for a contact that
    /// is lost, its multiplier) reached zero: on the straight line through its
    /// values at the last two shapes, which errs by the square of a step.
    fn crossing(&self, id: RowId, made: Made) -> f64 {
        let end = self.target();
        let value = |rows: &Rows| {
            let list = match made {
                Made::Contact => &rows.clearances,
                Made::Gap => &rows.multipliers,
            };
            let found = list.binary_search_by_key(&id, |(id, _)| *id);
            found.ok().map(|index| list[index].1)
        };
        let (Some(before_at), Some(before), Some(here)) = (
            self.before_at,
            value(&self.before),
            value(&self.anchor.rows),
        ) else {
            return end;
        };
        let rate = (here - before) / (self.at - before_at);
        if rate < 0.0 {
            within(self.at - here / rate, self.at, end)
        } else {
            end
        }
    }

    /// The node that the step moved farthest, and how far.
    pub(super) fn farthest_node(&self) -> (usize, f64) {
        let (from, to) = (&self.anchor.nodes, &self.sqp.point().nodes);
        let (from, to) = (M::shape(from), M::shape(to));
        let moved = |i: usize| to.node(i).position - from.node(i).position;
        let distances = (0..from.count().min(to.count())).map(|i| moved(i).norm());
        distances.enumerate().fold(
            (0, 0.0),
            |most, next| if next.1 > most.1 { next } else { most },
        )
    }
}
