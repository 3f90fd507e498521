//! How hard contacts and disks press, as shares of what presses hardest: the
//! same for every picture.

use crate::contact::{Class, Contact};
use crate::equilibrium::Solution;
use crate::robot::Line;

/// The contacts of a solution, measured by the greatest of their multipliers.
#[derive(Clone, Copy, Debug)]
pub struct Shares<'a> {
    contacts: &'a [Contact],
    most: f64,
}

impl<'a> Shares<'a> {
    /// The shares of a solution's contacts.
    pub fn of(solution: &'a Solution) -> Self {
        let contacts = &solution.contacts[..];
        let multipliers = contacts.iter().map(|contact| contact.multiplier);
        Self {
            contacts,
            most: multipliers.fold(0.0, f64::max),
        }
    }

    /// The greatest multiplier, rad²/m; 0 where nothing presses.
    pub fn most(&self) -> f64 {
        self.most
    }

    /// A contact's share, from 0 to 1.
    pub fn contact(&self, contact: &Contact) -> f64 {
        if self.most > 0.0 {
            (contact.multiplier / self.most).clamp(0.0, 1.0)
        } else {
            0.0
        }
    }

    /// The greatest share of what presses on a node's disk and not on the
    /// links beside it; `None` where nothing does.
    pub fn disk(&self, node: usize) -> Option<f64> {
        let pressing = self.contacts.iter().filter(|contact| {
            let on_link = matches!(contact.line, Line::BackboneLink | Line::CableLink);
            contact.node == node && !on_link && contact.class == Class::Pressing
        });
        pressing
            .map(|contact| self.contact(contact))
            .reduce(f64::max)
    }
}
