//! What a right click or a long press offers, for an obstacle or the plane.

use super::hit::{Target, per_point};
use super::view::{Canvas, Opened};
use crate::app::commands::Command;
use crate::app::look::{icon, icons};
use crate::app::shapes::{Handle, Tool, add_vertex, clicked, remove_vertex};
use crate::app::workbench::{Selection, Workbench};
use crate::geometry::Vector;
use crate::scene::{Obstacle, Shape};
use crate::units::METRES_PER_MM;
use crate::view::Frame;
use eframe::egui::{Button, Popup, PopupCloseBehavior, Response, TextEdit, Ui, vec2};

/// Width of the menu, in points.
const WIDTH: f32 = 216.0;

/// Opens the menu on a target at a point in metres. Selects it.
pub fn open(canvas: &mut Canvas, bench: &mut Workbench, target: Target, at: Vector) {
    if let Some(index) = target.obstacle() {
        bench.selection = Selection::Obstacle(index);
    }
    canvas.menu = Some(Opened {
        target,
        at: at / METRES_PER_MM,
    });
}

/// Shows the menu while it is open.
pub fn show(response: &Response, canvas: &mut Canvas, bench: &mut Workbench, frame: &Frame) {
    let Some(opened) = canvas.menu else {
        return;
    };
    Popup::context_menu(response)
        .close_behavior(PopupCloseBehavior::CloseOnClickOutside)
        .show(|ui| {
            ui.set_width(WIDTH);
            match opened.target.obstacle() {
                Some(index) if index < bench.document.scene.obstacles.len() => {
                    of_obstacle(ui, canvas, bench, index, opened);
                }
                _ => of_plane(ui, canvas, bench, opened, frame),
            }
        });
}

fn of_obstacle(
    ui: &mut Ui,
    canvas: &mut Canvas,
    bench: &mut Workbench,
    index: usize,
    opened: Opened,
) {
    let obstacle = &mut bench.document.scene.obstacles[index];
    let label = ui.weak("Rename");
    let mut name = obstacle.name.clone().unwrap_or_default();
    let field = TextEdit::singleline(&mut name)
        .hint_text(obstacle.shape.word())
        .margin(vec2(8.0, 5.0))
        .desired_width(WIDTH - 16.0);
    let field = ui.add(field).labelled_by(label.id);
    if field.changed() {
        obstacle.name = (!name.trim().is_empty()).then_some(name);
    }
    if field.lost_focus() && ui.input(|input| input.key_pressed(eframe::egui::Key::Enter)) {
        ui.close();
    }
    ui.separator();
    command(ui, bench, Command::Duplicate);
    let shape = bench.document.scene.obstacles[index].shape.clone();
    let mut edited = None;
    if let Shape::Polygon { .. } = shape {
        if let Target::Handle(_, Handle::Vertex(vertex)) = opened.target {
            let fewer = remove_vertex(&shape, vertex);
            if item(ui, icons::MINUS, "Remove this vertex", fewer.is_some()) {
                edited = fewer;
            }
        }
        let more = add_vertex(&shape, opened.at);
        if item(ui, icons::PLUS, "Add a vertex here", more.is_some()) {
            edited = more.map(|(shape, _)| shape);
        }
    }
    let is_turned = shape.rotation_deg() != 0.0;
    let turns = !matches!(shape, Shape::Disc { .. } | Shape::Wall { .. });
    if turns
        && item(
            ui,
            icons::CLOCK_COUNTER_CLOCKWISE,
            "Reset its turn",
            is_turned,
        )
    {
        let mut straight = shape;
        if let Shape::Box { rotation_deg, .. }
        | Shape::Capsule { rotation_deg, .. }
        | Shape::Polygon { rotation_deg, .. } = &mut straight
        {
            *rotation_deg = 0.0;
        }
        edited = Some(straight);
    }
    if let Some(shape) = edited {
        canvas.vertex = None;
        bench.document.scene.obstacles[index].shape = shape;
        ui.close();
    }
    ui.separator();
    command(ui, bench, Command::Delete);
}

fn of_plane(
    ui: &mut Ui,
    canvas: &mut Canvas,
    bench: &mut Workbench,
    opened: Opened,
    frame: &Frame,
) {
    for (tool, title) in [
        (Tool::Disc, "Add a disc here"),
        (Tool::Box, "Add a box here"),
        (Tool::Capsule, "Add a capsule here"),
        (Tool::Wall, "Add a wall here"),
    ] {
        if item(ui, tool.icon(), title, true) {
            add(canvas, bench, tool, METRES_PER_MM * opened.at, frame);
            ui.close();
        }
    }
    ui.separator();
    command(ui, bench, Command::Fit);
}

/// Adds the obstacle of a tool at a point in metres, and selects it.
pub fn add(canvas: &mut Canvas, bench: &mut Workbench, tool: Tool, at: Vector, frame: &Frame) {
    let scene = &mut bench.document.scene;
    let shape = clicked(tool, at / METRES_PER_MM, &scene.robot, per_point(frame));
    if let Some(shape) = shape {
        scene.obstacles.push(Obstacle::from(shape));
        bench.selection = Selection::Obstacle(scene.obstacles.len() - 1);
        canvas.tool = Tool::Select;
    }
}

fn item(ui: &mut Ui, glyph: &str, title: &str, enabled: bool) -> bool {
    let button = Button::new((icon(glyph), title))
        .frame_when_inactive(false)
        .min_size(vec2(ui.available_width(), ui.spacing().interact_size.y));
    let response = ui.add_enabled(enabled, button);
    response.accessible_name(title).clicked()
}

fn command(ui: &mut Ui, bench: &mut Workbench, command: Command) {
    let entry = command.entry();
    let mut button = Button::new((icon(entry.icon), entry.title))
        .frame_when_inactive(false)
        .min_size(vec2(ui.available_width(), ui.spacing().interact_size.y));
    if let Some(keys) = &entry.shortcut {
        button = button.shortcut_text(ui.ctx().format_shortcut(keys));
    }
    let response = ui.add_enabled(bench.allows(command), button);
    if response.accessible_name(entry.title).clicked() {
        bench.commands.push(command);
        ui.close();
    }
}
