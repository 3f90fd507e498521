//! The transport bar: playing the pull, its slider across the window with what
//! happens on the way, and the load where the stiffness is known.

use super::status::{self, StatusChip};
use super::track;
use crate::app::commands::Command;
use crate::app::look::{Segment, icon_button, icons, segments};
use crate::app::widgets::button;
use crate::app::workbench::{Loads, Playing, Transport, Workbench};
use crate::view::Quantity;
use eframe::egui::{Align, ComboBox, DragValue, Layout, Ui, vec2};

/// Below this width, in points, the slider has a row of its own.
const NARROW: f32 = 640.0;
/// Below this width what can be done without is left out.
const SPARE: f32 = 800.0;
/// Below this width there is no room for the play button but beside the slider.
const CRAMPED: f32 = 364.0;
/// Width of the field of what is set, in points.
const FIELD: f32 = 84.0;

/// Shows the transport bar with the status chip at its right end.
pub fn show(ui: &mut Ui, chip: &mut StatusChip, bench: &mut Workbench) {
    let bar = ui.available_width();
    let row = vec2(bar, ui.spacing().interact_size.y);
    let layout = Layout::right_to_left(Align::Center);
    let narrow = bar < NARROW;
    let loads = ui.allocate_ui_with_layout(row, layout, |ui| {
        ui.spacing_mut().item_spacing.x = 16.0;
        status::show(ui, chip, bench, bar);
        let layout = Layout::left_to_right(Align::Center);
        let controls = ui.with_layout(layout, |ui| {
            ui.spacing_mut().item_spacing.x = 8.0;
            if bar >= CRAMPED {
                play(ui, bench);
            }
            if bar >= SPARE {
                looping(ui, bench);
                speed(ui, &mut bench.transport);
                button(ui, bench, Command::FromStraight);
                ui.add_space(8.0);
            }
            let loads = actuation(ui, bench);
            if !narrow {
                track::show(ui, bench, loads.as_ref());
            }
            loads
        });
        controls.inner
    });
    if narrow {
        // A finger needs the whole width.
        ui.add_space(4.0);
        ui.horizontal(|ui| {
            if bar < CRAMPED {
                play(ui, bench);
            }
            track::show(ui, bench, loads.inner.as_ref());
        });
        ui.add_space(8.0);
    }
}

fn play(ui: &mut Ui, bench: &mut Workbench) {
    let (glyph, name) = if bench.transport.is_playing() {
        (icons::PAUSE, "Pause")
    } else {
        (icons::PLAY, "Play")
    };
    let tip = Command::Play.tip_saying(name, ui.ctx());
    if icon_button(ui, glyph, &tip).clicked() {
        bench.commands.push(Command::Play);
    }
}

fn looping(ui: &mut Ui, bench: &mut Workbench) {
    let looping = &mut bench.transport.looping;
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

/// What is set, pull or load, and its value. The loads, if it is they.
fn actuation(ui: &mut Ui, bench: &mut Workbench) -> Option<Loads> {
    let loads = bench.loads().filter(|_| bench.transport.by_load);
    let known = bench.document.stiffness().is_some();
    let tip = if known {
        "The load that hangs on the cable"
    } else {
        "A load can be set where the robot's stiffness is known"
    };
    let shown = [
        Segment {
            name: "Pull",
            title: "Set the pull",
            tip: "The length of cable that is drawn in".to_owned(),
            enabled: true,
        },
        Segment {
            name: "Load",
            title: "Set the load",
            tip: Command::Load.tip_saying(tip, ui.ctx()),
            enabled: known,
        },
    ];
    let current = usize::from(loads.is_some());
    let chosen = segments(ui, 44.0, &shown, Some(current));
    if chosen.is_some_and(|chosen| chosen != current) {
        bench.commands.push(Command::Load);
    }
    match &loads {
        Some(loads) => load(ui, bench, loads),
        None => pull(ui, bench),
    }
    loads
}

fn pull(ui: &mut Ui, bench: &mut Workbench) {
    let (least, most) = bench.document.problem().robot().pull_range();
    let mut pull_mm = bench.pull_mm();
    let range = track::round_inwards(least, most);
    let field = DragValue::new(&mut pull_mm)
        .speed(0.01)
        .range(range.0..=range.1)
        .fixed_decimals(2)
        .suffix(" mm");
    let size = vec2(FIELD, ui.spacing().interact_size.y);
    ui.add_sized(size, field)
        .accessible_name("Pull")
        .on_hover_text("Length of cable drawn in. Drag sideways or click to type.");
    bench.set_pull(pull_mm, Playing::GoesOn);
}

fn load(ui: &mut Ui, bench: &mut Workbench, loads: &Loads) {
    let mut load_g = loads.load_g(bench.pull_mm());
    let field = DragValue::new(&mut load_g)
        .speed(0.5)
        .range(0.0..=loads.most_g())
        // A shape that needs more was reached by its pull.
        .clamp_existing_to_range(false)
        .fixed_decimals(1)
        .suffix(" g");
    let size = vec2(FIELD, ui.spacing().interact_size.y);
    let response = ui
        .add_sized(size, field)
        .accessible_name("Load")
        .on_hover_text(
            "Load on the cable, 0 for the straight robot. Drag sideways or click to type.",
        );
    if response.changed() {
        bench.set_pull(loads.pull_mm(load_g), Playing::GoesOn);
    }
}
