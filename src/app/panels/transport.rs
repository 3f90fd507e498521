//! The transport bar: playing the pull, its slider across the window with what
//! happens on the way. Each cable is set by its pull or, where the stiffness is known,
//! by its load; the other of the two stands beside it as it is found.

use super::status::{self, StatusChip};
use super::track;
use crate::app::commands::Command;
use crate::app::look::{Segment, Tokens, icon_button, icons, segments};
use crate::app::widgets::{button, row};
use crate::app::workbench::{Held, Transport, Workbench};
use crate::mechanics::Model;
use crate::scene::limits::LOAD;
use crate::view::Quantity;
use eframe::egui::{
    Align, ComboBox, DragValue, Layout, RichText, Role, Sense, Ui, WidgetInfo, vec2,
};

/// Below this width, in points, the slider has a row of its own.
const NARROW: f32 = 640.0;
/// Below this width what can be done without is left out.
const SPARE: f32 = 800.0;
/// Below this width there is no room for the play button but beside the slider.
const CRAMPED: f32 = 364.0;
/// Below this width there is no room for what is found beside what is set.
const FOUND_TOO: f32 = 1080.0;
/// Width of the field of what is set, in points, and of what is found.
const FIELD: f32 = 84.0;
const FOUND: f32 = 60.0;
/// A robot of more cables has a list of them, in the place of a rail.
const FEW: usize = 4;

/// Shows the transport bar with the status chip at its right end.
pub fn show(ui: &mut Ui, chip: &mut StatusChip, bench: &mut Workbench) {
    let bar = ui.available_width();
    let row = vec2(bar, ui.spacing().interact_size.y);
    let layout = Layout::right_to_left(Align::Center);
    let narrow = bar < NARROW;
    ui.allocate_ui_with_layout(row, layout, |ui| {
        ui.spacing_mut().item_spacing.x = 16.0;
        status::show(ui, chip, bench, bar);
        let layout = Layout::left_to_right(Align::Center);
        ui.with_layout(layout, |ui| {
            ui.spacing_mut().item_spacing.x = 8.0;
            if bar >= CRAMPED {
                play(ui, bench);
            }
            if bar >= SPARE {
                looping(ui, bench);
                speed(ui, bench);
                button(ui, bench, Command::FromStraight);
                ui.add_space(8.0);
            }
            cables(ui, bench);
            actuation(ui, bench);
            if !short_of(ui, bench, bar) && bar >= FOUND_TOO {
                found(ui, bench);
            }
            if !narrow {
                track::show(ui, bench);
            }
        });
    });
    if narrow {
        // A finger needs the whole width.
        ui.add_space(4.0);
        ui.horizontal(|ui| {
            if bar < CRAMPED {
                play(ui, bench);
            }
            track::show(ui, bench);
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

fn speed(ui: &mut Ui, bench: &mut Workbench) {
    let held = bench.held(bench.cable());
    let transport = &mut bench.transport;
    let (speed, offered, unit) = match held {
        Held::Pull => (&mut transport.speed_mm, &Transport::SPEEDS_MM[..], "mm/s"),
        Held::Load => (&mut transport.speed_g, &Transport::SPEEDS_G[..], "g/s"),
    };
    let shown = |speed: f64| {
        let decimals = usize::from(speed.fract() != 0.0);
        Quantity::fixed(speed, decimals, unit).text()
    };
    let combo = ComboBox::from_id_salt("speed")
        .width(84.0)
        .selected_text(shown(*speed))
        .show_ui(ui, |ui| {
            for one in offered {
                ui.selectable_value(speed, *one, shown(*one));
            }
        });
    combo.response.on_hover_text("Speed of playing");
}

/// Which cable slider and field are of, where there are several.
fn cables(ui: &mut Ui, bench: &mut Workbench) {
    let count = bench.document.scene.cable_count();
    if count < 2 {
        return;
    }
    let current = bench.cable();
    if count > FEW {
        ComboBox::from_id_salt("cable")
            .width(72.0)
            .selected_text(format!("Cable {}", current + 1))
            .show_ui(ui, |ui| {
                for cable in 0..count {
                    let name = format!("Cable {}", cable + 1);
                    ui.selectable_value(&mut bench.transport.cable, cable, name);
                }
            });
        return;
    }
    let names: Vec<(String, String)> = (1..=count)
        .map(|number| (number.to_string(), format!("Cable {number}")))
        .collect();
    let shown: Vec<Segment<'_>> = names
        .iter()
        .map(|(name, title)| Segment {
            name,
            title,
            tip: format!("Set {}", title.to_lowercase()),
            enabled: true,
        })
        .collect();
    if let Some(chosen) = segments(ui, 28.0, &shown, Some(current)) {
        bench.transport.cable = chosen;
    }
}

/// What is set, pull or load, and its value.
fn actuation(ui: &mut Ui, bench: &mut Workbench) {
    let known = bench.document.stiffness().is_some();
    let tip = if known {
        "Hold the load that hangs on the cable"
    } else {
        "A load can be set where the robot's stiffness is known"
    };
    let shown = [
        Segment {
            name: "Pull",
            title: "Set the pull",
            tip: "Hold the length of cable that is drawn in".to_owned(),
            enabled: true,
        },
        Segment {
            name: "Load",
            title: "Set the load",
            tip: Command::Load.tip_saying(tip, ui.ctx()),
            enabled: known,
        },
    ];
    let held = bench.held(bench.cable());
    let current = usize::from(held == Held::Load);
    let chosen = segments(ui, 44.0, &shown, Some(current));
    if chosen.is_some_and(|chosen| chosen != current) {
        bench.commands.push(Command::Load);
    }
    match held {
        Held::Load => load(ui, bench),
        Held::Pull => pull(ui, bench),
    }
}

/// How far the robot was brought of what is asked, where it gets no farther. Whether
/// it is so.
fn short_of(ui: &mut Ui, bench: &Workbench, bar: f32) -> bool {
    let cable = bench.cable();
    let Some(reached) = bench.reached(cable) else {
        return false;
    };
    let (asked, reached) = match bench.held(cable) {
        Held::Pull => [bench.pull_mm_of(cable), reached]
            .map(|mm| Quantity::fixed(mm, 2, "mm"))
            .into(),
        Held::Load => [bench.load_g(cable).unwrap_or_default(), reached]
            .map(|g| Quantity::fixed(g, 1, "g"))
            .into(),
    };
    let told = format!("Asked {}, reached {}", asked.text(), reached.text());
    let shown = match bar < SPARE {
        true => reached.text(),
        false => format!("reached {}", reached.text()),
    };
    let warning = Tokens::in_ui(ui).warning;
    let response = ui.label(RichText::new(shown).small().color(warning));
    response.widget_info(|| WidgetInfo::labeled(Role::Label, true, &told));
    let why = bench
        .live
        .solution()
        .map(|it| crate::view::reason(it).to_string());
    response.on_hover_text(match why {
        Some(why) => format!("{told}. {why}."),
        None => told,
    });
    true
}

/// The other quantity of the cable, as the solver finds it.
fn found(ui: &mut Ui, bench: &Workbench) {
    let cable = bench.cable();
    let (name, value) = match bench.held(cable) {
        Held::Load => {
            let pull_mm = bench.pull_mm_of(cable);
            ("Pull found", Quantity::fixed(pull_mm, 2, "mm"))
        }
        Held::Pull => match bench.load_g(cable) {
            Some(load_g) => {
                // As many digits as there is room for.
                let decimals = usize::from(load_g < 1000.0);
                ("Load found", Quantity::fixed(load_g, decimals, "g"))
            }
            None => return,
        },
    };
    let (rect, response) =
        ui.allocate_exact_size(vec2(FOUND, ui.spacing().interact_size.y), Sense::hover());
    let told = format!("{name}: {}", value.text());
    response.widget_info(|| WidgetInfo::labeled(Role::Label, true, &told));
    let text = RichText::new(value.text()).small().weak();
    row::text(ui, rect, text, Align::Min);
    response.on_hover_text(told);
}

fn pull(ui: &mut Ui, bench: &mut Workbench) {
    let cable = bench.cable();
    let (least, most) = bench.document.problem().pull_range();
    let mut pull_mm = bench.pull_mm_of(cable);
    let range = track::round_inwards(least, most);
    let field = DragValue::new(&mut pull_mm)
        .speed(0.01)
        .range(range.0..=range.1)
        .fixed_decimals(2)
        .suffix(" mm");
    let size = vec2(FIELD, ui.spacing().interact_size.y);
    let response = ui
        .add_sized(size, field)
        .accessible_name("Pull")
        .on_hover_text("Length of cable drawn in. Drag sideways or click to type.");
    if response.changed() {
        bench.set_pull_of(cable, pull_mm);
    }
}

fn load(ui: &mut Ui, bench: &mut Workbench) {
    let cable = bench.cable();
    let (Some(mut load_g), Some(most_g)) = (bench.load_g(cable), bench.most_g(cable)) else {
        return;
    };
    // Where cables slide any load can be hung on one, whatever becomes of the robot.
    let most_g = match bench.model() {
        Model::Sliding => LOAD.max,
        Model::Equal => most_g,
    };
    let field = DragValue::new(&mut load_g)
        .speed(0.5)
        .range(0.0..=most_g)
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
        bench.set_load(cable, load_g);
    }
}
