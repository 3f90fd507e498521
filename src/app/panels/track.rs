//! The track of the pull: its slider, and marks where contacts begin and end,
//! where the robot jumps and where its branch ends.

use crate::app::look::{Tokens, fits_fingers, icon_font, icons};
use crate::app::words;
use crate::app::workbench::{Held, Hovered, Workbench};
use crate::equilibrium::{Event, Occurrence};
use crate::units::{metres, millimetres};
use eframe::egui::{
    Align2, FontId, Painter, Rangef, Rect, Response, Sense, Slider, SliderClamping, Stroke, Ui,
    pos2, vec2,
};

/// Height of the slider, of which its handle takes four fifths; for fingers it
/// is as high as all else.
const HEIGHT: f32 = 20.0;

/// Shows the slider of what is held of the cable at hand, its pull or its load, in the
/// width that is left.
pub fn show(ui: &mut Ui, bench: &mut Workbench) {
    ui.spacing_mut().slider_width = (ui.available_width() - 4.0).max(80.0);
    if !fits_fingers(ui) {
        ui.spacing_mut().interact_size.y = HEIGHT;
    }
    let cable = bench.cable();
    let held = bench.held(cable);
    let (span, response) = match held {
        Held::Load => load_slider(ui, bench, cable),
        Held::Pull => pull_slider(ui, bench, cable),
    };
    let loads = match held {
        Held::Pull => None,
        Held::Load => match bench.loads_along() {
            Some(loads) => Some(loads),
            None => return,
        },
    };
    // Where egui puts the middle of the handle.
    let ends = response.rect.x_range().shrink(response.rect.height() / 2.5);
    let at = |pull: f64| {
        let pull_mm = millimetres(pull);
        let value = loads
            .as_ref()
            .map_or(pull_mm, |loads| loads.load_g(pull_mm));
        let share = (value - span.0) / (span.1 - span.0).max(f64::MIN_POSITIVE);
        ends.min + share as f32 * (ends.max - ends.min)
    };
    marks(ui, bench, response.rect, ends, at);
    ghost(ui, bench, &response, span, ends);
    // Pulls that are hovered elsewhere are the first cable's.
    if let Hovered::Pull(pull) = bench.hovered
        && cable == 0
    {
        let x = at(pull);
        if ends.contains(x) {
            let stroke = Stroke::new(1.0, Tokens::in_ui(ui).accent);
            ui.painter().vline(x, response.rect.y_range(), stroke);
        }
    }
}

fn pull_slider(ui: &mut Ui, bench: &mut Workbench, cable: usize) -> ((f64, f64), Response) {
    let span = bench.span_mm_of(cable);
    let mut pull_mm = bench.pull_mm_of(cable);
    let slider = Slider::new(&mut pull_mm, span.0..=span.1)
        .show_value(false)
        // A pull that nobody edits stays what it is, to the last digit.
        .clamping(SliderClamping::Edits)
        .max_decimals(3);
    let response = ui.add(slider).accessible_name("Pull slider");
    if response.changed() {
        bench.set_pull_of(cable, pull_mm);
    }
    (span, response)
}

fn load_slider(ui: &mut Ui, bench: &mut Workbench, cable: usize) -> ((f64, f64), Response) {
    let span = (0.0, bench.most_g(cable).unwrap_or_default());
    let mut load_g = bench.load_g(cable).unwrap_or_default();
    let slider = Slider::new(&mut load_g, span.0..=span.1)
        .show_value(false)
        .clamping(SliderClamping::Edits)
        .max_decimals(1);
    let response = ui.add(slider).accessible_name("Load slider");
    if response.changed() {
        bench.set_load(cable, load_g);
    }
    (span, response)
}

/// A ghost of the handle where the robot was brought to, while more is asked.
fn ghost(ui: &Ui, bench: &Workbench, slider: &Response, span: (f64, f64), ends: Rangef) {
    let Some(reached) = bench.reached(bench.cable()) else {
        return;
    };
    let share = (reached - span.0) / (span.1 - span.0).max(f64::MIN_POSITIVE);
    let x = ends.min + share as f32 * (ends.max - ends.min);
    if ends.contains(x) {
        let tokens = Tokens::in_ui(ui);
        let centre = pos2(x, slider.rect.center().y);
        let radius = 0.36 * slider.rect.height();
        let stroke = Stroke::new(1.5, tokens.warning);
        ui.painter()
            .circle(centre, radius, tokens.panel.gamma_multiply(0.6), stroke);
    }
}

/// The marks of the path, if it is known, below the rail; each tells what it
/// is under the pointer.
fn marks(ui: &Ui, bench: &mut Workbench, rect: Rect, ends: Rangef, at: impl Fn(f64) -> f32) {
    let tokens = Tokens::in_ui(ui);
    let Some((path, current)) = bench.path_along() else {
        return;
    };
    let cable = bench.cable();
    if let Some(end) = &path.end
        && at(end.pull) < ends.max
    {
        // What lies beyond the end of the branch is out of reach.
        let x = at(end.pull).clamp(ends.min, ends.max);
        let beyond =
            Rect::from_x_y_ranges(x..=ends.max, rect.center().y - 2.0..=rect.center().y + 2.0);
        ui.painter()
            .rect_filled(beyond, 2.0, tokens.warning.gamma_multiply(0.35));
    }
    for (index, event) in path.events.iter().enumerate() {
        let x = at(event.pull);
        if !ends.contains(x) {
            continue;
        }
        let foot = pos2(x, rect.bottom() + 2.0);
        mark(ui.painter(), foot, event, &tokens, current);
        let spot = Rect::from_center_size(foot, vec2(10.0, 12.0));
        let id = ui.scope_id().with(("event", index));
        let response = ui.interact(spot, id, Sense::click());
        if response.hovered() && cable == 0 {
            bench.hovering = Hovered::Pull(event.pull);
        }
        let text = words::event(event, &bench.document.scene);
        if response.on_hover_text(text).clicked() {
            bench.go_along(millimetres(event.pull));
        }
    }
}

fn mark(
    painter: &Painter,
    foot: eframe::egui::Pos2,
    event: &Event,
    tokens: &Tokens,
    current: bool,
) {
    let faded = if current { 1.0 } else { 0.4 };
    match event.what {
        Occurrence::ContactMade { .. } => {
            painter.circle_filled(foot, 3.0, tokens.contact.gamma_multiply(faded));
        }
        Occurrence::ContactLost { .. } => {
            let stroke = Stroke::new(1.25, tokens.muted.gamma_multiply(faded));
            painter.circle_stroke(foot, 2.5, stroke);
        }
        Occurrence::Jump { .. } | Occurrence::FrictionGaveWay => {
            let ink = tokens.warning.gamma_multiply(faded);
            painter.text(
                foot,
                Align2::CENTER_CENTER,
                icons::LIGHTNING,
                icon_font(12.0),
                ink,
            );
        }
        Occurrence::BranchEnded { .. } => {
            let ink = tokens.warning.gamma_multiply(faded);
            painter.text(
                foot,
                Align2::CENTER_CENTER,
                "×",
                FontId::proportional(14.0),
                ink,
            );
        }
        Occurrence::PushedAside { .. } | Occurrence::StartRefused => {}
    }
}

/// A range in metres as millimetres with two decimals, none of them outside.
pub fn round_inwards(least: f64, most: f64) -> (f64, f64) {
    let hundredths = |value: f64| millimetres(value) * 100.0;
    let inside = (
        hundredths(least).ceil() / 100.0,
        hundredths(most).floor() / 100.0,
    );
    if inside.0 < inside.1 && metres(inside.0) >= least && metres(inside.1) <= most {
        inside
    } else {
        (millimetres(least), millimetres(most))
    }
}
