//! The transport bar: playing the pull, its slider across the window with what
//! happens on the way, and the load where the stiffness is known.

use super::bar::button;
use super::track;
use crate::app::commands::Command;
use crate::app::look::{icon_button, icons};
use crate::app::state::State;
use crate::app::transport::Transport;
use crate::view::Quantity;
use eframe::egui::{ComboBox, DragValue, RichText, Ui};

/// Below this width, in points, only play, the pull and its slider stay.
const NARROW: f32 = 640.0;

/// Shows the transport bar.
pub fn show(ui: &mut Ui, state: &mut State) {
    let wide = ui.available_width() >= NARROW;
    ui.horizontal(|ui| {
        play(ui, state);
        if wide {
            looping(ui, state);
            speed(ui, &mut state.transport);
            button(ui, state, Command::FromStraight);
            ui.add_space(8.0);
        }
        pull(ui, state);
        track::show(ui, state);
    });
}

fn play(ui: &mut Ui, state: &mut State) {
    let (glyph, name) = if state.transport.is_playing() {
        (icons::PAUSE, "Pause")
    } else {
        (icons::PLAY, "Play")
    };
    let keys = Command::Play.entry().shortcut;
    let keys = keys.map(|keys| ui.ctx().format_shortcut(&keys));
    let tip = format!("{name} ({})", keys.unwrap_or_default());
    if icon_button(ui, glyph, &tip).clicked() {
        state.commands.push(Command::Play);
    }
}

fn looping(ui: &mut Ui, state: &mut State) {
    let looping = &mut state.transport.looping;
    let tip = if *looping {
        "Turn round at the ends: on"
    } else {
        "Turn round at the ends: off"
    };
    let was = *looping;
    let response = ui.scope(|ui| {
        if !was {
            ui.visuals_mut().override_text_color = Some(ui.visuals().weak_text_color());
        }
        icon_button(ui, icons::REPEAT, tip)
    });
    if response.inner.clicked() {
        *looping ^= true;
    }
}

fn speed(ui: &mut Ui, transport: &mut Transport) {
    let shown = |speed: f64| {
        let decimals = usize::from(speed.fract() != 0.0);
        Quantity::fixed(speed, decimals, "mm/s").text()
    };
    let combo = ComboBox::from_id_salt("speed")
        .width(84.0)
        .selected_text(shown(transport.speed_mm))
        .show_ui(ui, |ui| {
            for speed in Transport::SPEEDS_MM {
                ui.selectable_value(&mut transport.speed_mm, speed, shown(speed));
            }
        });
    combo.response.on_hover_text("Speed of playing");
}

fn pull(ui: &mut Ui, state: &mut State) {
    let label = ui.label("Pull");
    ui.label(RichText::new("l").italics().weak());
    let (least, most) = state.document.problem().robot().pull_range();
    let pull_mm = &mut state.document.scene.actuation.pull_mm;
    let range = track::round_inwards(least, most);
    ui.add(
        DragValue::new(pull_mm)
            .speed(0.01)
            .range(range.0..=range.1)
            .fixed_decimals(2)
            .min_size(eframe::egui::vec2(84.0, 28.0))
            .suffix(" mm"),
    )
    .labelled_by(label.id)
    .on_hover_text("Length of cable drawn in. Drag sideways or click to type.");
}
