//! The tools at the canvas's left edge, and drawing a polygon with one.

use super::hit;
use super::view::Canvas;
use crate::app::commands::Command;
use crate::app::look::{Tokens, icon_button};
use crate::app::paint::{to_screen, to_world};
use crate::app::shapes::{Tool, convex, neat, written};
use crate::app::workbench::{Notice, Selection, Workbench};
use crate::geometry::Vector;
use crate::scene::limits::VERTICES;
use crate::scene::{Obstacle, Shape};
use crate::units::METRES_PER_MM;
use crate::view::Frame;
use eframe::egui::{
    self, Color32, Layout, Margin, Painter, Pos2, Rect, Sense, Stroke, Ui, UiBuilder, pos2, vec2,
};

/// What to do with the tool; nothing for the one that is always there.
fn advice(tool: Tool) -> Option<&'static str> {
    Some(match tool {
        Tool::Select => return None,
        Tool::Disc => "Click, or drag from the centre outward",
        Tool::Box => "Click, or drag from corner to corner",
        Tool::Capsule => "Click, or drag from end to end",
        Tool::Polygon => "Click its vertices, then Enter or a double click",
        Tool::Wall => "Click, or drag along the surface",
    })
}

/// Width of the strip with its distance from the edge, in points.
pub const ROOM: f32 = 56.0;
const EDGE: f32 = 12.0;
const BUTTON: f32 = 32.0;
/// Touch screens want larger targets.
const TOUCHED: f32 = 40.0;

/// Shows the strip, and what its tool wants of the user.
pub fn show(ui: &mut Ui, canvas: &mut Canvas, bench: &mut Workbench, rect: Rect) -> Rect {
    let tokens = Tokens::in_ui(ui);
    let touch = ui.input(|input| input.has_touch_screen());
    let button = if touch { TOUCHED } else { BUTTON };
    let height = Tool::ALL.len() as f32 * (button + 2.0) + 6.0;
    let top = (rect.center().y - 0.5 * height).max(rect.top() + EDGE);
    let place = Rect::from_min_size(pos2(rect.left() + EDGE, top), vec2(button + 8.0, height));
    let builder = UiBuilder::new()
        .id_salt("tools")
        .max_rect(place)
        .layout(Layout::top_down(egui::Align::Center))
        .sense(Sense::click_and_drag());
    let strip = ui.scope_builder(builder, |ui| {
        raised(&tokens, 4).show(ui, |ui| {
            ui.spacing_mut().item_spacing = vec2(0.0, 2.0);
            ui.spacing_mut().interact_size = egui::Vec2::splat(button);
            for tool in Tool::ALL {
                let chosen = canvas.tool == tool;
                ui.scope(|ui| {
                    if chosen {
                        let visuals = &mut ui.style_mut().visuals;
                        let widgets = &mut visuals.widgets;
                        for look in [&mut widgets.inactive, &mut widgets.hovered] {
                            look.weak_bg_fill = tokens.accent_soft;
                            look.fg_stroke.color = tokens.accent;
                        }
                        visuals.button_frame = true;
                    }
                    let command = Command::Tool(tool);
                    if tool_button(ui, tool, chosen, &command.tip(ui.ctx())).clicked() {
                        bench.commands.push(command);
                    }
                });
            }
        });
    });
    let area = strip.response.rect;
    if let Some(advice) = advice(canvas.tool) {
        let at = area.right_top() + vec2(8.0, 4.0);
        let text = format!("{advice} · Esc stops");
        super::chip::text(ui.painter(), rect, at, &text, &tokens);
    }
    area
}

fn tool_button(ui: &mut Ui, tool: Tool, chosen: bool, tip: &str) -> egui::Response {
    if !chosen {
        return icon_button(ui, tool.icon(), tip);
    }
    let size = ui.spacing().interact_size;
    let face = egui::Button::new(crate::app::look::icon(tool.icon())).selected(true);
    let response = ui.add_sized(size, face).on_hover_text(tip);
    response.widget_info(|| egui::WidgetInfo::selected(egui::Role::Button, true, true, tip));
    response
}

/// The frame of what floats over the canvas.
pub fn raised(tokens: &Tokens, margin: i8) -> egui::Frame {
    egui::Frame::new()
        .fill(tokens.raised)
        .stroke(Stroke::new(1.0, tokens.line))
        .corner_radius(8)
        .inner_margin(Margin::same(margin))
}

/// Adds a vertex to the polygon being drawn, at a point in metres, or closes it
/// where it began.
pub fn add_to_draft(canvas: &mut Canvas, bench: &mut Workbench, frame: &Frame, at: Vector) {
    let per_point = hit::per_point(frame);
    let at = (at / METRES_PER_MM).map(|x| neat(x, per_point));
    let draft = &mut canvas.draft;
    let begun = draft.first().copied();
    if draft.len() >= 3 && begun.is_some_and(|first| (first - at).norm() < 10.0 * per_point) {
        close_draft(canvas, bench);
        return;
    }
    if draft.len() < VERTICES && draft.last() != Some(&at) {
        draft.push(at);
    }
}

/// Makes an obstacle of the polygon being drawn, or tells why not.
pub fn close_draft(canvas: &mut Canvas, bench: &mut Workbench) {
    let draft = std::mem::take(&mut canvas.draft);
    canvas.tool = Tool::Select;
    let Some(found) = convex(&draft) else {
        let why = "A polygon needs three vertices that are not on one line.";
        bench.notices.tell(Notice::information(why));
        return;
    };
    if found.left_out > 0 {
        let what = "Obstacles are convex, so the polygon became its convex hull.";
        bench.notices.tell(Notice::information(what));
    }
    let obstacles = &mut bench.document.scene.obstacles;
    obstacles.push(Obstacle::from(Shape::Polygon {
        points_mm: found.points.iter().map(|p| written(*p)).collect(),
        rotation_deg: 0.0,
        corner_radius_mm: 0.0,
    }));
    bench.selection = Selection::Obstacle(obstacles.len() - 1);
}

/// Paints the polygon being drawn, up to the pointer.
pub fn paint_draft(
    painter: &Painter,
    canvas: &Canvas,
    frame: &Frame,
    pointer: Option<Pos2>,
    tokens: &Tokens,
) {
    let Some(first) = canvas.draft.first() else {
        return;
    };
    let on_screen = |p: &Vector| to_screen(frame, METRES_PER_MM * p);
    let mut line: Vec<Pos2> = canvas.draft.iter().map(on_screen).collect();
    let dots = line.clone();
    let mut shown = canvas.draft.clone();
    if let Some(pointer) = pointer {
        line.push(pointer);
        shown.push(to_world(frame, pointer) / METRES_PER_MM);
    }
    // What it would become now.
    if let Some(found) = convex(&shown) {
        let hull = found.points.iter().map(on_screen).collect();
        let edge = Stroke::new(1.0, tokens.accent.gamma_multiply(0.5));
        let fill = tokens.accent.gamma_multiply(0.12);
        painter.add(egui::Shape::convex_polygon(hull, fill, edge));
    }
    painter.add(egui::Shape::line(line, Stroke::new(1.5, tokens.accent)));
    for (i, dot) in dots.into_iter().enumerate() {
        let (radius, fill) = if i == 0 {
            (5.0, tokens.canvas)
        } else {
            (3.0, tokens.accent)
        };
        painter.circle(dot, radius, fill, Stroke::new(1.5, tokens.accent));
    }
    if pointer.is_some_and(|at| at.distance(on_screen(first)) < 10.0) && canvas.draft.len() >= 3 {
        let ring = Stroke::new(2.0, tokens.accent);
        painter.circle(on_screen(first), 9.0, Color32::TRANSPARENT, ring);
    }
}
