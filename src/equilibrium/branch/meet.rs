//! How a run meets obstacles that come, go or change their places in the list.

use super::{Branch, Rows};
use crate::contact::RowKind;
use crate::equilibrium::approach;
use crate::equilibrium::event::{Event, Occurrence};
use crate::equilibrium::solution::sort_by_id;
use crate::geometry::Obstacle;
use crate::mechanics::{Drive, Mechanics, Problem};
use crate::solver::RowId;

impl<M: Mechanics<NU>, const NU: usize> Branch<M, NU> {
    /// Begins at the anchor, driven as given, with the goal's obstacles where they
    /// are `known` to be or, where none of the kind is known, grown from
    /// nothing if they overlap.
    pub(super) fn meet_obstacles(&mut self, known: &[Obstacle], drive: &Drive) {
        let mut first = self.goal.clone();
        first.change(|first| first.set_drive(drive));
        let mut overlapping = false;
        for (index, obstacle) in self.goal.obstacles().iter().enumerate() {
            // One that stands where it stood is that one, wherever it is in
            // the list; others move only where the list is as long as before.
            let stands = known.iter().any(|here| stands(here, obstacle));
            let moves = known.len() == self.goal.obstacles().len()
                && !self
                    .goal
                    .obstacles()
                    .iter()
                    .any(|other| stands_at(known, index, other));
            let here = known
                .get(index)
                .filter(|here| moves && here.resembles(obstacle));
            if stands {
                continue;
            }
            if let Some(here) = here {
                first.change(|first| first.set_obstacle(index, here.clone()));
            } else if let Some(seed) =
                approach::seed(&self.goal, obstacle, M::shape(&self.anchor.nodes))
            {
                overlapping = true;
                first.change(|first| first.set_obstacle(index, seed.obstacle));
                let what = Occurrence::PushedAside {
                    obstacle: index,
                    direction: seed.direction,
                };
                self.solution.events.push(Event {
                    pull: drive.pull(),
                    share: 0.0,
                    load: drive.load(),
                    what,
                });
            }
        }
        self.from = first;
        self.to.clone_from(&self.goal);
        if overlapping {
            self.to.change(|to| to.set_drive(drive));
        }
        self.anchor.rows = self.anchor.rows.renamed(known, self.goal.obstacles());
        self.grown_first = overlapping;
        self.begin_leg(!overlapping);
    }
}

impl Rows {
    /// The same rows, whose names count the obstacles, among others: of each
    /// obstacle that stands where it stood, wherever it is in the list now, and of
    /// none that is gone. What presses on goes on pressing.
    fn renamed(&self, known: &[Obstacle], now: &[Obstacle]) -> Self {
        let name = |id: RowId| match RowKind::of(id, known.len()) {
            RowKind::Contact {
                candidate,
                obstacle,
                vertex,
            } => {
                let known = known.get(obstacle)?;
                let obstacle = now.iter().position(|now| stands(known, now))?;
                let kind = RowKind::Contact {
                    candidate,
                    obstacle,
                    vertex,
                };
                Some(kind.id(now.len()))
            }
            RowKind::TurnLimit { .. } | RowKind::Cable { .. } => Some(id),
        };
        let rename = |rows: &[(RowId, f64)]| {
            let named = rows
                .iter()
                .filter_map(|(id, value)| Some((name(*id)?, *value)));
            let mut rows: Vec<(RowId, f64)> = named.collect();
            sort_by_id(&mut rows);
            rows
        };
        Self {
            multipliers: rename(&self.multipliers),
            clearances: rename(&self.clearances),
        }
    }
}

/// Whether two obstacles are the same at the same place.
fn stands(a: &Obstacle, b: &Obstacle) -> bool {
    a.resembles(b) && a.change(b) == 0.0
}

/// Whether the known obstacle of this index stands where another one does.
fn stands_at(known: &[Obstacle], index: usize, other: &Obstacle) -> bool {
    known.get(index).is_some_and(|here| stands(here, other))
}

/// Whether some obstacle stands where another one of the list stood.
pub(super) fn reordered(now: &Problem, then: &Problem) -> bool {
    let pairs = now.obstacles().iter().zip(then.obstacles());
    let moved = |(a, b): &(&Obstacle, &Obstacle)| !stands(a, b);
    let mut moving = pairs.clone().filter(moved);
    moving.any(|(_, b)| now.obstacles().iter().any(|a| stands(a, b)))
}
