//! The scene as it was in the last frame, for what is said after a panic: the
//! window itself cannot be asked any more.

use crate::scene::Scene;
use std::sync::Mutex;

static KEPT: Mutex<Option<Scene>> = Mutex::new(None);

/// Remembers a scene.
pub fn keep(scene: &Scene) {
    if let Ok(mut kept) = KEPT.lock()
        && kept.as_ref() != Some(scene)
    {
        *kept = Some(scene.clone());
    }
}

/// The scene that was kept as its file; empty where there is none.
pub fn file() -> String {
    // A panic may have come while it was being remembered.
    let scene = KEPT.try_lock().ok().and_then(|kept| kept.clone());
    let file = scene.and_then(|scene| scene.to_toml().ok());
    file.unwrap_or_default()
}

/// Calls something on a panic: with what happened, and with the scene that was
/// kept as its file.
pub fn on_panic(tell: fn(&str, &str)) {
    std::panic::set_hook(Box::new(move |panic| tell(&panic.to_string(), &file())));
}
