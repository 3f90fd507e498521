//! What the panels and tables are made of: rows, buttons of commands, forms of
//! fields, and the mark on forces that are not to be believed.

mod button;
mod form;
pub mod row;
mod typed;
mod understated;

pub use button::button;
pub use form::{Form, Number};
pub use typed::Kind;
pub use understated::{understated, understated_over};

use crate::app::workbench::Workbench;
use crate::scene::{Scene, SceneError};

/// A form for a part of the scene, which is handed out beside it.
pub fn with_form(bench: &mut Workbench, add: impl FnOnce(&mut Scene, &mut Form<'_>)) {
    let faults: &[SceneError] = bench.refusal.as_ref().map_or(&[], |it| &it.faults);
    let form = &mut Form::new(&mut bench.complaint, faults);
    add(&mut bench.document.scene, form);
}
