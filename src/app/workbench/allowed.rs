//! Which commands would do anything now.

use super::{Selection, Workbench};
use crate::app::commands::Command;

impl Workbench {
    /// Whether a command would do anything.
    pub fn allows(&self, command: Command) -> bool {
        match command {
            Command::Undo => self.history.can_undo(&self.document.scene),
            Command::Redo => self.history.can_redo(),
            Command::Delete => {
                let kept = matches!(self.selection, Selection::Nothing | Selection::Robot);
                !kept
            }
            Command::Pin => self.pins.have_room() && self.live.is_settled(),
            Command::Load => self.document.stiffness().is_some(),
            Command::Mechanics => self.other.faults().is_empty(),
            Command::Duplicate => self.selection.obstacle().is_some(),
            Command::Deselect => {
                self.is_in_hand
                    || self.photos.scaling.is_some()
                    || self.selection != Selection::Nothing
            }
            _ => true,
        }
    }
}
