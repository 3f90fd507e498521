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
            sinew::render::install(cc.wgpu_render_state.as_ref().unwrap());
            let backend = Box::new(Inline::to_the_end());
            Sinew::new(&cc.egui_ctx, None, backend, preferences).unwrap()
        })
}

fn shoot(window: &mut Harness<'static, Sinew>, name: &str) {
    if let Some(folder) = std::env::var_os("SHOTS") {
        let file = std::path::Path::new(&folder).join(name);
        window.render().unwrap().save(file).unwrap();
    }
}

#[test]
fn shots() {
    for (theme, name) in [(Theme::Light, "light"), (Theme::Dark, "dark")] {
        let mut window = window([1440.0, 900.0], theme);
        window.run();
        shoot(&mut window, &format!("{name}.png"));
        window.state_mut().state_mut().preferences.views = sinew::app::Views::Both;
        window.run();
        shoot(&mut window, &format!("{name}-both.png"));
    }
}

#[test]
fn opens_on_the_robot_leaning_on_two_discs() {
    let mut window = window([1280.0, 800.0], Theme::Light);
    window.run();
    let state = window.state().state();
    assert!(state.live.is_settled());
    assert_eq!(state.live.solution().unwrap().contacts.len(), 2);
}
