//! The canvas: the robot among its obstacles, in the plane, to be looked at
//! and taken hold of.

mod backdrop;
mod banner;
mod camera;
mod chip;
mod clear;
mod drag;
mod gravity;
mod handles;
mod hints;
mod hit;
mod hover;
mod keys;
mod labels;
mod menu;
mod other;
mod overlay;
mod photo;
mod pins;
mod pointer;
mod pull;
mod shade;
mod tip_force;
mod tools;
mod view;

pub use clear::{Rather, kept, place};
pub use keys::hold_space;
pub use view::Canvas;

use super::look::{Tokens, theme_of};
use super::paint::{drawing, grid};
use super::shapes::Tool;
use super::widgets::understated_over;
use super::workbench::{Hovered, Selection, Workbench};
use crate::render::field_callback;
use crate::view::Frame;
use eframe::egui::{self, Pos2, Rect, Sense, Stroke, Ui, vec2};
use hit::{Reach, Target};

/// Shows the canvas in all the room there is.
pub fn show(ui: &mut Ui, canvas: &mut Canvas, bench: &mut Workbench) {
    let size = ui.available_size();
    let (rect, response) = ui.allocate_exact_size(size, Sense::click_and_drag());
    response
        .widget_info(|| egui::WidgetInfo::labeled(egui::Role::Canvas, true, "Robot and obstacles"));
    canvas.rect = rect;
    canvas.take_news(bench);
    if rect.width() < 8.0 || rect.height() < 8.0 {
        return;
    }
    let bounds = bench.live.drawing().bounds;
    canvas.camera.place(rect, tools::ROOM, &bounds);
    canvas.camera.navigate(ui, &response);
    let frame = canvas.camera.frame();
    canvas.go_on_fitting(&bench.live);
    let reach = Reach::of(ui);
    keys::follow(&response, canvas, bench, &frame);
    // What lies behind and before the robot comes first, where it is in hand.
    let target = if backdrop::interact(&response, canvas, bench, &frame) {
        Target::Nothing
    } else {
        pointer::follow(&response, canvas, bench, &frame, reach)
    };
    bench.take_edits(ui.ctx());
    picture(ui, canvas, bench, &frame, rect, target, reach);
    overlays(ui, canvas, bench, &frame, rect, &response);
    if response.has_focus() && response.ctx.input(|input| !input.pointer.has_pointer()) {
        let ring = Stroke::new(2.0, Tokens::in_ui(ui).accent);
        let painter = ui.painter_at(rect);
        painter.rect_stroke(rect.shrink(1.0), 0.0, ring, egui::StrokeKind::Inside);
    }
    menu::show(&response, canvas, bench, &frame);
}

/// The lower right corner of what there is above the legend.
fn corner_above_legend(rect: Rect) -> Pos2 {
    rect.right_bottom() - vec2(12.0, 34.0)
}

/// Paints the scene.
fn picture(
    ui: &Ui,
    canvas: &mut Canvas,
    bench: &mut Workbench,
    frame: &Frame,
    rect: Rect,
    target: Target,
    reach: Reach,
) {
    let theme = theme_of(ui);
    let tokens = Tokens::of(theme);
    let painter = ui.painter_at(rect);
    painter.rect_filled(rect, 0.0, tokens.canvas);
    if bench.preferences.field {
        let obstacles = bench.live.problem().obstacles();
        painter.add(field_callback(rect, frame, obstacles, theme));
    }
    backdrop::behind(&painter, bench, frame);
    if bench.preferences.grid {
        grid(&painter, frame, theme);
    }
    let lit = match &canvas.drag {
        None => bench.hovering,
        Some(_) => Hovered::Nothing,
    };
    if bench.selection == Selection::Robot {
        overlay::halo(&painter, &bench.live, frame, theme);
    }
    if let Some(shade) = &mut canvas.shade
        && !shade.paint(ui, &painter, frame)
    {
        canvas.shade = None;
    }
    pins::paint(&painter, bench.pins.all(), frame, &tokens);
    drawing(&painter, bench.live.drawing(), frame, theme);
    if bench.preferences.compare {
        other::outline(&painter, bench, frame, &tokens);
    }
    if let Hovered::Obstacle(_) = lit {
        hover::paint(&painter, bench, lit, frame, rect, theme);
    }
    overlay::selection(&painter, &bench.live, bench.selection, frame, theme);
    let revision = bench.live.revision();
    let drawn = (bench.live.drawing(), revision);
    let strip = canvas.strip;
    canvas.labels.paint(&painter, drawn, frame, strip, theme);
    if bench.preferences.compare {
        let taken = canvas.labels.areas();
        other::forces(&painter, bench, frame, taken, &tokens);
    }
    if let Some((index, shape)) = hit::selected(canvas.tool, bench, frame) {
        let under = match target {
            Target::Handle(of, handle) if of == index => Some(handle),
            _ => None,
        };
        let vertex = canvas.vertex.filter(|(of, _)| *of == index);
        let filled = (under, vertex.map(|(_, vertex)| vertex));
        handles::paint(&painter, &shape, frame, filled, reach, &tokens);
    }
    tip_force::paint(&painter, bench, frame, &tokens);
    gravity::paint(&painter, bench, frame, target == Target::Gravity, &tokens);
    if target == Target::Tip {
        overlay::tip_ring(&painter, &bench.live, frame, &tokens);
    }
    overlay::scale_bar(&painter, frame, canvas.strip, theme);
    backdrop::before(&painter, bench, frame, theme);
    if !bench.live.drawing().standing.is_greyed() {
        overlay::legend(&painter, bench.live.drawing(), frame, rect, theme);
    }
    match lit {
        Hovered::Obstacle(_) => {}
        lit => hover::paint(&painter, bench, lit, frame, rect, theme),
    }
}

/// Paints and shows what floats over the scene.
fn overlays(
    ui: &mut Ui,
    canvas: &mut Canvas,
    bench: &mut Workbench,
    frame: &Frame,
    rect: Rect,
    response: &egui::Response,
) {
    let tokens = Tokens::in_ui(ui);
    let painter = ui.painter_at(rect);
    let pointer = response.hover_pos().or(response.interact_pointer_pos());
    banner::rings(ui, &painter, canvas, bench, frame);
    tools::paint_draft(&painter, canvas, frame, pointer, &tokens);
    let calm = canvas.drag.is_none() && canvas.tool == Tool::Select;
    let calm = calm && !bench.live.drawing().standing.is_greyed() && !bench.preferences.compare;
    if calm && bench.hovering == Hovered::Nothing && bench.selection == Selection::Nothing {
        let found = bench.preferences.hints;
        hints::paint(found, &painter, &bench.live, frame, rect, &tokens);
    }
    canvas.strip = tools::show(ui, canvas, bench, rect);
    understated_over(ui, bench, corner_above_legend(rect));
    let kept = kept(canvas, bench);
    banner::show(ui, bench, rect, &kept);
    let painter = ui.painter_at(rect);
    if let (Some(drag), Some(pointer)) = (&canvas.drag, pointer) {
        let numbers = drag.reading(bench);
        chip::reading(&painter, rect, pointer, &numbers, &tokens);
    }
    banner::refusal(ui, &painter, bench, rect, pointer);
}
