//! How hard contacts and disks press, as shares of a scale: the same for every
//! picture.

use super::force_scale::ForceScale;
use crate::contact::{Class, Contact};
use crate::equilibrium::Solution;
use crate::robot::Line;

/// The contacts of a solution, measured by a scale.
#[derive(Clone, Copy, Debug)]
pub struct Shares<'a> {
    contacts: &'a [Contact],
    scale: ForceScale,
}

impl<'a> Shares<'a> {
    /// The shares of a solution's contacts.
    pub fn of(solution: &'a Solution, scale: ForceScale) -> Self {
        Self {
            contacts: &solution.contacts,
            scale,
        }
    }

    /// A contact's share, from 0 to 1.
    pub fn contact(&self, contact: &Contact) -> f64 {
        self.scale.of(contact)
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
