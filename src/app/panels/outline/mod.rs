//! The outline: everything in the scene, to be found, chosen, named and
//! deleted.

mod add;

use crate::app::commands::Command;
use crate::app::look::{Tokens, colour, icon, icon_font, icons, theme_of};
use crate::app::widgets::row::{self, Emphasis};
use crate::app::words;
use crate::app::workbench::{Hovered, Selection, Workbench};
use crate::scene::Scene;
use eframe::egui::{
    self, Align, Align2, Button, EventFilter, Id, Key, Layout, Modifiers, Rect, Response, RichText,
    ScrollArea, Sense, Stroke, TextEdit, Ui, Vec2, WidgetInfo, vec2,
};

/// What the outline keeps from frame to frame.
#[derive(Debug, Default)]
pub struct Outline {
    /// The obstacle that is being renamed.
    renaming: Option<Renaming>,
}

/// A name while it is being written.
#[derive(Clone, Debug, PartialEq, Eq)]
struct Renaming {
    index: usize,
    text: String,
    /// Whether the field has had the focus yet.
    begun: bool,
}

/// Shows the outline, as high as its rows but at most so many points.
pub fn show(ui: &mut Ui, outline: &mut Outline, bench: &mut Workbench, most: f32) {
    ui.spacing_mut().item_spacing.y = 2.0;
    robot(ui, outline, bench);
    besides(ui, outline, bench);
    ui.add_space(8.0);
    head(ui, bench);
    let count = bench.document.scene.obstacles.len();
    if count == 0 {
        empty(ui, bench);
        return;
    }
    let shares = shares(bench);
    let height = row::height(ui);
    ScrollArea::vertical()
        .id_salt("obstacles")
        .max_height((most - 80.0).max(4.0 * height))
        .auto_shrink([false, true])
        .show_rows(ui, height, count, |ui, rows| {
            let pitch = height + ui.spacing().item_spacing.y;
            let top = ui.max_rect().top() - rows.start as f32 * pitch;
            for index in rows {
                obstacle(
                    ui,
                    outline,
                    bench,
                    index,
                    shares.get(index).copied().flatten(),
                );
            }
            if let Selection::Obstacle(index) = bench.selection
                && bench.selection != bench.inspected
            {
                // Chosen elsewhere, or by the keyboard: where is it?
                let at = egui::pos2(ui.max_rect().left(), top + index as f32 * pitch);
                let row = Rect::from_min_size(at, vec2(1.0, height));
                ui.scroll_to_rect(row, None);
            }
        });
}

fn head(ui: &mut Ui, bench: &mut Workbench) {
    ui.horizontal(|ui| {
        row::heading(ui, "Obstacles");
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            add::menu(ui, bench);
        });
    });
}

fn empty(ui: &mut Ui, bench: &mut Workbench) {
    let muted = Tokens::in_ui(ui).muted;
    let text = "Nothing stands around the robot. Add an obstacle and drag it against the robot.";
    ui.add(egui::Label::new(RichText::new(text).color(muted)).wrap());
    ui.add_space(8.0);
    if ui.button("Add a disc").clicked() {
        add::disc(bench);
    }
}

fn robot(ui: &mut Ui, outline: &mut Outline, bench: &mut Workbench) {
    let emphasis = Emphasis {
        selected: bench.selection == Selection::Robot,
        lit: matches!(bench.hovered, Hovered::Node(_)),
    };
    let response = row::row(ui, row_id(Selection::Robot), "Robot", emphasis);
    contents(ui, response.rect, icons::ROBOT, "Robot");
    if response.clicked() {
        choose(&response, bench, Selection::Robot);
    }
    keys(ui, &response, outline, bench, Selection::Robot);
}

/// What there is besides the robot and its obstacles.
fn besides(ui: &mut Ui, outline: &mut Outline, bench: &mut Workbench) {
    let scene = &bench.document.scene;
    let rows = [
        (
            scene.measured.is_some(),
            Selection::Measured,
            icons::RULER,
            "Measurements",
        ),
        (
            scene.photo.is_some(),
            Selection::Photo,
            icons::IMAGE,
            "Photograph",
        ),
    ];
    for (_, this, glyph, name) in rows.into_iter().filter(|(there, ..)| *there) {
        let emphasis = Emphasis {
            selected: bench.selection == this,
            lit: false,
        };
        let response = row::row(ui, row_id(this), name, emphasis);
        contents(ui, response.rect, glyph, name);
        if response.clicked() {
            choose(&response, bench, this);
        }
        keys(ui, &response, outline, bench, this);
    }
}

fn obstacle(
    ui: &mut Ui,
    outline: &mut Outline,
    bench: &mut Workbench,
    index: usize,
    share: Option<f64>,
) {
    let Some(found) = bench.document.scene.obstacles.get(index) else {
        return;
    };
    let glyph = words::shape_icon(&found.shape);
    let name = words::obstacle(index, found);
    let is_renamed = outline
        .renaming
        .as_ref()
        .is_some_and(|it| it.index == index);
    if is_renamed {
        rename(ui, outline, bench, glyph);
        return;
    }
    let this = Selection::Obstacle(index);
    let emphasis = Emphasis {
        selected: bench.selection == this,
        lit: bench.hovered == Hovered::Obstacle(index),
    };
    let response = row::row(ui, row_id(this), &name, emphasis);
    contents(ui, response.rect, glyph, &name);
    if let Some(share) = share {
        presses(ui, &response, share);
    }
    if response.hovered() {
        bench.hovering = Hovered::Obstacle(index);
    }
    if response.double_clicked() {
        begin(outline, bench, index);
    } else if response.clicked() {
        choose(&response, bench, this);
    }
    if response.secondary_clicked() {
        bench.selection = this;
    }
    response.context_menu(|ui| menu(ui, outline, bench, index));
    keys(ui, &response, outline, bench, this);
}

fn menu(ui: &mut Ui, outline: &mut Outline, bench: &mut Workbench, index: usize) {
    if ui.button("Rename").clicked() {
        begin(outline, bench, index);
        ui.close();
    }
    for command in [Command::Duplicate, Command::Delete] {
        let entry = command.entry();
        let keys = entry.shortcut;
        let keys = keys.map_or(String::new(), |keys| ui.ctx().format_shortcut(&keys));
        let item = Button::new(entry.title).shortcut_text(keys);
        if ui.add(item).clicked() {
            bench.selection = Selection::Obstacle(index);
            bench.commands.push(command);
            ui.close();
        }
    }
}

fn choose(response: &Response, bench: &mut Workbench, selection: Selection) {
    bench.selection = selection;
    response.request_focus();
}

/// What a row is, apart from where it stands in this frame.
fn row_id(of: Selection) -> Id {
    match of {
        Selection::Nothing => Id::unique("outline"),
        Selection::Robot => Id::unique("outline robot"),
        Selection::Obstacle(index) => Id::unique(("outline obstacle", index)),
        Selection::Photo => Id::unique("outline photograph"),
        Selection::Measured => Id::unique("outline measurements"),
    }
}

/// The icon and the name in a row.
fn contents(ui: &mut Ui, rect: Rect, glyph: &str, name: &str) {
    let tokens = Tokens::in_ui(ui);
    let at = rect.left_center() + vec2(8.0, 0.0);
    let font = icon_font(16.0);
    ui.painter()
        .text(at, egui::Align2::LEFT_CENTER, glyph, font, tokens.muted);
    let mut room = rect;
    room.min.x += 32.0;
    room.max.x -= 24.0;
    row::painted(ui, room, name);
}

/// A dot in the contact scale at the end of a row.
fn presses(ui: &mut Ui, response: &Response, share: f64) {
    let theme = theme_of(ui);
    let tokens = Tokens::of(theme);
    let centre = response.rect.right_center() - vec2(14.0, 0.0);
    let painter = ui.painter();
    painter.circle_filled(centre, 3.5, colour(theme.contact(share)));
    painter.circle_stroke(centre, 5.5, Stroke::new(1.0, tokens.muted));
    response.clone().on_hover_text("The robot presses on it");
    ui.ctx().accesskit_node_builder(response.id, |node| {
        node.set_description("The robot presses on it");
    });
}

/// The arrow keys, and those that act on a row.
fn keys(
    ui: &Ui,
    response: &Response,
    outline: &mut Outline,
    bench: &mut Workbench,
    this: Selection,
) {
    if !response.has_focus() {
        return;
    }
    let filter = EventFilter {
        vertical_arrows: true,
        ..EventFilter::default()
    };
    ui.memory_mut(|memory| memory.set_focus_lock_filter(response.id, filter));
    let pressed = |key| ui.input_mut(|input| input.consume_key(Modifiers::NONE, key));
    let rows = rows(&bench.document.scene);
    let last = rows.len() - 1;
    let place = rows.iter().position(|row| *row == this).unwrap_or(0);
    let to = if pressed(Key::ArrowDown) {
        (place + 1).min(last)
    } else if pressed(Key::ArrowUp) {
        place.saturating_sub(1)
    } else if pressed(Key::Home) {
        0
    } else if pressed(Key::End) {
        last
    } else {
        if let Selection::Obstacle(index) = this
            && pressed(Key::F2)
        {
            begin(outline, bench, index);
        }
        return;
    };
    bench.selection = rows[to];
    ui.memory_mut(|memory| memory.request_focus(row_id(bench.selection)));
}

/// What is listed, from top to bottom; never nothing.
fn rows(scene: &Scene) -> Vec<Selection> {
    let measured = scene.measured.as_ref().map(|_| Selection::Measured);
    let photo = scene.photo.as_ref().map(|_| Selection::Photo);
    let obstacles = (0..scene.obstacles.len()).map(Selection::Obstacle);
    let besides = measured.into_iter().chain(photo);
    let first = std::iter::once(Selection::Robot);
    first.chain(besides).chain(obstacles).collect()
}

fn begin(outline: &mut Outline, bench: &mut Workbench, index: usize) {
    let found = bench.document.scene.obstacles.get(index);
    if let Some(obstacle) = found {
        bench.selection = Selection::Obstacle(index);
        outline.renaming = Some(Renaming {
            index,
            text: obstacle.name.clone().unwrap_or_default(),
            begun: false,
        });
    }
}

/// A row whose name is being written.
fn rename(ui: &mut Ui, outline: &mut Outline, bench: &mut Workbench, glyph: &str) {
    let Some(mut renaming) = outline.renaming.take() else {
        return;
    };
    let size = vec2(ui.available_width(), row::height(ui));
    let (rect, _) = ui.allocate_exact_size(size, Sense::hover());
    contents(ui, rect, glyph, "");
    let mut room = rect;
    room.min.x += 28.0;
    let field = TextEdit::singleline(&mut renaming.text)
        .id(Id::unique("outline renaming"))
        .align(Align2::LEFT_CENTER)
        .margin(vec2(4.0, 2.0))
        .desired_width(room.width());
    let response = ui.put(room, field).accessible_name("Name of the obstacle");
    if !renaming.begun {
        renaming.begun = true;
        response.request_focus();
        outline.renaming = Some(renaming);
        return;
    }
    let given_up = ui.input(|input| input.key_pressed(Key::Escape));
    if response.has_focus() && !given_up {
        outline.renaming = Some(renaming);
        return;
    }
    let index = renaming.index;
    if !given_up && let Some(obstacle) = bench.document.scene.obstacles.get_mut(index) {
        let name = renaming.text.trim();
        obstacle.name = (!name.is_empty()).then(|| name.to_owned());
    }
    let row = row_id(Selection::Obstacle(index));
    ui.memory_mut(|memory| memory.request_focus(row));
}

/// By obstacle: how hard the robot presses on it, as a share of the scale that forces
/// are drawn by; `None` where it does not.
fn shares(bench: &Workbench) -> Vec<Option<f64>> {
    let scene: &Scene = &bench.document.scene;
    let mut shares = vec![None; scene.obstacles.len()];
    let Some(solution) = bench.live.solution() else {
        return shares;
    };
    let scale = bench.live.drawing().scale;
    for contact in solution.pressing() {
        if let Some(share) = shares.get_mut(contact.obstacle) {
            let this = scale.of(contact);
            *share = Some(share.map_or(this, |other: f64| other.max(this)));
        }
    }
    shares
}

/// A button that is only an icon, for a menu.
fn icon_menu(ui: &mut Ui, glyph: &str, name: &str, add: impl FnOnce(&mut Ui)) {
    let size = Vec2::splat(ui.spacing().interact_size.y);
    let button = Button::new(icon(glyph))
        .frame_when_inactive(false)
        .min_size(size);
    let (response, _) = egui::containers::menu::MenuButton::from_button(button).ui(ui, add);
    let response = response.on_hover_text(name);
    response.widget_info(|| WidgetInfo::labeled(egui::Role::Button, ui.is_enabled(), name));
}
