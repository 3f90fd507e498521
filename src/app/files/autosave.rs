//! The scene while it differs from what is saved, kept so that a crash loses
//! nothing.
//!
//! Unsaved work is kept by each window for itself ([`Platform::keep`]). An
//! orderly end leaves none behind, so what is found at the start is from a
//! crash (or a system that shut down), and is offered.
//!
//! [`Platform::keep`]: crate::app::platform::Platform::keep

use crate::app::workbench::{Unsaved, Workbench};

/// The window's scene, if it differs from what is saved.
fn unsaved(bench: &Workbench) -> Option<Unsaved> {
    let document = &bench.document;
    if !document.is_changed() || bench.files.closing {
        return None;
    }
    Some(Unsaved {
        name: document.name(),
        // A path that is no text cannot be written, which must not cost
        // the work.
        file: document.file.clone().filter(|file| file.to_str().is_some()),
        scene: document.scene.to_toml().ok()?,
        drawer: String::new(),
    })
}

/// Keeps the scene where a crash leaves it, as long as it is not saved.
pub fn keep(bench: &mut Workbench) {
    let work = unsaved(bench).and_then(|unsaved| toml::to_string(&unsaved).ok());
    bench.files.platform.keep(work);
}

/// Throws away what a window that is gone has kept.
pub fn forget(bench: &mut Workbench, drawer: &str) {
    bench.files.unsaved.retain(|left| left.drawer != drawer);
    bench.files.platform.forget(drawer);
}
