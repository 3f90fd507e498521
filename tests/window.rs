//! The window, driven as a person would and looked at.

use eframe::egui::{Theme, vec2};
use egui_kittest::Harness;
use sinew::app::backend::Inline;
use sinew::app::{Preferences, Sinew};

/// A window on the first example, solved inline so that nothing races.
fn window(size: [f32; 2], theme: Theme) -> Harness<'static, Sinew> {
    let preferences = Preferences {
        theme: theme.into(),
        ..Preferences::default()
    };
    Harness::builder()
        .with_size(vec2(size[0], size[1]))
        .with_pixels_per_point(1.0)
        .with_theme(theme)
        .wgpu()
        .build_eframe(move |cc| {
            let backend = Box::new(Inline::to_the_end());
            Sinew::new(&cc.egui_ctx, None, backend, preferences).unwrap()
        })
}

#[test]
fn opens_on_the_robot_leaning_on_two_discs() {
    let mut window = window([1280.0, 800.0], Theme::Light);
    window.run();
    let state = window.state().state();
    assert!(state.live.is_settled());
    assert_eq!(state.live.solution().unwrap().contacts.len(), 2);
}
