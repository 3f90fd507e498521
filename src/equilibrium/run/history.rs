//! What a run notes on its way: contacts made and lost, jumps.

use super::{Rows, Run};
use crate::contact::RowKind;
use crate::equilibrium::event::{Event, Occurrence};
use crate::math::within;
use crate::solver::RowId;

/// What a change of a row's standing makes.
#[derive(Clone, Copy)]
enum Made {
    Contact,
    Gap,
}

impl Run {
    /// Notes something at the present pull.
    pub(super) fn note(&mut self, what: Occurrence) {
        self.solution.events.push(Event {
            pull: self.now.pull(),
            what,
        });
    }

    /// Notes which contacts the step made and lost.
    pub(super) fn note_contacts(&mut self) {
        let count = self.now.obstacles().len();
        let rows = self.sqp.point().rows.iter().zip(self.sqp.multipliers());
        let pressing = rows.filter(|(_, multiplier)| **multiplier > 0.0);
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
                let pull = self.pull_at(self.crossing(id, made));
                events.push(Event { pull, what });
            }
        };
        for (row, _) in pressing {
            while let Some(id) = old.next_if(|id| *id < row.id) {
                note(id, Made::Gap);
            }
            if old.next_if_eq(&row.id).is_none() {
                note(row.id, Made::Contact);
            }
        }
        old.for_each(|id| note(id, Made::Gap));
        // In the order they happened along the step.
        let forward = self.to.pull() >= self.from.pull();
        events[first..].sort_by(|a, b| {
            if forward {
                a.pull.total_cmp(&b.pull)
            } else {
                b.pull.total_cmp(&a.pull)
            }
        });
        self.solution.events = events;
    }

    fn pull_at(&self, share: f64) -> f64 {
        (1.0 - share) * self.from.pull() + share * self.to.pull()
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
        let pairs = self.anchor.nodes.iter().zip(&self.sqp.point().nodes);
        let distances = pairs.map(|(a, b)| (b.position - a.position).norm());
        distances.enumerate().fold(
            (0, 0.0),
            |most, next| if next.1 > most.1 { next } else { most },
        )
    }
}
